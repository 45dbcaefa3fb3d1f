/** Pictures of a record or a map of friction and of the law that was fitted to it. */

import type { Curve, Diagram } from "./drawing";
import type { Fitted, Quality } from "./types";

/** Standard deviations to each side that a band shows (chosen: 95 %). */
const BAND = 1.96;

export type Across = "time" | "velocity" | "displacement";

export interface Seen {
  quality: Quality;
  arrays: Float64Array[];
  fitted: { answer: Fitted; arrays: Float64Array[] } | undefined;
  /** Times and friction of a virtual rig. */
  truth: Float64Array[] | undefined;
}

/** Measured and fitted friction; over velocity and displacement the mean cycle, if the record is periodic. */
export function friction(seen: Seen, across: Across): Diagram | undefined {
  const { labels, record } = seen.quality;
  if (record === null && across !== "velocity") return undefined;
  const cycles = seen.fitted?.answer.cycles ?? record?.cycles ?? 0;
  const isCycle = across !== "time" && cycles > 0;
  const curves = record === null ? ofMap(seen) : ofRecord(seen, across, isCycle);
  const [x, y] = [labels[across], labels.force];
  const of = isCycle ? `, mean of ${cycles} cycles` : "";
  return { title: `${y.name} over ${x.name.toLowerCase()}${of}`, x, y, curves, hasLegend: true };
}

/** Measured less fitted friction, over time or over the velocities of a map. */
export function residuals(seen: Seen, across: Across): Diagram | undefined {
  const { labels, record } = seen.quality;
  if (!seen.fitted || across !== (record ? "time" : "velocity")) return undefined;
  const told = record ? ofRecord(seen, "time", false) : ofRows(seen);
  const [measured, fitted] = [told[0]!, told.at(-1)!];
  const y = Float64Array.from(measured.y, (force, at) => force - fitted.y[at]!);
  const curve: Curve = { name: "residual", x: measured.x, y, law: fitted.law, style: record ? "thin" : "crosses" };
  const noise = BAND * (seen.fitted.answer.noise ?? 0);
  const band = noise > 0 ? `; band: 95 % of the ${record ? "noise" : "scatter"}` : "";
  const x = labels[across];
  const title = `Residual over ${x.name.toLowerCase()}${band}`;
  return { title, x, y: { name: "Residual", unit: labels.force.unit }, curves: [curve], hasLegend: true, told, noise };
}

/** Friction of a record, or of its mean cycle: measured, that of a virtual rig, and fitted. */
function ofRecord({ arrays, fitted, truth }: Seen, across: Across, isCycle: boolean): Curve[] {
  // A fit has corrected what was measured by the mass, offset and delay that it found.
  const all = fitted?.arrays ?? arrays;
  const [time, displacement, velocity, y, explained] = isCycle ? all.slice(fitted ? 5 : 4) : all;
  const x = { time, displacement, velocity }[across]!;
  const measured: Curve = { name: "measured", x, y: y!, law: 0 };
  const others: Curve[] = [];
  if (truth && !isCycle) others.push({ name: "true", x, y: at(time!, truth), law: 2 });
  if (fitted) others.push({ name: `${fitted.answer.best} fitted`, x, y: explained!, law: 1 });
  return others.length > 0 ? [{ ...measured, style: "band" }, ...others] : [measured];
}

/** Samples at equal intervals, at some of their times. */
function at(time: Float64Array, [times, values]: Float64Array[]): Float64Array {
  const [first, second] = times!;
  return Float64Array.from(time, (t) => values![Math.round((t - first!) / (second! - first!))] ?? NaN);
}

/** The rows of a map, and what a law explains in them. */
function ofRows({ arrays: [x, y], fitted }: Seen): Curve[] {
  const measured: Curve = { name: "measured", x: x!, y: y!, law: 0, style: "crosses" };
  return fitted ? [measured, { name: `${fitted.answer.best} fitted`, x: x!, y: fitted.arrays[0]!, law: 1 }] : [measured];
}

function ofMap(seen: Seen): Curve[] {
  const curves = (seen.fitted?.answer.curves ?? []).map((name, number) => {
    const [x, y] = seen.fitted!.arrays.slice(1 + 2 * number);
    return { name, x: x!, y: y!, law: number + 1 };
  });
  return [ofRows(seen)[0]!, ...curves];
}
