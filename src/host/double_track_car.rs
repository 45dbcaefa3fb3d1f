use crate::host::magic_formula::{Contact, MagicFormula, Side, Wrench};
use crate::host::tyre_radii::Radii;
use crate::host::vertical::{Axle, Body, Car, Corner, GRAVITY, Load, Motion, Wheel};
use crate::model::{Derivatives, Fault, Law, Meaning, Model, ModelExchange, integrate, real};
use crate::number::Scalar;

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
        road_height: input = real("m", 0.0).shown_in("mm").means(Meaning::GroundHeight),
        /// Rate of the road's height.
        road_velocity: input = real("m/s", 0.0).means(Meaning::GroundVelocity),
        /// The wheel and the strut.
        wheel: (Wheel),
        /// Side slip of the tyre; positive when the wheel slips to the left.
        side_slip: state_output = real("rad", 0.0).nominal(1e-2).shown_in("deg"),
        /// Lateral force of the road on the tyre; positive to the left.
        lateral_force: output = real("N", 0.0).nominal(100.0),
        /// Vertical deflection of the tyre.
        tyre_deflection: output = real("m", 0.0).nominal(1e-2).shown_in("mm"),
        /// Radius of the tyre under its load; 0 if the formula carries no such load.
        loaded_radius: output = real("m", 0.2).nominal(0.1).shown_in("mm"),
        /// Effective rolling radius of the tyre; 0 if the formula carries no such load.
        effective_radius: output = real("m", 0.2).nominal(0.1).shown_in("mm"),
    }
}

crate::model! {
    /// A car with two tracks at constant speed: it is steered, slips sideways, yaws, rolls and pitches. Its tyres
    /// follow the Magic Formula; its four struts are other models. It adds the motion in the plane of the road to the
    /// car on four posts.
    /// # Equations
    ///
    /// In the plane of the road. A wheel k is $X_k$ ahead of the car's centre of gravity; $delta_k$ is 0 at the rear:
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
    /// $F_k$ and $M_k$ are lateral force and aligning torque of a tyre: the Magic Formula 5.2, or 6.1 and 6.2 with the
    /// inflation pressure, for the load $f_tk$, the side slip $alpha_k$ and no camber. In version 5.2 without shifts the
    /// force is
    ///
    /// ```text
    /// F_k = D sin(C atan(B alpha_k - E (B alpha_k - atan(B alpha_k))))                  (4)
    /// D   = (p_1 + p_2 (f_tk - f_n) / f_n) f_tk
    /// ```
    ///
    /// The radii of the tyres under their loads follow from the same formula, in version 6.1 without bottoming
    ///
    /// ```text
    /// f_tk = f_z0 (1 + p_z dp) g (q rho / R_0 + q_fz2 (rho / R_0)^2)                  (9)
    /// q    = sqrt((k_t R_0 / f_z0)^2 - 4 q_fz2)
    /// g    = 1 + q_v2 |Omega| R_0 / V_0 - (q_fcy F_k / f_z0)^2
    /// R_f  = R_0 (q_re0 + q_v1 (Omega R_0 / V_0)^2)
    /// R_l  = R_f - rho
    /// R_e  = R_f - f_z0 / (k_t (1 + p_z dp)) (D_e atan(B_e f_tk / f_z0) + F_e f_tk / f_z0)
    /// ```
    ///
    /// with $Omega = V / R_e$, the nominal load $f_z0$, the relative deviation $dp$ of the pressure from the nominal one,
    /// and $p_z$, $B_e$, $D_e$, $F_e$ for `tyre.pfz1`, `tyre.breff`, `tyre.dreff`, `tyre.freff`. Nothing else depends on
    /// them: in the motion of the car the tyres are linear springs.
    ///
    /// Body and wheels. A wheel is at the place $(x_k, y_k)$ seen from the body's centre of gravity:
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
    /// $F_a$ is the lateral force of both tyres of an axle a; $W_a$ is the part that accelerates its wheels and $B_a$
    /// the part that acts on the body, at the height $h_a$ of the roll centre. $C_a$ tilts the axle: $s_k$ is 1 for its
    /// left wheel and -1 for its right wheel. $h_r$ is the height, at the body's centre of gravity, of the line through
    /// both roll centres.
    ///
    /// | symbol    | variable                   | unit  | meaning                                             |
    /// |-----------|----------------------------|-------|-----------------------------------------------------|
    /// | delta     | `steering_angle`           | rad   | steering angle of both front wheels                 |
    /// | V         | `speed`                    | m/s   | forward speed                                       |
    /// | I_zz      | `yaw_inertia`              | kg.m2 | moment of inertia of the car about $z$              |
    /// | h_s       | `cg_height`                | m     | height of the body's centre of gravity              |
    /// | h_u       | `wheel_centre_height`      | m     | height of the wheels' centres of gravity            |
    /// | sigma     | `relaxation_length`        | m     | relaxation length of the tyres                      |
    /// | p_1       | `tyre.pdy1`                | 1     | friction; all of `tyre` has the names of tyre files |
    /// | p_2       | `tyre.pdy2`                | 1     | its change with load                                |
    /// | f_n       | `tyre.fnomin`              | N     | nominal load, here times `tyre.lfzo`                |
    /// |           | `tyre.side`                |       | side that the tyre set was measured for             |
    /// |           | `tyre.version`             |       | version of the formula                              |
    /// |           | `tyre.inflpres`            | Pa    | inflation pressure, from version 6 on               |
    /// | m_s       | `body_mass`                | kg    | mass of the body; $m$ is that of the car            |
    /// | I_yy      | `pitch_inertia`            | kg.m2 | moment of inertia of the body about $y$             |
    /// | I_xx      | `roll_inertia`             | kg.m2 | moment of inertia of the body about $x$             |
    /// | x_1 - x_3 | `wheelbase`                | m     | distance between the axles                          |
    /// | x_1       | `cg_to_front`              | m     | centre of gravity of the body to front axle         |
    /// | z         | `heave`                    | m     | height of the body's centre of gravity above rest   |
    /// | dz/dt     | `heave_rate`               | m/s   | its rate                                            |
    /// | theta     | `pitch`                    | rad   | pitch angle                                         |
    /// | dtheta/dt | `pitch_rate`               | rad/s | its rate                                            |
    /// | phi       | `roll`                     | rad   | roll angle                                          |
    /// | dphi/dt   | `roll_rate`                | rad/s | its rate                                            |
    /// | x         | `position_x`               | m     | position of the car's centre of gravity             |
    /// | y         | `position_y`               | m     | position to the left                                |
    /// | psi       | `yaw_angle`                | rad   | yaw angle                                           |
    /// | v_y       | `lateral_velocity`         | m/s   | lateral velocity of the car's centre of gravity     |
    /// | r         | `yaw_rate`                 | rad/s | yaw rate                                            |
    /// | a_y       | `lateral_acceleration`     | m/s2  | lateral acceleration of the car's centre of gravity |
    /// | h_a       | `front.roll_centre_height` | m     | height of the roll centre of an axle                |
    /// | T         | `front.track`              | m     | distance between the wheels of an axle              |
    /// | MR        | `front.motion_ratio`       | 1     | damper travel per wheel travel                      |
    /// | l_0       | `front.static_length`      | m     | length of the strut at rest                         |
    /// | f_0       | `front.static_force`       | N     | force of the strut at rest                          |
    /// | m_u       | `front.wheel_mass`         | kg    | unsprung mass of a corner                           |
    /// | k_t       | `front.tyre_stiffness`     | N/m   | stiffness of a tyre                                 |
    /// | c_t       | `front.tyre_damping`       | N.s/m | damping of a tyre                                   |
    /// | f_k       | `fl.strut_force`           | N     | force of the strut                                  |
    /// | z_rk      | `fl.road_height`           | m     | height of the road                                  |
    /// | v_rk      | `fl.road_velocity`         | m/s   | rate of the road's height                           |
    /// | z_uk      | `fl.wheel_height`          | m     | height of the wheel above its height at rest        |
    /// | dz_uk/dt  | `fl.wheel_velocity`        | m/s   | vertical velocity of the wheel                      |
    /// | l_k       | `fl.length`                | m     | length of the strut                                 |
    /// | dl_k/dt   | `fl.velocity`              | m/s   | rate of the strut's length                          |
    /// | f_tk      | `fl.tyre_load`             | N     | force of the tyre on the road                       |
    /// | alpha_k   | `fl.side_slip`             | rad   | side slip of the tyre                               |
    /// | F_k       | `fl.lateral_force`         | N     | lateral force of the tyre                           |
    /// | rho       | `fl.tyre_deflection`       | m     | its vertical deflection                             |
    /// | R_l       | `fl.loaded_radius`         | m     | its radius under load                               |
    /// | R_e       | `fl.effective_radius`      | m     | its effective rolling radius                        |
    ///
    /// The corners are `fl`, `fr`, `rl`, `rr` (front left to rear right), the axles `front` and `rear`.
    ///
    /// # Sign
    /// Axes of ISO 8855: $x$ forward, $y$ left, $z$ up; angles turn about them by the right-hand rule, so steering, yaw
    /// and yaw rate are positive to the left, roll is positive when the right side goes down, pitch when the nose goes
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
    /// Refused: a parameter outside its bound; `cg_to_front` > `wheelbase`; `tyre.pky2` = 0; `tyre.q_fz2` above the
    /// square of `tyre.unloaded_radius` `tyre_stiffness` / `tyre.fnomin`, divided by 4; a step that would take more than
    /// 86,000 pieces, as with `QuarterCar`.
    ///
    /// # Limits
    /// The speed is constant: no drive, no brakes, no longitudinal forces. Small angles: the lateral forces count along
    /// the $y$ axis of the body, both front wheels are steered alike, wheels stay upright (no camber), and both wheels
    /// of an axle have the path of its middle. The overturning couple of the tyres is left out. The roll centres stay
    /// where they are, and nothing lifts the body when the tyres of an axle share the lateral force unequally. No
    /// anti-roll bars: add their force to `strut_force`. The relaxation length does not change with load.
    ///
    /// # Source
    /// (1) to (4) and (9): H. $B$. Pacejka, "Tyre and Vehicle Dynamics", 2nd ed., Butterworth-Heinemann (2006):
    /// two-track model with the roll axis, section 1.3; Magic Formula, section 4.3.2, in the form of version 5.2, and in
    /// the 3rd ed. (2012) for version 6 and (9); relaxation in its simplest form, of the side slip. (5) to (8):
    /// rigid-body dynamics about a rest position. Defaults: body, wheels, struts and axles as `FourPostCar`; from the
    /// same car ZR26 the yaw inertia and the heights of the roll centres; `cg_height` is derived from the 0.293 m of
    /// that car less its wheels; tyres: an open set (Open-Car-Dynamics, Apache-2.0), scaled from a nominal load of 3000
    /// N to 700 N, without its shifts and its friction scale of 0.97. Chosen: speed, relaxation length, height of the
    /// wheels.
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

impl<T: Scalar> DoubleTrackCar<T> {
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

    fn contact(&self, corner: Corner) -> Contact<T> {
        Contact {
            load: self.tyre_load(corner),
            longitudinal_slip: T::zero(),
            side_slip: self.corner(corner).side_slip,
            camber: T::zero(),
            speed: self.speed,
        }
    }

    /// Forces and moments of the road on a tyre.
    fn wrench(&self, corner: Corner) -> Wrench<T> {
        self.tyre.wrench_on(side(corner), &self.contact(corner))
    }

    /// Radii of a tyre under its load; 0 if its formula does not carry that.
    fn radii(&self, corner: Corner, wrench: &Wrench<T>) -> Radii<T> {
        let stiffness = self.axle(corner).suspension.tyre_stiffness;
        self.tyre.radii_on(side(corner), stiffness, &self.contact(corner), wrench)
    }
}

/// The side of the car that a corner is on.
fn side(corner: Corner) -> Side {
    if corner.is_left() { Side::Left } else { Side::Right }
}

impl<T: Scalar> Car<T> for DoubleTrackCar<T> {
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

impl<T: Scalar> Law for DoubleTrackCar<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        self.output_wheels();
        let mut sum = T::zero();
        for corner in Corner::ALL {
            let wrench = self.wrench(corner);
            let radii = self.radii(corner, &wrench);
            let wheel = self.corner_mut(corner);
            wheel.lateral_force = wrench.force_y;
            (wheel.loaded_radius, wheel.effective_radius) = (radii.loaded, radii.effective);
            wheel.tyre_deflection = radii.deflection;
            sum = sum + wrench.force_y;
        }
        self.lateral_acceleration = sum / self.mass();
    }
}

impl<T: Scalar> Derivatives for DoubleTrackCar<T> {
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

impl<T: Scalar> PlaneMotion<T> {
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

impl<T: Scalar> DoubleTrackCar<T> {
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
    fn check(&self) -> Result<(), Fault> {
        if self.tyre.pky2 == 0.0 {
            return Err(Fault::new("tyre.pky2 = 0: must not be 0"));
        }
        for (name, axle) in [("front", &self.front), ("rear", &self.rear)] {
            let most = self.tyre.largest_q_fz2(axle.axle.suspension.tyre_stiffness);
            let found = self.tyre.spring.q_fz2;
            if found > most {
                let limit = format_args!("(tyre.unloaded_radius {name}.tyre_stiffness / tyre.fnomin)^2 / 4 = {most}");
                return Err(Fault::new(format_args!("tyre.q_fz2 = {found}: must be at most {limit}")));
            }
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
mod tests;
