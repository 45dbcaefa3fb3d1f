use crate::model::{Column, Derivatives, Fault, Law, Model, ModelExchange, boolean, integer, real};
use crate::number::{Mask, Scalar};
use crate::numerics::interpolation::Curve;

/// Largest number of points of a table.
pub const POINTS: usize = 16;

crate::choices! {
    /// Form of a spring's characteristic.
    pub enum SpringMode {
        /// Proportional to the compression.
        Linear,
        /// Straight lines between the points of a table.
        Table,
    }
}

crate::part! {
    /// Spring with preload.
    Coil {
        /// Is there a spring?
        enabled: fixed = boolean(true),
        /// Form of the spring's characteristic.
        mode: fixed = SpringMode::Linear.start(),
        /// Stiffness.
        k: tunable = real("N/m", 45_000.0).at_least(0.0),
        /// Force at full extension (default chosen).
        preload: tunable = real("N", 150.0),
        /// Number of points of the table in use (default chosen).
        tab_n: fixed = integer(3).at_least(2.0).at_most(POINTS as f64),
        /// Compressions of the table, ascending (default chosen).
        tab_x: [tunable; POINTS] = compressions(),
        /// Forces of the table, without preload (default chosen).
        tab_f: [tunable; POINTS] = forces(),
    }
}

/// A progressive spring, as an example: 45 N/mm, and 60 N/mm beyond 30 mm.
const EXAMPLE: [(f64, f64); 3] = [(0.0, 0.0), (0.03, 1350.0), (0.055, 2850.0)];

const fn compressions() -> [Column; POINTS] {
    let mut columns = [real("m", 0.0); POINTS];
    let mut at = 0;
    while at < EXAMPLE.len() {
        columns[at] = real("m", EXAMPLE[at].0);
        at += 1;
    }
    columns
}

const fn forces() -> [Column; POINTS] {
    let mut columns = [real("N", 0.0); POINTS];
    let mut at = 0;
    while at < EXAMPLE.len() {
        columns[at] = real("N", EXAMPLE[at].1);
        at += 1;
    }
    columns
}

/// Points of a table, of which `count` are in use.
pub(crate) fn points<T: Copy>(x: &[T; POINTS], y: &[T; POINTS]) -> [(T, T); POINTS] {
    std::array::from_fn(|at| (x[at], y[at]))
}

/// Refuses a table whose x are not strictly ascending.
pub(crate) fn check_rising(name: &str, x: &[f64; POINTS], count: f64) -> Result<(), Fault> {
    for at in 1..count as usize {
        if x[at] <= x[at - 1] {
            let (i, before) = (at + 1, x[at - 1]);
            return Err(Fault::new(format_args!("{name}[{i}] = {}: must be > {name}[{at}] = {before}", x[at])));
        }
    }
    Ok(())
}

impl<T: Scalar> Coil<T> {
    /// Force at a compression from full extension.
    pub fn force(&self, compression: T) -> T {
        let linear = || self.preload + self.k * compression;
        let table = || {
            let points = points(&self.tab_x, &self.tab_f);
            self.preload + Curve::new(&points, self.tab_n).linear(compression)
        };
        let force = || SpringMode::Table.is(self.mode).choose(table, linear);
        self.enabled.vanishes().choose(|| T::zero(), force)
    }
}

impl Coil {
    pub(crate) fn check(&self) -> Result<(), Fault> {
        match SpringMode::of(self.mode) {
            _ if self.enabled == 0.0 => Ok(()),
            SpringMode::Linear => Ok(()),
            SpringMode::Table => check_rising("spring.tab_x", &self.tab_x, self.tab_n),
        }
    }
}

crate::model! {
    /// Coil spring with preload, linear or from a table.
    ///
    /// # Equations
    ///
    /// ```text
    /// F = F_p + k x                  linear
    /// F = F_p + F_t(x)               table
    /// ```
    ///
    /// | symbol | variable                         | unit | meaning                                             |
    /// |--------|----------------------------------|------|-----------------------------------------------------|
    /// | x      | `compression`                    | m    | compression from full extension                     |
    /// | F_p    | `spring.preload`                 | N    | force at full extension                             |
    /// | k      | `spring.k`                       | N/m  | stiffness                                           |
    /// | F_t    | `spring.tab_x[1]`, `spring.tab_f[1]`, ... | m, N | points of the table, `spring.tab_n` of them |
    /// | F      | `force`                          | N    | force of the spring                                 |
    ///
    /// # Sign
    /// `force` is positive when the spring pushes its ends apart.
    ///
    /// # Step
    /// No memory: the force follows the compression.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; a table whose compressions are not strictly ascending.
    ///
    /// # Limits
    /// The spring never separates: beyond full extension it continues along the same line. Beyond the ends of a table
    /// the first and the last line are extended. A preload given as a length $x$ is the force $k x$.
    ///
    /// # Source
    /// Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024), list of symbols of chapter 9. Stiffness: Zips Racing ZR26, front axle
    /// (ZipsRacingElectric/Vehicle-Dynamics, MIT licence). Preload and table are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Law;
    /// use stribeck::shock_absorber::CoilSpring;
    /// let mut spring = CoilSpring { compression: 0.01, ..Default::default() };
    /// spring.output();
    /// assert_eq!(spring.force, 150.0 + 450.0);
    /// ```
    CoilSpring: "Coil spring with preload, linear or from a table" {
        /// Compression from full extension.
        compression: input = real("m", 0.0).shown_in("mm"),
        /// Characteristic.
        spring: Coil,
        /// Force of the spring; positive pushes its ends apart.
        force: output = real("N", 0.0),
    }
}

impl<T: Scalar> Law for CoilSpring<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.force = self.spring.force(self.compression);
    }
}

impl<T: Scalar> Derivatives for CoilSpring<T> {
    /// No state moves with time.
    fn derivatives(&self, _rate: &mut Self) {}
}

impl Model for CoilSpring {
    fn check(&self) -> Result<(), Fault> {
        self.spring.check()
    }

    fn step(&mut self, _dt: f64) {}
}
