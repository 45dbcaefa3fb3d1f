use crate::host::integrate;
use crate::host::vertical::{GRAVITY, Motion, Suspension, Wheel};
use crate::model::{Law, Model, real};
use crate::number::Real;

crate::model! {
    /// A quarter of a car: the body above one wheel, the wheel, and a tyre that lifts off. The strut between them is
    /// another model.
    QuarterCar: "Quarter car: body, wheel and tyre, driven by the force of a strut" {
        /// Height of the road under the wheel.
        road_height: input = real("m", 0.0).shown_in("mm"),
        /// Rate of the road's height.
        road_velocity: input = real("m/s", 0.0),
        /// Mass of the body, without the wheels.
        body_mass: fixed = real("kg", 52.91).positive(),
        /// What holds the wheel.
        suspension: (Suspension),
        /// Height of the body above its height at rest.
        body_height: state_output = real("m", 0.0).nominal(1e-2).shown_in("mm"),
        /// Vertical velocity of the body.
        body_velocity: state_output = real("m/s", 0.0).nominal(0.1),
        /// The wheel and the strut.
        wheel: (Wheel),
    }
}

impl<T: Real> QuarterCar<T> {
    fn road(&self) -> Motion<T> {
        Motion { height: self.road_height, velocity: self.road_velocity }
    }

    fn static_load(&self) -> T {
        T::from(GRAVITY) * (self.body_mass + self.suspension.wheel_mass)
    }
}

impl<T: Real> Law for QuarterCar<T> {
    fn output(&mut self) {
        let body = Motion { height: self.body_height, velocity: self.body_velocity };
        let (road, static_load) = (self.road(), self.static_load());
        self.wheel.output(&self.suspension, body, road, static_load);
    }
}

impl Model for QuarterCar {
    fn step(&mut self, dt: f64) {
        integrate::held::<_, 4>(self, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        integrate::advance::<_, 4>(self, slope, dt);
    }

    fn rate(&self, rate: &mut Self) {
        rate.body_height = self.body_velocity;
        rate.body_velocity = self.wheel.lift(&self.suspension) / self.body_mass;
        rate.wheel.wheel_height = self.wheel.wheel_velocity;
        rate.wheel.wheel_velocity = self.wheel.acceleration(&self.suspension, self.road(), self.static_load());
    }
}
