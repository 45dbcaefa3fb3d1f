//! Vectors of nalgebra with the number types of the laws as components.

use std::ops::{AddAssign, MulAssign, SubAssign};

use nalgebra::{SVector, Scalar, Vector3};
pub use num_traits::{One, Zero};

use crate::number::{Dual, Gradient, Lanes, Mask, Real, Register};

/// A number that can be a component of a vector.
pub trait Component: Real + Scalar + Zero + One + AddAssign + SubAssign + MulAssign {}

impl Component for f64 {}
impl Component for Dual {}
impl Component for Gradient {}
impl<R: Register> Component for Lanes<R> {}

/// What nalgebra asks of a component beside its operations.
macro_rules! component {
    ($Number:ty $(, $R:ident)?) => {
        impl<$($R: Register)?> Zero for $Number {
            #[inline(always)]
            fn zero() -> Self {
                Self::from(0.0)
            }
            #[inline(always)]
            fn is_zero(&self) -> bool {
                Self::truth(self.is(0.0)) == Self::from(1.0)
            }
        }

        impl<$($R: Register)?> One for $Number {
            #[inline(always)]
            fn one() -> Self {
                Self::from(1.0)
            }
        }

        impl<$($R: Register)?> AddAssign for $Number {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<$($R: Register)?> SubAssign for $Number {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl<$($R: Register)?> MulAssign for $Number {
            #[inline(always)]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }
    };
}

component!(Dual);
component!(Gradient);
component!(Lanes<R>, R);

/// Length of a vector, for components of any size. At 0 its derivative is taken as 0, as that of a magnitude.
pub fn length<T: Component, const N: usize>(vector: &SVector<T, N>) -> T {
    let largest = largest(vector);
    let scaled = || {
        let squares = vector.iter().map(|component| *component / largest);
        largest * squares.fold(T::from(0.0), |sum, part| sum + part * part).sqrt()
    };
    largest.vanishes().choose(|| T::from(0.0), scaled)
}

/// Direction of a vector; zero for a zero vector.
pub fn direction<T: Component, const N: usize>(vector: &SVector<T, N>) -> SVector<T, N> {
    let length = length(vector);
    let is_zero = length.vanishes();
    vector.map(|component| is_zero.choose(|| T::from(0.0), || component / length))
}

/// Magnitude of the largest component, without derivative.
fn largest<T: Component, const N: usize>(vector: &SVector<T, N>) -> T {
    vector.iter().fold(T::from(0.0), |largest, component| {
        let size = component.as_constant().abs();
        size.above(largest).choose(|| size, || largest)
    })
}

/// The vector where the answer is yes, zero elsewhere.
pub fn only<T: Component, const N: usize>(answer: T::Mask, vector: SVector<T, N>) -> SVector<T, N> {
    vector.map(|component| answer.choose(|| component, || T::from(0.0)))
}

/// The part of a vector in the plane with the unit normal `normal`.
pub fn in_plane<T: Component>(vector: &Vector3<T>, normal: &Vector3<T>) -> Vector3<T> {
    *vector - *normal * vector.dot(normal)
}

/// A vector turned into the plane with the unit normal `normal`: projected, with its length restored.
pub fn turned_into<T: Component>(vector: &Vector3<T>, normal: &Vector3<T>) -> Vector3<T> {
    direction(&in_plane(vector, normal)) * length(vector)
}

/// Largest rounding remainder of a velocity after a component has been removed (chosen).
const ROUNDING: f64 = 1e-15;

/// A remainder of the vector `whole`; zero if it is only rounding.
pub fn remainder<T: Component, const N: usize>(rest: SVector<T, N>, whole: &SVector<T, N>) -> SVector<T, N> {
    let is_rounding = largest(&rest).at_most(T::from(ROUNDING) * largest(whole));
    only(!is_rounding, rest)
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    #[test]
    fn length_of_small_and_large_vectors() {
        for scale in [1e-300, 1.0, 1e300] {
            assert!(
                (length(&Vector3::new(2.0 * scale, -3.0 * scale, 6.0 * scale)) / (7.0 * scale) - 1.0).abs() < 1e-15
            );
        }
        assert_eq!(length(&Vector3::new(0.0, -0.1, 0.0)), 0.1);
    }

    /// The derivative of a length is the component along the direction.
    #[test]
    fn length_has_its_derivative() {
        let slopes = [0.3, -0.2, 0.9];
        let vector = Vector3::new(2.0, -3.0, 6.0);
        let dual = Vector3::from_fn(|i, _| Dual { value: vector[i], slope: slopes[i] });
        let along = (2.0 * 0.3 + 3.0 * 0.2 + 6.0 * 0.9) / 7.0;
        assert_abs_diff_eq!(length(&dual).slope, along, epsilon = 1e-15);
    }

    #[test]
    fn turning_keeps_the_length_and_ends_in_the_plane() {
        let normal = direction(&Vector3::new(1.0, 2.0, -0.5));
        let turned = turned_into(&Vector3::new(0.4, -0.1, 0.7), &normal);
        assert!(turned.dot(&normal).abs() < 1e-16);
        assert_abs_diff_eq!(length(&turned), 0.66f64.sqrt(), epsilon = 1e-15);
        assert_eq!(turned_into(&(normal * 2.0), &normal).map(|x| x.abs() < 1.0), Vector3::new(true, true, true));
    }
}
