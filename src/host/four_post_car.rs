use crate::host::vertical::{Axle, Body, Car, Corner, Motion, Wheel};
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, integrate, real};
use crate::number::Scalar;

crate::part! {
    /// A corner of the car, on its post.
    Post {
        /// Height of the post under the wheel.
        post_height: input = real("m", 0.0).shown_in("mm").means(Meaning::GroundHeight),
        /// Rate of the post's height.
        post_velocity: input = real("m/s", 0.0).means(Meaning::GroundVelocity),
        /// The wheel and the strut.
        wheel: (Wheel),
    }
}

crate::model! {
    /// A car on four posts: heave, pitch and roll of the body and the heights of four wheels, with tyres that lift off.
    /// The four struts are other models, such as shock absorbers.
    ///
    /// # Equations
    /// For each corner k at the place $(X_k, Y_k)$, forward and to the left of the centre of gravity:
    ///
    /// ```text
    /// z_k   = z - X_k theta + Y_k phi
    /// l_k   = l_0 + r (z_k - z_uk)
    /// F_k   = r (f_k - f_0)
    /// f_tk  = max(0, f_t0 + k_t (z_rk - z_uk) + c_t (v_rk - dz_uk/dt))
    /// ```
    ///
    /// ```text
    /// m_s d2z/dt2       = sum_k F_k
    /// I_yy d2theta/dt2  = -sum_k X_k F_k
    /// I_xx d2phi/dt2    = sum_k Y_k F_k
    /// m_u d2z_uk/dt2    = f_tk - f_t0 - F_k
    /// ```
    ///
    /// The load $f_t0$ of a tyre at rest is the weight of its wheel and half of the body's weight on its axle.
    ///
    /// | symbol     | variable               | unit  | meaning                                            |
    /// |------------|------------------------|-------|----------------------------------------------------|
    /// | f_k        | `fl.strut_force`       | N     | force of the strut                                 |
    /// | z_rk       | `fl.post_height`       | m     | height of the post                                 |
    /// | v_rk       | `fl.post_velocity`     | m/s   | rate of the post's height                          |
    /// | z_uk       | `fl.wheel_height`      | m     | height of the wheel above its height at rest       |
    /// | dz_uk/dt   | `fl.wheel_velocity`    | m/s   | vertical velocity of the wheel                     |
    /// | z_k        |                        | m     | height of the body above the wheel                 |
    /// | l_k        | `fl.length`            | m     | length of the strut                                |
    /// | dl_k/dt    | `fl.velocity`          | m/s   | rate of the strut's length                         |
    /// | f_tk       | `fl.tyre_load`         | N     | force of the tyre on the post                      |
    /// | r          | `front.motion_ratio`   | 1     | damper travel per wheel travel                     |
    /// | l_0        | `front.static_length`  | m     | length of the strut at rest                        |
    /// | f_0        | `front.static_force`   | N     | force of the strut at rest                         |
    /// | m_u        | `front.wheel_mass`     | kg    | unsprung mass of a corner                          |
    /// | k_t        | `front.tyre_stiffness` | N/m   | stiffness of a tyre                                |
    /// | c_t        | `front.tyre_damping`   | N.s/m | damping of a tyre                                  |
    /// | 2 abs(Y_k) | `front.track`          | m     | distance between the wheels of the axle            |
    /// | m_s        | `body_mass`            | kg    | mass of the body                                   |
    /// | I_yy       | `pitch_inertia`        | kg.m2 | moment of inertia about the lateral axis           |
    /// | I_xx       | `roll_inertia`         | kg.m2 | moment of inertia about the longitudinal axis      |
    /// | X_1 - X_3  | `wheelbase`            | m     | distance between the axles                         |
    /// | X_1        | `cg_to_front`          | m     | centre of gravity to front axle                    |
    /// | z          | `heave`                | m     | height of the centre of gravity above that at rest |
    /// | dz/dt      | `heave_rate`           | m/s   | its rate                                           |
    /// | theta      | `pitch`                | rad   | pitch angle                                        |
    /// | dtheta/dt  | `pitch_rate`           | rad/s | its rate                                           |
    /// | phi        | `roll`                 | rad   | roll angle                                         |
    /// | dphi/dt    | `roll_rate`            | rad/s | its rate                                           |
    ///
    /// The corners are `fl`, `fr`, `rl`, `rr` (front left to rear right), the axles `front` and `rear`.
    ///
    /// # Sign
    /// Axes as in ISO 8855: x forward, y left, $z$ up. `pitch` is positive nose down, `roll` lowers the right side. A
    /// strut force is positive if it pushes the eyes of the strut apart; a strut's velocity is positive as it extends.
    ///
    /// # Step
    /// As that of `QuarterCar`: the inputs are held or move linearly, and error control divides the step (order 5,
    /// relative error 1e-10 per piece), also where tyres lift off or land. Lengths and velocities of the struts follow
    /// from states alone, so the struts close no algebraic loop. A tyre load follows its post at once, and no strut
    /// force.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `cg_to_front` > `wheelbase`; a step that would take more than 140,000
    /// pieces, as with `QuarterCar`.
    ///
    /// # Limits
    /// Small angles; the body is rigid; no anti-roll bars; wheels move vertically only. The horizontal spring-dampers
    /// of a contact patch, which would restrain a change of track, have nothing to act on here. A post that is held
    /// over steps is a staircase: give input derivatives. For the step of the coupling see `QuarterCar`.
    ///
    /// # Source
    /// Equations: rigid-body dynamics about a rest position. Defaults: the car ZR26 in Zips Racing's repository
    /// "Vehicle-Dynamics" (commit 0e8bbc8, MIT licence): 288.64 kg with driver, 48 % of it in front, wheels of 16.36
    /// kg, wheelbase, tracks, lever ratios, tyre stiffness; its moments of inertia, which the source gives for the car,
    /// are used for the body. Derived: a body of 223.2 kg with its centre of gravity 0.8035 m behind the front axle.
    /// Chosen: tyre damping (4 % of critical), and struts of 177.5 mm at rest, with the force of the default shock
    /// absorber in front and of one with a spring of 35 kN/m (`spring.k`) in the rear.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::FourPostCar;
    /// use stribeck::model::{Law, Model};
    /// let mut car = FourPostCar::default();
    /// car.fl.post_height = 1e-3; // 87.6 N more on this tyre
    /// car.output();
    /// assert!((car.fl.wheel.tyre_load - car.fr.wheel.tyre_load - 87.5635).abs() < 1e-9);
    /// let load: f64 = [car.fl, car.fr, car.rl, car.rr].iter().map(|post| post.wheel.tyre_load).sum();
    /// assert!((load - 9.81 * 288.64 - 87.5635).abs() < 1e-9);
    /// ```
    FourPostCar: "Car on four posts, driven by the forces of four struts" {
        /// The body.
        body: (Body),
        /// The front axle.
        front: Axle,
        /// The rear axle.
        rear: Axle = &[("track", 1.20), ("motion_ratio", 1.004), ("static_force", 1100.2555)],
        /// Front left corner.
        fl: Post,
        /// Front right corner.
        fr: Post,
        /// Rear left corner.
        rl: Post = &[("strut_force", 1100.2555)],
        /// Rear right corner.
        rr: Post = &[("strut_force", 1100.2555)],
    }
}

impl<T: Scalar> FourPostCar<T> {
    fn post(&self, corner: Corner) -> &Post<T> {
        match corner {
            Corner::FrontLeft => &self.fl,
            Corner::FrontRight => &self.fr,
            Corner::RearLeft => &self.rl,
            Corner::RearRight => &self.rr,
        }
    }
}

impl<T: Scalar> Car<T> for FourPostCar<T> {
    fn body(&self) -> &Body<T> {
        &self.body
    }

    fn axle(&self, corner: Corner) -> &Axle<T> {
        if corner.is_front() { &self.front } else { &self.rear }
    }

    fn wheel(&self, corner: Corner) -> &Wheel<T> {
        &self.post(corner).wheel
    }

    fn wheel_mut(&mut self, corner: Corner) -> &mut Wheel<T> {
        match corner {
            Corner::FrontLeft => &mut self.fl.wheel,
            Corner::FrontRight => &mut self.fr.wheel,
            Corner::RearLeft => &mut self.rl.wheel,
            Corner::RearRight => &mut self.rr.wheel,
        }
    }

    fn ground(&self, corner: Corner) -> Motion<T> {
        let Post { post_height, post_velocity, .. } = *self.post(corner);
        Motion { height: post_height, velocity: post_velocity }
    }
}

impl<T: Scalar> Law for FourPostCar<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.output_wheels();
    }
}

impl<T: Scalar> Derivatives for FourPostCar<T> {
    fn derivatives(&self, rate: &mut Self) {
        self.body.rate(self.strut_load(), &mut rate.body);
        for corner in Corner::ALL {
            let rate = rate.wheel_mut(corner);
            rate.wheel_height = self.wheel(corner).wheel_velocity;
            rate.wheel_velocity = self.wheel_acceleration(corner);
        }
    }
}

impl Model for FourPostCar {
    fn check(&self) -> Result<(), Fault> {
        self.body.check()
    }

    fn step(&mut self, dt: f64) {
        integrate::held::<_, 14>(self, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        integrate::advance::<_, 14>(self, slope, dt);
    }

    fn branches(&self) -> u32 {
        self.wheels_on_ground()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::host::QuarterCar;
    use crate::host::vertical::Suspension;
    use crate::model::{row_of, row_of_mut};

    /// Front and rear equal, with the centre of gravity in the middle.
    fn symmetrical() -> FourPostCar {
        let mut car = FourPostCar::default();
        car.rear = car.front;
        (car.rl, car.rr) = (car.fl, car.fr);
        car.body.cg_to_front = 0.5 * car.body.wheelbase;
        car
    }

    fn posts(car: &mut FourPostCar) -> [&mut Post; 4] {
        [&mut car.fl, &mut car.fr, &mut car.rl, &mut car.rr]
    }

    /// Linear struts, in steps of 1 ms in which all inputs are held.
    fn ride(car: &mut FourPostCar, steps: usize, mut seen: impl FnMut(&FourPostCar)) {
        for _ in 0..steps {
            car.output();
            for post in posts(car) {
                post.wheel.strut_force = 1325.2555 - 45e3 * (post.wheel.length - 0.1775) - 1900.0 * post.wheel.velocity;
            }
            car.step(1e-3);
            seen(car);
        }
    }

    fn ride_quarter(car: &mut QuarterCar) {
        car.output();
        let wheel = &mut car.wheel;
        wheel.strut_force = 1325.2555 - 45e3 * (wheel.length - 0.1775) - 1900.0 * wheel.velocity;
        car.step(1e-3);
    }

    #[test]
    fn the_car_rests() {
        let mut car = FourPostCar::default();
        let before = car;
        car.step(1.0);
        assert_eq!(row_of(&car), row_of(&before));
        car.output();
        let loads = [car.fl, car.fr, car.rl, car.rr].map(|post| post.wheel.tyre_load);
        assert_eq!((loads[0], loads[2]), (loads[1], loads[3]));
        let total: f64 = loads.iter().sum();
        assert_abs_diff_eq!(total, 288.64 * 9.81, epsilon = 1e-9);
        // 48 % in front.
        assert!(((loads[0] + loads[1]) / total - 0.48).abs() < 1e-4, "{loads:?}");
    }

    /// 40 mm, and the tyres lift off: the quarter car has a quarter of the body's mass.
    #[test]
    fn equal_posts_heave_as_four_quarter_cars() {
        let mut car = symmetrical();
        posts(&mut car).into_iter().for_each(|post| post.post_height = -0.04);
        let mut quarter = QuarterCar { body_mass: 0.25 * car.body.body_mass, road_height: -0.04, ..Default::default() };
        let mut flights = 0;
        ride(&mut car, 500, |car| {
            ride_quarter(&mut quarter);
            quarter.output();
            flights += usize::from(quarter.wheel.tyre_load == 0.0);
            assert_abs_diff_eq!(car.body.heave, quarter.body_height, epsilon = 1e-9);
            for post in [car.fl, car.fr, car.rl, car.rr] {
                assert_abs_diff_eq!(post.wheel.wheel_height, quarter.wheel.wheel_height, epsilon = 1e-9);
            }
            assert!(car.body.pitch.abs() < 1e-12 && car.body.roll.abs() < 1e-12);
        });
        assert!(flights > 10, "{flights}");
    }

    /// Left up, right down: the body rolls, as a quarter car whose mass is I / Y^2 / 4. It pitches in the same way.
    #[test]
    fn opposite_posts_roll_and_pitch_as_quarter_cars() {
        let modes = |car: &FourPostCar| {
            let Body { wheelbase, pitch_inertia, roll_inertia, .. } = car.body;
            let half_track = 0.5 * car.front.track;
            [
                (roll_inertia, half_track, [1.0, -1.0, 1.0, -1.0]),
                (pitch_inertia, 0.5 * wheelbase, [-1.0, -1.0, 1.0, 1.0]),
            ]
        };
        for (mode, (inertia, lever, signs)) in modes(&symmetrical()).into_iter().enumerate() {
            let mut car = symmetrical();
            for (post, sign) in posts(&mut car).into_iter().zip(signs) {
                post.post_height = sign * 2e-3;
            }
            let body_mass = 0.25 * inertia / (lever * lever);
            let mut quarter = QuarterCar { body_mass, road_height: 2e-3, ..Default::default() };
            ride(&mut car, 300, |car| {
                ride_quarter(&mut quarter);
                let (angle, other) =
                    if mode == 0 { (car.body.roll, car.body.pitch) } else { (car.body.pitch, car.body.roll) };
                assert!((angle * lever - quarter.body_height).abs() < 1e-9, "mode {mode}: {angle}");
                assert!(other.abs() < 1e-12 && car.body.heave.abs() < 1e-12);
            });
            assert!(quarter.body_height > 1e-3, "it has moved");
        }
    }

    /// One strut pushes for a while: linear and angular momentum are those of its force, whatever the tyres do.
    #[test]
    fn a_single_strut_gives_its_momentum() {
        let mut car = FourPostCar::default();
        car.rl.wheel.strut_force += 70.0;
        car.step(0.25);
        let impulse = 70.0 * 1.004 * 0.25;
        assert_abs_diff_eq!(223.2 * car.body.heave_rate, impulse, epsilon = 1e-9);
        // Behind the centre of gravity and left of it: the nose and the right side go down.
        assert_abs_diff_eq!(126.29 * car.body.pitch_rate, (1.528 - 0.8035) * impulse, epsilon = 1e-9);
        assert_abs_diff_eq!(26.46 * car.body.roll_rate, 0.60 * impulse, epsilon = 1e-9);
        assert_eq!(car.fl.wheel.wheel_velocity, 0.0);
        assert!(car.rl.wheel.wheel_height < -1e-6);
    }

    #[test]
    fn two_half_steps_are_one_step_also_on_ramps() {
        for dt in [1e-12, 1e-4, 0.02, 1.0] {
            let mut whole = FourPostCar::default();
            whole.fl.post_height = -0.03;
            whole.rr.wheel.strut_force += 400.0;
            let mut slope = whole;
            row_of_mut(&mut slope).fill(0.0);
            (slope.fr.post_height, slope.rl.post_velocity, slope.fl.wheel.strut_force) = (0.1 / dt, -0.5, 200.0);
            if dt < 1e-3 {
                slope.fr.post_height = 0.5;
            }
            let mut halves = whole;
            whole.step_ramp(&slope, dt);
            halves.step_ramp(&slope, 0.5 * dt);
            halves.step_ramp(&slope, 0.5 * dt);
            for (a, b) in row_of(&whole).iter().zip(row_of(&halves)) {
                assert!((a - b).abs() < 1e-9 * a.abs().max(1.0), "{dt}: {a} against {b}");
            }
        }
    }

    #[test]
    fn a_centre_of_gravity_behind_the_rear_axle_is_refused() {
        let mut car = FourPostCar::default();
        car.body.cg_to_front = 2.0;
        let fault = car.check().expect_err("it would tip over");
        assert_eq!(fault.0, "cg_to_front = 2: must be <= wheelbase = 1.528");
    }

    /// Force of the struts at rest as stated on the pages: preload, spring and gas of the default shock absorber at
    /// 22.5 mm.
    #[test]
    fn static_forces_are_those_of_the_default_struts() {
        let area = std::f64::consts::PI * 0.007 * 0.007;
        let gas = (1e6 * (3e-5 / (3e-5 - area * 0.0225f64)).powf(1.2) - 101_325.0) * area;
        let force = |stiffness: f64| 150.0 + stiffness * 0.0225 + gas;
        let FourPostCar { front, rear, .. } = FourPostCar::default();
        for (Suspension { static_force, .. }, stiffness) in [(front.suspension, 45e3), (rear.suspension, 35e3)] {
            assert!((static_force - force(stiffness)).abs() < 1e-4, "{}", force(stiffness));
        }
    }
}
