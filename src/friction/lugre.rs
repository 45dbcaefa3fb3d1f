use crate::contact::conditions::is_elastic;
use crate::contact::quantities::*;
use crate::contact::unloading::released_without_load;
use crate::laws::passivity::names_least_viscous;
use crate::laws::stribeck;
use crate::model::{Derivatives, Fault, Law, Model, ModelExchange, Preset, Shared, Steps, change, in_lanes};
use crate::number::{Real, choose};
use crate::numerics::relaxation::{self, Relaxation};

crate::model! {
    /// LuGre friction: bristles that yield before they slide (Dahl) with a level that falls with speed (Stribeck) and
    /// with damping; the most widely used dynamic friction model.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt = v - sigma_0 |v| z / g(v)
    /// g(v)  = f_C + (f_s - f_C) exp(-(|v| / v_S)^delta)
    /// f_f   = sigma_0 z + sigma_1(v) dz/dt + sigma_2 v
    /// f_C   = mu_k f_n,   f_s = mu_s f_n
    /// sigma_1(v) = sigma_1 exp(-(v / v_d)^2)     if v_d > 0, else sigma_1
    /// ```
    ///
    /// | symbol  | variable              | unit  | meaning                                         |
    /// |---------|-----------------------|-------|-------------------------------------------------|
    /// | v       | `velocity`            | m/s   | velocity of body 1 relative to body 2           |
    /// | f_n     | `normal_force`        | N     | force pressing the surfaces together            |
    /// | mu_k    | `mu_k`                | 1     | kinetic coefficient of friction                 |
    /// | mu_s    | `mu_s`                | 1     | static coefficient of friction                  |
    /// | v_S     | `stribeck_velocity`   | m/s   | speed at which the level has fallen             |
    /// | delta   | `stribeck_exponent`   | 1     | shape of the Stribeck curve                     |
    /// | sigma_0 | `sigma_0`             | N/m   | stiffness of the bristles                       |
    /// | sigma_1 | `sigma_1`             | N.s/m | damping of the bristles                         |
    /// | sigma_2 | `viscous_coefficient` | N.s/m | viscous coefficient                             |
    /// | v_d     | `damping_velocity`    | m/s   | speed at which the bristle damping fades        |
    /// | z       | `bristle_deflection`  | m     | mean deflection of the bristles                 |
    /// | f_f     | `friction_force`      | N     | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the bristles spring back.
    ///
    /// # Step
    /// With held inputs the equation of $z$ is linear and solved exactly, so the result does not depend on how an
    /// interval is divided, from 1 us to 1 s. `sticking` means that more than 1 % (chosen) of the motion still goes
    /// into the bristles.
    ///
    /// A master that integrates a mass $m$ with the force it reads couples it explicitly to the stiffness $k$ and the
    /// damping $c$ of the contact at rest. If the friction steps first, a held body stays still for communication steps
    /// $h$ with $k h^2 + 2 c h < 4 m$, which is 3.9 ms for the defaults and 1 kg; above, it chatters within the bounds
    /// of the force. If all models step at once and exchange afterwards, the limit is $h < 1 / (k / c + c / m)$, 1.6
    /// ms. A force that is read right after setting the velocity needs $h < 2 m / (sigma_1 + sigma_2)$, or
    /// `damping_velocity` > 0.
    ///
    #[doc = include_str!("slopes.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`.
    ///
    /// # Limits
    /// Drifts under a load that cycles below breakaway. $mu_k = 0$ is refused: $g$ would vanish at high speed, and with
    /// it the equation of $z$. Passive for every motion only if $sigma_2 >= sigma_1 (f_s - f_C) / f_C$, which no common
    /// parameter set satisfies: a velocity that jumps, as a sampled one does, can give a force spike of $sigma_1 dz/dt$
    /// (0 -> 0.1 m/s from full stiction: -14.3 N). `damping_velocity` (of the size of $v_S$) removes it; the default 0
    /// keeps the law of the paper. `normal_force` = 0 releases the contact (force 0, deflection 0).
    ///
    #[doc = include_str!("falling_load.md")]
    /// # Source
    /// Canudas de Wit, Olsson, Astrom, Lischinsky (1995), doi:10.1109/9.376053. In the paper $sigma_0 g(v)$ is the
    /// level; here $g$ is in newtons and carries the normal force, and $delta = 2$ is a parameter. Defaults: Table 7.1
    /// of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of
    /// Minho (2024). Velocity-dependent damping: Olsson (1996), PhD thesis, Lund University.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::LuGre;
    /// use stribeck::model::{Law, Model};
    /// let mut law = LuGre { velocity: 0.001, ..Default::default() };
    /// law.step(1.0);
    /// law.output();
    /// let steady = 0.981 + 0.4905 * (-1.0f64).exp() + 0.1 * 0.001; // g(v_S) + sigma_2 v_S
    /// assert!((law.friction_force - steady).abs() < 1e-12);
    /// ```
    LuGre: "Bristle friction with Stribeck effect (LuGre)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K.positive(),
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT.start(0.1),
        damping_velocity: tunable = DAMPING_VELOCITY,
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Real> LuGre<T> {
    /// g(v).
    #[inline(always)]
    fn level(&self) -> T {
        let coulomb = self.mu_k * self.normal_force;
        let breakaway = self.mu_s * self.normal_force;
        stribeck::level(self.velocity, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent)
    }

    /// sigma_1(v).
    #[inline(always)]
    fn damping(&self) -> T {
        choose!(self.damping_velocity.vanishes(), self.sigma_1, {
            let u = self.velocity / self.damping_velocity;
            self.sigma_1 * (-(u * u)).exp()
        })
    }

    /// dz/dt.
    #[inline(always)]
    fn deflection_rate(&self, level: T) -> T {
        // Without load: a step then drops the deflection, and so does the event of Model Exchange at which the load
        // vanishes.
        choose!(
            level.vanishes(),
            T::zero(),
            self.velocity - self.sigma_0 * self.velocity.abs() * self.bristle_deflection / level
        )
    }

    #[inline(always)]
    fn force(&self, deflection_rate: T, damping: T) -> T {
        let [stiffness, viscous] = [self.sigma_0, self.viscous_coefficient];
        choose!(
            self.normal_force.vanishes(),
            T::zero(),
            stiffness * self.bristle_deflection + damping * deflection_rate + viscous * self.velocity
        )
    }
}

impl<T: Real> LuGre<T> {
    /// The outputs at the level g(v) and with the damping sigma_1(v). Returns dz/dt.
    #[inline(always)]
    fn respond(&mut self, level: T, damping: T) -> T {
        let rate = self.deflection_rate(level);
        self.friction_force = self.force(rate, damping);
        self.dissipated_power = self.friction_force * self.velocity;
        let elastic = is_elastic(rate, self.velocity);
        self.sticking = T::truth(elastic & self.normal_force.is_positive());
        rate
    }
}

impl<T: Real> Law for LuGre<T> {
    type Interface = ModelExchange;

    #[inline(always)]
    fn output(&mut self) {
        self.respond(self.level(), self.damping());
    }

    #[inline(always)]
    fn slide_steadily(&mut self) {
        let level = self.level();
        let kept = choose!(self.velocity.vanishes(), self.bristle_deflection, self.steady_deflection(level));
        self.bristle_deflection = choose!(level.vanishes(), T::zero(), kept);
    }
}

impl<T: Real> Derivatives for LuGre<T> {
    #[inline(always)]
    fn derivatives(&self, rate: &mut Self) {
        rate.bristle_deflection = self.deflection_rate(self.level());
        rate.dissipated_energy = self.force(rate.bristle_deflection, self.damping()) * self.velocity;
    }

    #[inline(always)]
    fn output_and_derivatives(&mut self, rate: &mut Self) {
        rate.bristle_deflection = self.respond(self.level(), self.damping());
        rate.dissipated_energy = self.dissipated_power;
    }
}

impl<T: Real> LuGre<T> {
    /// Exact step of the deflection at the level g(v) and with the damping sigma_1(v).
    #[inline(always)]
    fn relax(&mut self, level: T, damping: T, dt: T) {
        let distance = self.velocity * dt;
        change!(self, level.vanishes(), |law| law.release(distance), |law| law.slide(level, damping, distance));
    }

    #[inline(always)]
    fn release(&mut self, distance: T) {
        self.bristle_deflection = T::zero();
        let [before, viscous] = [self.dissipated_energy, self.viscous_coefficient * self.velocity * distance];
        self.dissipated_energy = choose!(self.normal_force.is_positive(), before + viscous, before);
    }

    /// z of steady sliding at the level g(v).
    #[inline(always)]
    fn steady_deflection(&self, level: T) -> T {
        self.velocity.sign() * level / self.sigma_0
    }

    #[inline(always)]
    fn decay(&self, level: T, distance: T) -> T {
        self.sigma_0 * distance.abs() / level
    }

    #[inline(always)]
    fn slide(&mut self, level: T, damping: T, distance: T) {
        let direction = self.velocity.sign();
        let before = self.bristle_deflection;
        self.bristle_deflection = relaxation::after(before, self.steady_deflection(level), self.decay(level, distance));
        let change = self.bristle_deflection - before;
        // The integral of the force over the distance: sigma_0 z |v| / g = v - dz/dt gives the first term.
        let work = direction * level * (distance - change)
            + damping * self.velocity * change
            + self.viscous_coefficient * self.velocity * distance;
        self.dissipated_energy = self.dissipated_energy + work;
    }
}

impl<T: Real> Steps for LuGre<T> {
    const SHARED: Shared = Shared::Term;

    #[inline(always)]
    fn advance(&mut self, dt: T) {
        self.relax(self.level(), self.damping(), dt);
    }

    #[inline(always)]
    fn advance_and_output(&mut self, dt: T) {
        let (level, damping) = (self.level(), self.damping());
        self.relax(level, damping, dt);
        self.respond(level, damping);
    }

    #[inline(always)]
    fn relaxation(&self, dt: T) -> Option<Relaxation<T>> {
        let level = self.level();
        let decay = self.decay(level, self.velocity * dt);
        Some(Relaxation::of(self.steady_deflection(level), decay, !level.vanishes()))
    }
}

in_lanes!(LuGre, relaxes bristle_deflection);

impl Model for LuGre {
    const LINEAR: bool = true;
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset { name: "thesis", source: "Novais (2024), Tables 6.1 and 7.1 (the start values)", values: &[] },
        Preset {
            name: "canudas_1995",
            source: "Canudas de Wit et al. (1995), Table I: F_C = 1 N, F_S = 1.5 N, here at a normal force of 1 N",
            values: &[("normal_force", 1.0), ("mu_k", 1.0), ("mu_s", 1.5), ("viscous_coefficient", 0.4)],
        },
        Preset {
            name: "rod_seal",
            source: "Example of the rod seal of a damper: 30 N sliding, 45 N at breakaway, at a contact force of 300 N",
            values: &[
                ("normal_force", 300.0),
                ("stribeck_velocity", 0.01),
                ("sigma_0", 3e5),
                ("sigma_1", 300.0),
                ("viscous_coefficient", 50.0),
            ],
        },
    ];

    released_without_load!(bristle_deflection);

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    names_least_viscous!(|_law| 1.0);

    in_lanes!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn slide(velocity: f64, time: f64) -> LuGre {
        let mut law = LuGre { velocity, ..Default::default() };
        law.step(time);
        law.output();
        law
    }

    /// Equal levels and no damping: Dahl's law with alpha = 1.
    #[test]
    fn reduces_to_dahl() {
        let mut law = LuGre { mu_s: 0.1, sigma_1: 0.0, viscous_coefficient: 0.0, ..Default::default() };
        let mut dahl = crate::friction::Dahl::default();
        for velocity in [1e-3, -2e-3, 5e-4, 3e-2, -1e-5] {
            (law.velocity, dahl.velocity) = (velocity, velocity);
            law.step(3e-3);
            dahl.step(3e-3);
            law.output();
            dahl.output();
            assert_abs_diff_eq!(law.friction_force, dahl.friction_force, epsilon = 1e-15);
            assert_abs_diff_eq!(law.dissipated_energy, dahl.dissipated_energy, epsilon = 1e-18);
        }
    }

    /// At rest a small motion sees a spring and a damper: f = sigma_0 x + (sigma_1 + sigma_2) dx/dt.
    #[test]
    fn small_motion_meets_spring_and_damper() {
        let law = slide(1e-7, 1e-3);
        let expected = 1e5 * 1e-10 + 316.327_766 * 1e-7;
        assert_abs_diff_eq!(law.friction_force / expected, 1.0, epsilon = 1e-4);
    }

    /// Energy balance: the input is stored in the bristles or dissipated, and the dissipated part is not negative.
    #[test]
    fn energy_is_the_integral_of_power() {
        let mut law = LuGre::default();
        let (mut integral, n) = (0.0, 200_000);
        for k in 0..n {
            law.velocity = 2e-3 * f64::cos(20.0 * k as f64 / n as f64);
            law.output();
            let before = law.dissipated_power;
            law.step(0.01 / n as f64);
            law.output();
            integral += 0.5 * (before + law.dissipated_power) * 0.01 / n as f64;
        }
        assert_abs_diff_eq!(law.dissipated_energy / integral, 1.0, epsilon = 1e-8);
    }

    /// From full stiction a jump to 0.1 m/s: f = f_s + sigma_1 v (1 - f_s / g) + sigma_2 v, about -14.3 N.
    #[test]
    fn velocity_dependent_damping_removes_the_spike() {
        let stuck = LuGre { velocity: 0.1, bristle_deflection: 1.4715e-5, ..Default::default() };
        let mut printed = stuck;
        printed.output();
        assert!((printed.friction_force + 14.33).abs() < 0.01, "{}", printed.friction_force);
        let mut faded = LuGre { damping_velocity: 0.001, ..stuck };
        faded.output();
        assert!((faded.friction_force - 1.4815).abs() < 1e-9, "{}", faded.friction_force);
    }
}
