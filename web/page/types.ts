/** What the library is asked and what it answers. Written by `python3 tasks.py types`. */

export type Value = number | string | boolean;

export type Question = { "ask": "catalogue" } | { "ask": "system", 
/**
 * The run.
 */
run: Partial<Run>, } | { "ask": "solve", 
/**
 * The run with all laws: a setting that none of them has is refused.
 */
run: Partial<Run>, 
/**
 * The law; none if the system has its own.
 */
law: string | null, } | { "ask": "csv", 
/**
 * The run.
 */
run: Partial<Run>, 
/**
 * The law.
 */
law: string | null, } | { "ask": "toml", 
/**
 * The run.
 */
run: Partial<Run>, } | { "ask": "c", 
/**
 * The run.
 */
run: Partial<Run>, 
/**
 * The law.
 */
law: string | null, } | { "ask": "curve" } & Strokes | { "ask": "strokes" } & Strokes | { "ask": "strokes-c" } & Strokes | { "ask": "ssv", 
/**
 * The model.
 */
model: string, 
/**
 * Values of its parameters.
 */
set: Record<string, Value>, } | { "ask": "rig", 
/**
 * The rig, as a user types it.
 */
rig: Record<string, string>, } | { "ask": "quality", 
/**
 * The identification.
 */
fit: Fit, 
/**
 * The record and the motion.
 */
files: Texts, } | { "ask": "fit", 
/**
 * The identification.
 */
fit: Fit, 
/**
 * The record and the motion.
 */
files: Texts, } | { "ask": "command", 
/**
 * What is done.
 */
job: Job, } | { "ask": "python", 
/**
 * What is done.
 */
job: Job, };

export type Run = { 
/**
 * Built-in system (see `stribeck systems`) or path of a system file (.toml)
 */
system?: string, 
/**
 * Friction law; several for `compare`
 */
law: Array<string>, 
/**
 * Solver
 */
solver?: string, 
/**
 * Relative and absolute tolerance (default 1e-8)
 */
tol?: number, 
/**
 * End of the run in s
 */
until?: number, 
/**
 * Interval of the results in s
 */
every?: number, 
/**
 * Communication step of co-simulation in s (default 1e-3); `find` searches for the largest one that is close to
 * the solution
 */
step?: number | "find", 
/**
 * Part by which co-simulation with the step that is found may differ from the solution (default 0.01)
 */
within?: number, 
/**
 * Order of exchange in co-simulation
 */
exchange?: string, 
/**
 * Largest random part by which a communication step differs from the others
 */
jitter?: number, 
/**
 * Let steps extend across events instead of locating them
 */
"no-events": boolean, 
/**
 * Repeat the run at a tenth of its steps' tolerance (in co-simulation, of its step), and report the difference
 */
check: boolean, 
/**
 * Results to record, such as rig.position or der(rig.block_velocity)
 */
record: Array<string>, 
/**
 * One run for each of n values of a variable
 */
vary?: string, 
/**
 * Values of variables; the command line gives them one by one.
 */
set?: Record<string, Value>, };

export type Fit = Record<string, string>;

export type Texts = Record<string, string>;

export type Strokes = { model: string, set: Record<string, Value>, held: Record<string, number>, 
/**
 * Highest velocity of the curve, m/s.
 */
velocity: number, 
/**
 * Length of the strokes, m.
 */
stroke: number, 
/**
 * Their highest speed, m/s.
 */
speed: number, };

export type Job = { "run": Partial<Run> } | { "fit": Fit } | { "strokes": Strokes };

export type Written = { 
/**
 * The text.
 */
text: string, };

export type Catalogue = { version: string, laws: Array<Model>, shock_absorber: Array<Model>, hosts: Array<Model>, components: Array<Model>, systems: Array<SystemEntry>, solvers: Array<Named>, 
/**
 * Laws and components that can be fitted.
 */
fitted: Array<Fittable>, thesis: Thesis, palette: Palette, };

export type Fittable = { name: string, 
/**
 * Whether a normal force presses it together; a component has none.
 */
has_load: boolean, 
/**
 * Quantities that drive it, beside its motion and normal force.
 */
drives: Array<Drive>, };

export type Drive = { name: string, 
/**
 * Its units for a body that slides and for one that turns.
 */
units: [string, string], 
/**
 * Its value where a record has no such column; none if it must be given.
 */
usual: number | null, help: string, };

export type Thesis = { classes: [string, string, string, string], times: Array<[string, [number | null, number | null, number | null, number | null]]>, };

export type Palette = { light: Colours, dark: Colours, dashes: [string, string, string, string, string, string, string, string], };

export type Colours = { paper: string, ink: string, grid: string, axis: string, laws: string[], };

export type Named = { name: string, help: string, };

export type SystemEntry = { name: string, title: string, source: string, until: number, every: number, show: Record<string, string>, 
/**
 * The law of the part that any law can be; none if laws are chosen inside of parts.
 */
law: string | null, };

export type Model = { name: string, summary: string, variables: Array<Variable>, presets: Array<Preset>, };

export type Preset = { name: string, source: string, 
/**
 * Values as a user writes them.
 */
values: Record<string, string>, };

export type Variable = { name: string, role: string, kind: "real" | "integer" | "boolean" | "choice", unit: string, start: number, nominal: number, bound: string, minimum: number | null, maximum: number | null, help: string, choices: Array<Named>, 
/**
 * The part that it plays in a law of friction.
 */
meaning: string, };

export type Choice = { 
/**
 * Its name.
 */
name: string, 
/**
 * What it does.
 */
help: string, 
/**
 * What it may be; empty if that is not one of a few words.
 */
choices: Array<string>, 
/**
 * Whether it is there or not, and has no value.
 */
is_flag: boolean, };

export type Parts = { parts: Array<Part>, signals: Array<Moving>, until: number, every: number, tol: number, results: Array<string>, };

export type Part = { name: string, model: string, is_law: boolean, values: Record<string, number>, };

export type Moving = { input: string, unit: string, properties: Array<Property>, };

export type Property = { name: string, value: number, };

export type Solved = { law: string | null, solver: string, reached: boolean, end: string, 
/**
 * Why the outcome is not what was asked for.
 */
fault: string | null, check: Check | null, statistics: Statistics, columns: Array<Column>, 
/**
 * The part that had each event; the times are the last array.
 */
events: Array<string>, };

export type Statistics = { steps: number, rejected: number, evaluations: number, jacobians: number, };

export type Column = { name: string, unit: string, };

export type Check = { 
/**
 * What was made finer.
 */
of: Finer, 
/**
 * The tolerance of the finer run, or its communication step in s.
 */
finer: number, 
/**
 * How the finer run ended.
 */
end: string, 
/**
 * The largest difference of each recorded result.
 */
differences: Array<Difference>, 
/**
 * Why the tolerance or the step does not hold; none if it does.
 */
fault: string | null, };

export type Finer = "tolerance" | "step";

export type Difference = { 
/**
 * Name of the result.
 */
name: string, 
/**
 * Unit of the result.
 */
unit: string, 
/**
 * The difference, without sign.
 */
largest: number, 
/**
 * The same in parts of the range, from the smallest to the largest value of both runs; 0 without a difference.
 */
part: number, 
/**
 * Output time of the difference, in s.
 */
time: number, };

export type Loop = { every: number, period: number, 
/**
 * Parameter with which the law can give back more energy than it took.
 */
warning: string | null, };

export type Files = { force: string, camera: string | null, truth: Record<string, number>, };

export type Label = { name: string, unit: string, };

export type Labels = { time: Label, displacement: Label, velocity: Label, force: Label, };

export type RecordQuality = { samples: number, duration: number, interval: number, gaps: number, noise: number, fastest: number, slow: number, reversals: number, differentiated: boolean, velocity_error: number, delay: number, cycles: number, };

export type MapQuality = { rows: number, 
/**
 * Number of different speeds and loads.
 */
settings: number, velocities: [number, number], 
/**
 * Standard deviation of the repeats, if there are some.
 */
scatter: number | null, };

export type Quality = { labels: Labels, loads: [number, number], findings: Array<string>, record: RecordQuality | null, map: MapQuality | null, };

export type Units = { 
/**
 * Of a force or torque.
 */
force: string, 
/**
 * Of a displacement or angle.
 */
displacement: string, 
/**
 * Of a velocity.
 */
velocity: string, };

export type Fitted = { ranking: Ranking, best: string, level: number, 
/**
 * Number of the cycles of the record, as the fit corrects it.
 */
cycles: number, 
/**
 * Standard deviation of the noise of what was fitted, or of the scatter of repeats, if it is known.
 */
noise: number | null, 
/**
 * Names of the curves of steady sliding, if it is a map.
 */
curves: Array<string>, 
/**
 * Description of a fit that was cancelled.
 */
early: string | null, condition: number, 
/**
 * The file for `stribeck run`; none for a component, which no system has in place of a law.
 */
toml: string | null, ssv: string, };

export type Ranking = { 
/**
 * The units of the records.
 */
units: Units, 
/**
 * The laws, the best first.
 */
laws: Array<FittedLaw>, 
/**
 * Laws that cannot be fitted.
 */
refused: Array<RefusedLaw>, 
/**
 * For each record what is to be known of it, first how it is taken to begin.
 */
findings: Record<string, string[]>, };

export type FittedLaw = { 
/**
 * The law.
 */
law: string, 
/**
 * Bayesian information criterion above that of the best law.
 */
delta_bic: number, 
/**
 * Whether it cannot be told apart from the best law.
 */
tied: boolean, 
/**
 * RMS residual, in the unit of a force or torque.
 */
rms: number, 
/**
 * The same without outliers.
 */
noise: number, 
/**
 * RMS residual in each validation record.
 */
validation: Record<string, number>, 
/**
 * Number of samples.
 */
samples: number, 
/**
 * Correlation time of the residuals, in samples.
 */
correlation: number, 
/**
 * Whether several searches found the same values.
 */
repeatable: boolean, 
/**
 * Whether the sensitivities are exact.
 */
exact: boolean, 
/**
 * Ratio of the best to the worst known direction.
 */
condition: number, 
/**
 * Correlations among the parameters.
 */
correlations: Array<Array<number>>, 
/**
 * Evaluations of the law.
 */
evaluations: number, 
/**
 * Misfit of a map with repeats, compared with their scatter.
 */
lack_of_fit: LackOfFit | null, 
/**
 * Warnings.
 */
warnings: Array<string>, 
/**
 * Judgement of values that were given: a reference, or values that were all held.
 */
judgement: Judgement | null, 
/**
 * The parameters that were held or that the data determine.
 */
values: Record<string, number>, 
/**
 * Description of a fit that was cancelled.
 */
early: string | null, 
/**
 * The parameters.
 */
estimates: Array<Estimate>, };

export type Estimate = { 
/**
 * Its name.
 */
name: string, 
/**
 * Its unit.
 */
unit: string, 
/**
 * The two parameters whose difference it is, if it is one.
 */
difference_of: [string, string] | null, 
/**
 * `determined`, or why there is no value.
 */
verdict: string, 
/**
 * Its value.
 */
value: number | null, 
/**
 * Interval of 95 %, by the sensitivities and the profile likelihood.
 */
interval: [number, number] | null, 
/**
 * Interval of 95 %, from repetitions with blocks of residuals.
 */
repeated: [number, number] | null, 
/**
 * Value and intervals for a reader, or why there are none.
 */
text: string, 
/**
 * Value and intervals in one notation, for a cell of a table; none without a value.
 */
readable: Readable | null, };

export type Readable = { 
/**
 * The value with the distances of both ends of its interval; without them if the search ended early.
 */
value: string, 
/**
 * Interval from repetitions.
 */
repeated: string | null, };

export type RefusedLaw = { 
/**
 * The law.
 */
law: string, 
/**
 * Why.
 */
reason: string, };

export type Judgement = { 
/**
 * Where the values are from: a preset, a file, or `fix`.
 */
source: string, 
/**
 * The values of the law.
 */
values: Record<string, number>, 
/**
 * RMS residual of the values, in the unit of a force or torque.
 */
rms: number, 
/**
 * That of the best fit of the same law, if one was made.
 */
fit_rms: number | null, 
/**
 * Values outside the interval of the fit.
 */
outside: Array<Outside>, 
/**
 * The verdict, in words.
 */
verdict: string, 
/**
 * Warnings of the values, as of a fit.
 */
warnings: Array<string>, 
/**
 * Note on values that are those of another law.
 */
note: string | null, };

export type Outside = { 
/**
 * The parameter, or the difference of two.
 */
name: string, 
/**
 * The value that was given.
 */
value: number, 
/**
 * Interval of 95 % of the fit.
 */
interval: [number, number], };

export type LackOfFit = { 
/**
 * Ratio of the variance of the means to that of the repeats.
 */
ratio: number, 
/**
 * Degrees of freedom of both.
 */
freedom: [number, number], 
/**
 * Whether the scatter explains it.
 */
explained: boolean, };

export const IDENTIFICATION: Choice[] = [{"name":"column","help":"Name of a column in the records: force=Kraft_1; in binary files (.mf4, .mat) that of a channel or variable","choices":[],"is_flag":false},{"name":"scale","help":"Factor of a column: force=35.15 if it has volts of an amplifier with 35.15 N/V, displacement=-1 if it is reversed","choices":[],"is_flag":false},{"name":"joint","help":"The records are of a joint: columns without a unit are in N m, rad and rad/s","choices":[],"is_flag":true},{"name":"torque_constant","help":"Torque constant of the motor of a joint in N m/A: its current, in A, stands in the column of the force","choices":[],"is_flag":false},{"name":"gear_ratio","help":"Turns of the motor for one of the joint: torque or current are of the motor, and their column is multiplied by it","choices":[],"is_flag":false},{"name":"motor_side","help":"Columns of the motor, before the gear: force, displacement, velocity (default: force, with --gear-ratio)","choices":[],"is_flag":false},{"name":"axis","help":"The records are of an axis, M a = F - f - offset: fit mass and offset too, with Coulomb and viscous friction unless a law is given, at a normal force of 1 N unless one is known","choices":[],"is_flag":true},{"name":"window","help":"Window in s for smoothing and differentiating the motion, 0 for the shortest of 7 samples (default: up to 391 samples, at most a tenth of the record, with the least error of velocity and acceleration; for an axis 9 to 191 samples, force and motion alike, 0 for 3)","choices":[],"is_flag":false},{"name":"delay","help":"Delay of the motion behind the force in s; or `find`, or `find:LONGEST` (default: 0; for an axis that of a controller, up to two samples, is found)","choices":[],"is_flag":false},{"name":"skip","help":"Seconds at the start of the records that are skipped (default: 0)","choices":[],"is_flag":false},{"name":"rest","help":"Speed in m/s below which samples are left out (default: three times the error of the velocity, and for Coulomb and viscous friction of an axis a twentieth of the highest speed; 0 for none)","choices":[],"is_flag":false},{"name":"fix","help":"Parameter that is held, in those of several laws that have it: sigma_1=0; also mass and offset of the rig, gravity_cos and gravity_sin","choices":[],"is_flag":false},{"name":"fit","help":"Additional parameter to fit: an exponent, mass, offset; gravity of the arm of a joint","choices":[],"is_flag":false},{"name":"tie","help":"Parameter that has the value of another one of its law: mu_k_backward=mu_k_forward","choices":[],"is_flag":false},{"name":"range","help":"Range of a parameter instead of the one that follows from the data","choices":[],"is_flag":false},{"name":"method","help":"Search over the whole range (default: evolution)","choices":["evolution","genetic"],"is_flag":false},{"name":"loss","help":"Cost of a residual: squares, or less for outliers (default: squares)","choices":["squares","robust"],"is_flag":false},{"name":"folds","help":"Cross-validation: fit all parts of the records but one, in turn, and hold the law against that part (default: none)","choices":[],"is_flag":false},{"name":"budget","help":"Evaluations of the law in a search over the whole range, before least squares; at least those of its first generations are made, 48 or 16 for each parameter, 62 by the genetic algorithm (default: 3000)","choices":[],"is_flag":false},{"name":"seed","help":"Seed of the search and of the repetitions (default: 1)","choices":[],"is_flag":false},{"name":"repetitions","help":"Repetitions with blocks of residuals (default: 40)","choices":[],"is_flag":false}];
