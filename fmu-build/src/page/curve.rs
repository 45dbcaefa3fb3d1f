//! Curves for the page and the icon of a model, computed with the model itself.
//!
//! The range of the velocities follows from the speeds that the law declares, that of the displacements from the way on
//! which the contact yields.

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use anyhow::{Context, Result};
use stribeck::instance::Instance;
use stribeck::model::{Kind, Meaning, ModelType, Preset};
use stribeck::series::{self, Ended};

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

    /// The column of the normal force and its value while the law is observed.
    pub fn normal_force(&self) -> Result<Option<(usize, f64)>> {
        let column = self.model.table.of(Meaning::NormalForce);
        let run = self.run(0.0)?;
        Ok(column.map(|column| (column, run.instance.row()[column])))
    }

    /// Whether an external force determines the force at rest.
    pub fn has_external_force(&self) -> bool {
        self.external_force.is_some()
    }

    /// A round velocity that includes all features of the curve: a multiple of the largest speed that the law declares,
    /// five unless the force is constant from twice that speed (chosen). Without one, the velocity at which viscous
    /// friction is a tenth of the force, or a usual one.
    pub fn velocity_range(&self) -> Result<f64> {
        const USUAL: f64 = 0.01;
        let mut run = self.run(0.0)?;
        let largest = run.speeds().fold(0.0, f64::max);
        if largest > 0.0 {
            // Some laws raise the static level at rest.
            run.settle(0.0)?;
            let [near, far] = [run.settle(2.0 * largest)?, run.settle(4.0 * largest)?];
            let is_constant = (far - near).abs() < 5e-3 * near;
            return Ok(round_up(largest * if is_constant { 2.0 } else { 5.0 }));
        }
        let viscous = self.model.table.of(Meaning::Viscous).map_or(0.0, |column| run.instance.row()[column]);
        Ok(if viscous > 0.0 { round_up(0.1 * run.settle(USUAL)? / viscous) } else { USUAL })
    }

    /// The settled force over velocities from -`range` to `range`, which are closer together near 0.
    pub fn steady(&self, range: f64, external_force: f64) -> Result<Curve> {
        // At rest only an external force determines the friction force.
        let first = i32::from(!self.has_external_force());
        let side = |end: f64| {
            let mut run = self.run(external_force)?;
            let velocities = (first..=POINTS).map(|k| end * (f64::from(k) / f64::from(POINTS)).powf(1.5));
            velocities.map(|velocity| Ok([velocity, run.settle(velocity)?])).collect::<Result<Curve>>()
        };
        let (backwards, forwards) = (side(-range)?, side(range)?);
        Ok(backwards.into_iter().rev().chain(forwards).collect())
    }

    /// A round period of an oscillating velocity that shows the memory of the law, twelve response times (chosen); none
    /// for a law without memory.
    pub fn period(&self, amplitude: f64) -> Result<Option<f64>> {
        match self.response_time(amplitude)? {
            0.0 => Ok(self.acceleration.map(|_| 1.0)),
            response => Ok(Some(round_up(12.0 * response))),
        }
    }

    /// The settling time of the force after the velocity has changed from -`velocity` / 4 to `velocity`; 0 for a law
    /// without memory.
    fn response_time(&self, velocity: f64) -> Result<f64> {
        let mut run = self.run(0.0)?;
        let settled = run.settled(velocity)?;
        let level = settled.map_or_else(|| run.mean(velocity), Ok)?;
        run.settle(-0.25 * velocity)?;
        run.at(velocity)?;
        let (mut time, mut dt, mut history) = (0.0, 1e-5, Vec::new());
        while time < 10.0 {
            run.step(dt)?;
            time += dt;
            dt *= 1.1;
            history.push((time, (run.force() - level).abs() / level.abs()));
        }
        let last_off = match settled {
            Some(_) => history.iter().rposition(|(_, off)| *off > 0.03),
            // It keeps fluctuating: until the first time that it comes near.
            None => history.iter().position(|(_, off)| *off < 0.15).and_then(|at| at.checked_sub(1)),
        };
        Ok(last_off.map_or(0.0, |at| history[at].0))
    }

    /// The second period of an oscillating velocity.
    pub fn oscillation(&self, amplitude: f64, period: f64) -> Result<Curve> {
        const STEPS: usize = 2000;
        let mut run = self.run(0.0)?;
        let mut curve = Vec::new();
        for step in 0..=2 * STEPS {
            let (sine, cosine) = (TAU * step as f64 / STEPS as f64).sin_cos();
            if let Some(column) = self.acceleration {
                run.instance.set_column(column, amplitude * TAU / period * cosine)?;
            }
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
        let Some([scale, level]) = self.yielding(slow)? else { return Ok(None) };
        // A spring keeps its deflection at rest; a lag does not.
        let mut run = self.run(0.0)?;
        run.travel(4.0 * scale, slow, 40)?;
        run.at(0.0)?;
        run.step(1.0)?;
        Ok((run.force() > 0.2 * level).then_some(scale))
    }

    /// The displacement at which 63 % of the largest force is reached, if it is reached gradually, and that force.
    fn yielding(&self, velocity: f64) -> Result<Option<[f64; 2]>> {
        let mut run = self.run(0.0)?;
        let (mut x, mut curve) = (0.0, Vec::new());
        for k in 0..=64 {
            let next = 1e-10 * 10f64.powf(f64::from(k) / 8.0);
            run.travel(next - x, velocity, 1)?;
            x = next;
            curve.push([x, run.force()]);
        }
        let level = curve.iter().map(|point| point[1]).fold(0.0, f64::max);
        let at = curve.iter().position(|point| point[1] >= 0.63 * level).unwrap_or_default();
        // A tenth of the displacement, eight points earlier.
        let is_gradual = at >= 8 && curve[at - 8][1] < 0.5 * level;
        Ok(is_gradual.then(|| [curve[at][0], level]))
    }

    /// Force over displacement for growing strokes, each to both sides.
    pub fn strokes(&self, scale: f64, range: f64) -> Result<Curve> {
        const STEPS: u32 = 150;
        let mut run = self.run(0.0)?;
        let mut curve = vec![[0.0, run.at(0.0)?]];
        let mut x = 0.0;
        for target in [0.6, -0.6, 1.6, -1.6, 4.0, -4.0, 4.0].map(|factor| factor * scale) {
            let (begin, distance) = (x, target - x);
            for step in 1..=STEPS {
                let next = begin + distance * f64::from(step) / f64::from(STEPS);
                run.travel(next - x, range / 200.0, 1)?;
                x = next;
                curve.push([x, run.force()]);
            }
        }
        Ok(curve)
    }
}

impl Run<'_> {
    /// The speeds that its parameters declare, directly or as rates of decay with speed.
    fn speeds(&self) -> impl Iterator<Item = f64> {
        let parameters = self.law.model.table.iter().enumerate().filter(|(_, variable)| variable.role.is_parameter());
        parameters.filter_map(|(column, variable)| {
            let Kind::Real(unit) = variable.kind else { return None };
            let value = self.instance.row()[column];
            match unit.name {
                "m/s" => Some(value),
                "s/m" if variable.meaning != Meaning::GrowsWithSpeed => Some(1.0 / value),
                _ => None,
            }
        })
    }

    /// The force at a velocity that has just been set.
    fn at(&mut self, velocity: f64) -> Result<f64> {
        self.instance.set_column(self.law.velocity, velocity)?;
        self.instance.refresh()?;
        Ok(self.force())
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

    /// The settled force at a held velocity; the mean of a force that keeps fluctuating.
    fn settle(&mut self, velocity: f64) -> Result<f64> {
        self.settled(velocity)?.map_or_else(|| self.mean(velocity), Ok)
    }

    /// The settled force at a held velocity; `None` if it keeps fluctuating.
    fn settled(&mut self, velocity: f64) -> Result<Option<f64>> {
        let (inputs, results) = ([(self.law.velocity, velocity)], [self.law.force]);
        let mut force = [0.0];
        match series::settle(&mut self.instance, &inputs, &results, &mut force, &AtomicBool::new(false)) {
            Ok(()) => Ok(Some(force[0])),
            Err(Ended::Unsettled(_)) => Ok(None),
            Err(other) => Err(other.into()),
        }
    }

    /// The mean force at the present velocity, over samples that are far apart for a contact.
    fn mean(&mut self, velocity: f64) -> Result<f64> {
        const SAMPLES: u32 = 60;
        const APART: f64 = 1e-3;
        let mut sum = 0.0;
        for _ in 0..SAMPLES {
            self.step((APART / velocity.abs()).min(100.0))?;
            sum += self.force();
        }
        Ok(sum / f64::from(SAMPLES))
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
        for [v, force] in &steady {
            let level = 0.981 + 0.4905 * (-(v / 1e-3).powi(2)).exp();
            assert!(abs_diff_eq!(force - level * v.signum(), 0.1 * v, epsilon = 1e-9), "{v}: {force}");
        }
        assert_eq!(steady.len(), 600);
        assert!(steady.is_sorted_by(|a, b| a[0] < b[0]));
    }

    /// The features of a curve fill the figure: v_0 or v_S is 1 mm/s in these laws.
    #[test]
    fn velocities_reach_beyond_the_bend() {
        for name in ["LuGre", "BrownMcPhee", "Karnopp", "Bernard", "NonReversible"] {
            let range = law(name).velocity_range().unwrap();
            assert!((1e-3..=1e-2).contains(&range), "{name}: {range}");
        }
        // Without a speed: a usual range, or that on which 0.1 N.s/m adds a tenth to 0.981 N.
        assert_eq!(law("CoulombStiction").velocity_range().unwrap(), 0.01);
        assert_eq!(law("CoulombViscous").velocity_range().unwrap(), 1.0);
    }

    /// Bristles that snap at random carry mu_k f_n = 0.981 N in the mean.
    #[test]
    fn a_fluctuating_force_has_a_mean() {
        let law = law("Bristle");
        let mut run = law.run(0.0).unwrap();
        assert_eq!(run.settled(0.01).unwrap(), None);
        assert_abs_diff_eq!(run.settle(0.01).unwrap(), 0.981, epsilon = 0.05);
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
        assert!(steady.iter().all(|[v, force]| *force == v.signum()));
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
        let upper = law.steady(0.01, 1e3).unwrap();
        let at_rest = upper.iter().find(|[v, _]| *v == 0.0).unwrap();
        assert_abs_diff_eq!(at_rest[1], 1.4715, epsilon = 1e-12);
        assert!(upper.iter().filter(|[v, _]| *v > 0.0).all(|[_, force]| (force - 0.981).abs() < 1e-12));
    }

    #[test]
    fn presets_change_the_curve() {
        static PRESET: Preset = Preset { name: "thesis", source: "", values: &[] };
        let model = by_name("LuGre").unwrap();
        let known = model.presets.iter().find(|preset| preset.name != PRESET.name).expect("a second preset");
        let [plain, preset] =
            [None, Some(known)].map(|preset| Law::new(model, preset).unwrap().run(0.0).unwrap().settle(0.01).unwrap());
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
