//! Contacts between bodies that both move, in co-simulation: correct values of `mass` and `external_force`, tolerance
//! of the mass, and several contacts on one body. Bodies that stick move as one body, which is integrated here for
//! comparison, and slide with the acceleration given by Newton's law.

use crate::common::{Bench, holding_laws};
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// Communication step in s.
const STEP: f64 = 1e-3;

const SEQUENTIAL: f64 = 1.0;
const PARALLEL: f64 = 2.0;

/// The friction force that the host applies over a step: that of this step, or in a parallel exchange that of the last
/// one.
fn exchanged(law: &mut Bench, exchange: f64, velocity: f64, external_force: f64) -> f64 {
    let before = law.get("friction_force");
    law.set("velocity", velocity);
    law.set("external_force", external_force);
    law.step(STEP);
    if exchange == PARALLEL { before } else { law.get("friction_force") }
}

/// Two bodies that slide on each other, 1 kg on 2 kg, for 3 s from rest.
struct Pair {
    model: &'static str,
    exchange: f64,
    /// The law's mass as a multiple of the correct one.
    scale: f64,
}

/// Velocities of the bodies of a pair.
struct Motion {
    /// Highest speed relative to each other after half a second.
    slip: f64,
    /// Velocity of body 1 at the end, and that of both bodies as one.
    end: [f64; 2],
}

const PAIR: [f64; 2] = [1.0, 2.0];

/// As one body the pair would need at most 0.83 N of friction, while body 1 is pulled by up to 1.3 N.
fn loads(time: f64) -> [f64; 2] {
    [1.0 + 0.3 * (3.0 * time).sin(), 0.2 * (2.0 * time).cos()]
}

fn reduced([f_1, f_2]: [f64; 2], [m_1, m_2]: [f64; 2]) -> f64 {
    (m_2 * f_1 - m_1 * f_2) / (m_1 + m_2)
}

impl Pair {
    fn run(&self, external_force: impl Fn([f64; 2], [f64; 2]) -> f64) -> Motion {
        let [m_1, m_2] = PAIR;
        let mass = self.scale * m_1 * m_2 / (m_1 + m_2);
        let mut law = Bench::new(self.model, &[("mass", mass), ("exchange", self.exchange)]);
        let (mut v_1, mut v_2, mut as_one, mut slip) = (0.0, 0.0, 0.0, 0.0_f64);
        for k in 0..3000 {
            let [f_1, f_2] = loads(f64::from(k) * STEP);
            let force = exchanged(&mut law, self.exchange, v_1 - v_2, external_force([f_1, f_2], PAIR));
            v_1 += STEP * (f_1 - force) / m_1;
            v_2 += STEP * (f_2 + force) / m_2;
            as_one += STEP * (f_1 + f_2) / (m_1 + m_2);
            if k >= 500 {
                slip = slip.max(f64::abs(v_1 - v_2));
            }
        }
        Motion { slip, end: [v_1, as_one] }
    }
}

/// With the reduced force only the effect of its change within a step remains, h^2 (df_e/dt) / m: 1 um/s. With the
/// force on body 1 alone the law holds a load that does not exist.
#[test]
fn a_pair_of_moving_bodies_sticks_by_the_reduced_force() {
    for model in holding_laws() {
        for exchange in [SEQUENTIAL, PARALLEL] {
            let pair = Pair { model, exchange, scale: 1.0 };
            let Motion { slip, end: [velocity, as_one] } = pair.run(reduced);
            assert!(slip < 4e-6, "{model} {exchange}: {slip} m/s");
            assert!(abs_diff_eq!(velocity, as_one, epsilon = 1e-5), "{model} {exchange}: {velocity}, {as_one} m/s");
            let wrong = pair.run(|[f_1, _], _| f_1).slip;
            assert!(wrong > 3e-4, "{model} {exchange}: {wrong} m/s");
        }
    }
}

/// If the force on body 1 exceeds the level, the pair even slides: 2.1 N on 1 kg that lies on 2 kg, of which the
/// contact has to carry 1.4 N, and f_s is 1.4715 N. Then 0.981 N remain, 0.63 m/s^2.
#[test]
fn a_pair_that_sticks_slides_with_the_force_on_body_1_alone() {
    let [m_1, m_2] = PAIR;
    let run = |external_force: f64| {
        let mut law = Bench::new("CoulombStiction", &[("mass", m_1 * m_2 / (m_1 + m_2))]);
        let (mut v_1, mut v_2) = (0.0, 0.0);
        for _ in 0..1000 {
            let force = exchanged(&mut law, SEQUENTIAL, v_1 - v_2, external_force);
            v_1 += STEP * (2.1 - force) / m_1;
            v_2 += STEP * force / m_2;
        }
        v_1 - v_2
    };
    assert!(run(reduced([2.1, 0.0], PAIR)).abs() < 1e-12);
    assert_abs_diff_eq!(run(2.1), 2.1 - 0.981 * 1.5, epsilon = 2e-3);
}

/// A block of 1 kg on a table shaken back and forth with 0.9 m/s^2: it moves along, because f_C allows 0.98 m/s^2.
#[test]
fn a_block_moves_along_with_a_base_that_accelerates() {
    let (frequency, acceleration) = (4.0, 0.9);
    let run = |model, exchange, knows_base: f64| {
        let mut law = Bench::new(model, &[("mass", 1.0), ("exchange", exchange)]);
        let (mut velocity, mut slip) = (0.0, 0.0_f64);
        for k in 0..3000 {
            let time = f64::from(k) * STEP;
            let base = acceleration / frequency * (frequency * time).sin();
            let load = -knows_base * acceleration * (frequency * time).cos();
            if k >= 500 {
                slip = slip.max(f64::abs(velocity - base));
            }
            velocity -= STEP * exchanged(&mut law, exchange, velocity - base, load);
        }
        slip
    };
    for model in holding_laws() {
        for exchange in [SEQUENTIAL, PARALLEL] {
            // The acceleration changes by up to 3.6e-3 m/s^2 within a step.
            let (right, wrong) = (run(model, exchange, 1.0), run(model, exchange, 0.0));
            assert!(right < 1e-5, "{model} {exchange}: {right} m/s");
            assert!(wrong > 8e-4, "{model} {exchange}: {wrong} m/s");
        }
    }
}

/// Newton's iteration with a wrong derivative: the error is multiplied by 1 - scale in a step.
#[test]
fn a_wrong_mass_holds_up_to_twice_the_correct_one() {
    for model in holding_laws() {
        for exchange in [SEQUENTIAL, PARALLEL] {
            for scale in [0.3, 0.5, 1.5, 1.9] {
                let slip = Pair { model, exchange, scale }.run(reduced).slip;
                assert!(slip < 1e-5, "{model} {exchange} {scale}: {slip} m/s");
            }
            let slip = Pair { model, exchange, scale: 2.1 }.run(reduced).slip;
            assert!(slip > 1e-4, "{model} {exchange}: {slip} m/s");
        }
    }
}

/// Exchange of friction between the contacts of a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Order {
    /// One after another, each with the new forces of those before it; the blocks last.
    InTurn,
    /// All with the forces of the previous step; the blocks last.
    AtOnce,
    /// All models at once, including the blocks.
    Parallel,
}

/// Blocks of 1 kg on each other and on the ground; the uppermost is pulled.
struct Stack {
    blocks: usize,
    order: Order,
    exchange: f64,
    /// Mass of each contact as a multiple of its effective mass.
    scale: f64,
}

impl Stack {
    /// Velocities of the blocks relative to their supports, after half a second: the largest, and the final one of the
    /// uppermost block.
    fn run(&self, model: &str, pull: impl Fn(f64) -> f64) -> [f64; 2] {
        let contact = |at: usize| {
            let effective = if at == 0 { 1.0 } else { 0.5 };
            let load = (self.blocks - at) as f64 * 9.81;
            Bench::new(model, &[("mass", self.scale * effective), ("exchange", self.exchange), ("normal_force", load)])
        };
        let mut contacts: Vec<Bench> = (0..self.blocks).map(contact).collect();
        let mut velocities = vec![0.0; self.blocks];
        let mut found = vec![0.0; self.blocks];
        let (mut slip, mut last) = (0.0_f64, 0.0);
        for k in 0..2000 {
            let pull = pull(f64::from(k) * STEP);
            let applied = self.friction(&mut contacts, &velocities, &mut found, pull);
            for at in 0..self.blocks {
                let [from_above, _] = self.on_block(at, &applied, pull);
                velocities[at] += STEP * (from_above - applied[at]);
            }
            let slips: Vec<f64> = (0..self.blocks).map(|at| relative(&velocities, at)).collect();
            if k >= 500 {
                slip = slips.iter().fold(slip, |slip, v| slip.max(v.abs()));
            }
            last = slips[self.blocks - 1];
        }
        [slip, last]
    }

    /// Force on a block except for the contact below it, and that on the block below except for the contact between
    /// them.
    fn on_block(&self, at: usize, friction: &[f64], pull: f64) -> [f64; 2] {
        let above = friction.get(at + 1).map_or(pull, |force| *force);
        [above, if at == 0 { 0.0 } else { -friction[at - 1] }]
    }

    /// One exchange: the forces on the blocks.
    fn friction(&self, contacts: &mut [Bench], velocities: &[f64], found: &mut [f64], pull: f64) -> Vec<f64> {
        let before = found.to_vec();
        for at in (0..self.blocks).rev() {
            let known = if self.order == Order::InTurn { &*found } else { &before };
            let [on, below] = self.on_block(at, known, pull);
            let external_force = if at == 0 { on } else { reduced([on, below], [1.0, 1.0]) };
            contacts[at].set("velocity", relative(velocities, at));
            contacts[at].set("external_force", external_force);
            contacts[at].step(STEP);
            found[at] = contacts[at].get("friction_force");
        }
        if self.order == Order::Parallel { before } else { found.to_vec() }
    }
}

fn relative(velocities: &[f64], at: usize) -> f64 {
    velocities[at] - if at == 0 { 0.0 } else { velocities[at - 1] }
}

/// Below the static level of the uppermost contact.
fn gentle_pull(time: f64) -> f64 {
    0.6 + 0.2 * (3.0 * time).sin()
}

/// A contact that uses old forces of its neighbours repeats their corrections. One after another they do not, and with
/// half the mass and one force for two steps they converge. With the full mass three blocks chatter.
#[test]
fn contacts_on_one_body_hold_in_turn_or_with_half_the_mass() {
    for model in holding_laws() {
        for blocks in [2, 3, 5] {
            let slip = |order, exchange, scale| Stack { blocks, order, exchange, scale }.run(model, gentle_pull)[0];
            let in_turn = slip(Order::InTurn, SEQUENTIAL, 1.0);
            assert!(in_turn < 2e-6, "{model}, {blocks} blocks: {in_turn} m/s");
            let halved = slip(Order::Parallel, SEQUENTIAL, 0.5);
            assert!(halved < 1e-5, "{model}, {blocks} blocks: {halved} m/s");
            if blocks > 2 {
                for (order, exchange) in [(Order::Parallel, PARALLEL), (Order::AtOnce, SEQUENTIAL)] {
                    let chatter = slip(order, exchange, 1.0);
                    assert!((5e-3..0.1).contains(&chatter), "{model}, {blocks} blocks, {order:?}: {chatter} m/s");
                }
            }
        }
    }
}

/// 2 N on the uppermost block, which slides against 0.981 N; the others stay.
#[test]
fn a_block_slides_off_its_stack_with_half_the_mass_too() {
    for (order, scale) in [(Order::InTurn, 1.0), (Order::Parallel, 0.5)] {
        let stack = Stack { blocks: 3, order, exchange: SEQUENTIAL, scale };
        let [_, velocity] = stack.run("CoulombStiction", |_| 2.0);
        assert!(abs_diff_eq!(velocity, 2.0 * (2.0 - 0.981), epsilon = 3e-3), "{order:?}: {velocity} m/s");
    }
}
