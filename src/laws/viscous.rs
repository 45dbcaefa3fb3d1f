//! The viscous part of friction.

use crate::number::{Real, choose};

/// A force proportional to the velocity, as long as there is contact.
#[inline(always)]
pub fn force<T: Real>(velocity: T, viscous_coefficient: T, normal_force: T) -> T {
    choose!(normal_force.is_positive(), viscous_coefficient * velocity, T::zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn needs_contact_only() {
        assert_eq!(force(-2.0, 0.5, 1e-300), -1.0);
        assert_eq!(force(-2.0, 0.5, 0.0), 0.0);
    }
}
