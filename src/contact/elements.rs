//! Division of stiffness and strength among the elements of the Maxwell-slip laws.

use crate::model::{Meaning, real};
use crate::number::Scalar;
use crate::number::elementary::pow;

/// Largest number of elements with individual shares.
pub(crate) const MOST: usize = 64;

/// Four elements of growing strength and falling stiffness, so that they slip one after the other (chosen).
pub(crate) const FOUR: crate::model::Starts =
    &[("stiffness_share", &[0.5, 0.25, 0.15, 0.1]), ("strength_share", &[0.1, 0.2, 0.3, 0.4])];

crate::choices! {
    /// Source of the elements' shares.
    pub enum ElementDistribution {
        /// The shares of each element are given.
        Explicit,
        /// Equal stiffness and evenly spaced slip displacements: the virgin curve is nearly a parabola.
        Uniform,
    }
}

crate::part! {
    /// Share of an element in the whole.
    Share {
        /// Stiffness of the element, relative to the sum over all elements in use.
        stiffness_share: tunable = real("1", 0.1).positive().means(Meaning::Shape),
        /// Strength of the element, relative to the sum over all elements in use.
        strength_share: tunable = real("1", 0.1).positive().means(Meaning::Shape),
    }
}

/// The share of an element without individual shares: an equal one, or nothing.
pub(crate) fn no_share<T: Scalar>() -> Share<T> {
    Share { stiffness_share: T::zero(), strength_share: T::zero() }
}

/// The division among the elements in use.
pub(crate) struct Division<T> {
    distribution: ElementDistribution,
    count: f64,
    sum: Share<T>,
}

impl<T: Scalar> Division<T> {
    pub(crate) fn new(distribution: T, shares: impl Iterator<Item = Share<T>>) -> Division<T> {
        let add = |(count, sum): (f64, Share<T>), share: Share<T>| {
            let stiffness_share = sum.stiffness_share + share.stiffness_share;
            (count + 1.0, Share { stiffness_share, strength_share: sum.strength_share + share.strength_share })
        };
        let (count, sum) = shares.fold((0.0, no_share()), add);
        Division { distribution: ElementDistribution::of(distribution.value()), count, sum }
    }

    /// The same division among more elements, which have no individual shares.
    pub(crate) fn among(self, count: usize) -> Division<T> {
        Division { count: count as f64, ..self }
    }

    /// The shares of the element with this index, counted from 0; over all elements their sums are 1.
    #[inline]
    pub(crate) fn of(&self, index: usize, given: &Share<T>) -> Share<T> {
        match self.distribution {
            ElementDistribution::Explicit => Share {
                stiffness_share: given.stiffness_share / self.sum.stiffness_share,
                strength_share: given.strength_share / self.sum.strength_share,
            },
            // The odd numbers up to 2 N - 1 add up to N^2.
            ElementDistribution::Uniform => Share {
                stiffness_share: T::from(1.0 / self.count),
                strength_share: T::from((2 * index + 1) as f64 / (self.count * self.count)),
            },
        }
    }
}

/// Velocity and load that move linearly over a step.
#[derive(Clone, Copy)]
pub(crate) struct Ramp {
    /// Value at the beginning and slope.
    pub(crate) velocity: [f64; 2],
    /// Value at the beginning and slope.
    pub(crate) normal_force: [f64; 2],
    /// Duration of the step.
    pub(crate) duration: f64,
}

/// Equal parts of a step with moving inputs (chosen).
const PARTS: u32 = 4;

/// Levels of (|v| / v_S)^delta at which a step with moving inputs is cut, because the Stribeck level is curved there
/// (chosen).
const BENDS: [f64; 7] = [1.0 / 16.0, 0.25, 9.0 / 16.0, 1.0, 2.25, 4.0, 9.0];

/// Instants at which a step is cut, in rising order.
pub(crate) struct Cuts {
    times: [f64; PARTS as usize + 1 + 2 * BENDS.len()],
    count: usize,
}

impl Cuts {
    fn add(&mut self, time: f64) {
        self.times[self.count] = time;
        self.count += 1;
    }

    /// In rising order, without pieces that are only rounding.
    fn sort(&mut self, duration: f64) {
        self.times[..self.count].sort_unstable_by(f64::total_cmp);
        let (count, mut last) = (self.count, 0.0);
        self.count = 0;
        for at in 0..count {
            let time = self.times[at];
            if time - last > 1e-9 * duration {
                self.add(time);
                last = time;
            } else if time == duration && self.count > 0 {
                self.times[self.count - 1] = time;
            }
        }
    }

    /// Beginnings and ends of the pieces.
    pub(crate) fn pieces(&self) -> impl Iterator<Item = [f64; 2]> {
        let begins = std::iter::once(&0.0).chain(&self.times);
        begins.zip(&self.times[..self.count]).map(|(begin, end)| [*begin, *end]).filter(|[begin, end]| begin < end)
    }
}

impl Ramp {
    pub(crate) fn velocity_at(&self, time: f64) -> f64 {
        self.velocity[0] + self.velocity[1] * time
    }

    pub(crate) fn normal_force_at(&self, time: f64) -> f64 {
        // By rounding, a load that vanishes at the end may end below 0.
        (self.normal_force[0] + self.normal_force[1] * time).max(0.0)
    }

    /// Integral of the square of the velocity.
    pub(crate) fn squares(&self, [from, to]: [f64; 2]) -> f64 {
        let [a, b] = [from, to].map(|time| self.velocity_at(time));
        (a * a + a * b + b * b) / 3.0 * (to - from)
    }

    /// Cuts the step where the motion reverses, where the level is curved, and into equal parts.
    pub(crate) fn cuts(&self, stribeck_velocity: f64, exponent: f64) -> Cuts {
        let mut cuts = Cuts { times: [0.0; PARTS as usize + 1 + 2 * BENDS.len()], count: 0 };
        (1..=PARTS).for_each(|part| cuts.add(self.duration * (f64::from(part) / f64::from(PARTS))));
        let reach = |velocity: f64| (velocity - self.velocity[0]) / self.velocity[1];
        let mut bend = |velocity: f64| {
            let time = reach(velocity);
            if time > 0.0 && time < self.duration {
                cuts.add(time);
            }
        };
        bend(0.0);
        let fastest = self.velocity[0].abs().max(self.velocity_at(self.duration).abs());
        for speed in BENDS.map(|power| stribeck_velocity * pow(power, 1.0 / exponent)) {
            if speed >= fastest {
                break;
            }
            bend(speed);
            bend(-speed);
        }
        cuts.sort(self.duration);
        cuts
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn a_ramp_is_cut_where_it_turns_and_where_the_level_bends() {
        let ramp = Ramp { velocity: [-1e-3, 1.0], normal_force: [1.0, 0.0], duration: 4e-3 };
        let pieces: Vec<[f64; 2]> = ramp.cuts(1e-3, 2.0).pieces().collect();
        assert!(pieces.windows(2).all(|pair| pair[0][1] == pair[1][0]));
        assert_eq!((pieces[0][0], pieces[pieces.len() - 1][1]), (0.0, 4e-3));
        // At -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1, 1.5 and 2 mm/s; the quarters are at 0, 1 and 2 mm/s.
        assert_eq!(pieces.len(), 11, "{pieces:?}");
        let still = Ramp { velocity: [0.0, 0.0], ..ramp };
        assert_eq!(still.cuts(1e-3, 2.0).pieces().count(), 4);
    }

    #[test]
    fn shares_add_up_to_one() {
        let given = [0.7, 2.0, 1.3].map(|share| Share { stiffness_share: share, strength_share: share * share });
        for distribution in [1.0, 2.0] {
            let division = Division::new(distribution, given.into_iter());
            let shares: Vec<Share> = (0..3).map(|index| division.of(index, &given[index])).collect();
            assert_abs_diff_eq!(shares.iter().map(|share| share.stiffness_share).sum::<f64>(), 1.0, epsilon = 1e-15);
            assert_abs_diff_eq!(shares.iter().map(|share| share.strength_share).sum::<f64>(), 1.0, epsilon = 1e-15);
        }
    }

    /// Slip of the elements at odd multiples of the first: 1, 3, 5.
    #[test]
    fn uniform_elements_slip_at_evenly_spread_displacements() {
        let any = Share { stiffness_share: 9.0, strength_share: 9.0 };
        let division = Division::new(2.0, [any; 3].into_iter());
        let at = |index| division.of(index, &any).strength_share / division.of(index, &any).stiffness_share;
        let first: f64 = at(0);
        assert!((at(1) / first - 3.0).abs() < 1e-15 && (at(2) / first - 5.0).abs() < 1e-15);
    }
}
