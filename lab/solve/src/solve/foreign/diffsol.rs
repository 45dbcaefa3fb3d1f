//! The implicit methods of the crate diffsol.

use std::cell::RefCell;

use ::diffsol::error::OdeSolverError;
use ::diffsol::{
    ConstantOp, DiffsolError, Matrix as _, NalgebraContext, NalgebraLU, NalgebraMat, NalgebraVec, NonLinearOp,
    NonLinearOpJacobian, OdeBuilder, OdeEquations, OdeEquationsRef, OdeSolverMethod, OdeSolverProblem,
    OdeSolverStopReason, Op, UnitCallable, Vector as _, VectorCommon as _,
};

use super::bridge::Bridge;
use super::{Foreign, Run, Stop};

type Matrix = NalgebraMat<f64>;
type Vector = NalgebraVec<f64>;
type Lu = NalgebraLU<f64>;

/// Solves for one piece: the equations from one event or break to the next.
struct Piece<'p, 'e> {
    bridge: &'p Bridge<'e>,
    start: &'p [f64],
    indicators: usize,
    /// Indicators that have been exactly zero from the beginning of the piece, and so have no sign to change.
    signless: &'p RefCell<Vec<bool>>,
    context: NalgebraContext,
}

/// The indicators of a piece.
struct Roots<'r, 'p, 'e>(&'r Piece<'p, 'e>);

/// The states at the beginning of a piece.
struct Start<'r, 'p, 'e>(&'r Piece<'p, 'e>);

macro_rules! op {
    ($Type:ty, $self:ident, $piece:expr, $outputs:expr) => {
        impl Op for $Type {
            type T = f64;
            type V = Vector;
            type M = Matrix;
            type C = NalgebraContext;

            fn context(&self) -> &NalgebraContext {
                let $self = self;
                &$piece.context
            }

            fn nstates(&self) -> usize {
                let $self = self;
                $piece.start.len()
            }

            fn nout(&self) -> usize {
                let $self = self;
                $outputs
            }

            fn nparams(&self) -> usize {
                0
            }
        }
    };
}

op!(Piece<'_, '_>, piece, piece, piece.start.len());
op!(Roots<'_, '_, '_>, roots, roots.0, roots.0.indicators);
op!(Start<'_, '_, '_>, start, start.0, start.0.start.len());

impl NonLinearOp for Piece<'_, '_> {
    fn call_inplace(&self, x: &Vector, t: f64, y: &mut Vector) {
        y.for_each_batch_host([x], |rates, [states], _| self.bridge.rates(t, states, rates));
    }
}

impl NonLinearOpJacobian for Piece<'_, '_> {
    fn jac_mul_inplace(&self, x: &Vector, t: f64, v: &Vector, y: &mut Vector) {
        let count = self.start.len();
        let mut jacobian = vec![0.0; count * count];
        y.for_each_batch_host([x, v], |product, [states, v], _| {
            self.bridge.jacobian(t, states, &mut jacobian);
            for (product, row) in product.iter_mut().zip(jacobian.chunks(count)) {
                *product = row.iter().zip(v).map(|(slope, v)| slope * v).sum();
            }
        });
    }

    fn jacobian_inplace(&self, x: &Vector, t: f64, y: &mut Matrix) {
        let count = self.start.len();
        let mut jacobian = vec![0.0; count * count];
        let mut column = Vector::zeros(count, self.context);
        column.for_each_batch_host([x], |_, [states], _| self.bridge.jacobian(t, states, &mut jacobian));
        for number in 0..count {
            for row in 0..count {
                column[row] = jacobian[row * count + number];
            }
            y.set_column(number, &column);
        }
    }
}

impl NonLinearOp for Roots<'_, '_, '_> {
    fn call_inplace(&self, x: &Vector, t: f64, y: &mut Vector) {
        let Piece { bridge, signless, .. } = self.0;
        y.for_each_batch_host([x], |indicators, [states], _| {
            bridge.with(|equations| equations.indicate(t, states, indicators));
            for (indicator, is_signless) in indicators.iter_mut().zip(&*signless.borrow()) {
                // The crate takes every zero for a root, but NaN for none.
                if *is_signless && *indicator == 0.0 {
                    *indicator = f64::NAN;
                }
            }
        });
    }
}

impl ConstantOp for Start<'_, '_, '_> {
    fn call_inplace(&self, _t: f64, y: &mut Vector) {
        y.for_each_batch_host([], |states, [], _| states.copy_from_slice(self.0.start));
    }
}

impl<'r, 'p, 'e> OdeEquationsRef<'r> for Piece<'p, 'e> {
    type Mass = UnitCallable<Matrix>;
    type Rhs = &'r Self;
    type Root = Roots<'r, 'p, 'e>;
    type Init = Start<'r, 'p, 'e>;
    type Out = UnitCallable<Matrix>;
    type Reset = UnitCallable<Matrix>;
}

impl<'p, 'e> OdeEquations for Piece<'p, 'e> {
    fn rhs(&self) -> &Self {
        self
    }

    fn mass(&self) -> Option<UnitCallable<Matrix>> {
        None
    }

    fn root(&self) -> Option<Roots<'_, 'p, 'e>> {
        (self.indicators > 0).then_some(Roots(self))
    }

    fn init(&self) -> Start<'_, 'p, 'e> {
        Start(self)
    }

    fn set_params(&mut self, _p: &Vector) {}

    fn get_params(&self, _p: &mut Vector) {}
}

/// Runs to the wall, or to an event before it.
pub(super) fn piece(run: &mut Run, kind: Foreign, wall: f64) -> Result<Stop, String> {
    let start = run.states.clone();
    let indicators = if run.has_events() { run.bridge.with(|equations| equations.indicators()) } else { 0 };
    let mut values = vec![0.0; indicators];
    if indicators > 0 {
        run.bridge.with(|equations| equations.indicate(run.time, &start, &mut values));
    }
    let signless = RefCell::new(values.iter().map(|value| *value == 0.0).collect());
    let piece =
        Piece { bridge: run.bridge, start: &start, indicators, signless: &signless, context: Default::default() };
    let problem = problem(run, piece).map_err(in_words)?;
    match kind {
        Foreign::TrBdf2 => March::new(problem.tr_bdf2::<Lu>().map_err(in_words)?, run, wall).go(),
        Foreign::Esdirk34 => March::new(problem.esdirk34::<Lu>().map_err(in_words)?, run, wall).go(),
        _ => March::new(problem.bdf::<Lu>().map_err(in_words)?, run, wall).go(),
    }
}

fn problem<'p, 'e>(run: &Run, piece: Piece<'p, 'e>) -> Result<OdeSolverProblem<Piece<'p, 'e>>, DiffsolError> {
    let absolute = run.scales.iter().map(|scale| run.options.absolute * scale);
    let builder = OdeBuilder::<Matrix>::new().t0(run.time).rtol(run.options.relative).atol(absolute);
    let mut problem = builder.build_from_eqn(piece)?;
    // The limit is on the sum over all steps: by default a long run of stick-slip comes to it.
    problem.ode_options.max_nonlinear_solver_failures = usize::MAX;
    Ok(problem)
}

/// The steps of a piece.
struct March<'m, 'r, 'e, S> {
    solver: S,
    run: &'m mut Run<'r, 'e>,
    wall: f64,
    /// Time that the crate knows as the one to stop at.
    until: Option<f64>,
    /// Steps rejected before the piece.
    rejected: u64,
    states: Vector,
}

impl<'m, 'r, 'e, 's, 'p: 's, S> March<'m, 'r, 'e, S>
where
    'e: 'p,
    S: OdeSolverMethod<'s, Piece<'p, 'e>>,
{
    fn new(solver: S, run: &'m mut Run<'r, 'e>, wall: f64) -> Self {
        let states = Vector::zeros(run.states.len(), NalgebraContext::default());
        let rejected = run.statistics.rejected;
        March { solver, run, wall, until: None, rejected, states }
    }

    fn go(&mut self) -> Result<Stop, String> {
        loop {
            if self.run.options.is_cancelled() {
                return Ok(Stop::Cancelled);
            }
            if self.run.steps_left() == 0 {
                return Err(self.run.too_many_steps());
            }
            if !self.aim()? {
                return Ok(Stop::Wall);
            }
            match self.step()? {
                OdeSolverStopReason::RootFound(_, indicator) => return Ok(Stop::Event(indicator)),
                OdeSolverStopReason::TstopReached if self.until == Some(self.wall) => return Ok(Stop::Wall),
                // The crate forgets a time that it has reached.
                OdeSolverStopReason::TstopReached => self.until = None,
                OdeSolverStopReason::InternalTimestep => {}
            }
            self.give_signs();
        }
    }

    /// Limits the next step. False if nothing is left of the piece but rounding.
    fn aim(&mut self) -> Result<bool, String> {
        let until = self.wall.min(self.run.time + self.run.options.longest);
        if self.until == Some(until) {
            return Ok(true);
        }
        self.until = Some(until);
        match self.solver.set_stop_time(until) {
            Ok(()) => Ok(true),
            Err(DiffsolError::OdeSolverError(OdeSolverError::StopTimeAtCurrentTime)) if until == self.wall => Ok(false),
            Err(error) => Err(in_words(error)),
        }
    }

    /// Makes a step and goes to its end, or to the event within it.
    fn step(&mut self) -> Result<OdeSolverStopReason<f64>, String> {
        let made = self.solver.step();
        let failures = self.solver.get_statistics();
        let failures = failures.number_of_error_test_failures + failures.number_of_nonlinear_solver_fails;
        self.run.statistics.rejected = self.rejected + failures as u64;
        let made = made.map_err(in_words)?;
        self.run.statistics.steps += 1;
        let end = if let OdeSolverStopReason::RootFound(time, _) = made { time } else { self.solver.state().t };
        while let Some(time) = self.run.recorder.next().filter(|time| *time <= end) {
            self.solver.interpolate_inplace(time, &mut self.states).map_err(in_words)?;
            let states = self.states.inner().as_slice();
            self.run.bridge.with(|equations| self.run.recorder.point(equations, states))?;
        }
        if let OdeSolverStopReason::RootFound(time, _) = made {
            self.solver.state_mut_back(time).map_err(in_words)?;
        }
        self.run.arrive(end, self.solver.state().y.inner().as_slice())?;
        Ok(made)
    }

    /// Notes which indicators are no longer zero.
    fn give_signs(&mut self) {
        let signless = self.solver.problem().eqn.signless;
        if signless.borrow().contains(&true) {
            let mut values = vec![0.0; signless.borrow().len()];
            let Run { bridge, time, states, .. } = &*self.run;
            bridge.with(|equations| equations.indicate(*time, states, &mut values));
            for (is_signless, value) in signless.borrow_mut().iter_mut().zip(&values) {
                *is_signless &= *value == 0.0;
            }
        }
    }
}

/// Why the crate gave up.
fn in_words(error: DiffsolError) -> String {
    match error {
        DiffsolError::OdeSolverError(OdeSolverError::StepSizeTooSmall { .. }) => {
            "diffsol's step has become too short".to_owned()
        }
        DiffsolError::OdeSolverError(OdeSolverError::TooManyErrorTestFailures { num_failures, .. }) => {
            format!("{num_failures} steps of diffsol one after the other had too large an error")
        }
        other => format!("diffsol: {other}"),
    }
}
