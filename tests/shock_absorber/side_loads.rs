//! The side load that a host reads at its joint, compared with statics: the body on which it acts, and its point.
//!
//! Rod and tube press on each other at two places. Those forces are chosen here; what a joint reports is their sum and
//! their moment about the place where the joint has its frame. The strut has to find the forces again.

use crate::common::Bench;
use approx::abs_diff_eq;

/// Overlap of 50 mm: default guidance, 125 mm + 105 mm - 180 mm.
const LENGTH: f64 = 0.18;
const ROD_GUIDE: f64 = 0.125;
const PISTON_TO_ROD_EYE: f64 = 0.105;

/// A force across the axis at a distance from the eye of the tube.
struct Across {
    place: f64,
    force: [f64; 2],
}

/// Force and moment about the point of the axis at `origin`; with m x n = a the lever s turns F_m to n and F_n to -m.
fn reaction(forces: &[Across], origin: f64) -> [f64; 4] {
    forces.iter().fold([0.0; 4], |[r_m, r_n, m_m, m_n], Across { place, force: [f_m, f_n] }| {
        let lever = place - origin;
        [r_m + f_m, r_n + f_n, m_m - lever * f_n, m_n + lever * f_m]
    })
}

/// Action of the tube on the rod at its guide and at the piston, for a strut of that length.
fn contacts(length: f64, at_guide: [f64; 2], at_piston: [f64; 2]) -> [Across; 2] {
    let piston = length - PISTON_TO_ROD_EYE;
    [Across { place: ROD_GUIDE, force: at_guide }, Across { place: piston, force: at_piston }]
}

fn normal_forces(model: &str, length: f64, side_load: [f64; 4]) -> [f64; 2] {
    let mut joint = Bench::new(model, &[("length", length), ("geom.h_reg", 0.0)]);
    if joint.has("side.mode") {
        joint.set("side.mode", 1.0); // Inputs alone
    }
    for (name, value) in ["side_force_m", "side_force_n", "side_moment_m", "side_moment_n"].iter().zip(side_load) {
        joint.set(name, value);
    }
    ["normal_1", "normal_2"].map(|name| joint.get(name))
}

fn assert_forces(found: [f64; 2], expected: [f64; 2]) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert!(abs_diff_eq!(found, expected, epsilon = 0.05), "{found} N, expected {expected} N");
    }
}

/// Equal forces at both contacts: (80, -30) N in total, 42.7 N each.
const HALF: [f64; 2] = [40.0, -15.0];
const EACH: f64 = 42.720_018_726_587_65;

/// A frame on the tube, at its eye, reports the action of the rod on the tube: all signs change, and nothing is
/// shifted.
#[test]
fn the_reaction_on_the_tube_needs_no_shift_at_any_length() {
    for model in ["TelescopicJoint", "ShockAbsorber"] {
        for length in [0.15, LENGTH, 0.2] {
            let opposite = HALF.map(|force| -force);
            let on_tube = reaction(&contacts(length, opposite, opposite), 0.0);
            let found = normal_forces(model, length, on_tube.map(|component| -component));
            assert!((found[0] - EACH).abs() < 1e-9 && (found[1] - EACH).abs() < 1e-9, "{model} {length}: {found:?}");
        }
    }
}

/// A frame on the rod that was at the eye of the tube when the joint was created moves with the rod. After 30 mm its
/// moment, mistaken for one about the eye, loads one contact twice and the other not at all.
#[test]
fn the_reaction_on_the_rod_must_be_shifted_by_its_present_distance() {
    let travel = 0.03;
    let [r_m, r_n, m_m, m_n] = reaction(&contacts(LENGTH, HALF, HALF), travel);
    assert_forces(normal_forces("TelescopicJoint", LENGTH, [r_m, r_n, m_m, m_n]), [8.5, 94.0]);
    let [r_m, r_n, m_m, m_n] = reaction(&contacts(LENGTH, HALF, HALF), -travel);
    assert_forces(normal_forces("TelescopicJoint", LENGTH, [r_m, r_n, m_m, m_n]), [94.0, 8.5]);
    // A frame at the eye of the rod is at the distance `length`.
    for (origin, length) in [(travel, LENGTH), (LENGTH, LENGTH), (0.15, 0.15)] {
        let [r_m, r_n, m_m, m_n] = reaction(&contacts(length, HALF, HALF), origin);
        let shifted = [r_m, r_n, m_m - origin * r_n, m_n + origin * r_m];
        assert_forces(normal_forces("TelescopicJoint", length, shifted), [EACH, EACH]);
    }
}

/// Also unequal forces: each contact gets its own.
#[test]
fn each_contact_gets_its_own_force() {
    let forces = contacts(0.19, [30.0, 40.0], [-12.0, 5.0]);
    let found = normal_forces("TelescopicJoint", 0.19, reaction(&forces, 0.0));
    assert!((found[0] - 50.0).abs() < 1e-9 && (found[1] - 13.0).abs() < 1e-9, "{found:?}");
}
