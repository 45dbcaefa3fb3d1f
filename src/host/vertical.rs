//! Common parts of the cars: a rigid body that heaves, pitches and rolls on struts, wheels and tyres.
//!
//! All heights are deviations from rest, positive up. Axes as in ISO 8855: x forward, y left, z up.

use crate::model::{Fault, Meaning, real};
use crate::number::{Mask, Scalar};

/// Acceleration of gravity in m/s2, as in the benchmark of the friction models (9.81 N for 1 kg).
pub const GRAVITY: f64 = 9.81;

crate::part! {
    /// The suspension of a wheel: the lever of the strut, the wheel and its tyre.
    Suspension {
        /// Damper travel per wheel travel.
        motion_ratio: fixed = real("1", 1.011).positive(),
        /// Length of the strut at rest, eye to eye.
        static_length: fixed = real("m", 0.1775).positive().shown_in("mm"),
        /// Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
        static_force: fixed = real("N", 1325.2555),
        /// Unsprung mass of the corner.
        wheel_mass: fixed = real("kg", 16.36).positive(),
        /// Stiffness of the tyre.
        tyre_stiffness: fixed = real("N/m", 87563.5).at_least(0.0),
        /// Damping of the tyre.
        tyre_damping: fixed = real("N.s/m", 95.8).at_least(0.0),
    }
}

crate::part! {
    /// A wheel with the strut above it.
    Wheel {
        /// Force of the strut; positive pushes its eyes apart.
        strut_force: input = real("N", 1325.2555).means(Meaning::StrutForce),
        /// Height of the wheel above its height at rest.
        wheel_height: state_output = real("m", 0.0).nominal(1e-2).shown_in("mm"),
        /// Vertical velocity of the wheel.
        wheel_velocity: state_output = real("m/s", 0.0).nominal(0.1),
        /// Length of the strut, eye to eye.
        length: output = real("m", 0.1775).shown_in("mm").means(Meaning::StrutLength),
        /// Rate of the strut's length; positive as it extends.
        velocity: output = real("m/s", 0.0).means(Meaning::Velocity),
        /// Vertical force of the tyre on the ground; 0 while the wheel is off the ground.
        tyre_load: output = real("N", 0.0),
    }
}

/// Height and vertical velocity of a point.
#[derive(Clone, Copy)]
pub struct Motion<T> {
    /// Height above the height at rest.
    pub height: T,
    /// Vertical velocity.
    pub velocity: T,
}

impl<T: Scalar> Wheel<T> {
    /// Computes the outputs, for the body and the ground at this wheel and the load of the tyre at rest.
    pub fn output(&mut self, with: &Suspension<T>, body: Motion<T>, ground: Motion<T>, static_load: T) {
        self.length = with.static_length + with.motion_ratio * (body.height - self.wheel_height);
        self.velocity = with.motion_ratio * (body.velocity - self.wheel_velocity);
        self.tyre_load = self.load(with, ground, static_load);
    }

    /// Load of the tyre, which cannot pull.
    pub fn load(&self, with: &Suspension<T>, ground: Motion<T>, static_load: T) -> T {
        let load = static_load
            + with.tyre_stiffness * (ground.height - self.wheel_height)
            + with.tyre_damping * (ground.velocity - self.wheel_velocity);
        load.is_positive().choose(|| load, || T::zero())
    }

    /// Whether the wheel is on the ground.
    pub fn is_on(&self, with: &Suspension<T>, ground: Motion<T>, static_load: T) -> bool {
        self.load(with, ground, static_load) > T::zero()
    }

    /// Force of the strut on the body, as it acts at the wheel, beyond that at rest.
    pub fn lift(&self, with: &Suspension<T>) -> T {
        with.motion_ratio * (self.strut_force - with.static_force)
    }

    /// Acceleration of the wheel.
    pub fn acceleration(&self, with: &Suspension<T>, ground: Motion<T>, static_load: T) -> T {
        (self.load(with, ground, static_load) - static_load - self.lift(with)) / with.wheel_mass
    }
}

crate::part! {
    /// An axle with two identical wheels.
    Axle {
        /// Distance between the wheels of the axle.
        track: fixed = real("m", 1.22).positive(),
        /// The suspension of each of its wheels.
        suspension: (Suspension),
    }
}

crate::part! {
    /// The body of a car: rigid, with small angles.
    Body {
        /// Mass of the body, without the wheels.
        body_mass: fixed = real("kg", 223.2).positive(),
        /// Moment of inertia of the body about its lateral axis.
        pitch_inertia: fixed = real("kg.m2", 126.29).positive(),
        /// Moment of inertia of the body about its longitudinal axis.
        roll_inertia: fixed = real("kg.m2", 26.46).positive(),
        /// Distance between the axles.
        wheelbase: fixed = real("m", 1.528).positive(),
        /// Distance of the front axle ahead of the body's centre of gravity.
        cg_to_front: fixed = real("m", 0.8035).at_least(0.0),
        /// Height of the centre of gravity above its height at rest.
        heave: state_output = real("m", 0.0).nominal(1e-2).shown_in("mm"),
        /// Vertical velocity of the centre of gravity.
        heave_rate: state_output = real("m/s", 0.0).nominal(0.1),
        /// Pitch angle; positive nose down.
        pitch: state_output = real("rad", 0.0).nominal(1e-2).shown_in("deg"),
        /// Rate of the pitch angle.
        pitch_rate: state_output = real("rad/s", 0.0).nominal(0.1),
        /// Roll angle; positive lowers the right side.
        roll: state_output = real("rad", 0.0).nominal(1e-2).shown_in("deg"),
        /// Rate of the roll angle.
        roll_rate: state_output = real("rad/s", 0.0).nominal(0.1),
    }
}

/// Force and moments on a body, beyond those at rest; signs as those of heave, pitch and roll.
#[derive(Clone, Copy)]
pub struct Load<T> {
    /// Upwards.
    pub force: T,
    /// About the lateral axis.
    pub pitch_moment: T,
    /// About the longitudinal axis.
    pub roll_moment: T,
}

/// The corners in the order of all arrays of corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corner {
    /// `fl`.
    FrontLeft,
    /// `fr`.
    FrontRight,
    /// `rl`.
    RearLeft,
    /// `rr`.
    RearRight,
}

impl Corner {
    /// All corners, in order.
    pub const ALL: [Corner; 4] = [Corner::FrontLeft, Corner::FrontRight, Corner::RearLeft, Corner::RearRight];

    /// Whether it is on the front axle.
    pub fn is_front(self) -> bool {
        matches!(self, Corner::FrontLeft | Corner::FrontRight)
    }

    /// Whether it is on the left side.
    pub fn is_left(self) -> bool {
        matches!(self, Corner::FrontLeft | Corner::RearLeft)
    }
}

/// Position of a wheel relative to the centre of gravity.
#[derive(Clone, Copy)]
pub struct Place<T> {
    /// Forward.
    pub x: T,
    /// To the left.
    pub y: T,
}

impl<T: Scalar> Body<T> {
    /// Position of a wheel.
    pub fn place(&self, corner: Corner, axle: &Axle<T>) -> Place<T> {
        let x = if corner.is_front() { self.cg_to_front } else { self.cg_to_front - self.wheelbase };
        let half_track = axle.track / T::from(2.0);
        Place { x, y: if corner.is_left() { half_track } else { -half_track } }
    }

    /// Motion of the body at a position.
    pub fn at(&self, Place { x, y }: Place<T>) -> Motion<T> {
        Motion {
            height: self.heave - x * self.pitch + y * self.roll,
            velocity: self.heave_rate - x * self.pitch_rate + y * self.roll_rate,
        }
    }

    /// Load of a tyre at rest.
    pub fn static_load(&self, corner: Corner, axle: &Axle<T>) -> T {
        let behind = self.wheelbase - self.cg_to_front;
        let lever = if corner.is_front() { behind } else { self.cg_to_front };
        let share = lever / (T::from(2.0) * self.wheelbase);
        T::from(GRAVITY) * (self.body_mass * share + axle.suspension.wheel_mass)
    }

    /// Writes the rates of the body's states.
    pub fn rate(&self, load: Load<T>, rate: &mut Body<T>) {
        rate.heave = self.heave_rate;
        rate.pitch = self.pitch_rate;
        rate.roll = self.roll_rate;
        rate.heave_rate = load.force / self.body_mass;
        rate.pitch_rate = load.pitch_moment / self.pitch_inertia;
        rate.roll_rate = load.roll_moment / self.roll_inertia;
    }
}

impl Body {
    /// Rejects a body that would tip over.
    pub fn check(&self) -> Result<(), Fault> {
        let Body { cg_to_front, wheelbase, .. } = *self;
        if cg_to_front > wheelbase {
            return Err(Fault::new(format_args!("cg_to_front = {cg_to_front}: must be <= wheelbase = {wheelbase}")));
        }
        Ok(())
    }
}

/// A car on four wheels: the equations that follow from its parts and from the ground under it.
pub trait Car<T: Scalar> {
    /// The body.
    fn body(&self) -> &Body<T>;
    /// The axle of a corner.
    fn axle(&self, corner: Corner) -> &Axle<T>;
    /// The wheel of a corner.
    fn wheel(&self, corner: Corner) -> &Wheel<T>;
    /// The wheel of a corner, mutable.
    fn wheel_mut(&mut self, corner: Corner) -> &mut Wheel<T>;
    /// The ground under a wheel.
    fn ground(&self, corner: Corner) -> Motion<T>;

    /// Position of a wheel relative to the body's centre of gravity.
    fn place(&self, corner: Corner) -> Place<T> {
        self.body().place(corner, self.axle(corner))
    }

    /// Load of a tyre at rest.
    fn static_load(&self, corner: Corner) -> T {
        self.body().static_load(corner, self.axle(corner))
    }

    /// Load of a tyre.
    fn tyre_load(&self, corner: Corner) -> T {
        self.wheel(corner).load(&self.axle(corner).suspension, self.ground(corner), self.static_load(corner))
    }

    /// Force and moments of the struts on the body.
    fn strut_load(&self) -> Load<T> {
        let lift = |corner| self.wheel(corner).lift(&self.axle(corner).suspension);
        Load::of(Corner::ALL.map(|corner| (self.place(corner), lift(corner))))
    }

    /// Acceleration of a wheel by its strut and its tyre.
    fn wheel_acceleration(&self, corner: Corner) -> T {
        let suspension = &self.axle(corner).suspension;
        self.wheel(corner).acceleration(suspension, self.ground(corner), self.static_load(corner))
    }

    /// One bit for each wheel that is on the ground.
    fn wheels_on_ground(&self) -> u32 {
        Corner::ALL.into_iter().fold(0, |bits, corner| 2 * bits + u32::from(self.tyre_load(corner) > T::zero()))
    }

    /// Computes the outputs of the wheels.
    fn output_wheels(&mut self) {
        for corner in Corner::ALL {
            let (suspension, body) = (self.axle(corner).suspension, self.body().at(self.place(corner)));
            let (ground, static_load) = (self.ground(corner), self.static_load(corner));
            self.wheel_mut(corner).output(&suspension, body, ground, static_load);
        }
    }
}

impl<T: Scalar> Load<T> {
    /// Sum of the upward forces on the body at the positions of the wheels.
    pub fn of(forces: [(Place<T>, T); 4]) -> Load<T> {
        let none = Load { force: T::zero(), pitch_moment: T::zero(), roll_moment: T::zero() };
        forces.into_iter().fold(none, |sum, (Place { x, y }, force)| Load {
            force: sum.force + force,
            pitch_moment: sum.pitch_moment - x * force,
            roll_moment: sum.roll_moment + y * force,
        })
    }
}
