use crate::host::integrate;
use crate::host::magic_formula::{Contact, MagicFormula, Side, Wrench};
use crate::host::vertical::{Axle, Body, Corner, GRAVITY, Load, Motion, Place, Wheel};
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
    /// A car on two tracks at constant speed: it is steered, slips sideways, yaws, rolls and pitches. Its tyres follow the
    /// Magic Formula; its four struts are other models. It adds the plane of the road to the car on four posts.
    ///
    /// # Equations
    ///
    /// Plane of the road; a wheel is at X_k ahead of the car's centre of gravity, delta_k is 0 at the rear:
    ///
    /// ```text
    /// m (dv_y/dt + V r) = sum F_k                                                        (1)
    /// I_z dr/dt         = sum (X_k F_k + M_k)                                            (2)
    /// dalpha_k/dt       = V / sigma_r (atan((v_y + X_k r) / V) - delta_k - alpha_k)      (3)
    /// F_k, M_k          = magic_formula(N_k, alpha_k)                                    (4)
    /// dx/dt             = V cos psi - v_y sin psi
    /// dy/dt             = V sin psi + v_y cos psi
    /// dpsi/dt           = r
    /// a_y               = dv_y/dt + V r
    /// ```
    ///
    /// Body and wheels, with the place (x_k, y_k) of a wheel seen from the body's centre of gravity, the lift
    /// L_k = MR (S_k - S_k0) of a strut and the height z_k = z - x_k theta + y_k phi of the body over a wheel:
    ///
    /// ```text
    /// m_b d2z/dt2     = sum L_k                                                          (5)
    /// I_y d2theta/dt2 = -sum x_k L_k                                                     (6)
    /// I_x d2phi/dt2   = sum y_k L_k + sum B_a (h_b - h_a) + m_b g (h_b - h_r) phi        (7)
    /// m_w d2z_wk/dt2  = N_k - N_k0 - L_k +- C_a / T                                      (8)
    /// N_k             = max(0, N_k0 + k_t (z_rk - z_wk) + c_t (dz_rk/dt - dz_wk/dt))
    /// B_a             = F_a - 2 m_w (a_y + X_a dr/dt)
    /// C_a             = B_a h_a + 2 m_w (a_y + X_a dr/dt) h_w
    /// length_k        = l_0 + MR (z_k - z_wk)
    /// ```
    ///
    /// F_a is the lateral force of both tyres of an axle, B_a what the body takes of it at the height h_a of the roll
    /// centre, h_r the height of the line through both roll centres below the body's centre of gravity. C_a tilts the
    /// axle: + for its left wheel, - for its right wheel.
    ///
    /// | symbol       | variable                       | unit    | meaning                                            |
    /// |--------------|--------------------------------|---------|----------------------------------------------------|
    /// | delta        | `steering_angle`               | rad     | steering angle of both front wheels                |
    /// | S_k          | `fl.strut_force`               | N       | force of a strut (also `fr`, `rl`, `rr`, as below) |
    /// | z_r          | `fl.road_height`               | m       | height of the road under a wheel                   |
    /// | dz_r/dt      | `fl.road_velocity`             | m/s     | its rate                                           |
    /// | V            | `speed`                        | m/s     | forward speed                                      |
    /// | I_z          | `yaw_inertia`                  | kg.m2   | moment of inertia of the car about z               |
    /// | h_b          | `cg_height`                    | m       | height of the body's centre of gravity             |
    /// | h_w          | `wheel_centre_height`          | m       | height of the wheels' centres of gravity           |
    /// | sigma_r      | `relaxation_length`            | m       | relaxation length of the tyres                     |
    /// |              | `tyre.side`                    |         | side that the tyre set was measured for            |
    /// | F_z0         | `tyre.fnomin`                  | N       | nominal load; `tyre.*` has all coefficients        |
    /// | m_b          | `body_mass`                    | kg      | mass of the body; m has the wheels too             |
    /// | I_y, I_x     | `pitch_inertia`, `roll_inertia` | kg.m2  | moments of inertia of the body                     |
    /// |              | `wheelbase`, `cg_to_front`     | m       | axles, seen from the body's centre of gravity      |
    /// | T            | `front.track`                  | m       | track of an axle (also `rear`, as below)           |
    /// | h_a          | `front.roll_centre_height`     | m       | height of the roll centre of an axle               |
    /// | MR           | `front.motion_ratio`           | 1       | damper travel per wheel travel                     |
    /// | l_0          | `front.static_length`          | m       | length of a strut at rest                          |
    /// | S_0          | `front.static_force`           | N       | force of a strut at rest                           |
    /// | m_w          | `front.wheel_mass`             | kg      | mass of a wheel and of what moves with it          |
    /// | k_t, c_t     | `front.tyre_stiffness`, `front.tyre_damping` | N/m, N.s/m | the tyre, vertically              |
    /// | z, dz/dt     | `heave`, `heave_rate`          | m, m/s  | height of the body, its rate                       |
    /// | theta, phi   | `pitch`, `roll`                | rad     | angles of the body                                 |
    /// |              | `pitch_rate`, `roll_rate`      | rad/s   | their rates                                        |
    /// | x, y         | `position_x`, `position_y`     | m       | place of the car's centre of gravity on the road   |
    /// | psi          | `yaw_angle`                    | rad     | heading                                            |
    /// | v_y          | `lateral_velocity`             | m/s     | lateral velocity of the car's centre of gravity    |
    /// | r            | `yaw_rate`                     | rad/s   | yaw rate                                           |
    /// | a_y          | `lateral_acceleration`         | m/s2    | lateral acceleration of the car's centre of gravity |
    /// | z_w, dz_w/dt | `fl.wheel_height`, `fl.wheel_velocity` | m, m/s | height of a wheel, its rate                  |
    /// | length       | `fl.length`                    | m       | length of a strut, eye to eye                      |
    /// | dlength/dt   | `fl.velocity`                  | m/s     | its rate                                           |
    /// | N            | `fl.tyre_load`                 | N       | load of a tyre                                     |
    /// | alpha        | `fl.side_slip`                 | rad     | side slip of a tyre                                |
    /// | F            | `fl.lateral_force`             | N       | lateral force of a tyre                            |
    ///
    /// # Sign
    /// Axes of ISO 8855: x forward, y left, z up; angles turn about them by the right-hand rule, so steering, yaw and yaw
    /// rate are positive to the left, roll is positive when the right side goes down, pitch when the nose goes down.
    /// `side_slip` is positive when the wheel slips to the left; then the tyre is pushed to the right, `lateral_force` < 0.
    /// `strut_force` is positive when it pushes the eyes of the strut apart, `velocity` when the strut extends. Heights and
    /// angles of the body are deviations from rest on a level road.
    ///
    /// # Step
    /// The inputs are held over a step, or move linearly. Each step is divided by error control (Dormand and Prince, 5th
    /// order) until the error is below 1e-10 of the state or of its nominal value, also where a tyre lifts off or lands, so
    /// the result does not depend on the step beyond what the held strut forces mean. A step of many seconds costs its
    /// share of time; one that would need more than a million pieces is refused. Strut lengths and velocities follow from
    /// states alone, so a strut closes no algebraic loop.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound; `cg_to_front` > `wheelbase`; `tyre.pky2` = 0; a step whose result is not
    /// finite.
    ///
    /// # Limits
    /// The speed is constant: no drive, no brakes, no longitudinal forces. Small angles: the lateral forces count along the
    /// y axis of the body, both front wheels are steered alike, wheels stay upright (no camber), and all wheels of an axle
    /// see the path of its middle. The overturning couple of the tyres is left out. The roll centres stay where they are,
    /// and nothing lifts the body when the tyres of an axle share the lateral force unequally. No anti-roll bars: add their
    /// force to `strut_force`. The relaxation length does not change with load.
    ///
    /// # Source
    /// Equations (1), (2) and (3): H. B. Pacejka, "Tyre and Vehicle Dynamics", 2nd ed., Butterworth-Heinemann (2006),
    /// sections 1.3 and 7.1 (linear relaxation, here with the steady force at the side slip that has followed); (4) as in
    /// section 4.3 there, Magic Formula 5.2. (5) to (8): Newton and Euler; the roll axis is that of
    /// the same book, section 1.3.
    ///
    /// Start values: ZR26 of Zips Racing (open data, MIT licence: 288.64 kg with driver, 48 per cent at the front, centre of
    /// gravity at 0.293 m, roll centres at 35 and 50 mm). `cg_height` follows from them: 0.293 m for the car, less four
    /// wheels of 16.36 kg at 0.2 m. `rear.static_force` belongs to a spring of 35 kN/m. Tyres: see `tyre`, an open set that is
    /// scaled to a nominal load of 700 N.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::DoubleTrackCar;
    /// use stribeck::model::{Law, Model};
    /// let mut car = DoubleTrackCar { steering_angle: 1e-4, ..Default::default() };
    /// car.step(1.0);
    /// car.output();
    /// EXAMPLE
    /// ```
    DoubleTrackCar: "Car on two tracks that is steered at constant speed, with tyres after the Magic Formula" {
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
        /// Height of the wheels' centres of gravity above the ground; chosen.
        wheel_centre_height: fixed = real("m", 0.2).at_least(0.0),
        /// Way that a tyre rolls until its side slip has followed by 63 per cent; chosen.
        relaxation_length: fixed = real("m", 0.2).positive(),
        /// The tyres: four alike.
        tyre: MagicFormula,
        /// Position along the road of the car's centre of gravity.
        position_x: state_output = real("m", 0.0),
        /// Position to the left of the car's centre of gravity.
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

impl<T: Real> RollingWheel<T> {
    fn ground(&self) -> Motion<T> {
        Motion { height: self.road_height, velocity: self.road_velocity }
    }
}

impl<T: Real> DoubleTrackCar<T> {
    fn rolling_axle(&self, corner: Corner) -> &RollingAxle<T> {
        if corner.is_front() { &self.front } else { &self.rear }
    }

    fn axle(&self, corner: Corner) -> &Axle<T> {
        &self.rolling_axle(corner).axle
    }

    fn corner(&self, corner: Corner) -> &RollingWheel<T> {
        [&self.fl, &self.fr, &self.rl, &self.rr][corner as usize]
    }

    /// Mass of the car.
    fn mass(&self) -> T {
        let two = T::from(2.0);
        self.body.body_mass + two * (self.front.axle.suspension.wheel_mass + self.rear.axle.suspension.wheel_mass)
    }

    /// Place of a wheel, seen from the centre of gravity of the car and not of its body.
    fn place(&self, corner: Corner) -> Place<T> {
        let place = |corner| self.body.place(corner, self.axle(corner));
        let moment = |corner| place(corner).x * self.axle(corner).suspension.wheel_mass;
        let ahead = Corner::ALL.into_iter().fold(T::zero(), |sum, corner| sum + moment(corner)) / self.mass();
        let Place { x, y } = place(corner);
        Place { x: x - ahead, y }
    }

    /// Forces and moments of the road on a tyre.
    fn wrench(&self, corner: Corner) -> Wrench<T> {
        let (axle, wheel) = (self.axle(corner), self.corner(corner));
        let static_load = self.body.static_load(corner, axle);
        let contact = Contact {
            load: wheel.wheel.load(&axle.suspension, wheel.ground(), static_load),
            longitudinal_slip: T::zero(),
            side_slip: wheel.side_slip,
            camber: T::zero(),
            speed: self.speed,
        };
        self.tyre.wrench_on(if corner.is_left() { Side::Left } else { Side::Right }, &contact)
    }
}

impl<T: Real> Law for DoubleTrackCar<T> {
    fn output(&mut self) {
        let forces = Corner::ALL.map(|corner| self.wrench(corner).force_y);
        self.lateral_acceleration = (forces[0] + forces[1] + forces[2] + forces[3]) / self.mass();
        let DoubleTrackCar { body, front, rear, fl, fr, rl, rr, .. } = self;
        let axles = [&front.axle, &front.axle, &rear.axle, &rear.axle];
        for (((corner, axle), wheel), force) in Corner::ALL.into_iter().zip(axles).zip([fl, fr, rl, rr]).zip(forces) {
            let motion = body.at(body.place(corner, axle));
            wheel.wheel.output(&axle.suspension, motion, wheel.ground(), body.static_load(corner, axle));
            wheel.lateral_force = force;
        }
    }
}

/// How the car moves in the plane of the road.
struct PlaneMotion {
    /// Acceleration of the car's centre of gravity.
    acceleration: f64,
    yaw_acceleration: f64,
    /// Of the front and of the rear axle.
    axles: [AxleForce; 2],
}

/// What the road does to an axle.
#[derive(Clone, Copy)]
struct AxleForce {
    /// Place of the axle ahead of the car's centre of gravity.
    x: f64,
    /// Lateral force of both tyres.
    force: f64,
    /// Aligning torque of both tyres.
    torque: f64,
}

impl PlaneMotion {
    fn axle(&self, corner: Corner) -> AxleForce {
        self.axles[usize::from(!corner.is_front())]
    }

    /// Force of inertia of both wheels of an axle, in the direction of the acceleration.
    fn of_wheels(&self, corner: Corner, axle: &RollingAxle) -> f64 {
        let acceleration = self.acceleration + self.axle(corner).x * self.yaw_acceleration;
        2.0 * axle.axle.suspension.wheel_mass * acceleration
    }

    /// What the body takes of the lateral force of an axle: B_a.
    fn on_body(&self, corner: Corner, axle: &RollingAxle) -> f64 {
        self.axle(corner).force - self.of_wheels(corner, axle)
    }
}

impl DoubleTrackCar {
    /// Equations (1) and (2).
    fn plane_motion(&self) -> PlaneMotion {
        let axle = |left: Corner, right: Corner| {
            let [left_wrench, right_wrench] = [left, right].map(|corner| self.wrench(corner));
            let force = left_wrench.force_y + right_wrench.force_y;
            AxleForce { x: self.place(left).x, force, torque: left_wrench.moment_z + right_wrench.moment_z }
        };
        let axles = [axle(Corner::FrontLeft, Corner::FrontRight), axle(Corner::RearLeft, Corner::RearRight)];
        let moment: f64 = axles.iter().map(|axle| axle.x * axle.force + axle.torque).sum();
        let force = axles[0].force + axles[1].force;
        PlaneMotion { acceleration: force / self.mass(), yaw_acceleration: moment / self.yaw_inertia, axles }
    }

    /// Right-hand sides of (5), (6) and (7).
    fn load_of_body(&self, motion: &PlaneMotion) -> Load<f64> {
        let Body { body_mass, wheelbase, cg_to_front, roll, .. } = self.body;
        let lift = |corner| {
            let axle = self.axle(corner);
            (self.body.place(corner, axle), self.corner(corner).wheel.lift(&axle.suspension))
        };
        let mut load = Load::of(Corner::ALL.map(lift));
        for corner in [Corner::FrontLeft, Corner::RearLeft] {
            let axle = self.rolling_axle(corner);
            load.roll_moment += motion.on_body(corner, axle) * (self.cg_height - axle.roll_centre_height);
        }
        let [front, rear] = [self.front.roll_centre_height, self.rear.roll_centre_height];
        let roll_axis = front + (rear - front) * cg_to_front / wheelbase;
        load.roll_moment += body_mass * GRAVITY * (self.cg_height - roll_axis) * roll;
        load
    }

    /// Force on a wheel from the links that hold it: the last term of (8).
    fn link_force(&self, corner: Corner, motion: &PlaneMotion) -> f64 {
        let axle = self.rolling_axle(corner);
        let tilting = motion.on_body(corner, axle) * axle.roll_centre_height
            + motion.of_wheels(corner, axle) * self.wheel_centre_height;
        let force = tilting / axle.axle.track;
        if corner.is_left() { force } else { -force }
    }

    /// Right-hand side of (3).
    fn side_slip_rate(&self, corner: Corner) -> f64 {
        let path = ((self.lateral_velocity + self.place(corner).x * self.yaw_rate) / self.speed).atan();
        let steered = if corner.is_front() { path - self.steering_angle } else { path };
        self.speed / self.relaxation_length * (steered - self.corner(corner).side_slip)
    }

    /// Right-hand side of (8), per mass.
    fn wheel_acceleration(&self, corner: Corner, motion: &PlaneMotion) -> f64 {
        let (axle, wheel) = (self.axle(corner), self.corner(corner));
        let static_load = self.body.static_load(corner, axle);
        wheel.wheel.acceleration(&axle.suspension, wheel.ground(), static_load)
            + self.link_force(corner, motion) / axle.suspension.wheel_mass
    }
}

impl Model for DoubleTrackCar {
    fn check(&self) -> Result<(), Fault> {
        if self.tyre.pky2 == 0.0 {
            return Err(Fault("tyre.pky2 = 0: must not be 0".into()));
        }
        Ok(())
    }

    fn step(&mut self, dt: f64) {
        integrate::held::<_, 23>(self, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        integrate::advance::<_, 23>(self, slope, dt);
    }

    fn rate(&self, rate: &mut Self) {
        let motion = self.plane_motion();
        let (sin, cos) = self.yaw_angle.sin_cos();
        rate.position_x = self.speed * cos - self.lateral_velocity * sin;
        rate.position_y = self.speed * sin + self.lateral_velocity * cos;
        rate.yaw_angle = self.yaw_rate;
        rate.lateral_velocity = motion.acceleration - self.speed * self.yaw_rate;
        rate.yaw_rate = motion.yaw_acceleration;
        self.body.rate(self.load_of_body(&motion), &mut rate.body);
        let wheels = [&mut rate.fl, &mut rate.fr, &mut rate.rl, &mut rate.rr];
        for (corner, rate) in Corner::ALL.into_iter().zip(wheels) {
            rate.side_slip = self.side_slip_rate(corner);
            rate.wheel.wheel_height = self.corner(corner).wheel.wheel_velocity;
            rate.wheel.wheel_velocity = self.wheel_acceleration(corner, &motion);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn explore() {
        use std::f64::consts::TAU;
        for (second, degressive) in [(1.0, false), (-1.0, false), (1.0, true), (-1.0, true)] {
            let mut car = DoubleTrackCar::default();
            let (mut most_roll, mut most_a): (f64, f64) = (0.0, 0.0);
            let h = 1e-3;
            for i in 0..5000 {
                let t = f64::from(i) * h;
                let p = 1.0 / 0.9;
                let t1 = t - 0.5;
                let s = if t1 < 0.0 {
                    0.0
                } else if t1 < p {
                    (TAU * t1 / p).sin()
                } else if t1 < p + 0.35 {
                    0.0
                } else if t1 < 2.0 * p + 0.35 {
                    second * (TAU * (t1 - p - 0.35) / p).sin()
                } else {
                    0.0
                };
                car.steering_angle = 3.6f64.to_radians() * s;
                car.output();
                most_roll = most_roll.max(car.body.roll.abs());
                most_a = most_a.max(car.lateral_acceleration.abs());
                let DoubleTrackCar { fl, fr, rl, rr, .. } = &mut car;
                for (w, k, f0) in
                    [(fl, 45e3, 1325.2555), (fr, 45e3, 1325.2555), (rl, 35e3, 1100.2555), (rr, 35e3, 1100.2555)]
                {
                    let v = w.wheel.velocity;
                    let damper = if degressive {
                        let x = [-1.0, -0.5, -0.25, -0.1, -0.05, 0.0, 0.05, 0.1, 0.25, 0.5, 1.0];
                        let y = [-1150.0, -700.0, -430.0, -210.0, -110.0, 0.0, 180.0, 340.0, 640.0, 950.0, 1500.0];
                        let j = x.iter().rposition(|x| *x <= v).unwrap().min(9);
                        y[j] + (y[j + 1] - y[j]) * (v - x[j]) / (x[j + 1] - x[j])
                    } else if v < 0.0 {
                        1500.0 * v
                    } else {
                        2300.0 * v
                    };
                    w.wheel.strut_force = f0 - k * (w.wheel.length - 0.1775) - damper;
                }
                car.step(h);
            }
            println!(
                "{second} {degressive}: roll {} a {} g, left {} y {} psi {}",
                most_roll.to_degrees(),
                most_a / 9.81,
                car.body.roll.to_degrees(),
                car.position_y,
                car.yaw_angle
            );
        }
    }
}
