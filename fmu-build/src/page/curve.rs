//! Curves for the page and the icon of a model, computed with the model itself.
//!
//! The ranges follow from the model's behaviour, not from its name or its parameters: that of velocity from the bends
//! of the force over velocity, that of displacement from the bends of the force over displacement.

use std::f64::consts::TAU;

use anyhow::{Context, Result};
use stribeck::instance::Instance;
use stribeck::model::{Meaning, ModelType, Preset};

/// Number of velocities on each side of a curve.
const POINTS: i32 = 300;

/// Points of a curve, in SI units.
pub type Curve = Vec<[f64; 2]>;

/// A friction law, observed along one direction.
pub struct Law {
    /// The model.
    pub model: &'static ModelType,
    preset: Option<&'static Preset>,
    /// Column of the velocity.
    pub velocity: usize,
    /// Column of the friction force.
    pub force: usize,
    external_force: Option<usize>,
    acceleration: Option<usize>,
}

/// A running instance of a law.
struct Run<'a> {
    law: &'a Law,
    instance: Instance,
}

/// The force at held velocities.
pub struct Steady {
    /// Forces while the speed grows from one held value to the next.
    pub growing: Curve,
    /// Forces while it falls.
    pub fading: Curve,
    /// Uncertainty of a force that fluctuates.
    pub noise: f64,
}

/// The settled force at a held velocity.
struct Settled {
    force: f64,
    /// Standard error, if the force keeps fluctuating and this is its mean.
    noise: f64,
}

impl Law {
    /// The law of a model; along x if it has several directions.
    pub fn new(model: &'static ModelType, preset: Option<&'static Preset>) -> Result<Law> {
        let known = |meaning| model.table.of(meaning).with_context(|| format!("{} has no {meaning:?}", model.name));
        let (velocity, force) = (known(Meaning::Velocity)?, known(Meaning::FrictionForce)?);
        Ok(Law {
            model,
            preset,
            velocity,
            force,
            external_force: model.table.of(Meaning::ExternalForce),
            acceleration: model.table.of(Meaning::Acceleration),
        })
    }

    fn run(&self, external_force: f64) -> Result<Run<'_>> {
        let mut instance = Instance::new(self.model);
        if let Some(preset) = self.preset {
            instance.apply(preset.name);
        }
        if let Some(column) = self.external_force {
            instance.set_column(column, external_force)?;
        }
        Ok(Run { law: self, instance })
    }

    /// The column of an input and its value while the law is observed.
    pub fn held(&self, name: &str) -> Option<(usize, f64)> {
        let column = self.model.find(name)?;
        let preset = self.preset.and_then(|preset| preset.values.iter().find(|(known, _)| *known == name));
        Some((column, preset.map_or(self.model.table.at(column).start, |(_, value)| *value)))
    }

    /// Whether it has an acceleration as input, because speeding up differs from slowing down.
    pub fn has_acceleration(&self) -> bool {
        self.acceleration.is_some()
    }

    /// Whether an external force determines the force at rest.
    pub fn has_external_force(&self) -> bool {
        self.external_force.is_some()
    }

    /// A round velocity that includes all features of the curve.
    pub fn velocity_range(&self) -> Result<f64> {
        let mut run = self.run(0.0)?;
        let points = (0..=50).map(|k| 1e-5 * 10f64.powf(f64::from(k) / 10.0));
        let settled = points.map(|v| Ok((v, run.settle(v)?))).collect::<Result<Vec<_>>>()?;
        let noise = settled.iter().map(|(_, settled)| settled.noise).fold(0.0, f64::max);
        let curve: Curve = settled.into_iter().map(|(v, settled)| [v, settled.force]).collect();
        Ok(round_up(last_bend(&curve, noise).map_or_else(|| velocity_without_bend(&curve, noise), |bend| 1.5 * bend)))
    }

    /// The settled force over velocities from -`range` to `range`, which are closer together near 0.
    pub fn steady(&self, range: f64, external_force: f64) -> Result<Steady> {
        let [backwards, forwards] = [self.branches(-range, external_force)?, self.branches(range, external_force)?];
        let joined = |backwards: &Curve, forwards: &Curve| backwards.iter().rev().chain(forwards).copied().collect();
        Ok(Steady {
            growing: joined(&backwards.growing, &forwards.growing),
            fading: joined(&backwards.fading, &forwards.fading),
            noise: backwards.noise.max(forwards.noise),
        })
    }

    /// As [`Law::steady`], from 0 to `range`.
    fn branches(&self, range: f64, external_force: f64) -> Result<Steady> {
        let mut run = self.run(external_force)?;
        // At rest only an external force determines the friction force.
        let first = i32::from(!self.has_external_force());
        let mut noise = 0f64;
        let mut settled = |k: i32| {
            let velocity = range * (f64::from(k) / f64::from(POINTS)).powf(1.5);
            let settled = run.settle(velocity)?;
            noise = noise.max(settled.noise);
            Ok([velocity, settled.force])
        };
        let growing = (first..=POINTS).map(&mut settled).collect::<Result<Curve>>()?;
        let mut fading = (first..=POINTS).rev().map(settled).collect::<Result<Curve>>()?;
        fading.reverse();
        Ok(Steady { growing, fading, noise })
    }

    /// The settling time of the force after the velocity has changed from -`velocity` / 4 to `velocity`; 0 for a law
    /// without memory.
    pub fn response_time(&self, velocity: f64) -> Result<f64> {
        let mut run = self.run(0.0)?;
        run.settle(-0.25 * velocity)?;
        let history = run.history(velocity)?;
        let last = history.last().map_or(0.0, |point| point[1]);
        let is_off = |share: f64| move |point: &[f64; 2]| (point[1] - last).abs() > share * last.abs();
        let at = if is_settled(&history) {
            history.iter().rposition(is_off(0.03))
        } else {
            // It keeps fluctuating: the first time that it comes near.
            let is_near = |point: &[f64; 2]| !is_off(0.15)(point);
            history.iter().position(is_near).and_then(|at| at.checked_sub(1))
        };
        Ok(at.map_or(0.0, |at| history[at][0]))
    }

    /// The second period of an oscillating velocity.
    pub fn oscillation(&self, amplitude: f64, period: f64) -> Result<Curve> {
        const STEPS: usize = 2000;
        let mut run = self.run(0.0)?;
        let mut curve = Vec::new();
        for step in 0..=2 * STEPS {
            let (sine, cosine) = (TAU * step as f64 / STEPS as f64).sin_cos();
            run.accelerate(amplitude * TAU / period * cosine)?;
            let force = run.at(amplitude * sine)?;
            if step >= STEPS {
                curve.push([amplitude * sine, force]);
            }
            run.step(period / STEPS as f64)?;
        }
        Ok(curve)
    }

    /// The displacement at which a contact that was at rest begins to slide; `None` for a law whose force does not
    /// depend on displacement. `range` is that of the velocities.
    pub fn displacement_scale(&self, range: f64) -> Result<Option<f64>> {
        let slow = range / 200.0;
        let Some((scale, level)) = self.yielding(slow)? else { return Ok(None) };
        // A law that depends on time, not on displacement, yields earlier if it moves more slowly.
        let Some((slower, _)) = self.yielding(slow / 4.0)? else { return Ok(None) };
        if (slower / scale).ln().abs() > 2f64.ln() {
            return Ok(None);
        }
        // A spring keeps its deflection when the motion reverses.
        let mut run = self.run(0.0)?;
        run.travel(4.0 * scale, slow, 40)?;
        run.travel(-0.05 * scale, slow, 1)?;
        Ok((run.force() > 0.3 * level).then_some(scale))
    }

    /// Displacement and force at which 63 % of the largest force is reached, if it is reached gradually.
    fn yielding(&self, velocity: f64) -> Result<Option<(f64, f64)>> {
        let mut run = self.run(0.0)?;
        let (mut x, mut curve) = (0.0, Vec::new());
        for k in 0..=64 {
            let next = 1e-10 * 10f64.powf(f64::from(k) / 8.0);
            run.travel(next - x, velocity, 1)?;
            x = next;
            curve.push([x, run.force()]);
        }
        let level = curve.iter().map(|point| point[1]).fold(0.0, f64::max);
        let Some(at) = curve.iter().position(|point| point[1] >= 0.63 * level) else { return Ok(None) };
        // A tenth of the displacement, eight points earlier.
        let is_gradual = at >= 8 && level > 0.0 && curve[at - 8][1] < 0.5 * level;
        Ok(is_gradual.then_some((curve[at][0], level)))
    }

    /// Force over displacement for growing strokes, each to both sides.
    pub fn strokes(&self, scale: f64, range: f64) -> Result<Curve> {
        let mut run = self.run(0.0)?;
        let mut curve = vec![[0.0, run.at(0.0)?]];
        let mut x = 0.0;
        for target in [0.6, -0.6, 1.6, -1.6, 4.0, -4.0, 4.0].map(|factor| factor * scale) {
            let steps = 150;
            let (begin, distance) = (x, target - x);
            for step in 1..=steps {
                let next = begin + distance * f64::from(step) / f64::from(steps);
                run.travel(next - x, range / 200.0, 1)?;
                x = next;
                curve.push([x, run.force()]);
            }
        }
        Ok(curve)
    }
}

impl Run<'_> {
    fn at(&mut self, velocity: f64) -> Result<f64> {
        self.instance.set_column(self.law.velocity, velocity)?;
        self.instance.refresh()?;
        Ok(self.force())
    }

    fn accelerate(&mut self, acceleration: f64) -> Result<()> {
        match self.law.acceleration {
            Some(column) => Ok(self.instance.set_column(column, acceleration)?),
            None => Ok(()),
        }
    }

    /// The force after the last step.
    fn force(&self) -> f64 {
        self.instance.row()[self.law.force]
    }

    fn step(&mut self, dt: f64) -> Result<()> {
        self.instance.step(dt)?;
        Ok(())
    }

    /// Moves by a distance at the given speed.
    fn travel(&mut self, distance: f64, speed: f64, steps: u32) -> Result<()> {
        let duration = distance.abs() / speed;
        self.at(speed * distance.signum())?;
        // No step is longer than a second.
        let steps = steps.max(duration.ceil().min(100.0) as u32);
        for _ in 0..steps {
            self.step(duration / f64::from(steps))?;
        }
        Ok(())
    }

    /// The force at a held velocity, over time.
    fn history(&mut self, velocity: f64) -> Result<Curve> {
        const LONGEST: usize = 120;
        // Not too far per step: some laws follow every asperity.
        let longest = (1e-3 / velocity.abs()).clamp(1e-3, 100.0);
        let mut history = Vec::new();
        let (mut time, mut dt) = (0.0, 1e-4);
        self.at(velocity)?;
        while history.len() < LONGEST && (time < 1.0 || !is_settled(&history)) {
            self.step(dt)?;
            time += dt;
            history.push([time, self.force()]);
            dt = f64::min(longest, 1.5 * dt);
        }
        Ok(history)
    }

    /// The settled force at a held velocity; the mean of a force that keeps fluctuating.
    fn settle(&mut self, velocity: f64) -> Result<Settled> {
        let history = self.history(velocity)?;
        match history.last() {
            Some([_, force]) if is_settled(&history) => Ok(Settled { force: *force, noise: 0.0 }),
            _ => Ok(mean(&history[history.len() / 2..])),
        }
    }
}

fn mean(history: &[[f64; 2]]) -> Settled {
    let count = history.len().max(1) as f64;
    let force = history.iter().map(|point| point[1]).sum::<f64>() / count;
    let variance = history.iter().map(|point| (point[1] - force).powi(2)).sum::<f64>() / count;
    Settled { force, noise: (variance / count).sqrt() }
}

/// Settles when four values are equal, each after a step half as long again as the one before.
fn is_settled(history: &[[f64; 2]]) -> bool {
    let Some([rest @ .., last]) = history.last_chunk::<5>() else { return false };
    rest.iter().all(|[_, force]| (force - last[1]).abs() <= 1e-5 * last[1].abs())
}

/// The last bend of the curve: up to there, the intercept of the tangent with the force axis has made nine tenths of
/// its changes. For a straight line, such as viscous friction, the intercept is constant.
fn last_bend(curve: &[[f64; 2]], noise: f64) -> Option<f64> {
    let intercepts: Curve = curve.windows(3).map(|three| [three[1][0], intercept(three)]).collect();
    let largest = intercepts.iter().map(|point| point[1].abs()).fold(0.0, f64::max);
    let mut anchor = intercepts.first()?[1];
    let mut changes = Vec::new();
    for [velocity, value] in &intercepts {
        // Anything smaller is noise, which the slope amplifies, or invisible.
        if (value - anchor).abs() > f64::max(0.05 * largest, 15.0 * noise) {
            changes.push([*velocity, (value - anchor).abs()]);
            anchor = *value;
        }
    }
    let total: f64 = changes.iter().map(|change| change[1]).sum();
    let mut sum = 0.0;
    changes
        .iter()
        .find(|change| {
            sum += change[1];
            sum >= 0.9 * total
        })
        .map(|change| change[0])
}

/// For three points whose velocities grow by the same factor.
fn intercept(three: &[[f64; 2]]) -> f64 {
    let ratio = three[2][0] / three[1][0];
    three[1][1] - (three[2][1] - three[0][1]) / (ratio - 1.0 / ratio)
}

/// The velocity at which the viscous part is half as large as the rest, or the end of the curve if the force grows at
/// all; a usual one for a law without any scale.
fn velocity_without_bend(curve: &[[f64; 2]], noise: f64) -> f64 {
    const USUAL: f64 = 0.01;
    let (Some(first), Some(last)) = (curve.first(), curve.last()) else { return USUAL };
    let is_larger = |point: &&[f64; 2]| first[1] != 0.0 && point[1].abs() > 1.5 * first[1].abs();
    match curve.iter().find(is_larger) {
        Some(point) => point[0],
        None if (last[1] - first[1]).abs() > f64::max(0.03 * first[1].abs(), 6.0 * noise) => last[0],
        None => USUAL,
    }
}

/// The next number with one digit, or 1.5, times a power of ten.
pub fn round_up(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    // A number that has just been rounded must not be rounded again.
    let digits = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
    let digit = digits.into_iter().find(|digit| digit * power >= value * (1.0 - 1e-9));
    let text = format!("{:.1e}", digit.unwrap_or(10.0) * power);
    text.parse().unwrap_or(value)
}

/// Smallest and largest value along an axis.
pub fn limits<'a>(curves: impl IntoIterator<Item = &'a Curve>, axis: usize) -> [f64; 2] {
    let values = curves.into_iter().flatten().map(|point| point[axis]);
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// Distance of two curves over the same velocities, relative to the range of the force.
pub fn distance(a: &Curve, b: &Curve) -> f64 {
    let [low, high] = limits([a, b], 1);
    let largest = a.iter().zip(b).map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f64::max);
    if high > low { largest / (high - low) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{abs_diff_eq, assert_abs_diff_eq};
    use stribeck::catalogue::by_name;

    mod laws {
        //! Laws unlike any shipped model.
        use stribeck::model::{Model, ModelType, real};
        use stribeck::number::Real;

        stribeck::model! {
            /// A force that follows a smooth law with a delay in time.
            Sluggish: "Sluggish" {
                /// Velocity.
                velocity: input = real("m/s", 0.0).means(stribeck::model::Meaning::Velocity),
                /// Force.
                force: state = real("N", 0.0),
                /// Force.
                friction_force: output = real("N", 0.0).means(stribeck::model::Meaning::FrictionForce),
            }
        }

        impl<T: Real> stribeck::model::Law for Sluggish<T> {
            type Interface = stribeck::model::CoSimulation;

            fn output(&mut self) {
                self.friction_force = self.force;
            }
        }

        impl Model for Sluggish {
            fn step(&mut self, dt: f64) {
                let target = (self.velocity / 1e-3).tanh();
                self.force = target + (self.force - target) * (-dt / 0.05).exp();
            }
        }

        stribeck::model! {
            /// Dry friction in the plane.
            Planar: "Planar" {
                /// Velocity.
                velocity_x: input = real("m/s", 0.0).means(stribeck::model::Meaning::Velocity),
                /// Velocity.
                velocity_y: input = real("m/s", 0.0).means(stribeck::model::Meaning::VelocityY),
                /// Force.
                friction_force_x: output = real("N", 0.0).means(stribeck::model::Meaning::FrictionForce),
                /// Force.
                friction_force_y: output = real("N", 0.0),
            }
        }

        impl<T: Real> stribeck::model::Law for Planar<T> {
            type Interface = stribeck::model::CoSimulation;

            fn output(&mut self) {
                self.friction_force_x = self.velocity_x.sign();
                self.friction_force_y = self.velocity_y.sign();
            }
        }

        impl Model for Planar {
            fn step(&mut self, _dt: f64) {}
        }

        pub static SLUGGISH: ModelType = ModelType::of::<Sluggish>();
        pub static PLANAR: ModelType = ModelType::of::<Planar>();
    }

    fn law(name: &str) -> Law {
        Law::new(by_name(name).unwrap(), None).unwrap()
    }

    /// LuGre in steady sliding: g(v) + sigma_2 v with the start values, by hand.
    #[test]
    fn steady_curve_is_the_closed_form() {
        let steady = law("LuGre").steady(5e-3, 0.0).unwrap();
        for [v, force] in steady.growing.iter().chain(&steady.fading) {
            let level = 0.981 + 0.4905 * (-(v / 1e-3).powi(2)).exp();
            assert!(abs_diff_eq!(force - level * v.signum(), 0.1 * v, epsilon = 2e-4), "{v}: {force}");
        }
        assert_eq!(steady.growing.len(), 600);
        assert!(steady.growing.is_sorted_by(|a, b| a[0] < b[0]));
    }

    /// The features of a curve fill the figure: v_0 or v_S is 1 mm/s in these laws.
    #[test]
    fn velocities_reach_beyond_the_bend() {
        for name in ["LuGre", "BrownMcPhee", "Karnopp"] {
            let range = law(name).velocity_range().unwrap();
            assert!((1.5e-3..=8e-3).contains(&range), "{name}: {range}");
        }
        assert_eq!(law("CoulombStiction").velocity_range().unwrap(), 0.01);
    }

    #[test]
    fn last_bend_is_found_on_any_scale_and_not_on_a_straight_line() {
        for scale in [1e-4, 1e-2, 1.0] {
            let points = |f: fn(f64) -> f64| {
                (0..60)
                    .map(|k| scale * 10f64.powf(f64::from(k) / 10.0 - 3.0))
                    .map(|v| [v, f(v / scale)])
                    .collect::<Curve>()
            };
            let bend = last_bend(&points(f64::tanh), 0.0).unwrap();
            assert!((2.0..3.2).contains(&(bend / scale)), "{bend}");
            assert_eq!(last_bend(&points(|u| 1.0 + 0.3 * u), 0.0), None);
            // Additional viscous friction does not matter.
            let viscous = last_bend(&points(|u| u.tanh() + 0.01 * u), 0.0).unwrap();
            assert!((2.0..3.2).contains(&(viscous / scale)), "{viscous}");
        }
    }

    #[test]
    fn displacement_matters_to_laws_with_bristles_only() {
        for name in ["LuGre", "Dahl"] {
            let scale = law(name).displacement_scale(5e-3).unwrap().unwrap();
            // f_s / sigma_0 or f_C / sigma_0: 15 um or 10 um.
            assert!((8e-6..3e-5).contains(&scale), "{name}: {scale}");
        }
        for name in ["CoulombStiction", "Karnopp", "BrownMcPhee"] {
            assert_eq!(law(name).displacement_scale(5e-3).unwrap(), None, "{name}");
        }
    }

    #[test]
    fn a_delay_in_time_is_not_a_displacement() {
        let law = Law::new(&laws::SLUGGISH, None).unwrap();
        assert!(law.response_time(2e-3).unwrap() > 0.05);
        assert_eq!(law.displacement_scale(2e-3).unwrap(), None);
    }

    #[test]
    fn laws_without_memory_respond_at_once() {
        for name in ["CoulombStiction", "Karnopp", "BrownMcPhee"] {
            assert_eq!(law(name).response_time(5e-3).unwrap(), 0.0, "{name}");
        }
    }

    #[test]
    fn a_planar_law_is_observed_along_x() {
        let law = Law::new(&laws::PLANAR, None).unwrap();
        let steady = law.steady(1.0, 0.0).unwrap();
        assert!(steady.growing.iter().all(|[v, force]| *force == v.signum()));
    }

    /// Dahl's virgin curve, f_C (1 - exp(-sigma_0 x / f_C)), and the closed form of its largest loop.
    #[test]
    fn strokes_of_dahl_have_the_closed_form() {
        let strokes = law("Dahl").strokes(1e-5, 5e-3).unwrap();
        for &[x, force] in &strokes[..=150] {
            assert!(abs_diff_eq!(force, 0.981 * (1.0 - (-1e5 * x / 0.981f64).exp()), epsilon = 1e-12), "{x}: {force}");
        }
        let [x, force] = *strokes.last().unwrap();
        assert_abs_diff_eq!(x, 4e-5, epsilon = 1e-18);
        // Close to f_C tanh(sigma_0 X / f_C): after one cycle the loop has almost closed.
        assert_abs_diff_eq!(force, 0.981 * (4.0 / 0.981f64).tanh(), epsilon = 1e-4);
    }

    #[test]
    fn external_force_determines_the_force_at_rest() {
        let law = law("CoulombStiction");
        assert!(law.has_external_force());
        let upper = law.steady(0.01, 1e3).unwrap().growing;
        let at_rest = upper.iter().find(|[v, _]| *v == 0.0).unwrap();
        assert_abs_diff_eq!(at_rest[1], 1.4715, epsilon = 1e-12);
        assert!(upper.iter().filter(|[v, _]| *v > 0.0).all(|[_, force]| (force - 0.981).abs() < 1e-12));
    }

    /// A force that fluctuates about a constant has no bend.
    #[test]
    fn noise_is_no_bend() {
        let mut random = fastrand::Rng::with_seed(7);
        let curve: Curve =
            (0..=50).map(|k| [1e-5 * 10f64.powf(f64::from(k) / 10.0), 1.0 + 0.04 * (random.f64() - 0.5)]).collect();
        let noise = 0.04 / 12f64.sqrt();
        assert_eq!(last_bend(&curve, noise), None);
        assert_eq!(velocity_without_bend(&curve, noise), 0.01);
    }

    #[test]
    fn a_fluctuating_force_has_a_mean_with_its_error() {
        let history: Curve = (0..100).map(|k| [f64::from(k), if k % 2 == 0 { 1.0 } else { 2.0 }]).collect();
        let Settled { force, noise } = mean(&history);
        assert!((force - 1.5).abs() < 1e-12 && (noise - 0.05).abs() < 1e-12);
    }

    #[test]
    fn presets_change_the_curve() {
        static PRESET: Preset = Preset { name: "thesis", source: "", values: &[] };
        let model = by_name("LuGre").unwrap();
        let known = model.presets.iter().find(|preset| preset.name != PRESET.name).expect("a second preset");
        let [plain, preset] = [None, Some(known)]
            .map(|preset| Law::new(model, preset).unwrap().run(0.0).unwrap().settle(0.01).unwrap().force);
        assert_ne!(plain, preset);
    }

    #[test]
    fn ranges_are_round() {
        for (value, round) in
            [(0.0123, 0.015), (0.015, 0.015), (7e-5, 8e-5), (9.1, 10.0), (1.0, 1.0), (3.000_000_000_001, 3.0)]
        {
            assert!(abs_diff_eq!(round_up(value) / round, 1.0, epsilon = 1e-6), "{value}: {}", round_up(value));
        }
    }
}
