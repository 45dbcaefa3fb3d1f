use crate::host::oscillator::undamped;
use crate::host::vertical::GRAVITY;
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, ramp, real};
use crate::number::Real;

crate::model! {
    /// Two blocks, one lying on the other, that both move: under forces, and on springs to the ground if wanted.
    ///
    /// # Equations
    ///
    /// ```text
    /// m_1 d2x_1/dt2 = F_1 - k_1 x_1 - f_f
    /// m_2 d2x_2/dt2 = F_2 - k_2 x_2 + f_f
    /// v   = dx_1/dt - dx_2/dt
    /// f_e = (m_2 (F_1 - k_1 x_1) - m_1 (F_2 - k_2 x_2)) / (m_1 + m_2)
    /// f_n = m_1 g
    /// m   = m_1 m_2 / (m_1 + m_2)
    /// ```
    ///
    /// | symbol  | variable         | unit | meaning                                               |
    /// |---------|------------------|------|-------------------------------------------------------|
    /// | f_f     | `friction_force` | N    | friction force between the blocks                     |
    /// | F_1     | `force_1`        | N    | force on block 1                                      |
    /// | F_2     | `force_2`        | N    | force on block 2                                      |
    /// | m_1     | `mass_1`         | kg   | mass of block 1, which lies on block 2                |
    /// | m_2     | `mass_2`         | kg   | mass of block 2                                       |
    /// | k_1     | `stiffness_1`    | N/m  | stiffness of a spring from block 1 to the ground      |
    /// | k_2     | `stiffness_2`    | N/m  | stiffness of a spring from block 2 to the ground      |
    /// | g       | `gravity`        | m/s2 | acceleration of gravity                               |
    /// | x_1     | `position_1`     | m    | position of block 1, spring relaxed at 0              |
    /// | dx_1/dt | `velocity_1`     | m/s  | velocity of block 1                                   |
    /// | x_2     | `position_2`     | m    | position of block 2, spring relaxed at 0              |
    /// | dx_2/dt | `velocity_2`     | m/s  | velocity of block 2                                   |
    /// | v       | `velocity`       | m/s  | velocity of block 1 relative to block 2               |
    /// | f_e     | `external_force` | N    | force that a contact must carry to stick              |
    /// | f_n     | `normal_force`   | N    | weight of block 1 on block 2                          |
    /// | m       | `effective_mass` | kg   | mass of the relative motion                           |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding: block 1 feels `-friction_force`, block 2 feels
    /// `+friction_force`. Forces, positions and velocities are positive in the same direction.
    ///
    /// # Step
    /// For a given friction force the blocks are two linear systems, so the step is exact for held inputs and for
    /// inputs that move linearly. Outputs follow from states and external forces: there is no direct feed-through of
    /// the friction force.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// Block 2 rests on the ground without friction. The friction force comes from the master: held over a step, it
    /// makes the coupling a method of first order. A law with a `mass` needs `effective_mass` there.
    ///
    /// # Source
    /// Newton's laws; mass and force of the relative motion as in textbooks on the two-body problem. The masses are
    /// chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::TwoBlocks;
    /// use stribeck::model::Law;
    /// let mut blocks = TwoBlocks { force_1: 3.0, ..Default::default() };
    /// blocks.output();
    /// assert_eq!(blocks.external_force, 2.0); // 1 kg on 2 kg: friction must give 2 N so that both have 1 m/s2
    /// ```
    TwoBlocks: "Two blocks, one on the other, under forces and on springs" {
        /// Friction force; has the sign of the velocity when sliding. Body 1 feels its negative.
        friction_force: input = real("N", 0.0).means(Meaning::FrictionForce),
        /// Force on block 1.
        force_1: input = real("N", 0.0),
        /// Force on block 2.
        force_2: input = real("N", 0.0),
        /// Mass of block 1, which lies on block 2.
        mass_1: fixed = real("kg", 1.0).positive(),
        /// Mass of block 2 (default chosen).
        mass_2: fixed = real("kg", 2.0).positive(),
        /// Stiffness of the spring from block 1 to the ground; 0 = none.
        stiffness_1: fixed = real("N/m", 0.0).at_least(0.0),
        /// Stiffness of the spring from block 2 to the ground; 0 = none.
        stiffness_2: fixed = real("N/m", 0.0).at_least(0.0),
        /// Acceleration of gravity.
        gravity: tunable = real("m/s2", GRAVITY).at_least(0.0),
        /// Position of block 1; its spring is relaxed at 0.
        position_1: state_output = real("m", 0.0).nominal(1e-2),
        /// Velocity of block 1.
        velocity_1: state_output = real("m/s", 0.0).nominal(0.1),
        /// Position of block 2; its spring is relaxed at 0.
        position_2: state_output = real("m", 0.0).nominal(1e-2),
        /// Velocity of block 2.
        velocity_2: state_output = real("m/s", 0.0).nominal(0.1),
        /// Velocity of block 1 relative to block 2.
        velocity: output = real("m/s", 0.0).means(Meaning::Velocity),
        /// Force that the contact must carry so that both blocks move together.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
        /// Weight of block 1 on block 2.
        normal_force: output = real("N", 0.0).means(Meaning::NormalForce),
        /// Effective mass of the relative motion.
        effective_mass: output = real("kg", 1.0),
    }
}

impl<T: Real> TwoBlocks<T> {
    /// Forces on the blocks other than friction.
    fn others(&self) -> [T; 2] {
        [self.force_1 - self.stiffness_1 * self.position_1, self.force_2 - self.stiffness_2 * self.position_2]
    }

    fn accelerations(&self) -> [T; 2] {
        let [on_1, on_2] = self.others();
        [(on_1 - self.friction_force) / self.mass_1, (on_2 + self.friction_force) / self.mass_2]
    }
}

impl<T: Real> Law for TwoBlocks<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        let ([on_1, on_2], total) = (self.others(), self.mass_1 + self.mass_2);
        self.velocity = self.velocity_1 - self.velocity_2;
        self.external_force = (self.mass_2 * on_1 - self.mass_1 * on_2) / total;
        self.normal_force = self.mass_1 * self.gravity;
        self.effective_mass = self.mass_1 * self.mass_2 / total;
    }
}

impl<T: Real> Derivatives for TwoBlocks<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.position_1 = self.velocity_1;
        rate.position_2 = self.velocity_2;
        [rate.velocity_1, rate.velocity_2] = self.accelerations();
    }
}

impl TwoBlocks {
    /// Exact motion while the forces on the blocks move at constant rates.
    fn advance(&mut self, [rate_1, rate_2]: [f64; 2], t: f64) {
        let [a_1, a_2] = self.accelerations();
        let jerk_1 = (rate_1 - self.stiffness_1 * self.velocity_1) / self.mass_1;
        let jerk_2 = (rate_2 - self.stiffness_2 * self.velocity_2) / self.mass_2;
        let (one, two) = ([self.position_1, self.velocity_1], [self.position_2, self.velocity_2]);
        [self.position_1, self.velocity_1] = undamped(one, [a_1, jerk_1], self.stiffness_1 / self.mass_1, t);
        [self.position_2, self.velocity_2] = undamped(two, [a_2, jerk_2], self.stiffness_2 / self.mass_2, t);
    }
}

impl Model for TwoBlocks {
    const PIECEWISE_LINEAR: bool = true;
    fn step(&mut self, dt: f64) {
        self.advance([0.0; 2], dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        self.advance([slope.force_1 - slope.friction_force, slope.force_2 + slope.friction_force], dt);
        ramp::set_inputs(self, &begin, slope, dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// A contact that carries `external_force` gives both blocks the same acceleration.
    #[test]
    fn blocks_that_stick_move_as_one() {
        let springs = TwoBlocks { stiffness_1: 5.0, stiffness_2: 11.0, position_1: 0.2, position_2: -0.1, ..free() };
        for mut blocks in [free(), springs] {
            blocks.output();
            blocks.friction_force = blocks.external_force;
            let mut rate = blocks;
            blocks.derivatives(&mut rate);
            assert_abs_diff_eq!(rate.velocity_1, rate.velocity_2, epsilon = 1e-15);
        }
    }

    fn free() -> TwoBlocks {
        TwoBlocks { force_1: 1.5, force_2: -0.4, mass_1: 0.7, mass_2: 3.0, velocity_1: 0.3, ..Default::default() }
    }

    /// The effective mass times the relative acceleration is `external_force` less the friction force.
    #[test]
    fn newton_s_law_of_the_relative_motion() {
        let mut blocks = TwoBlocks { friction_force: 0.9, ..free() };
        let mut rate = blocks;
        blocks.output();
        blocks.derivatives(&mut rate);
        let relative = blocks.effective_mass * (rate.velocity_1 - rate.velocity_2);
        assert_abs_diff_eq!(relative, blocks.external_force - 0.9, epsilon = 1e-15);
    }

    /// Friction moves momentum from block to block; only the external forces change the sum. Over 3 s: 1.1 N, and a
    /// mean of 0.2 N/s * 1.5 s.
    #[test]
    fn momentum_comes_from_outside_only() {
        let mut blocks = TwoBlocks { friction_force: 0.9, ..free() };
        let momentum = |blocks: &TwoBlocks| blocks.mass_1 * blocks.velocity_1 + blocks.mass_2 * blocks.velocity_2;
        let (before, still) = (momentum(&blocks), ramp::held_inputs(&blocks));
        let slope = TwoBlocks { friction_force: -3.0, force_1: 0.5, force_2: -0.3, ..still };
        blocks.step_ramp(&slope, 3.0);
        assert_abs_diff_eq!(momentum(&blocks) - before, 3.0 * (1.1 + 0.2 * 1.5), epsilon = 1e-14);
        assert_abs_diff_eq!(blocks.friction_force, -8.1, epsilon = 1e-14);
    }

    /// Energy lost by masses and springs under held friction: the force times the path of block 1 on block 2.
    #[test]
    fn friction_takes_its_force_times_the_sliding_path() {
        let mut blocks = TwoBlocks { stiffness_1: 40.0, stiffness_2: 3.0, friction_force: 0.3, ..free() };
        (blocks.force_1, blocks.force_2) = (0.0, 0.0);
        let energy = |b: &TwoBlocks| {
            let kinetic = b.mass_1 * b.velocity_1.powi(2) + b.mass_2 * b.velocity_2.powi(2);
            0.5 * (kinetic + b.stiffness_1 * b.position_1.powi(2) + b.stiffness_2 * b.position_2.powi(2))
        };
        for dt in [1e-6, 1e-3, 0.1, 3.0, 50.0] {
            let before = blocks;
            blocks.step(dt);
            let path = blocks.position_1 - blocks.position_2 - (before.position_1 - before.position_2);
            assert!((energy(&before) - energy(&blocks) - 0.3 * path).abs() < 1e-14, "{dt}");
        }
    }
}
