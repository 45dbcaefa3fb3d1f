use crate::contact::conditions::is_elastic;
use crate::contact::element_limits::{Limits, Stretch, lag};
use crate::contact::element_slip::{self, EVENTS_OF_ELEMENTS, Onset};
use crate::contact::elements::{self, Division, Ramp, Share};
use crate::contact::quantities::*;
use crate::contact::time_stepping::{MOVED, Phase, PhaseColumn};
use crate::contact::unloading;
use crate::laws::stribeck;
use crate::model::ramp;
use crate::model::{Derivatives, Fault, GivesBack, Law, Meaning, Model, ModelExchange, Preset, real};
use crate::number::elementary::{exp_m1, pow};
use crate::number::{Mask, Real, Scalar};
use crate::numerics::approach;

crate::part! {
    /// A Maxwell-slip element of the hysteresis force.
    Element {
        /// Share of the element.
        share: (Share),
        force: state = ELEMENT_FORCE.reinit(),
        slipping: state = ELEMENT_SLIPPING,
    }
}

crate::model! {
    /// Leuven friction in the form of Lampaert: LuGre whose bristle spring is replaced by Maxwell-slip elements, so
    /// that pre-sliding has hysteresis with non-local memory.
    ///
    /// # Equations
    ///
    /// ```text
    /// dz/dt = v (1 - sgn(F_h / s(v)) |F_h / s(v)|^n)
    /// f_f   = F_h(z) + sigma_1 dz/dt + sigma_2 v
    /// F_h   = sum_i F_i,   dF_i/dz = k_i if |F_i| < W_i or F_i falls, else 0
    /// s(v)  = sgn(v) (f_C + (f_s - f_C) exp(-(|v| / v_S)^delta))
    /// f_C = mu_k f_n,   f_s = mu_s f_n,   sum_i k_i = sigma_0,   sum_i W_i = w f_s
    /// ```
    ///
    /// | symbol        | variable                     | unit  | meaning                                          |
    /// |---------------|------------------------------|-------|--------------------------------------------------|
    /// | v             | `velocity`                   | m/s   | velocity of body 1 relative to body 2            |
    /// | f_n           | `normal_force`               | N     | force pressing the surfaces together             |
    /// | mu_k          | `mu_k`                       | 1     | kinetic coefficient of friction                  |
    /// | mu_s          | `mu_s`                       | 1     | static coefficient of friction                   |
    /// | v_S           | `stribeck_velocity`          | m/s   | speed at which the level has fallen              |
    /// | delta         | `stribeck_exponent`          | 1     | shape of the falling level                       |
    /// | sigma_0       | `sigma_0`                    | N/m   | stiffness of all elements together               |
    /// | sigma_1       | `sigma_1`                    | N.s/m | damping of the bristles                          |
    /// | sigma_2       | `viscous_coefficient`        | N.s/m | viscous coefficient                              |
    /// | n             | `approach_exponent`          | 1     | shape of the transition to sliding               |
    /// | w             | `hysteresis_strength`        | 1     | strength of the elements, as a multiple of $f_s$ |
    /// |               | `distribution`               |       | where the shares come from                       |
    /// |               | `element_count`              |       | number of elements in use                        |
    /// | k_i / sigma_0 | `element[i].stiffness_share` | 1     | share of an element in the stiffness             |
    /// | W_i / (w f_s) | `element[i].strength_share`  | 1     | share of an element in the strength              |
    /// | F_i           | `element[i].force`           | N     | force of an element                              |
    /// |               | `element[i].slipping`        |       | mode of an element, as the last event has found it |
    /// |               | `slip`                       |       | direction of slip, as the last event has found it |
    /// | z             | `bristle_deflection`         | m     | mean deflection                                  |
    /// | f_f           | `friction_force`             | N     | friction force                                   |
    ///
    /// # Sign
    /// `friction_force` has the sign of `velocity` in steady sliding; body 1 feels `-friction_force`. Dissipated power
    /// is `friction_force * velocity`; it is negative while the bristles spring back.
    ///
    /// # Step
    /// Between two slips of elements $F_h$ is linear in $z$. With held inputs and $r = F_h / |s|$ such a piece is
    ///
    /// ```text
    /// dr/dt = (K |v| / |s|) (1 - sgn(r) |r|^n),   K = stiffness of the elements that do not slip
    /// ```
    ///
    /// (for motion forwards), and a deflection that grows or falls throughout the step. For $n = 1$ the pieces are
    /// solved in closed form, otherwise by quadrature of time over force to 1e-13; each slip is located inside the
    /// step. So the result does not depend on how an interval is divided. `sticking` means that more than 1 % (chosen)
    /// of the motion still goes into the bristles.
    ///
    /// With linearly moving inputs the step is of second order, in 4 to 19 pieces (chosen): it is cut where $v$ changes
    /// sign and where the level is curved, and in each piece level and strengths count as linear. $F_h$ follows a
    /// moving level as closely as the bristles do. An element that slips while the load rises stays at its strength
    /// unless the strength grows faster than the element's force can.
    ///
    /// In Model Exchange the forces of all 64 elements and $z$ are continuous states; elements beyond `element_count`
    /// rest. An element begins to slip at an event, where $|F_i|$ reaches $W_i$ while it moves outwards, and all stick
    /// again at the event at which $dz/dt$ changes its sign: where $v$ reverses, or where the level falls below $F_h$. A
    /// third event releases the elements where the load vanishes. Slipping elements follow a rising load with a time
    /// constant of 0.1 ms.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `mu_s` < `mu_k`; `hysteresis_strength` < 1, because elements that are
    /// together weaker than $f_s$ all slip before the level is reached, and $z$ grows without limit;
    /// `approach_exponent` < 0.1 (chosen), where nearly all motion would be sliding from the start.
    ///
    /// # Limits
    /// Not passive for sampled velocities if $sigma_1 > 0$ and $f_s > f_C$, for the same reason as LuGre and by the
    /// same bound: $sigma_2 >= sigma_1 (f_s - f_C) / f_C$ for $n = 1$; for $n > 1$ the spike grows as $(f_s / f_C)^n$.
    /// Without damping ($sigma_1 = 0$) it is passive at constant load. One element with $n = 1$ is LuGre exactly. If
    /// the load falls, an element above its new strength keeps its force until it moves back. `normal_force` = 0
    /// releases the contact (force 0, deflections 0). The force at $v = 0$ is held.
    ///
    #[doc = include_str!("falling_load.md")]
    /// # Source
    /// Lampaert, Swevers, Al-Bender (2002), "Modification of the Leuven integrated friction model structure", IEEE
    /// Transactions on Automatic Control 47, 683-687, after Swevers, Al-Bender, Ganseman, Prajogo (2000), "An
    /// integrated friction model structure with improved presliding behavior for accurate friction compensation", the
    /// same journal 45, 675-686. Deviations: $s(v)$ and the strengths carry the normal force; the deflections of the
    /// slipping ends of the elements are replaced by the forces $F_i$. The hysteresis of 2000, with a stack of reversal
    /// points, is not included. Levels, $sigma_0$, $sigma_1$, $sigma_2$: Tables 6.1 and 7.1 of F. Novais, "A critical
    /// analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024), for its other
    /// bristle models; $n$, the elements and their strength are chosen. A public implementation misplaces a parenthesis
    /// in the equation of $z$ and has $v (1 - sgn r) |r|^n$.
    ///
    /// # Example
    /// ```
    /// use stribeck::friction::Leuven;
    /// use stribeck::model::{Law, Model};
    /// let mut law = Leuven { velocity: 0.001, ..Default::default() };
    /// law.step(10.0);
    /// law.output();
    /// let steady = 0.981 + 0.4905 * (-1.0f64).exp() + 0.1 * 0.001; // s(v_S) + sigma_2 v_S
    /// assert!((law.friction_force - steady).abs() < 1e-12);
    /// ```
    Leuven: "Bristle friction with hysteresis of pre-sliding (Leuven, in the form of Lampaert)" {
        velocity: input = VELOCITY,
        normal_force: input = NORMAL_FORCE,
        mu_k: tunable = MU_K,
        mu_s: tunable = MU_S,
        stribeck_velocity: tunable = STRIBECK_VELOCITY,
        stribeck_exponent: tunable = STRIBECK_EXPONENT,
        sigma_0: tunable = SIGMA_0,
        sigma_1: tunable = SIGMA_1,
        viscous_coefficient: tunable = VISCOUS_COEFFICIENT.start(0.1),
        /// Exponent of the approach to the steady level (default chosen).
        approach_exponent: tunable = real("1", 1.0).at_least(0.1).means(Meaning::Shape),
        /// Strength of all elements together, as a multiple of the static level; not less than 1 (default chosen).
        hysteresis_strength: tunable = real("1", 1.2).positive().means(Meaning::Strength),
        distribution: fixed = DISTRIBUTION,
        element_count: fixed = ELEMENT_COUNT,
        /// Elements; those beyond element_count are not used.
        element: [Element; 64] = elements::FOUR,
        bristle_deflection: state = BRISTLE_DEFLECTION.reinit(),
        /// Direction of slip as found by the last event of Model Exchange: none (Held), Forward or Backward.
        slip: state = Phase::Free.start(),
        dissipated_energy: state_output = DISSIPATED_ENERGY,
        friction_force: output = FRICTION_FORCE,
        dissipated_power: output = DISSIPATED_POWER,
        sticking: output = STICKING,
    }
}

/// Rounding error of F_h, relative to the largest forces of its parts (chosen: the most that 64 elements can add up).
const ROUNDING: f64 = 1e-14;

impl<T: Scalar> Leuven<T> {
    /// |s(v)|; 0 if it has all but vanished, as it does at high speed for f_C = 0, or if an event has released the contact.
    fn level(&self) -> T {
        let is_released = !PhaseColumn(self.slip).is_free() & self.normal_force.at_most(T::from(unloading::RELEASED));
        is_released.choose(|| T::zero(), || self.loaded_level())
    }

    fn loaded_level(&self) -> T {
        let coulomb = self.mu_k * self.normal_force;
        let breakaway = self.mu_s * self.normal_force;
        let level = stribeck::level(self.velocity, coulomb, breakaway, self.stribeck_velocity, self.stribeck_exponent);
        level.above(T::from(1e-100) * breakaway).choose(|| level, || T::zero())
    }

    /// w f_s.
    fn strength(&self) -> T {
        self.hysteresis_strength * self.mu_s * self.normal_force
    }

    fn count(&self) -> usize {
        self.element_count.value() as usize
    }

    /// F_h.
    fn hysteresis(&self) -> T {
        self.element[..self.count()].iter().fold(T::zero(), |sum, element| sum + element.force)
    }

    /// F_h as it continues while the load rises: elements that slip follow their strength unless it grows too fast for
    /// them.
    fn moving_hysteresis(&self) -> T {
        let strength = self.strength();
        let growing = || {
            let rate = self.deflection_rate(self.level());
            rate.vanishes().choose(|| self.hysteresis(), || self.growing_hysteresis(strength, rate.sign()))
        };
        strength.rises().choose(growing, || self.hysteresis())
    }

    /// F_h as it continues in a direction while the strength grows.
    fn growing_hysteresis(&self, strength: T, direction: T) -> T {
        let division = Division::new(self.distribution, self.element[..self.count()].iter().map(|e| e.share));
        // The change only.
        let motion = self.bristle_deflection - self.bristle_deflection.as_constant();
        self.element[..self.count()].iter().enumerate().fold(T::zero(), |sum, (index, element)| {
            let share = division.of(index, &element.share);
            let slipping = direction * share.strength_share * strength;
            let sticking = element.force + share.stiffness_share * self.sigma_0 * motion;
            let is_slower = !(direction * slipping - direction * sticking).rises();
            let slips = || is_slower.choose(|| slipping, || sticking);
            sum + element.force.equals(slipping).choose(slips, || element.force)
        })
    }

    /// Whether F_h is at that level, within the resolution of a sum of forces of both signs.
    fn is_at(&self, level: T) -> T::Mask {
        let forces = self.element[..self.count()].iter().map(|element| element.force.abs());
        let scale = forces.fold(self.strength(), |sum, force| sum + force);
        (self.velocity.sign() * self.hysteresis() - level).abs().at_most(T::from(ROUNDING) * scale)
    }

    /// dz/dt.
    fn deflection_rate(&self, level: T) -> T {
        self.rate_under(level, self.hysteresis())
    }

    /// dz/dt at the given F_h.
    fn rate_under(&self, level: T, hysteresis: T) -> T {
        let moving = || {
            let r = self.velocity.sign() * hysteresis / level;
            let n = self.approach_exponent;
            let power = n.is(1.0).choose(|| r, || r.sign() * r.abs().powf(n));
            // A level far below the force must not make the rate infinite.
            self.velocity * (T::from(1.0) - power.limited(T::from(1e100)))
        };
        (level.vanishes() | self.is_at(level)).choose(|| T::zero(), moving)
    }

    fn force(&self, hysteresis: T, deflection_rate: T) -> T {
        let loaded = || hysteresis + self.sigma_1 * deflection_rate + self.viscous_coefficient * self.velocity;
        self.normal_force.vanishes().choose(|| T::zero(), loaded)
    }
}

impl<T: Scalar> Law for Leuven<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        let hysteresis = self.moving_hysteresis();
        let rate = self.rate_under(self.level(), hysteresis);
        self.friction_force = self.force(hysteresis, rate);
        self.dissipated_power = self.friction_force * self.velocity;
        let elastic = is_elastic(rate, self.velocity);
        self.sticking = T::truth(elastic & self.normal_force.is_positive());
    }
}

impl<T: Scalar> Derivatives for Leuven<T> {
    fn derivatives(&self, rate: &mut Self) {
        let deflection_rate = self.deflection_rate(self.level());
        let (division, strength) = (self.division(), self.strength());
        for (index, element) in self.element[..self.count()].iter().enumerate() {
            let share = division.of(index, &element.share);
            let spring = share.stiffness_share * self.sigma_0 * deflection_rate;
            rate.element[index].force = self.force_rate(element, share.strength_share * strength, spring);
        }
        rate.bristle_deflection = deflection_rate;
        rate.dissipated_energy = self.force(self.hysteresis(), deflection_rate) * self.velocity;
    }
}

/// Time constant with which a slipping element follows a rising load, in s (chosen).
const FOLLOWS: f64 = 1e-4;

/// Part of the velocity at which the deflection counts as reversed (chosen): in steady sliding only rounding is left.
const TURNED: f64 = 1e-9;

impl<T: Scalar> Leuven<T> {
    fn division(&self) -> Division<T> {
        Division::new(self.distribution, self.element[..self.count()].iter().map(|e| e.share))
    }

    /// dF_i/dt for that of its spring. Between events an element that slips in a direction follows its strength there.
    fn force_rate(&self, element: &Element<T>, strength: T, spring: T) -> T {
        let slip = PhaseColumn(self.slip);
        let direction = slip.direction();
        let follows = || {
            let missing = (strength - direction * element.force).larger(T::zero()) / T::from(FOLLOWS);
            let most = (direction * spring).larger(T::zero());
            direction * missing.above(most).select(most, missing)
        };
        let yields = slip.is_free() & (spring.sign() * element.force).at_least(strength);
        let stuck = || yields.choose(|| T::zero(), || spring);
        (slip.slides() & !element.slipping.vanishes()).choose(follows, stuck)
    }
}

impl Leuven {
    fn onset(&self, index: usize, division: &Division<f64>, deflection_rate: f64) -> Onset {
        let strength = self.spring(division, index).1 * self.strength();
        Onset { slip: Phase::of(self.slip), force: self.element[index].force, strength, speed: deflection_rate }
    }

    /// Rate of the deflection in the direction of slip, in parts of the velocity; none without slip.
    fn onward(&self, deflection_rate: f64) -> Option<f64> {
        Phase::of(self.slip).direction().map(|to| to * deflection_rate / (self.velocity.abs() + MOVED))
    }

    /// Whether an element slips after an event.
    fn slips_on(&self, index: usize, division: &Division<f64>, deflection_rate: f64) -> bool {
        let has_slipped = Phase::of(self.slip).direction().is_some() && self.element[index].slipping != 0.0;
        has_slipped || self.onset(index, division, deflection_rate).is_due()
    }

    /// k_i and W_i / (w f_s).
    #[inline]
    fn spring(&self, division: &Division<f64>, index: usize) -> (f64, f64) {
        let share = division.of(index, &self.element[index].share);
        (share.stiffness_share * self.sigma_0, share.strength_share)
    }

    /// Forgets what events have found: steps see it themselves.
    fn leave_events(&mut self) {
        if self.slip != Phase::Free.number() {
            self.slip = Phase::Free.number();
            self.element.iter_mut().for_each(|element| element.slipping = 0.0);
        }
    }

    fn release(&mut self) {
        self.bristle_deflection = 0.0;
        for element in &mut self.element {
            (element.force, element.slipping) = (0.0, 0.0);
        }
    }

    /// Moves over a distance at one level. Advances the deflection and returns the work of F_h.
    fn advance(&mut self, limits: &mut Limits, level: f64, distance: f64) -> f64 {
        let (mut left, mut work) = (distance, 0.0);
        // Each piece but the last ends with an element that begins to slip, and each does so only once in one
        // direction.
        for _ in 0..=self.count() {
            let (done, area) = self.piece(limits, level, left);
            work += area;
            left -= done;
            if left <= 0.0 {
                break;
            }
        }
        work
    }

    /// One piece of a step, at most until an element begins to slip. Returns the distance travelled and the work of
    /// F_h.
    fn piece(&mut self, limits: &mut Limits, level: f64, distance: f64) -> (f64, f64) {
        let direction = self.velocity.sign();
        let force = direction * self.hysteresis();
        // The deflection grows up to the level, or falls to it from above.
        let outward = if force <= level { direction } else { -direction };
        let (stiffness, room) = self.yielding(limits, outward);
        if stiffness == 0.0 || self.is_at(level) {
            return (distance, force * distance);
        }
        // In terms of r = F_h / |s| and the distance in units of |s| / K.
        let unit = level / stiffness;
        let slip = (force + direction * outward * stiffness * room) / level;
        let travelled = approach::advance(force / level, slip, distance / unit, self.approach_exponent);
        // Exactly up to the slip, so that rounding does not leave the element short of it.
        let change = if travelled.arrived { room } else { travelled.change.abs() * unit };
        self.deflect(limits, outward, change, room);
        let done = if travelled.arrived { travelled.distance * unit } else { distance };
        (done, travelled.area * unit * level)
    }

    /// Stiffness of the elements that follow a motion in this direction, and the deflection at which the next one
    /// slips.
    fn yielding(&self, limits: &Limits, direction: f64) -> (f64, f64) {
        let (mut sum, mut room) = (0.0, f64::INFINITY);
        for index in 0..self.count() {
            let (stiffness, share) = self.spring(limits.division, index);
            if let Some(own) = limits.room(index, stiffness, share, direction * self.element[index].force) {
                sum += stiffness;
                room = room.min(own);
            }
        }
        (sum, room)
    }

    fn deflect(&mut self, limits: &mut Limits, direction: f64, change: f64, room: f64) {
        self.bristle_deflection += direction * change;
        let before = *limits;
        limits.line = (before.line - before.fall * change).max(before.floor);
        for index in 0..self.count() {
            let (stiffness, share) = self.spring(limits.division, index);
            let force = &mut self.element[index].force;
            if let Some(own) = before.room(index, stiffness, share, direction * *force) {
                let slips = change >= room && own <= room || change >= own;
                *force += direction * stiffness * change;
                if slips {
                    *force = direction * share * limits.at(index);
                }
            }
        }
    }
}

/// Distance from its strength, in shares of its possible change over a piece of a ramp, within which an element counts
/// as slipping (chosen).
const NEAR: f64 = 1e-3;

/// Least level that a piece of a ramp approaches, relative to that of its middle (chosen): where the level falls by most
/// of itself, the one that would end where an approach to the moving level ends may be negative.
const LEAST_SEEN: f64 = 0.25;

impl Leuven {
    /// Advances over a piece of a ramp in which the velocity keeps its sign, and level and strengths count as linear.
    ///
    /// The approach to the level is that of held inputs, at the level for which it ends where an exponential approach
    /// to the moving level would end. Elements that slip along a rising strength are lifted half a piece before and
    /// after.
    fn follow(&mut self, ramp: &Ramp, [from, to]: [f64; 2], division: &Division<f64>) {
        let Some(stretch) = self.enter(ramp, [from, to]) else { return };
        let (direction, distance) = (self.velocity.sign(), self.velocity.abs() * stretch.duration);
        let before = self.bristle_deflection;
        let force = direction * self.hysteresis();
        let (level, begin) = (self.level(), stretch.level[0]);
        let rate = self.rate_at(force / if begin > 0.0 { begin } else { level });
        let outward = if rate == 0.0 { direction } else { direction * rate.sign() };
        let mut limits = self.limits(&stretch, division, rate.abs(), outward);
        let drive =
            outward * direction * self.drive(&limits, &stretch, |limits, index, _, _| limits.slipping.has(index));
        let x = stretch.distance(self.yielding(&limits, outward).0, self.approach_exponent);
        let [begin, end] = stretch.level;
        let aim = end - (end - begin - drive * stretch.duration) * lag(x);
        let seen = aim - 0.5 * drive * stretch.duration;
        let work = self.advance(&mut limits, seen.max(LEAST_SEEN * level), distance);
        self.lift(&limits, &stretch, outward);
        self.settle(division, &stretch, aim);
        self.dissipated_energy += work
            + self.sigma_1 * self.velocity * (self.bristle_deflection - before)
            + self.viscous_coefficient * ramp.squares([from, to]);
    }

    /// Moves the inputs to the middle of a piece and returns the limits at its ends; none if there is nothing to
    /// follow.
    fn enter(&mut self, ramp: &Ramp, [from, to]: [f64; 2]) -> Option<Stretch> {
        let [begin, end, middle] = [from, to, 0.5 * (from + to)].map(|time| {
            (self.velocity, self.normal_force) = (ramp.velocity_at(time), ramp.normal_force_at(time));
            (self.strength(), self.level())
        });
        if middle.1 == 0.0 {
            self.release();
            if self.normal_force > 0.0 {
                self.dissipated_energy += self.viscous_coefficient * ramp.squares([from, to]);
            }
            return None;
        }
        let speed = ramp.velocity_at(to).abs();
        let stretch = Stretch { strength: [begin.0, end.0], level: [begin.1, end.1], speed, duration: to - from };
        (self.velocity != 0.0).then_some(stretch)
    }

    /// |dz/dt| with the sign of a deflection in the direction of the motion, for r = F_h / |s|.
    fn rate_at(&self, r: f64) -> f64 {
        self.velocity.abs() * (1.0 - r.sign() * pow(r.abs(), self.approach_exponent))
    }

    /// Limits over a piece of a ramp, at this speed of deflection. Lifts the elements that slip to the middle.
    fn limits<'a>(&mut self, stretch: &Stretch, division: &'a Division<f64>, rate: f64, outward: f64) -> Limits<'a> {
        let [begin, end] = stretch.strength;
        let mut limits = Limits { held: 0.5 * (begin + end), ..Limits::held(division, end) };
        if stretch.rise() < 0.0 && rate > 0.0 {
            (limits.line, limits.fall) = (begin, -stretch.rise() / rate);
        }
        for index in (0..self.count()).filter(|_| stretch.rise() > 0.0 && rate > 0.0) {
            let (stiffness, share) = self.spring(division, index);
            let force = &mut self.element[index].force;
            let motion = stiffness * rate * stretch.duration;
            let gap = share * begin - outward * *force;
            if gap.abs() <= NEAR * motion && motion >= share * (end - begin) {
                limits.slipping.set(index);
                *force = outward * share * limits.held;
            }
        }
        limits
    }

    /// Slope of the forces of some elements that follow their strength.
    fn drive(&self, limits: &Limits, stretch: &Stretch, follows: impl Fn(&Limits, usize, f64, f64) -> bool) -> f64 {
        let elements = (0..self.count()).filter_map(|index| {
            let (_, share) = self.spring(limits.division, index);
            follows(limits, index, share, self.element[index].force).then_some(share)
        });
        elements.sum::<f64>() * stretch.rise()
    }

    /// Lifts the elements that still slip from the middle to the end.
    fn lift(&mut self, limits: &Limits, stretch: &Stretch, outward: f64) {
        for index in (0..self.count()).filter(|index| limits.slipping.has(*index)) {
            let (_, share) = self.spring(limits.division, index);
            let force = &mut self.element[index].force;
            if outward * *force == share * limits.held {
                *force = outward * share * stretch.strength[1];
            }
        }
    }

    /// Where elements have begun to slip, the others end further behind the level than intended: moves them there, as
    /// far as the approach has come.
    fn settle(&mut self, division: &Division<f64>, stretch: &Stretch, aim: f64) {
        let (direction, [begin, end]) = (self.velocity.sign(), stretch.level);
        let outward = if direction * self.hysteresis() <= end { direction } else { -direction };
        let mut limits = Limits::held(division, stretch.strength[1]);
        let (stiffness, _) = self.yielding(&limits, outward);
        let x = stretch.distance(stiffness, self.approach_exponent);
        if x > 0.0 {
            let is_at_limit = |limits: &Limits, _, share, force: f64| outward * force >= share * limits.line;
            let drive = outward * direction * self.drive(&limits, stretch, is_at_limit).max(0.0);
            let missing = end - (end - begin - drive * stretch.duration) * lag(x) - aim;
            let change = -direction * missing * exp_m1(-x) / stiffness;
            let (_, room) = self.yielding(&limits, change.sign());
            self.deflect(&mut limits, change.sign(), change.abs().min(room), room);
        }
    }
}

impl Model for Leuven {
    const PRESETS: &'static [Preset] = &[
        Preset {
            name: "four_elements",
            source: "Example: levels and stiffness of Novais (2024), Tables 6.1, 7.1; rest chosen (the start values)",
            values: &[],
        },
        Preset {
            name: "smooth",
            source: "Example of a smooth virgin curve: 64 elements with evenly spaced slip displacements",
            values: &[("distribution", 2.0), ("element_count", 64.0)],
        },
    ];

    fn check(&self) -> Result<(), Fault> {
        crate::contact::conditions::static_not_below_kinetic(self.mu_s, self.mu_k)?;
        crate::contact::conditions::carries_static_level(self.hysteresis_strength)
    }

    fn passivity(&self) -> Option<GivesBack> {
        let excess = pow(self.mu_s / self.mu_k, self.approach_exponent) - 1.0;
        crate::laws::passivity::least_viscous(self.viscous_coefficient, self.sigma_1 * excess)
    }

    fn step(&mut self, dt: f64) {
        self.leave_events();
        let level = self.level();
        let distance = self.velocity.abs() * dt;
        let before = self.bristle_deflection;
        let mut work = 0.0;
        if level == 0.0 {
            self.release();
        } else if distance > 0.0 {
            work = self.advance(&mut Limits::held(&self.division(), self.strength()), level, distance);
        }
        if self.normal_force > 0.0 {
            let change = if level == 0.0 { 0.0 } else { self.bristle_deflection - before };
            self.dissipated_energy += work
                + self.sigma_1 * self.velocity * change
                + self.viscous_coefficient * self.velocity.abs() * distance;
        }
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        self.leave_events();
        let begin = ramp::Inputs::of(self);
        let ramp = Ramp {
            velocity: [self.velocity, slope.velocity],
            normal_force: [self.normal_force, slope.normal_force],
            duration: dt,
        };
        let division = self.division();
        for piece in ramp.cuts(self.stribeck_velocity, self.stribeck_exponent).pieces() {
            self.follow(&ramp, piece, &division);
        }
        ramp::set_inputs(self, &begin, slope, dt);
        if self.level() == 0.0 {
            self.release();
        }
    }

    const EVENT_INDICATORS: usize = EVENTS_OF_ELEMENTS;

    fn event_indicators(&self, indicators: &mut [f64]) {
        let (deflection_rate, division) = (self.deflection_rate(self.level()), self.division());
        let sticking = (0..self.count()).filter(|index| self.element[*index].slipping == 0.0);
        let onsets = sticking.map(|index| self.onset(index, &division, deflection_rate));
        let onward = self.onward(deflection_rate).map(|onward| onward + TURNED);
        indicators.copy_from_slice(&element_slip::indicators(onsets, onward, self.normal_force));
    }

    fn at_event(&mut self) {
        let deflection_rate = self.deflection_rate(self.level());
        if self.onward(deflection_rate).is_none_or(|onward| onward < -0.5 * TURNED) {
            self.slip = Phase::Held.number();
        }
        let (division, mut slips) = (self.division(), false);
        for index in 0..self.count() {
            let slip = self.slips_on(index, &division, deflection_rate);
            self.element[index].slipping = f64::from(u8::from(slip));
            slips |= slip;
        }
        self.slip = match Phase::of(self.slip) {
            _ if !slips => Phase::Held,
            Phase::Held => Phase::sliding(deflection_rate),
            found => found,
        }
        .number();
        if unloading::is_unloaded(self.normal_force) || self.level() == 0.0 {
            self.release();
            self.slip = Phase::Held.number();
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::friction::LuGre;

    /// One element, n = 1: LuGre, to rounding, through reversals, rest and sliding.
    #[test]
    fn one_element_is_lugre() {
        for hysteresis_strength in [1.0, 1.2, 1e3] {
            let mut law = Leuven { element_count: 1.0, hysteresis_strength, ..Default::default() };
            let mut lugre = LuGre::default();
            for k in 0..2000 {
                let velocity = 2e-3 * (f64::from(k) * 0.7).sin().powi(3);
                (law.velocity, lugre.velocity) = (velocity, velocity);
                law.step(3e-3);
                lugre.step(3e-3);
                law.output();
                lugre.output();
                assert!((law.friction_force - lugre.friction_force).abs() < 1e-12, "{k}");
                assert!((law.bristle_deflection - lugre.bristle_deflection).abs() < 1e-17, "{k}");
                assert_eq!(law.sticking, lugre.sticking);
            }
            assert_abs_diff_eq!(law.dissipated_energy / lugre.dissipated_energy, 1.0, epsilon = 1e-12);
        }
    }

    /// Far below the level nothing slides (n large): only the elements act, and follow Masing's rules.
    #[test]
    fn large_exponent_leaves_the_elements_alone() {
        let mut law = Leuven { approach_exponent: 200.0, sigma_1: 0.0, viscous_coefficient: 0.0, ..Default::default() };
        let virgin = |x: f64| {
            let elements = [(0.5, 0.1), (0.25, 0.2), (0.15, 0.3), (0.1, 0.4)];
            elements.iter().map(|(k, w)| f64::min(k * 1e5 * x, w * 1.2 * 1.4715)).sum::<f64>()
        };
        law.velocity = 1e-6;
        law.step(20.0);
        law.velocity = -1e-6;
        for k in 1..=30 {
            law.step(1.0);
            law.output();
            let branch = virgin(2e-5) - 2.0 * virgin(0.5e-6 * f64::from(k));
            assert!((law.friction_force - branch).abs() < 1e-9, "{k}: {} {branch}", law.friction_force);
        }
    }

    #[test]
    fn weak_elements_are_refused() {
        let fault = Leuven { hysteresis_strength: 0.8, ..Default::default() }.check().unwrap_err();
        assert!(fault.0.starts_with("hysteresis_strength = 0.8: must be >= 1"), "{fault}");
    }

    /// A long step, and the same motion by Heun's method in small steps.
    #[test]
    fn agrees_with_small_explicit_steps_for_any_exponent() {
        for approach_exponent in [0.5, 1.0, 2.0] {
            let mut law = Leuven { approach_exponent, ..Default::default() };
            let mut fine = law;
            for (velocity, time) in [(1e-3, 0.03), (-4e-4, 0.02), (-0.02, 0.01), (1e-4, 0.1)] {
                (law.velocity, fine.velocity) = (velocity, velocity);
                law.step(time);
                let (n, mut zero) = (200_000, Leuven::default());
                crate::model::row_of_mut(&mut zero).fill(0.0);
                let h = time / f64::from(n);
                for _ in 0..n {
                    let mut first = zero;
                    fine.rate(&mut first);
                    let mut ahead = fine;
                    for (e, r) in ahead.element.iter_mut().zip(&first.element) {
                        e.force += h * r.force;
                    }
                    let mut second = zero;
                    ahead.rate(&mut second);
                    for (e, (r, s)) in fine.element.iter_mut().zip(first.element.iter().zip(&second.element)) {
                        e.force += 0.5 * h * (r.force + s.force);
                    }
                    fine.dissipated_energy += 0.5 * h * (first.dissipated_energy + second.dissipated_energy);
                }
                assert!((law.hysteresis() - fine.hysteresis()).abs() < 2e-6, "{approach_exponent} {velocity}");
                assert_abs_diff_eq!(law.dissipated_energy / fine.dissipated_energy, 1.0, epsilon = 1e-5);
            }
        }
    }
}
