//! Forces and moments of version 6 against another program.
//!
//! The tables were computed from `six.tir` with MFeval.jl (M. Furlan's MFeval in Julia, MIT licence;
//! github.com/matheusft/MFeval_julia, commit a3b3ba4): its functions for each force and moment, unchanged, with alpha*
//! and gamma*, without turn slip and limits of the ranges, and with 0 for what guards its quotients. It has
//! cos(tan alpha) where (4.E47) has cos alpha: `six.csv` is for a tyre without residual torque, `six_straight.csv` for
//! one with all coefficients that does not slip sideways.
//!
//! The radii in `six_radii.csv` are those of TyreDyn (N. van Rossem, MIT licence; github.com/NiekvanRossem/TyreDyn,
//! commit 7821de6), its functions for version 6.2, iterated to the end.

use stribeck::host::{Contact, MagicFormula, Side, Wrench};
use stribeck::model::{Columns, row_of_mut, start};

use super::{TyreFile, parse};

const FILE: &str = include_str!("six.tir");

/// Relative error of each value.
const TOLERANCE: f64 = 1e-9;

fn tyre(text: &str) -> MagicFormula {
    let TyreFile { set, unused, ignored, notes } = parse("six.tir", text).unwrap();
    assert!(unused.is_empty() && ignored.is_empty(), "{unused:?} {ignored:?}");
    assert_eq!(notes[0], "FITTYP = 62: read as Magic Formula 6.2");
    let mut formula: MagicFormula = start();
    for (column, variable) in MagicFormula::TABLE.iter().enumerate() {
        row_of_mut(&mut formula)[column] = set.get(&format!("tyre.{}", variable.path)).unwrap();
    }
    formula
}

/// The rows of a table, each with `N` numbers.
fn rows<const N: usize>(table: &str) -> Vec<[f64; N]> {
    let numbers = |line: &str| line.split(',').map(|text| text.parse().unwrap()).collect::<Vec<f64>>();
    table.lines().skip(1).map(|line| numbers(line).try_into().unwrap()).collect()
}

fn assert_close(found: &[f64], expected: &[f64], at: &str) {
    for (number, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!((found / expected - 1.0).abs() < TOLERANCE, "{at}: {number}: {found} for {expected}");
    }
}

#[test]
fn five_hundred_slips_agree_with_another_program() {
    let without = ["QDZ6", "QDZ7", "QDZ8", "QDZ9", "QDZ10", "QDZ11"];
    let is_kept = |line: &&str| !without.iter().any(|key| line.starts_with(&format!("{key} ")));
    let text: String = FILE.lines().filter(is_kept).map(|line| format!("{line}\n")).collect();
    let tyre = tyre(&text);
    let rows = rows::<11>(include_str!("six.csv"));
    assert_eq!(rows.len(), 500);
    for [load, longitudinal_slip, side_slip, camber, speed, inflpres, expected @ ..] in rows {
        let contact = Contact { load, longitudinal_slip, side_slip, camber, speed };
        let wrench = MagicFormula { inflpres, ..tyre }.wrench(&contact);
        let Wrench { force_x, force_y, moment_x, moment_y, moment_z } = wrench;
        assert_close(&[force_x, force_y, moment_x, moment_y, moment_z], &expected, &format!("{contact:?}"));
    }
}

#[test]
fn residual_torques_agree_with_another_program() {
    let tyre = tyre(FILE);
    for [load, longitudinal_slip, camber, speed, inflpres, moment_z] in rows::<6>(include_str!("six_straight.csv")) {
        let contact = Contact { load, longitudinal_slip, side_slip: 0.0, camber, speed };
        let wrench = MagicFormula { inflpres, ..tyre }.wrench(&contact);
        assert_close(&[wrench.moment_z], &[moment_z], &format!("{contact:?}"));
    }
}

/// Upright wheels are left out: there the other program divides by 0.
#[test]
fn five_hundred_radii_agree_with_another_program() {
    let TyreFile { set, .. } = parse("six.tir", FILE).unwrap();
    let (tyre, stiffness) = (tyre(FILE), set.get("front.tyre_stiffness").unwrap());
    let rows = rows::<11>(include_str!("six_radii.csv"));
    assert_eq!(rows.len(), 500);
    for [load, longitudinal_slip, camber, speed, inflpres, force_x, force_y, expected @ ..] in rows {
        let contact = Contact { load, longitudinal_slip, side_slip: 0.0, camber, speed };
        let tyre = MagicFormula { inflpres, ..tyre };
        let wrench = Wrench { force_x, force_y, ..tyre.wrench(&contact) };
        let radii = tyre.checked_radii_on(Side::Left, stiffness, &contact, &wrench).unwrap();
        let found = [radii.free, radii.loaded, radii.effective, radii.deflection];
        assert_close(&found, &expected, &format!("{contact:?}"));
    }
}

/// Far from all slip the residual torque is D_r cos' alpha; it is what the coefficients of (4.E47) add.
#[test]
fn residual_torque_goes_with_the_cosine_of_the_side_slip() {
    let all = MagicFormula { qbz9: 0.0, qbz10: 0.0, lmuv: 0.0, ..tyre(FILE) };
    let none = MagicFormula { qdz6: 0.0, qdz7: 0.0, qdz8: 0.0, qdz9: 0.0, qdz10: 0.0, qdz11: 0.0, ..all };
    let residual = |side_slip| {
        let contact = Contact { load: 5000.0, longitudinal_slip: 0.1, side_slip, camber: 0.05, speed: 20.0 };
        all.wrench(&contact).moment_z - none.wrench(&contact).moment_z
    };
    for side_slip in [-0.5f64, 0.2, 0.8] {
        let ratio = residual(side_slip) / residual(0.0);
        assert!((ratio / side_slip.cos() - 1.0).abs() < 1e-10, "{side_slip}: {ratio}");
    }
}

/// (4.E7): the friction falls with the speed of slip, here V kappa, and the force at its peak with it.
#[test]
fn friction_falls_with_the_speed_of_slip() {
    let falling = MagicFormula { lmuv: 0.3, pvx1: 0.0, pvx2: 0.0, rhx1: 0.0, pex1: 0.0, pex2: 0.0, ..tyre(FILE) };
    let falling = MagicFormula { pex3: 0.0, lhx: 0.0, pcx1: 1.0, lcx: 1.0, pkx1: 1e6, ..falling };
    let contact = Contact { load: 5000.0, longitudinal_slip: 0.2, side_slip: 0.0, camber: 0.0, speed: 20.0 };
    let force = falling.wrench(&contact).force_x;
    let constant = MagicFormula { lmuv: 0.0, ..falling }.wrench(&contact).force_x;
    let expected = 1.0 + 0.3 * (20.0 * 0.2) / 16.0;
    assert!((constant / force / expected - 1.0).abs() < 1e-9, "{constant} {force}");
}

#[test]
fn the_other_side_is_the_mirror_image() {
    let tyre = tyre(FILE);
    let contact = Contact { load: 3000.0, longitudinal_slip: 0.03, side_slip: 0.04, camber: 0.05, speed: 20.0 };
    let mirrored = Contact { side_slip: -0.04, camber: -0.05, ..contact };
    let [left, right] = [tyre.wrench_on(Side::Left, &contact), tyre.wrench_on(Side::Right, &mirrored)];
    assert_eq!([left.force_x, left.moment_y], [right.force_x, right.moment_y]);
    assert_eq!([left.force_y, left.moment_x, left.moment_z], [-right.force_y, -right.moment_x, -right.moment_z]);
}
