/** A drawing that moves with the first law, driven by the cursor of the plots or by its own button. */

import { h } from "./dom";
import { short } from "./format";
import { CanvasPen, type Pen } from "./pen";
import type { Cursor } from "./plot";
import { colours, isMotionReduced } from "./theme";
import type { Colours } from "./types";

/** One instant of a run. */
export interface Instant {
  /** Number of the output time. */
  at: number;
  time: number;
  width: number;
  height: number;
  colours: Colours;
  /** A quantity at this instant, or none. */
  now(name: string): number;
  /** Its range over the run. */
  span(name: string): [number, number];
  /** Its integral up to this instant. */
  way(name: string): number;
  /** The value of a parameter. */
  value(name: string): number;
}

export type Paint = (pen: Pen, instant: Instant) => void;

export interface Shown {
  law: string;
  time: Float64Array;
  quantity(name: string): Float64Array | undefined;
  value(name: string): number;
  paint: Paint;
}

/** Length of a whole run as it is played, in s (chosen). */
const LENGTH = 12;
/** Pictures of a run where motion is reduced (chosen). */
const PICTURES = 40;

export class Stage {
  readonly root: HTMLElement;
  private readonly canvas = h("canvas", { role: "img", "aria-label": "Drawing of the first law at the cursor" });
  private readonly play = h("button", { type: "button", id: "play", onclick: () => this.press() }, "Play");
  private readonly slider = h("input", { type: "range", min: 0, max: 1, step: 1, "aria-label": "Instant of the drawing" });
  private readonly label = h("output", { class: "instant" });
  private shown: Shown | undefined;
  private at = 0;
  private begun: number | undefined;
  private readonly integrals = new Map<string, Float64Array>();
  private readonly spans = new Map<string, [number, number]>();

  constructor(private readonly cursor: Cursor) {
    this.root = h(
      "figure",
      { class: "stage", hidden: true },
      this.canvas,
      h("div", { class: "transport" }, this.play, this.slider, this.label),
    );
    this.slider.addEventListener("input", () => this.go(Number(this.slider.value)));
    cursor.on((at, from) => {
      if (from === this || at === null) return;
      this.at = at;
      this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(this.root);
  }

  show(shown: Shown | undefined): void {
    this.shown = shown;
    this.root.hidden = shown === undefined;
    this.integrals.clear();
    this.spans.clear();
    if (!shown) return;
    this.slider.max = String(shown.time.length - 1);
    this.at = Math.min(this.at, shown.time.length - 1);
    if (this.begun === undefined) this.play.textContent = isMotionReduced() ? "Next picture" : "Play";
    this.draw();
  }

  private press(): void {
    const { shown } = this;
    if (!shown) return;
    const last = shown.time.length - 1;
    if (isMotionReduced()) {
      this.go(this.at >= last ? 0 : Math.min(last, this.at + Math.ceil(last / PICTURES)));
      return;
    }
    if (this.begun !== undefined) {
      this.stop();
      return;
    }
    if (this.at >= last) this.at = 0;
    this.begun = performance.now() - (this.at / last) * LENGTH * 1000;
    this.play.textContent = "Pause";
    requestAnimationFrame(() => this.frame());
  }

  private stop(): void {
    this.begun = undefined;
    this.play.textContent = "Play";
  }

  private frame(): void {
    if (this.begun === undefined || !this.shown || !this.root.isConnected || this.root.offsetParent === null) {
      this.stop();
      return;
    }
    const last = this.shown.time.length - 1;
    const share = (performance.now() - this.begun) / (LENGTH * 1000);
    this.go(Math.min(last, Math.round(share * last)));
    if (share >= 1) this.stop();
    else requestAnimationFrame(() => this.frame());
  }

  private go(at: number): void {
    this.at = at;
    this.cursor.move(at, this);
    this.draw();
  }

  draw(): void {
    const { shown } = this;
    const width = this.canvas.clientWidth;
    const context = this.canvas.getContext("2d");
    if (!shown || !context || width === 0) return;
    const height = this.canvas.clientHeight;
    const scale = devicePixelRatio || 1;
    this.canvas.width = Math.round(width * scale);
    this.canvas.height = Math.round(height * scale);
    const pen = new CanvasPen(context, width, height, scale);
    pen.fill(colours().paper);
    const time = shown.time[this.at] ?? 0;
    shown.paint(pen, {
      at: this.at,
      time,
      width,
      height,
      colours: colours(),
      now: (name) => shown.quantity(name)?.[this.at] ?? NaN,
      span: (name) => this.span(shown, name),
      way: (name) => this.integral(shown, name)[this.at] ?? NaN,
      value: shown.value,
    });
    this.slider.value = String(this.at);
    this.slider.setAttribute("aria-valuetext", `${short(time)} s`);
    this.label.textContent = `${shown.law}, ${short(time)} s`;
  }

  private span(shown: Shown, name: string): [number, number] {
    const known = this.spans.get(name);
    if (known) return known;
    const found: [number, number] = [Infinity, -Infinity];
    for (const value of shown.quantity(name) ?? []) {
      found[0] = Math.min(found[0], value);
      found[1] = Math.max(found[1], value);
    }
    this.spans.set(name, found);
    return found;
  }

  private integral(shown: Shown, name: string): Float64Array {
    const known = this.integrals.get(name);
    if (known) return known;
    const values = shown.quantity(name) ?? new Float64Array();
    const sum = new Float64Array(values.length);
    for (let at = 1; at < sum.length; at++) {
      const step = shown.time[at]! - shown.time[at - 1]!;
      sum[at] = sum[at - 1]! + 0.5 * (values[at - 1]! + values[at]!) * step;
    }
    this.integrals.set(name, sum);
    return sum;
  }
}
