/** A view of systems that are solved: laws, sliders, plots that share a cursor, a scene, costs. */

import { LawPicker, modelOf, RunChoices } from "./choices";
import { faultText, type Setting } from "./controls";
import { checkLaws, ofPart, run } from "./asked";
import { h, save, swatch } from "./dom";
import type { Curve, Diagram, Label, Range } from "./drawing";
import { Lane, Superseded } from "./engine";
import { short, unitText } from "./format";
import { intro } from "./intros";
import { type State, toHash, type View } from "./link";
import { Cursor, LoopPlot, type Plot, TimePlot } from "./plot";
import { type Outcome, Runs } from "./runs";
import { type Paint, Stage } from "./scene";
import { type Group, Sliders } from "./sliders";
import { TakeAway } from "./take";
import { dashes, onTheme } from "./theme";
import type { Catalogue, Job, Moving, Parts, Solved, SystemEntry, Written } from "./types";

/** A plot of quantities over time or over each other. */
export interface Picture {
  id: string;
  title: string;
  up: string[];
  across?: string;
  /** Of the first law only. */
  first?: boolean;
}

export interface Layout {
  view: View;
  systems(name: string): boolean;
  pictures: Picture[];
  /** Results besides those that the systems show, by the name of the quantity. */
  record: Record<string, string>;
  names: Record<string, string>;
  /** How a system is drawn. */
  scene(system: string): Paint | undefined;
  /** Tables below the plots. */
  below?: (page: Page) => HTMLElement;
}

export interface Page {
  catalogue: Catalogue;
  /** The state was changed: shown in the link, and kept for undo if `isLast`. */
  changed(isLast: boolean): void;
  /** Shows a message; empty to remove it. */
  fault(text: string): void;
}

/** Time between two pictures while laws are under way, in ms (chosen). */
const PATIENCE = 150;

export class Bench {
  readonly root: HTMLElement;
  private readonly picker: LawPicker;
  private readonly choices: RunChoices;
  private readonly sliders: Sliders;
  private readonly legend = h("ul", { class: "legend", "aria-label": "Laws, with their values at the cursor" });
  private readonly costs = h("div", { class: "costs" });
  private readonly cursor = new Cursor();
  private readonly plots: [Picture, Plot][];
  private readonly runs: Runs;
  private readonly stage: Stage;
  private readonly take: TakeAway;
  private readonly questions = new Lane();
  private readonly systems: SystemEntry[];
  private readonly defaults = new Map<string, Parts>();
  private waiting: ReturnType<typeof setTimeout> | undefined;
  private drawnAt = 0;

  constructor(
    private readonly page: Page,
    private readonly state: State,
    private readonly layout: Layout,
  ) {
    const { view } = layout;
    const { catalogue } = page;
    this.systems = catalogue.systems.filter(({ name }) => layout.systems(name));
    const changed = () => {
      this.page.changed(true);
      this.solve();
    };
    const moved = () => {
      this.page.changed(true);
      void this.show();
    };
    const inStrut = view === "strut" ? catalogue.laws.filter(({ name }) => lawsInStrut(catalogue).includes(name)) : catalogue.laws;
    this.picker = new LawPicker(view, inStrut, state, moved);
    this.choices = new RunChoices(catalogue, this.systems, state, view, moved, changed);
    this.sliders = new Sliders(
      state,
      (isLast) => {
        page.changed(isLast);
        this.solve();
      },
      () => void this.show(),
    );
    this.runs = new Runs(() => this.redraw(), page.fault);
    this.plots = layout.pictures.map((picture) => [picture, this.plot(picture)]);
    this.stage = new Stage(this.cursor);
    onTheme(() => {
      this.plots.forEach(([, plot]) => plot.theme());
      this.stage.draw();
    });
    this.cursor.on(() => this.showLegend());
    this.take = this.takeAway();
    const side = h("section", { class: "side", "aria-label": "Settings" }, this.picker.root, this.choices.root, this.sliders.root);
    const main = h(
      "section",
      { class: "main", "aria-label": "Results" },
      intro(view),
      this.legend,
      this.runs.root,
      this.stage.root,
      h("div", { class: "plots" }, ...this.plots.map(([, plot]) => plot.root)),
      this.costs,
      this.take.root,
      layout.below?.(page),
    );
    this.root = h("div", { class: "view", id: view, "data-drawn": 0, "data-running": 1 }, side, main);
  }

  private plot({ id, across }: Picture): Plot {
    return across === undefined ? new TimePlot(id, this.cursor, (range) => this.zoom(range)) : new LoopPlot(id, this.cursor);
  }

  private get system(): SystemEntry | undefined {
    return this.systems.find((system) => system.name === this.state.system);
  }

  /** Shows the state: after a link, undo, or a change of laws or system. */
  async show(): Promise<void> {
    this.picker.show();
    this.choices.show();
    this.showLegend();
    this.solve();
    try {
      await this.showSliders();
    } catch (fault) {
      if (!(fault instanceof Superseded)) this.page.fault(faultText(fault));
    }
  }

  /** The parts of the system with one of the laws, at their start values. */
  private async parts(law: string): Promise<Parts> {
    const key = `${this.state.system} ${law}`;
    const known = this.defaults.get(key);
    if (known) return known;
    const { answer } = await this.questions.ask<Parts>({ ask: "system", run: { system: this.state.system, law: [law] } });
    this.defaults.set(key, answer);
    return answer;
  }

  private async showSliders(): Promise<void> {
    const { state } = this;
    const asked = JSON.stringify([state.system, state.laws]);
    const all: [string, Parts][] = [];
    if (state.laws.length > dashes().length) return;
    for (const law of [...state.laws]) all.push([law, await this.parts(law)]);
    // Another choice was made meanwhile.
    if (asked !== JSON.stringify([state.system, state.laws])) return;
    const groups = new Map<string, Map<string, Setting>>();
    for (const [law, { parts }] of all) {
      for (const part of parts) {
        const model = modelOf(this.page.catalogue, part.model);
        const group = groups.get(part.name) ?? new Map<string, Setting>();
        groups.set(part.name, group);
        for (const [name, start] of Object.entries(part.values)) {
          const variable = model?.variables.find((variable) => variable.name === name);
          if (!variable || this.isOfOtherLaw(part.model, name)) continue;
          const known = group.get(name);
          if (known) known.laws?.push(law);
          else group.set(name, { name: `${part.name}.${name}`, variable, start, laws: part.is_law ? [law] : undefined });
        }
      }
    }
    const signals = (all[0]?.[1].signals ?? []).map((signal) => motion(signal));
    this.sliders.show([...signals, ...[...groups].map(([part, settings]) => this.group(part, [...settings.values()]))]);
    this.redraw();
  }

  /** Parameters of laws that are inside of a strut and not chosen; tables are for files. */
  private isOfOtherLaw(model: string, name: string): boolean {
    if (model !== "ShockAbsorber") return false;
    const [part, law] = name.split(".");
    const { laws } = this.page.catalogue;
    if (name.includes("[") || name === "friction.model") return true;
    if (part !== "friction") return false;
    if (laws.some((one) => one.name === law)) return !this.state.laws.includes(law!);
    const users = laws.filter((one) => one.variables.some((variable) => variable.name === law));
    return users.length > 0 && !users.some((one) => this.state.laws.includes(one.name));
  }

  private group(part: string, settings: Setting[]): Group {
    const count = this.state.laws.length;
    const isLaw = settings.some(({ laws }) => laws !== undefined);
    for (const setting of settings) if (setting.laws?.length === count) setting.laws = undefined;
    const laws = isLaw ? this.state.laws : [];
    return { part, settings, models: laws.flatMap((law) => modelOf(this.page.catalogue, law) ?? []) };
  }

  /** Results to record; none if the system chooses them. */
  private record(): string[] {
    const more = Object.values(this.layout.record);
    return more.length > 0 ? [...new Set([...Object.values(this.system?.show ?? {}), ...more])] : [];
  }

  /** Runs every law; replaces runs in progress. */
  solve(): void {
    this.page.fault("");
    try {
      checkLaws(this.state.laws, dashes().length);
      this.runs.start(this.state.laws, run(this.state, this.record()));
      this.root.dataset.running = String(this.runs.count);
    } catch (fault) {
      this.runs.stop();
      this.page.fault(faultText(fault));
      this.root.dataset.running = "0";
    }
  }

  /** Draws when all laws have come, and now and then while some are under way. */
  private redraw(): void {
    const isDue = this.runs.count === 0 || performance.now() - this.drawnAt > PATIENCE;
    if (!isDue) {
      this.waiting ??= setTimeout(() => this.draw(), PATIENCE);
      return;
    }
    this.draw();
  }

  private shown(): (Outcome & { number: number })[] {
    return this.state.laws.flatMap((law, number) => {
      const outcome = this.runs.outcomes.get(law);
      return outcome ? [{ ...outcome, number }] : [];
    });
  }

  private draw(): void {
    clearTimeout(this.waiting);
    this.waiting = undefined;
    this.drawnAt = performance.now();
    for (const [picture, plot] of this.plots) {
      const diagram = this.diagram(picture);
      plot.root.hidden = diagram === undefined;
      if (diagram) plot.show(diagram);
    }
    this.showScene();
    this.showLegend();
    this.showCosts();
    this.take.heed();
    this.root.dataset.drawn = String(Number(this.root.dataset.drawn ?? 0) + 1);
    this.root.dataset.running = String(this.runs.count);
  }

  /** Number of the array of a quantity; 0 is the time. */
  private columnOf(solved: Solved, quantity: string): number | undefined {
    const show = { ...this.system?.show, ...this.layout.record };
    const name = show[quantity] ?? (quantity === "displacement" ? show.position : undefined);
    const at = solved.columns.findIndex((column) => column.name === name);
    return name === undefined || at < 0 ? undefined : at + 1;
  }

  private diagram({ title, up, across, first }: Picture): Diagram | undefined {
    const curves: Curve[] = [];
    let labels: [Label, Label] | undefined;
    const shown = this.shown();
    for (const { law, solved, arrays, number } of first ? shown.slice(0, 1) : shown) {
      const x = across === undefined ? 0 : this.columnOf(solved, across);
      up.forEach((quantity, at) => {
        const y = this.columnOf(solved, quantity);
        if (x === undefined || y === undefined) return;
        const unit = (column: number) => (column === 0 ? "s" : (solved.columns[column - 1]?.unit ?? "1"));
        const { names } = this.layout;
        labels ??= [
          { name: across === undefined ? "Time" : names[across]!, unit: unit(x) },
          { name: up.length > 1 ? "Force" : names[quantity]!, unit: unit(y) },
        ];
        const own = up.length > 1;
        const name = !own ? law : first ? names[quantity]! : `${law}: ${names[quantity]!.toLowerCase()}`;
        const colour = own ? (number * up.length + at) % dashes().length : number;
        curves.push({ name, x: arrays[x]!, y: arrays[y]!, law: colour });
      });
    }
    if (!labels) return undefined;
    return { title, x: labels[0], y: labels[1], curves, hasLegend: up.length > 1 };
  }

  private zoom(range: Range | undefined): void {
    for (const [, plot] of this.plots) if (plot instanceof TimePlot) plot.zoom(range);
  }

  /** Laws with their lines, and their force at the cursor. */
  private showLegend(): void {
    const { at } = this.cursor;
    const items = this.state.laws.map((name, number) => {
      const outcome = this.runs.outcomes.get(name);
      const item = h("li", {}, swatch(number, dashes()[number] ?? ""), h("strong", {}, name));
      if (outcome && at !== null) {
        const column = this.columnOf(outcome.solved, "force");
        const [time, force] = [outcome.arrays[0]?.[at], column === undefined ? undefined : outcome.arrays[column]?.[at]];
        const unit = column === undefined ? "" : unitText(outcome.solved.columns[column - 1]?.unit ?? "1");
        if (time !== undefined && force !== undefined) item.append(` ${short(force)} ${unit} at ${short(time)} s`);
      } else if (outcome?.solved.fault) item.append(` ${outcome.solved.fault}`);
      return item;
    });
    this.legend.replaceChildren(...items);
  }

  /** The first law, as it is drawn. */
  private showScene(): void {
    const [first] = this.shown();
    const paint = this.layout.scene(this.state.system);
    const parts = this.defaults.get(`${this.state.system} ${this.state.laws[0]}`)?.parts;
    if (!first || !paint || !parts) {
      this.stage.show(undefined);
      return;
    }
    const value = (name: string) => {
      const [part, ...rest] = name.split(".");
      const set = Number(this.state.set[name] ?? NaN);
      return Number.isFinite(set) ? set : (parts.find((one) => one.name === part)?.values[rest.join(".")] ?? NaN);
    };
    const quantity = (name: string) => {
      const column = this.columnOf(first.solved, name);
      return column === undefined ? undefined : first.arrays[column];
    };
    this.stage.show({ law: first.law, time: first.arrays[0]!, quantity, value, paint });
  }

  private showCosts(): void {
    const outcomes = this.shown();
    const isChecked = outcomes.some(({ solved }) => solved.check);
    const head = ["Law", "Solver", "Steps", "Rejected", "Evaluations", "Jacobians", "Events", "Time in ms", "End"];
    if (isChecked) head.push("Check");
    const row = ({ law, solved, took }: Outcome) => {
      const { steps, rejected, evaluations, jacobians } = solved.statistics;
      const counts = [steps, rejected, evaluations, jacobians, solved.events.length].map(String);
      const cells = [solved.solver, ...counts, took.toFixed(1), solved.end];
      if (isChecked) cells.push(checkText(solved.check));
      return h("tr", {}, h("th", { scope: "row" }, law), ...cells.map((cell) => h("td", {}, cell)));
    };
    const table = h(
      "table",
      {},
      h("caption", {}, "Cost of each run"),
      h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...outcomes.map(row)),
    );
    const open = new Set([...this.costs.querySelectorAll("details[open]")].map((one) => one.getAttribute("data-law")));
    const events = outcomes.map((outcome) => this.events(outcome, open.has(outcome.law)));
    const label = "Cost of each run";
    this.costs.replaceChildren(h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, table), ...events);
  }

  /** The events of a law, listed when the list is opened. */
  private events({ law, solved, arrays }: Outcome, isOpen: boolean): HTMLElement {
    const times = arrays.at(-1) ?? [];
    const list = h("ol", {});
    const fill = () => {
      const items = solved.events.slice(0, 1000).map((part, at) => h("li", {}, `${short(times[at] ?? NaN)} s: ${part}`));
      list.replaceChildren(...items);
    };
    const details = h("details", { "data-law": law, open: isOpen }, h("summary", {}, `Events of ${law}: ${solved.events.length}`), list);
    details.addEventListener("toggle", () => details.open && fill());
    if (isOpen) fill();
    return details;
  }

  /** Link, files, and the same run elsewhere. */
  private takeAway(): TakeAway {
    const { state } = this;
    const { view } = this.layout;
    const isReady = () => this.shown().length > 0;
    const items = (take: TakeAway) => [
      { text: "Copy link", id: "copy-link", does: () => take.copy("Link", location.href.split("#")[0] + toHash({ view, state })) },
      { text: "Copy as Python", id: "copy-python", does: () => take.copyOf("python", this.job()), isReady },
      { text: "Copy as command line", id: "copy-command", does: () => take.copyOf("command", this.job()), isReady },
      { text: "Copy as C", id: "copy-c", does: async () => take.copy("C", await this.asC()), isReady },
      { text: "Save CSV", id: "save-csv", does: () => this.saveCsv(), isReady },
      { text: "Save TOML", id: "save-toml", does: () => this.saveToml(), isReady },
      { text: "Save SSV", id: "save-ssv", does: () => this.saveSsv(), isReady },
    ];
    return new TakeAway(view, items, this.page.fault);
  }

  private job(): Job {
    return { run: run(this.state, this.record()) };
  }

  /** The run of the first law as a program. */
  private async asC(): Promise<string> {
    const [law = ""] = this.state.laws;
    const { answer } = await this.questions.ask<Written>({ ask: "c", run: run(this.state, this.record()), law });
    return answer.text;
  }

  private async saveCsv(): Promise<void> {
    const { state } = this;
    for (const law of [...state.laws]) {
      const { answer } = await this.questions.ask<Written>({ ask: "csv", run: run(state, this.record()), law });
      save(`${state.system}-${law}.csv`, answer.text, "text/csv");
    }
  }

  private async saveToml(): Promise<void> {
    const { state } = this;
    const { answer } = await this.questions.ask<Written>({ ask: "toml", run: run(state, this.record()) });
    save(`${state.system}.toml`, answer.text, "application/toml");
  }

  /** Parameter sets of the laws, or of the strut with the first law. */
  private async saveSsv(): Promise<void> {
    const { state } = this;
    const inStrut = this.layout.view === "strut";
    for (const law of inStrut ? state.laws.slice(0, 1) : [...state.laws]) {
      const model = modelOf(this.page.catalogue, inStrut ? "ShockAbsorber" : law);
      const own = (name: string) => model?.variables.some((one) => one.name === name && one.role !== "Input");
      const all = ofPart(state, inStrut ? "strut" : "friction");
      const set = Object.fromEntries(Object.entries(all).filter(([name]) => own(name)));
      if (inStrut) set["friction.model"] = law;
      const { answer } = await this.questions.ask<Written>({ ask: "ssv", model: model?.name ?? law, set });
      save(`${law}.ssv`, answer.text, "application/xml");
    }
  }
}

/** What a finer run says: its fault, or the largest difference of each result in parts of the range. */
function checkText(check: Solved["check"]): string {
  if (!check) return "";
  if (check.fault !== null) return check.fault;
  const { of, finer, differences } = check;
  const parts = differences.map(({ name, part }) => `${name} ${short(part)}`);
  return `${of} ${finer.toExponential()}: ${parts.join(", ")} of the range`;
}

/** Laws that a strut can have: the choices of its friction model. */
function lawsInStrut(catalogue: Catalogue): string[] {
  const choice = modelOf(catalogue, "ShockAbsorber")?.variables.find(({ name }) => name === "friction.model");
  return choice?.choices.map(({ name }) => name) ?? [];
}

/** Controls of a signal that moves. */
function motion({ input, unit, properties }: Moving): Group {
  const units: Record<string, string> = { frequency: "Hz", phase: "rad", start: "s", rate: `${unit}/s` };
  const setting = ({ name, value }: { name: string; value: number }): Setting => ({
    name: `${input}.${name}`,
    start: value,
    variable: {
      name,
      role: "Input",
      kind: "real",
      unit: units[name] ?? unit,
      start: value,
      nominal: Math.abs(value) || 1,
      bound: "",
      minimum: name === "amplitude" || name === "frequency" ? 0 : null,
      maximum: null,
      help: `${name} of the signal ${input}.`,
      choices: [], meaning: "Own",
    },
  });
  return { part: `motion of ${input.split(".").at(-1)}`, settings: properties.map(setting) };
}
