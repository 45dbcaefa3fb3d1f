//! How the laws with Maxwell-slip elements divide stiffness and strength among their elements.

use crate::model::real;
use crate::number::Real;

/// Largest number of elements.
pub(crate) const MOST: usize = 64;

/// Four elements of growing strength and falling stiffness, so that they slip one after the other (chosen).
pub(crate) const FOUR: crate::model::Starts =
    &[("stiffness_share", &[0.5, 0.25, 0.15, 0.1]), ("strength_share", &[0.1, 0.2, 0.3, 0.4])];

crate::choices! {
    /// Where the shares of the elements come from.
    pub enum ElementDistribution {
        /// The shares of each element are given.
        Explicit,
        /// Equal stiffness, and displacements up to slip that are spread evenly: the virgin curve is nearly a parabola.
        Uniform,
    }
}

crate::part! {
    /// What an element has of the whole.
    Share {
        /// Stiffness of the element, relative to the sum over all elements in use.
        stiffness_share: tunable = real("1", 0.1).positive(),
        /// Strength of the element, relative to the sum over all elements in use.
        strength_share: tunable = real("1", 0.1).positive(),
    }
}

/// The division among the elements in use.
pub(crate) struct Division<T> {
    distribution: ElementDistribution,
    count: f64,
    sum: Share<T>,
}

impl<T: Real> Division<T> {
    pub(crate) fn new(distribution: T, shares: impl Iterator<Item = Share<T>>) -> Division<T> {
        let none = Share { stiffness_share: T::zero(), strength_share: T::zero() };
        let add = |(count, sum): (f64, Share<T>), share: Share<T>| {
            let stiffness_share = sum.stiffness_share + share.stiffness_share;
            (count + 1.0, Share { stiffness_share, strength_share: sum.strength_share + share.strength_share })
        };
        let (count, sum) = shares.fold((0.0, none), add);
        Division { distribution: ElementDistribution::of(distribution.value()), count, sum }
    }

    /// The shares of the element with that index, counted from 0; over all elements their sums are 1.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_add_up_to_one() {
        let given = [0.7, 2.0, 1.3].map(|share| Share { stiffness_share: share, strength_share: share * share });
        for distribution in [1.0, 2.0] {
            let division = Division::new(distribution, given.into_iter());
            let shares: Vec<Share> = (0..3).map(|index| division.of(index, &given[index])).collect();
            assert!((shares.iter().map(|share| share.stiffness_share).sum::<f64>() - 1.0).abs() < 1e-15);
            assert!((shares.iter().map(|share| share.strength_share).sum::<f64>() - 1.0).abs() < 1e-15);
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
