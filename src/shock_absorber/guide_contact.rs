use std::mem::offset_of;
use std::ops::Range;

use crate::contact::ExchangeOrder;
use crate::memory;
use crate::model::ramp;
use crate::model::{CoSimulation, Fault, GivesBack, Law, Meaning, Model, Width, boolean, choice, passivity, real};
use crate::number::{Decision, Mask, Scalar};
use crate::shock_absorber::law::{Answer, ChosenLaw, Evaluate, Given, MOST_EVENTS};
use crate::shock_absorber::law_list::{FRICTION_MODEL, LUGRE};
use crate::shock_absorber::law_parameters::LawParameters;
use crate::shock_absorber::law_plan::{MEMORY, blank_memory};

crate::choices! {
    /// Active parts of the friction.
    pub enum FrictionSwitch {
        /// The complete law.
        On,
        /// Static level equal to the kinetic one, as if mu_s were mu_k and preload_s were preload_k.
        NoStiction,
        /// Only the viscous part, as if coefficients and preloads were 0.
        ViscousOnly,
        /// No friction, as if the model were None.
        Off,
    }
}

crate::part! {
    /// The friction law of a contact and its parameters.
    FrictionLaw {
        /// Friction law; parameters of other laws are ignored.
        model: fixed = choice(&FRICTION_MODEL, LUGRE),
        /// Active parts of the friction.
        switch: tunable = FrictionSwitch::On.start(),
        /// Friction in compression over friction in extension: (1 + asymmetry) / (1 - asymmetry).
        asymmetry: tunable = real("1", 0.0).at_least(-0.99).at_most(0.99),
        /// Factor on all friction levels.
        scale: tunable = real("1", 1.0).at_least(0.0),
        /// Effective mass of the body, for laws that use it; 0 = law as printed.
        mass: tunable = real("kg", 0.0).at_least(0.0),
        /// Order in which the master exchanges force and motion; used with mass > 0.
        exchange: fixed = ExchangeOrder::Sequential.start(),
        /// Parameters of the laws.
        law: (LawParameters),
    }
}

crate::part! {
    /// Friction levels of a contact.
    Levels {
        /// Static coefficient of friction; not less than mu_k (default chosen).
        mu_s: tunable = real("1", 0.15).at_least(0.0),
        /// Kinetic coefficient of friction (default chosen).
        mu_k: tunable = real("1", 0.1).at_least(0.0),
        /// Breakaway force without normal force, e.g. of a seal; not less than preload_k (default chosen).
        preload_s: tunable = real("N", 10.0).at_least(0.0),
        /// Sliding friction force without normal force, e.g. of a seal (default chosen).
        preload_k: tunable = real("N", 8.0).at_least(0.0),
    }
}

impl Levels {
    /// Refuses impossible levels.
    pub(crate) fn check(&self, part: &str) -> Result<(), Fault> {
        for (name, breakaway, kinetic) in self.pairs() {
            if breakaway < kinetic {
                return Err(Fault::new(format_args!(
                    "{part}{name}_s = {breakaway}: must be >= {part}{name}_k = {kinetic}"
                )));
            }
            if breakaway > 0.0 && kinetic == 0.0 {
                return Err(Fault::new(format_args!(
                    "{part}{name}_k = 0: must be > 0 because {part}{name}_s = {breakaway} is; \
                     otherwise friction would vanish in sliding"
                )));
            }
        }
        Ok(())
    }

    /// Static levels and kinetic ones, by what their names begin with.
    fn pairs(&self) -> [(&'static str, f64, f64); 2] {
        [("mu", self.mu_s, self.mu_k), ("preload", self.preload_s, self.preload_k)]
    }
}

/// Damping that a contact lacks in order to be passive.
pub(crate) struct Shortfall {
    /// Coefficient of a viscous friction; infinite if none would do.
    pub coefficient: f64,
    /// The parameter, and the value with which it would be.
    pub said: Fault,
}

/// Motion and load of a contact at an instant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch<T> {
    /// Axial sliding velocity.
    pub velocity: T,
    /// Sliding velocity along the circumference.
    pub rim_velocity: T,
    pub normal_force: T,
    /// Acceleration along the axis.
    pub acceleration: T,
    /// All other forces along the axis that this contact has to hold.
    pub external_force: T,
    /// Mass that this contact has to stop.
    pub mass: T,
}

impl<T: Scalar> Touch<T> {
    /// Sliding speed with the sign of the axial velocity.
    pub(crate) fn signed_speed(&self) -> T {
        let turning = || {
            let speed = (self.velocity * self.velocity + self.rim_velocity * self.rim_velocity).sqrt();
            self.velocity.below(T::zero()).choose(|| -speed, || speed)
        };
        self.rim_velocity.is(0.0).choose(|| self.velocity, turning)
    }

    /// The same in steady motion, in which no mass has to be stopped.
    fn steady(&self) -> Touch<T> {
        Touch { acceleration: T::zero(), mass: T::zero(), ..*self }
    }

    /// Shares of a friction force against the sliding speed that act along the axis and along the circumference.
    pub(crate) fn direction(&self) -> [T; 2] {
        let speed = self.signed_speed();
        let is_axial = self.rim_velocity.is(0.0) | speed.vanishes();
        let along = is_axial.choose(|| T::from(1.0), || self.velocity / speed);
        [along, is_axial.choose(|| T::zero(), || self.rim_velocity / speed)]
    }
}

impl<T: Scalar> FrictionLaw<T> {
    pub(crate) fn chosen(&self) -> Option<ChosenLaw> {
        if FrictionSwitch::Off.is(self.switch).holds() { None } else { ChosenLaw::of(self.model.value()) }
    }

    /// Number of places of a memory that the law uses, from the first.
    pub(crate) fn memory_in_use(&self) -> usize {
        ChosenLaw::of(self.model.value()).map_or(0, ChosenLaw::memory_in_use)
    }

    /// Kinetic and static level of a contact, regardless of the direction of motion.
    pub(crate) fn levels(&self, levels: &Levels<T>, normal_force: T) -> [T; 2] {
        let kinetic = self.scale * (levels.preload_k + levels.mu_k * normal_force);
        let breakaway = self.scale * (levels.preload_s + levels.mu_s * normal_force);
        let is_complete = FrictionSwitch::On.is(self.switch);
        let has_levels = is_complete | FrictionSwitch::NoStiction.is(self.switch);
        has_levels.choose_all(|| [kinetic, is_complete.choose(|| breakaway, || kinetic)], || [T::zero(); 2])
    }

    /// Factor on the levels in the direction of motion. At rest it is the larger one, so that nothing slips on
    /// stopping.
    fn side(&self, velocity: T) -> T {
        let direction = velocity.sign();
        direction.is(0.0).choose(|| self.largest_side(), || T::from(1.0) - self.asymmetry * direction)
    }

    fn largest_side(&self) -> T {
        T::from(1.0) + self.asymmetry.abs()
    }

    /// Levels expressed as coefficients and a normal force, which the laws require.
    fn given(&self, levels: &Levels<T>, touch: &Touch<T>) -> Given<T> {
        let one = T::from(1.0);
        let side = self.side(touch.velocity);
        let [kinetic, breakaway] = self.levels(levels, touch.normal_force);
        let mu_k = levels.mu_k.is_positive().choose(|| levels.mu_k, || one);
        let normal_force = side * kinetic / mu_k;
        let has_stiction = kinetic.is_positive() & breakaway.above(kinetic);
        Given {
            velocity: touch.signed_speed(),
            normal_force,
            mu_k,
            mu_s: has_stiction.choose(|| mu_k * breakaway / kinetic, || mu_k),
            mass: touch.mass,
            exchange: self.exchange,
            external_force: touch.external_force,
            acceleration: touch.acceleration,
            largest: self.largest_side() * breakaway,
        }
    }

    /// Friction force against the sliding speed.
    pub(crate) fn force(&self, levels: &Levels<T>, touch: &Touch<T>, memory: &[T; MEMORY]) -> Answer<T>
    where
        T: Evaluate,
    {
        let Some(law) = self.chosen() else {
            return Answer::none();
        };
        let given = self.given(levels, touch);
        let mut answer = law.force(&given, &self.law, memory);
        answer.force += self.drag(law, &given) * given.velocity;
        answer
    }

    /// Writes the time derivatives of the law's states.
    pub(crate) fn write_rate(&self, levels: &Levels<T>, touch: &Touch<T>, memory: &[T; MEMORY], rate: &mut [T; MEMORY])
    where
        T: Evaluate,
    {
        rate.fill(T::from(0.0));
        if let Some(law) = self.chosen() {
            law.write_rate(&self.given(levels, touch), &self.law, memory, rate);
        }
    }

    /// Whether the force of the law stops a mass over a whole step.
    pub(crate) fn moves_mass(&self) -> T::Mask {
        let asks_for_mass = self.chosen().is_some_and(ChosenLaw::asks_for_mass);
        self.mass.is_positive() & asks_for_mass.into()
    }

    /// Stands for [`FrictionLaw::advance`] where numbers have no values: each state of the law becomes a number with the
    /// same dependencies.
    pub(crate) fn mark_step(&self, levels: &Levels<T>, touch: &Touch<T>, memory: &mut [T; MEMORY])
    where
        T: Evaluate,
    {
        if let Some(law) = self.chosen() {
            law.mark_step(&self.given(levels, touch), &self.law, memory);
        }
    }

    /// Stands for [`FrictionLaw::settled`] where numbers have no values.
    pub(crate) fn mark_settled(&self, levels: &Levels<T>, touch: &Touch<T>, memory: &mut [T; MEMORY])
    where
        T: Evaluate,
    {
        self.write_fresh(memory);
        let mut settled = *memory;
        self.mark_step(levels, &touch.steady(), &mut settled);
        let rests = touch.signed_speed().vanishes() | self.moves_mass();
        for (number, settled) in memory.iter_mut().zip(settled) {
            *number = rests.choose(|| *number, || settled);
        }
    }

    /// Writes the initial state of the law, also if it is switched on later.
    pub(crate) fn write_fresh<N: Scalar>(&self, memory: &mut [N; MEMORY]) {
        memory.fill(N::zero());
        if let Some(law) = ChosenLaw::of(self.model.value()) {
            law.write_start(memory);
        }
    }

    /// Viscous coefficient of a contact without levels, for which the law itself gives no force.
    fn drag(&self, law: ChosenLaw, given: &Given<T>) -> T {
        given.normal_force.is_positive().choose(|| T::zero(), || law.viscous_coefficient(&self.law))
    }
}

impl FrictionLaw {
    /// Advances the memory by `dt` while the motion is held.
    pub(crate) fn advance(
        &self,
        levels: &Levels,
        touch: &Touch<f64>,
        memory: &mut [f64; MEMORY],
        dt: f64,
    ) -> Answer<f64> {
        let Some(law) = self.chosen() else {
            return Answer::none();
        };
        let given = self.given(levels, touch);
        let mut answer = law.advance(&given, &self.law, memory, dt);
        let drag = self.drag(law, &given) * given.velocity;
        answer.force += drag;
        answer.energy += drag * given.velocity * dt;
        answer
    }

    /// As [`FrictionLaw::advance`], while the contact moves linearly from the first touch to the second.
    pub(crate) fn advance_from(
        &self,
        levels: &Levels,
        [begin, end]: [&Touch<f64>; 2],
        memory: &mut [f64; MEMORY],
        dt: f64,
    ) -> Answer<f64> {
        let Some(law) = self.chosen() else {
            return Answer::none();
        };
        let [begin, end] = [begin, end].map(|touch| self.given(levels, touch));
        let mut answer = law.advance_from(&begin, &end, &self.law, memory, dt);
        let drag = self.drag(law, &end);
        answer.force += drag * end.velocity;
        // Where the contact has levels on the way, the law itself has included its viscous part.
        let (v_0, v_1) = (begin.velocity, end.velocity);
        answer.energy += drag.min(self.drag(law, &begin)) * (v_0 * v_0 + v_0 * v_1 + v_1 * v_1) / 3.0 * dt;
        answer
    }

    /// State of the law after a while at this velocity: steady sliding, or rest if the velocity is only noise.
    #[inline(never)]
    pub(crate) fn settled(&self, levels: &Levels, touch: &Touch<f64>) -> [f64; MEMORY] {
        let mut memory = [0.0; MEMORY];
        self.write_fresh(&mut memory);
        if touch.signed_speed() != 0.0 && !self.moves_mass() {
            self.advance(levels, &touch.steady(), &mut memory, SETTLING_TIME);
        }
        memory
    }

    /// Refuses parameters that the chosen law refuses.
    pub(crate) fn check(&self, levels: &Levels) -> Result<(), Fault> {
        self.chosen().map_or(Ok(()), |law| law.check(&self.given(levels, &self.loaded_at_rest()), &self.law))
    }

    /// Warns of a parameter that was set but has no effect.
    pub(crate) fn warning(&self) -> Option<Fault> {
        self.chosen().and_then(|law| law.warning(&self.law))
    }

    /// Reason why a contact can give back more energy than it took under some load. The levels under any load are a mean of
    /// those of the preload and of the coefficients: the ratio of static and kinetic level is at most the larger one of
    /// these. The level itself is least without load. Bristles keep what the stronger direction carries when the load falls.
    pub(crate) fn passivity(&self, part: &str, levels: &Levels) -> Option<Shortfall> {
        let law = self.chosen()?;
        if FrictionSwitch::of(self.switch) != FrictionSwitch::On || self.scale == 0.0 {
            return None;
        }
        let loaded = levels.pairs().into_iter().filter(|(_, _, kinetic)| *kinetic > 0.0);
        let mu_s = loaded.map(|(_, breakaway, kinetic)| breakaway / kinetic).fold(1.0, f64::max);
        let weakest = 1.0 - self.asymmetry.abs();
        let mu_s = mu_s * self.largest_side() / weakest;
        let normal_force = self.scale * weakest * levels.preload_k;
        let given = Given { mu_k: 1.0, mu_s, normal_force, ..self.given(levels, &self.loaded_at_rest()) };
        if let GivesBack::Damping { viscous_coefficient, least } = law.gives_back_at_worst(&given, &self.law)? {
            let name = memory::text(format_args!("friction.{}", law.viscous_path()?));
            let said = passivity::damping(&name, viscous_coefficient, least);
            return Some(Shortfall { coefficient: least - viscous_coefficient, said });
        }
        let (name, breakaway, kinetic) =
            levels.pairs().into_iter().find(|(_, breakaway, kinetic)| breakaway > kinetic)?;
        let names = ["s", "k"].map(|level| memory::text(format_args!("{part}{name}_{level}")));
        let said = passivity::level([&names[0], &names[1]], [breakaway, kinetic]);
        Some(Shortfall { coefficient: f64::INFINITY, said })
    }

    /// Refuses a law that is for co-simulation only.
    pub(crate) fn check_model_exchange(&self, levels: &Levels) -> Result<(), Fault> {
        self.chosen()
            .map_or(Ok(()), |law| law.check_model_exchange(&self.given(levels, &self.loaded_at_rest()), &self.law))
    }

    /// Refuses a law that cannot act behind a mount, where forces and masses are not those of the host.
    pub(crate) fn check_mounted(&self, levels: &Levels) -> Result<(), Fault> {
        if self.moves_mass() {
            let why = "must be 0 if mount.enabled is true, because the friction then stops mount.mass";
            return Err(Fault::new(format_args!("friction.mass = {}: {why}", self.mass)));
        }
        self.chosen().map_or(Ok(()), |law| law.check_mounted(&self.given(levels, &self.loaded_at_rest()), &self.law))
    }

    /// Refuses a law that sticks and slips at events.
    pub(crate) fn check_without_events(&self, levels: &Levels) -> Result<(), Fault> {
        self.chosen()
            .map_or(Ok(()), |law| law.check_without_events(&self.given(levels, &self.loaded_at_rest()), &self.law))
    }

    /// Event indicators of the law; 1 for an event that never occurs.
    pub(crate) fn indicators(&self, levels: &Levels, touch: &Touch<f64>, memory: &[f64; MEMORY]) -> [f64; MOST_EVENTS] {
        let mut indicators = [1.0; MOST_EVENTS];
        if let Some(law) = self.chosen() {
            law.indicate(&self.given(levels, touch), &self.law, memory, &mut indicators);
        }
        indicators
    }

    /// Updates the states of the law that change at an event.
    pub(crate) fn at_event(&self, levels: &Levels, touch: &Touch<f64>, memory: &mut [f64; MEMORY]) {
        if let Some(law) = self.chosen() {
            law.at_event(&self.given(levels, touch), &self.law, memory);
        }
    }

    fn loaded_at_rest(&self) -> Touch<f64> {
        Touch {
            velocity: 0.0,
            rim_velocity: 0.0,
            normal_force: 1.0,
            acceleration: 0.0,
            external_force: 0.0,
            mass: self.mass,
        }
    }
}

/// Time of motion before the run (chosen, in s): at 1 mm/s, several times the pre-sliding displacement.
const SETTLING_TIME: f64 = 1.0;

crate::model! {
    /// Friction of a rod in its guide: any scalar law of the catalogue, for motion along the axis and about it.
    ///
    /// # Equations
    ///
    /// ```text
    /// f_C = F_k + mu_k f_n,   f_s = F_s + mu_s f_n
    /// s = (v^2 + (r w)^2)^(1/2)
    /// f = phi(s) v / s
    /// tau = r phi(s) r w / s
    /// ```
    ///
    /// $phi$ is the chosen law with the levels $f_C$ and $f_s$. For motion along the axis alone ($w = 0$) it is
    /// $f = phi(v)$.
    ///
    /// | symbol | variable          | unit  | meaning                                         |
    /// |--------|-------------------|-------|-------------------------------------------------|
    /// | v      | `velocity`        | m/s   | axial velocity of the rod relative to the guide |
    /// | w      | `spin_rate`       | rad/s | spin of the rod relative to the guide           |
    /// | f_n    | `normal_force`    | N     | force pressing the surfaces together            |
    /// | r      | `radius`          | m     | radius of the contact                           |
    /// | mu_k   | `levels.mu_k`     | 1     | kinetic coefficient of friction                 |
    /// | mu_s   | `levels.mu_s`     | 1     | static coefficient of friction                  |
    /// | F_k    | `levels.preload_k` | N    | sliding friction without normal force           |
    /// | F_s    | `levels.preload_s` | N    | breakaway force without normal force            |
    /// | f      | `friction_force`  | N     | axial friction force                            |
    /// | tau    | `friction_torque` | N.m   | friction torque about the axis                  |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` when sliding, `friction_torque` that of `spin_rate`; the rod feels
    /// their negatives. Both levels are multiplied by `friction.scale`, and by 1 - `friction.asymmetry` for $v > 0$ or
    /// by 1 + `friction.asymmetry` for $v < 0$; at rest the larger of the two applies.
    ///
    /// # Step
    /// As that of the chosen law. If the law supports Model Exchange, its continuous states are `memory[1]` and
    /// `memory[2]`, in its order; whatever else it remembers is not a variable, but part of a saved state. It starts at
    /// rest. If the load falls, whatever carries more than $f_s$ slips until it carries $f_s$: bristles; elements, in
    /// proportion, so that the forces between them stay possible too; the force of a law with a low-pass filter, apart
    /// from its viscous part, and what its curve has above $f_s$. If an importer integrates the states, the force is
    /// that after the slip at once, and the states follow with a time constant of 1 ms.
    ///
    /// The parameters have the names and the start values of the laws. Laws with the same start value share a
    /// parameter; a law with another start value has its own, such as `friction.Gonthier.transition_velocity`, and does
    /// not follow the shared one: setting the shared one gives a warning.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `levels.mu_s` < `levels.mu_k`; `levels.preload_s` < `levels.preload_k`;
    /// what the chosen law refuses.
    ///
    /// # Limits
    /// The memory of a law belongs to the axial motion only: if the rod spins, the force follows the direction of
    /// motion at once, and a reversal of `velocity` passes through zero torque. The law sees the normal force
    /// $f_C / mu_k$, the load plus a load that represents the preload. Without levels ($f_C = 0$) only the viscous part
    /// remains. `external_force`, `acceleration` and `friction.mass` are used only by the laws that have them.
    ///
    /// The damping of bristles can give back more energy than the contact took, unless the viscous coefficient is large
    /// enough: `LuGre`, `ElastoPlastic`, `Leuven` and `CylinderFriction` say how large on their pages, by the ratio of
    /// static and kinetic level. Here it lies between those of preload and coefficients, whatever the load. Bristles that
    /// slip as the load falls keep the larger static level of both directions, also beside the smaller kinetic one, with
    /// $a$ for `friction.asymmetry`:
    ///
    /// ```text
    /// (1 + |a|) f_s / ((1 - |a|) f_C) <= (1 + |a|) / (1 - |a|) max(F_s / F_k, mu_s / mu_k)
    /// ```
    ///
    /// With this bound a value follows that suffices under every load, also one that changes: bristles that slip lose their
    /// energy. Where the damping fades, the level beside it is the smaller kinetic one without load, the least of all. A
    /// warning names the value. `Gonthier` and `MaxwellSlip` need equal levels, those of the preload and the coefficients,
    /// and a constant load.
    ///
    /// # Source
    /// F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024), chapter 9: friction at the contact points of a telescopic joint, reconstructed from its list of symbols.
    /// The defaults are chosen: a guide of filled PTFE with a wiper, on a chromed rod.
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Law;
    /// use stribeck::shock_absorber::GuideContact;
    /// let mut contact = GuideContact { velocity: 0.3, spin_rate: 40.0, radius: 0.01, ..Default::default() };
    /// contact.friction.model = 2.0; // Coulomb
    /// contact.normal_force = 20.0;
    /// contact.output();
    /// assert!((contact.friction_force - 10.0 * 0.6).abs() < 1e-14); // speed 0.5 m/s, level 8 + 0.1 20 = 10 N
    /// assert!((contact.friction_torque - 10.0 * 0.8 * 0.01).abs() < 1e-15);
    /// ```
    GuideContact: "Friction of a rod in its guide, by any law of the catalogue" {
        /// Axial velocity of the rod relative to the guide.
        velocity: input = real("m/s", 0.0).shown_in("mm/s").means(Meaning::Velocity),
        /// Spin of the rod relative to the guide.
        spin_rate: input = real("rad/s", 0.0),
        /// Normal force that presses the surfaces together.
        normal_force: input = real("N", 0.0).at_least(0.0).means(Meaning::NormalForce),
        /// All other axial forces on the rod; only for laws that hold a load at rest.
        external_force: input = real("N", 0.0).means(Meaning::ExternalForce),
        /// Time derivative of the velocity; only for laws that use it.
        acceleration: input = real("m/s2", 0.0).means(Meaning::Acceleration),
        /// Radius of the contact.
        radius: tunable = real("m", 0.007).at_least(0.0).shown_in("mm"),
        /// Friction levels.
        levels: Levels,
        /// Friction law.
        friction: FrictionLaw,
        /// States of the friction law, in SI units: its continuous states in their order.
        memory: [state; MEMORY] = blank_memory(1.0),
        /// Has the run begun?
        started: state = boolean(false).hidden(),
        /// Energy taken out of the motion since the start.
        dissipated_energy: state_output = real("J", 0.0).means(Meaning::Energy),
        /// Axial friction force; has the sign of the velocity when sliding.
        friction_force: output = real("N", 0.0),
        /// Friction torque about the axis; has the sign of the spin rate when sliding.
        friction_torque: output = real("N.m", 0.0),
        /// Power taken out of the motion.
        dissipated_power: output = real("W", 0.0),
        /// Is the contact sticking?
        sticking: output = boolean(false),
    }
}

impl<T: Evaluate> GuideContact<T> {
    fn touch(&self) -> Touch<T> {
        Touch {
            velocity: self.velocity,
            rim_velocity: self.radius * self.spin_rate,
            normal_force: self.normal_force,
            acceleration: self.acceleration,
            external_force: self.external_force,
            mass: self.friction.mass,
        }
    }

    /// Works on the states of the law; before the run, on its initial state.
    fn with_memory<R>(&self, work: impl FnOnce(&[T; MEMORY]) -> R) -> R {
        if self.started.vanishes().holds() { self.with_fresh_memory(work) } else { work(&self.memory) }
    }

    #[inline(never)] // so that only callers that need it have it on their stack
    fn with_fresh_memory<R>(&self, work: impl FnOnce(&[T; MEMORY]) -> R) -> R {
        let mut memory = [T::from(0.0); MEMORY];
        self.friction.write_fresh(&mut memory);
        work(&memory)
    }
}

impl<T: Evaluate> Law for GuideContact<T> {
    type Interface = CoSimulation;

    fn output(&mut self) {
        let touch = self.touch();
        let answer = self.with_memory(|memory| self.friction.force(&self.levels, &touch, memory));
        let [axial, around] = touch.direction();
        self.friction_force = answer.force * axial;
        self.friction_torque = self.radius * answer.force * around;
        self.dissipated_power = answer.force * touch.signed_speed();
        self.sticking = answer.sticking;
    }
}

/// Distance from a reversal at which the levels are taken, in parts of the interval (chosen).
const INSIDE: f64 = 1e-9;

impl Model for GuideContact {
    const HAS_IDLE: bool = true;

    fn idle(&self) -> [Range<usize>; 2] {
        // The start of a run writes all of the memory.
        let in_use = if self.started == 0.0 { MEMORY } else { self.friction.memory_in_use() };
        let (first, none) = (offset_of!(Self, memory) / size_of::<f64>(), Self::WIDTH..Self::WIDTH);
        [first + in_use..first + MEMORY, none]
    }

    fn check(&self) -> Result<(), Fault> {
        self.levels.check("levels.")?;
        self.friction.check(&self.levels)
    }

    fn warning(&self) -> Option<Fault> {
        self.friction.warning()
    }

    fn passivity(&self) -> Option<GivesBack> {
        self.friction.passivity("levels.", &self.levels).map(|lacking| GivesBack::Said(lacking.said))
    }

    fn step(&mut self, dt: f64) {
        if self.started == 0.0 {
            self.friction.write_fresh(&mut self.memory);
            self.started = 1.0;
        }
        let touch = self.touch();
        let answer = self.friction.advance(&self.levels, &touch, &mut self.memory, dt);
        self.dissipated_energy += answer.energy;
    }

    /// As the chosen law, from one reversal to the next, where the levels jump. A force that stops a mass belongs to
    /// the whole step.
    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        if self.started == 0.0 {
            self.friction.write_fresh(&mut self.memory);
            self.started = 1.0;
        }
        let begin = ramp::Inputs::of(self);
        let reversal = -self.velocity / slope.velocity;
        let turns = reversal > 0.0 && reversal < dt && !self.friction.moves_mass();
        let mut from = 0.0;
        for to in turns.then_some(reversal).into_iter().chain([dt]) {
            // At the reversal itself the larger level applies; before and after it, that of the direction.
            let inside = |time: f64| if time == reversal { INSIDE * (to - from) } else { 0.0 };
            let touches = [from + inside(from), to - inside(to)].map(|time| {
                ramp::set_inputs(self, &begin, slope, time);
                self.touch()
            });
            let [before, after] = &touches;
            let answer = self.friction.advance_from(&self.levels, [before, after], &mut self.memory, to - from);
            self.dissipated_energy += answer.energy;
            from = to;
        }
        ramp::set_inputs(self, &begin, slope, dt);
    }

    fn rate(&self, rate: &mut Self) {
        let touch = self.touch();
        let answer = self.with_memory(|memory| {
            self.friction.write_rate(&self.levels, &touch, memory, &mut rate.memory);
            self.friction.force(&self.levels, &touch, memory)
        });
        rate.dissipated_energy = answer.force * touch.signed_speed();
    }
}
