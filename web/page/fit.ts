/** Fit: laws against records of a rig, in a worker; nothing is uploaded. */

import type { Page } from "./bench";
import { field, LawPicker, select } from "./choices";
import { faultText } from "./controls";
import { checkLaws } from "./asked";
import { h, save } from "./dom";
import type { Curve, Diagram, Label } from "./drawing";
import { Lane, Superseded } from "./engine";
import { parsed, short, unitText } from "./format";
import { type State, toHash } from "./link";
import { Cursor, LoopPlot, type Plot, TimePlot } from "./plot";
import { TakeAway } from "./take";
import { dashes, onTheme } from "./theme";
import { type Choice, type Files, type Fit, type Fitted, type FittedLaw, IDENTIFICATION, type Quality } from "./types";

/** Largest file that is read, in bytes (chosen). */
const LARGEST = 64e6;
/** Values of the rig until they are set. */
const RIG: Record<string, string> = {
  mass: "2",
  normal_force: "20",
  law: "LuGre",
  duration: "4",
  seed: "1",
  faults: "false",
};


interface Data {
  name: string;
  table: string;
  motion?: string;
  /** Values of the law of a virtual rig. */
  truth?: Record<string, number>;
}

interface Measured {
  quality: Quality;
  arrays: Float64Array[];
}

export class FitView {
  readonly root: HTMLElement;
  private readonly picker: LawPicker;
  private readonly form = h("div", { class: "choices" });
  private readonly known = h("div", { class: "choices" });
  private readonly drop: HTMLElement;
  private readonly file = h("input", { type: "file", id: "record", multiple: true, accept: ".csv,.tsv,.txt,text/csv" });
  private readonly worth = h("div", { class: "worth" });
  private readonly progress = h("div", { class: "progress", role: "status" });
  private readonly start = h("button", { type: "button", id: "start-fit", onclick: () => this.fit() }, "Fit");
  private readonly cancel = h("button", { type: "button", id: "cancel-fit", onclick: () => this.end() }, "Cancel");
  private readonly outcome = h("div", { class: "outcome" });
  private readonly plots: [string, Plot][];
  private readonly questions = new Lane();
  private readonly worker = new Lane();
  private isEnding = false;
  private data: Data | undefined;
  private measured: Measured | undefined;
  private fitted: { answer: Fitted; arrays: Float64Array[] } | undefined;

  constructor(
    private readonly page: Page,
    private readonly state: State,
  ) {
    const laws = page.catalogue.laws.filter(({ name }) => page.catalogue.fitted.includes(name));
    this.picker = new LawPicker("fit", laws, state, () => {
      page.changed(true);
      this.picker.show();
    });
    const [time, loops] = [new Cursor(), new Cursor()];
    const timePlot: TimePlot = new TimePlot("friction-over-time", time, (range) => timePlot.zoom(range));
    this.plots = [
      ["velocity", new LoopPlot("friction-over-velocity", loops)],
      ["displacement", new LoopPlot("friction-over-displacement", loops)],
      ["time", timePlot],
    ];
    onTheme(() => this.plots.forEach(([, plot]) => plot.theme()));
    this.file.addEventListener("change", () => this.read([...(this.file.files ?? [])]));
    this.drop = this.dropZone();
    const side = h(
      "section",
      { class: "side", "aria-label": "Settings" },
      this.drop,
      this.known,
      this.picker.root,
      h("div", { class: "buttons" }, this.start, this.cancel),
      this.form,
    );
    const plots = h("div", { class: "plots" }, ...this.plots.map(([, plot]) => plot.root));
    const main = h(
      "section",
      { class: "main", "aria-label": "Results" },
      this.worth,
      this.progress,
      this.outcome,
      plots,
      this.takeAway().root,
    );
    this.root = h("div", { class: "view", id: "fit", "data-drawn": 0, "data-running": 0 }, side, main);
    for (const [, plot] of this.plots) plot.root.hidden = true;
    this.cancel.disabled = true;
    this.start.disabled = true;
  }

  private value(name: string): string {
    return this.state.set[`rig.${name}`] ?? RIG[name]!;
  }

  private set(name: string, text: string): void {
    if (text === RIG[name] || text === "") delete this.state.set[`rig.${name}`];
    else this.state.set[`rig.${name}`] = text;
    this.page.changed(true);
  }

  private setOption(name: string, text: string): void {
    if (text === "" || text === "false") delete this.state.set[`fit.${name}`];
    else this.state.set[`fit.${name}`] = text;
    this.page.changed(true);
    void this.measure();
  }

  private number(name: string): number {
    const number = parsed(this.value(name));
    if (number === undefined) throw new RangeError(`${name} = '${this.value(name)}': must be a number`);
    return number;
  }

  /** Reports what the state has and this view does not. */
  private checkState(): void {
    const names = [...Object.keys(RIG).map((name) => `rig.${name}`), ...IDENTIFICATION.map(({ name }) => `fit.${name}`)];
    const unknown = Object.keys(this.state.set).find((name) => !names.includes(name));
    if (unknown !== undefined) this.page.fault(`'${unknown}' is unknown`);
    const stranger = this.state.laws.find((law) => !this.page.catalogue.fitted.includes(law));
    if (stranger !== undefined) this.page.fault(`friction law '${stranger}' does not exist, or cannot be fitted`);
    try {
      checkLaws(this.state.laws, dashes().length);
    } catch (fault) {
      this.page.fault(faultText(fault));
    }
  }

  async show(): Promise<void> {
    this.checkState();
    this.picker.show();
    const number = (label: string, name: string, unit: string, then: () => void = () => undefined) =>
      field(label, `rig-${name}`, this.value(name), unit, undefined, (text) => {
        this.set(name, text);
        then();
      });
    const again = () => void this.measure();
    this.known.replaceChildren(
      number("Mass", "mass", "kg", again),
      number("Normal force", "normal_force", "N", again),
      h("details", { class: "solver" }, h("summary", {}, "Options"), ...IDENTIFICATION.map((option) => this.option(option))),
    );
    const laws = this.page.catalogue.fitted.map((name) => ({ name, text: name }));
    const faults = h("input", { type: "checkbox", id: "rig-faults" });
    faults.checked = this.value("faults") === "true";
    faults.addEventListener("change", () => this.set("faults", String(faults.checked)));
    this.form.replaceChildren(
      h(
        "fieldset",
        {},
        h("legend", {}, "Virtual rig"),
        h("p", { class: "note" }, "Simulated rig with a known law: check what a fit recovers."),
        select("Its law", "rig-law", this.value("law"), laws, (name) => this.set("law", name)),
        number("Length", "duration", "s"),
        number("Seed", "seed", ""),
        h("div", { class: "law" }, faults, h("label", { for: "rig-faults" }, "hysteresis, ripple, drift, and a camera with its own clock")),
        h("button", { type: "button", id: "measure-rig", onclick: () => this.virtual() }, "Measure on the virtual rig"),
      ),
    );
  }

  /** An option of the identification. */
  private option({ name, help, choices, is_flag }: Choice): HTMLElement {
    const [id, value] = [`fit-${name}`, this.state.set[`fit.${name}`] ?? ""];
    const label = name.charAt(0).toUpperCase() + name.slice(1).replaceAll("_", " ");
    const change = (text: string) => this.setOption(name, text);
    const all = is_flag ? ["true"] : choices;
    const input =
      all.length > 0
        ? select(label, id, value, [{ name: "", text: is_flag ? "no" : "default" }, ...all.map((one) => ({ name: one, text: is_flag ? "yes" : one }))], change)
        : field(label, id, value, "", undefined, change);
    input.title = help;
    return input;
  }

  private dropZone(): HTMLElement {
    const zone = h(
      "div",
      { class: "drop", id: "drop" },
      h("label", { for: "record" }, "Record of a rig: drop a CSV here, or choose it"),
      this.file,
      h("p", { class: "note" }, "Columns time, force, displacement or velocity, perhaps normal_force, with units in brackets: time [s]. A second file is the motion on its own clock. The files stay in this page; nothing is uploaded."),
    );
    const over = (isOver: boolean) => (event: DragEvent) => {
      event.preventDefault();
      zone.classList.toggle("over", isOver);
    };
    zone.addEventListener("dragover", over(true));
    zone.addEventListener("dragleave", over(false));
    zone.addEventListener("drop", (event: DragEvent) => {
      over(false)(event);
      void this.read([...(event.dataTransfer?.files ?? [])]);
    });
    return zone;
  }

  /** Reads one file, or two: the one without a force is the motion. */
  private async read(files: File[]): Promise<void> {
    // Errors of earlier files disappear before these are read.
    this.page.fault("");
    try {
      if (files.length < 1 || files.length > 2) throw new RangeError(`${files.length} files: must be 1, or 2 with the motion`);
      const large = files.find((file) => file.size > LARGEST);
      if (large) throw new RangeError(`${large.name}: has ${large.size} bytes, must be at most ${LARGEST}`);
      const texts = await Promise.all(files.map((file) => file.text()));
      const hasForce = (text: string) => /(^|[\s,;"])force\b/i.test(text.replace(/^#.*\n/gm, "").split("\n", 1)[0] ?? "");
      if (texts.length === 2 && !hasForce(texts[0]!)) {
        texts.reverse();
        files.reverse();
      }
      await this.take({ name: files[0]!.name, table: texts[0]!, ...(texts[1] === undefined ? {} : { motion: texts[1] }) });
    } catch (fault) {
      this.page.fault(faultText(fault));
    }
    this.file.value = "";
  }

  private async virtual(): Promise<void> {
    try {
      const rig = Object.fromEntries(Object.keys(RIG).map((name) => [name, this.value(name)]));
      const { answer } = await this.questions.ask<Files>({ ask: "rig", rig });
      const motion = answer.camera === null ? {} : { motion: answer.camera };
      await this.take({ name: `virtual rig with ${this.value("law")}`, table: answer.force, truth: answer.truth, ...motion });
    } catch (fault) {
      if (!(fault instanceof Superseded)) this.page.fault(faultText(fault));
    }
  }

  private async take(data: Data): Promise<void> {
    this.data = data;
    this.measured = undefined;
    await this.measure();
  }

  /** The identification. */
  private asked(data: Data): Fit {
    const camera = data.motion === undefined ? {} : { motion: "motion.csv", delay: "find" };
    const known = ["mass", "normal_force"].map((name) => [name, this.value(name)]);
    const given = IDENTIFICATION.map(({ name }) => [name, this.state.set[`fit.${name}`]]).filter(([, text]) => text !== undefined);
    return { records: "force.csv", law: this.state.laws.join(), ...camera, ...Object.fromEntries([...known, ...given]) };
  }

  /** Looks at the record. */
  private async measure(): Promise<void> {
    const { data } = this;
    if (!data) return;
    this.stop();
    this.page.fault("");
    this.fitted = undefined;
    try {
      const { answer, arrays } = await this.questions.ask<Quality>({ ask: "quality", fit: this.asked(data), files: files(data) });
      if (this.data !== data) return;
      this.measured = { quality: answer, arrays };
    } catch (fault) {
      if (fault instanceof Superseded) return;
      this.measured = undefined;
      this.page.fault(`${data.name}: ${faultText(fault)}`);
    }
    this.draw();
  }

  /** Ends a fit with the best so far; gives it up where that cannot be done, or takes too long for the user. */
  private end(): void {
    if (!this.isEnding && this.worker.end()) {
      this.isEnding = true;
      this.cancel.textContent = "Give up";
      return;
    }
    const { isEnding } = this;
    this.stop();
    this.progress.textContent = isEnding ? "Stopped." : "Stopped; this browser cannot return a partial result.";
  }

  private stop(): void {
    this.worker.stop();
    this.mark(false);
    this.progress.replaceChildren();
  }

  private mark(isRunning: boolean): void {
    const { dataset } = this.root;
    dataset.running = isRunning ? "1" : "0";
    dataset.drawn = String(Number(dataset.drawn) + 1);
    this.start.disabled = isRunning || !this.measured;
    this.cancel.disabled = !isRunning;
    this.isEnding = false;
    this.cancel.textContent = "Cancel";
  }

  private async fit(): Promise<void> {
    const { data, state } = this;
    if (!data || !this.measured) return;
    this.page.fault("");
    try {
      checkLaws(state.laws, dashes().length);
    } catch (fault) {
      this.page.fault(faultText(fault));
      return;
    }
    const begin = performance.now();
    const status = h("span", {});
    const bar = h("progress", { "aria-label": "Fitting" });
    this.progress.replaceChildren(bar, status);
    this.mark(true);
    const of = unitText(this.measured.quality.units.force);
    const report = (rms?: number) => {
      const seconds = ((performance.now() - begin) / 1000).toFixed(0);
      const so = rms === undefined ? "" : `, RMS residual ${short(rms)} ${of} so far`;
      const doing = this.isEnding ? "Ending with the best so far:" : "Fitting";
      status.textContent = `${doing} ${state.laws.join(", ")} for ${seconds} s${so}`;
    };
    report();
    try {
      const { answer, arrays } = await this.worker.ask<Fitted>({ ask: "fit", fit: this.asked(data), files: files(data) }, report);
      this.fitted = { answer, arrays };
    } catch (fault) {
      if (fault instanceof Superseded) return;
      this.page.fault(faultText(fault));
    }
    this.progress.replaceChildren();
    this.draw();
  }

  private draw(): void {
    this.showWorth();
    this.showOutcome();
    for (const [across, plot] of this.plots) {
      const diagram = this.diagram(across);
      plot.root.hidden = diagram === undefined;
      if (diagram) plot.show(diagram);
    }
    this.mark(false);
  }

  /** Measured and fitted friction; over velocity and displacement the mean cycle, if the record is periodic. */
  private diagram(across: string): Diagram | undefined {
    if (!this.measured) return undefined;
    const { arrays, quality } = this.measured;
    const isCycle = across !== "time" && arrays.length > 4;
    const [x, force] =
      across === "time"
        ? [arrays[0]!, arrays[3]!]
        : isCycle
          ? [arrays[across === "velocity" ? 6 : 5]!, arrays[7]!]
          : [arrays[across === "velocity" ? 2 : 1]!, arrays[3]!];
    const curves: Curve[] = [{ name: "measured", x, y: force, law: 0 }];
    const explained = this.fitted?.arrays[isCycle ? 1 : 0];
    if (explained) curves.push({ name: `${this.fitted!.answer.best} fitted`, x, y: explained, law: 1 });
    const { units } = quality;
    const labels: Record<string, Label> = {
      time: { name: "Time", unit: "s" },
      velocity: { name: "Velocity", unit: units.velocity },
      displacement: { name: "Displacement", unit: units.displacement },
    };
    const of = isCycle ? `, mean of ${quality.cycles} cycles` : "";
    const y: Label = { name: "Friction force", unit: units.force };
    return { title: `Friction force over ${across}${of}`, x: labels[across]!, y, curves, hasLegend: true };
  }

  private showWorth(): void {
    if (!this.measured || !this.data) {
      this.worth.replaceChildren();
      return;
    }
    const { quality: q } = this.measured;
    const speed = unitText(q.units.velocity);
    const facts: [string, string][] = [
      ["Samples", `${q.samples} over ${short(q.duration)} s, every ${short(q.interval)} s${q.gaps > 0 ? `, ${q.gaps} gaps` : ""}`],
      ["Reversals", `${q.reversals}, ${short(q.slow)} slow samples at each`],
      ["Fastest", `${short(q.fastest)} ${speed}`],
      ["Noise of the force", `${short(q.noise)} ${unitText(q.units.force)}`],
      ["Velocity", q.differentiated ? `from the displacement, known to ${short(q.velocity_error)} ${speed} around rest` : "measured"],
    ];
    if (q.delay !== 0) facts.push(["Delay of the motion", `${short(q.delay)} s`]);
    const rows = facts.map(([name, text]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, text)));
    this.worth.replaceChildren(
      h("h2", {}, `Record: ${this.data.name}`),
      h("table", { class: "facts" }, h("tbody", {}, ...rows)),
      h("ul", { class: "findings" }, ...q.findings.map((finding) => h("li", {}, finding))),
    );
  }

  private showOutcome(): void {
    const { fitted, data } = this;
    if (!fitted) {
      this.outcome.replaceChildren();
      return;
    }
    const { ranking, level, early } = fitted.answer;
    const [best] = ranking.laws;
    const of = unitText(ranking.units.force);
    if (!best) return;
    this.outcome.replaceChildren(
      h("h2", {}, `${best.law}: RMS residual ${short(best.rms)} ${of} of ${short(level)} ${of}`),
      early === null ? "" : h("p", { class: "note" }, early),
      this.estimates(best, data?.truth),
      h("ul", { class: "findings" }, ...best.warnings.map((text) => h("li", {}, text))),
      ranking.laws.length + ranking.refused.length > 1 ? places(ranking) : "",
    );
  }

  private estimates({ estimates }: FittedLaw, truth: Record<string, number> | undefined): HTMLElement {
    const head = ["Parameter", "Value", "95 % interval", "Bootstrap interval", ...(truth ? ["Truth"] : []), "Verdict"];
    const ends = (pair: [number, number] | null) => (pair ? `${short(pair[0])} to ${short(pair[1])}` : "");
    const row = ({ name, unit, value, interval, repeated, verdict, difference_of }: FittedLaw["estimates"][number]) => {
      const of = unitText(unit);
      const known = truth && (difference_of ? truth[difference_of[0]]! - truth[difference_of[1]]! : truth[name]);
      const cells = [
        value === null ? "" : `${short(value)} ${of}`,
        ends(interval),
        ends(repeated),
        ...(truth ? [known === undefined ? "" : short(known)] : []),
        verdict,
      ];
      return h("tr", {}, h("th", { scope: "row" }, name), ...cells.map((cell) => h("td", {}, cell)));
    };
    const table = h(
      "table",
      {},
      h("caption", {}, "Parameters; without a number where the record does not determine it"),
      h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...estimates.map(row)),
    );
    return h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Parameters" }, table);
  }

  private takeAway(): TakeAway {
    const { state } = this;
    const best = () => {
      if (!this.fitted) throw new RangeError("nothing is fitted yet");
      return this.fitted.answer;
    };
    const items = (take: TakeAway) => [
      { text: "Copy link", id: "copy-link", does: () => take.copy("Link", location.href.split("#")[0] + toHash({ view: "fit", state })) },
      { text: "Copy as Python", id: "copy-python", does: () => take.copyOf("python", this.job()) },
      { text: "Copy as command line", id: "copy-command", does: () => take.copyOf("command", this.job()) },
      { text: "Save record", id: "save-csv", does: () => this.saveRecord() },
      { text: "Save TOML", id: "save-toml", does: () => save(`${best().best}.toml`, best().toml, "application/toml") },
      { text: "Save SSV", id: "save-ssv", does: () => save(`${best().best}.ssv`, best().ssv, "application/xml") },
      { text: "Show the fitted law", id: "to-law", does: () => this.toLaw(best()) },
    ];
    return new TakeAway("fit", items, this.page.fault);
  }

  /** The tables, for a fit elsewhere. */
  private saveRecord(): void {
    for (const [name, text] of Object.entries(files(this.given()))) save(name, text, "text/csv");
  }

  private given(): Data {
    if (!this.data) throw new RangeError("there is no record yet");
    return this.data;
  }

  private job(): { fit: Fit } {
    return { fit: this.asked(this.given()) };
  }

  private toLaw({ ranking }: Fitted): void {
    const best = ranking.laws[0]!;
    const entries = Object.entries(best.values).map(([name, value]) => `&friction.${name}=${value}`);
    location.hash = `v=1&view=law&law=${best.law}&held.normal_force=${this.number("normal_force")}${entries.join("")}`;
  }
}

/** The tables by the names of their files. */
function files({ table, motion }: Data): Record<string, string> {
  return { "force.csv": table, ...(motion === undefined ? {} : { "motion.csv": motion }) };
}

/** The laws, the best first. */
function places({ units, laws, refused }: Fitted["ranking"]): HTMLElement {
  const note = ({ repeatable, tied }: FittedLaw, at: number) =>
    !repeatable ? "the searches did not agree" : tied && at > 0 ? "cannot be distinguished from the first" : "";
  const of = unitText(units.force);
  const rows = laws.map((law, at) => [law.law, `${short(law.rms)} ${of}`, law.delta_bic.toFixed(1), note(law, at)]);
  const head = ["Law", "RMS residual", "ΔBIC", "Note"];
  const all = [...rows, ...refused.map(({ law, reason }) => [law, "", "", reason])];
  const row = ([name, ...cells]: string[]) => h("tr", {}, h("th", { scope: "row" }, name), ...cells.map((cell) => h("td", {}, cell)));
  const table = h(
    "table",
    {},
    h("caption", {}, "Laws, the best first"),
    h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...all.map(row)),
  );
  return h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Laws" }, table);
}
