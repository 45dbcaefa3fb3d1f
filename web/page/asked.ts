/** Requests of runs to the library. */

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
export function run(state: State, record: string[] = []): Partial<Run> {
  const run: Partial<Run> = { system: state.system, law: [...state.laws] };
  if (state.solver !== "auto") run.solver = state.solver;
  for (const name of ["tol", "until", "every"] as const) {
    if (state[name] === "") continue;
    const number = parsed(state[name]);
    if (number === undefined) throw new RangeError(`${name} = '${state[name]}': must be a number`);
    run[name] = number;
  }
  if (state.check) run.check = true;
  if (record.length > 0) run.record = record;
  const set = Object.entries(state.set);
  if (set.length > 0) run.set = Object.fromEntries(set.map(([name, text]) => [name, value(text)]));
  return run;
}

/** Values of parameters, without the name of the part that they were set in. */
export function ofPart(state: State, part: string): Record<string, Value> {
  const own = Object.entries(state.set).filter(([name]) => name.startsWith(`${part}.`));
  return Object.fromEntries(own.map(([name, text]) => [name.slice(part.length + 1), value(text)]));
}
