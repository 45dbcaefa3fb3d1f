/** What the library tells: see `web/src`. */

export interface Variable {
  name: string;
  role: "Input" | "Fixed" | "Tunable" | "State" | "StateOutput" | "Output";
  kind: "real" | "integer" | "boolean" | "choice";
  unit: string;
  start: number;
  nominal: number;
  bound: string;
  minimum: number | null;
  maximum: number | null;
  help: string;
  choices: { name: string; help: string }[];
}

export interface Model {
  name: string;
  summary: string;
  variables: Variable[];
}

export interface SystemEntry {
  name: string;
  title: string;
  source: string;
  until: number;
  every: number;
  show: Record<string, string>;
  /** The law of the part that any law can be; none if laws are chosen inside of parts. */
  law: string | null;
}

export interface Colours {
  paper: string;
  ink: string;
  grid: string;
  axis: string;
  laws: string[];
}

export interface Catalogue {
  version: string;
  laws: Model[];
  shock_absorber: Model[];
  hosts: Model[];
  systems: SystemEntry[];
  solvers: { name: string; help: string }[];
  palette: { light: Colours; dark: Colours; dashes: string[] };
}

export interface Part {
  name: string;
  model: string;
  is_law: boolean;
  values: Record<string, number>;
}

export interface Parts {
  parts: Part[];
  until: number;
  every: number;
  tol: number;
  results: string[];
}

export interface Column {
  name: string;
  unit: string;
}

export interface Solved {
  law: string | null;
  solver: string;
  reached: boolean;
  end: string;
  statistics: Record<"steps" | "rejected" | "evaluations" | "jacobians", number>;
  columns: Column[];
  /** The part that had each event; the times are the last array. */
  events: string[];
}

export type Value = number | string | boolean;

/** A run as the command line and Python write it. */
export interface Run {
  system?: string;
  law?: string[];
  solver?: string;
  tol?: number;
  until?: number;
  every?: number;
  set?: Record<string, Value>;
}

export type Question =
  | { ask: "catalogue" }
  | { ask: "system"; run: Run }
  | { ask: "solve" | "csv"; run: Run; law: string | null }
  | { ask: "toml"; run: Run };

export interface Answer<T> {
  answer: T;
  arrays: Float64Array[];
  /** Time on the clock, in ms. */
  took: number;
}

/** A refusal of the library, with its reason. */
export class Refused extends Error {}
