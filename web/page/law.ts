/** A law by itself: its text beside its curve and its loops, which follow the sliders. */

import type { Page } from "./bench";
import { modelOf, select } from "./choices";
import { faultText, refusal, type Setting } from "./controls";
import { ofPart } from "./asked";
import { h, save } from "./dom";
import type { Diagram, Label } from "./drawing";
import { Lane, Refused, Superseded } from "./engine";
import { parsed, short } from "./format";
import { intro } from "./intros";
import { type State, toHash, value } from "./link";
import { Cursor, LoopPlot } from "./plot";
import { type Group, Sliders } from "./sliders";
import { TakeAway } from "./take";
import { type Text, textOf } from "./texts";
import { onTheme } from "./theme";
import type { Loop, Model, Strokes, Variable, Written } from "./types";

/** Speed of the strokes of laws that depend on displacement, relative to the highest velocity of the curve (chosen). */
const SLOW = 0.02;
/** Length of the strokes of the others, in s at that velocity (chosen). */
const LONG = 0.25;

const FORCE: Label = { name: "Friction force", unit: "N" };
const VELOCITY: Label = { name: "Velocity", unit: "m/s" };

/** Strokes as they are drawn and saved. */
interface Loops {
  every: number;
  way: Float64Array;
  speed: Float64Array;
  force: Float64Array;
}

export class LawView {
  readonly root: HTMLElement;
  private readonly chooser = h("div", {});
  private readonly sliders: Sliders;
  private readonly title = h("h2", {});
  private readonly article = h("article", { class: "text" });
  private readonly note = h("p", { class: "progress", role: "status" });
  private readonly warning = h("p", { class: "findings", id: "passivity" });
  private readonly plots: Record<"steady" | "way" | "speed", LoopPlot>;
  private readonly lanes = { steady: new Lane(), loop: new Lane() };
  private readonly take: TakeAway;
  private readonly questions = new Lane();
  private text: Text | undefined;
  private now: Strokes | undefined;
  private loop: Loops | undefined;
  private running = 0;

  constructor(
    private readonly page: Page,
    private readonly state: State,
  ) {
    this.sliders = new Sliders(
      state,
      (isLast) => {
        page.changed(isLast);
        this.compute();
      },
      () => void this.show(),
    );
    const strokes = new Cursor();
    this.plots = {
      steady: new LoopPlot("force-at-held-velocity", new Cursor()),
      way: new LoopPlot("strokes-over-displacement", strokes),
      speed: new LoopPlot("strokes-over-velocity", strokes),
    };
    onTheme(() => Object.values(this.plots).forEach((plot) => plot.theme()));
    this.take = this.takeAway();
    const side = h("section", { class: "side", "aria-label": "Settings" }, this.chooser, this.sliders.root);
    const main = h(
      "section",
      { class: "main", "aria-label": "Results" },
      intro("law"),
      this.title,
      this.note,
      this.warning,
      h("div", { class: "plots" }, ...Object.values(this.plots).map((plot) => plot.root)),
      this.article,
      this.take.root,
    );
    this.root = h("div", { class: "view", id: "law", "data-drawn": 0, "data-running": 1 }, side, main);
  }

  private get model(): Model | undefined {
    return modelOf(this.page.catalogue, this.state.laws[0] ?? "");
  }

  async show(): Promise<void> {
    const { state, page } = this;
    const laws = page.catalogue.laws;
    const law = state.laws[0] ?? "";
    const options = laws.map(({ name, summary }) => ({ name, text: `${name}: ${summary}` }));
    this.chooser.replaceChildren(
      select("Friction law", "the-law", law, options, (name) => {
        state.laws = [name];
        state.set = {};
        page.changed(true);
        void this.show();
      }),
    );
    const model = laws.find(({ name }) => name === law);
    if (!model || state.laws.length > 1) {
      page.fault(model ? `${state.laws.length} laws: this view shows one` : `friction law '${law}' does not exist`);
      this.running = 0;
      this.mark();
      return;
    }
    const text = textOf(law);
    if (!text) return;
    this.text = text;
    if (this.now?.model !== law) this.now = this.loop = undefined;
    this.title.textContent = `${law}: ${model.summary}`;
    this.article.innerHTML = text.html;
    [...this.article.querySelectorAll("table")].forEach(wrap);
    this.sliders.show(this.groups(model, text));
    this.compute();
  }

  private groups(model: Model, text: Text): Group[] {
    const setting = (part: string) => (variable: Variable): Setting => ({ name: `${part}.${variable.name}`, variable, start: variable.start });
    const parameters = model.variables.filter(({ role }) => role === "Fixed" || role === "Tunable");
    const inputs = model.variables.filter(isHeld);
    const { velocity, stroke, speed } = usual(text);
    return [
      { part: "friction", settings: parameters.map(setting("friction")), models: [model] },
      { part: "held", settings: inputs.map(setting("held")) },
      {
        part: "motion",
        settings: [
          setting("motion")(length("velocity", "m/s", velocity, "Highest velocity of the curve.")),
          setting("motion")(length("stroke", "m", stroke, "Length of the strokes.")),
          setting("motion")(length("speed", "m/s", speed, "Highest speed of the strokes.")),
        ],
      },
    ];
  }

  /** The law with the settings. */
  private strokes(model: Model, text: Text): Strokes {
    const { state } = this;
    const known = new Set(model.variables.map(({ name }) => name));
    const parameters = ofPart(state, "friction");
    const held: Record<string, number> = {};
    for (const variable of model.variables.filter(isHeld)) {
      held[variable.name] = this.number(`held.${variable.name}`, variable, variable.start);
    }
    const usually = usual(text);
    const motion = (name: keyof typeof usually, unit: string) =>
      this.number(`motion.${name}`, length(name, unit, usually[name], ""), usually[name]);
    const wrong = Object.keys(state.set).find((name) => {
      const [part, ...rest] = name.split(".");
      if (part === "held") return !(rest.join(".") in held);
      if (part === "motion") return !(rest.join(".") in usually);
      return part !== "friction" || !known.has(rest.join("."));
    });
    if (wrong !== undefined && !wrong.startsWith("friction.")) throw new RangeError(`'${wrong}' is unknown`);
    const [velocity, stroke, speed] = [motion("velocity", "m/s"), motion("stroke", "m"), motion("speed", "m/s")];
    return { model: model.name, set: parameters, held, velocity, stroke, speed };
  }

  private number(name: string, variable: Variable, usual: number): number {
    const text = this.state.set[name];
    if (text === undefined) return usual;
    const fault = refusal(variable, text);
    if (fault) throw new RangeError(fault);
    return parsed(text)!;
  }

  private compute(): void {
    const { model, text } = this;
    if (!model || !text) return;
    this.page.fault("");
    try {
      this.now = this.strokes(model, text);
    } catch (fault) {
      this.page.fault(faultText(fault));
      this.now = this.loop = undefined;
      this.running = 0;
      this.mark();
      return;
    }
    const { now } = this;
    this.running = 2;
    this.mark();
    this.ask<Loop>(this.lanes.loop, { ask: "strokes", ...now }, (answer, arrays) => this.showLoop(answer, arrays));
    this.ask(this.lanes.steady, { ask: "curve", ...now }, (_, arrays) => this.showCurve(arrays));
  }

  private ask<T>(lane: Lane, question: Parameters<Lane["ask"]>[0], done: (answer: T, arrays: Float64Array[]) => void): void {
    const isCurve = lane === this.lanes.steady;
    const plots = isCurve ? [this.plots.steady] : [this.plots.way, this.plots.speed];
    lane.ask<T>(question).then(
      ({ answer, arrays }) => {
        plots.forEach((plot) => (plot.root.hidden = false));
        if (isCurve) this.note.textContent = "";
        done(answer, arrays);
        this.running -= 1;
        this.mark();
      },
      (fault) => {
        if (fault instanceof Superseded) return;
        plots.forEach((plot) => (plot.root.hidden = true));
        // Some laws keep fluctuating: they have strokes, but no curve.
        if (isCurve && fault instanceof Refused && fault.message.includes("do not settle")) this.note.textContent = `No curve: ${fault.message}`;
        else this.page.fault(faultText(fault));
        this.running -= 1;
        this.mark();
      },
    );
  }

  private mark(): void {
    const { dataset } = this.root;
    this.take.heed();
    dataset.running = String(this.running);
    dataset.drawn = String(Number(dataset.drawn) + 1);
  }

  private showCurve([velocity, force]: Float64Array[]): void {
    const diagram: Diagram = {
      title: "Friction force at held velocities",
      x: VELOCITY,
      y: FORCE,
      curves: [{ name: this.model!.name, x: velocity!, y: force!, law: 0 }],
    };
    this.plots.steady.show(diagram);
  }

  private showLoop({ every, period, warning }: Loop, arrays: Float64Array[]): void {
    this.warning.textContent = warning ?? "";
    const [way, speed, force] = [arrays[0]!, arrays[1]!, arrays[2]!];
    const { name } = this.model!;
    this.loop = { every, way, speed, force };
    const curve = (x: ArrayLike<number>) => [{ name, x, y: force, law: 0 }];
    const takes = `a period takes ${short(period * every)} s`;
    this.plots.way.show({ title: `Strokes over displacement; ${takes}`, x: { name: "Displacement", unit: "m" }, y: FORCE, curves: curve(way) });
    this.plots.speed.show({ title: "Strokes over velocity", x: VELOCITY, y: FORCE, curves: curve(speed) });
  }

  private takeAway(): TakeAway {
    const { state } = this;
    const now = () => this.now!;
    const [isKnown, isDrawn] = [() => this.now !== undefined, () => this.loop !== undefined];
    const items = (take: TakeAway) => [
      { text: "Copy link", id: "copy-link", does: () => take.copy("Link", location.href.split("#")[0] + toHash({ view: "law", state })) },
      { text: "Copy as Python", id: "copy-python", does: () => take.copyOf("python", { strokes: now() }), isReady: isKnown },
      { text: "Copy as C", id: "copy-c", does: async () => take.copy("C", await this.asC(now())), isReady: isKnown },
      { text: "Save CSV", id: "save-csv", does: () => this.saveCsv(this.loop!), isReady: isDrawn },
      { text: "Save SSV", id: "save-ssv", does: () => this.saveSsv(), isReady: isKnown },
      { text: "Try it on the bench", id: "to-bench", does: () => this.toBench(), isReady: isKnown },
    ];
    return new TakeAway("law", items, this.page.fault);
  }

  private async asC(strokes: Strokes): Promise<string> {
    const { answer } = await this.questions.ask<Written>({ ask: "strokes-c", ...strokes });
    return answer.text;
  }

  private saveCsv({ every, way, speed, force }: Loops): void {
    const rows = Array.from(force, (f, at) => [at * every, way[at]!, speed[at]!, f].map(written).join());
    const heading = "time [s],displacement [m],velocity [m/s],friction_force [N]";
    save(`${this.state.laws[0]}.csv`, `${heading}\n${rows.join("\n")}\n`, "text/csv");
  }

  private async saveSsv(): Promise<void> {
    const model = this.state.laws[0] ?? "";
    const { answer } = await this.questions.ask<Written>({ ask: "ssv", model, set: ofPart(this.state, "friction") });
    save(`${model}.ssv`, answer.text, "application/xml");
  }

  private toBench(): void {
    const own = Object.entries(this.state.set).filter(([name]) => name.startsWith("friction."));
    const entries = own.map(([name, text]) => `&${encodeURIComponent(name)}=${encodeURIComponent(String(value(text)))}`);
    location.hash = `v=1&law=${this.state.laws[0]}${entries.join("")}`;
  }
}

/** Whether it is an input that does not move. */
const isHeld = ({ role, meaning }: Variable) => role === "Input" && (meaning === "NormalForce" || meaning === "ExternalForce");

/** A number with all its bits. */
const written = (value: number) => (Object.is(value, -0) ? "-0" : String(value));

/** Start values of the motion. */
function usual({ velocity, stroke }: Text): { velocity: number; stroke: number; speed: number } {
  if (stroke === null) return { velocity, stroke: Number((LONG * velocity).toPrecision(3)), speed: velocity };
  return { velocity, stroke, speed: Number((SLOW * velocity).toPrecision(3)) };
}

/** A positive quantity of the motion as a variable. */
function length(name: string, unit: string, start: number, help: string): Variable {
  const bound = "> 0";
  return { name, role: "Tunable", kind: "real", unit, start, nominal: start, bound, minimum: 1e-300, maximum: null, help, choices: [], meaning: "Own" };
}

/** Tables that are wider than the page scroll by themselves. */
function wrap(table: HTMLTableElement, at: number, all: ArrayLike<HTMLTableElement>): void {
  const name = table.closest(".equations") ? "Equations" : "Symbols";
  const label = all.length > 1 ? `${name}, ${at + 1} of ${all.length}` : name;
  const box = h("div", { class: "scroll free", tabindex: 0, role: "region", "aria-label": label });
  table.replaceWith(box);
  box.append(table);
}
