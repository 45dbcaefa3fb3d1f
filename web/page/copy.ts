/** The same runs for the command line, Python and C. */

import { parsed } from "./format";
import { type State, value } from "./link";
import type { Run, Value } from "./types";

/** Refuses laws that cannot be shown together. */
export function checkLaws(laws: string[], most: number): void {
  if (laws.length === 0 || laws.length > most) throw new RangeError(`${laws.length} laws: must be 1 to ${most}`);
  const twice = laws.find((law, at) => laws.indexOf(law) < at);
  if (twice !== undefined) throw new RangeError(`the law ${twice} is there twice`);
}

/** The run of a system; `record` are its results if they are not those that it shows. */
export function run(state: State, record: string[] = []): Run {
  const run: Run = { system: state.system, law: [...state.laws] };
  if (state.solver !== "auto") run.solver = state.solver;
  for (const name of ["tol", "until", "every"] as const) {
    if (state[name] === "") continue;
    const number = parsed(state[name]);
    if (number === undefined) throw new RangeError(`${name} = '${state[name]}': must be a number`);
    run[name] = number;
  }
  if (record.length > 0) run.record = record;
  const set = Object.entries(state.set);
  if (set.length > 0) run.set = Object.fromEntries(set.map(([name, text]) => [name, value(text)]));
  return run;
}

const quoted = (text: string) => (/^[\w.,=+-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`);

/** The run on the command line. */
export function asCommand({ system, law = [], set = {}, record = [], solver, tol, until, every }: Run): string {
  const options = Object.entries({ solver, tol, until, every }).filter(([, given]) => given !== undefined);
  return [
    `stribeck ${law.length > 1 ? "compare" : "run"} --system ${quoted(system ?? "")}`,
    `--law ${quoted(law.join())}`,
    ...Object.entries(set).map(([name, given]) => `--set ${quoted(`${name}=${given}`)}`),
    ...record.map((name) => `--record ${quoted(name)}`),
    ...options.map(([name, given]) => `--${name} ${quoted(String(given))}`),
  ].join(" ");
}

/** A value as Python writes it. */
export function literal(given: unknown): string {
  if (typeof given === "boolean") return given ? "True" : "False";
  if (Array.isArray(given)) return `[${given.map(literal).join(", ")}]`;
  if (typeof given !== "object" || given === null) return JSON.stringify(given);
  return `{${Object.entries(given).map(([name, one]) => `${literal(name)}: ${literal(one)}`).join(", ")}}`;
}

/** The run in Python. */
export function asPython({ system, law = [], set, record, solver, tol, until, every }: Run): string {
  const options = Object.entries({ set, record, solver, tol, until, every }).filter(([, given]) => given !== undefined);
  const several = law.length > 1;
  const given = [literal(system), literal(several ? law : law[0]), ...options.map(([k, v]) => `${k}=${literal(v)}`)];
  const call = `stribeck.${several ? "compare" : "solve"}(${given.join(", ")})`;
  return `import stribeck\n\n${several ? "solutions" : "solution"} = ${call}\n`;
}

/** Values of parameters, without the name of the part that they were set in. */
export function ofPart(state: State, part: string): Record<string, Value> {
  const own = Object.entries(state.set).filter(([name]) => name.startsWith(`${part}.`));
  return Object.fromEntries(own.map(([name, text]) => [name.slice(part.length + 1), value(text)]));
}
