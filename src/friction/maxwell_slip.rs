use crate::contact::element_path::{Follower, Path};
use crate::contact::element_slip::{self, EVENTS_OF_ELEMENTS, Onset};
use crate::contact::elements::{self, Division, ElementDistribution, Ramp, Share};
use crate::contact::quantities::*;
use crate::contact::time_stepping::{MOVED, PASSED, Phase, PhaseColumn};
use crate::contact::unloading;
use crate::laws::stribeck;
use crate::model::ramp;
use crate::model::{self, Derivatives, Fault, GivesBack, Law, Meaning, Model, ModelExchange, Preset, Width, real};
use crate::number::{Mask, Real, Scalar, choose};
use crate::numerics::relaxation;

crate::part! {
    /// The state of an element.
    Block {
        force: state = ELEMENT_FORCE.reinit(),
        slipping: state = ELEMENT_SLIPPING,
    }
}

crate::part! {
    /// A Maxwell-slip element: a spring in series with a block that sticks or slips.
    Element {
        /// Share of the element.
        share: (Share),
        /// State of the element.
        block: (Block),
    }
}

/// Elements that have variables.
const LISTED: usize = elements::MOST;

/// Largest number of elements: the thesis uses about as many for a smooth response.
const MOST: usize = 1000;

crate::model! {
    /// Generalised Maxwell-slip friction (GMS): elements in parallel that stick or slip one by one, so that pre-sliding
    /// has hysteresis with non-local memory (inner loops close, as in measurements), which a single bristle cannot
    /// have.
    ///
    /// # Equations
    ///
    /// ```text
    /// dF_i/dt = k_i v                              element sticks              (7.35)
    /// dF_i/dt = C (alpha_i sgn v - F_i / s(v))     element slips               (7.36)
    /// s(v)    = f_C + (f_s - f_C) exp(-(|v| / v_S)^delta)
    /// f_f     = sum_i (F_i + sigma_i dz_i/dt) + f_v v,   z_i = F_i / k_i       (7.37)
    /// f_C = mu_k f_n,   f_s = mu_s f_n,   sum_i alpha_i = 1,   sum_i k_i = sigma_0,   sigma_i = k_i sigma_1 / sigma_0
    /// ```
    ///
    /// An element begins to slip when, moving outwards, $|F_i|$ reaches $alpha_i s(v)$. It sticks again only when $v$
    /// comes to rest or changes sign. `distribution` Explicit takes $k_i / sigma_0$ and $alpha_i$ from the elements,
    /// each relative to their sum; for $N$ elements Uniform has
    ///
    /// ```text
    /// k_i = sigma_0 / N,   alpha_i = (2 i - 1) / N^2,   i = 1 ... N
    /// ```
    ///
    /// so that for many elements the virgin curve is $f_s (1 - (1 - sigma_0 x / (2 f_s))^2)$, to within
    /// $f_s / (4 N^2)$. Up to 1000 elements are possible. The first 64 have variables; a larger number requires
    /// Uniform. All elements are part of a saved state. The time of a step is proportional to $N$.
    ///
    /// | symbol           | variable                     | unit  | meaning                                           |
    /// |------------------|------------------------------|-------|---------------------------------------------------|
    /// | v                | `velocity`                   | m/s   | velocity of body 1 relative to body 2             |
    /// | f_n              | `normal_force`               | N     | force pressing the surfaces together              |
    /// | mu_k             | `mu_k`                       | 1     | kinetic coefficient of friction                   |
    /// | mu_s             | `mu_s`                       | 1     | static coefficient of friction                    |
    /// | v_S              | `stribeck_velocity`          | m/s   | speed at which the level has fallen               |
    /// | delta            | `stribeck_exponent`          | 1     | shape of the falling level                        |
    /// | sigma_0          | `sigma_0`                    | N/m   | stiffness of all elements together                |
    /// | sigma_1          | `sigma_1`                    | N.s/m | damping of all elements together                  |
    /// | f_v              | `viscous_coefficient`        | N.s/m | viscous coefficient                               |
    /// | C                | `attraction`                 | N/s   | how fast slipping elements follow a changed level |
    /// |                  | `distribution`               |       | where the shares come from                        |
    /// | N                | `element_count`              |       | number of elements in use                         |
    /// | k_i / sigma_0    | `element[i].stiffness_share` | 1     | share of an element in the stiffness              |
    /// | alpha_i          | `element[i].strength_share`  | 1     | share of an element in the level                  |
    /// | F_i              | `element[i].force`           | N     | force of an element                               |
    /// |                  | `element[i].slipping`        |       | mode of an element                                |
    /// |                  | `slip`                       |       | direction of slip, as the last event has found it |
    /// | f_f              | `friction_force`             | N     | friction force                                    |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the elements spring back.
    ///
    /// # Step
    /// With held inputs both modes are solved exactly, and the instant at which an element begins to slip is located
    /// inside the step, so the result does not depend on how an interval is divided. `sticking` means that not all
    /// elements slip.
    ///
    /// With linearly moving inputs the step is of second order, in 4 to 19 pieces (chosen): it is cut where $v$ changes
    /// sign and where the level is curved, and in each piece the level counts as linear. The onset of slip is where the
    /// force of the element reaches its moving level.
    ///
    /// A master that integrates a mass m with the force it reads couples it explicitly to the stiffness k of the
    /// contact at rest. If the friction steps first, a held body stays still for communication steps below 2 sqrt(m /
    /// k), which is 6.3 ms for the defaults and 1 kg; above, it chatters within the bounds of the force. If all models
    /// step at once and exchange afterwards, it chatters at every step, since nothing damps the stiffness: take the
    /// friction first.
    ///
    /// In Model Exchange the forces of the 64 elements that have variables are continuous states; those beyond `element_count` rest. An
    /// element begins to slip at an event, where $|F_i|$ reaches $alpha_i s(v)$ while it moves outwards, and all stick
    /// again at the event at which $v$ reverses; in between, `slip` is the direction of slip, and an element follows its
    /// equation whatever values a solver tries. A third event releases the elements where the load vanishes. While all
    /// elements stick, or with $f_s = f_C$, the equations are linear. Elements without damping vibrate, and reverse a
    /// thousand times in some seconds of stick-slip: $sigma_1 > 0$ saves events, and without it a motion beyond the first
    /// breakaway depends on the phase of the vibration, so that it is known to a few thousandths of its amplitude only.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; more than 64 elements with Explicit shares, or in Model
    /// Exchange.
    ///
    /// # Limits
    /// For $sigma_1 = 0$ (default, the form of 2005) a stuck body vibrates without damping on the springs of its
    /// elements; the preset `damped` has the damping of the form of 2003. A stuck element whose level falls below its
    /// force (by a higher speed or a smaller load) begins to slip as soon as it moves outwards, and keeps its force
    /// while it moves inwards. $v = 0$ counts as rest: all elements stick, and the force is held. If the load falls at
    /// rest, the old force is held until there is motion. `normal_force` = 0 releases the contact (force 0, elements
    /// relaxed and sticking). With equal levels ($f_s = f_C$) the elements are elastic and perfectly plastic, and $C$
    /// does not matter. As a Rust struct the law has up to 64 elements, in `GuideContact` and `ShockAbsorber` up to 16;
    /// more need an `Instance`, which is behind every FMU and $C$ handle.
    ///
    /// Passive for $f_s = f_C$ and a constant load. Otherwise not: a slipping element that slows down gains force, and
    /// with it elastic energy, without moving. Each rise of the level from $f_C$ to $f_s$ can return up to
    /// $sum_i alpha_i^2 (f_s^2 - f_C^2) / (2 k_i)$; an element that then speeds up on its way back returns
    /// $(f_s - f_C)^2 / (2 sigma_0) = 1.2$ uJ per cycle with one element and the default levels. With $sigma_1 > 0$ the
    /// force also has peaks of $sigma_i dz_i/dt$ while the level changes.
    ///
    /// # Source
    /// Lampaert, Al-Bender, Swevers (2003), "A generalized Maxwell-slip friction model appropriate for control
    /// purposes", PhysCon, 1170-1177; Al-Bender, Lampaert, Swevers (2005), IEEE Transactions on Automatic Control 50,
    /// 1883-1887; equations (7.35) to (7.37) of F. Novais, "A critical analysis on friction force models in dynamical
    /// systems", MSc thesis, University of Minho (2024). The thesis writes the forms of 2003 and the year 2003 beside a
    /// figure that says 2004. Its (7.36) reads $dz_i/dt = sgn(v) C_i (1 - z_i / s_i(v))$, which is right only if $s_i$
    /// carries the sign of $v$: with $s_i > 0$ it diverges for $v < 0$. Here the sign multiplies the level. $C$ is in
    /// N/s; the $C_i$ of (7.36), called a gain there, is $C alpha_i / k_i$ in m/s. Deviation: the thesis gives each
    /// element its own $C_i$ and $sigma_i$; here both follow from one $C$ and one $sigma_1$, so that all elements have
    /// one time constant. The sources leave $v = 0$ open. Stiffness: Table 7.1; levels: Table 6.1; the number of
    /// elements and their shares are chosen. The thesis uses about 1000 elements for a smooth response, as the preset
    /// `smooth` does. A public library has the form of (7.36) with $s > 0$, which diverges for $v < 0$.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::MaxwellSlip;
    /// use stribeck::model::{Law, Model};
    /// let mut law = MaxwellSlip { velocity: 1e-9, ..Default::default() };
    /// law.step(1e4); // 10 um
    /// law.output();
    /// // The first element slips at 0.1 f_s; the others are springs of 0.5 sigma_0 together.
    /// assert!((law.friction_force - (0.1 * 1.4715 + 0.5 * 1e5 * 1e-5)).abs() < 1e-9);
    /// ```
    MaxwellSlip: "Elements that stick or slip, with hysteresis of pre-sliding (generalised Maxwell-slip, GMS)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1.start(0.0),
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT,
        /// Rate at which the slipping elements together approach their level (default chosen).
        attraction: tunable = real("N/s", 1000.0).positive().nominal(1000.0).means(Meaning::Own),
        distribution: fixed = DISTRIBUTION,
        element_count: fixed = ELEMENT_COUNT.at_most(MOST as f64),
        /// Elements; those beyond element_count are not used.
        element: [Element; LISTED] = elements::FOUR,
        /// Direction of slip as found by the last event of Model Exchange: none (Held), Forward or Backward.
        slip: state = Phase::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

impl<T: Scalar> MaxwellSlip<T> {
    /// s(v); 0 if an event has released the contact.
    fn level(&self) -> T {
        let is_found = !PhaseColumn(self.slip).is_free();
        let is_released = is_found & self.normal_force.at_most(T::from(unloading::RELEASED));
        let coulomb = self.mu_k * self.normal_force;
        let breakaway = self.mu_s * self.normal_force;
        let stribeck =
            || stribeck::level(self.velocity, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent);
        is_released.choose(|| T::zero(), stribeck)
    }

    fn count(&self) -> usize {
        self.element_count.value() as usize
    }

    /// Elements in use that have variables.
    fn listed(&self) -> usize {
        self.count().min(LISTED)
    }

    /// Shares of each element in use, and its state.
    fn elements<'a>(&'a self, memory: &'a [T]) -> impl Iterator<Item = (Share<T>, &'a Block<T>)> {
        self.assert_memory(memory.len());
        let (listed, more) = (self.element[..self.listed()].iter(), model::parts(memory).iter());
        listed.map(|element| (element.share, &element.block)).chain(more.map(|block| (elements::no_share(), block)))
    }

    /// As [`MaxwellSlip::elements`], mutable.
    fn elements_mut<'a>(&'a mut self, memory: &'a mut [T]) -> impl Iterator<Item = (Share<T>, &'a mut Block<T>)> {
        self.assert_memory(memory.len());
        let listed = self.listed();
        all_mut(&mut self.element[..listed], memory)
    }

    fn assert_memory(&self, numbers: usize) {
        assert!(numbers == self.memory_in_use(), "elements beyond the {LISTED}th need the memory of an instance");
    }

    /// The laws that the elements follow.
    fn springs(&self, level: T) -> Springs<T> {
        let shares = self.element[..self.listed()].iter().map(|element| element.share);
        Springs {
            division: Division::new(self.distribution, shares).among(self.count()),
            stiffness: self.sigma_0,
            level,
            rate: self.attraction / level,
            slip: PhaseColumn(self.slip),
        }
    }

    /// Dissipated power.
    fn power(&self, sums: &Sums<T>) -> T {
        let damped = self.sigma_1 / self.sigma_0 * sums.rate + self.viscous_coefficient * self.velocity;
        self.normal_force.is_positive().choose(|| (sums.force + damped) * self.velocity, || T::zero())
    }

    /// Sums over elements, each of whose dF_i/dt is given away.
    fn sums<'a>(
        &self,
        elements: impl Iterator<Item = (Share<T>, &'a Block<T>)>,
        mut take: impl FnMut(usize, T),
    ) -> Sums<T>
    where
        T: 'a,
    {
        let springs = self.springs(self.level());
        let mut sums = Sums { force: T::zero(), rate: T::zero(), all_slip: T::Mask::from(true) };
        elements.enumerate().for_each(|(index, (share, block))| {
            let spring = springs.of(index, &share);
            let slips = spring.slips(block, self.velocity);
            let rate = spring.force_rate(block, self.velocity, slips);
            let Sums { force: force_before, rate: rate_before, all_slip } = sums;
            sums = Sums { force: force_before + block.force, rate: rate_before + rate, all_slip: all_slip & slips };
            take(index, rate);
        });
        sums
    }

    /// Sums over the elements that have variables, whose dF_i/dt are written.
    fn listed_sums(&self, rate: &mut Self) -> Sums<T> {
        let elements = self.element[..self.listed()].iter().map(|element| (element.share, &element.block));
        self.sums(elements, |index, force_rate| rate.element[index].block.force = force_rate)
    }

    /// Writes the outputs.
    fn put_outputs(&mut self, sums: &Sums<T>) {
        let Sums { force, rate, all_slip } = *sums;
        let is_loaded = self.normal_force.is_positive();
        let loaded = || force + self.sigma_1 / self.sigma_0 * rate + self.viscous_coefficient * self.velocity;
        self.friction_force = is_loaded.choose(loaded, || T::zero());
        self.sticking = is_loaded.choose(|| T::truth(!all_slip), || T::zero());
        self.dissipated_power = self.friction_force * self.velocity;
    }
}

/// Sums over the elements.
#[derive(Clone, Copy)]
struct Sums<T: Scalar> {
    /// Of F_i.
    force: T,
    /// Of dF_i/dt.
    rate: T,
    /// Whether all of them slip.
    all_slip: T::Mask,
}

/// The elements that have variables, then those that have none.
fn all_mut<'a, T: Scalar>(
    listed: &'a mut [Element<T>],
    memory: &'a mut [T],
) -> impl Iterator<Item = (Share<T>, &'a mut Block<T>)> {
    let more = model::parts_mut(memory).iter_mut().map(|block| (elements::no_share(), block));
    listed.iter_mut().map(|element| (element.share, &mut element.block)).chain(more)
}

/// The laws that the elements follow while the inputs are held.
struct Springs<T> {
    division: Division<T>,
    /// sigma_0.
    stiffness: T,
    /// s(v).
    level: T,
    /// C / s(v).
    rate: T,
    /// Direction of slip that an event has found.
    slip: PhaseColumn<T>,
}

impl<T: Scalar> Springs<T> {
    /// The law of the element with this index.
    fn of(&self, index: usize, given: &Share<T>) -> Spring<T> {
        let share = self.division.of(index, given);
        Spring {
            stiffness: share.stiffness_share * self.stiffness,
            strength: share.strength_share * self.level,
            // Slip, divided by the share of the element: the time constant is the same for all.
            rate: self.rate,
            slip: self.slip,
        }
    }
}

impl<T: Scalar> Law for MaxwellSlip<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.output_with(&[]);
    }

    fn memory_in_use(&self) -> usize {
        (self.count() - self.listed()) * Block::WIDTH
    }

    fn output_with(&mut self, memory: &[T]) {
        self.put_outputs(&self.sums(self.elements(memory), |_, _| {}));
    }

    fn slide_steadily(&mut self) {
        self.slide_steadily_with(&mut []);
    }

    fn slide_steadily_with(&mut self, memory: &mut [T]) {
        self.slip = T::from(Phase::Free.number());
        let (springs, velocity) = (self.springs(self.level()), self.velocity);
        let elements = self.elements_mut(memory).enumerate();
        elements.for_each(|(index, (share, block))| springs.of(index, &share).slide_steadily(block, velocity));
    }
}

impl<T: Scalar> Derivatives for MaxwellSlip<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.dissipated_energy = self.power(&self.listed_sums(rate));
    }

    fn output_and_derivatives(&mut self, rate: &mut Self) {
        let sums = self.listed_sums(rate);
        rate.dissipated_energy = self.power(&sums);
        self.put_outputs(&sums);
    }
}

impl Model for MaxwellSlip {
    const STEADY_SLIDING: bool = true;
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "four_elements",
            source: "Example: levels and stiffness of Novais (2024), Tables 6.1, 7.1; rest chosen (the start values)",
            values: &[],
        },
        Preset {
            name: "damped",
            source: "Example: damping and viscous coefficient of other bristle models in Novais (2024), Table 7.1",
            values: &[("sigma_1", 316.227_766_016_837_94), ("viscous_coefficient", 0.1)],
        },
        Preset {
            name: "smooth",
            source: "Example of a smooth virgin curve: 1000 elements with evenly spaced slip displacements",
            values: &[("distribution", 2.0), ("element_count", 1000.0)],
        },
    ];

    const MEMORY: usize = (MOST - LISTED) * Block::WIDTH;

    fn check(&self) -> Result<(), Fault> {
        if self.count() > LISTED && ElementDistribution::of(self.distribution) == ElementDistribution::Explicit {
            let text = "with distribution = Explicit, because only the first 64 elements have variables";
            return Err(Fault::new(format_args!("element_count = {}: must be <= {LISTED} {text}", self.count())));
        }
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)
    }

    fn step(&mut self, dt: f64) {
        self.step_with(&mut [], dt);
    }

    fn step_with(&mut self, memory: &mut [f64], dt: f64) {
        self.slip = Phase::Free.number();
        let springs = self.springs(self.level());
        let (velocity, mut energy, mut change) = (self.velocity, self.dissipated_energy, 0.0);
        self.elements_mut(memory).enumerate().for_each(|(index, (share, block))| {
            let before = block.force;
            energy += springs.of(index, &share).step(block, velocity, dt);
            change += block.force - before;
        });
        self.dissipated_energy = energy;
        if self.normal_force > 0.0 {
            // The integral of sigma_i dz_i/dt is sigma_1 / sigma_0 times the change of F_i.
            self.dissipated_energy += self.velocity * (self.sigma_1 / self.sigma_0 * change)
                + self.viscous_coefficient * self.velocity * self.velocity * dt;
        }
    }

    fn step_and_output_with(&mut self, memory: &mut [f64], dt: f64) {
        self.step_with(memory, dt);
        self.output_with(memory);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.step_ramp_with(&mut [], slope, dt);
    }

    fn step_ramp_with(&mut self, memory: &mut [f64], slope: &Self, dt: f64) {
        self.slip = Phase::Free.number();
        let begin = ramp::Inputs::of(self);
        let ramp = Ramp {
            velocity: [self.velocity, slope.velocity],
            normal_force: [self.normal_force, slope.normal_force],
            duration: dt,
        };
        // In the pieces the level moves; the division into elements stays.
        let division = self.springs(0.0).division;
        for [from, to] in ramp.cuts(self.stribeck_velocity, self.stribeck_exponent).pieces() {
            self.follow(memory, &ramp, from, to, &division);
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }

    fn rate_with(&self, memory: &[f64], rate: &mut Self, memory_rate: &mut [f64]) {
        let mut rates = all_mut(&mut rate.element[..self.listed()], memory_rate);
        let sums = self.sums(self.elements(memory), |_, force_rate| {
            if let Some((_, rate)) = rates.next() {
                rate.force = force_rate;
            }
        });
        drop(rates);
        rate.dissipated_energy = self.power(&sums);
    }

    const EVENT_INDICATORS: usize = EVENTS_OF_ELEMENTS;

    /// Elements that slip follow a level that is curved, if its ends differ.
    fn is_linear(&self) -> bool {
        Phase::of(self.slip).direction().is_none() || self.mu_s == self.mu_k
    }

    fn passivity(&self) -> Option<GivesBack> {
        crate::laws::passivity::equal_levels(self.mu_s, self.mu_k)
    }

    fn check_model_exchange(&self) -> Result<(), Fault> {
        if self.count() > LISTED {
            let text = format_args!("in Model Exchange, because only the first {LISTED} elements have variables");
            return Err(Fault::new(format_args!("element_count = {}: must be <= {LISTED} {text}", self.count())));
        }
        Ok(())
    }

    fn event_indicators(&self, indicators: &mut [f64]) {
        let springs = self.springs(self.level());
        let sticking = self.element[..self.listed()].iter().enumerate().filter(|(_, e)| e.block.slipping == 0.0);
        let onsets = sticking.map(|(index, e)| springs.of(index, &e.share).onset(&e.block, self.velocity));
        let onward = Phase::of(self.slip).direction().map(|direction| direction * self.velocity / MOVED + PASSED);
        indicators.copy_from_slice(&element_slip::indicators(onsets, onward, self.normal_force));
    }

    fn at_event(&mut self) {
        let mut springs = self.springs(self.level());
        let is_released = unloading::is_unloaded(self.normal_force) || springs.level == 0.0;
        let found = Phase::of(self.slip);
        let keeps = found.direction().is_some_and(|direction| direction * self.velocity > 0.0);
        if !keeps && !springs.slip.is_free() {
            springs.slip = PhaseColumn(Phase::Held.number());
        }
        let (velocity, mut slips) = (self.velocity, false);
        self.elements_mut(&mut []).enumerate().for_each(|(index, (share, block))| {
            let slip = !is_released && springs.of(index, &share).slips_on(block, velocity);
            block.slipping = f64::from(u8::from(slip));
            slips |= slip;
            if is_released {
                block.force = 0.0;
            }
        });
        let direction = if keeps { found } else { Phase::sliding(velocity) };
        self.slip = if slips { direction } else { Phase::Held }.number();
    }
}

impl MaxwellSlip {
    /// Advances over a piece of a ramp in which the velocity keeps its sign and the level counts as linear.
    fn follow(&mut self, memory: &mut [f64], ramp: &Ramp, from: f64, to: f64, division: &Division<f64>) {
        let mut levels = [0.0; 2];
        for (level, time) in levels.iter_mut().zip([from, to]) {
            (self.velocity, self.normal_force) = (ramp.velocity_at(time), ramp.normal_force_at(time));
            *level = self.level();
        }
        let speed = [from, to].map(|time| ramp.velocity_at(time).abs());
        let middle = 0.5 * (from + to);
        (self.velocity, self.normal_force) = (ramp.velocity_at(middle), ramp.normal_force_at(middle));
        if self.velocity == 0.0 || self.normal_force == 0.0 {
            self.step_with(memory, to - from);
            return;
        }
        let (direction, stiffness, attraction) = (self.velocity.sign(), self.sigma_0, self.attraction);
        let (mut energy, mut damping) = (self.dissipated_energy, 0.0);
        self.elements_mut(memory).enumerate().for_each(|(index, (given, block))| {
            let share = division.of(index, &given);
            let path = Path {
                stiffness: share.stiffness_share * stiffness,
                strength: levels.map(|level| share.strength_share * level),
                attraction: share.strength_share * attraction,
                speed,
                duration: to - from,
            };
            let mut follower =
                Follower { force: direction * block.force, slips: block.slipping != 0.0, ..Follower::default() };
            path.follow(&mut follower);
            (block.force, block.slipping) = (direction * follower.force, f64::from(u8::from(follower.slips)));
            energy += follower.work;
            damping += follower.damping;
        });
        let damped = self.viscous_coefficient * ramp.squares([from, to]) + self.sigma_1 / self.sigma_0 * damping;
        self.dissipated_energy = energy + damped;
    }
}

/// Limits of an element while the inputs are held.
struct Spring<T> {
    /// k_i.
    stiffness: T,
    /// alpha_i s(v).
    strength: T,
    /// C / s(v).
    rate: T,
    /// Direction of slip that an event has found.
    slip: PhaseColumn<T>,
}

impl<T: Scalar> Spring<T> {
    /// Whether the element slips: as the last event has found it or, without one, at that velocity or from now on.
    fn slips(&self, block: &Block<T>, velocity: T) -> T::Mask {
        let slipped = !block.slipping.vanishes();
        let outward = block.force * velocity.sign();
        let moves_on = !velocity.vanishes() & (slipped & outward.is_positive() | outward.at_least(self.strength));
        self.slip.slides() & slipped | self.slip.is_free() & moves_on
    }

    /// dF_i/dt of an element that slips or does not.
    fn force_rate(&self, block: &Block<T>, velocity: T, slips: T::Mask) -> T {
        let direction = choose!(self.slip.slides(), self.slip.direction(), velocity.sign());
        let slipping = || self.rate * (direction * self.strength - block.force);
        let loaded = || slips.choose(slipping, || self.stiffness * velocity);
        self.strength.vanishes().choose(|| T::zero(), loaded)
    }

    /// Puts the element at its level, where it slips; at rest it sticks.
    fn slide_steadily(&self, block: &mut Block<T>, velocity: T) {
        let (rests, is_released) = (velocity.vanishes(), self.strength.vanishes());
        let loaded = || rests.choose(|| block.force, || velocity.sign() * self.strength);
        block.force = is_released.choose(|| T::zero(), loaded);
        block.slipping = T::truth(!(rests | is_released));
    }
}

impl Spring<f64> {
    fn onset(&self, block: &Block, velocity: f64) -> Onset {
        Onset { slip: Phase::of(self.slip.0), force: block.force, strength: self.strength, speed: velocity }
    }

    /// Whether the element slips after an event.
    fn slips_on(&self, block: &Block, velocity: f64) -> bool {
        self.slips(block, velocity) || !self.slip.is_free() && self.onset(block, velocity).is_due()
    }

    /// Advances the element exactly and returns the work done on it.
    fn step(&self, block: &mut Block, velocity: f64, dt: f64) -> f64 {
        if self.strength == 0.0 {
            (block.force, block.slipping) = (0.0, 0.0);
            return 0.0;
        }
        let steady = velocity.sign() * self.strength;
        let before = block.force;
        if self.slips(block, velocity) {
            block.slipping = 1.0;
            block.force = relaxation::after(before, steady, self.rate * dt);
            return velocity * (steady * dt - (block.force - before) / self.rate);
        }
        block.slipping = 0.0;
        let stuck = before + self.stiffness * (velocity * dt);
        if stuck * velocity.sign() < self.strength {
            block.force = stuck;
            return 0.5 * (before + stuck) * (velocity * dt);
        }
        // From the instant of slip on, the element is in equilibrium with its level.
        (block.force, block.slipping) = (steady, 1.0);
        let stuck_distance = (steady - before) / self.stiffness;
        0.5 * (before + steady) * stuck_distance + steady * (velocity * dt - stuck_distance)
    }
}

#[cfg(test)]
mod tests;
