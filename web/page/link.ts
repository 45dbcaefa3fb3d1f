/** The states of the views and their links. */

import { parsed } from "./format";
import type { Value } from "./types";

export const VIEWS = ["bench", "law", "strut", "fit"] as const;
export type View = (typeof VIEWS)[number];

export interface State {
  laws: string[];
  system: string;
  solver: string;
  /** Numbers as typed; empty where the system decides. */
  tol: string;
  until: string;
  every: string;
  /** Whether each run is repeated at a tenth of the tolerance. */
  check: boolean;
  /** Values by `part.variable`, as typed. */
  set: Record<string, string>;
}

export interface Place {
  view: View;
  state: State;
}

/** The version is raised when a link of an older one would be read differently; older ones stay readable. */
const VERSION = 1;
const PLAIN = { solver: "auto", tol: "", until: "", every: "", check: false, set: {} };
const DEFAULTS: Record<View, State> = {
  bench: { laws: ["CoulombStiction", "LuGre"], system: "belt", ...PLAIN },
  law: { laws: ["LuGre"], system: "", ...PLAIN },
  strut: { laws: ["LuGre"], system: "dyno", ...PLAIN },
  fit: { laws: ["LuGre"], system: "", ...PLAIN },
};

export function defaults(view: View): State {
  return structuredClone(DEFAULTS[view]);
}

/** Settings that differ from the defaults, as the hash of a link. */
export function toHash({ view, state }: Place): string {
  const usual = DEFAULTS[view];
  const entries: [string, string][] = [];
  if (view !== "bench") entries.push(["view", view]);
  for (const name of ["system", "solver", "tol", "until", "every"] as const) {
    if (state[name] !== usual[name]) entries.push([name, state[name]]);
  }
  if (state.check !== usual.check) entries.push(["check", String(state.check)]);
  if (state.laws.join() !== usual.laws.join()) entries.push(["law", state.laws.join()]);
  for (const name of Object.keys(state.set).sort()) entries.push([name, state.set[name]!]);
  if (entries.length === 0) return "";
  const escape = (text: string) => encodeURIComponent(text).replace(/%2C/g, ",");
  return `#v=${VERSION}&${entries.map(([name, value]) => `${escape(name)}=${escape(value)}`).join("&")}`;
}

/** The state of a link; `faults` are entries that it does not understand. */
export function fromHash(hash: string): Place & { faults: string[] } {
  const faults: string[] = [];
  const entries: [string, string][] = [];
  for (const entry of hash.replace(/^#/, "").split("&").filter(Boolean)) {
    const [name, value] = decoded(entry);
    if (name === undefined || value === undefined) faults.push(`'${entry}' must be name=value`);
    else entries.push([name, value]);
  }
  const asked = entries.findLast(([name]) => name === "view")?.[1] ?? "bench";
  const view = VIEWS.find((known) => known === asked);
  if (!view) faults.push(`the view '${asked}' does not exist; there are ${VIEWS.join(", ")}`);
  const state = defaults(view ?? "bench");
  for (const [name, value] of entries) if (name !== "view") read(state, name, value, faults);
  return { view: view ?? "bench", state, faults };
}

function decoded(entry: string): [string?, string?] {
  const at = entry.indexOf("=");
  if (at < 1) return [];
  try {
    return [decodeURIComponent(entry.slice(0, at)), decodeURIComponent(entry.slice(at + 1))];
  } catch {
    return [];
  }
}

function read(state: State, name: string, value: string, faults: string[]): void {
  if (name === "v") {
    if (Number(value) !== VERSION) faults.push(`the link is of version ${value}; this page reads version ${VERSION}`);
  } else if (name === "law") {
    state.laws = value.split(",").filter(Boolean);
  } else if (name === "system" || name === "solver") {
    state[name] = value;
  } else if (name === "tol" || name === "until" || name === "every") {
    state[name] = value;
  } else if (name === "check" && (value === "true" || value === "false")) {
    state.check = value === "true";
  } else if (name.includes(".") && name !== "__proto__") {
    state.set[name] = value;
  } else {
    faults.push(`'${name}' is unknown`);
  }
}

/** A value as typed, as a number or a truth where it is one. */
export function value(text: string): Value {
  if (text === "true" || text === "false") return text === "true";
  const number = parsed(text);
  return number === undefined || Object.is(number, -0) ? text : number;
}
