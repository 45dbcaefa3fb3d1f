use crate::contact::conditions::not_below;
use crate::contact::quantities::*;
use crate::contact::time_stepping::{Curve, TimeStepping, memoryless};
use crate::laws::{stribeck, viscous};
use crate::model::{Fault, Model, Preset};
use crate::number::{Real, choose};

crate::model! {
    /// Stribeck friction that differs by direction: levels, Stribeck velocity and viscous coefficient of their own for
    /// forward and backward motion, as gears, screws and seals have them, and a contact that holds at rest.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = f_Cp + (f_sp - f_Cp) exp(-(|v| / v_Sp)^delta) + f_vp v         v > 0
    /// f_f = -f_Cn - (f_sn - f_Cn) exp(-(|v| / v_Sn)^delta) + f_vn v        v < 0
    /// f_f = min(f_e, f_sp)                                                 v = 0, f_e >= 0
    /// f_f = max(f_e, -f_sn)                                                v = 0, f_e <  0
    /// f_Cp = mu_kp f_n,   f_sp = mu_sp f_n,   f_Cn = mu_kn f_n,   f_sn = mu_sn f_n
    /// ```
    ///
    /// With `mass` $m > 0$ the force over a step $h$ is that of the velocity $w$ at its end; the jump at rest is part
    /// of $f_f$. Of several solutions it is the first one reached from $v$ in the direction of the acceleration
    /// (implicit Euler; time stepping in the sense of Moreau):
    ///
    /// ```text
    /// m (w - v) / h = f_e - f_f(w)
    /// ```
    ///
    /// | symbol | variable                       | unit  | meaning                                         |
    /// |--------|--------------------------------|-------|-------------------------------------------------|
    /// | v      | `velocity`                     | m/s   | velocity of body 1 relative to body 2           |
    /// | f_n    | `normal_force`                 | N     | force pressing the surfaces together            |
    /// | f_e    | `external_force`               | N     | all other tangential forces on body 1           |
    /// | mu_kp  | `mu_k_forward`                 | 1     | kinetic coefficient of friction forward         |
    /// | mu_kn  | `mu_k_backward`                | 1     | kinetic coefficient of friction backward        |
    /// | mu_sp  | `mu_s_forward`                 | 1     | static coefficient of friction forward          |
    /// | mu_sn  | `mu_s_backward`                | 1     | static coefficient of friction backward         |
    /// | v_Sp   | `stribeck_velocity_forward`    | m/s   | Stribeck velocity forward                       |
    /// | v_Sn   | `stribeck_velocity_backward`   | m/s   | Stribeck velocity backward                      |
    /// | delta  | `stribeck_exponent`            | 1     | exponent of both curves                         |
    /// | f_vp   | `viscous_coefficient_forward`  | N.s/m | viscous coefficient forward                     |
    /// | f_vn   | `viscous_coefficient_backward` | N.s/m | viscous coefficient backward                    |
    /// | m      | `mass`                         | kg    | effective mass of the host, 0 = the printed law |
    /// | h      | `step_size`                    | s     | last communication step                         |
    /// | f_f    | `friction_force`               | N     | friction force                                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding and the sign of `external_force` when stuck; body 1
    /// feels `-friction_force`. Forward is a positive `velocity`; at rest the level of the direction counts in which
    /// `external_force` pushes. Dissipated power is `friction_force * velocity`; outside rest it is never negative: the
    /// law is passive.
    ///
    /// # Step
    /// Without `mass` the law has no memory; only the dissipated energy is integrated, exactly for held inputs. A host
    /// that integrates the body itself never reaches $v = 0$ exactly, so the force of a contact at rest then alternates
    /// at any step. With `mass` the body is caught where it comes to rest and neither chatters nor creeps; there is no
    /// largest step. In Model Exchange a contact is held or slides in one direction from one event to the next. A held
    /// contact returns `external_force`: connect it, or the body is released and caught again endlessly.
    ///
    #[doc = include_str!("coupling.md")]
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s_forward` < `mu_k_forward`; `mu_s_backward` < `mu_k_backward`.
    ///
    /// # Limits
    /// Equal values of both directions are `Stribeck` with `curve` = BoPavelescu, to the last bit. No pre-sliding
    /// displacement. Equal coefficients of a direction are Coulomb friction with viscous part there. A falling branch
    /// takes a driven body through stick-slip; with `mass` a step longer than about $m v_S / (f_s - f_C)$ crosses it in
    /// one go. `normal_force` = 0 releases the contact: force 0, also of the viscous part. `sticking` means that the
    /// step ends at rest or, without `mass`, that $v = 0$ and $f_e$ is within $-f_sn$ and $f_sp$.
    ///
    /// The force of a contact that slides to and fro with levels $f_Cp$ and $f_Cn$ is that with their mean in both
    /// directions and a constant force of half their difference, such as gravity or the offset of a load cell; what
    /// slides cannot tell the two apart. A strut does not have the law: its contacts have the same levels in both
    /// directions.
    ///
    /// # Source
    /// Coulomb and viscous friction by direction: P. I. Corke, "A robotics toolbox for MATLAB" (1996), IEEE Robotics
    /// and Automation Magazine 3 (1), 24-32, doi:10.1109/100.486658, with two values of $T_c$; a falling level that need
    /// not be symmetrical: Canudas de Wit et al. (1995), IEEE Transactions on Automatic Control 40, 419-425,
    /// doi:10.1109/9.376053; viscous coefficients of both directions: the first preset. The form of the curve is that of
    /// Bo and Pavelescu (1982), doi:10.1016/0043-1648(82)90274-8, with $v_S$ as in `Stribeck`; the one exponent for both
    /// directions, $v_S = 0.001$ m/s and $delta = 2$ are chosen. Time stepping: Moreau (1988),
    /// doi:10.1007/978-3-7091-2624-0_1. The choice `exchange` is our addition.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::DirectionalStribeck;
    /// use stribeck::model::Law;
    /// let mut law = DirectionalStribeck { velocity: 2.0, mu_k_forward: 0.2, mu_s_forward: 0.3, ..Default::default() };
    /// law.viscous_coefficient_backward = 0.5;
    /// law.output();
    /// assert!((law.friction_force - 1.962).abs() < 1e-15); // mu_k_forward f_n
    /// law.velocity = -2.0;
    /// law.output();
    /// assert!((law.friction_force + 0.981 + 1.0).abs() < 1e-15); // -mu_k_backward f_n + 0.5 v
    /// ```
    DirectionalStribeck: "Stribeck friction that differs by direction" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        external_force: input = EXTERNAL_FORCE,
        mu_k_forward: tunable = MU_K.help("Kinetic coefficient of friction at positive velocity."),
        mu_k_backward: tunable = MU_K.help("Kinetic coefficient of friction at negative velocity."),
        mu_s_forward: tunable = MU_S
            .help("Static coefficient of friction towards positive velocity; not less than mu_k_forward."),
        mu_s_backward: tunable = MU_S
            .help("Static coefficient of friction towards negative velocity; not less than mu_k_backward."),
        stribeck_velocity_forward: tunable = STRIBECK_VELOCITY
            .help("Positive velocity at which the excess of static over kinetic friction has fallen to 1/e."),
        stribeck_velocity_backward: tunable = STRIBECK_VELOCITY
            .help("Magnitude of the negative velocity at which the excess of static friction has fallen to 1/e."),
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        viscous_coefficient_forward: tunable = VISCOUS_COEFFICIENT
            .help("Viscous friction coefficient at positive velocity."),
        viscous_coefficient_backward: tunable = VISCOUS_COEFFICIENT
            .help("Viscous friction coefficient at negative velocity."),
        /// Data for co-simulation with a body of known mass.
        time_stepping: (TimeStepping),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// The value of the direction of a velocity or force.
#[inline(always)]
fn of_direction<T: Real>(along: T, forward: T, backward: T) -> T {
    choose!(along.below(T::zero()), backward, forward)
}

impl<T: Real> Curve<T> for DirectionalStribeck<T> {
    #[inline(always)]
    fn curve(&self, velocity: T) -> T {
        let of = |forward, backward| of_direction(velocity, forward, backward);
        let coulomb = of(self.mu_k_forward, self.mu_k_backward) * self.normal_force;
        let v_s = of(self.stribeck_velocity_forward, self.stribeck_velocity_backward);
        let level = stribeck::level(velocity, coulomb, self.level_against(velocity), v_s, self.stribeck_exponent);
        let coefficient = of(self.viscous_coefficient_forward, self.viscous_coefficient_backward);
        level * velocity.sign() + viscous::force(velocity, coefficient, self.normal_force)
    }

    #[inline(always)]
    fn level(&self) -> T {
        self.mu_s_forward.larger(self.mu_s_backward) * self.normal_force
    }

    #[inline(always)]
    fn level_against(&self, force: T) -> T {
        of_direction(force, self.mu_s_forward, self.mu_s_backward) * self.normal_force
    }

    #[inline(always)]
    fn band(&self) -> Option<T> {
        None
    }
}

memoryless!(DirectionalStribeck);

impl Model for DirectionalStribeck {
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "openarm_joint_1",
            source: "enactic/openarm, issue 103 (2025), axis 1: N.m and N.m.s/rad, here at a normal force of 1; no \
                     static level known",
            values: &[
                ("normal_force", 1.0),
                ("mu_k_forward", 0.560),
                ("mu_k_backward", 0.584),
                ("mu_s_forward", 0.560),
                ("mu_s_backward", 0.584),
                ("viscous_coefficient_forward", 0.562),
                ("viscous_coefficient_backward", 0.482),
            ],
        },
        Preset {
            name: "puma_560_joint_1",
            source: "Robotics Toolbox of P. Corke, model of the Puma 560: N.m and N.m.s/rad of the motor, here at a \
                     normal force of 1; no static level known",
            values: &[
                ("normal_force", 1.0),
                ("mu_k_forward", 0.395),
                ("mu_k_backward", 0.435),
                ("mu_s_forward", 0.395),
                ("mu_s_backward", 0.435),
                ("viscous_coefficient_forward", 1.48e-3),
                ("viscous_coefficient_backward", 1.48e-3),
            ],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        not_below(("mu_s_forward", self.mu_s_forward), ("mu_k_forward", self.mu_k_forward))?;
        not_below(("mu_s_backward", self.mu_s_backward), ("mu_k_backward", self.mu_k_backward))
    }

    memoryless!();
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::friction::Stribeck;
    use crate::model::Law;

    /// Levels of 1 and 1.5 N forward, 2 and 4 N backward, at a load of 10 N.
    fn directional(velocity: f64, external_force: f64) -> DirectionalStribeck {
        DirectionalStribeck {
            velocity,
            external_force,
            normal_force: 10.0,
            mu_k_forward: 0.1,
            mu_s_forward: 0.15,
            mu_k_backward: 0.2,
            mu_s_backward: 0.4,
            stribeck_velocity_backward: 0.01,
            viscous_coefficient_forward: 3.0,
            viscous_coefficient_backward: 5.0,
            ..Default::default()
        }
    }

    fn force(mut law: DirectionalStribeck) -> f64 {
        law.output();
        law.friction_force
    }

    #[test]
    fn each_direction_has_its_curve() {
        let excess = (-1.0f64).exp();
        for (velocity, expected) in [
            (1e-12, 1.5),
            (1e-3, 1.0 + 0.5 * excess + 0.003),
            (2.0, 7.0),
            (-1e-12, -4.0),
            (-0.01, -2.0 - 2.0 * excess - 0.05),
            (-2.0, -12.0),
        ] {
            assert_abs_diff_eq!(force(directional(velocity, 0.0)), expected, epsilon = 1e-10);
        }
    }

    /// As printed: the external force between -4 and 1.5 N, which a body at rest feels back.
    #[test]
    fn a_contact_at_rest_holds_up_to_the_level_of_the_direction() {
        for (load, expected, sticks) in [
            (1.4, 1.4, true),
            (1.5, 1.5, true),
            (1.6, 1.5, false),
            (-1.6, -1.6, true),
            (-3.9, -3.9, true),
            (-4.1, -4.0, false),
            (0.0, 0.0, true),
        ] {
            let mut law = directional(0.0, load);
            law.output();
            assert_eq!((law.friction_force, law.sticking == 1.0), (expected, sticks), "{load}");
        }
    }

    #[test]
    fn a_static_level_below_the_kinetic_one_of_its_direction_is_refused() {
        let fault = |law: DirectionalStribeck| law.check().unwrap_err().0;
        let law = DirectionalStribeck::default();
        let text = fault(DirectionalStribeck { mu_s_forward: 0.05, ..law });
        assert_eq!(text, "mu_s_forward = 0.05: must be >= mu_k_forward = 0.1");
        let text = fault(DirectionalStribeck { mu_k_backward: 0.3, ..law });
        assert_eq!(text, "mu_s_backward = 0.15: must be >= mu_k_backward = 0.3");
        assert!(DirectionalStribeck { mu_s_backward: 0.3, mu_k_backward: 0.3, ..law }.check().is_ok());
    }

    /// Stribeck's law in the form of Bo and Pavelescu.
    fn even(law: &DirectionalStribeck) -> Stribeck {
        Stribeck {
            velocity: law.velocity,
            normal_force: law.normal_force,
            external_force: law.external_force,
            curve: 2.0,
            mu_k: law.mu_k_forward,
            mu_s: law.mu_s_forward,
            stribeck_velocity: law.stribeck_velocity_forward,
            stribeck_exponent: law.stribeck_exponent,
            viscous_coefficient: law.viscous_coefficient_forward,
            time_stepping: law.time_stepping,
            ..Default::default()
        }
    }

    /// Equal values of both directions, along a motion with jumps, turns and rest, with and without mass, in either
    /// order of the exchange.
    #[test]
    fn equal_directions_are_stribeck_to_the_last_bit() {
        for (mass, exchange) in [(0.0, 1.0), (0.3, 1.0), (0.3, 2.0)] {
            for exponent in [2.0, 1.0, 0.7] {
                let mut law = DirectionalStribeck { stribeck_exponent: exponent, ..Default::default() };
                (law.viscous_coefficient_forward, law.viscous_coefficient_backward) = (0.7, 0.7);
                (law.time_stepping.mass, law.time_stepping.exchange) = (mass, exchange);
                let mut other = even(&law);
                for at in 0..2000 {
                    let phase = f64::from(at) * 0.37;
                    let velocity = if at % 7 == 0 { 0.0 } else { 3e-3 * phase.sin() * (0.11 * phase).cos().powi(3) };
                    let load = 2.0 * (1.3 * phase).cos();
                    (law.velocity, law.external_force) = (velocity, load);
                    (other.velocity, other.external_force) = (velocity, load);
                    law.step(1e-3);
                    other.step(1e-3);
                    law.output();
                    other.output();
                    let bits = [law.friction_force, law.sticking, law.dissipated_energy].map(f64::to_bits);
                    let expected = [other.friction_force, other.sticking, other.dissipated_energy].map(f64::to_bits);
                    assert_eq!(bits, expected, "{mass} {exchange} {exponent} {at}");
                }
            }
        }
    }

    /// A block of 2 kg, 1 ms, semi-implicit Euler: the force of the step moves it.
    fn moved(load: f64, velocity: f64, steps: u32) -> (f64, f64) {
        let mut law = directional(velocity, load);
        law.time_stepping.mass = 2.0;
        for _ in 0..steps {
            law.step(1e-3);
            law.output();
            law.velocity += 1e-3 * (load - law.friction_force) / 2.0;
        }
        (law.velocity, law.friction_force)
    }

    /// By hand: held between -4 and 1.5 N; beyond them it starts with (1.6 - 1.5) h / m and (-4.1 + 4) h / m at first.
    #[test]
    fn with_mass_a_body_rests_between_both_levels() {
        for load in [1.49, 0.3, -1.6, -3.99] {
            assert_eq!(moved(load, 0.0, 1000), (0.0, load), "{load}");
        }
        for (load, start) in [(1.6, 5e-5), (-4.1, -5e-5)] {
            let (velocity, _) = moved(load, 0.0, 1);
            // Viscous force and fall of the level change it by little.
            assert_abs_diff_eq!(velocity / start, 1.0, epsilon = 0.02);
        }
    }

    /// The same contact turned round.
    #[test]
    fn exchanged_directions_mirror_the_motion() {
        for (mass, exchange) in [(0.0, 1.0), (0.3, 1.0), (0.3, 2.0)] {
            let mut law = directional(0.0, 0.0);
            (law.time_stepping.mass, law.time_stepping.exchange) = (mass, exchange);
            let mut turned = DirectionalStribeck {
                mu_k_forward: law.mu_k_backward,
                mu_k_backward: law.mu_k_forward,
                mu_s_forward: law.mu_s_backward,
                mu_s_backward: law.mu_s_forward,
                stribeck_velocity_forward: law.stribeck_velocity_backward,
                stribeck_velocity_backward: law.stribeck_velocity_forward,
                viscous_coefficient_forward: law.viscous_coefficient_backward,
                viscous_coefficient_backward: law.viscous_coefficient_forward,
                ..law
            };
            for at in 0..500 {
                let phase = f64::from(at) * 0.37;
                (law.velocity, law.external_force) = (3e-3 * phase.sin().powi(5), 5.0 * (1.3 * phase).cos());
                (turned.velocity, turned.external_force) = (-law.velocity, -law.external_force);
                for law in [&mut law, &mut turned] {
                    law.step(1e-3);
                    law.output();
                }
                let expected = [-law.friction_force, law.sticking, law.dissipated_energy];
                assert_eq!([turned.friction_force, turned.sticking, turned.dissipated_energy], expected, "{at}");
            }
        }
    }

    /// Thrown backward under 2.5 N: it stops, held by neither direction's level, and slides forward; under -2.5 N and
    /// thrown forward it stops and is held by the level backward.
    #[test]
    fn a_thrown_body_is_caught_by_the_level_of_its_load() {
        let (velocity, _) = moved(2.5, -0.05, 400);
        assert!(velocity > 0.05, "{velocity}");
        let (velocity, held) = moved(-2.5, 0.05, 400);
        assert_abs_diff_eq!(velocity, 0.0, epsilon = 1e-15);
        assert_abs_diff_eq!(held, -2.5, epsilon = 1e-12);
    }
}
