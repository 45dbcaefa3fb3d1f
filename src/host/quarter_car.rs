use crate::host::vertical::{GRAVITY, Motion, Suspension, Wheel};
use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, integrate, real};
use crate::number::Scalar;

crate::model! {
    /// A quarter of a car: the body above one wheel, the wheel, and a tyre that lifts off. The strut between them is
    /// another model, such as a shock absorber.
    ///
    /// # Equations
    ///
    /// ```text
    /// m_s d2z_s/dt2 = r (f - f_0 - f_y)
    /// m_u d2z_u/dt2 = f_t - f_t0 - r (f - f_0)
    /// f_t   = max(0, f_t0 + k_t (z_r - z_u) + c_t (v_r - dz_u/dt))
    /// f_t0  = (m_s + m_u) g
    /// l     = l_0 + r (z_s - z_u)
    /// dl/dt = r (dz_s/dt - dz_u/dt)
    /// f_e   = f_w - f_0 - (f_t - f_t0) m_s / ((m_s + m_u) r)
    /// ```
    ///
    /// | symbol  | variable         | unit  | meaning                                           |
    /// |---------|------------------|-------|---------------------------------------------------|
    /// | f       | `strut_force`    | N     | force of the strut                                |
    /// | f_w     | `force_without_friction` | N | that force without the friction in the strut      |
    /// | f_y     | `rod_force`      | N     | part of it that moves the rod of the strut         |
    /// | z_r     | `road_height`    | m     | height of the road under the wheel                |
    /// | v_r     | `road_velocity`  | m/s   | rate of the road's height                         |
    /// | m_s     | `body_mass`      | kg    | mass of the body                                  |
    /// | m_u     | `wheel_mass`     | kg    | unsprung mass of the corner                       |
    /// | r       | `motion_ratio`   | 1     | damper travel per wheel travel                    |
    /// | l_0     | `static_length`  | m     | length of the strut at rest                       |
    /// | f_0     | `static_force`   | N     | force of the strut at rest                        |
    /// | k_t     | `tyre_stiffness` | N/m   | stiffness of the tyre                             |
    /// | c_t     | `tyre_damping`   | N.s/m | damping of the tyre                               |
    /// | z_s     | `body_height`    | m     | height of the body above its height at rest       |
    /// | dz_s/dt | `body_velocity`  | m/s   | vertical velocity of the body                     |
    /// | z_u     | `wheel_height`   | m     | height of the wheel above its height at rest      |
    /// | dz_u/dt | `wheel_velocity` | m/s   | vertical velocity of the wheel                    |
    /// | l       | `length`         | m     | length of the strut                               |
    /// | dl/dt   | `velocity`       | m/s   | rate of the strut's length                        |
    /// | f_t     | `tyre_load`      | N     | force of the tyre on the road                     |
    /// | f_e     | `external_force` | N     | force that the friction of a stuck strut carries  |
    /// | g       |                  | m/s2  | 9.81, the acceleration of gravity                 |
    ///
    /// Where rod and body move together, `rod_force` is 0; with a rubber mount between them it is that of `TopMount`.
    ///
    /// # Sign
    /// Heights are positive up. `strut_force` is positive if it pushes the eyes of the strut apart: it lifts the body
    /// and presses the wheel down. `velocity` is positive as the strut extends.
    ///
    /// # Step
    /// The inputs are held over a step, or move linearly. The step is divided by error control (Dormand and Prince,
    /// order 5) to a relative error of 1e-10 per piece, also where the tyre lifts off or lands; with the defaults a
    /// piece is about 1 ms long. `length` and `velocity` follow from states alone: the strut closes no algebraic loop.
    /// `tyre_load` follows the road at once, and never the strut force; `external_force` follows the road and
    /// `force_without_friction` at once.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; a step that would take more than 500,000 pieces (2,000,000 divided by
    /// the number of states), which is reported as a result that is not finite. With the defaults that is a step of
    /// some minutes on a tyre without damping and of hours on the others. If after a tenth of the pieces less than a
    /// hundredth of the rest is done, the step is refused at once.
    ///
    /// # Limits
    /// The body does not pitch or roll, and the strut's lever ratio is constant. Road height and road velocity are two
    /// inputs: a master that holds them over its steps makes the road a staircase, one that gives input derivatives
    /// does not. The strut force comes from the master: held over a step, it makes the coupling a method of first
    /// order, stable for steps shorter than 2 `wheel_mass` / c for a damper c at the wheel, and half of that if both
    /// models step at once. The weight does not have to agree with `static_force`: heights count from the rest position
    /// in which it does.
    ///
    /// # Source
    /// The usual model of two masses, with a tyre that cannot pull. Defaults: front corner of the car ZR26 in Zips
    /// Racing's repository "Vehicle-Dynamics" (commit 0e8bbc8, MIT licence): 288.64 kg with driver, 48 % of it in
    /// front, less 16.36 kg per wheel; tyre stiffness and lever ratio. Tyre damping is chosen: 4 % of the critical
    /// damping of the wheel on its tyre. `static_length` and `static_force` are those of the default shock absorber at
    /// 22.5 mm of its travel, both chosen.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::QuarterCar;
    /// use stribeck::model::{Law, Model};
    /// let mut car = QuarterCar::default();
    /// car.wheel.strut_force += 52.91; // 1.011 m/s2 more at a lever ratio of 1.011
    /// car.step(0.1);
    /// assert!((car.body_height - 0.5 * 1.011 * 0.1 * 0.1).abs() < 1e-12);
    /// car.output();
    /// assert!(car.wheel.tyre_load > 69.27 * 9.81 && car.wheel.velocity > 0.0);
    /// ```
    QuarterCar: "Quarter car: body, wheel and tyre, driven by the force of a strut" {
        /// Height of the road under the wheel.
        road_height: input = real("m", 0.0).shown_in("mm").means(Meaning::GroundHeight),
        /// Rate of the road's height.
        road_velocity: input = real("m/s", 0.0).means(Meaning::GroundVelocity),
        /// Force of the strut without its friction; only the external force depends on it.
        force_without_friction: input = real("N", 1325.2555).means(Meaning::ForceWithoutFriction),
        /// Part of the strut force that moves the rod and not the body; 0 if they move together.
        rod_force: input = real("N", 0.0).means(Meaning::RodForce),
        /// Mass of the body, without the wheels.
        body_mass: fixed = real("kg", 52.91).positive(),
        /// The wheel's suspension.
        suspension: (Suspension),
        /// Height of the body above its height at rest.
        body_height: state_output = real("m", 0.0).nominal(1e-2).shown_in("mm"),
        /// Vertical velocity of the body.
        body_velocity: state_output = real("m/s", 0.0).nominal(0.1),
        /// The wheel and the strut.
        wheel: (Wheel),
        /// Force that the strut's friction must carry so that its length keeps its velocity; positive in extension.
        external_force: output = real("N", 0.0).means(Meaning::ExternalForce),
    }
}

impl<T: Scalar> QuarterCar<T> {
    fn road(&self) -> Motion<T> {
        Motion { height: self.road_height, velocity: self.road_velocity }
    }

    fn static_load(&self) -> T {
        T::from(GRAVITY) * (self.body_mass + self.suspension.wheel_mass)
    }

    /// Force of the strut with which body and wheel have the same acceleration, while the tyre carries more than at
    /// rest.
    fn holding_force(&self, excess: T) -> T {
        let Suspension { motion_ratio, static_force, wheel_mass, .. } = self.suspension;
        static_force + excess * self.body_mass / ((self.body_mass + wheel_mass) * motion_ratio)
    }
}

impl<T: Scalar> Law for QuarterCar<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        let body = Motion { height: self.body_height, velocity: self.body_velocity };
        let (road, static_load) = (self.road(), self.static_load());
        self.wheel.output(&self.suspension, body, road, static_load);
        self.external_force = self.force_without_friction - self.holding_force(self.wheel.tyre_load - static_load);
    }
}

impl<T: Scalar> Derivatives for QuarterCar<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.body_height = self.body_velocity;
        let lift = self.wheel.lift(&self.suspension) - self.suspension.motion_ratio * self.rod_force;
        rate.body_velocity = lift / self.body_mass;
        rate.wheel.wheel_height = self.wheel.wheel_velocity;
        rate.wheel.wheel_velocity = self.wheel.acceleration(&self.suspension, self.road(), self.static_load());
    }
}

impl Model for QuarterCar {
    fn step(&mut self, dt: f64) {
        integrate::held::<_, 4>(self, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        integrate::advance::<_, 4>(self, slope, dt);
    }

    fn branches(&self) -> u32 {
        self.wheel.is_on(&self.suspension, self.road(), self.static_load()).into()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::catalogue::by_name;
    use crate::instance::Instance;
    use crate::model::row_of;

    /// Height and velocity of a damped oscillator that is released from `z` at rest.
    fn let_go(z: f64, stiffness: f64, damping: f64, mass: f64, t: f64) -> [f64; 2] {
        let decay = damping / (2.0 * mass);
        let w = (stiffness / mass - decay * decay).sqrt();
        let (sine, cosine) = (w * t).sin_cos();
        let fade = z * (-decay * t).exp();
        [fade * (cosine + decay / w * sine), -fade * (stiffness / mass) / w * sine]
    }

    /// With a held strut force the wheel oscillates on its tyre alone.
    #[test]
    fn wheel_on_its_tyre_is_a_damped_oscillator() {
        for t in [1e-12, 1e-3, 0.02, 0.3, 1.0, 20.0] {
            let mut car = QuarterCar::default();
            car.wheel.wheel_height = -5e-3;
            car.step(t);
            let [height, velocity] = let_go(-5e-3, 87563.5, 95.8, 16.36, t);
            assert!((car.wheel.wheel_height - height).abs() < 1e-10, "{t}");
            assert!((car.wheel.wheel_velocity - velocity).abs() < 1e-8, "{t}");
            assert_eq!((car.body_height, car.body_velocity), (0.0, 0.0));
        }
    }

    /// The spring stiffnesses acting on the car, taken from its rates. The source of the parameters gives the
    /// frequencies of each mass alone: the body on both springs in series, the wheel between them.
    #[test]
    fn frequencies_are_those_of_the_source() {
        let stiffness = |body: f64, wheel: f64| {
            let mut car = QuarterCar { body_height: body, ..Default::default() };
            car.wheel.wheel_height = wheel;
            car.output();
            car.wheel.strut_force -= 45e3 * (car.wheel.length - 0.1775);
            let mut rate = car;
            car.rate(&mut rate);
            [-rate.body_velocity / 1e-3, -rate.wheel.wheel_velocity / 1e-3]
        };
        let ([a, c], [b, d]) = (stiffness(1e-3, 0.0), stiffness(0.0, 1e-3));
        let [body, hop] = [a - b * c / d, d].map(|square| square.sqrt() / std::f64::consts::TAU);
        assert!((body - 3.80).abs() < 5e-3 && (hop - 14.4).abs() < 0.05, "{body} Hz, {hop} Hz");
    }

    #[test]
    fn undamped_tyre_keeps_the_energy_of_the_wheel() {
        let mut car = QuarterCar::default();
        car.suspension.tyre_damping = 0.0;
        car.wheel.wheel_height = 5e-3;
        let energy = |car: &QuarterCar| {
            0.5 * (16.36 * car.wheel.wheel_velocity.powi(2) + 87563.5 * car.wheel.wheel_height.powi(2))
        };
        let before = energy(&car);
        for dt in [1e-5, 1e-3, 0.1, 3.0, 10.0] {
            car.step(dt);
            assert!((energy(&car) / before - 1.0).abs() < 1e-6, "{dt}: {}", energy(&car) / before - 1.0);
        }
    }

    /// In flight only the weight acts: m_s v_s + m_u v_u falls by (m_s + m_u) g t, and each mass moves in a parabola.
    #[test]
    fn free_flight() {
        let mut car = QuarterCar { road_height: -20.0, body_velocity: 0.3, ..Default::default() };
        car.wheel.strut_force += 100.0;
        car.output();
        assert_eq!(car.wheel.tyre_load, 0.0);
        let (t, push) = (0.7, 1.011 * 100.0);
        car.step(t);
        let momentum = 52.91 * car.body_velocity + 16.36 * car.wheel.wheel_velocity;
        assert!((momentum - (52.91 * 0.3 - 69.27 * 9.81 * t)).abs() < 1e-9, "{momentum}");
        let fall = 0.5 * (69.27 * 9.81 + push) / 16.36 * t * t;
        assert!((car.wheel.wheel_height + fall).abs() < 1e-10 && car.wheel.tyre_load == 0.0);
        assert_abs_diff_eq!(car.body_height, 0.3 * t + 0.5 * push / 52.91 * t * t, epsilon = 1e-10);
    }

    /// The wheel's equation as printed, in the fourth-order method with a tiny step: the method does not locate
    /// lift-off and landing, but its steps hardly cross them.
    fn fine(road: impl Fn(f64) -> [f64; 2], push: f64, end: f64) -> ([f64; 2], f64) {
        let load = |t: f64, [z, v]: [f64; 2]| {
            let [height, velocity] = road(t);
            f64::max(0.0, 69.27 * 9.81 + 87563.5 * (height - z) + 95.8 * (velocity - v))
        };
        let rate = |t: f64, y: [f64; 2]| [y[1], (load(t, y) - 69.27 * 9.81 - push) / 16.36];
        let n = 400_000;
        let h = end / f64::from(n);
        let (mut y, mut in_the_air) = ([0.0; 2], 0.0);
        for k in 0..n {
            let t = f64::from(k) * h;
            let after = |rate: [f64; 2], h: f64| [y[0] + h * rate[0], y[1] + h * rate[1]];
            let k_1 = rate(t, y);
            let k_2 = rate(t + 0.5 * h, after(k_1, 0.5 * h));
            let k_3 = rate(t + 0.5 * h, after(k_2, 0.5 * h));
            let k_4 = rate(t + h, after(k_3, h));
            y = [0, 1].map(|i| y[i] + h / 6.0 * (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]));
            in_the_air += if load(t, y) == 0.0 { h } else { 0.0 };
        }
        (y, in_the_air)
    }

    /// The road falls away by 30 mm: the wheel flies, lands and flies again.
    #[test]
    fn lift_off_and_landing_are_followed() {
        for end in [0.02, 0.1, 0.4] {
            let mut car = QuarterCar { road_height: -0.03, ..Default::default() };
            car.wheel.strut_force += 50.0;
            car.step(end);
            let ([height, velocity], in_the_air) = fine(|_| [-0.03, 0.0], 1.011 * 50.0, end);
            assert!(in_the_air > 0.01 && (end < 0.1 || in_the_air < end - 0.01), "{in_the_air} s");
            assert!((car.wheel.wheel_height - height).abs() < 1e-9, "{end}: {}", car.wheel.wheel_height - height);
            assert!((car.wheel.wheel_velocity - velocity).abs() < 1e-7, "{end}");
        }
    }

    /// A road that moves within the step: it sinks by 40 mm in 0.1 s, and rises.
    #[test]
    fn ramps_are_followed() {
        for rise in [-0.4, 0.4] {
            let mut car = QuarterCar { road_velocity: rise, ..Default::default() };
            let mut slope = car;
            crate::model::row_of_mut(&mut slope).fill(0.0);
            slope.road_height = rise;
            slope.wheel.strut_force = 300.0;
            car.step_ramp(&slope, 0.1);
            assert_eq!((car.road_height, car.wheel.strut_force), (0.1 * rise, 1325.2555 + 30.0));
            assert_abs_diff_eq!(car.body_velocity, 1.011 * 0.5 * 300.0 * 0.1 * 0.1 / 52.91, epsilon = 1e-12);

            let mut staircase = QuarterCar { road_velocity: rise, ..Default::default() };
            let n = 20_000;
            for k in 0..n {
                let middle = 0.1 * (f64::from(k) + 0.5) / f64::from(n);
                staircase.road_height = rise * middle;
                staircase.wheel.strut_force = 1325.2555 + 300.0 * middle;
                staircase.step(0.1 / f64::from(n));
            }
            let difference = car.wheel.wheel_height - staircase.wheel.wheel_height;
            assert!(difference.abs() < 1e-9, "{rise}: {difference}");
        }
    }

    #[test]
    fn two_half_steps_are_one_step() {
        for dt in [1e-12, 1e-6, 1e-3, 0.03, 1.0] {
            for road_height in [-0.05, -5e-3, 0.02] {
                let mut whole = QuarterCar { road_height, road_velocity: -0.2, ..Default::default() };
                whole.wheel.strut_force -= 200.0;
                let mut halves = whole;
                whole.step(dt);
                halves.step(0.5 * dt);
                halves.step(0.5 * dt);
                for (a, b) in row_of(&whole).iter().zip(row_of(&halves)) {
                    assert!((a - b).abs() < 1e-9 * a.abs().max(1.0), "{dt} {road_height}: {a} against {b}");
                }
            }
        }
    }

    /// A step that would take forever is refused, and nothing has changed.
    #[test]
    fn endless_steps_are_refused() {
        let mut car = Instance::new(by_name("QuarterCar").expect("a model"));
        car.set_column(0, 1e-3).unwrap();
        car.step(1.0).expect("a second is a step");
        let before = car.save();
        let fault = car.step(1e9).expect_err("30 years are not");
        assert!(fault.0.starts_with("a step of 1000000000 s would not be finite"), "{fault}");
        assert_eq!(car.save(), before);
    }
}
