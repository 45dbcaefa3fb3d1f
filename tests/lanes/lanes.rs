//! Steps that are written for every number type: in lanes they have the bits of a scalar, through dual numbers the slopes
//! of the result.

#[path = "../common/mod.rs"]
mod common;

use std::array::from_fn;

use common::random::Random;
use common::rows;
use stribeck::catalogue;
use stribeck::model::{InLanes, Kind, Law, Model, ModelType, Role, Steps, Visitor, model_in};
use stribeck::number::{Dual, Lanes};

/// Rows that are tried for each law.
const TRIED: usize = 500;

/// Shows the models that run in lanes to a check, and counts them.
struct EveryLaw<C>(C, usize);

trait Check {
    fn check<M: InLanes>(&mut self, model: &ModelType);
}

impl<C: Check> Visitor for EveryLaw<C> {
    fn visit<M: Model>(&mut self) {}

    fn visit_in_lanes<M: InLanes>(&mut self) {
        self.0.check::<M>(&ModelType::of::<M>());
        self.1 += 1;
    }
}

/// The laws without memory, and those of bristles whose equation is linear or has a closed form.
fn for_every_law(check: impl Check) {
    let mut all = EveryLaw(check, 0);
    catalogue::visit(&mut all);
    assert!(all.1 >= 24, "{}", all.1);
}

fn time_step(random: &mut Random) -> f64 {
    10f64.powf(-3.0 + 3.0 * random.signed())
}

/// Every column of `N` rows, of which each runs on its own as well.
fn agree<M: InLanes, const N: usize>(model: &ModelType, random: &mut Random) {
    let share = random.next();
    let mut rows: [Vec<f64>; N] = from_fn(|_| rows::row(model, share, random));
    let lane = |column| Lanes::<[f64; N]>(from_fn(|k| rows[k][column]));
    let mut lanes: Vec<_> = (0..model.table.len()).map(lane).collect();
    // With and without the outputs, and a second time from the states that the first one left.
    for way in 0..4 {
        let dt = Lanes(from_fn(|_| time_step(random)));
        let both = model_in::<M, Lanes<[f64; N]>>(&mut lanes);
        if way % 2 == 0 {
            both.advance_and_output(dt);
        } else {
            both.advance(dt);
            both.output();
        }
        for (k, row) in rows.iter_mut().enumerate() {
            if way % 2 == 0 {
                model.advance(row, dt.0[k]);
            } else {
                model_in::<M, f64>(row).advance(dt.0[k]);
                model.output(row);
            }
        }
        for (column, variable) in model.table.iter().enumerate() {
            for (k, row) in rows.iter().enumerate() {
                let (lane, alone) = (lanes[column].0[k], row[column]);
                let is_same = lane.to_bits() == alone.to_bits() || lane.is_nan() && alone.is_nan();
                assert!(is_same, "{}.{}: {lane} in lane {k} of {N}, {alone} alone", model.name, variable.path);
            }
        }
    }
}

struct LanesAreScalars;

impl Check for LanesAreScalars {
    fn check<M: InLanes>(&mut self, model: &ModelType) {
        let mut random = Random(11);
        for _ in 0..TRIED {
            agree::<M, 4>(model, &mut random);
        }
    }
}

#[test]
fn every_lane_has_the_bits_of_a_scalar() {
    for_every_law(LanesAreScalars);
}

/// A row with the step after its last column, along one of which it is changed.
#[derive(Clone)]
struct Ray {
    row: Vec<f64>,
    column: usize,
}

impl Ray {
    /// The row after the step, from a row changed by so much.
    fn after<M: InLanes>(&self, change: f64) -> Vec<f64> {
        let mut row = self.row.clone();
        row[self.column] += change;
        let dt = row.pop().expect("the step");
        model_in::<M, f64>(&mut row).advance_and_output(dt);
        row
    }

    fn slopes<M: InLanes>(&self) -> Vec<f64> {
        let mut row: Vec<Dual> = self.row.iter().copied().map(Dual::from).collect();
        row[self.column].slope = 1.0;
        let dt = row.pop().expect("the step");
        model_in::<M, Dual>(&mut row).advance_and_output(dt);
        row.iter().map(|number| number.slope).collect()
    }
}

/// The slopes of a step by central differences, each with its error; infinite where the function is not smooth.
fn differences<M: InLanes>(ray: &Ray) -> Vec<[f64; 2]> {
    let distance = 1e-3 * ray.row[ray.column].abs();
    let at = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| ray.after::<M>(k * distance));
    let slope = |result: usize| {
        let [far_below, below, here, above, far_above] = at.each_ref().map(|row| row[result]);
        let (near, far) = ((above - below) / (2.0 * distance), (far_above - far_below) / (4.0 * distance));
        let [left, right] = [(here - below) / distance, (above - here) / distance];
        // The fourth difference of a smooth function is rounding only.
        let fourth = far_below - 4.0 * below + 6.0 * here - 4.0 * above + far_above;
        let rounding = (1e-15 * here.abs().max(ray.row[result].abs()) + fourth.abs()) / distance;
        let is_smooth = (left - right).abs() <= 2e-2 * near.abs() + 4.0 * rounding;
        let error = if is_smooth { 0.4 * (near - far).abs() } else { f64::INFINITY };
        [(4.0 * near - far) / 3.0, error + 1e-5 * near.abs() + 100.0 * rounding]
    };
    (0..at[0].len()).map(slope).collect()
}

struct DualsHaveSlopes;

impl Check for DualsHaveSlopes {
    fn check<M: InLanes>(&mut self, model: &ModelType) {
        let mut random = Random(12);
        let is_along = |variable: &stribeck::model::Variable| {
            matches!(variable.kind, Kind::Real(_)) && variable.role != Role::Output
        };
        let columns: Vec<usize> = (0..model.table.len()).filter(|c| is_along(&model.table.at(*c))).collect();
        let mut checked = 0;
        for _ in 0..TRIED {
            let mut row = rows::everyday(model, &mut random);
            row.push(time_step(&mut random));
            for column in columns.iter().copied().chain([row.len() - 1]).filter(|column| row[*column] != 0.0) {
                let ray = Ray { row: row.clone(), column };
                let exact = ray.slopes::<M>();
                for (result, [slope, error]) in differences::<M>(&ray).into_iter().enumerate() {
                    if error.is_finite() {
                        let name = |column: usize| model.table.get(column).map(|v| v.path.to_string());
                        let message = format!("{}: {:?} by {:?}", model.name, name(result), name(column));
                        assert!(
                            (exact[result] - slope).abs() <= error,
                            "{message}: {} {slope} {error}\n{row:?}",
                            exact[result]
                        );
                        checked += usize::from(slope != 0.0);
                    }
                }
            }
        }
        assert!(checked > TRIED, "{}: {checked}", model.name);
    }
}

#[test]
fn a_dual_number_through_a_step_has_the_slope_of_the_result() {
    for_every_law(DualsHaveSlopes);
}
