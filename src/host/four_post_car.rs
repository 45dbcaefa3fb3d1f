use crate::host::integrate;
use crate::host::vertical::{Axle, Body, Corner, Load, Motion, Wheel};
use crate::model::{Law, Model, real};
use crate::number::Real;

crate::part! {
    /// A corner of the car, on its post.
    Post {
        /// Height of the post under the wheel.
        post_height: input = real("m", 0.0).shown_in("mm"),
        /// Rate of the post's height.
        post_velocity: input = real("m/s", 0.0),
        /// The wheel and the strut.
        wheel: (Wheel),
    }
}

crate::model! {
    /// A car on four posts: heave, pitch and roll of the body and the heights of four wheels, with tyres that lift off.
    /// The four struts are other models.
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

impl<T: Real> Post<T> {
    fn ground(&self) -> Motion<T> {
        Motion { height: self.post_height, velocity: self.post_velocity }
    }
}

impl<T: Real> FourPostCar<T> {
    fn axle(&self, corner: Corner) -> &Axle<T> {
        if corner.is_front() { &self.front } else { &self.rear }
    }

    fn post(&self, corner: Corner) -> &Post<T> {
        match corner {
            Corner::FrontLeft => &self.fl,
            Corner::FrontRight => &self.fr,
            Corner::RearLeft => &self.rl,
            Corner::RearRight => &self.rr,
        }
    }
}

impl FourPostCar {
    fn lift(&self, corner: Corner) -> f64 {
        self.post(corner).wheel.lift(&self.axle(corner).suspension)
    }

    fn wheel_acceleration(&self, corner: Corner) -> f64 {
        let (axle, post) = (self.axle(corner), self.post(corner));
        post.wheel.acceleration(&axle.suspension, post.ground(), self.body.static_load(corner, axle))
    }
}

impl<T: Real> Law for FourPostCar<T> {
    fn output(&mut self) {
        let FourPostCar { body, front, rear, fl, fr, rl, rr } = self;
        for (corner, axle, post) in [
            (Corner::FrontLeft, &*front, fl),
            (Corner::FrontRight, front, fr),
            (Corner::RearLeft, rear, rl),
            (Corner::RearRight, rear, rr),
        ] {
            let motion = body.at(body.place(corner, axle));
            post.wheel.output(&axle.suspension, motion, post.ground(), body.static_load(corner, axle));
        }
    }
}

impl Model for FourPostCar {
    fn step(&mut self, dt: f64) {
        integrate::held::<_, 14>(self, dt);
    }

    fn step_ramp(&mut self, slope: &Self, dt: f64) {
        integrate::advance::<_, 14>(self, slope, dt);
    }

    fn rate(&self, rate: &mut Self) {
        let force = |corner| (self.body.place(corner, self.axle(corner)), self.lift(corner));
        self.body.rate(Load::of(Corner::ALL.map(force)), &mut rate.body);
        let posts = [&mut rate.fl, &mut rate.fr, &mut rate.rl, &mut rate.rr];
        for (corner, rate) in Corner::ALL.into_iter().zip(posts) {
            rate.wheel.wheel_height = self.post(corner).wheel.wheel_velocity;
            rate.wheel.wheel_velocity = self.wheel_acceleration(corner);
        }
    }
}
