/** The state of the page, its link, and the same run for the command line and Python. */

import { parsed } from "./format";
import type { Run, Value } from "./types";

export interface State {
  laws: string[];
  system: string;
  solver: string;
  /** Numbers as typed; empty where the system decides. */
  tol: string;
  until: string;
  every: string;
  /** Values by `part.variable`, as typed. */
  set: Record<string, string>;
}

const VERSION = 1;
const DEFAULTS: State = {
  laws: ["CoulombStiction", "LuGre"],
  system: "belt",
  solver: "auto",
  tol: "",
  until: "",
  every: "",
  set: {},
};

export function defaults(): State {
  return structuredClone(DEFAULTS);
}

/** What differs from the defaults, as the hash of a link. */
export function toHash(state: State): string {
  const entries: [string, string][] = [];
  for (const name of ["system", "solver", "tol", "until", "every"] as const) {
    if (state[name] !== DEFAULTS[name]) entries.push([name, state[name]]);
  }
  if (state.laws.join() !== DEFAULTS.laws.join()) entries.push(["law", state.laws.join()]);
  for (const name of Object.keys(state.set).sort()) entries.push([name, state.set[name]!]);
  if (entries.length === 0) return "";
  const escape = (text: string) => encodeURIComponent(text).replace(/%2C/g, ",");
  return `#v=${VERSION}&${entries.map(([name, value]) => `${escape(name)}=${escape(value)}`).join("&")}`;
}

/** The state of a link; `faults` are entries that it does not understand. */
export function fromHash(hash: string): { state: State; faults: string[] } {
  const state = defaults();
  const faults: string[] = [];
  for (const entry of hash.replace(/^#/, "").split("&").filter(Boolean)) {
    const [name, value] = decoded(entry);
    if (name === undefined || value === undefined) faults.push(`'${entry}' must be name=value`);
    else read(state, name, value, faults);
  }
  return { state, faults };
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
  } else if (name.includes(".")) {
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

/** The run of the bench. */
export function run(state: State): Run {
  const run: Run = { system: state.system, law: [...state.laws] };
  if (state.solver !== DEFAULTS.solver) run.solver = state.solver;
  for (const name of ["tol", "until", "every"] as const) {
    if (state[name] === "") continue;
    const number = parsed(state[name]);
    if (number === undefined) throw new RangeError(`${name} = '${state[name]}': must be a number`);
    run[name] = number;
  }
  const set = Object.entries(state.set);
  if (set.length > 0) run.set = Object.fromEntries(set.map(([name, text]) => [name, value(text)]));
  return run;
}

const quoted = (text: string) => (/^[\w.,=+-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`);

/** The same run on the command line. */
export function asCommand(state: State): string {
  const { system, law = [], set = {}, solver, tol, until, every } = run(state);
  const options = Object.entries({ solver, tol, until, every }).filter(([, given]) => given !== undefined);
  return [
    `stribeck ${law.length > 1 ? "compare" : "run"} --system ${quoted(system ?? "")}`,
    `--law ${quoted(law.join())}`,
    ...Object.entries(set).map(([name, given]) => `--set ${quoted(`${name}=${given}`)}`),
    ...options.map(([name, given]) => `--${name} ${quoted(String(given))}`),
  ].join(" ");
}

/** The same run in Python. */
export function asPython(state: State): string {
  const { system, law = [], set, solver, tol, until, every } = run(state);
  const literal = (given: unknown): string => {
    if (typeof given === "boolean") return given ? "True" : "False";
    if (Array.isArray(given)) return `[${given.map(literal).join(", ")}]`;
    if (typeof given !== "object" || given === null) return JSON.stringify(given);
    return `{${Object.entries(given).map(([name, one]) => `${literal(name)}: ${literal(one)}`).join(", ")}}`;
  };
  const options = Object.entries({ set, solver, tol, until, every }).filter(([, given]) => given !== undefined);
  const several = law.length > 1;
  const given = [literal(system), literal(several ? law : law[0]), ...options.map(([k, v]) => `${k}=${literal(v)}`)];
  const call = `stribeck.${several ? "compare" : "solve"}(${given.join(", ")})`;
  return `import stribeck\n\n${several ? "solutions" : "solution"} = ${call}\n`;
}
