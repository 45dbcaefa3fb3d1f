use crate::model::{Derivatives, Fault, Law, Model, ModelExchange, Preset, boolean, real};
use crate::number::{Mask, Scalar};

crate::choices! {
    /// Meaning of the four side-load inputs.
    pub enum SideConvention {
        /// Transverse force and moment of the tube on the rod, reduced to the eye of the tube.
        WrenchOnRod,
        /// Lagrange multipliers of the joint, of the rows m.d, n.d, m.a and n.a.
        Lambda,
    }
}

crate::choices! {
    /// Rule for the loads of the contacts from the load of the joint.
    pub enum NormalSum {
        /// Each contact has its own load, found as a vector.
        TwoPoint,
        /// Magnitudes of force and bending moment over overlap are added and shared equally, as Adams does.
        Adams,
    }
}

crate::part! {
    /// Positions of rod guide and piston.
    Guidance {
        /// Distance from the eye of the tube to the rod guide (default chosen).
        d_i: fixed = real("m", 0.125).positive().shown_in("mm"),
        /// Distance from the eye of the rod to the piston (default chosen).
        d_j: fixed = real("m", 0.105).positive().shown_in("mm"),
        /// Overlap below which the contact forces are kept finite (default chosen).
        h_reg: fixed = real("m", 0.002).at_least(0.0).shown_in("mm"),
    }
}

crate::part! {
    /// Load of the joint across its axis; or the four multipliers.
    SideLoad {
        /// Transverse force of the tube on the rod along m, at the eye of the tube; or lambda_1.
        side_force_m: input = real("N", 0.0),
        /// Transverse force of the tube on the rod along n, at the eye of the tube; or lambda_2.
        side_force_n: input = real("N", 0.0),
        /// Moment of the tube on the rod about m, at the eye of the tube; or lambda_3.
        side_moment_m: input = real("N.m", 0.0),
        /// Moment of the tube on the rod about n, at the eye of the tube; or lambda_4.
        side_moment_n: input = real("N.m", 0.0),
    }
}

/// Transverse force and moment of the tube on the rod, reduced to the eye of the tube.
#[derive(Clone, Copy, Debug)]
pub struct Wrench<T> {
    /// Force along m and n, R.
    pub force: [T; 2],
    /// Moment about m and n, M.
    pub moment: [T; 2],
}

impl<T: Scalar> SideLoad<T> {
    /// The load as a wrench on the rod.
    pub fn wrench(&self, convention: T) -> Wrench<T> {
        let SideLoad { side_force_m: m, side_force_n: n, side_moment_m: about_m, side_moment_n: about_n } = *self;
        let multipliers = || [-m, -n, -about_n, about_m];
        let [m, n, about_m, about_n] =
            SideConvention::Lambda.is(convention).choose_all(multipliers, || [m, n, about_m, about_n]);
        Wrench { force: [m, n], moment: [about_m, about_n] }
    }
}

impl<T: Scalar> Guidance<T> {
    /// Overlap of rod guide and piston at a length.
    pub fn overlap(&self, length: T) -> T {
        self.d_i + self.d_j - length
    }

    /// Whether the overlap is so small that the contact forces are no longer those of the rigid joint.
    pub fn is_low(&self, length: T) -> T::Mask {
        self.overlap(length).below(T::from(5.0) * self.h_reg)
    }

    /// Forces on the rod at the rod guide and at the piston, (1).
    pub fn contact_forces(&self, wrench: &Wrench<T>, length: T) -> [[T; 2]; 2] {
        let couple = self.couple(wrench, length).map(|moment| moment / self.regular_overlap(length));
        let half = wrench.force.map(|force| force / T::from(2.0));
        [[half[0] + couple[0], half[1] + couple[1]], [half[0] - couple[0], half[1] - couple[1]]]
    }

    /// Normal forces at the rod guide and at the piston.
    pub fn normal_forces(&self, wrench: &Wrench<T>, length: T, sum: T) -> [T; 2] {
        let adams = || {
            let bending = magnitude(self.couple(wrench, length)) / self.regular_overlap(length);
            [(magnitude(wrench.force) + bending) / T::from(2.0); 2]
        };
        NormalSum::Adams.is(sum).choose_all(adams, || self.contact_forces(wrench, length).map(magnitude))
    }

    /// M x a - R (xi_1 + xi_2) / 2.
    fn couple(&self, wrench: &Wrench<T>, length: T) -> [T; 2] {
        let middle = (self.d_i + length - self.d_j) / T::from(2.0);
        let ([r_m, r_n], [m_m, m_n]) = (wrench.force, wrench.moment);
        [m_n - middle * r_m, -m_m - middle * r_n]
    }

    /// (h^2 + h_reg^2)^(1/2); NaN where that is only rounding of the lengths.
    fn regular_overlap(&self, length: T) -> T {
        let overlap = magnitude([self.overlap(length), self.h_reg]);
        overlap.above(self.least_overlap()).choose(|| overlap, || T::from(f64::NAN))
    }

    /// Smallest overlap with at least six significant digits.
    fn least_overlap(&self) -> T {
        T::from(LEAST_OVERLAP) * (self.d_i + self.d_j)
    }
}

/// Smallest overlap relative to the lengths of which it is the difference (chosen).
const LEAST_OVERLAP: f64 = 1e-9;

impl Guidance {
    /// Refuses a length at which there is no overlap to carry a couple.
    pub(crate) fn check_overlap(&self, length: f64) -> Result<(), Fault> {
        let (overlap, least) = (self.overlap(length), self.least_overlap());
        if magnitude([overlap, self.h_reg]) <= least {
            let h_reg = self.h_reg;
            return Err(Fault::new(format_args!(
                "overlap = {overlap:e} m: its size must be > {least:e} m with geom.h_reg = {h_reg} m"
            )));
        }
        Ok(())
    }
}

fn magnitude<T: Scalar>([a, b]: [T; 2]) -> T {
    // Scaled, so that the squares of large and small numbers neither overflow nor vanish.
    let size = a.abs().above(b.abs()).choose(|| a.abs(), || b.abs());
    let scaled = || {
        let (a, b) = (a / size, b / size);
        size * (a * a + b * b).sqrt()
    };
    size.vanishes().choose(|| T::zero(), scaled)
}

crate::model! {
    /// Contact forces in a telescopic joint: from the load across its axis to the normal forces at rod guide and
    /// piston.
    ///
    /// # Equations
    ///
    /// ```text
    /// xi_1 = d_i,   xi_2 = d - d_j,   h = xi_1 - xi_2
    /// G = M x a - R (xi_1 + xi_2) / 2
    /// N_1 = R / 2 + G / h_e                                            (1)
    /// N_2 = R / 2 - G / h_e
    /// h_e = (h^2 + h_r^2)^(1/2)
    /// ```
    ///
    /// a is the unit vector from the eye of the tube to that of the rod; $m$, $n$ and a are perpendicular to each other
    /// and right-handed. In components $M x a = (M_n, -M_m)$. With the sum of Adams, each contact gets half of
    /// $|R| + |G| / h_e$.
    ///
    /// | symbol     | variable        | unit | meaning                                                     |
    /// |------------|-----------------|------|-------------------------------------------------------------|
    /// | d          | `length`        | m    | distance of the eyes                                        |
    /// | R_m, R_n   | `side_force_m`, `side_force_n` | N | force of the tube on the rod, at the eye of the tube |
    /// | M_m, M_n   | `side_moment_m`, `side_moment_n` | N.m | moment of the tube on the rod, about that eye |
    /// | d_i        | `geom.d_i`      | m    | from the eye of the tube to the rod guide                   |
    /// | d_j        | `geom.d_j`      | m    | from the eye of the rod to the piston                       |
    /// | h          | `overlap`       | m    | distance from piston to rod guide                           |
    /// | h_r        | `geom.h_reg`    | m    | regularisation, 0 = none                                    |
    /// | N_1m, N_1n | `force_1_m`, `force_1_n` | N | force on the rod at the rod guide                      |
    /// | N_2m, N_2n | `force_2_m`, `force_2_n` | N | force on the rod at the piston                         |
    ///
    /// # Sign
    /// `length` grows in extension, which shortens the overlap and raises the contact forces. With `convention` =
    /// Lambda the inputs are the multipliers of the constraints m.d, n.d, m.a, n.a with the equations of motion
    /// $M dv/dt + D^T lambda = g$: $R = -(lambda_1 m + lambda_2 n)$, $M = lambda_3 n - lambda_4 m$. If a host has other
    /// rows or signs, convert to $R$ and $M$.
    ///
    /// # Step
    /// No memory: the outputs follow the inputs.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound. An overlap $(h^2 + h_r^2)^(1/2)$ of at most $1e-9 (d_i + d_j)$ is an
    /// error.
    ///
    /// # Limits
    /// Rigid, straight bodies that touch at two rings; no clearance, no pressure distribution. The resultant is exact
    /// for every overlap; the couple is low by $(h_r / h)^2 / 2$, 0.08 % at 50 mm. The eyes cannot coincide: a `length`
    /// of 0, as with an input that is not set yet, is used as it is, with a warning.
    ///
    /// # Source
    /// F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho
    /// (2024), chapter 9, reconstructed from its list of symbols and figures by the equilibrium of the rod. The default
    /// lengths are chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::model::Law;
    /// use stribeck::shock_absorber::TelescopicJoint;
    /// let mut joint = TelescopicJoint { length: 0.18, ..Default::default() }; // overlap 50 mm
    /// joint.side.side_moment_n = 1.0;
    /// joint.geom.h_reg = 0.0;
    /// joint.output();
    /// assert!((joint.normal_1 - 20.0).abs() < 1e-12 && (joint.normal_2 - 20.0).abs() < 1e-12); // 1 N.m / 50 mm
    /// ```
    TelescopicJoint: "Contact forces of a telescopic joint, from its side load" {
        /// Distance of the eyes.
        length: input = real("m", 0.1775).shown_in("mm"),
        /// Load across the axis.
        side: (SideLoad),
        /// Meaning of the four side loads.
        convention: fixed = SideConvention::WrenchOnRod.start(),
        /// Rule for summing the contact forces.
        normal_sum: fixed = NormalSum::TwoPoint.start(),
        /// Dimensions.
        geom: Guidance,
        /// Normal force at the rod guide.
        normal_1: output = real("N", 0.0),
        /// Normal force at the piston.
        normal_2: output = real("N", 0.0),
        /// Force on the rod at the rod guide along m.
        force_1_m: output = real("N", 0.0),
        /// Force on the rod at the rod guide along n.
        force_1_n: output = real("N", 0.0),
        /// Force on the rod at the piston along m.
        force_2_m: output = real("N", 0.0),
        /// Force on the rod at the piston along n.
        force_2_n: output = real("N", 0.0),
        /// Distance from piston to rod guide.
        overlap: output = real("m", 0.0).shown_in("mm"),
        /// Is the overlap so short that the contact forces are regularised?
        overlap_low: output = boolean(false),
    }
}

impl<T: Scalar> Law for TelescopicJoint<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        let wrench = self.side.wrench(self.convention);
        self.overlap = self.geom.overlap(self.length);
        self.overlap_low = T::truth(self.geom.is_low(self.length));
        [self.normal_1, self.normal_2] = self.geom.normal_forces(&wrench, self.length, self.normal_sum);
        [[self.force_1_m, self.force_1_n], [self.force_2_m, self.force_2_n]] =
            self.geom.contact_forces(&wrench, self.length);
    }
}

impl<T: Scalar> Derivatives for TelescopicJoint<T> {
    /// No state moves with time.
    fn derivatives(&self, _rate: &mut Self) {}
}

impl Model for TelescopicJoint {
    const PRESETS: &'static [Preset] = &[Preset {
        name: "side_force",
        source: "Example of a side load of 100 N at the eye of the tube",
        values: &[("side_force_m", 100.0)],
    }];

    fn check_motion(&self) -> Result<(), Fault> {
        self.geom.check_overlap(self.length)
    }

    fn warning(&self) -> Option<Fault> {
        let text =
            "length = 0 m: the distance of the eyes must be > 0; the contact forces are computed for this length";
        (self.length == 0.0).then(|| Fault::new(text))
    }

    fn step(&mut self, _dt: f64) {}
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use nalgebra::{Matrix3, Rotation3, Vector3};

    /// The 200 wrenches of the tests: forces of some 100 N, moments of some 10 N.m.
    fn wrenches() -> impl Iterator<Item = Wrench<f64>> {
        let angle = |k: i32, i: i32| (f64::from(k * (7 * i + 3)) + 0.37 * f64::from(i)).sin();
        (0..200).map(move |k| Wrench {
            force: [150.0 * angle(k, 1), 150.0 * angle(k, 2)],
            moment: [12.0 * angle(k, 3), 12.0 * angle(k, 4)],
        })
    }

    fn guidance(h_reg: f64) -> Guidance {
        Guidance { h_reg, ..TelescopicJoint::default().geom }
    }

    const A: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);

    fn vector([m, n]: [f64; 2]) -> Vector3<f64> {
        Vector3::new(m, n, 0.0)
    }

    /// In vectors: the two forces at their points of action have the resultant and the moment of the wrench.
    #[test]
    fn two_contact_forces_reproduce_resultant_and_moment() {
        for (k, wrench) in wrenches().enumerate() {
            let length = 0.146 + 0.0004 * k as f64;
            let [n_1, n_2] = guidance(0.0).contact_forces(&wrench, length).map(vector);
            let moment = (0.125 * A).cross(&n_1) + ((length - 0.105) * A).cross(&n_2);
            assert!((n_1 + n_2 - vector(wrench.force)).norm() < 1e-10);
            assert!((moment - vector(wrench.moment)).norm() < 1e-10);
        }
    }

    /// As the overlap passes through zero, the resultant stays exact and the forces stay finite.
    #[test]
    fn resultant_is_exact_without_overlap() {
        for wrench in wrenches() {
            for overlap in [1e-2, 1e-4, 1e-8, 0.0, -1e-3] {
                let [n_1, n_2] = guidance(0.002).contact_forces(&wrench, 0.23 - overlap).map(vector);
                assert!((n_1 + n_2 - vector(wrench.force)).norm() < 1e-10);
                assert!(n_1.norm() < 2e4 && n_2.norm() < 2e4);
            }
        }
    }

    #[test]
    fn neither_rotation_nor_place_of_reduction_matters() {
        let guidance = guidance(0.0);
        for (k, wrench) in wrenches().enumerate() {
            let before = guidance.normal_forces(&wrench, 0.18, NormalSum::TwoPoint.number());
            let turn: Matrix3<f64> = Rotation3::from_axis_angle(&Vector3::z_axis(), k as f64).into();
            let turned = |pair| {
                let turned = turn * vector(pair);
                [turned.x, turned.y]
            };
            let rotated = Wrench { force: turned(wrench.force), moment: turned(wrench.moment) };
            // Moved along the axis by b, with the joint and the moment of the force.
            let b = 0.03;
            let moment = vector(wrench.moment) + (b * A).cross(&vector(wrench.force));
            let moved = Wrench { force: wrench.force, moment: [moment.x, moment.y] };
            let shifted = Guidance { d_i: guidance.d_i + b, d_j: guidance.d_j, ..guidance };
            for (guidance, wrench, length) in [(guidance, rotated, 0.18), (shifted, moved, 0.18 + b)] {
                let after = guidance.normal_forces(&wrench, length, NormalSum::TwoPoint.number());
                assert!((0..2).all(|i| (after[i] - before[i]).abs() < 1e-9), "{before:?} {after:?}");
            }
        }
    }

    /// The worked example: R = (80, -30) N, M = (2, 6) N.m, 50 mm of overlap; and the same as multipliers.
    #[test]
    fn worked_example_and_its_multipliers() {
        let wrench = SideLoad { side_force_m: 80.0, side_force_n: -30.0, side_moment_m: 2.0, side_moment_n: 6.0 };
        let lambda = SideLoad { side_force_m: -80.0, side_force_n: 30.0, side_moment_m: 6.0, side_moment_n: -2.0 };
        for wrench in
            [wrench.wrench(SideConvention::WrenchOnRod.number()), lambda.wrench(SideConvention::Lambda.number())]
        {
            let [n_1, n_2] = guidance(0.0).contact_forces(&wrench, 0.18).map(vector);
            assert!((n_1 - Vector3::new(0.0, 5.0, 0.0)).norm() < 1e-12);
            assert!((n_2 - Vector3::new(80.0, -35.0, 0.0)).norm() < 1e-12);
        }
    }

    /// Printed values with a regularisation of 2 mm.
    #[test]
    fn regularised_values() {
        let wrench = Wrench { force: [80.0, -30.0], moment: [2.0, 6.0] };
        let printed = [
            (0.145, 34.262, 51.363),
            (0.180, 4.984, 87.286),
            (0.200, 60.165, 145.308),
            (0.225, 728.5, 813.8),
            (0.230, 2140.4, 2225.7),
        ];
        for (length, n_1, n_2) in printed {
            let [a, b] = guidance(0.002).normal_forces(&wrench, length, NormalSum::TwoPoint.number());
            assert!((a - n_1).abs() < 6e-5 * n_1.max(10.0) && (b - n_2).abs() < 6e-5 * n_2, "{length}: {a} {b}");
        }
    }

    /// Without regularisation an overlap that is only rounding is refused by name; one with significant digits is not.
    #[test]
    fn an_overlap_of_rounding_is_an_error() {
        use crate::catalogue::by_name;
        use crate::instance::Instance;
        let mut joint = Instance::new(by_name("TelescopicJoint").expect("a model"));
        let column = |name: &str| joint.model().find(name).expect("a column");
        let [length, moment, h_reg] = [column("length"), column("side_moment_n"), column("geom.h_reg")];
        joint.set_column(moment, 1.0).unwrap();
        joint.set_column(h_reg, 0.0).unwrap();
        for (there, is_refused) in
            [(0.23, true), (0.23f64.next_up(), true), (0.23f64.next_down(), true), (0.23 - 1e-8, false), (0.231, false)]
        {
            joint.set_column(length, there).unwrap();
            let text = joint.refresh().err().map(|fault| fault.to_string()).unwrap_or_default();
            assert_eq!(text.contains("overlap = "), is_refused, "{there}: {text}");
            assert!(!is_refused || text.contains(" m with geom.h_reg = 0 m"), "{text}");
        }
        joint.set_column(h_reg, 0.002).unwrap();
        joint.set_column(length, 0.23).unwrap();
        joint.refresh().expect("regularised");
    }

    /// With collinear force and couple both sums are max(|R|, 2 |G| / h) and |R| + |G| / h; a pure couple counts twice
    /// in the first and once in the second.
    #[test]
    fn sum_of_adams_counts_a_pure_couple_once() {
        let couple = Wrench { force: [0.0, 0.0], moment: [0.0, 2.0] };
        let two_point: f64 = guidance(0.0).normal_forces(&couple, 0.18, NormalSum::TwoPoint.number()).iter().sum();
        let adams: f64 = guidance(0.0).normal_forces(&couple, 0.18, NormalSum::Adams.number()).iter().sum();
        assert_abs_diff_eq!(two_point, 2.0 * 40.0, epsilon = 1e-12);
        assert_abs_diff_eq!(adams, 40.0, epsilon = 1e-12);
    }
}
