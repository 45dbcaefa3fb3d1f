//! Rosenbrock method of order 5, L-stable, with eight stages and dense output of order 4.
//!
//! Coefficients: G. Steinebach (2023), Construction of Rosenbrock-Wanner method Rodas5P, BIT Numerical Mathematics 63,
//! 27, doi:10.1007/s10543-023-00967-x, in the form that needs no products with the Jacobian:
//!
//! ```text
//! (I / (h gamma) - J) k_i = f(t + c_i h, x + sum a_ij k_j) + sum C_ij k_j / h + h d_i df/dt
//! x_1 = x + sum a_8j k_j + k_8,   error k_8
//! ```

use super::Equations;
use super::elimination::Factors;
use super::recorder::Polynomials;
use super::step::{Beginning, Step};

const STAGES: usize = 8;

/// Largest number of states for which each stage has code of its own (chosen): with more, time goes elsewhere.
const FEW: usize = 4;

const GAMMA: f64 = 0.211_937_563_194_290_14;

/// Coefficients a_ij; those of the last two stages are those of the sixth, and 1.
const A: [[f64; 5]; 6] = [
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0, 0.0, 0.0, 0.0, 0.0],
    [2.849394379747939, 0.45842242204463923, 0.0, 0.0, 0.0],
    [-6.954028509809101, 2.489845061869568, -10.358996098473584, 0.0, 0.0],
    [2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641, 0.0],
    [-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946],
];

const C: [[f64; 7]; STAGES] = [
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-14.155112264123755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-17.97296035885952, -2.859693295451294, 0.0, 0.0, 0.0, 0.0, 0.0],
    [147.12150275711716, -1.41221402718213, 71.68940251302358, 0.0, 0.0, 0.0, 0.0],
    [165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306, 0.0, 0.0, 0.0],
    [24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471, 0.0, 0.0],
    [
        30.91273214028599,
        -3.1208243349937974,
        77.79954646070892,
        34.28646028294783,
        -19.097331116725623,
        -28.087943162872662,
        0.0,
    ],
    [
        37.80277123390563,
        -3.2571969029072276,
        112.26918849496327,
        66.9347231244047,
        -40.06618937091002,
        -54.66780262877968,
        -9.48861652309627,
    ],
];

const TIMES: [f64; STAGES] =
    [0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664, 1.0, 1.0, 1.0];

const D: [f64; STAGES] = [
    0.21193756319429014,
    -0.42387512638858027,
    -0.3384627126235924,
    1.8046452872882734,
    2.325825639765069,
    0.0,
    0.0,
    0.0,
];

/// Dense output.
const H: [[f64; STAGES]; 3] = [
    [
        25.948786856663858,
        -2.5579724845846235,
        10.433815404888879,
        -2.3679251022685204,
        0.524948541321073,
        1.1241088310450404,
        0.4272876194431874,
        -0.17202221070155493,
    ],
    [
        -9.91568850695171,
        -0.9689944594115154,
        3.0438037242978453,
        -24.495224566215796,
        20.176138334709044,
        15.98066361424651,
        -6.789040303419874,
        -6.710236069923372,
    ],
    [
        11.419903575922262,
        2.8879645146136994,
        72.92137995996029,
        80.12511834622643,
        -52.072871366152654,
        -59.78993625266729,
        -0.15582684282751913,
        4.883087185713722,
    ],
];

/// A step of the method.
pub(super) struct Rodas5P<const N: usize> {
    /// Stage by stage, so that a processor works on the states of a stage at once.
    k: [[f64; N]; STAGES],
    end: [f64; N],
    error: [f64; N],
}

impl<const N: usize> Default for Rodas5P<N> {
    fn default() -> Self {
        Rodas5P { k: [[0.0; N]; STAGES], end: [0.0; N], error: [0.0; N] }
    }
}

/// Adds a multiple. A loop, not a function of arrays: it always becomes part of the code around it.
#[inline(always)]
fn add<const N: usize>(sum: &mut [f64; N], factor: f64, k: &[f64; N]) {
    for (sum, k) in sum.iter_mut().zip(k) {
        *sum += factor * k;
    }
}

impl<const N: usize> Rodas5P<N> {
    /// x + sum a_ij k_j.
    #[inline(always)]
    fn argument(&self, stage: usize, begin: &[f64; N]) -> [f64; N] {
        let mut at = *begin;
        for (a, k) in A[stage.min(5)].iter().zip(&self.k).take(stage) {
            add(&mut at, *a, k);
        }
        for k in self.k.iter().take(stage).skip(5) {
            at.iter_mut().zip(k).for_each(|(at, k)| *at += k);
        }
        at
    }

    /// sum C_ij k_j / h + h d_i df/dt.
    #[inline(always)]
    fn memory(&self, stage: usize, by_time: &[f64; N], h: f64, reciprocal: f64) -> [f64; N] {
        let slope = h * D[stage];
        let mut sum = [0.0; N];
        for (c, k) in C[stage].iter().zip(&self.k).take(stage) {
            add(&mut sum, *c, k);
        }
        for (sum, by_time) in sum.iter_mut().zip(by_time) {
            *sum = *sum * reciprocal + slope * by_time;
        }
        sum
    }

    /// Finds k of a stage. Where its number is known when this is compiled, no loop is left.
    #[inline(always)]
    fn make(
        &mut self,
        stage: usize,
        equations: &mut dyn Equations,
        begin: &Beginning<N>,
        factors: &Factors<N>,
        h: f64,
    ) {
        let mut rates = begin.rates;
        let at = self.argument(stage, &begin.states);
        if stage > 0 {
            equations.rates(begin.time + TIMES[stage] * h, &at, &mut rates);
        }
        let memory = self.memory(stage, &begin.by_time, h, 1.0 / h);
        rates.iter_mut().zip(memory).for_each(|(rate, memory)| *rate += memory);
        let found = factors.solve(rates);
        self.k[stage] = found;
        if stage == STAGES - 1 {
            self.end = at;
            add(&mut self.end, 1.0, &found);
            self.error = found;
        }
    }
}

impl<const N: usize> Step<N> for Rodas5P<N> {
    type Course = Polynomials<N>;
    const ERROR_ORDER: i32 = 5;
    const GAMMA: f64 = GAMMA;
    const DEFECT: f64 = 0.1;

    fn attempt(&mut self, equations: &mut dyn Equations, begin: &Beginning<N>, h: f64) -> bool {
        let Some(factors) = Factors::of_shifted(1.0 / h / GAMMA, &begin.jacobian) else { return false };
        macro_rules! make {
            ($($stage:literal)+) => { $(self.make($stage, equations, begin, &factors, h);)+ };
        }
        if N <= FEW {
            make!(0 1 2 3 4 5 6 7);
        } else {
            (0..STAGES).for_each(|stage| self.make(stage, equations, begin, &factors, h));
        }
        self.end.iter().all(|x| x.is_finite())
    }

    fn evaluations(&self) -> u64 {
        STAGES as u64 - 1
    }

    fn end(&self) -> &[f64; N] {
        &self.end
    }

    fn error(&self) -> &[f64; N] {
        &self.error
    }

    /// x(s) = (1 - s) x_0 + s (x_1 + (1 - s) (b_1 + s (b_2 + s b_3))), b = H k.
    fn course(&self, begin: &Beginning<N>) -> Polynomials<N> {
        // Nothing is added to -0.
        let mut b = [[-0.0; N]; 3];
        for (b, row) in b.iter_mut().zip(&H) {
            for (h, k) in row.iter().zip(&self.k) {
                add(b, *h, k);
            }
        }
        std::array::from_fn(|i| {
            let (from, to) = (begin.states[i], self.end[i]);
            [from, to - from + b[0][i], b[1][i] - b[0][i], b[2][i] - b[1][i], -b[2][i]]
        })
    }
}
