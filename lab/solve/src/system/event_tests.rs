//! Events of laws with branches and elements, against closed forms and an integration of their own.

use std::f64::consts::TAU;

use super::tests::{belt, belt_with};
use super::{Motion, Setting, Source, System};
use crate::stick_slip::{BELT, StickSlip};

/// Deflection and its rate, without what has faded, of a bond with the block at x when it was bent by z:
/// m z'' + c z' + (K + k) z = -k (x - z + v_b t).
fn steady_bond(x: f64, z: f64, [spring, stiffness, damping]: [f64; 3]) -> [f64; 2] {
    let both = stiffness + spring;
    let drift = -spring * BELT / both;
    [-(spring * (x - z) + damping * drift) / both, drift]
}

/// The spring breaks the bond when its swinging has long faded; the block then slides in a harmonic motion about f_C / k
/// until it is as fast as the belt.
#[test]
fn a_bond_breaks_and_forms_where_closed_forms_say() {
    let (StickSlip { w, .. }, stiffness, damping, level) = (StickSlip::table_6_1(), 1e5, 1e5f64.sqrt(), 0.981);
    let (spring, most) = (w * w, level / stiffness);
    let system = [spring, 1.5 * stiffness, damping];
    let breaks = |[start, drift]: [f64; 2]| (start + most) / -drift;
    let steady = steady_bond(0.0, 0.0, system);
    let first = breaks(steady);
    let [rests, x] = comes_to_rest(w, [first, BELT * first - most, BELT + steady[1], level]);
    let expected = [first, rests, rests + breaks(steady_bond(x, -most, system))];
    for tolerance in [1e-3, 1e-12] {
        let (statistics, _) = belt("ResetIntegrator", tolerance);
        let times: Vec<f64> = statistics.events.iter().take(3).map(|event| event.time).collect();
        assert!(times.iter().zip(expected).all(|(time, exact)| (time - exact).abs() < 1e-9), "{times:?} {expected:?}");
    }
}

/// A block that lags behind the belt, on the two curves of the law of Wojewoda, by its own integration.
struct TwoCurves {
    time: f64,
    /// Position, and speed against the belt.
    at: [f64; 2],
    branch: Branch,
}

#[derive(Clone, Copy, PartialEq)]
enum Branch {
    Upper,
    Between,
    Lower,
}

impl TwoCurves {
    const KINETIC: f64 = 0.981;
    const STATIC: f64 = 1.4715;
    const STIFFNESS: f64 = 1e5;
    const SPRING: f64 = 2.0;

    /// The first breakaway: until then the block swings without damping on spring and contact, by
    /// y = d (t - sin(w t) / w) against the belt.
    fn broken() -> TwoCurves {
        let both = Self::SPRING + Self::STIFFNESS;
        let (w, d) = (both.sqrt(), Self::SPRING * BELT / both);
        let way = |t: f64| d * (t - (w * t).sin() / w);
        let time = bisected(7.0, 8.0, |t| Self::STIFFNESS * way(t) - Self::STATIC);
        TwoCurves { time, at: [BELT * time - way(time), d * (1.0 - (w * time).cos())], branch: Branch::Upper }
    }

    /// Pull of the spring, lower and upper level.
    fn forces([position, speed]: [f64; 2]) -> [f64; 3] {
        let fade = (-500.0 * speed).exp() * (Self::STATIC - Self::KINETIC);
        [Self::SPRING * position, Self::KINETIC - fade, Self::KINETIC + fade]
    }

    fn rates(&self, at: [f64; 2]) -> [f64; 2] {
        let [pull, lower, upper] = Self::forces(at);
        let acceleration = match self.branch {
            Branch::Upper => pull - upper,
            Branch::Between => 0.0,
            Branch::Lower => pull - lower,
        };
        [BELT - at[1], acceleration]
    }

    /// Positive beyond the end of the branch.
    fn excess(&self, at: [f64; 2]) -> f64 {
        let [pull, lower, upper] = Self::forces(at);
        match self.branch {
            Branch::Upper => upper - pull,
            Branch::Between => (pull - upper).max(lower - pull),
            Branch::Lower => pull - lower,
        }
    }

    /// A step of Runge and Kutta.
    fn moved(&self, h: f64) -> [f64; 2] {
        let beside = |k: [f64; 2], h: f64| [self.at[0] + h * k[0], self.at[1] + h * k[1]];
        let k_1 = self.rates(self.at);
        let k_2 = self.rates(beside(k_1, 0.5 * h));
        let k_3 = self.rates(beside(k_2, 0.5 * h));
        let k_4 = self.rates(beside(k_3, h));
        std::array::from_fn(|i| self.at[i] + h / 6.0 * (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]))
    }

    /// Goes on to the end of the branch; the block never comes to rest again.
    fn leave(&mut self) {
        const H: f64 = 1e-5;
        while self.excess(self.moved(H)) < 0.0 {
            self.at = self.moved(H);
            self.time += H;
            assert!(self.at[1] > 0.0, "at rest at {}", self.time);
        }
        let h = bisected(0.0, H, |h| self.excess(self.moved(h)));
        self.at = self.moved(h);
        self.time += h;
        let [pull, lower, upper] = Self::forces(self.at);
        // At high speed there is nothing between them.
        let is_one = upper - lower < 1e-9;
        self.branch = match self.branch {
            Branch::Upper if is_one => Branch::Lower,
            Branch::Between if pull > lower => Branch::Upper,
            _ => Branch::Between,
        };
    }
}

/// The zero of a rising function between two numbers.
fn bisected(mut low: f64, mut high: f64, rising: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if rising(middle) < 0.0 { low = middle } else { high = middle }
    }
    high
}

/// Breakaway and changes of the curve over two slips. The first breakaway has a closed form, and every tolerance meets it.
/// The curve changes when the pull is beyond its level by 1e-9 of it, which takes 1e-8 s.
#[test]
fn a_block_changes_its_curves_where_another_integration_says() {
    let mut block = TwoCurves::broken();
    let mut expected = vec![block.time];
    for _ in 0..5 {
        block.leave();
        expected.push(block.time);
    }
    let off = |tolerance: f64| -> Vec<f64> {
        let events = belt("Wojewoda", tolerance).0.events;
        events.iter().zip(&expected).map(|(event, expected)| (event.time - expected).abs()).collect()
    };
    let [loose, tight] = [1e-3, 1e-12].map(off);
    assert!(loose.len() == 6 && loose[0] < 1e-9 && loose.iter().all(|off| *off < 1e-2), "{loose:?} {expected:?}");
    assert!(tight.len() == 6 && tight[0] < 1e-9 && tight.iter().all(|off| *off < 2e-8), "{tight:?} {expected:?}");
}

/// Instant and place at which a block that slides against a constant level is as fast as the belt again.
fn comes_to_rest(w: f64, start: [f64; 4]) -> [f64; 2] {
    swings_back(w, start, BELT)
}

/// The same for any speed.
fn swings_back(w: f64, [begin, x, speed, level]: [f64; 4], to: f64) -> [f64; 2] {
    let middle = level / (w * w);
    let out = x - middle;
    let back = -(out * out + (speed * speed - to * to) / (w * w)).sqrt();
    [begin + (TAU + (w * back).atan2(to) - (w * out).atan2(speed)) / w, middle + back]
}

/// The bristle breaks at the static limit as a bond does; the block slides against the static level until it differs from
/// the belt by v_0, against the kinetic one until it is as near again, and takes the bristle along from its kinetic limit
/// to its static one.
#[test]
fn a_bristle_breaks_and_changes_its_limit_where_closed_forms_say() {
    let (StickSlip { w, .. }, stiffness, damping) = (StickSlip::table_6_1(), 1e5, 1e5f64.sqrt());
    let [fast, kinetic, breakaway] = [BELT - 1e-3, 0.981, 1.4715];
    let system = [w * w, stiffness, damping];
    let breaks = |[start, drift]: [f64; 2]| (start + breakaway / stiffness) / -drift;
    let steady = steady_bond(0.0, 0.0, system);
    let first = breaks(steady);
    // Against the static level it is accelerated outwards of the middle.
    let [out, speed] = [BELT * first - (breakaway / stiffness) - breakaway / (w * w), BELT + steady[1]];
    let further = (out * out + (speed * speed - fast * fast) / (w * w)).sqrt();
    let passes = first + ((w * further).atan2(fast) - (w * out).atan2(speed)) / w;
    let [returns, x] = swings_back(w, [passes, breakaway / (w * w) + further, fast, kinetic], fast);
    let second = returns + breaks(steady_bond(x, -kinetic / stiffness, system));
    let expected = [first, passes, returns, second];
    for tolerance in [1e-3, 1e-12] {
        let (statistics, _) = belt("Liang", tolerance);
        let times: Vec<f64> = statistics.events.iter().take(4).map(|event| event.time).collect();
        assert!(times.iter().zip(expected).all(|(time, exact)| (time - exact).abs() < 1e-9), "{times:?} {expected:?}");
    }
}

/// Two elements with equal levels, 2/3 and 1/3 of the stiffness, 1/3 and 2/3 of the level: the first one slips, then the
/// second one, and the block slides in a harmonic motion until it is as fast as the belt. Both elements are at their
/// limits then, and leave and reach them together.
#[test]
fn elements_slip_and_stick_where_closed_forms_say() {
    let (StickSlip { w, .. }, stiffness, damping, level) = (StickSlip::table_6_1(), 1e5, 1e5f64.sqrt(), 0.981);
    let spring = w * w;
    let settings = [("element_count", 2.0), ("mu_s", 0.1), ("sigma_1", damping)];
    // The drift of a deflection, and the force that moves it there, from (K + k) z + c z' = force - k v_b t.
    let reaches = |share: f64, force: f64, deflection: f64| {
        let both = share * stiffness + spring;
        let drift = -spring * BELT / both;
        [(force - share * damping * drift - both * deflection) / (spring * BELT), drift]
    };
    let [first, _] = reaches(1.0, 0.0, -0.5 * level / stiffness);
    let [second, drift] = reaches(1.0 / 3.0, level / 3.0, -2.0 * level / stiffness);
    let out = BELT * second - 2.0 * level / stiffness;
    let [rests, x] = comes_to_rest(w, [second, out, BELT + drift, level]);
    let [again, _] = reaches(1.0, level - spring * x, 0.0);
    let expected = [first, second, rests, rests + again];
    for tolerance in [1e-3, 1e-12] {
        let (statistics, _) = belt_with("MaxwellSlip", &settings, tolerance);
        let times: Vec<f64> = statistics.events.iter().take(4).map(|event| event.time).collect();
        assert!(times.iter().zip(expected).all(|(time, exact)| (time - exact).abs() < 1e-9), "{times:?} {expected:?}");
    }
}

/// States of the belt, and one of each element in use.
#[test]
fn only_elements_in_use_are_states() {
    let source = Source::open("belt").unwrap();
    for count in [1, 4, 62] {
        let settings = [("distribution", "Uniform".to_owned()), ("element_count", count.to_string())];
        let settings = settings.map(|(name, value)| Setting { name: name.to_owned(), value });
        let system = System::assemble(&source, Some("MaxwellSlip"), &settings).unwrap();
        assert_eq!(Motion::new(&system, &[]).unwrap().places().len(), 2 + count);
    }
}
