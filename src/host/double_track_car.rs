use crate::host::integrate;
use crate::host::magic_formula::{Contact, MagicFormula, Side, Wrench};
use crate::host::vertical::{Axle, Body, Car, Corner, GRAVITY, Load, Motion, Wheel};
use crate::model::{Fault, Law, Model, real};
use crate::number::Real;

crate::part! {
    /// An axle with its roll centre.
    RollingAxle {
        /// Height of the roll centre above the ground.
        roll_centre_height: fixed = real("m", 0.035).shown_in("mm"),
        /// Its wheels.
        axle: (Axle),
    }
}

crate::part! {
    /// A corner of the car, on the road.
    RollingWheel {
        /// Height of the road under the wheel.
        road_height: input = real("m", 0.0).shown_in("mm"),
        /// Rate of the road's height.
        road_velocity: input = real("m/s", 0.0),
        /// The wheel and the strut.
        wheel: (Wheel),
        /// Side slip of the tyre; positive when the wheel slips to the left.
        side_slip: state_output = real("rad", 0.0).nominal(1e-2).shown_in("deg"),
        /// Lateral force of the road on the tyre; positive to the left.
        lateral_force: output = real("N", 0.0).nominal(100.0),
    }
}

crate::model! {
    /// A car with two tracks at constant speed: it is steered, slips sideways, yaws, rolls and pitches. Its tyres
    /// follow the Magic Formula; its four struts are other models. It adds the motion in the plane of the road to the
    /// car on four posts.
    /// # Equations
    ///
    /// In the plane of the road. A wheel k is X_k ahead of the car's centre of gravity; delta_k is 0 at the rear:
    ///
    /// ```text
    /// m (dv_y/dt + V r) = sum_k F_k                                                     (1)
    /// I_zz dr/dt        = sum_k (X_k F_k + M_k)                                         (2)
    /// dalpha_k/dt       = V / sigma (atan((v_y + X_k r) / V) - delta_k - alpha_k)       (3)
    /// dx/dt             = V cos psi - v_y sin psi
    /// dy/dt             = V sin psi + v_y cos psi
    /// dpsi/dt           = r
    /// a_y               = dv_y/dt + V r
    /// ```
    ///
    /// F_k and M_k are lateral force and aligning torque of a tyre: the Magic Formula 5.2, for the load f_tk, the side
    /// slip alpha_k and no camber. Without shifts the force is
    ///
    /// ```text
    /// F_k = D sin(C atan(B alpha_k - E (B alpha_k - atan(B alpha_k))))                  (4)
    /// D   = (p_1 + p_2 (f_tk - f_n) / f_n) f_tk
    /// ```
    ///
    /// Body and wheels. A wheel is at the place (x_k, y_k) seen from the body's centre of gravity:
    ///
    /// ```text
    /// z_k   = z - x_k theta + y_k phi
    /// l_k   = l_0 + MR (z_k - z_uk)
    /// L_k   = MR (f_k - f_0)
    /// f_tk  = max(0, f_t0 + k_t (z_rk - z_uk) + c_t (v_rk - dz_uk/dt))
    /// ```
    ///
    /// ```text
    /// m_s d2z/dt2      = sum_k L_k                                                      (5)
    /// I_yy d2theta/dt2 = -sum_k x_k L_k                                                 (6)
    /// I_xx d2phi/dt2   = sum_k y_k L_k + sum_a B_a (h_s - h_a) + m_s g (h_s - h_r) phi  (7)
    /// m_u d2z_uk/dt2   = f_tk - f_t0 - L_k + s_k C_a / T                                (8)
    /// B_a              = F_a - W_a
    /// C_a              = B_a h_a + W_a h_u
    /// W_a              = 2 m_u (a_y + X_a dr/dt)
    /// ```
    ///
    /// F_a is the lateral force of both tyres of an axle a; W_a is the part that accelerates its wheels and B_a the
    /// part that acts on the body, at the height h_a of the roll centre. C_a tilts the axle: s_k is 1 for its left
    /// wheel and -1 for its right wheel. h_r is the height, at the body's centre of gravity, of the line through both
    /// roll centres.
    ///
    /// | symbol     | variable                   | unit  | meaning                                             |
    /// |------------|----------------------------|-------|-----------------------------------------------------|
    /// | delta      | `steering_angle`           | rad   | steering angle of both front wheels                 |
    /// | V          | `speed`                    | m/s   | forward speed                                       |
    /// | I_zz       | `yaw_inertia`              | kg.m2 | moment of inertia of the car about z                |
    /// | h_s        | `cg_height`                | m     | height of the body's centre of gravity              |
    /// | h_u        | `wheel_centre_height`      | m     | height of the wheels' centres of gravity            |
    /// | sigma      | `relaxation_length`        | m     | relaxation length of the tyres                      |
    /// | p_1        | `tyre.pdy1`                | 1     | friction; all of `tyre` has the names of tyre files |
    /// | p_2        | `tyre.pdy2`                | 1     | its change with load                                |
    /// | f_n        | `tyre.fnomin`              | N     | nominal load, here times `tyre.lfzo`                |
    /// |            | `tyre.side`                |       | side that the tyre set was measured for             |
    /// | m_s        | `body_mass`                | kg    | mass of the body; m is that of the car              |
    /// | I_yy       | `pitch_inertia`            | kg.m2 | moment of inertia of the body about y               |
    /// | I_xx       | `roll_inertia`             | kg.m2 | moment of inertia of the body about x               |
    /// | x_1 - x_3  | `wheelbase`                | m     | distance between the axles                          |
    /// | x_1        | `cg_to_front`              | m     | centre of gravity of the body to front axle         |
    /// | z          | `heave`                    | m     | height of the body's centre of gravity above rest   |
    /// | dz/dt      | `heave_rate`               | m/s   | its rate                                            |
    /// | theta      | `pitch`                    | rad   | pitch angle                                         |
    /// | dtheta/dt  | `pitch_rate`               | rad/s | its rate                                            |
    /// | phi        | `roll`                     | rad   | roll angle                                          |
    /// | dphi/dt    | `roll_rate`                | rad/s | its rate                                            |
    /// | x          | `position_x`               | m     | position of the car's centre of gravity             |
    /// | y          | `position_y`               | m     | position to the left                                |
    /// | psi        | `yaw_angle`                | rad   | yaw angle                                           |
    /// | v_y        | `lateral_velocity`         | m/s   | lateral velocity of the car's centre of gravity     |
    /// | r          | `yaw_rate`                 | rad/s | yaw rate                                            |
    /// | a_y        | `lateral_acceleration`     | m/s2  | lateral acceleration of the car's centre of gravity |
    /// | h_a        | `front.roll_centre_height` | m     | height of the roll centre of an axle                |
    /// | T          | `front.track`              | m     | distance between the wheels of an axle              |
    /// | MR         | `front.motion_ratio`       | 1     | damper travel per wheel travel                      |
    /// | l_0        | `front.static_length`      | m     | length of the strut at rest                         |
    /// | f_0        | `front.static_force`       | N     | force of the strut at rest                          |
    /// | m_u        | `front.wheel_mass`         | kg    | unsprung mass of a corner                           |
    /// | k_t        | `front.tyre_stiffness`     | N/m   | stiffness of a tyre                                 |
    /// | c_t        | `front.tyre_damping`       | N.s/m | damping of a tyre                                   |
    /// | f_k        | `fl.strut_force`           | N     | force of the strut                                  |
    /// | z_rk       | `fl.road_height`           | m     | height of the road                                  |
    /// | v_rk       | `fl.road_velocity`         | m/s   | rate of the road's height                           |
    /// | z_uk       | `fl.wheel_height`          | m     | height of the wheel above its height at rest        |
    /// | dz_uk/dt   | `fl.wheel_velocity`        | m/s   | vertical velocity of the wheel                      |
    /// | l_k        | `fl.length`                | m     | length of the strut                                 |
    /// | dl_k/dt    | `fl.velocity`              | m/s   | rate of the strut's length                          |
    /// | f_tk       | `fl.tyre_load`             | N     | force of the tyre on the road                       |
    /// | alpha_k    | `fl.side_slip`             | rad   | side slip of the tyre                               |
    /// | F_k        | `fl.lateral_force`         | N     | lateral force of the tyre                           |
    ///
    /// The corners are `fl`, `fr`, `rl`, `rr` (front left to rear right), the axles `front` and `rear`.
    ///
    /// # Sign
    /// Axes of ISO 8855: x forward, y left, z up; angles turn about them by the right-hand rule, so steering, yaw and
    /// yaw rate are positive to the left, roll is positive when the right side goes down, pitch when the nose goes
    /// down. `side_slip` is positive when the wheel slips to the left; then the tyre is pushed to the right,
    /// `lateral_force` < 0. `strut_force` is positive when it pushes the eyes of the strut apart, `velocity` when the
    /// strut extends. Heights and angles of the body are deviations from rest on a level road.
    ///
    /// # Step
    /// As that of `FourPostCar`: the inputs are held or move linearly, and error control divides the step (order 5,
    /// relative error 1e-10 per piece), also where tyres lift off or land. Lengths and velocities of the struts follow
    /// from states alone, so the struts close no algebraic loop. Tyre loads and lateral forces follow the road at once,
    /// but neither the steering nor the struts.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `cg_to_front` > `wheelbase`; `tyre.pky2` = 0; a step that would take
    /// more than 86,000 pieces, as with `QuarterCar`.
    ///
    /// # Limits
    /// The speed is constant: no drive, no brakes, no longitudinal forces. Small angles: the lateral forces count along
    /// the y axis of the body, both front wheels are steered alike, wheels stay upright (no camber), and both wheels of
    /// an axle have the path of its middle. The overturning couple of the tyres is left out. The roll centres stay
    /// where they are, and nothing lifts the body when the tyres of an axle share the lateral force unequally. No
    /// anti-roll bars: add their force to `strut_force`. The relaxation length does not change with load.
    ///
    /// # Source
    /// (1) to (4): H. B. Pacejka, "Tyre and Vehicle Dynamics", 2nd ed., Butterworth-Heinemann (2006): two-track model
    /// with the roll axis, section 1.3; Magic Formula, section 4.3.2, in the form of version 5.2; relaxation in its
    /// simplest form, of the side slip. (5) to (8): rigid-body dynamics about a rest position. Defaults: body, wheels,
    /// struts and axles as `FourPostCar`; from the same car ZR26 the yaw inertia and the heights of the roll centres;
    /// `cg_height` is derived from the 0.293 m of that car less its wheels; tyres: an open set (Open-Car-Dynamics,
    /// Apache-2.0), scaled from a nominal load of 3000 N to 700 N, without its shifts and its friction scale of 0.97.
    /// Chosen: speed, relaxation length, height of the wheels.
    ///
    /// # Example
    /// The loads of the tyres carry the car, 288.64 kg, and the tyres push to the left in a turn to the left:
    /// ```
    /// use stribeck::host::DoubleTrackCar;
    /// use stribeck::model::{Law, Model};
    /// let mut car = DoubleTrackCar { steering_angle: 0.001, ..Default::default() };
    /// car.step(0.2);
    /// car.output();
    /// let wheels = [car.fl, car.fr, car.rl, car.rr];
    /// let load: f64 = wheels.iter().map(|wheel| wheel.wheel.tyre_load).sum();
    /// assert!((load - 9.81 * 288.64).abs() < 1e-6);
    /// let force: f64 = wheels.iter().map(|wheel| wheel.lateral_force).sum();
    /// assert!(force > 0.0 && (force / 288.64 - car.lateral_acceleration).abs() < 1e-12);
    /// ```
    DoubleTrackCar: "Double-track car steered at constant speed, with Magic Formula tyres" {
        /// Steering angle of the front wheels; positive to the left.
        steering_angle: input = real("rad", 0.0).shown_in("deg"),
        /// The body.
        body: (Body),
        /// Forward speed.
        speed: fixed = real("m/s", 20.0).positive().nominal(10.0),
        /// Moment of inertia of the car about its vertical axis.
        yaw_inertia: fixed = real("kg.m2", 142.92).positive(),
        /// Height of the body's centre of gravity above the ground.
        cg_height: fixed = real("m", 0.3203).at_least(0.0),
        /// Height of the wheels' centres of gravity above the ground (default chosen).
        wheel_centre_height: fixed = real("m", 0.2).at_least(0.0),
        /// Relaxation length: rolling distance after which the side slip has reached 63 % (default chosen).
        relaxation_length: fixed = real("m", 0.2).positive(),
        /// The tyres: four identical ones.
        tyre: MagicFormula,
        /// Position of the car's centre of gravity along the road.
        position_x: state_output = real("m", 0.0),
        /// Lateral position of the car's centre of gravity; positive to the left.
        position_y: state_output = real("m", 0.0),
        /// Yaw angle; positive to the left.
        yaw_angle: state_output = real("rad", 0.0).nominal(0.1).shown_in("deg"),
        /// Lateral velocity of the car's centre of gravity; positive to the left.
        lateral_velocity: state_output = real("m/s", 0.0).nominal(0.1),
        /// Yaw rate; positive to the left.
        yaw_rate: state_output = real("rad/s", 0.0).nominal(0.1),
        /// Lateral acceleration of the car's centre of gravity; positive to the left.
        lateral_acceleration: output = real("m/s2", 0.0),
        /// The front axle.
        front: RollingAxle,
        /// The rear axle.
        rear: RollingAxle = &[
            ("roll_centre_height", 0.05),
            ("track", 1.20),
            ("motion_ratio", 1.004),
            ("static_force", 1100.2555),
        ],
        /// Front left corner.
        fl: RollingWheel,
        /// Front right corner.
        fr: RollingWheel,
        /// Rear left corner.
        rl: RollingWheel = &[("strut_force", 1100.2555)],
        /// Rear right corner.
        rr: RollingWheel = &[("strut_force", 1100.2555)],
    }
}

impl<T: Real> DoubleTrackCar<T> {
    fn rolling_axle(&self, corner: Corner) -> &RollingAxle<T> {
        if corner.is_front() { &self.front } else { &self.rear }
    }

    fn corner(&self, corner: Corner) -> &RollingWheel<T> {
        match corner {
            Corner::FrontLeft => &self.fl,
            Corner::FrontRight => &self.fr,
            Corner::RearLeft => &self.rl,
            Corner::RearRight => &self.rr,
        }
    }

    fn corner_mut(&mut self, corner: Corner) -> &mut RollingWheel<T> {
        match corner {
            Corner::FrontLeft => &mut self.fl,
            Corner::FrontRight => &mut self.fr,
            Corner::RearLeft => &mut self.rl,
            Corner::RearRight => &mut self.rr,
        }
    }

    /// Mass of the car.
    fn mass(&self) -> T {
        let two = T::from(2.0);
        self.body.body_mass + two * (self.front.axle.suspension.wheel_mass + self.rear.axle.suspension.wheel_mass)
    }

    /// Distance of a wheel ahead of the centre of gravity of the car, which is not that of its body.
    fn ahead(&self, corner: Corner) -> T {
        let moment = |corner| self.place(corner).x * self.axle(corner).suspension.wheel_mass;
        let moments = Corner::ALL.into_iter().fold(T::zero(), |sum, corner| sum + moment(corner));
        self.place(corner).x - moments / self.mass()
    }

    /// Forces and moments of the road on a tyre.
    fn wrench(&self, corner: Corner) -> Wrench<T> {
        let contact = Contact {
            load: self.tyre_load(corner),
            longitudinal_slip: T::zero(),
            side_slip: self.corner(corner).side_slip,
            camber: T::zero(),
            speed: self.speed,
        };
        self.tyre.wrench_on(if corner.is_left() { Side::Left } else { Side::Right }, &contact)
    }
}

impl<T: Real> Car<T> for DoubleTrackCar<T> {
    fn body(&self) -> &Body<T> {
        &self.body
    }

    fn axle(&self, corner: Corner) -> &Axle<T> {
        &self.rolling_axle(corner).axle
    }

    fn wheel(&self, corner: Corner) -> &Wheel<T> {
        &self.corner(corner).wheel
    }

    fn wheel_mut(&mut self, corner: Corner) -> &mut Wheel<T> {
        &mut self.corner_mut(corner).wheel
    }

    fn ground(&self, corner: Corner) -> Motion<T> {
        let RollingWheel { road_height, road_velocity, .. } = *self.corner(corner);
        Motion { height: road_height, velocity: road_velocity }
    }
}

impl<T: Real> Law for DoubleTrackCar<T> {
    fn output(&mut self) {
        self.output_wheels();
        let mut sum = T::zero();
        for corner in Corner::ALL {
            let force = self.wrench(corner).force_y;
            self.corner_mut(corner).lateral_force = force;
            sum = sum + force;
        }
        self.lateral_acceleration = sum / self.mass();
    }

    fn derivatives(&self, rate: &mut Self) {
        let motion = self.plane_motion();
        let [sin, cos] = [self.yaw_angle.sin(), self.yaw_angle.cos()];
        rate.position_x = self.speed * cos - self.lateral_velocity * sin;
        rate.position_y = self.speed * sin + self.lateral_velocity * cos;
        rate.yaw_angle = self.yaw_rate;
        rate.lateral_velocity = motion.acceleration - self.speed * self.yaw_rate;
        rate.yaw_rate = motion.yaw_acceleration;
        self.body.rate(self.load_of_body(&motion), &mut rate.body);
        for corner in Corner::ALL {
            let by_links = self.link_force(corner, &motion) / self.axle(corner).suspension.wheel_mass;
            let rate = rate.corner_mut(corner);
            rate.side_slip = self.side_slip_rate(corner);
            rate.wheel.wheel_height = self.wheel(corner).wheel_velocity;
            rate.wheel.wheel_velocity = self.wheel_acceleration(corner) + by_links;
        }
    }
}

/// Motion of the car in the plane of the road.
struct PlaneMotion<T> {
    /// Acceleration of the car's centre of gravity.
    acceleration: T,
    yaw_acceleration: T,
    /// Of the front and of the rear axle.
    axles: [AxleForce<T>; 2],
}

/// Action of the road on an axle.
#[derive(Clone, Copy)]
struct AxleForce<T> {
    /// Place of the axle ahead of the car's centre of gravity.
    x: T,
    /// Lateral force of both tyres.
    force: T,
    /// Aligning torque of both tyres.
    torque: T,
}

impl<T: Real> PlaneMotion<T> {
    fn axle(&self, corner: Corner) -> AxleForce<T> {
        self.axles[usize::from(!corner.is_front())]
    }

    /// Force of inertia of both wheels of an axle, in the direction of the acceleration.
    fn of_wheels(&self, corner: Corner, axle: &RollingAxle<T>) -> T {
        let acceleration = self.acceleration + self.axle(corner).x * self.yaw_acceleration;
        T::from(2.0) * axle.axle.suspension.wheel_mass * acceleration
    }

    /// Lateral force of an axle on the body: B_a.
    fn on_body(&self, corner: Corner, axle: &RollingAxle<T>) -> T {
        self.axle(corner).force - self.of_wheels(corner, axle)
    }
}

impl<T: Real> DoubleTrackCar<T> {
    /// Equations (1) and (2).
    fn plane_motion(&self) -> PlaneMotion<T> {
        let axle = |left: Corner, right: Corner| {
            let [left_wrench, right_wrench] = [left, right].map(|corner| self.wrench(corner));
            let force = left_wrench.force_y + right_wrench.force_y;
            AxleForce { x: self.ahead(left), force, torque: left_wrench.moment_z + right_wrench.moment_z }
        };
        let axles = [axle(Corner::FrontLeft, Corner::FrontRight), axle(Corner::RearLeft, Corner::RearRight)];
        let moment = axles.iter().fold(T::zero(), |sum, axle| sum + (axle.x * axle.force + axle.torque));
        let force = axles[0].force + axles[1].force;
        PlaneMotion { acceleration: force / self.mass(), yaw_acceleration: moment / self.yaw_inertia, axles }
    }

    /// Right-hand sides of (5), (6) and (7).
    fn load_of_body(&self, motion: &PlaneMotion<T>) -> Load<T> {
        let Body { body_mass, wheelbase, cg_to_front, roll, .. } = self.body;
        let mut load = self.strut_load();
        for corner in [Corner::FrontLeft, Corner::RearLeft] {
            let axle = self.rolling_axle(corner);
            let lever = self.cg_height - axle.roll_centre_height;
            load.roll_moment = load.roll_moment + motion.on_body(corner, axle) * lever;
        }
        let [front, rear] = [self.front.roll_centre_height, self.rear.roll_centre_height];
        let roll_axis = front + (rear - front) * cg_to_front / wheelbase;
        load.roll_moment = load.roll_moment + body_mass * T::from(GRAVITY) * (self.cg_height - roll_axis) * roll;
        load
    }

    /// Force on a wheel from the links that hold it: the last term of (8).
    fn link_force(&self, corner: Corner, motion: &PlaneMotion<T>) -> T {
        let axle = self.rolling_axle(corner);
        let tilting = motion.on_body(corner, axle) * axle.roll_centre_height
            + motion.of_wheels(corner, axle) * self.wheel_centre_height;
        let force = tilting / axle.axle.track;
        if corner.is_left() { force } else { -force }
    }

    /// Right-hand side of (3).
    fn side_slip_rate(&self, corner: Corner) -> T {
        let path = ((self.lateral_velocity + self.ahead(corner) * self.yaw_rate) / self.speed).atan();
        let steered = if corner.is_front() { path - self.steering_angle } else { path };
        self.speed / self.relaxation_length * (steered - self.corner(corner).side_slip)
    }
}

impl Model for DoubleTrackCar {
    const MODEL_EXCHANGE: bool = true;

    fn check(&self) -> Result<(), Fault> {
        if self.tyre.pky2 == 0.0 {
            return Err(Fault::new("tyre.pky2 = 0: must not be 0"));
        }
        self.body.check()
    }

    fn step(&mut self, dt: f64) {
        integrate::held::<_, 23>(self, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        integrate::advance::<_, 23>(self, slope, dt);
    }

    fn branches(&self) -> u32 {
        self.wheels_on_ground()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::host::FourPostCar;
    use crate::laws::runge_kutta::dormand_prince;
    use crate::model::{row_of, row_of_mut};

    const STEP: f64 = 1e-3;

    fn wheels(car: &mut DoubleTrackCar) -> [&mut RollingWheel; 4] {
        [&mut car.fl, &mut car.fr, &mut car.rl, &mut car.rr]
    }

    /// Linear springs and dampers of two slopes, as in the reference run: 45 and 35 kN/m, 1500 and 2300 N.s/m.
    fn load_struts(car: &mut DoubleTrackCar) {
        let seats = [&car.front, &car.front, &car.rear, &car.rear].map(|axle| axle.axle.suspension);
        let stiffness = [45e3, 45e3, 35e3, 35e3];
        for ((wheel, seat), stiffness) in wheels(car).into_iter().zip(seats).zip(stiffness) {
            let RollingWheel { wheel, .. } = wheel;
            let damping = if wheel.velocity < 0.0 { 1500.0 } else { 2300.0 };
            let spring = seat.static_force - stiffness * (wheel.length - seat.static_length);
            wheel.strut_force = spring - damping * wheel.velocity;
        }
    }

    /// Drives in steps of 1 ms, struts first, and inspects each.
    fn drive(
        car: &mut DoubleTrackCar,
        duration: f64,
        steering: impl Fn(f64) -> f64,
        mut seen: impl FnMut(&DoubleTrackCar),
    ) {
        for step in 0..(duration / STEP).round() as u32 {
            car.steering_angle = steering(f64::from(step) * STEP);
            car.output();
            load_struts(car);
            car.step(STEP);
            car.output();
            seen(car);
        }
    }

    /// The textbook bicycle model: mass and distances of the car, cornering stiffness and trail of each axle.
    struct Bicycle {
        mass: f64,
        places: [f64; 2],
        stiffness: [f64; 2],
        trails: [f64; 2],
    }

    impl Bicycle {
        /// Numbers of ZR26: 288.64 kg, 48 % in front; the stiffness is that of the formula at each load.
        fn of(car: &DoubleTrackCar) -> Bicycle {
            let mass = 223.2 + 4.0 * 16.36;
            let behind: f64 = 1.528 - 0.8035;
            let ahead = (223.2 * 0.8035 + 2.0 * 16.36 * 1.528) / mass;
            let loads = [behind, 0.8035].map(|lever| 9.81 * (223.2 * lever / (2.0 * 1.528) + 16.36));
            Bicycle {
                mass,
                places: [ahead, ahead - 1.528],
                stiffness: loads.map(|load| 2.0 * 75.5 * 700.0 * (2.0 * (load / (4.65f64 * 700.0)).atan()).sin()),
                trails: loads.map(|load| load / 700.0 * car.tyre.qdz1 * 0.2),
            }
        }

        /// Rates of lateral velocity, yaw rate and the side slips of both axles, small, at the speed 20 m/s.
        fn rates(&self, steering: f64, [velocity, yaw_rate, front, rear]: [f64; 4]) -> [f64; 4] {
            let forces = [-self.stiffness[0] * front, -self.stiffness[1] * rear];
            let arm = |i: usize| self.places[i] - self.trails[i];
            let path = |i: usize| (velocity + self.places[i] * yaw_rate) / 20.0;
            [
                (forces[0] + forces[1]) / self.mass - 20.0 * yaw_rate,
                (arm(0) * forces[0] + arm(1) * forces[1]) / 142.92,
                20.0 / 0.2 * (path(0) - steering - front),
                20.0 / 0.2 * (path(1) - rear),
            ]
        }
    }

    /// Also with tyres whose shifts push both sides against each other.
    #[test]
    fn a_straight_road_is_followed_exactly() {
        let mut car = DoubleTrackCar::default();
        (car.tyre.lhy, car.tyre.lvy, car.tyre.qdz6, car.tyre.qbz9) = (1.0, 1.0, 0.01, 3.0);
        for wheel in wheels(&mut car) {
            wheel.road_height = 0.01;
        }
        drive(&mut car, 1.0, |_| 0.0, |_| ());
        let lateral = [car.position_y, car.yaw_angle, car.lateral_velocity, car.yaw_rate, car.body.roll];
        assert_eq!(lateral, [0.0; 5]);
        assert!((car.position_x - 20.0).abs() < 1e-12);
        assert!(car.body.heave > 9e-3 && car.fl.lateral_force == -car.fr.lateral_force);
        assert!(car.fl.lateral_force.abs() > 10.0);
    }

    /// Small steering: yaw rate = V delta / (L + K V^2), K = m (b C_r - a C_f) / (L C_f C_r).
    #[test]
    fn small_steering_turns_as_the_understeer_gradient_says() {
        let mut car = DoubleTrackCar::default();
        let Bicycle { mass, places: [a, b], stiffness: [c_f, c_r], .. } = Bicycle::of(&car);
        let wheelbase = a - b;
        let gradient = mass * (-b * c_r - a * c_f) / (wheelbase * c_f * c_r);
        drive(&mut car, 3.0, |_| 1e-5, |_| ());
        let expected = 20.0 * 1e-5 / (wheelbase + gradient * 400.0);
        assert!((car.yaw_rate / expected - 1.0).abs() < 1e-6, "{} against {expected}", car.yaw_rate);
        assert!((car.lateral_acceleration / (20.0 * expected) - 1.0).abs() < 1e-6);
    }

    /// The whole transient of lateral velocity, yaw rate and side slip, small, against the linear bicycle; also with
    /// tyres that have a trail.
    #[test]
    fn small_motions_are_those_of_the_bicycle() {
        for trail in [0.0, 0.1] {
            let mut car = DoubleTrackCar::default();
            (car.tyre.qdz1, car.tyre.qcz1, car.tyre.qbz1) = (trail, 1.1, 9.0);
            (car.lateral_velocity, car.steering_angle) = (1e-5, 1e-6);
            let bicycle = Bicycle::of(&car);
            let mut linear = [1e-5, 0.0, 0.0, 0.0];
            for _ in 0..40 {
                car.step(0.01);
                for _ in 0..10 {
                    linear = dormand_prince(|_, at| bicycle.rates(1e-6, at), linear, 1e-3).0;
                }
                let states = [car.lateral_velocity, car.yaw_rate, car.fl.side_slip, car.rr.side_slip];
                for (state, linear) in states.iter().zip(linear) {
                    assert!((state - linear).abs() < 1e-11, "trail {trail}: {states:?} against {linear:?}");
                }
            }
            assert!(linear[1].abs() > 1e-6, "it has turned: {linear:?}");
        }
    }

    #[test]
    fn steering_to_the_other_side_mirrors_the_run() {
        let mut left = DoubleTrackCar::default();
        (left.tyre.lhy, left.tyre.lvy) = (1.0, 1.0);
        let mut right = left;
        let mut path = Vec::new();
        drive(&mut left, 0.5, |t| 0.1 * (12.0 * t).sin(), |car| path.push(*car));
        let mut path = path.iter();
        drive(
            &mut right,
            0.5,
            |t| -0.1 * (12.0 * t).sin(),
            |right| {
                let left = path.next().unwrap();
                let odd = |car: &DoubleTrackCar| {
                    [
                        car.position_y,
                        car.yaw_angle,
                        car.lateral_velocity,
                        car.yaw_rate,
                        car.body.roll,
                        car.body.roll_rate,
                    ]
                };
                odd(left).iter().zip(odd(right)).for_each(|(left, right)| assert!((left + right).abs() < 1e-9));
                let even = |car: &DoubleTrackCar| [car.position_x, car.body.heave, car.body.pitch];
                even(left).iter().zip(even(right)).for_each(|(left, right)| assert!((left - right).abs() < 1e-9));
                assert!((left.fl.wheel.tyre_load - right.fr.wheel.tyre_load).abs() < 1e-5);
                assert!((left.rl.lateral_force + right.rr.lateral_force).abs() < 1e-5);
            },
        );
        assert!(left.position_y.abs() > 0.1);
    }

    /// In a steady turn the tyres carry the weight, and their loads balance the moment of inertia and weight about the
    /// ground, whatever the suspension does. Left turn: right tyres are loaded, the right side goes down.
    #[test]
    fn loads_of_a_steady_turn_balance() {
        let mut car = DoubleTrackCar::default();
        drive(&mut car, 4.0, |t| 0.03 * t.min(1.0), |_| ());
        let loads = [car.fl, car.fr, car.rl, car.rr].map(|wheel| wheel.wheel.tyre_load);
        assert!((loads.iter().sum::<f64>() - 9.81 * 288.64).abs() < 1e-6, "{loads:?}");
        let moment = 0.61 * (loads[0] - loads[1]) + 0.60 * (loads[2] - loads[3]);
        let heights = 223.2 * 0.3203 + 4.0 * 16.36 * 0.2;
        let roll_axis = 0.035 + (0.05 - 0.035) * 0.8035 / 1.528;
        let expected = -car.lateral_acceleration * heights - 223.2 * 9.81 * (0.3203 - roll_axis) * car.body.roll;
        assert!((moment - expected).abs() < 1e-6, "{moment} against {expected}");
        assert!(car.lateral_acceleration > 7.0 && car.body.roll > 0.01, "{car:?}");
        // The centre of gravity runs on a circle.
        assert!((car.lateral_acceleration - 20.0 * car.yaw_rate).abs() < 1e-9);
    }

    /// The body rolls by the moment over the stiffness of the springs; the wheels follow their tyres.
    #[test]
    fn steady_roll_angle_is_moment_over_stiffness() {
        let mut car = DoubleTrackCar::default();
        // Without roll centres and without weight above the roll axis there is one moment and two springs in series.
        (car.front.roll_centre_height, car.rear.roll_centre_height, car.wheel_centre_height) = (0.0, 0.0, 0.0);
        drive(&mut car, 4.0, |t| 0.02 * t.min(1.0), |_| ());
        let spring = [(45e3 * 1.011 * 1.011, 0.61), (35e3 * 1.004 * 1.004, 0.60)];
        let stiffness: f64 = spring.iter().map(|(rate, half_track)| 2.0 * half_track * half_track * rate).sum();
        let loads = [car.fl, car.fr, car.rl, car.rr].map(|wheel| wheel.wheel.wheel_height);
        // Deflection of the springs: the roll of the body less that of each axle.
        let resisted: f64 = [0, 1]
            .map(|axle| {
                let (rate, half_track) = spring[axle];
                let axle_roll = (loads[2 * axle] - loads[2 * axle + 1]) / (2.0 * half_track);
                2.0 * half_track * half_track * rate * (car.body.roll - axle_roll)
            })
            .iter()
            .sum();
        let moment = 223.2 * 0.3203 * (car.lateral_acceleration + 9.81 * car.body.roll);
        assert!((resisted / moment - 1.0).abs() < 1e-6, "{resisted} against {moment}");
        assert!(car.body.roll > moment / stiffness);
    }

    /// Posts under the wheels and no lateral motion: with the roll axis at the centre of gravity, the car on four
    /// posts.
    #[test]
    fn without_lateral_motion_it_is_the_car_on_four_posts() {
        let mut car = DoubleTrackCar { cg_height: 0.04, ..Default::default() };
        (car.front.roll_centre_height, car.rear.roll_centre_height) = (0.04, 0.04);
        let mut posts = FourPostCar::default();
        let mut lifted = false;
        for step in 0..300 {
            let time = f64::from(step) * STEP;
            let heights = [0.0, 1.0, 2.0, 3.0].map(|phase: f64| 0.04 * (30.0 * time + phase).sin());
            car.output();
            load_struts(&mut car);
            let pairs = wheels(&mut car).into_iter().zip([&mut posts.fl, &mut posts.fr, &mut posts.rl, &mut posts.rr]);
            for ((wheel, post), height) in pairs.zip(heights) {
                (wheel.road_height, post.post_height) = (height, height);
                post.wheel.strut_force = wheel.wheel.strut_force;
                lifted |= wheel.wheel.tyre_load == 0.0;
            }
            car.step(STEP);
            posts.step(STEP);
            for (car, posts) in row_of(&car.body).iter().zip(row_of(&posts.body)) {
                assert!((car - posts).abs() < 1e-9, "after {time} s");
            }
            assert!((car.rr.wheel.wheel_height - posts.rr.wheel.wheel_height).abs() < 1e-9);
        }
        assert!(lifted, "the road was rough enough");
        assert_eq!([car.lateral_velocity, car.yaw_rate], [0.0; 2]);
    }

    #[test]
    fn two_half_steps_are_one_step_also_on_ramps() {
        for dt in [1e-12, 1e-4, 0.02, 0.5] {
            let mut whole = DoubleTrackCar { steering_angle: 0.05, yaw_rate: 0.2, ..Default::default() };
            whole.fl.road_height = -0.03;
            let mut slope = whole;
            row_of_mut(&mut slope).fill(0.0);
            (slope.steering_angle, slope.rr.road_height, slope.fl.wheel.strut_force) = (-0.1, 0.02, 200.0);
            let mut halves = whole;
            whole.step_ramp(&slope, dt);
            halves.step_ramp(&slope, 0.5 * dt);
            halves.step_ramp(&slope, 0.5 * dt);
            for (a, b) in row_of(&whole).iter().zip(row_of(&halves)) {
                assert!((a - b).abs() < 1e-9 * a.abs().max(1.0), "{dt}: {a} against {b}");
            }
        }
    }

    /// Inertia only: the car slides on in its old direction.
    #[test]
    fn without_grip_steering_does_nothing() {
        let mut car = DoubleTrackCar { lateral_velocity: 0.5, steering_angle: 0.1, ..Default::default() };
        (car.tyre.pdy1, car.tyre.pdy2) = (0.0, 0.0);
        car.step(1.0);
        assert_eq!([car.lateral_velocity, car.yaw_angle, car.body.roll], [0.5, 0.0, 0.0]);
        assert!((car.position_y - 0.5).abs() < 1e-12);
    }

    /// Two periods of sine steering, 3.6 degrees at 0.9 Hz, with 0.35 s between them, at 72 km/h, on struts without
    /// friction. Another simulation of the same car, with a simpler tyre and without the links that tilt the axles, has
    /// 1.13 g and a roll of 0.953 degrees. The tilt of the axles (see C_a) adds what this test computes at rest.
    #[test]
    fn lane_change_of_the_reference() {
        let period = 1.0 / 0.9;
        let steering = |time: f64| {
            let second = time - period - 0.35;
            let phase = if time < period { time } else { second.clamp(0.0, period) };
            3.6f64.to_radians() * (std::f64::consts::TAU * phase / period).sin()
        };
        let mut car = DoubleTrackCar::default();
        let (mut roll, mut acceleration): (f64, f64) = (0.0, 0.0);
        drive(&mut car, 5.0, steering, |car| {
            roll = roll.max(car.body.roll.abs().to_degrees());
            acceleration = acceleration.max(car.lateral_acceleration.abs() / 9.81);
        });
        assert!((acceleration / 1.13 - 1.0).abs() < 0.03, "{acceleration} g");
        let tilt = |body_mass: f64, roll_centre: f64, track: f64| {
            let moment = (body_mass * roll_centre + 2.0 * 16.36 * 0.2) * acceleration * 9.81;
            moment / (0.5 * 87563.5 * track * track)
        };
        let spring = |rate: f64, ratio: f64, track: f64| rate * (ratio * track).powi(2);
        let (front, rear) = (spring(45e3, 1.011, 1.22), spring(35e3, 1.004, 1.20));
        let tilt = (front * tilt(105.83, 0.035, 1.22) + rear * tilt(117.37, 0.05, 1.20)) / (front + rear);
        let without_tilt = roll - tilt.to_degrees();
        assert!((without_tilt / 0.953 - 1.0).abs() < 0.02, "{roll} deg, {without_tilt} deg without tilt");
        assert!(car.body.roll.abs().to_degrees() < 1e-4, "no friction holds the body: {}", car.body.roll);
    }

    #[test]
    fn parameters_that_do_not_fit_are_refused() {
        let mut car = DoubleTrackCar::default();
        car.check().unwrap();
        car.body.cg_to_front = 2.0;
        assert_eq!(car.check().unwrap_err().0, "cg_to_front = 2: must be <= wheelbase = 1.528");
        car.tyre.pky2 = 0.0;
        assert_eq!(car.check().unwrap_err().0, "tyre.pky2 = 0: must not be 0");
    }
}
