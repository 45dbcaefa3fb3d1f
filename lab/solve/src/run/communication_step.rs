//! The largest communication step with which co-simulation is close to the solution.

use serde::Serialize;

use super::likeness::{Compared, Deviation};
use super::progress::Share;
use super::{Outcome, Settings, Solver, run};
use crate::couple::{Exchange, Master};
use crate::solve::{End, Progress};
use crate::system::{Fault, System};

/// Largest step that is tried, in parts of the run (chosen).
const LONGEST: f64 = 0.02;

/// Smallest step that is tried, in s (chosen).
const SHORTEST: f64 = 1e-6;

/// Most steps of one run (chosen).
const MOST_STEPS: f64 = 4e6;

/// Number of smaller steps that must agree as well (chosen: a decade).
const CONFIRMED: usize = 3;

/// Interval of the results that are compared, in parts of that of the results (chosen), and the most of them (chosen).
const FINER: f64 = 0.1;
const MOST_RESULTS: f64 = 2e5;

/// Part of the progress that is that of the solution (chosen).
const SOLUTION: f64 = 0.1;

/// Settings of a search for the communication step.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// Largest part by which a quantity may differ from that of the solution.
    pub within: f64,
    /// Orders of exchange.
    pub exchanges: Vec<Exchange>,
}

/// The largest communication steps, for each order of exchange.
#[derive(Clone, Debug, Serialize)]
pub struct CommunicationSteps {
    /// The friction law, if a part of the system can be any.
    pub law: Option<&'static str>,
    /// Largest part by which a quantity may differ from that of the solution.
    pub within: f64,
    /// The solver of the solution.
    pub solver: String,
    /// Its tolerance.
    pub tolerance: f64,
    /// How the solution or, if that was ended early, the search ended.
    #[serde(serialize_with = "super::outcome::shown")]
    pub end: End,
    /// The orders of exchange; none without a solution.
    pub orders: Vec<Order>,
}

/// The steps that were tried in an order of exchange.
#[derive(Clone, Debug, Serialize)]
pub struct Order {
    /// The order of exchange.
    pub exchange: Exchange,
    /// The largest step with which, and with all smaller ones that were tried, the motion is close to the solution, in
    /// s; none if there is no such step.
    pub step: Option<f64>,
    /// The trials, from the largest step on.
    pub trials: Vec<Trial>,
}

/// A run with one step.
#[derive(Clone, Debug, Serialize)]
pub struct Trial {
    /// The step, in s.
    pub step: f64,
    /// The quantities beside those of the solution, if the run came to its end.
    pub deviations: Vec<Deviation>,
    /// Why the motion is not close to the solution; none if it is.
    pub fault: Option<String>,
}

impl Order {
    /// The trial with the largest step that holds.
    pub fn found(&self) -> Option<&Trial> {
        self.trials.iter().find(|trial| Some(trial.step) == self.step)
    }

    /// The trial with the next larger step, which says what limits the step; without a step, the smallest one.
    pub fn limit(&self) -> Option<&Trial> {
        self.trials.iter().rfind(|trial| trial.fault.is_some())
    }

    /// Larger steps that agree by chance: a smaller one does not.
    pub fn by_chance(&self) -> Vec<f64> {
        let limit = self.limit().map_or(0.0, |limit| limit.step);
        self.trials.iter().filter(|trial| trial.step > limit && trial.fault.is_none()).map(|trial| trial.step).collect()
    }

    /// Whether enough smaller steps agree as well.
    fn is_confirmed(&self) -> bool {
        self.trials.iter().rev().take_while(|trial| trial.fault.is_none()).count() > CONFIRMED
    }
}

/// Steps of 1, 2 and 5 times a power of ten, from large to small.
fn steps(until: f64) -> Vec<f64> {
    let (longest, shortest) = (LONGEST * until, SHORTEST.max(until / MOST_STEPS));
    let mut steps = Vec::new();
    for power in (-6..=9).rev() {
        for digit in ["5", "2", "1"] {
            steps.extend(format!("{digit}e{power}").parse::<f64>());
        }
    }
    // A tenth of the last digit: until / 50 may be the step itself.
    steps.retain(|step| (shortest * (1.0 - 1e-9)..=longest * (1.0 + 1e-9)).contains(step));
    steps
}

/// Solves a system and searches, for each order of exchange, for the largest step of 1, 2 or 5 times a power of ten
/// with which a master comes close to the solution in all quantities: times of slip and rest through the whole motion,
/// largest and smallest forces, velocities and positions, velocity at rest. Steps are tried from large to small until
/// three smaller ones in turn agree as well, since an agreement of one step may be chance.
pub fn communication_steps(
    system: &System,
    settings: &Settings,
    results: &[String],
    search: &Search,
) -> Result<CommunicationSteps, Fault> {
    let compared = Compared::of(system, results)?;
    let finer = FINER * settings.every;
    let every = if settings.until / finer <= MOST_RESULTS { finer } else { settings.every };
    let settings = Settings { every, is_checked: false, ..*settings };
    let steps = steps(settings.until);
    if steps.is_empty() {
        let text = format_args!("until = {} s: too short or too long to search for a step", settings.until);
        return Err(Fault::value(text));
    }
    let share = settings.progress.map(|whole| Share { whole, begin: 0.0, part: SOLUTION });
    let progress = share.as_ref().map(|share| share as &dyn Progress);
    let solution = run(system, &Settings { solver: Solver::Auto, progress, ..settings }, &compared.results)?;
    let mut found = CommunicationSteps {
        law: system.law.map(|law| law.name),
        within: search.within,
        solver: solution.solver.to_string(),
        tolerance: settings.tolerance,
        end: solution.end.clone(),
        orders: Vec::new(),
    };
    let mut seeker = Seeker { system, settings, compared, solution, within: search.within, begin: 0.0 };
    for (number, exchange) in search.exchanges.iter().enumerate() {
        if !found.end.is_reached() {
            break;
        }
        let part = (1.0 - SOLUTION) / search.exchanges.len() as f64;
        seeker.begin = SOLUTION + number as f64 * part;
        let (order, end) = seeker.order(*exchange, &steps, part)?;
        found.orders.push(order);
        found.end = end;
    }
    Ok(found)
}

struct Seeker<'a> {
    system: &'a System,
    settings: Settings<'a>,
    compared: Compared,
    solution: Outcome,
    within: f64,
    /// Part of the search that is done.
    begin: f64,
}

impl Seeker<'_> {
    /// Tries the steps in an order of exchange, which is this part of the search.
    fn order(&mut self, exchange: Exchange, steps: &[f64], part: f64) -> Result<(Order, End), Fault> {
        let mut order = Order { exchange, step: None, trials: Vec::new() };
        let all: f64 = steps.iter().map(|step| step.recip()).sum();
        for step in steps {
            let share = part / step / all;
            let (trial, end) = self.trial(Master { step: *step, exchange, ..self.settings.master }, share)?;
            if matches!(end, End::Cancelled { .. }) {
                return Ok((order, end));
            }
            self.begin += share;
            order.trials.push(trial);
            if order.is_confirmed() {
                break;
            }
        }
        let confirmed = order.trials.iter().rev().take_while(|trial| trial.fault.is_none());
        order.step = confirmed.last().map(|trial| trial.step);
        Ok((order, End::Reached))
    }

    fn trial(&self, master: Master, share: f64) -> Result<(Trial, End), Fault> {
        let (until, begin) = (self.settings.until, self.begin * self.settings.until);
        let progress = self.settings.progress.map(|whole| Share { whole, begin, part: share });
        let progress = progress.as_ref().map(|share| share as &dyn Progress);
        let settings = Settings { solver: Solver::CoSimulation, master, progress, until, ..self.settings };
        let motion = run(self.system, &settings, &self.compared.results)?;
        let mut trial = Trial { step: master.step, deviations: Vec::new(), fault: None };
        if motion.is_reached() {
            trial.deviations = self.compared.deviations(&motion, &self.solution, self.within);
            trial.fault = self.fault(&trial.deviations);
        } else {
            trial.fault = Some(motion.end.to_string());
        }
        Ok((trial, motion.end))
    }

    /// The first quantity that is off by more than may be: numbers and times stand before forces.
    fn fault(&self, deviations: &[Deviation]) -> Option<String> {
        // What is not a number is off as well.
        let is_off = |one: &&Deviation| one.part.is_nan() || one.part > self.within;
        deviations.iter().find(is_off).map(Deviation::sentence)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::super::Configuration;
    use super::super::progress::Heard;
    use super::*;
    use crate::stick_slip::StickSlip;
    use crate::system::Source;

    fn belt(law: &str) -> System {
        System::assemble(&Source::open("belt").unwrap(), Some(law), &[]).unwrap()
    }

    fn found(system: &System, exchange: &str) -> CommunicationSteps {
        let text = format!("solver = \"co-simulation\"\nstep = \"find\"\nexchange = \"{exchange}\"");
        let run: Configuration = toml::from_str(&text).unwrap();
        let (settings, search) = run.search(system).unwrap();
        communication_steps(system, &settings, &["rig.position".to_owned()], &search).unwrap()
    }

    /// Times of the maxima of the position of the block, by parabolas; of each excursion above 0.5 m the first one.
    fn maxima(master: Master, system: &System) -> Vec<f64> {
        let settings = Settings { solver: Solver::CoSimulation, master, every: master.step, ..Settings::of(system) };
        let outcome = run(system, &settings, &["rig.position".to_owned()]).unwrap();
        let (mut maxima, mut is_new) = (Vec::new(), true);
        for (time, x) in outcome.time.windows(3).zip(outcome.values("rig.position").unwrap().windows(3)) {
            if is_new && x[0] > 0.5 && x[1] >= x[0] && x[1] > x[2] {
                maxima.push(time[1] + 0.5 * (x[0] - x[2]) / (x[0] - 2.0 * x[1] + x[2]) * (time[2] - time[1]));
                is_new = false;
            }
            is_new |= x[1] < 0.5;
        }
        maxima
    }

    /// Largest part by which the first maximum and the intervals between the maxima are off from the closed form: the
    /// block slides along centre + D cos(w t) + (v_b / w) sin(w t).
    fn error(master: Master, system: &System) -> f64 {
        let exact = StickSlip::table_6_1();
        let (excess, belt) = (0.5 * 0.05 * 9.81, 0.1);
        let first = exact.first_slip + (belt / exact.w / excess).atan() / exact.w;
        let maxima = maxima(master, system);
        let periods = maxima.windows(2).map(|pair| (pair[1] - pair[0]) / exact.period - 1.0);
        std::iter::once(maxima[0] / first - 1.0).chain(periods).map(f64::abs).fold(0.0, f64::max)
    }

    #[test]
    fn the_step_that_is_found_is_right_and_the_next_one_is_not() {
        let system = belt("CoulombStiction");
        let found = found(&system, "parallel");
        let order = &found.orders[0];
        let (step, limit) = (order.step.unwrap(), order.limit().unwrap());
        let at = |step| error(Master { step, exchange: Exchange::Parallel, jitter: 0.0 }, &system);
        assert!(at(step) < 0.01 && at(limit.step) > 0.01, "{} {} {order:?}", at(step), at(limit.step));
        assert!(limit.step <= 2.51 * step && order.found().unwrap().fault.is_none());
        let period = order.found().unwrap().deviations.iter().find(|one| one.name == "period of friction").unwrap();
        assert!((period.solution - StickSlip::table_6_1().period).abs() < 1e-3, "{period:?}");
        assert_eq!((found.solver.as_str(), found.end.is_reached()), ("rodas5p", true));
    }

    /// Where both parts step at once, bristles with this damping hold 1 kg below 1.6 ms (docs/fmu.md).
    #[test]
    fn bristles_limit_the_step() {
        assert_eq!(found(&belt("LuGre"), "parallel").orders[0].step, Some(1e-3));
    }

    #[test]
    fn steps_that_agree_by_chance_do_not_count() {
        let trial = |(step, holds): (f64, bool)| {
            let fault = (!holds).then(|| "is off".to_owned());
            Trial { step, deviations: Vec::new(), fault }
        };
        let order = |trials: &[(f64, bool)], step| Order {
            exchange: Exchange::Parallel,
            step,
            trials: trials.iter().copied().map(trial).collect(),
        };
        let some =
            order(&[(5e-3, true), (2e-3, false), (1e-3, true), (5e-4, true), (2e-4, true), (1e-4, true)], Some(1e-3));
        assert_eq!((some.by_chance(), some.limit().unwrap().step), (vec![5e-3], 2e-3));
        assert!(some.is_confirmed() && !order(&[(1e-3, true), (5e-4, true), (2e-4, true)], None).is_confirmed());
        let none = order(&[(2e-3, true), (1e-3, false)], None);
        assert_eq!((none.found().is_none(), none.by_chance(), none.limit().unwrap().step), (true, vec![2e-3], 1e-3));
        let tried = steps(40.0);
        assert_eq!((tried.len(), tried[0], tried[1], tried[tried.len() - 1]), (15, 0.5, 0.2, 1e-5));
    }

    #[test]
    fn a_search_tells_its_progress_and_can_be_ended() {
        let (system, heard, cancel) = (belt("CoulombStiction"), Heard::default(), AtomicBool::new(true));
        let search = Search { within: 0.01, exchanges: vec![Exchange::Sequential, Exchange::Parallel] };
        let settings = Settings { progress: Some(&heard), ..Settings::of(&system) };
        communication_steps(&system, &settings, &[], &search).unwrap();
        let times = heard.0.into_inner().unwrap();
        assert!(times.is_sorted() && times.iter().all(|time| *time <= 40.0) && times.iter().any(|time| *time > 22.0));
        let settings = Settings { cancel: Some(&cancel), ..Settings::of(&system) };
        let ended = communication_steps(&system, &settings, &[], &search).unwrap();
        assert!(matches!(ended.end, End::Cancelled { .. }) && ended.orders.is_empty());
    }

    #[test]
    fn without_a_solution_there_is_no_step() {
        let source = Source::open("belt").unwrap();
        let printed = ["variant=Printed".parse().unwrap()];
        let system = System::assemble(&source, Some("RooneyDeravi"), &printed).unwrap();
        let found = found(&system, "sequential");
        assert!(found.end.to_string().contains("chatters") && found.orders.is_empty());
    }
}
