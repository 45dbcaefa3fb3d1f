//! The methods of this library.

use super::piecewise::Piecewise;
use super::rodas5p::Rodas5P;
use super::rosenbrock23::Rosenbrock23;
use super::snapping::Snapping;
use super::{End, Equations, Options, Recorder, Statistics, Track, march};

/// A one-step method with exact Jacobian, dense output and located events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Rosenbrock method of order 5 (Rodas5P); exact steps where the equations are linear.
    Rodas5P,
    /// Modified Rosenbrock method of orders 2 and 3.
    Rosenbrock23,
}

/// Runs a method with as many states as the equations have, or the next larger number that has code of its own; the
/// workspace is on the stack, and the loops over few states are unrolled.
macro_rules! run_in {
    ($equations:ident, $states:ident, $options:ident, $recorder:ident: $($n:literal => $Step:ty,)+) => {
        match $states.len() {
            $($n => march::run::<$Step, $n>($equations, $states, $options, $recorder),)+
            $(count if count < $n => {
                march::run::<$Step, $n>(&mut Padded::new($equations, $n), $states, $options, $recorder)
            })+
            count => {
                let most = [$($n),+].into_iter().max().unwrap_or_default();
                let reason = format!("{count} states; the limit is {most}");
                (End::Failed { time: $options.begin, reason }, Statistics::default())
            }
        }
    };
}

impl Method {
    /// Runs the method, or steps in which bonds snap if the equations have some.
    pub(super) fn run(
        self,
        equations: &mut dyn Equations,
        states: &mut [f64],
        options: &Options,
        recorder: &mut Recorder,
    ) -> (End, Statistics) {
        if !equations.tracks().is_empty() {
            return run_in! { equations, states, options, recorder:
                1 => Snapping<1>,
                2 => Snapping<2>,
                3 => Snapping<3>,
                4 => Snapping<4>,
                6 => Snapping<6>,
                16 => Snapping<16>,
                72 => Snapping<72>,
            };
        }
        match self {
            Method::Rodas5P => run_in! { equations, states, options, recorder:
                1 => Piecewise<Rodas5P<1>, 1>,
                2 => Piecewise<Rodas5P<2>, 2>,
                3 => Piecewise<Rodas5P<3>, 3>,
                4 => Piecewise<Rodas5P<4>, 4>,
                6 => Piecewise<Rodas5P<6>, 6>,
                8 => Rodas5P<8>,
                16 => Rodas5P<16>,
                72 => Rodas5P<72>,
            },
            Method::Rosenbrock23 => run_in! { equations, states, options, recorder:
                4 => Rosenbrock23<4>,
                16 => Rosenbrock23<16>,
                72 => Rosenbrock23<72>,
            },
        }
    }
}

/// Equations with further states that rest at 0, so that not every number of states needs code of its own.
struct Padded<'a> {
    inner: &'a mut dyn Equations,
    scales: Vec<f64>,
    jacobian: Vec<f64>,
}

impl<'a> Padded<'a> {
    fn new(inner: &'a mut dyn Equations, size: usize) -> Padded<'a> {
        let count = inner.states();
        let mut scales = inner.scales().to_vec();
        scales.resize(size, 1.0);
        Padded { inner, scales, jacobian: vec![0.0; count * count] }
    }

    /// Writes the Jacobian of the states that do not rest.
    fn pad(&self, jacobian: &mut [f64], size: usize) {
        jacobian.fill(0.0);
        let rows = self.jacobian.chunks(self.inner.states().max(1));
        for (to, from) in jacobian.chunks_mut(size).zip(rows) {
            to[..from.len()].copy_from_slice(from);
        }
    }
}

impl Equations for Padded<'_> {
    fn states(&self) -> usize {
        self.inner.states()
    }

    fn state_name(&self, state: usize) -> String {
        self.inner.state_name(state)
    }

    fn scales(&self) -> &[f64] {
        &self.scales
    }

    fn rates(&mut self, time: f64, states: &[f64], rates: &mut [f64]) {
        let count = self.inner.states();
        self.inner.rates(time, &states[..count], &mut rates[..count]);
        rates[count..].fill(0.0);
    }

    fn jacobian(&mut self, time: f64, states: &[f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        let (count, size) = (self.inner.states(), states.len());
        self.inner.jacobian(time, &states[..count], &mut self.jacobian, &mut by_time[..count]);
        by_time[count..].fill(0.0);
        self.pad(jacobian, size);
    }

    fn linearise(&mut self, time: f64, states: &[f64], rates: &mut [f64], jacobian: &mut [f64], by_time: &mut [f64]) {
        let (count, size) = (self.inner.states(), states.len());
        let (rates_of_inner, jacobian_of_inner) = (&mut rates[..count], &mut self.jacobian);
        self.inner.linearise(time, &states[..count], rates_of_inner, jacobian_of_inner, &mut by_time[..count]);
        rates[count..].fill(0.0);
        by_time[count..].fill(0.0);
        self.pad(jacobian, size);
    }

    fn indicators(&self) -> usize {
        self.inner.indicators()
    }

    fn indicator_name(&self, indicator: usize) -> String {
        self.inner.indicator_name(indicator)
    }

    fn indicate(&mut self, time: f64, states: &[f64], indicators: &mut [f64]) {
        let count = self.inner.states();
        self.inner.indicate(time, &states[..count], indicators);
    }

    fn at_event(&mut self, time: f64, states: &mut [f64]) -> Result<(), String> {
        let count = self.inner.states();
        self.inner.at_event(time, &mut states[..count])
    }

    fn is_piecewise_linear(&self) -> bool {
        self.inner.is_piecewise_linear()
    }

    fn next_break(&self, time: f64) -> f64 {
        self.inner.next_break(time)
    }

    fn accept(&mut self, begin: f64, end: f64, states_at: &dyn Fn(f64, &mut [f64])) {
        self.inner.accept(begin, end, states_at);
    }

    fn is_due(&self, time: f64) -> bool {
        self.inner.is_due(time)
    }

    fn tracks(&mut self) -> &mut [Track] {
        self.inner.tracks()
    }

    fn renew_tracks(&mut self) {
        self.inner.renew_tracks();
    }

    fn recorded(&self) -> usize {
        self.inner.recorded()
    }

    fn record(&mut self, time: f64, states: &[f64], values: &mut [f64]) -> Result<(), String> {
        let count = self.inner.states();
        self.inner.record(time, &states[..count], values)
    }
}
