use crate::contact::quantities::*;
use crate::contact::unloading;
use crate::model::ramp;
use crate::model::{
    self, Bonds, Derivatives, Fault, Law, MOST_BONDS, Meaning, Model, Preset, Surface, WithHistory, integer, real,
};
use crate::number::{Mask, Real, Scalar};

crate::choices! {
    /// State of the bristles when the motion starts.
    pub enum InitialBonds {
        /// All are bonded in place, so they snap together at the first breakaway.
        Bonded,
        /// As after a long slide in the direction of the first motion.
        Stationary,
    }
}

crate::part! {
    /// A bond between the surfaces.
    Bond {
        /// Strain of the bristle, x - b_i.
        strain: state = real("m", 0.0).nominal(1e-5).shown_in("um").odd().means(Meaning::Strain),
        /// Random numbers that the bristle has used.
        draws: state = real("1", 0.0).at_least(0.0),
    }
}

crate::model! {
    /// Bristle friction (Haessig and Friedland): bonds that snap one by one and form again at random places, so that
    /// the force of a sliding contact fluctuates as measured friction does.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_f = sum_i sigma_i (x - b_i),  i = 1 .. N                                        (7.7)
    /// |x - b_i| >= delta:   b_i <- b_i + uniform(0, Delta) sgn(x - b_i)                 (7.8)
    /// dx/dt = v
    /// sigma_i = f_s / (N delta),   Delta = 3 delta (1 - f_C / f_s)
    /// f_C = mu_k f_n,   f_s = mu_s f_n
    /// ```
    ///
    /// | symbol  | variable            | unit | meaning                                                |
    /// |---------|---------------------|------|--------------------------------------------------------|
    /// | v       | `velocity`          | m/s  | velocity of body 1 relative to body 2                  |
    /// | f_n     | `normal_force`      | N    | force pressing the surfaces together                   |
    /// | mu_k    | `mu_k`              | 1    | kinetic coefficient of friction: the mean when sliding |
    /// | mu_s    | `mu_s`              | 1    | static coefficient of friction: all bonds at $delta$   |
    /// | delta   | `delta`             | m    | strain at which a bond snaps                           |
    /// | N       | `bristle_count`     | -    | number of bristles                                     |
    /// | -       | `seed`              | -    | selects the sequence of random numbers                 |
    /// | -       | `initial_bonds`     | -    | state of the bristles when the motion starts           |
    /// | x - b_i | `bristle[i].strain` | m    | strain of bristle $i$                                  |
    /// | -       | `bristle[i].draws`  | 1    | random numbers that bristle $i$ has used               |
    /// | f_f     | `friction_force`    | N    | friction force                                         |
    ///
    /// Renewal theory gives for a long slide, where $delta - |x - b_i|$ has the density $2 / Delta (1 - d / Delta)$ on
    /// $[0, Delta]$,
    ///
    /// ```text
    /// mean:                N sigma (delta - Delta / 3) = f_C
    /// standard deviation:  sigma Delta sqrt(N / 18)    = 3 (f_s - f_C) / sqrt(18 N)
    /// first peak:          N sigma delta               = f_s     all bonded at x(0)
    /// initial stiffness:   N sigma                     = f_s / delta
    /// ```
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding, on average; body 1 feels `-friction_force`. Dissipated
    /// power is `friction_force * velocity`; it is negative while the bristles spring back.
    ///
    /// # Step
    /// The law depends on the displacement only. The snaps of a step are followed one by one, at the places where they
    /// happen, so the step is exact and needs no events. The k-th random number of bristle $i$ is a function of seed,
    /// $i$ and k only (the mixing function of SplitMix64), so the same path gives the same force however it is divided
    /// into steps, and a saved and restored instance repeats its future.
    ///
    /// Two step sizes, two tolerances and two masters have the same numbers, as long as no step is longer than that of
    /// the next paragraph.
    ///
    /// A bristle that would slide by more than $20 Delta$ (about 40 snaps) in one step is instead drawn from the
    /// density above, which it approaches as $exp(-2.09 s / Delta)$: the work of a step is bounded, the force is the
    /// same in distribution to 1e-18, and the energy of such a slide is its expectation. With a linearly moving
    /// velocity the displacement, and with it the force, is exact between the instants where it changes sign; the
    /// energy takes the load in the middle, which is of second order. A contact at rest keeps its bonds, however long.
    ///
    /// `sticking` means that the force is less than half (chosen) of $f_C$ in the direction of the motion. Steady
    /// sliding of 25 bristles is 7 standard deviations away from that; a single bristle passes below it occasionally.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below 2 sqrt(m /
    /// k), which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force. If all models
    /// step at once and exchange afterwards, it chatters at every step, since nothing damps the stiffness: take the
    /// friction first.
    ///
    /// A solver that follows the bonds, as the workbench does, integrates the law by its rates: between two snaps all
    /// strains move with $v$, and each bond snaps at its own place within a step, however many do. Model Exchange is not
    /// offered: with the defaults, sliding at 0.1 m/s would ask an importer for 340,000 events in a second. `mu_s` =
    /// `mu_k` is for steps only, because bonds that lose nothing slide.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; `mu_k` < `mu_s` / 3, for which $Delta > 2 delta$ and a
    /// bond could form again beyond its own strength.
    ///
    /// # Limits
    /// No damping and no dependence on the speed; no stiction after the first breakaway other than by chance, because
    /// the bristles stay spread. Steady sliding gives a force against the motion at every instant only if
    /// $Delta <= delta$ (`mu_k` >= 2/3 `mu_s`); below that it does so on average. Passive at constant load: a snap
    /// removes strain energy, $1/2 sigma (delta^2 - (delta - u)^2) >= 0$ for $u <= Delta <= 2 delta$, so from bonded
    /// bristles `dissipated_energy` never becomes negative. A stationary start contains strain energy, at most
    /// $f_s delta / 2$. Strains do not depend on the load, forces are proportional to it. `normal_force` = 0 releases
    /// the contact (force 0, strains 0; the random numbers continue), and the bristles then bond in place. `mu_s` =
    /// `mu_k` has $Delta = 0$: elastic and perfectly plastic, no random numbers.
    ///
    /// # Source
    /// Haessig and Friedland (1991), doi:10.1115/1.2896418; equations (7.7) and (7.8) of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024), where the
    /// argument of sgn and the interval of uniform( ) are lost and $x$ carries an index, though all bristles share it.
    /// $sigma_i$, $Delta$ and $delta = f_s / sigma_0$ follow from the levels and the stiffness 1e5 N/m of Table 7.1;
    /// the choice that the stiffness, not $delta$, is proportional to the load is ours. $N = 25$ is chosen. Random
    /// numbers: Steele, Lea, Flood (2014), doi:10.1145/2660193.2660195.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Bristle;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Bristle { velocity: 1e-4, ..Default::default() };
    /// law.step(0.1); // 10 um, all bonded: a spring of 1e5 N/m
    /// law.output();
    /// assert!((law.friction_force - 1.0).abs() < 1e-12);
    /// ```
    Bristle: "Bonds that snap and form again at random (bristle model)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        /// Strain at which a bristle snaps (default f_s / sigma_0 of the thesis).
        delta: tunable = real("m", 1.4715e-5).positive().nominal(1e-5).shown_in("um").means(Meaning::Own),
        /// Number of bristles (default chosen).
        bristle_count: fixed = integer(25).at_least(1.0).at_most(MOST_BONDS as f64).means(Meaning::Own),
        /// Seed of the random numbers.
        seed: fixed = integer(0).at_least(0.0).means(Meaning::Own),
        /// State of the bristles when the motion starts.
        initial_bonds: fixed = InitialBonds::Bonded.start(),
        /// Bristles; those beyond the count are not used.
        bristle: [Bond; MOST_BONDS],
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// A slide longer than this many Delta is drawn from the stationary density (chosen: exp(-2.09 * 20) = 7e-19).
const LONG: f64 = 20.0;

/// A Delta below this part of delta counts as 0 (chosen), because its snaps would be lost to rounding.
const SMALL: f64 = 1e-9;

/// Part of the mean sliding force below which the contact counts as sticking (chosen).
const STUCK_SHARE: f64 = 0.5;

impl<T: Scalar> Bristle<T> {
    fn count(&self) -> usize {
        self.bristle_count.value() as usize
    }

    /// Eq. (7.7).
    fn force(&self) -> T {
        let strain = self.bristle[..self.count()].iter().fold(T::zero(), |sum, bristle| sum + bristle.strain);
        self.mu_s * self.normal_force * (strain / (self.bristle_count * self.delta))
    }
}

impl<T: Scalar> Law for Bristle<T> {
    type Interface = WithHistory;

    fn output(&mut self) {
        self.friction_force = self.force();
        self.dissipated_power = self.friction_force * self.velocity;
        let coulomb = self.mu_k * self.normal_force;
        let is_outward = (self.friction_force * self.velocity.sign()).at_least(T::from(STUCK_SHARE) * coulomb);
        let sliding = is_outward & !self.velocity.vanishes();
        self.sticking = T::truth(!sliding & coulomb.is_positive());
    }
}

impl<T: Scalar> Derivatives for Bristle<T> {
    /// Between two snaps, with Delta > 0.
    fn derivatives(&self, rate: &mut Self) {
        let count = self.count();
        let velocity = self.normal_force.is_positive().choose(|| self.velocity, T::zero);
        rate.bristle[..count].iter_mut().for_each(|rate| rate.strain = velocity);
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl Bristle {
    /// Delta.
    fn span(&self) -> f64 {
        let span = 3.0 * self.delta * (1.0 - self.mu_k / self.mu_s);
        if span > SMALL * self.delta { span } else { 0.0 }
    }

    fn surface(&self) -> Surface {
        Surface { limit: self.delta, span: self.span(), seed: self.seed }
    }

    fn is_stationary(&self) -> bool {
        InitialBonds::of(self.initial_bonds) == InitialBonds::Stationary
    }

    /// sigma_i = f_s / (N delta).
    fn stiffness(&self) -> f64 {
        self.mu_s * self.normal_force / (self.bristle_count * self.delta)
    }

    /// Moves the surfaces by `displacement` under the present load. Without motion strains have no direction, and no
    /// bond changes.
    fn shift(&mut self, displacement: f64) {
        if displacement == 0.0 {
            return;
        }
        let direction = displacement.sign();
        let (surface, is_stationary) = (self.surface(), self.is_stationary());
        let count = self.count();
        let mut area = 0.0;
        for (number, bond) in self.bristle[..count].iter_mut().enumerate() {
            if is_stationary && bond.draws == 0.0 {
                bond.strain = direction * surface.stationary(number, &mut bond.draws);
            }
            let mut strain = direction * bond.strain;
            area += surface.slide(number, bond, &mut strain, displacement.abs());
            bond.strain = direction * strain;
        }
        // sigma_i = f_s / (N delta).
        self.dissipated_energy += self.mu_s * self.normal_force * (area / (count as f64 * self.delta));
    }

    /// Whether a bond that forms again without a random number slides along at delta.
    fn slides(&self, bond: &Bond) -> bool {
        self.span() == 0.0 && bond.strain * self.velocity.sign() >= self.delta
    }

    fn release(&mut self) {
        for bond in &mut self.bristle {
            bond.strain = 0.0;
        }
    }
}

impl Model for Bristle {
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "thesis",
            source: "Novais (2024), Tables 6.1 and 7.1 for levels and stiffness; 25 bristles chosen (the start values)",
            values: &[],
        },
        Preset {
            name: "haessig_friedland_stationary",
            source: "Example: the start values without the first peak, in which all bristles snap together",
            values: &[("initial_bonds", 2.0)],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)?;
        if self.span() > 2.0 * self.delta {
            let least = self.mu_s / 3.0;
            return Err(Fault::new(format_args!("mu_k = {}: must be >= mu_s / 3 = {least}", self.mu_k)));
        }
        Ok(())
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        if self.span() > 0.0 {
            return Ok(());
        }
        let text = "must be > mu_k where rates are integrated: bonds that do not snap slide, which only steps know";
        Err(Fault::new(format_args!("mu_s = {}: {text}", self.mu_s)))
    }

    const EVENT_INDICATORS: usize = 1;

    fn event_indicators(&self, indicators: &mut [f64]) {
        indicators[0] = unloading::load(self.normal_force);
    }

    fn at_event(&mut self) {
        if unloading::is_unloaded(self.normal_force) {
            self.release();
        }
    }

    fn bonds(&self) -> Option<Bonds> {
        let bond = |(number, bond): (usize, &Bond)| model::Bond { number, strain: bond.strain, draws: bond.draws };
        let bonds = self.bristle[..self.count()].iter().enumerate().map(bond);
        let bonds = Bonds::new(self.surface(), self.stiffness(), self.dissipated_energy, bonds);
        Some(if self.is_stationary() { bonds.waiting() } else { bonds })
    }

    fn put_bonds(&mut self, bonds: &Bonds, shift: f64) {
        for model::Bond { number, strain, draws } in bonds.iter() {
            self.bristle[number] = Bond { strain: strain + shift, draws };
        }
        self.dissipated_energy = bonds.energy();
    }

    fn step(&mut self, dt: f64) {
        if self.normal_force <= 0.0 {
            self.release();
        } else {
            self.shift(self.velocity * dt);
        }
    }

    /// Between the instants at which the velocity changes sign only the displacement counts.
    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        let begin = ramp::Inputs::of(self);
        let (velocity, normal_force) = (self.velocity, self.normal_force);
        let reversal = -velocity / slope.velocity;
        let turn = if reversal > 0.0 && reversal < dt { reversal } else { dt };
        for (from, to) in [(0.0, turn), (turn, dt)] {
            if from < to {
                let middle = 0.5 * (from + to);
                self.velocity = velocity + slope.velocity * middle;
                self.normal_force = normal_force + slope.normal_force * middle;
                self.step(to - from);
            }
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }

    fn rate(&self, rate: &mut Self) {
        if self.normal_force > 0.0 {
            let count = self.count();
            for (rate, bond) in rate.bristle[..count].iter_mut().zip(&self.bristle) {
                rate.strain = if self.slides(bond) { 0.0 } else { self.velocity };
            }
        }
        rate.dissipated_energy = self.force() * self.velocity;
    }
}

impl Surface {
    /// Moves a bristle by `distance` in the direction in which `strain` is counted. Returns the integral of the strain.
    fn slide(&self, number: usize, bond: &mut Bond, strain: &mut f64, distance: f64) -> f64 {
        let mut left = distance;
        let mut area = 0.0;
        // A strain beyond delta (set by the user, or after delta was lowered) snaps at once.
        loop {
            let stretch = left.min((self.limit - *strain).max(0.0));
            area += stretch * (*strain + 0.5 * stretch);
            left -= stretch;
            if left <= 0.0 {
                *strain += stretch;
                return area;
            }
            *strain = self.limit;
            if left > LONG * self.span {
                return area + self.jump(number, bond, strain, left);
            }
            *strain -= self.span * self.draw(number, &mut bond.draws);
        }
    }

    /// A long slide from delta on: the strain is stationary at its end. With sums over the snaps u, of which the
    /// squares have the expectation 2/3 Delta u, the integral of the strain is
    ///
    /// ```text
    /// 1/2 (strain^2 - delta^2) + delta sum(u) - 1/2 sum(u^2),   sum(u) = distance + delta - strain
    /// ```
    fn jump(&self, number: usize, bond: &mut Bond, strain: &mut f64, distance: f64) -> f64 {
        if self.span == 0.0 {
            return self.limit * distance;
        }
        *strain = self.stationary(number, &mut bond.draws);
        let missing = self.limit - *strain;
        (self.limit - self.span / 3.0) * (distance + missing) - missing * (self.limit - 0.5 * missing)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn moved(law: &Bristle, displacement: f64) -> Bristle {
        let mut law = Bristle { velocity: displacement, ..*law };
        law.step(1.0);
        law.output();
        law
    }

    /// However a path is divided, the same bonds snap at the same positions.
    #[test]
    fn force_does_not_depend_on_the_steps() {
        let mut whole = Bristle::default();
        let mut parts = Bristle::default();
        for leg in [1e-4, -2e-5, 3e-6, -2.5e-4, 1e-4, 0.0, 2e-6] {
            whole = moved(&whole, leg);
            for _ in 0..100 {
                parts = moved(&parts, leg / 100.0);
            }
            assert_abs_diff_eq!(whole.friction_force, parts.friction_force, epsilon = 1e-12);
            assert_abs_diff_eq!(whole.dissipated_energy, parts.dissipated_energy, epsilon = 1e-16);
            assert!(whole.bristle.iter().zip(&parts.bristle).all(|(a, b)| a.draws == b.draws));
        }
    }

    /// The energy is the sum of what the springs hold and what the snaps removed: the fine sum of force times distance.
    #[test]
    fn energy_is_the_integral_of_force_over_distance() {
        for law in
            [Bristle::default(), Bristle { initial_bonds: 2.0, mu_s: 0.29, bristle_count: 3.0, ..Default::default() }]
        {
            let (mut sum, mut fine, n) = (0.0, law, 200_000);
            for leg in [1e-4, -1.3e-4] {
                for _ in 0..n {
                    fine = moved(&fine, 0.5 * leg / f64::from(n));
                    sum += fine.friction_force * leg / f64::from(n);
                    fine = moved(&fine, 0.5 * leg / f64::from(n));
                }
            }
            let energy = moved(&moved(&law, 1e-4), -1.3e-4).dissipated_energy;
            assert!((energy / sum - 1.0).abs() < 1e-4, "{energy} {sum}");
        }
    }

    /// A slide of any length costs the same: 40 snaps per bristle are followed, the rest is drawn.
    #[test]
    fn long_slides_are_drawn() {
        for distance in [1e-3, 1.0, 1e9] {
            let law = moved(&Bristle::default(), distance);
            assert!(law.bristle.iter().take(25).all(|bristle| bristle.draws == 1.0));
            assert!(law.bristle.iter().take(25).all(|bristle| (0.0..=1.4715e-5).contains(&bristle.strain)));
            // f_C times the distance, less the rise and the energy still in the springs.
            assert_abs_diff_eq!(law.dissipated_energy, 0.981 * distance, epsilon = 2.0 * 1.4715 * 1.4715e-5);
        }
    }

    /// The expected energy of a drawn slide against slides that are followed, over 400 seeds: 4 standard errors.
    #[test]
    fn energy_of_a_drawn_slide_is_the_mean_of_followed_slides() {
        let (mut difference, mut square, n) = (0.0, 0.0, 400);
        for seed in 0..n {
            let law = Bristle { seed: f64::from(seed), ..Default::default() };
            let drawn = moved(&law, 1e-3);
            let followed = (0..10).fold(law, |law, _| moved(&law, 1e-4));
            let gap = drawn.dissipated_energy - followed.dissipated_energy;
            difference += gap / f64::from(n);
            square += gap * gap / f64::from(n);
        }
        let error = ((square - difference * difference) / f64::from(n)).sqrt();
        assert!(difference.abs() < 4.0 * error && error < 1e-3 * 0.981e-3, "{difference} {error}");
    }

    #[test]
    fn equal_levels_are_elastic_and_perfectly_plastic_without_random_numbers() {
        let law = moved(&Bristle { mu_s: 0.1, ..Default::default() }, 2e-5);
        assert!((law.friction_force - 0.981).abs() < 1e-15 && law.bristle[0].draws == 0.0);
        assert_abs_diff_eq!(moved(&law, -1e-5).friction_force, 0.981 - 0.981 / 1.4715, epsilon = 1e-12);
    }

    #[test]
    fn bonds_that_would_form_beyond_their_strength_are_refused() {
        let law = Bristle { mu_s: 0.4, ..Default::default() };
        assert!(law.check().unwrap_err().0.starts_with("mu_k = 0.1: must be >= mu_s / 3 = 0.13"));
    }
}
