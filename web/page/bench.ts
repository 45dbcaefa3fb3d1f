/** The bench: laws in a system, with sliders and the usual plots. */

import { control, faultText, type Setting } from "./controls";
import { h, save, say, swatch } from "./dom";
import type { Diagram, Label, Range } from "./drawing";
import { Lane, Superseded } from "./engine";
import { short, unitText, words } from "./format";
import { asCommand, asPython, run, type State, toHash } from "./link";
import { Cursor, LoopPlot, type Plot, TimePlot } from "./plot";
import { dashes, onTheme } from "./theme";
import type { Answer, Catalogue, Model, Parts, Solved, SystemEntry, Variable } from "./types";

/** Quantities that systems show over time, and those they show over another one. */
const OVER_TIME = ["position", "velocity", "acceleration", "force"] as const;
const OVER_EACH_OTHER = [
  ["force", "velocity"],
  ["force", "displacement"],
] as const;
const NAMES: Record<string, string> = {
  position: "Position",
  displacement: "Displacement",
  velocity: "Relative velocity",
  acceleration: "Acceleration",
  force: "Friction force",
};

interface Outcome {
  law: string;
  solved: Solved;
  arrays: Float64Array[];
  took: number;
}

export interface Page {
  catalogue: Catalogue;
  state: State;
  /** The state was changed: shown in the link, and kept for undo if `isLast`. */
  changed(isLast: boolean): void;
  /** Shows a message; empty to remove it. */
  fault(text: string): void;
}

export class Bench {
  readonly root = h("div", { class: "view", id: "bench" });
  private readonly choices = h("div", { class: "choices" });
  private readonly sliders = h("div", { class: "sliders" });
  private readonly legend = h("ul", { class: "legend", "aria-label": "Laws, with their values at the cursor" });
  private readonly costs = h("div", { class: "costs" });
  private readonly progress = h("p", { class: "progress", role: "status" });
  private readonly cursor = new Cursor();
  private readonly plots: Plot[] = [];
  private readonly timePlots = new Map<string, TimePlot>();
  private readonly loops = new Map<string, LoopPlot>();
  private readonly lanes: Lane[] = [];
  private readonly questions = new Lane();
  private outcomes = new Map<string, Outcome>();
  private running = new Set<string>();
  private waits = false;
  private defaults = new Map<string, Parts>();
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly page: Page) {
    for (const kind of OVER_TIME) {
      const plot = new TimePlot(`${kind}-over-time`, this.cursor, (range) => this.zoom(range));
      this.timePlots.set(kind, plot);
    }
    for (const [up, across] of OVER_EACH_OTHER) {
      this.loops.set(across, new LoopPlot(`${up}-over-${across}`, this.cursor));
    }
    this.plots.push(...this.timePlots.values(), ...this.loops.values());
    onTheme(() => this.plots.forEach((plot) => plot.theme()));
    this.cursor.on(() => this.showLegend());
    const side = h("section", { class: "side", "aria-label": "Settings" }, this.choices, this.sliders);
    const main = h(
      "section",
      { class: "main", "aria-label": "Results" },
      this.legend,
      this.progress,
      h("div", { class: "plots" }, ...this.plots.map((plot) => plot.root)),
      this.costs,
      this.takeAway(),
    );
    this.root.append(side, main);
  }

  private get system(): SystemEntry | undefined {
    return this.page.catalogue.systems.find((system) => system.name === this.page.state.system);
  }

  /** Shows the state: after a link, undo, or a change of laws or system. */
  async show(): Promise<void> {
    this.showChoices();
    this.showLegend();
    try {
      await this.showSliders();
    } catch (fault) {
      if (!(fault instanceof Superseded)) this.page.fault(faultText(fault));
    }
    this.solve();
  }

  private showChoices(): void {
    const { catalogue, state } = this.page;
    const select = (
      label: string,
      id: string,
      now: string,
      options: { name: string; text: string }[],
      change: (name: string) => void,
    ) => {
      const known = options.some(({ name }) => name === now) ? options : [{ name: now, text: now }, ...options];
      const list = h("select", { id }, ...known.map(({ name, text }) => h("option", { value: name }, text)));
      list.value = now;
      list.addEventListener("change", () => change(list.value));
      return h("div", { class: "choice" }, h("label", { for: id }, label), list);
    };
    const systems = catalogue.systems.map(({ name, title }) => ({ name, text: title }));
    const solvers = catalogue.solvers.map(({ name, help }) => ({ name, text: `${name}: ${help}` }));
    const field = (label: string, name: "tol" | "until" | "every", unit: string, usual: number | undefined) => {
      const input = h("input", { id: name, type: "text", inputmode: "decimal", autocomplete: "off" });
      input.value = state[name];
      input.placeholder = usual === undefined ? "" : String(usual);
      input.addEventListener("change", () => {
        state[name] = input.value.trim();
        this.page.changed(true);
        this.solve();
      });
      return h("div", { class: "choice" }, h("label", { for: name }, label), input, h("span", { class: "unit" }, unit));
    };
    this.choices.replaceChildren(
      this.lawPicker(),
      select("System", "system", state.system, systems, (name) => {
        state.system = name;
        state.set = {};
        this.page.changed(true);
        void this.show();
      }),
      h(
        "details",
        { class: "solver", open: Boolean(state.tol || state.until || state.every || state.solver !== "auto") },
        h("summary", {}, "Solver"),
        select("Solver", "solver", state.solver, solvers, (name) => {
          state.solver = name;
          this.page.changed(true);
          this.solve();
        }),
        field("Tolerance", "tol", "", 1e-8),
        field("End", "until", "s", this.system?.until),
        field("Interval", "every", "s", this.system?.every),
      ),
    );
  }

  /** The chosen laws, each with a cross, and a list to add one. */
  private lawPicker(): HTMLElement {
    const { catalogue, state } = this.page;
    const most = dashes().length;
    const change = (laws: string[]) => {
      state.laws = laws;
      this.page.changed(true);
      void this.show();
    };
    const chips = state.laws.map((name, law) => {
      const without = () => change(state.laws.filter((other) => other !== name));
      const cross = h("button", { type: "button", class: "small", "aria-label": `Remove ${name}`, onclick: without }, "\u00d7");
      cross.disabled = state.laws.length === 1;
      return h("li", { class: "chip" }, swatch(law, dashes()[law] ?? ""), h("span", {}, name), cross);
    });
    const rest = catalogue.laws.filter((law) => !state.laws.includes(law.name));
    const add = h(
      "select",
      { id: "add-law" },
      h("option", { value: "" }, state.laws.length < most ? "Add a law \u2026" : `At most ${most} laws`),
      ...rest.map((law) => h("option", { value: law.name, title: law.summary }, `${law.name}: ${law.summary}`)),
    );
    add.disabled = state.laws.length >= most;
    add.addEventListener("change", () => change([...state.laws, add.value]));
    return h(
      "div",
      { class: "laws" },
      h("label", { for: "add-law" }, "Friction laws"),
      h("ul", { class: "chips" }, ...chips),
      add,
    );
  }

  /** The parts of the system with one of the laws, at their start values. */
  private async parts(law: string): Promise<Parts> {
    const key = `${this.page.state.system} ${law}`;
    const known = this.defaults.get(key);
    if (known) return known;
    const { answer } = await this.questions.ask<Parts>({ ask: "system", run: { system: this.page.state.system, law: [law] } });
    this.defaults.set(key, answer);
    return answer;
  }

  private async showSliders(): Promise<void> {
    const { state } = this.page;
    const asked = JSON.stringify([state.system, state.laws]);
    const all: [string, Parts][] = [];
    for (const law of state.laws) all.push([law, await this.parts(law)]);
    // Another choice was made meanwhile.
    if (asked !== JSON.stringify([state.system, state.laws])) return;
    const groups = new Map<string, Map<string, Setting>>();
    for (const [law, { parts }] of all) {
      for (const part of parts) {
        const model = this.model(part.model);
        const group = groups.get(part.name) ?? new Map<string, Setting>();
        groups.set(part.name, group);
        for (const [name, start] of Object.entries(part.values)) {
          const variable = model?.variables.find((variable) => variable.name === name);
          if (!variable) continue;
          const known = group.get(name);
          if (known) known.laws?.push(law);
          else group.set(name, { name: `${part.name}.${name}`, variable, start, laws: part.is_law ? [law] : undefined });
        }
      }
    }
    this.sliders.replaceChildren(...[...groups].map(([part, settings]) => this.group(part, [...settings.values()])));
  }

  private model(name: string): Model | undefined {
    const { laws, hosts, shock_absorber } = this.page.catalogue;
    return [...laws, ...hosts, ...shock_absorber].find((model) => model.name === name);
  }

  /** Controls of a part. Start values and choices come last, and many more only on demand. */
  private group(part: string, settings: Setting[]): HTMLElement {
    const { state } = this.page;
    const count = state.laws.length;
    for (const setting of settings) if (setting.laws?.length === count) setting.laws = undefined;
    const isStart = ({ role }: Variable) => role === "State" || role === "StateOutput";
    const row = (setting: Setting) => this.row(setting);
    const first = settings.filter(({ variable }) => !isStart(variable) && variable.kind === "real");
    const rest = settings.filter((setting) => !first.includes(setting));
    const isSet = ({ name }: Setting) => state.set[name] !== undefined;
    const more = (title: string, some: Setting[]) =>
      some.length > 0 &&
      h("details", { open: some.some(isSet) }, h("summary", {}, title), ...some.map(row));
    const isLarge = first.length > 16;
    return h(
      "fieldset",
      { "data-part": part },
      h("legend", {}, words(part)),
      ...(isLarge ? [more(`${first.length} parameters`, first)] : first.map(row)),
      more("Choices", rest.filter(({ variable }) => !isStart(variable))),
      more("Start values", rest.filter(({ variable }) => isStart(variable))),
    );
  }

  private row(setting: Setting): HTMLElement {
    const { state } = this.page;
    const row = control(setting, state.set[setting.name], (text, isLast) => {
      if (text === undefined) delete state.set[setting.name];
      else state.set[setting.name] = text;
      const undo = row.querySelector<HTMLButtonElement>(".undo");
      if (undo) undo.hidden = text === undefined;
      row.dataset.set = String(text !== undefined);
      this.page.changed(isLast);
      if (text === undefined) this.replace(row, setting);
      this.solve();
    });
    return row;
  }

  /** A control at its start value again; the keyboard stays where it was. */
  private replace(row: HTMLElement, setting: Setting): void {
    if (document.activeElement instanceof HTMLInputElement && document.activeElement.type === "range") return;
    const hadFocus = row.contains(document.activeElement);
    const fresh = this.row(setting);
    row.replaceWith(fresh);
    if (hadFocus) fresh.querySelector<HTMLElement>("input, select")?.focus();
  }

  /** Runs every law; what is under way is replaced. */
  solve(): void {
    const { state } = this.page;
    this.page.fault("");
    let asked;
    try {
      asked = run(state);
    } catch (fault) {
      this.page.fault(faultText(fault));
      return;
    }
    for (const name of this.outcomes.keys()) if (!state.laws.includes(name)) this.outcomes.delete(name);
    this.lanes.slice(state.laws.length).forEach((lane) => lane.stop());
    this.running = new Set(state.laws);
    this.root.dataset.running = String(this.running.size);
    state.laws.forEach((law, number) => {
      const lane = (this.lanes[number] ??= new Lane());
      lane.ask<Solved>({ ask: "solve", run: asked, law }).then(
        (answer) => this.receive(law, answer),
        (fault) => {
          if (fault instanceof Superseded) return;
          this.running.delete(law);
          this.outcomes.delete(law);
          this.root.dataset.running = String(this.running.size);
          this.page.fault(faultText(fault));
          this.redraw();
        },
      );
    });
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.showProgress(), 400);
  }

  private receive(law: string, { answer, arrays, took }: Answer<Solved>): void {
    this.running.delete(law);
    this.outcomes.set(law, { law, solved: answer, arrays, took });
    this.redraw();
  }

  private showProgress(): void {
    clearTimeout(this.timer);
    const names = [...this.running];
    if (names.length === 0) {
      this.progress.replaceChildren();
      return;
    }
    const since = Math.min(...this.lanes.map((lane) => lane.since ?? Infinity));
    const seconds = Number.isFinite(since) ? ` for ${((performance.now() - since) / 1000).toFixed(0)} s` : "";
    const stop = h("button", { type: "button", class: "small", onclick: () => this.stop() }, "Stop");
    this.progress.replaceChildren(`Computing ${names.join(", ")}${seconds} \u2026 `, stop);
    this.timer = setTimeout(() => this.showProgress(), 1000);
  }

  private stop(): void {
    this.lanes.forEach((lane) => lane.stop());
    this.page.fault(`Stopped: ${[...this.running].join(", ")}`);
    this.running.clear();
    this.redraw();
  }

  /** Draws before the next picture of the screen, once for all laws that have come by then. */
  private redraw(): void {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      this.draw();
    });
  }

  private shown(): (Outcome & { number: number })[] {
    const { laws } = this.page.state;
    return laws.flatMap((law, number) => {
      const outcome = this.outcomes.get(law);
      return outcome ? [{ ...outcome, number }] : [];
    });
  }

  private draw(): void {
    const { system } = this;
    if (!system) return;
    for (const [kind, plot] of this.timePlots) this.place(plot, this.diagram(undefined, kind));
    for (const [across, plot] of this.loops) this.place(plot, this.diagram(across, "force"));
    this.showLegend();
    this.showCosts();
    if (this.running.size === 0) this.showProgress();
    this.root.dataset.drawn = String(Number(this.root.dataset.drawn ?? 0) + 1);
    this.root.dataset.running = String(this.running.size);
  }

  private place(plot: Plot, diagram: Diagram | undefined): void {
    plot.root.hidden = diagram === undefined;
    if (diagram) plot.show(diagram);
  }

  /** Number of the array of a quantity; 0 is the time. */
  private columnOf(solved: Solved, quantity: string): number | undefined {
    const show = this.system?.show ?? {};
    const name = show[quantity] ?? (quantity === "displacement" ? show.position : undefined);
    const at = solved.columns.findIndex((column) => column.name === name);
    return name === undefined || at < 0 ? undefined : at + 1;
  }

  /** One quantity over another, or over time. */
  private diagram(across: string | undefined, up: string): Diagram | undefined {
    const curves = [];
    let labels: [Label, Label] | undefined;
    for (const { law, solved, arrays, number } of this.shown()) {
      const y = this.columnOf(solved, up);
      const x = across === undefined ? 0 : this.columnOf(solved, across);
      if (x === undefined || y === undefined) return undefined;
      const unit = (column: number) => (column === 0 ? "s" : (solved.columns[column - 1]?.unit ?? "1"));
      const name = across === undefined ? "Time" : NAMES[across]!;
      labels = [
        { name, unit: unit(x) },
        { name: NAMES[up]!, unit: unit(y) },
      ];
      curves.push({ name: law, x: arrays[x]!, y: arrays[y]!, law: number });
    }
    if (!labels) return undefined;
    const title = `${labels[1].name} over ${labels[0].name.toLowerCase()}`;
    return { title, x: labels[0], y: labels[1], curves };
  }

  private zoom(range: Range | undefined): void {
    this.timePlots.forEach((plot) => plot.zoom(range));
  }

  /** Laws with their lines, and their force at the cursor. */
  private showLegend(): void {
    const { at } = this.cursor;
    const items = this.page.state.laws.map((name, number) => {
      const outcome = this.outcomes.get(name);
      const item = h("li", {}, swatch(number, dashes()[number] ?? ""), h("strong", {}, name));
      if (outcome && at !== null) {
        const column = this.columnOf(outcome.solved, "force");
        const [time, force] = [outcome.arrays[0]?.[at], column === undefined ? undefined : outcome.arrays[column]?.[at]];
        const unit = column === undefined ? "" : unitText(outcome.solved.columns[column - 1]?.unit ?? "1");
        if (time !== undefined && force !== undefined) item.append(` ${short(force)} ${unit} at ${short(time)} s`);
      } else if (outcome && !outcome.solved.reached) item.append(` ${outcome.solved.end}`);
      return item;
    });
    this.legend.replaceChildren(...items);
  }

  private showCosts(): void {
    const outcomes = this.shown();
    const head = ["Law", "Solver", "Steps", "Rejected", "Evaluations", "Jacobians", "Events", "Time in ms", "End"];
    const row = ({ law, solved, took }: Outcome) => {
      const { steps, rejected, evaluations, jacobians } = solved.statistics;
      const counts = [steps, rejected, evaluations, jacobians, solved.events.length].map(String);
      const cells = [solved.solver, ...counts, took.toFixed(1), solved.end];
      return h("tr", {}, h("th", { scope: "row" }, law), ...cells.map((cell) => h("td", {}, cell)));
    };
    const table = h(
      "table",
      {},
      h("caption", {}, "What each run has cost"),
      h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...outcomes.map(row)),
    );
    const open = new Set([...this.costs.querySelectorAll("details[open]")].map((one) => one.getAttribute("data-law")));
    const events = outcomes.map(({ law, solved, arrays }) => {
      const times = arrays.at(-1) ?? [];
      const items = solved.events.map((part, at) => h("li", {}, `${short(times[at] ?? NaN)} s: ${part}`));
      const summary = h("summary", {}, `Events of ${law}: ${items.length}`);
      return h("details", { "data-law": law, open: open.has(law) }, summary, h("ol", {}, ...items.slice(0, 1000)));
    });
    const label = "What each run has cost";
    this.costs.replaceChildren(h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, table), ...events);
  }

  /** Link, files, and the same run elsewhere. */
  private takeAway(): HTMLElement {
    const { state } = this.page;
    const copy = async (what: string, text: () => string) => {
      try {
        await navigator.clipboard.writeText(text());
        say(`${what} copied`);
        this.copied(`${what} copied.`);
      } catch {
        this.copied(text());
      }
    };
    const button = (text: string, id: string, does: () => unknown) =>
      h("button", { type: "button", id, onclick: () => Promise.resolve().then(does).catch((fault) => this.page.fault(faultText(fault))) }, text);
    return h(
      "section",
      { class: "take", "aria-label": "Take it with you" },
      h("h2", {}, "Take it with you"),
      h(
        "div",
        { class: "buttons" },
        button("Copy link", "copy-link", () => copy("Link", () => location.href.split("#")[0] + toHash(state))),
        button("Copy as Python", "copy-python", () => copy("Python", () => asPython(state))),
        button("Copy as command line", "copy-command", () => copy("Command line", () => asCommand(state))),
        button("Save CSV", "save-csv", () => this.saveCsv()),
        button("Save TOML", "save-toml", () => this.saveToml()),
      ),
      h("output", { id: "copied", class: "copied" }),
    );
  }

  private copied(text: string): void {
    const output = this.root.querySelector("#copied");
    if (output) output.textContent = text;
  }

  private async saveCsv(): Promise<void> {
    const { state } = this.page;
    for (const law of state.laws) {
      const { answer } = await this.questions.ask<{ text: string }>({ ask: "csv", run: run(state), law });
      save(`${state.system}-${law}.csv`, answer.text, "text/csv");
    }
  }

  private async saveToml(): Promise<void> {
    const { state } = this.page;
    const { answer } = await this.questions.ask<{ text: string }>({ ask: "toml", run: run(state) });
    save(`${state.system}.toml`, answer.text, "application/toml");
  }
}
