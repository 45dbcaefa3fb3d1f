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

export interface Preset {
  name: string;
  source: string;
  /** Values as a user writes them. */
  values: Record<string, string>;
}

export interface Model {
  name: string;
  summary: string;
  variables: Variable[];
  presets: Preset[];
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

export interface Choice {
  name: string;
  help: string;
  choices: string[];
  is_flag: boolean;
}

export interface Catalogue {
  version: string;
  laws: Model[];
  shock_absorber: Model[];
  hosts: Model[];
  systems: SystemEntry[];
  solvers: { name: string; help: string }[];
  /** Laws that can be fitted. */
  fitted: string[];
  /** Options of an identification. */
  identification: Choice[];
  /** Solvers of the thesis, and its times in s for each law; null where it did not converge. */
  thesis: { classes: string[]; times: [string, (number | null)[]][] };
  palette: { light: Colours; dark: Colours; dashes: string[] };
}

export interface Part {
  name: string;
  model: string;
  is_law: boolean;
  values: Record<string, number>;
}

/** The signal of an input that moves, with the numbers by which it does. */
export interface Moving {
  input: string;
  unit: string;
  properties: { name: string; value: number }[];
}

export interface Parts {
  parts: Part[];
  signals: Moving[];
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
  record?: string[];
  set?: Record<string, Value>;
}

/** A law, its parameters, inputs that are held, and its motion. */
export interface Strokes {
  model: string;
  set: Record<string, Value>;
  held: Record<string, number>;
  /** Highest velocity of the curve, m/s. */
  velocity: number;
  /** Length of the strokes, m, and their highest speed, m/s. */
  stroke: number;
  speed: number;
}

/** An identification: what is known, and further options as typed. */
export interface Fit {
  inquiry: Record<string, Value | string[]>;
  options: Record<string, string>;
}

/** What can be done elsewhere too. */
export type Job = { run: Run } | { fit: Fit } | { strokes: Strokes };

export interface Quality {
  samples: number;
  duration: number;
  interval: number;
  gaps: number;
  saturated: number;
  noise: number;
  resolution: number;
  fastest: number;
  slow: number;
  reversals: number;
  loads: [number, number];
  findings: string[];
  window: number;
  differentiated: boolean;
  velocity_error: number;
  delay: number;
  cycles: number;
}

export interface Estimate {
  name: string;
  unit: string;
  verdict: string;
  value: number | null;
  interval: [number, number] | null;
  repeated: [number, number] | null;
}

export interface FittedLaw {
  law: string;
  delta_bic: number;
  tied: boolean;
  rms: number;
  samples: number;
  repeatable: boolean;
  evaluations: number;
  warnings: string[];
  values: Record<string, number>;
  estimates: Estimate[];
}

export interface Fitted {
  ranking: { laws: FittedLaw[]; refused: { law: string; reason: string }[] };
  best: string;
  level: number;
  /** Description of a fit that was cancelled. */
  early: string | null;
  toml: string;
  ssv: string;
}

/** Files of a virtual rig, and the values of its law. */
export interface Files {
  force: string;
  camera: string | null;
  truth: Record<string, number>;
}

export type Question =
  | { ask: "catalogue" }
  | { ask: "system"; run: Run }
  | { ask: "solve" | "csv" | "c"; run: Run; law: string | null }
  | { ask: "toml"; run: Run }
  | ({ ask: "curve" | "strokes" | "strokes-c" } & Strokes)
  | { ask: "command" | "python"; job: Job }
  | { ask: "ssv"; model: string; set: Record<string, Value> }
  | { ask: "rig"; law: string; mass: number; normal_force: number; duration: number; faults: boolean; seed: number }
  | { ask: "quality" | "fit"; fit: Fit; files: Record<string, string> };

export interface Answer<T> {
  answer: T;
  arrays: Float64Array[];
  /** Time on the clock, in ms. */
  took: number;
}

/** A refusal of the library, with its reason. */
export class Refused extends Error {}
