/** Drawings of systems: a block on its ground, and the section of a strut. */

import { tickText } from "./drawing";
import type { Pen } from "./pen";
import type { Instant, Paint } from "./scene";

type Point = [number, number];

function outline(pen: Pen, points: Point[], colour: string, width: number): void {
  points.forEach((point, at) => at > 0 && pen.line(points[at - 1]!, point, colour, width));
}

function box(pen: Pen, [left, top]: Point, [right, bottom]: Point, colour: string, width = 2): void {
  outline(pen, [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]], colour, width);
}

/** Coils between two points on a level, or above each other. */
function coils(pen: Pen, from: Point, to: Point, radius: number, count: number, colour: string): void {
  const [across, up] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(across, up) || 1;
  const points: Point[] = [from];
  for (let turn = 0; turn < count; turn++) {
    const share = (turn + 0.5) / count;
    const side = turn % 2 === 0 ? radius : -radius;
    points.push([from[0] + share * across - (side * up) / length, from[1] + share * up + (side * across) / length]);
  }
  outline(pen, [...points, to], colour, 1.75);
}

function arrow(pen: Pen, from: Point, to: Point, colour: string): void {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (!(length > 2)) return;
  const [x, y] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  pen.line(from, to, colour, 2.5);
  const head = Math.min(8, length);
  for (const side of [-1, 1]) {
    pen.line(to, [to[0] - head * x + side * 0.5 * head * y, to[1] - head * y - side * 0.5 * head * x], colour, 2.5);
  }
}

/** Size of the numbers. */
const SIZE = 14;

/** A number with the decimals that tell hundredths of its range apart: its digits stay in their places while it changes. */
function steady(value: number, [low, high]: [number, number]): string {
  const order = Math.floor(Math.log10(Math.max(Math.abs(low), Math.abs(high)) || 1));
  return tickText(value, Math.max(0, 2 - order));
}

/** Position of a value between two positions. */
function placed(value: number, [low, high]: [number, number], [from, to]: [number, number]): number {
  return high > low ? from + ((value - low) / (high - low)) * (to - from) : 0.5 * (from + to);
}

const BRISTLES = 9;
const ROLL = 46;

/** A block on a belt, held by a spring to a wall if `isHeld`. The bristles lean with the friction force. */
export function block(isHeld: boolean): Paint {
  return (pen, instant) => {
    const { width, height, colours, now, span, way } = instant;
    const ground = height - 46;
    const [wide, high, gap] = [86, 44, 16];
    const position = isHeld ? now("position") : 0;
    const range = isHeld ? span("position") : ([0, 0] as [number, number]);
    const middle = placed(position, range, [0.34 * width, Math.min(0.8 * width, width - 70)]);
    const perMetre = range[1] > range[0] ? (Math.min(0.8 * width, width - 70) - 0.34 * width) / (range[1] - range[0]) : reach(instant);
    // Travel of the belt: displacement of the block less its sliding distance on the belt.
    const travel = ((isHeld ? position - range[0] : 0) - way("velocity")) * perMetre;
    belt(pen, instant, ground, travel);
    const top = ground - gap - high;
    box(pen, [middle - wide / 2, top], [middle + wide / 2, ground - gap], colours.ink, 2);
    bristles(pen, instant, middle, wide - 12, ground, gap);
    if (isHeld) {
      pen.line([16, top - 12], [16, ground - 6], colours.axis, 4);
      coils(pen, [18, top + high / 2], [middle - wide / 2, top + high / 2], 9, 14, colours.axis);
    }
    const [low, most] = span("force");
    const force = now("force");
    const large = Math.max(Math.abs(low), Math.abs(most)) || 1;
    const length = (0.16 * width * force) / large;
    // The block feels the negative of the friction force.
    arrow(pen, [middle, top - 10], [middle - length, top - 10], colours.laws[0]!);
    pen.text([middle, top - 20], `friction ${steady(force, [low, most])} N`, colours.ink, "middle", false, SIZE);
  };
}

/** Pixels per metre of a system whose block does not move in the drawing. */
function reach({ span, width }: Instant): number {
  const [low, high] = span("velocity");
  return (0.5 * width) / (Math.max(Math.abs(low), Math.abs(high)) || 1);
}

function belt(pen: Pen, { width, colours }: Instant, ground: number, travel: number): void {
  const [left, right, radius] = [40, width - 12, 13];
  pen.line([left, ground], [right, ground], colours.ink, 3);
  pen.line([left, ground + 2 * radius], [right, ground + 2 * radius], colours.axis, 1.5);
  const shift = ((travel % ROLL) + ROLL) % ROLL;
  for (let x = left - ROLL + shift; x < right; x += ROLL) {
    if (x > left) pen.line([x, ground + 2], [x - 7 < left ? left : x - 7, ground + 10], colours.axis, 2);
  }
  for (const centre of [left + radius, right - radius]) {
    const turn = travel / radius;
    pen.disc([centre, ground + radius], radius, colours.axis);
    pen.disc([centre, ground + radius], radius - 2, colours.paper);
    pen.line(
      [centre - 9 * Math.cos(turn), ground + radius - 9 * Math.sin(turn)],
      [centre + 9 * Math.cos(turn), ground + radius + 9 * Math.sin(turn)],
      colours.axis,
      2,
    );
  }
}

/** Bristles of the block: their tips are carried along by the ground, the more the larger the force. */
function bristles(pen: Pen, { colours, now, span }: Instant, middle: number, wide: number, ground: number, gap: number): void {
  const [low, high] = span("force");
  const lean = now("force") / (Math.max(Math.abs(low), Math.abs(high)) || 1);
  for (let number = 0; number < BRISTLES; number++) {
    const x = middle + (number / (BRISTLES - 1) - 0.5) * wide;
    const [root, tip]: [Point, Point] = [[x, ground - gap], [x - 11 * lean, ground - 1]];
    // A bent line: it leaves the block upright.
    const points = [0, 0.25, 0.5, 0.75, 1].map((s): Point => [root[0] + (tip[0] - root[0]) * s * s, root[1] + (tip[1] - root[1]) * s]);
    outline(pen, points, colours.laws[0]!, 1.75);
  }
}

/** Half the width of the tube, and distance of the rows of numbers, in pixels (chosen). */
const TUBE = 28;
const ROW = 19;

/** The section of a strut between its eyes, with the forces at guide and piston. */
export const strut: Paint = (pen, instant) => {
  const { width, height, colours, now, span, value } = instant;
  const extended = value("strut.geom.length_extended");
  const [guide, piston] = [value("strut.geom.d_i"), value("strut.geom.d_j")];
  const length = extended - now("displacement");
  const scale = (width - 60) / extended;
  const axis = 68;
  const x = (metres: number) => 30 + metres * scale;
  // The radii are drawn to scale with each other, not with the length.
  const rod = Math.min(0.8 * TUBE, (TUBE * value("strut.geom.r_1")) / value("strut.geom.r_2") || 0);
  const end = x(guide);
  // Tube with its eye, rod with its eye and piston.
  outline(pen, [[end, axis - rod - 3], [end, axis - TUBE], [x(0) + 14, axis - TUBE], [x(0) + 14, axis + TUBE], [end, axis + TUBE], [end, axis + rod + 3]], colours.ink, 2.5);
  pen.line([x(0), axis], [x(0) + 14, axis], colours.ink, 5);
  const eye = x(length);
  const crown = x(length - piston);
  box(pen, [crown, axis - rod], [eye, axis + rod], colours.ink, 2);
  box(pen, [crown - 7, axis - TUBE + 3], [crown + 3, axis + TUBE - 3], colours.ink, 3);
  for (const place of [x(0), eye]) pen.disc([place, axis], 6, colours.ink);
  coils(pen, [x(0) + 20, axis - TUBE - 16], [eye - 10, axis - TUBE - 16], 9, 26, colours.axis);
  pen.line([x(0) + 20, axis - TUBE - 28], [x(0) + 20, axis - TUBE], colours.axis, 2);
  outline(pen, [[eye - 10, axis - TUBE - 28], [eye - 10, axis - rod]], colours.axis, 2);
  // Names of contacts that are close to each other stand on either side.
  const isTight = end - crown < 60;
  contact(pen, instant, [end, axis + TUBE], "1", isTight ? "start" : "middle");
  contact(pen, instant, [crown - 2, axis + TUBE], "2", isTight ? "end" : "middle");
  const row = (number: number, text: string) => pen.text([10, height - 9 - (2 - number) * ROW], text, colours.ink, "start", false, SIZE);
  const millimetres = span("displacement").map((end) => 1000 * end) as [number, number];
  row(0, `force ${steady(now("force"), span("force"))} N, compression ${steady(1000 * now("displacement"), millimetres)} mm`);
  Object.entries(CONTACTS).forEach(([number, name]) => {
    const newtons = (quantity: string) => `${steady(now(`${quantity}_${number}`), span(`${quantity}_${number}`))} N`;
    row(Number(number), `${name}: friction ${newtons("friction")}, normal force ${newtons("normal")}`);
  });
};

/** Contacts of rod and tube by their numbers. */
const CONTACTS = { 1: "guide", 2: "piston" };

function contact(pen: Pen, { colours, now, span }: Instant, [x, y]: Point, number: "1" | "2", anchor: "start" | "middle" | "end"): void {
  const [normal, friction] = [now(`normal_${number}`), now(`friction_${number}`)];
  const [, most] = span(`normal_${number}`);
  const up = most > 0 ? (30 * normal) / most : 0;
  const colour = colours.laws[Number(number) - 1]!;
  arrow(pen, [x, y + 4 + up], [x, y + 4], colour);
  // The rod feels the negative of the friction force.
  const along = -28 * Math.sign(friction) * Math.min(1, Math.abs(friction) / 25);
  arrow(pen, [x, y + 38], [x + along, y + 38], colour);
  pen.text([x, y + 56], CONTACTS[number], colours.ink, anchor, false, SIZE);
}
