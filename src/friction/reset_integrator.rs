use crate::contact::motion::Motion;
use crate::contact::quantities::*;
use crate::contact::time_stepping::{MOVED, PASSED, Phase, PhaseColumn, REACHED};
use crate::contact::unloading;
use crate::model::ramp;
use crate::model::{Derivatives, Fault, Law, Model, ModelExchange, Preset, real};
use crate::number::{Mask, Real, choose};
use crate::numerics::root::first_rise;

crate::model! {
    /// Reset integrator friction: a stiff and damped bond that holds up to the static level, breaks at a given
    /// deflection and slides at the kinetic level; stiction and pre-sliding displacement with one state and one switch.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt = 0    if (v > 0 and z >= z_m) or (v < 0 and z <= -z_m),   else v          (7.9)
    /// f_f   = sigma_0 (1 + a) z + sigma_1 dz/dt    if |z| <  z_m                       (7.10)
    ///       = sigma_0 z_m sgn(v)                   if |z| >= z_m
    /// a     = f_s / f_C - 1,   z_m = f_C / sigma_0
    /// f_C   = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// | symbol  | variable             | unit  | meaning                                                |
    /// |---------|----------------------|-------|--------------------------------------------------------|
    /// | v       | `velocity`           | m/s   | velocity of body 1 relative to body 2                  |
    /// | f_n     | `normal_force`       | N     | force pressing the surfaces together                   |
    /// | mu_k    | `mu_k`               | 1     | kinetic coefficient of friction                        |
    /// | mu_s    | `mu_s`               | 1     | static coefficient of friction; $1 + a = mu_s / mu_k$  |
    /// | sigma_0 | `sigma_0`            | N/m   | stiffness while sliding; $(1 + a) sigma_0$ at rest     |
    /// | sigma_1 | `sigma_1`            | N.s/m | damping of the bond                                    |
    /// | z       | `bristle_deflection` | m     | deflection of the bond, at most $z_m$                  |
    /// | -       | `slip_direction`     | 1     | sign of $z$ once $z_m$ was reached, until $v$ reverses |
    /// | -       | `bond`               |       | held or broken, as the last event has found it         |
    /// | f_f     | `friction_force`     | N     | friction force                                         |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding; body 1 feels `-friction_force`. Dissipated power is
    /// `friction_force * velocity`; it is negative while the bond springs back.
    ///
    /// # Step
    /// With held inputs the step is exact: the instant at which the deflection reaches $z_m$ is located inside the
    /// step, and the energy is the sum of the two parts. If the master gives slopes of the inputs, the step is exact as
    /// well: the breakaway is located, and the energy is a closed form. A motion against the deflection bonds the
    /// contact again at once, so the force then belongs to the first line of (7.10), also at $|z| = z_m$. At rest
    /// ($v = 0$) with $|z| = z_m$ the last sliding force $sigma_0 z$ stays. `slip_direction` records that $z_m$ has
    /// been reached. `sticking` means that the contact is bonded or at rest.
    ///
    /// A master that steps the friction first and then reads the force gets at most $f_s + 2 sigma_1 z_m / h$, because
    /// a contact that is still bonded after a step $h$ has moved by $2 z_m$ at most.
    ///
    /// A master that integrates a mass $m$ with the force it reads couples it explicitly to the stiffness $k$ and the
    /// damping $c$ of the contact at rest. If the friction steps first, a held body stays still for communication steps
    /// $h$ with $k h^2 + 2 c h < 4 m$, which is 3.5 ms for the defaults and 1 kg; above, it chatters within the bounds
    /// of the force. If all models step at once and exchange afterwards, the limit is $h < 1 / (k / c + c / m)$, 1.3
    /// ms.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// The force drops from $f_s + sigma_1 v$ to $f_C$ at breakaway, and jumps up at every reversal. The level does not
    /// depend on the speed. A change of load takes a sliding contact to the new $z_m$ (`bristle_deflection` keeps its
    /// value at breakaway), so that it continues to slide, and limits the deflection of a bonded one. `normal_force` =
    /// 0 releases the contact (force 0, deflection 0), and so does `mu_k` = 0, because then $z_m = 0$. `mu_s` = `mu_k`
    /// with `sigma_1` = 0 is an elastic, perfectly plastic bond, Dahl's law with $alpha = 0$. Passive at constant load:
    /// the stored energy $(1 + a) sigma_0 z^2 / 2$ is that of a spring, so from the start values `dissipated_energy`
    /// never becomes negative.
    ///
    /// # Source
    /// Haessig and Friedland (1991), doi:10.1115/1.2896418; equations (7.9) to (7.11) of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024). Differences
    /// from the thesis: its maximum deflection $z_0$ is $z_m$ here, because its Table 7.1 gives $z_0 = 0$ as the
    /// initial deflection. That table prints $a = 0.52$, which makes the breakaway force 1.49112 N instead of
    /// $f_s = 1.4715$ N; here a follows from $mu_s / mu_k$ and is 0.5, and the preset `thesis_printed` has 0.52. The
    /// text calls a the ratio of stiction to sliding load, which is 1 + a. (7.11), $sigma_1 = 0.707 sqrt(sigma_0 m)$,
    /// gives a stuck mass $m$ a damping ratio of only 0.289; 0.707 would need $1.414 sqrt((1 + a) sigma_0 m)$; the
    /// default is that of Table 7.1 (damping ratio 0.408 for 1 kg). A stiffness that depends on the speed, which (7.10)
    /// allows, is left out.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::ResetIntegrator;
    /// use stribeck::model::{Law, Model};
    /// let mut law = ResetIntegrator { velocity: 1e-4, sigma_1: 0.0, ..Default::default() };
    /// law.step(0.05); // 5 um, bonded: 1.5 sigma_0 z
    /// law.output();
    /// assert!((law.friction_force - 0.75).abs() < 1e-12);
    /// law.step(0.05); // 10 um, beyond z_m = 9.81 um: sliding
    /// law.output();
    /// assert_eq!(law.friction_force, 0.1 * 9.81);
    /// ```
    ResetIntegrator: "Bond that breaks at the static level (reset integrator)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1,
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        /// Direction in which the contact has broken away; 0 = bonded.
        slip_direction: state = real("1", 0.0).at_least(-1.0).at_most(1.0).discrete().odd(),
        /// Bond as found by the last event of Model Exchange: held, or broken in a direction.
        bond: state = Phase::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// Time constant of a bond that a falling load pushes back, in s (chosen).
const PUSHED: f64 = 1e-4;

impl<T: Real> ResetIntegrator<T> {
    /// f_C.
    fn coulomb(&self) -> T {
        self.mu_k * self.normal_force
    }

    /// z_m.
    fn limit(&self) -> T {
        self.coulomb() / self.sigma_0
    }

    /// (1 + a) sigma_0.
    fn stiffness(&self) -> T {
        self.sigma_0 * self.mu_s / self.mu_k
    }

    /// Deflection at the present load: z_m once the contact has broken away, at most z_m before.
    fn deflection(&self) -> T {
        let bonded = || self.bristle_deflection.pushed_back(self.limit());
        self.slip_direction.vanishes().choose(bonded, || self.slip_direction.sign() * self.limit())
    }

    /// Bond as found by the last event of Model Exchange.
    fn bond(&self) -> PhaseColumn<T> {
        PhaseColumn(self.bond)
    }

    /// Whether the contact slides: as the last event has found it or, without one, as the motion says.
    fn is_sliding(&self) -> T::Mask {
        self.bond().slides() | self.bond().is_free() & self.moves_on()
    }

    /// Direction of sliding.
    fn direction(&self) -> T {
        choose!(self.bond().slides(), self.bond().direction(), self.velocity.sign())
    }

    /// Whether the contact has broken away in the direction of the motion.
    fn moves_on(&self) -> T::Mask {
        let direction = self.velocity.sign();
        let is_at_limit = (self.bristle_deflection * direction).at_least(self.limit());
        !direction.vanishes() & ((self.slip_direction * direction).is_positive() | is_at_limit)
    }

    fn is_at_rest_after_sliding(&self) -> T::Mask {
        let has_slid = !self.slip_direction.vanishes() | self.bristle_deflection.abs().at_least(self.limit());
        self.bond().is_free() & self.velocity.vanishes() & has_slid
    }

    /// Rate of the deflection.
    fn deflection_rate(&self) -> T {
        let excess = self.bristle_deflection - self.bristle_deflection.pushed_back(self.limit());
        let is_outward = (self.velocity * excess).is_positive();
        let pushed_back = choose!(is_outward, T::zero(), excess / T::from(PUSHED));
        choose!(self.is_sliding() | self.coulomb().at_most(T::zero()), T::zero(), self.velocity - pushed_back)
    }

    /// Eq. (7.10).
    fn force(&self) -> T {
        let bonded = || {
            let stiffness = self.is_at_rest_after_sliding().choose(|| self.sigma_0, || self.stiffness());
            stiffness * self.deflection() + self.sigma_1 * self.velocity
        };
        let loaded = || self.is_sliding().choose(|| self.coulomb() * self.direction(), bonded);
        self.coulomb().at_most(T::zero()).choose(|| T::zero(), loaded)
    }
}

impl<T: Real> Law for ResetIntegrator<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let sticks = !self.is_sliding() | self.velocity.vanishes();
        self.sticking = T::truth(sticks & self.coulomb().is_positive());
    }

    fn slide_steadily(&mut self) {
        self.bond = T::from(Phase::Free.number());
        let (is_loaded, direction) = (self.coulomb().is_positive(), self.velocity.sign());
        let steady = |moving: T, resting: T| {
            is_loaded.choose(|| direction.vanishes().choose(|| resting, || moving), || T::zero())
        };
        self.bristle_deflection = steady(direction * self.limit(), self.bristle_deflection);
        self.slip_direction = steady(direction, self.slip_direction);
    }
}

impl<T: Real> Derivatives for ResetIntegrator<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.bristle_deflection = self.deflection_rate();
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl ResetIntegrator {
    /// |z| / z_m.
    fn stretch(&self) -> f64 {
        self.bristle_deflection.abs() / self.limit()
    }

    /// Speed in the direction of the deflection, in parts of the least one that counts.
    fn outward_speed(&self) -> f64 {
        self.velocity * self.bristle_deflection.sign() / MOVED
    }

    /// Motion of the contact after an event. The limits lie between those of the indicator.
    fn settled(&self) -> Phase {
        // At rest after sliding the last force stays.
        let slides_on = |direction: f64| direction * self.velocity >= 0.0;
        let breaks = self.stretch() >= 1.0 + 0.5 * REACHED && self.outward_speed() > 0.5 * PASSED;
        match Phase::of(self.bond).direction() {
            _ if unloading::is_unloaded(self.normal_force) => Phase::Held,
            Some(direction) if slides_on(direction) => Phase::sliding(direction),
            None if breaks || self.bond().is_free() && self.moves_on() => Phase::sliding(self.velocity),
            None if self.is_at_rest_after_sliding() => Phase::sliding(self.bristle_deflection),
            _ => Phase::Held,
        }
    }

    /// Stretches the bond, up to z_m; the rest of the distance is sliding.
    fn pull(&mut self, direction: f64, distance: f64) {
        let before = self.deflection();
        let bonded = distance.min(self.limit() - direction * before);
        self.bristle_deflection = before + direction * bonded;
        self.slip_direction = 0.0;
        self.dissipated_energy += self.stiffness() * direction * bonded * (before + 0.5 * direction * bonded)
            + self.sigma_1 * self.velocity.abs() * bonded;
        if bonded < distance {
            self.slide(direction, distance - bonded);
        }
    }

    fn slide(&mut self, direction: f64, distance: f64) {
        if self.slip_direction != direction {
            self.bristle_deflection = direction * self.limit();
            self.slip_direction = direction;
        }
        self.dissipated_energy += self.coulomb() * distance;
    }

    /// Advances over a motion in which neither velocity nor normal force changes its sign.
    fn follow(&mut self, part: Motion) {
        let direction = part.direction();
        if self.mu_k == 0.0 || part.is_unloaded() {
            (self.bristle_deflection, self.slip_direction) = (0.0, 0.0);
            return;
        }
        if direction == 0.0 {
            return;
        }
        if self.slip_direction != direction {
            self.bristle_deflection = self.deflection_at(part.load);
            self.slip_direction = 0.0;
            let breakaway = self.breakaway(&part, direction);
            self.follow_bonded(part.part(0.0, breakaway.unwrap_or(part.duration)));
            let Some(breakaway) = breakaway else { return };
            self.slip_direction = direction;
            return self.follow_sliding(part.part(breakaway, part.duration), direction);
        }
        self.follow_sliding(part, direction);
    }

    /// The first instant at which the bond meets z_m, which moves with the load.
    fn breakaway(&self, part: &Motion, direction: f64) -> Option<f64> {
        let compliance = self.mu_k / self.sigma_0;
        let excess = |t: f64| direction * (self.bristle_deflection + part.path(t)) - compliance * part.load_at(t);
        let parabola =
            [direction * part.velocity - compliance * part.load_rate, 0.5 * direction * part.acceleration, 0.0];
        first_rise(excess, parabola, part.duration)
    }

    fn follow_bonded(&mut self, part: Motion) {
        let (before, change, h) = (self.bristle_deflection, part.path(part.duration), part.duration);
        let (begin, middle, end) = (part.velocity, part.velocity_at(0.5 * h), part.velocity_at(h));
        self.dissipated_energy += self.stiffness() * change * (before + 0.5 * change)
            + self.sigma_1 * h / 6.0 * (begin * begin + 4.0 * middle * middle + end * end);
        self.bristle_deflection += change;
    }

    /// Simpson's rule is exact for the product of load and velocity.
    fn follow_sliding(&mut self, part: Motion, direction: f64) {
        let power = |t: f64| self.mu_k * part.load_at(t) * part.velocity_at(t).abs();
        let h = part.duration;
        self.dissipated_energy += h / 6.0 * (power(0.0) + 4.0 * power(0.5 * h) + power(h));
        self.bristle_deflection = direction * self.mu_k * part.load_at(h) / self.sigma_0;
    }

    /// The deflection at another load.
    fn deflection_at(&self, load: f64) -> f64 {
        ResetIntegrator { normal_force: load, ..*self }.deflection()
    }
}

impl Model for ResetIntegrator {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "thesis",
            source: "Novais (2024), Tables 6.1 and 7.1 with a = f_s / f_C - 1 = 0.5: the start values",
            values: &[],
        },
        Preset {
            name: "thesis_printed",
            source: "Novais (2024), Table 7.1 as printed: a = 0.52, so that breakaway is at 1.49112 N",
            values: &[("mu_s", 0.152)],
        },
        Preset {
            name: "damped_bond",
            source: "Example: sigma_1 = 1.414 sqrt((1 + a) sigma_0 m) damps a stuck mass of 1 kg by 0.707",
            values: &[("sigma_1", 547.722_557_505_166_1)],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn step(&mut self, dt: f64) {
        self.bond = Phase::Free.number();
        let direction = self.velocity.sign();
        let distance = self.velocity.abs() * dt;
        if self.coulomb() <= 0.0 {
            (self.bristle_deflection, self.slip_direction) = (0.0, 0.0);
        } else if self.is_sliding() {
            self.slide(direction, distance);
        } else if direction != 0.0 {
            self.pull(direction, distance);
        }
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.bond = Phase::Free.number();
        let begin = ramp::Inputs::of(self);
        let motion = Motion {
            acceleration: slope.velocity,
            load_rate: slope.normal_force,
            ..Motion::held(self.velocity, self.normal_force, dt)
        };
        motion.parts().for_each(|part| self.follow(part));
        ramp::set_inputs(self, &begin, slope, dt);
        if self.slip_direction == 0.0 && !motion.is_at_rest() {
            // A bond that z_m has pushed back lies exactly on z_m.
            self.bristle_deflection = self.deflection();
        }
    }

    const EVENT_INDICATORS: usize = 2;

    const PIECEWISE_LINEAR: bool = true;

    fn event_indicators(&self, indicators: &mut [f64]) {
        let change = match Phase::of(self.bond).direction() {
            None => (1.0 + REACHED - self.stretch()).max(PASSED - self.outward_speed()),
            Some(direction) => direction * self.velocity / MOVED + PASSED,
        };
        indicators.copy_from_slice(&[change, unloading::load(self.normal_force)]);
    }

    fn at_event(&mut self) {
        let deflection = self.deflection();
        self.bond = self.settled().number();
        let direction = Phase::of(self.bond).direction();
        self.slip_direction = direction.unwrap_or(0.0);
        let is_released = unloading::is_unloaded(self.normal_force);
        self.bristle_deflection = if is_released { 0.0 } else { direction.map_or(deflection, |to| to * self.limit()) };
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn moved(law: ResetIntegrator, velocity: f64, dt: f64) -> ResetIntegrator {
        let mut law = ResetIntegrator { velocity, ..law };
        law.step(dt);
        law.output();
        law
    }

    /// A kinetic level of 0 has a limit of 0 for the deflection: the contact is released, whatever the static level.
    #[test]
    fn no_kinetic_level_is_no_contact() {
        let mut law = moved(ResetIntegrator::default(), 1e-4, 0.05);
        assert!(law.friction_force > 0.0);
        law.mu_k = 0.0;
        let released = moved(law, 1e-4, 1e-3);
        assert_eq!((released.friction_force, released.bristle_deflection), (0.0, 0.0));
        assert_eq!(released.dissipated_energy, law.dissipated_energy);
    }

    /// Breakaway: just before z_m the force is f_s + sigma_1 v, just after f_C.
    #[test]
    fn force_drops_at_breakaway_and_jumps_up_at_reversal() {
        let v = 1e-4;
        let before = moved(ResetIntegrator::default(), v, 0.0981 * (1.0 - 1e-9));
        assert!((before.friction_force - (1.4715 + 316.227_766 * v)).abs() < 1e-8, "{}", before.friction_force);
        assert_eq!(before.sticking, 1.0);
        let after = moved(ResetIntegrator::default(), v, 0.0981 * (1.0 + 1e-9));
        assert_eq!((after.friction_force, after.sticking), (0.1 * 9.81, 0.0));
        let mut stopped = ResetIntegrator { velocity: 0.0, ..after };
        stopped.output();
        assert!((stopped.friction_force - 0.981).abs() < 1e-15 && stopped.sticking == 1.0);
        let mut reversed = ResetIntegrator { velocity: -v, ..after };
        reversed.output();
        assert_abs_diff_eq!(reversed.friction_force, 1.4715 - 316.227_766 * v, epsilon = 1e-8);
    }

    /// A cycle of +-X with X > z_m and no damping: bonded over 2 z_m per leg, where the spring returns the energy that
    /// it took.
    #[test]
    fn closed_cycle_dissipates_in_sliding_only() {
        let start = moved(ResetIntegrator { sigma_1: 0.0, ..Default::default() }, 1e-3, 0.05);
        let end = moved(moved(start, -1e-3, 0.05), 1e-3, 0.05);
        let per_cycle = 2.0 * 0.981 * (5e-5 - 2.0 * 9.81e-6);
        assert_abs_diff_eq!((end.dissipated_energy - start.dissipated_energy) / per_cycle, 1.0, epsilon = 1e-12);
    }

    /// The energy against a fine sum of the power, across breakaway.
    #[test]
    fn energy_is_the_integral_of_power() {
        let whole = moved(ResetIntegrator::default(), 2e-3, 0.01);
        let mut law = ResetIntegrator { velocity: 2e-3, ..Default::default() };
        let (mut integral, n) = (0.0, 100_000);
        for _ in 0..n {
            law.step(0.5e-2 / f64::from(n));
            law.output();
            integral += law.dissipated_power * 1e-2 / f64::from(n);
            law.step(0.5e-2 / f64::from(n));
        }
        assert!((whole.dissipated_energy / integral - 1.0).abs() < 1e-5, "{integral}");
        assert_abs_diff_eq!(whole.dissipated_energy / law.dissipated_energy, 1.0, epsilon = 1e-9);
    }

    /// A falling load reduces the deflection: the force is the new level, and the bond is not stronger.
    #[test]
    fn falling_load_takes_the_deflection_down() {
        let mut law = moved(ResetIntegrator::default(), 1e-3, 1.0);
        law.normal_force = 4.905;
        law.output();
        assert_eq!(law.friction_force, 0.1 * 4.905);
        let law = moved(law, -1e-9, 1e-3);
        assert!((law.friction_force - 0.5 * 1.4715).abs() < 1e-6 && law.bristle_deflection < 4.905e-6);
    }

    /// A load that rises lets a sliding contact slide on; without this memory it would bond again with f_s + sigma_1 v.
    #[test]
    fn rising_load_does_not_bond_a_sliding_contact() {
        let sliding = moved(ResetIntegrator::default(), 0.3, 1e-3);
        let mut law = ResetIntegrator { normal_force: 12.0, ..sliding };
        law.output();
        assert_eq!((law.friction_force, law.sticking), (0.1 * 12.0, 0.0));
        let law = moved(law, 0.3, 1e-6);
        assert_eq!(law.friction_force, 0.1 * 12.0);
        assert_abs_diff_eq!(law.dissipated_energy - sliding.dissipated_energy, 1.2 * 0.3e-6, epsilon = 1e-18);
        // At a reversal the bond has the z_m of the present load.
        let mut law = ResetIntegrator { velocity: -1e-9, ..law };
        law.output();
        assert_abs_diff_eq!(law.friction_force, 0.15 * 12.0, epsilon = 1e-6);
    }

    #[test]
    fn without_kinetic_friction_nothing_holds() {
        let law = moved(ResetIntegrator { mu_k: 0.0, ..Default::default() }, 1e-3, 1e-3);
        assert_eq!((law.friction_force, law.bristle_deflection, law.sticking), (0.0, 0.0, 0.0));
    }
}
