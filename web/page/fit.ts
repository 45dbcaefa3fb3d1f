/** Fit: laws and components against records of a rig, in a worker; nothing is uploaded. */

import type { Page } from "./bench";
import { field, LawPicker, select } from "./choices";
import { faultText } from "./controls";
import { checkLaws } from "./asked";
import { h, save } from "./dom";
import type { Diagram } from "./drawing";
import { Drives } from "./drives";
import { Lane, Superseded } from "./engine";
import { type Across, friction, residuals, type Seen } from "./fitted";
import { short, unitText } from "./format";
import { intro } from "./intros";
import { type State, toHash } from "./link";
import { Cursor, LoopPlot, type Plot, TimePlot } from "./plot";
import { TakeAway } from "./take";
import { dashes, onTheme } from "./theme";
import { type Choice, type Files, type Fit, type Fitted, type FittedLaw, IDENTIFICATION, type Labels, type MapQuality, type Quality, type RecordQuality } from "./types";

/** Largest file that is read, in bytes (chosen). */
const LARGEST = 64e6;
/** Values of the virtual rig until they are set; of a rig that made a file, what is not set is not known. */
const RIG: Record<string, string> = {
  mass: "2",
  normal_force: "20",
  law: "LuGre",
  duration: "4",
  seed: "1",
  faults: "false",
};
/** Values that a user may know of the rig that made a file. */
const KNOWN = ["mass", "normal_force"];

interface Table {
  file: string;
  text: string;
}

interface Data {
  name: string;
  record: Table;
  motion?: Table;
  /** Values of the law of a virtual rig. */
  truth?: Record<string, number>;
  /** Its times and its friction. */
  friction?: Float64Array[];
}

interface Measured {
  quality: Quality;
  arrays: Float64Array[];
}

export class FitView {
  readonly root: HTMLElement;
  private readonly picker: LawPicker;
  private readonly drives: Drives;
  private readonly form = h("div", { class: "choices" });
  private readonly known = h("div", { class: "choices" });
  private readonly options = h("div", { class: "choices" });
  /** What the fields of the rig were made for: unit of the force, whether it is of a file, what drives the laws. */
  private knownOf = "";
  private readonly drop: HTMLElement;
  private readonly file = h("input", { type: "file", id: "record", multiple: true, accept: ".csv,.tsv,.txt,text/csv" });
  private readonly worth = h("div", { class: "worth" });
  private readonly progress = h("div", { class: "progress", role: "status" });
  private readonly start = h("button", { type: "button", id: "start-fit", onclick: () => this.again(() => this.fit()) }, "Fit");
  private readonly cancel = h("button", { type: "button", id: "cancel-fit", onclick: () => this.end() }, "Cancel");
  private readonly outcome = h("div", { class: "outcome" });
  private readonly plots: [(seen: Seen) => Diagram | undefined, Plot][];
  private readonly pictures = h("div", { class: "plots" });
  private readonly take: TakeAway;
  private readonly questions = new Lane();
  private readonly worker = new Lane();
  /** What drove the laws for which the record was read last. */
  private readFor: string | undefined;
  private isEnding = false;
  private data: Data | undefined;
  private measured: Measured | undefined;
  private fitted: { answer: Fitted; arrays: Float64Array[] } | undefined;

  constructor(
    private readonly page: Page,
    private readonly state: State,
  ) {
    const { laws, components, fitted } = page.catalogue;
    const models = [...laws, ...components].filter(({ name }) => fitted.some((one) => one.name === name));
    this.drives = new Drives(fitted, state);
    this.picker = new LawPicker("fit", models, state, () => this.choose());
    this.plots = this.allPlots();
    onTheme(() => this.plots.forEach(([, plot]) => plot.theme()));
    this.file.addEventListener("change", () => this.read([...(this.file.files ?? [])]));
    this.drop = this.dropZone();
    const side = h(
      "section",
      { class: "side", "aria-label": "Settings" },
      this.drop,
      this.known,
      this.options,
      this.picker.root,
      h("div", { class: "buttons" }, this.start, this.cancel),
      this.form,
    );
    this.take = this.takeAway();
    this.pictures.append(...this.plots.map(([, plot]) => plot.root));
    const main = h(
      "section",
      { class: "main", "aria-label": "Results" },
      intro("fit"),
      this.worth,
      this.progress,
      this.outcome,
      this.pictures,
      this.take.root,
    );
    this.root = h("div", { class: "view", id: "fit", "data-drawn": 0, "data-running": 0 }, side, main);
    for (const [, plot] of this.plots) plot.root.hidden = true;
    this.cancel.disabled = true;
    this.start.disabled = true;
  }

  /** Friction, with residuals below it that have its horizontal axis, part and cursor. */
  private allPlots(): [(seen: Seen) => Diagram | undefined, Plot][] {
    const [time, loops] = [new Cursor(), new Cursor()];
    const overTime: TimePlot[] = ["friction", "residual"].map((what) => {
      return new TimePlot(`${what}-over-time`, time, (range) => overTime.forEach((plot) => plot.zoom(range)));
    });
    const overVelocity: LoopPlot[] = ["friction", "residual"].map((what, number) => {
      return new LoopPlot(`${what}-over-velocity`, loops, (range) => overVelocity[1 - number]!.zoom(range));
    });
    const both = (across: Across, [above, below]: Plot[]): [(seen: Seen) => Diagram | undefined, Plot][] => [
      [(seen) => friction(seen, across), above!],
      [(seen) => residuals(seen, across), below!],
    ];
    const displacement: [(seen: Seen) => Diagram | undefined, Plot] = [(seen) => friction(seen, "displacement"), new LoopPlot("friction-over-displacement", loops)];
    return [...both("velocity", overVelocity), displacement, ...both("time", overTime)];
  }

  private value(name: string): string {
    return this.state.set[`rig.${name}`] ?? this.usual(name);
  }

  private usual(name: string): string {
    return KNOWN.includes(name) && this.isFromFile() ? "" : RIG[name]!;
  }

  /** Whether the record is, or has to be, from another rig than the virtual one. */
  private isFromFile(): boolean {
    return this.data ? this.data.truth === undefined : !this.drives.areLaws;
  }

  private set(name: string, text: string): void {
    if (text === this.usual(name) || text === "") delete this.state.set[`rig.${name}`];
    else this.state.set[`rig.${name}`] = text;
    this.page.changed(true);
  }

  /** Others were chosen: the record is read again if they need something else of it. */
  private choose(): void {
    this.drives.forget();
    this.page.changed(true);
    this.picker.show();
    if (this.readFor === this.drives.key) return;
    this.showKnown();
    this.again(() => this.begin());
  }

  private begin(): Promise<void> {
    return this.data ? this.measure() : this.first();
  }

  private setOption(name: string, text: string): void {
    if (text === "" || text === "false") delete this.state.set[`fit.${name}`];
    else this.state.set[`fit.${name}`] = text;
    this.page.changed(true);
    this.again(() => this.measure());
  }

  /** Does something, without the message on what was done before. */
  private again(does: () => Promise<void>): void {
    this.page.fault("");
    void does();
  }

  /** Reports what the state has and this view does not; returns whether there is nothing. */
  private checkState(): boolean {
    const own = [...Object.keys(RIG).map((name) => `rig.${name}`), ...IDENTIFICATION.map(({ name }) => `fit.${name}`)];
    const names = [...own, ...this.drives.names];
    const unknown = Object.keys(this.state.set).find((name) => !names.includes(name));
    const stranger = this.state.laws.find((law) => !this.page.catalogue.fitted.some(({ name }) => name === law));
    try {
      if (unknown !== undefined) throw new RangeError(`'${unknown}' is unknown`);
      if (stranger !== undefined) throw new RangeError(`friction law '${stranger}' does not exist, or cannot be fitted`);
      checkLaws(this.state.laws, dashes().length);
      return true;
    } catch (fault) {
      this.page.fault(faultText(fault));
      return false;
    }
  }

  /**
   * A record to begin with, from the virtual rig, and its fit; several laws take long, and wait for the button, components
   * for a record of theirs.
   */
  private async first(): Promise<void> {
    this.readFor = this.drives.key;
    if (!this.drives.areLaws) return this.draw();
    this.root.dataset.running = "1";
    await this.virtual();
    if (this.measured && this.data?.truth && !this.fitted && this.state.laws.length === 1) await this.fit();
    else if (!this.data) this.mark(false);
  }

  async show(): Promise<void> {
    const isGood = this.checkState();
    this.picker.show();
    this.showKnown();
    this.options.replaceChildren(
      h("details", { class: "solver" }, h("summary", {}, "Options"), ...IDENTIFICATION.map((option) => this.option(option))),
    );
    const laws = this.page.catalogue.fitted.filter(({ has_load }) => has_load).map(({ name }) => ({ name, text: name }));
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
        this.number("Length", "duration", "s"),
        this.number("Seed", "seed", ""),
        h("div", { class: "law" }, faults, h("label", { for: "rig-faults" }, "hysteresis, ripple, drift, and a camera with its own clock")),
        h("button", { type: "button", id: "measure-rig", onclick: () => this.again(() => this.virtual()) }, "Measure on the virtual rig"),
      ),
    );
    if (isGood && this.readFor !== this.drives.key) void this.begin();
  }

  /** Fields for what is known of the rig, and for what drives the laws. */
  private showKnown(): void {
    const unit = this.measured?.quality.labels.force.unit ?? "N";
    const turns = unit !== "N";
    const again = () => this.data && this.again(() => this.measure());
    this.knownOf = this.knownNow();
    this.known.replaceChildren(
      this.number(turns ? "Moment of inertia" : "Mass", "mass", turns ? "kg.m2" : "kg", again),
      this.drives.hasLoad ? this.number(turns ? "Load" : "Normal force", "normal_force", unit, again) : "",
      ...this.drives.fields(turns, () => {
        this.page.changed(true);
        again();
      }),
    );
  }

  private knownNow(): string {
    return `${this.measured?.quality.labels.force.unit} ${this.isFromFile()} ${this.drives.key}`;
  }

  private number(label: string, name: string, unit: string, then = () => {}): HTMLElement {
    const change = (text: string) => {
      this.set(name, text);
      then();
    };
    return field(label, `rig-${name}`, this.value(name), unitText(unit), undefined, change);
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
      h("p", { class: "note" }, "Columns time, force, displacement or velocity, perhaps normal_force, with units in brackets: time [s]. A component has no normal force, but columns of what drives it, such as voltage. A joint has a torque, an angle and an angular velocity. Without a time it is a map of friction at constant speeds. A second file is the motion on its own clock. The files stay in this page; nothing is uploaded."),
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
      const [record, motion] = files.map(({ name }, at) => ({ file: name, text: texts[at]! }));
      if (record!.file === motion?.file) throw new RangeError(`two files are called ${record!.file}: rename one`);
      await this.open({ name: record!.file, record: record!, ...(motion ? { motion } : {}) });
    } catch (fault) {
      this.page.fault(faultText(fault));
    }
    this.file.value = "";
  }

  private async virtual(): Promise<void> {
    try {
      const rig = Object.fromEntries(Object.entries(RIG).map(([name, usual]) => [name, this.state.set[`rig.${name}`] ?? usual]));
      const { answer, arrays } = await this.questions.ask<Files>({ ask: "rig", rig });
      const motion = answer.camera === null ? {} : { motion: { file: "motion.csv", text: answer.camera } };
      const record = { file: "force.csv", text: answer.force };
      await this.open({ name: `virtual rig with ${this.value("law")}`, record, truth: answer.truth, friction: arrays, ...motion });
    } catch (fault) {
      if (!(fault instanceof Superseded)) this.page.fault(faultText(fault));
    }
  }

  private async open(data: Data): Promise<void> {
    this.data = data;
    this.measured = undefined;
    await this.measure();
  }

  /** The identification. */
  private asked(data: Data): Fit {
    const camera = data.motion === undefined ? {} : { motion: data.motion.file, delay: "find" };
    const rig = KNOWN.filter((name) => name !== "normal_force" || this.drives.hasLoad);
    const known = rig.map((name) => [name, this.value(name)]).filter(([, text]) => text !== "");
    const given = IDENTIFICATION.map(({ name }) => [name, this.state.set[`fit.${name}`]]).filter(([, text]) => text !== undefined);
    const held = [...given.filter(([name]) => name === "fix").map(([, text]) => text), ...this.drives.fixed];
    const all = Object.fromEntries([...known, ...given, ...(held.length > 0 ? [["fix", held.join()]] : [])]);
    return { records: data.record.file, law: this.state.laws.join(), ...camera, ...all };
  }

  /** Looks at the record. */
  private async measure(): Promise<void> {
    const { data } = this;
    if (!data) return;
    this.stop();
    this.readFor = this.drives.key;
    this.root.dataset.running = "1";
    this.fitted = undefined;
    try {
      const { answer, arrays } = await this.questions.ask<Quality>({ ask: "quality", fit: this.asked(data), files: files(data) });
      if (this.data !== data) return;
      this.measured = { quality: answer, arrays };
    } catch (fault) {
      if (fault instanceof Superseded) return;
      this.measured = undefined;
      const [text, all] = [faultText(fault), [data.record, data.motion]];
      this.page.fault(all.some((one) => one && text.startsWith(one.file)) ? text : `${data.name}: ${text}`);
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
    this.take.heed();
    this.start.disabled = isRunning || !this.measured;
    this.cancel.disabled = !isRunning;
    this.isEnding = false;
    this.cancel.textContent = "Cancel";
  }

  private async fit(): Promise<void> {
    const { data, state } = this;
    if (!data || !this.measured) return;
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
    const of = unitText(this.measured.quality.labels.force.unit);
    let least: number | undefined;
    const tell = () => {
      const seconds = ((performance.now() - begin) / 1000).toFixed(0);
      const so = least === undefined ? "" : `, RMS residual ${short(least)} ${of} so far`;
      const doing = this.isEnding ? "Ending with the best so far:" : "Fitting";
      status.textContent = `${doing} ${state.laws.join(", ")} for ${seconds} s${so}`;
    };
    tell();
    // A slow model is silent for long.
    const clock = setInterval(tell, 1000);
    const report = (rms: number) => {
      least = rms;
      tell();
    };
    try {
      const { answer, arrays } = await this.worker.ask<Fitted>({ ask: "fit", fit: this.asked(data), files: files(data) }, report);
      this.fitted = { answer, arrays };
    } catch (fault) {
      if (fault instanceof Superseded) return;
      this.page.fault(faultText(fault));
    } finally {
      clearInterval(clock);
    }
    this.progress.replaceChildren();
    this.draw();
  }

  private draw(): void {
    if (this.knownOf !== this.knownNow()) this.showKnown();
    this.showWorth();
    this.showOutcome();
    const seen = this.measured && { ...this.measured, fitted: this.fitted, truth: this.data?.friction };
    this.pictures.classList.toggle("map", seen !== undefined && seen.quality.record === null);
    for (const [picture, plot] of this.plots) {
      const diagram = seen && picture(seen);
      plot.root.hidden = diagram === undefined;
      if (diagram) plot.show(diagram);
    }
    this.mark(false);
  }

  private showWorth(): void {
    if (!this.measured || !this.data) {
      const isWanted = !this.data && !this.drives.areLaws;
      this.worth.replaceChildren(isWanted ? h("p", { class: "note" }, this.drives.wanted) : "");
      return;
    }
    const { record, map, labels, findings } = this.measured.quality;
    const facts = record ? ofRecord(record, labels) : ofMap(map!, labels);
    const rows = facts.map(([name, text]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, text)));
    this.worth.replaceChildren(
      h("h2", {}, `${record ? "Record" : "Map"}: ${this.data.name}`),
      h("table", { class: "facts" }, h("tbody", {}, ...rows)),
      h("ul", { class: "findings" }, ...findings.map((finding) => h("li", {}, finding))),
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
    const isLaw = this.drives.isLaw(best.law);
    this.outcome.replaceChildren(
      h("h2", {}, `${best.law}: RMS residual ${short(best.rms)} ${of} of ${short(level)} ${of}`),
      early === null ? "" : h("p", { class: "note" }, early),
      isLaw ? "" : h("p", { class: "note" }, `${best.law} is a component: save its values as SSV; TOML and the view of a law are for laws.`),
      this.estimates(best, isLaw ? data?.truth : undefined),
      h("ul", { class: "findings" }, ...best.warnings.map((text) => h("li", {}, text))),
      ranking.laws.length + ranking.refused.length > 1 ? places(ranking) : "",
    );
  }

  private estimates({ estimates }: FittedLaw, truth: Record<string, number> | undefined): HTMLElement {
    const head = ["Parameter", "Value \u00b1 95 %", "Unit", "Bootstrap interval", ...(truth ? ["Truth"] : []), "Verdict"];
    const row = ({ name, unit, verdict, difference_of, readable }: FittedLaw["estimates"][number]) => {
      const known = truth && (difference_of ? truth[difference_of[0]]! - truth[difference_of[1]]! : truth[name]);
      const cells = [
        readable?.value ?? "",
        unitText(unit),
        readable?.repeated ?? "",
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
    const best = () => this.fitted!.answer;
    const [hasData, isFitted] = [() => this.data !== undefined, () => this.fitted !== undefined];
    const isLaw = () => isFitted() && this.drives.isLaw(best().best);
    const items = (take: TakeAway) => [
      { text: "Copy link", id: "copy-link", does: () => take.copy("Link", location.href.split("#")[0] + toHash({ view: "fit", state })) },
      { text: "Copy as Python", id: "copy-python", does: () => take.copyOf("python", this.job()), isReady: hasData },
      { text: "Copy as command line", id: "copy-command", does: () => take.copyOf("command", this.job()), isReady: hasData },
      { text: "Save record", id: "save-csv", does: () => this.saveRecord(), isReady: hasData },
      { text: "Save TOML", id: "save-toml", does: () => save(`${best().best}.toml`, best().toml!, "application/toml"), isReady: isLaw },
      { text: "Save SSV", id: "save-ssv", does: () => save(`${best().best}.ssv`, best().ssv, "application/xml"), isReady: isFitted },
      { text: "Show the fitted law", id: "to-law", does: () => this.toLaw(best()), isReady: isLaw },
    ];
    return new TakeAway("fit", items, this.page.fault);
  }

  /** The tables, for a fit elsewhere. */
  private saveRecord(): void {
    for (const [name, text] of Object.entries(files(this.data!))) save(name, text, "text/csv");
  }

  private job(): { fit: Fit } {
    return { fit: this.asked(this.data!) };
  }

  private toLaw({ ranking }: Fitted): void {
    const best = ranking.laws[0]!;
    const entries = Object.entries(best.values).map(([name, value]) => `&friction.${name}=${value}`);
    const [least, most] = this.measured!.quality.loads;
    location.hash = `v=1&view=law&law=${best.law}&held.normal_force=${(least + most) / 2}${entries.join("")}`;
  }
}

/** Facts about a record. */
function ofRecord(record: RecordQuality, { velocity, force }: Labels): [string, string][] {
  const { samples, duration, interval, gaps, reversals, slow, fastest, noise, differentiated, velocity_error, delay } = record;
  const speed = unitText(velocity.unit);
  const facts: [string, string][] = [
    ["Samples", `${samples} over ${short(duration)} s, every ${short(interval)} s${gaps > 0 ? `, ${gaps} gaps` : ""}`],
    ["Reversals", `${reversals}, ${short(slow)} slow samples at each`],
    ["Fastest", `${short(fastest)} ${speed}`],
    [`Noise of the ${force.unit === "N" ? "force" : "torque"}`, `${short(noise)} ${unitText(force.unit)}`],
    [velocity.name, differentiated ? `differentiated, known to ${short(velocity_error)} ${speed} around rest` : "measured"],
  ];
  if (delay !== 0) facts.push(["Delay of the motion", `${short(delay)} s`]);
  return facts;
}

/** Facts about a map. */
function ofMap({ rows, settings, velocities: [least, most], scatter }: MapQuality, { velocity, force }: Labels): [string, string][] {
  const facts: [string, string][] = [
    ["Rows", `${rows} at ${settings} speeds and loads`],
    [velocity.name, `${short(least)} to ${short(most)} ${unitText(velocity.unit)}`],
  ];
  if (scatter !== null) facts.push(["Scatter of the repeats", `${short(scatter)} ${unitText(force.unit)}`]);
  return facts;
}

/** The tables by the names of their files. */
function files({ record, motion }: Data): Record<string, string> {
  return Object.fromEntries((motion ? [record, motion] : [record]).map(({ file, text }) => [file, text]));
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
