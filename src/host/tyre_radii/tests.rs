//! Radii against closed forms, other roads and limits.

use approx::assert_abs_diff_eq;

use super::*;
use crate::model::{Columns, row_of, row_of_mut, start};

const STIFFNESS: f64 = 2e5;
const RADIUS: f64 = 0.3;
const NOMINAL: f64 = 4000.0;

/// A tyre of version 6.1, at 10 % more than its nominal pressure.
fn tyre() -> MagicFormula {
    let mut tyre = MagicFormula { unloaded_radius: RADIUS, fnomin: NOMINAL, longvl: 16.0, ..start() };
    (tyre.version, tyre.nompres, tyre.inflpres) = (FormulaVersion::Six.number(), 2e5, 2.2e5);
    let TyreSpring { q_re0, q_v1, q_v2, q_fz2, q_fcx, q_fcy, q_cam, pfz1, breff, dreff, freff, .. } = &mut tyre.spring;
    (*q_re0, *q_v1, *q_v2, *q_fz2, *q_fcx, *q_fcy) = (0.998, 7e-4, 0.04, 15.0, 0.1, 0.2);
    (*q_cam, *pfz1, *breff, *dreff, *freff) = (-3.0, 0.7, 8.0, 0.25, 0.07);
    tyre
}

/// What version 6.2 has in place of `q_cam`.
fn flat(mut tyre: MagicFormula) -> MagicFormula {
    let TyreSpring { q_cam, q_cam1, q_cam2, q_cam3, width, aspect_ratio, .. } = &mut tyre.spring;
    (*q_cam, *q_cam1, *q_cam2, *q_cam3, *width, *aspect_ratio) = (0.0, 85.0, 257.0, 0.5, 0.2, 0.6);
    tyre
}

/// The tyre as it stands upright, without a force but its load.
fn standing(load: f64) -> (Contact, Wrench) {
    let contact = Contact { load, longitudinal_slip: 0.0, side_slip: 0.0, camber: 0.0, speed: 0.0 };
    let wrench = Wrench { force_x: 0.0, force_y: 0.0, moment_x: 0.0, moment_y: 0.0, moment_z: 0.0 };
    (contact, wrench)
}

fn rolling(force_x: f64, force_y: f64, camber: f64, spin: f64) -> Rolling {
    Rolling { force_x, force_y, camber, spin }
}

/// Numbers in [0, 1) without pattern.
fn drawn() -> impl FnMut(f64, f64) -> f64 {
    let mut state = 1u64;
    move |low, high| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((state >> 11) as f64 / (1u64 << 53) as f64)
    }
}

#[test]
fn without_coefficients_the_spring_is_linear() {
    let tyre = MagicFormula { unloaded_radius: RADIUS, fnomin: NOMINAL, ..start() };
    let (contact, wrench) = standing(3000.0);
    let contact = Contact { speed: 20.0, camber: 0.1, ..contact };
    let radii = tyre.checked_radii_on(Side::Left, STIFFNESS, &contact, &Wrench { force_y: 2000.0, ..wrench }).unwrap();
    assert_abs_diff_eq!(radii.loaded, RADIUS - 0.015, epsilon = 1e-15);
    assert_abs_diff_eq!(radii.deflection, 0.015, epsilon = 1e-15);
    assert_eq!([radii.free, radii.effective], [RADIUS; 2]);
}

/// The quadratic (2) solved for rho, and the angular velocity that was meant when speed and R_e were made from it.
#[test]
fn drawn_states_have_the_root_of_the_quadratic() {
    let (tyre, mut draw) = (tyre(), drawn());
    for _ in 0..500 {
        let (load, slip, camber) = (draw(100.0, 9000.0), draw(-0.2, 0.2), draw(-0.1, 0.1));
        let (force_x, force_y, spin) = (draw(-3e3, 3e3), draw(-5e3, 5e3), draw(0.0, 200.0));
        let inflpres = draw(1.5e5, 2.6e5);
        let pressure = 1.0 + 0.7 * (inflpres / 2e5 - 1.0);
        let ratio = load / NOMINAL;
        let free = RADIUS * (0.998 + 7e-4 * (spin * RADIUS / 16.0).powi(2));
        let effective = free - NOMINAL / (STIFFNESS * pressure) * (0.25 * (8.0 * ratio).atan() + 0.07 * ratio);
        let growth = 1.0 + 0.04 * spin * RADIUS / 16.0 - (0.1 * force_x / NOMINAL).powi(2);
        let growth = growth - (0.2 * force_y / NOMINAL).powi(2);
        let linear = ((STIFFNESS * RADIUS / NOMINAL).powi(2) - 60.0).sqrt() - 3.0 * camber * camber;
        let root = (linear * linear + 60.0 * ratio / (growth * pressure)).sqrt();
        let deflection = RADIUS * (root - linear) / 30.0;

        let contact =
            Contact { load, longitudinal_slip: slip, side_slip: 0.0, camber, speed: spin * effective / (1.0 + slip) };
        let wrench = Wrench { force_x, force_y, ..standing(load).1 };
        let tyre = MagicFormula { inflpres, ..tyre };
        let radii = tyre.checked_radii_on(Side::Left, STIFFNESS, &contact, &wrench).unwrap();
        for (found, expected) in [
            (radii.free, free),
            (radii.effective, effective),
            (radii.deflection, deflection),
            (radii.loaded, free - deflection),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-12, "{contact:?}: {found} for {expected}");
        }
    }
}

/// (A3.4) is what makes C_z0 the slope of the load at the nominal load, upright, at rest and at nominal pressure.
#[test]
fn stiffness_is_the_slope_at_the_nominal_load() {
    let tyre = MagicFormula { inflpres: 2e5, ..tyre() };
    let loaded = |load: f64| {
        let (contact, wrench) = standing(load);
        tyre.checked_radii_on(Side::Left, STIFFNESS, &contact, &wrench).unwrap().loaded
    };
    let slope = -20.0 / (loaded(NOMINAL + 10.0) - loaded(NOMINAL - 10.0));
    assert!((slope / STIFFNESS - 1.0).abs() < 1e-6, "{slope}");
    assert!((slope / STIFFNESS - 1.0).abs() > 1e-12, "the spring is not linear");
}

/// The load of the radius that was found for it is that load, with all terms of version 6.2.
#[test]
fn load_and_radius_are_inverse() {
    let (mut tyre, mut draw) = (flat(tyre()), drawn());
    (tyre.spring.q_fcy2, tyre.spring.bottom_stiff, tyre.spring.rim_radius) = (0.4, 2e6, 0.19);
    (tyre.spring.q_fys1, tyre.spring.q_fys2, tyre.spring.q_fys3, tyre.spring.bottom_offst) = (2e4, -3e4, 2.5e4, 0.01);
    for _ in 0..500 {
        let (load, camber, speed) = (draw(1.0, 3e4), draw(-0.1, 0.1), draw(0.0, 60.0));
        let contact = Contact { load, longitudinal_slip: draw(-0.1, 0.1), side_slip: 0.0, camber, speed };
        let wrench = Wrench { force_x: draw(-3e3, 3e3), force_y: draw(-5e3, 5e3), ..standing(load).1 };
        for side in [Side::Left, Side::Right] {
            let radii = tyre.checked_radii_on(side, STIFFNESS, &contact, &wrench).unwrap();
            let spin = (1.0 + contact.longitudinal_slip) * speed / radii.effective;
            let at = rolling(wrench.force_x, wrench.force_y, camber, spin);
            let carried = tyre.load_on(side, STIFFNESS, &at, radii.loaded);
            assert!((carried / load - 1.0).abs() < 1e-12, "{contact:?}: {carried}");
        }
    }
}

/// Mean depth in the road of a flat tread that leans, by the trapezoidal rule.
#[test]
fn a_shoulder_carries_by_the_mean_depth_of_the_tread() {
    let mut tyre = flat(tyre());
    tyre.spring.q_cam3 = 0.0;
    let (camber, tread) = (0.08f64, (1.075 - 0.3) * 0.2);
    let spring = tyre.spring_on(Side::Left, STIFFNESS, &rolling(0.0, 0.0, camber, 0.0));
    let edge = tread * camber.tan() / 2.0;
    assert_abs_diff_eq!(spring.edge, edge, epsilon = 1e-16);
    for depth in [-1.1, -0.9, -0.5, -0.1, -1e-9].map(|part: f64| part * edge) {
        let count = 20_000;
        let depth_at = |k: i32| (depth + edge * (f64::from(k) / f64::from(count) * 2.0 - 1.0)).max(0.0);
        let sum: f64 = (0..count).map(|k| 0.5 * (depth_at(k) + depth_at(k + 1))).sum();
        let mean = sum / f64::from(count);
        assert!((spring.deflection(spring.free - depth) - mean).abs() < 1e-8 * edge, "{depth}");
    }
    assert_abs_diff_eq!(spring.deflection(spring.free), tread * camber.tan() / 8.0, epsilon = 1e-15);
}

#[test]
fn lateral_force_softens_less_what_camber_brings() {
    let mut tyre = tyre();
    (tyre.spring.q_fcy, tyre.spring.q_cam, tyre.inflpres) = (0.5, 0.0, 2e5);
    let load = |tyre: &MagicFormula, force_y: f64, camber: f64| {
        tyre.load_on(Side::Left, STIFFNESS, &rolling(0.0, force_y, camber, 0.0), 0.28)
    };
    let free = load(&tyre, 0.0, 0.0);
    assert_abs_diff_eq!(load(&tyre, NOMINAL, 0.0) / free, 0.75, epsilon = 1e-14);
    let depth = (0.998 * RADIUS - 0.28) / RADIUS;
    tyre.spring.q_fcy2 = 1.0;
    assert_abs_diff_eq!(load(&tyre, NOMINAL, 0.0) / free, 1.0 - 0.25 * depth * depth, epsilon = 1e-14);
    let ratio = 0.28 / (0.998 * RADIUS);
    for part in [
        TyreSpring { q_fys1: NOMINAL / 0.1, ..tyre.spring },
        TyreSpring { q_fys2: NOMINAL / 0.1 / ratio, ..tyre.spring },
        TyreSpring { q_fys3: NOMINAL / 0.1 / ratio / ratio, ..tyre.spring },
    ] {
        let tyre = MagicFormula { spring: part, ..tyre };
        assert_abs_diff_eq!(load(&tyre, NOMINAL, 0.1) / free, 1.0, epsilon = 1e-14);
        assert_abs_diff_eq!(load(&tyre, -NOMINAL, 0.1) / free, 1.0 - depth * depth, epsilon = 1e-14);
    }
}

#[test]
fn the_rim_carries_more_than_the_tyre() {
    let mut tyre = tyre();
    (tyre.spring.bottom_stiff, tyre.spring.rim_radius, tyre.spring.bottom_offst) = (2e6, 0.19, 0.01);
    let (contact, wrench) = standing(60e3);
    let radii = tyre.checked_radii_on(Side::Left, STIFFNESS, &contact, &wrench).unwrap();
    assert_abs_diff_eq!(radii.loaded, 0.2 - 0.03, epsilon = 1e-15);
}

/// The other side leans the other way; a tyre without load keeps its free radius; one in the air touches nowhere.
#[test]
fn sides_are_mirrored_and_no_load_is_no_deflection() {
    let mut tyre = flat(tyre());
    tyre.spring.q_fys1 = 1e4;
    let [left, right] = [(Side::Left, 0.05, 900.0), (Side::Right, -0.05, -900.0)]
        .map(|(side, camber, force_y)| tyre.load_on(side, STIFFNESS, &rolling(100.0, force_y, camber, 50.0), 0.29));
    assert_eq!(left, right);
    assert_ne!(left, tyre.load_on(Side::Left, STIFFNESS, &rolling(100.0, 900.0, -0.05, 50.0), 0.29));
    for load in [0.0, -10.0] {
        let (contact, wrench) = standing(load);
        let radii = tyre.checked_radii_on(Side::Left, STIFFNESS, &contact, &wrench).unwrap();
        assert_eq!([radii.loaded, radii.effective, radii.deflection], [radii.free, radii.free, 0.0]);
    }
    assert_eq!(tyre.load_on(Side::Left, STIFFNESS, &rolling(0.0, 0.0, 0.0, 0.0), 0.31), 0.0);
}

/// With q_fz2 < 0 the load has the maximum F_z0 q_fz1^2 / (4 |q_fz2|); with much lateral force there is none at all.
#[test]
fn loads_that_nothing_carries_are_refused() {
    let mut tyre = tyre();
    (tyre.spring.q_fz2, tyre.inflpres) = (-60.0, 2e5);
    let most = NOMINAL * ((STIFFNESS * RADIUS / NOMINAL).powi(2) + 240.0) / 240.0;
    let radii = |tyre: &MagicFormula, load: f64, force_y: f64| {
        let (contact, wrench) = standing(load);
        tyre.checked_radii_on(Side::Left, STIFFNESS, &contact, &Wrench { force_y, ..wrench })
    };
    // The deflection below that of the maximum, not the one above.
    let loaded = radii(&tyre, 0.99 * most, 0.0).unwrap().loaded;
    let summit = RADIUS * ((STIFFNESS * RADIUS / NOMINAL).powi(2) + 240.0).sqrt() / 120.0;
    assert!(loaded > 0.998 * RADIUS - summit, "{loaded}");
    let Err(NoRadii::Load { least, most: found }) = radii(&tyre, 1.01 * most, 0.0) else { panic!("carried") };
    assert!(least == 0.0 && (found / most - 1.0).abs() < 0.01, "{found} for {most}");
    assert_eq!(radii(&tyre, 1.0, 5.1 * NOMINAL).unwrap_err(), NoRadii::Load { least: 0.0, most: 0.0 });
    let (contact, wrench) = standing(1.01 * most);
    let Radii { free, loaded, effective, deflection } = tyre.radii_on(Side::Left, STIFFNESS, &contact, &wrench);
    assert_eq!([free, loaded, effective, deflection], [0.0; 4]);
    tyre.spring.q_v1 = -0.1;
    let (contact, wrench) = standing(100.0);
    let fast = Contact { speed: 60.0, ..contact };
    assert_eq!(tyre.checked_radii_on(Side::Left, STIFFNESS, &fast, &wrench).unwrap_err(), NoRadii::Rolling);
}

/// Derivatives of the loaded and of the effective radius by a central difference, for every coefficient.
#[test]
fn derivatives_pass_through_the_search() {
    let mut tyre = flat(tyre());
    (tyre.spring.q_fcy2, tyre.spring.q_fys1, tyre.spring.q_fys2) = (0.3, 500.0, 200.0);
    let contact = Contact { load: 3500.0, longitudinal_slip: 0.02, side_slip: 0.0, camber: 0.04, speed: 25.0 };
    let wrench = Wrench { force_x: 800.0, force_y: 1500.0, ..standing(0.0).1 };
    let radii = |tyre: &MagicFormula| {
        let radii = tyre.checked_radii_on(Side::Left, STIFFNESS, &contact, &wrench).unwrap();
        [radii.loaded, radii.effective]
    };
    let mut seen = 0;
    for (column, variable) in MagicFormula::TABLE.iter().enumerate() {
        if ["side", "version"].contains(&variable.path.to_string().as_str()) {
            continue;
        }
        let step = 1e-6 * row_of(&tyre)[column].abs().max(1.0);
        let moved = |by: f64| {
            let mut moved = tyre;
            row_of_mut(&mut moved)[column] += by;
            radii(&moved)
        };
        let at = std::cell::Cell::new(0);
        let dual = tyre.map(&|value| {
            let is_here = at.replace(at.get() + 1) == column;
            Dual { value, slope: f64::from(u8::from(is_here)) }
        });
        let [load, longitudinal_slip, side_slip, camber, speed] =
            [contact.load, contact.longitudinal_slip, contact.side_slip, contact.camber, contact.speed].map(Dual::from);
        let contact = Contact { load, longitudinal_slip, side_slip, camber, speed };
        let [force_x, force_y] = [wrench.force_x, wrench.force_y].map(Dual::from);
        let zero = Dual::from(0.0);
        let wrench = Wrench { force_x, force_y, moment_x: zero, moment_y: zero, moment_z: zero };
        let found = dual.radii_on(Side::Left, Dual::from(STIFFNESS), &contact, &wrench);
        let [above, below] = [moved(step), moved(-step)];
        for (found, number) in [(found.loaded, 0), (found.effective, 1)] {
            let slope = (above[number] - below[number]) / (2.0 * step);
            assert!((found.slope - slope).abs() < 1e-7 * slope.abs().max(1e-2), "{}: {found:?} {slope}", variable.path);
            seen += usize::from(slope != 0.0);
        }
    }
    assert!(seen > 20, "{seen}");
}
