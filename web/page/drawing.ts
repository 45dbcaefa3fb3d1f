/** A diagram with two axes, drawn on a canvas or into an SVG. */

import { unitText } from "./format";
import type { Pen, Points } from "./pen";
import type { Colours } from "./types";

export interface Curve {
  name: string;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  /** Number of its colour and dashes. */
  law: number;
  /** Pale and wide, so that others show on it; thin, without dashes that noise hides; a cross at each point. */
  style?: "band" | "thin" | "crosses";
}

export interface Label {
  name: string;
  unit: string;
}

export interface Diagram {
  title: string;
  x: Label;
  y: Label;
  curves: Curve[];
  /** Whether its curves are others than the laws of the view. */
  hasLegend?: boolean;
  /** Of residuals: what they are the difference of, told at the cursor with them. */
  told?: Curve[];
  /** Of residuals: how far from zero noise alone reaches; 0 if it is not known. */
  noise?: number;
}

export type Range = [number, number];

const ROOM = 0.04;

/** Smallest and largest number of arrays, with some room. */
export function range(arrays: ArrayLike<number>[], room = ROOM): Range {
  let low = Infinity;
  let high = -Infinity;
  for (const values of arrays) {
    for (let at = 0; at < values.length; at++) {
      const value = values[at]!;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (!(low <= high)) return [-1, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  // Values that differ only by rounding are constant.
  if (high - low <= 1e-9 * size) return size > 0 ? [low - 0.5 * size, high + 0.5 * size] : [-1, 1];
  return [low - room * (high - low), high + room * (high - low)];
}

/** Range of the values that are shown, with zero and the noise around it if they are residuals. */
export function rangeUp({ noise }: Diagram, values: ArrayLike<number>[]): Range {
  return range(noise === undefined ? values : [...values, [-noise, noise]]);
}

/** The curves whose points the cursor can be at: the crosses, if there are some. */
export function pointed({ curves }: Diagram): Curve[] {
  const crosses = curves.filter(({ style }) => style === "crosses");
  return crosses.length > 0 ? crosses : curves;
}

/** Width, opacity and dashes of a curve. */
export function stroke({ law, style }: Curve, dashes: string[]): { width: number; alpha: number; dash: string } {
  if (style === "band") return { width: 5, alpha: 0.4, dash: "" };
  if (style === "thin") return { width: 1, alpha: 1, dash: "" };
  return { width: 1.75, alpha: 1, dash: style === "crosses" ? "" : dashes[law]! };
}

/** Round values within a range. */
export function ticks([low, high]: Range, count: number): { values: number[]; decimals: number } {
  const rough = (high - low) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const round = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  // A single value does not make a scale.
  const step = Math.floor(high / round) > Math.ceil(low / round) ? round : round / 2;
  const values: number[] = [];
  const first = Math.ceil(low / step);
  for (let number = 0; number <= 10 * count && (first + number) * step <= high; number++) values.push((first + number) * step);
  return { values, decimals: decimalsOf(step) };
}

/** Digits after the point of multiples of a step: two for 0.25. */
export function decimalsOf(step: number): number {
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const scaled = step * 10 ** decimals;
  return Math.abs(scaled - Math.round(scaled)) < 1e-6 ? decimals : decimals + 1;
}

/** The text of a tick. */
export function tickText(value: number, decimals: number): string {
  const text = decimals > 5 || Math.abs(value) >= 1e6 ? value.toExponential(2) : value.toFixed(decimals);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212");
}

export function labelText({ name, unit }: Label): string {
  return unitText(unit) ? `${name} in ${unitText(unit)}` : name;
}

/** Area of the curves, and conversion of values to positions in it. */
export class Frame {
  readonly left = 62;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;

  constructor(
    width: number,
    height: number,
    readonly x: Range,
    readonly y: Range,
    head: number,
  ) {
    this.top = head;
    this.right = width - 14;
    this.bottom = height - 44;
  }

  across(value: number): number {
    return this.left + ((value - this.x[0]) / (this.x[1] - this.x[0])) * (this.right - this.left);
  }

  up(value: number): number {
    return this.bottom - ((value - this.y[0]) / (this.y[1] - this.y[0])) * (this.bottom - this.top);
  }

  /** The values at a position. */
  at(right: number, down: number): [number, number] {
    const [x, y] = [(right - this.left) / (this.right - this.left), (this.bottom - down) / (this.bottom - this.top)];
    return [this.x[0] + x * (this.x[1] - this.x[0]), this.y[0] + y * (this.y[1] - this.y[0])];
  }
}

/** Opacity of the band of the noise (chosen). */
export const NOISE = 0.18;

/** Distance below which two points look like one, in pixels (chosen). */
const CLOSE = 0.4;

/** Positions of a curve; points that coincide with the one before are left out. */
function placed(frame: Frame, x: ArrayLike<number>, y: ArrayLike<number>): Points {
  const places = { x: new Float64Array(x.length), y: new Float64Array(x.length) };
  let count = 0;
  for (let at = 0; at < x.length; at++) {
    const right = frame.across(x[at]!);
    const down = frame.up(y[at] ?? NaN);
    const isClose = count > 0 && Math.abs(right - places.x[count - 1]!) + Math.abs(down - places.y[count - 1]!) < CLOSE;
    // The last point is the end of the curve, wherever it lies.
    if (isClose && at < x.length - 1) continue;
    places.x[count] = right;
    places.y[count++] = down;
  }
  return { x: places.x.subarray(0, count), y: places.y.subarray(0, count) };
}

/** Half the size of a cross, in pixels (chosen). */
const CROSS = 4;

/** A cross at each position, with gaps between the strokes. */
function crosses({ x, y }: Points): Points {
  const strokes = Array.from(x, (right, at) => ({ right, down: y[at]! }));
  return {
    x: strokes.flatMap(({ right }) => [right - CROSS, right + CROSS, NaN, right - CROSS, right + CROSS, NaN]),
    y: strokes.flatMap(({ down }) => [down - CROSS, down + CROSS, NaN, down + CROSS, down - CROSS, NaN]),
  };
}

/** The band of the noise and the line at zero. */
function drawZero(pen: Pen, frame: Frame, noise: number, colours: Colours): void {
  const { left, right, top, bottom } = frame;
  const [zero, wide] = [frame.up(0), 2 * (frame.up(0) - frame.up(noise))];
  const [points, clip] = [{ x: [left, right], y: [zero, zero] }, [left, top, right - left, bottom - top] as [number, number, number, number]];
  if (noise > 0) pen.curve(points, clip, colours.axis, "", wide, NOISE);
  pen.curve(points, clip, colours.axis, "", 1);
}

/** Draws axes and curves. */
export function draw(pen: Pen, frame: Frame, diagram: Diagram, colours: Colours, dashes: string[]): void {
  pen.fill(colours.paper);
  const { left, right, top, bottom } = frame;
  const across = ticks(frame.x, (right - left) / 90);
  for (const value of across.values) {
    const x = frame.across(value);
    pen.line([x, top], [x, bottom], colours.grid);
    pen.text([x, bottom + 17], tickText(value, across.decimals), colours.ink, "middle");
  }
  const upwards = ticks(frame.y, (bottom - top) / 45);
  for (const value of upwards.values) {
    const y = frame.up(value);
    pen.line([left, y], [right, y], colours.grid);
    pen.text([left - 7, y + 4], tickText(value, upwards.decimals), colours.ink, "end");
  }
  pen.line([left, top], [left, bottom], colours.axis);
  pen.line([left, bottom], [right, bottom], colours.axis);
  pen.text([(left + right) / 2, bottom + 37], labelText(diagram.x), colours.ink, "middle");
  pen.text([14, (top + bottom) / 2], labelText(diagram.y), colours.ink, "middle", true);
  if (diagram.noise !== undefined) drawZero(pen, frame, diagram.noise, colours);
  for (const curve of diagram.curves) {
    const places = placed(frame, curve.x, curve.y);
    const { width, alpha, dash } = stroke(curve, dashes);
    const points = curve.style === "crosses" ? crosses(places) : places;
    pen.curve(points, [left, top, right - left, bottom - top], colours.laws[curve.law]!, dash, width, alpha);
  }
}

/** The names of the curves in a line above the diagram; returns its height. */
export function legend(pen: Pen, diagram: Diagram, colours: Colours, dashes: string[], width: number): number {
  pen.text([14, 20], diagram.title, colours.ink, "start");
  let [x, y] = [14, 40];
  for (const curve of diagram.curves) {
    const { name, law, style } = curve;
    const wide = 48 + 7 * name.length;
    if (x + wide > width && x > 14) [x, y] = [14, y + 18];
    const points = style === "crosses" ? crosses({ x: [x + 15], y: [y - 4] }) : { x: [x, x + 30], y: [y - 4, y - 4] };
    const look = stroke(curve, dashes);
    pen.curve(points, [x, y - 10, 30, 12], colours.laws[law]!, look.dash, look.width, look.alpha);
    pen.text([x + 36, y], name, colours.ink, "start");
    x += wide;
  }
  return y + 14;
}
