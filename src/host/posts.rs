use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::model::{Derivatives, Law, Meaning, Model, ModelExchange, real};
use crate::number::{Mask, Real};

crate::part! {
    /// A post under a wheel.
    Actuator {
        /// Height of the post under the wheel.
        post_height: output = real("m", 0.0).nominal(1e-2).shown_in("mm").means(Meaning::GroundHeight),
        /// Rate of the post's height.
        post_velocity: output = real("m/s", 0.0).nominal(0.1).means(Meaning::GroundVelocity),
        /// Travel of the post, lowest to highest.
        travel: fixed = real("m", 0.04).at_least(0.0).shown_in("mm"),
        /// Phase lag of the post; it rests until then.
        phase: fixed = real("rad", 0.0).at_least(0.0).shown_in("deg"),
    }
}

crate::model! {
    /// The posts of a four-post rig: sinusoidal strokes that begin smoothly, each with its own phase.
    /// # Equations
    ///
    /// ```text
    /// theta = integral of 2 pi f dt,   u_k = max(0, theta - phi_k)
    /// z_k   = A_k (1 - cos u_k) / 2
    /// v_k   = pi f A_k sin u_k
    /// ```
    ///
    /// | symbol | variable           | unit | meaning                                     |
    /// |--------|--------------------|------|---------------------------------------------|
    /// | f      | `frequency`        | Hz   | frequency of the strokes                    |
    /// | A_k    | `fl.travel`        | m    | lowest to highest position                  |
    /// | phi_k  | `fl.phase`         | rad  | phase lag of the post                       |
    /// | theta  | `angle`            | rad  | angle of the drive                          |
    /// | z_k    | `fl.post_height`   | m    | height                                      |
    /// | v_k    | `fl.post_velocity` | m/s  | its rate                                    |
    ///
    /// The posts are `fl`, `fr`, `rl`, `rr` (front left to rear right).
    ///
    /// # Sign
    /// Heights are positive up, 0 at the start.
    ///
    /// # Step
    /// Exact for any step: the outputs follow from the angle, and the angle is linear in time.
    ///
    /// # Errors
    /// Refused: a parameter outside its bound.
    ///
    /// # Limits
    /// Height and velocity begin without a jump, the acceleration jumps when a post starts. A change of `frequency`
    /// during the run changes the velocity at once.
    ///
    /// # Source
    /// Four-post test of F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis,
    /// University of Minho (2024): 40 mm on all wheels, a phase between the axles. Chosen: 2 Hz, 90 degrees.
    ///
    /// # Example
    /// ```
    /// use stribeck::host::Posts;
    /// use stribeck::model::{Law, Model};
    /// let mut posts = Posts::default();
    /// posts.step(0.25); // half a period
    /// posts.output();
    /// assert!((posts.fl.post_height - 0.04).abs() < 1e-15);
    /// assert!((posts.rl.post_height - 0.02).abs() < 1e-15); // a quarter of a period late
    /// ```
    Posts: "Four-post rig" {
        /// Front left post.
        fl: Actuator,
        /// Front right post.
        fr: Actuator,
        /// Rear left post.
        rl: Actuator = &[("phase", FRAC_PI_2)],
        /// Rear right post.
        rr: Actuator = &[("phase", FRAC_PI_2)],
        /// Frequency of the strokes.
        frequency: tunable = real("Hz", 2.0).at_least(0.0),
        /// Angle of the drive.
        angle: state = real("rad", 0.0),
    }
}

impl<T: Real> Actuator<T> {
    fn follow(&mut self, angle: T, frequency: T) {
        let late = angle - self.phase;
        let run = late.is_positive().choose(|| late, T::zero);
        // (1 - cos u) / 2 without cancellation.
        let half = (T::from(0.5) * run).sin();
        self.post_height = self.travel * half * half;
        self.post_velocity = T::from(PI) * frequency * self.travel * run.sin();
    }
}

impl<T: Real> Law for Posts<T> {
    type Interface = ModelExchange;

    fn output(&mut self) {
        for post in [&mut self.fl, &mut self.fr, &mut self.rl, &mut self.rr] {
            post.follow(self.angle, self.frequency);
        }
    }
}

impl<T: Real> Derivatives for Posts<T> {
    fn derivatives(&self, rate: &mut Self) {
        rate.angle = T::from(TAU) * self.frequency;
    }
}

impl Model for Posts {
    fn step(&mut self, dt: f64) {
        self.angle += TAU * self.frequency * dt;
    }

    fn step_ramp(&mut self, _slope: &Self, dt: f64) {
        self.step(dt);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn at(time: f64) -> Posts {
        let mut posts = Posts::default();
        posts.step(time);
        posts.output();
        posts
    }

    #[test]
    fn velocity_is_the_slope_of_height() {
        let h = 1e-6;
        for time in [0.01, 0.124, 0.2, 0.3, 1.77] {
            let [before, now, after] = [at(time - h), at(time), at(time + h)];
            for corner in [|posts: &Posts| posts.fl, |posts: &Posts| posts.rr] {
                let slope = (corner(&after).post_height - corner(&before).post_height) / (2.0 * h);
                assert!((slope - corner(&now).post_velocity).abs() < 1e-9, "{time}");
            }
        }
    }

    #[test]
    fn late_posts_rest_and_then_do_the_same() {
        assert_eq!([at(0.12).rl.post_height, at(0.12).rl.post_velocity], [0.0, 0.0]);
        let [early, late] = [at(0.31).fl, at(0.31 + 0.125).rl];
        assert_abs_diff_eq!(early.post_height, late.post_height, epsilon = 1e-15);
        assert_abs_diff_eq!(early.post_velocity, late.post_velocity, epsilon = 1e-14);
    }

    /// The mean of (A (1 - cos)/2)^2 over whole periods is 3/8 A^2.
    #[test]
    fn strokes_have_the_mean_square_of_their_form() {
        let mut posts = Posts::default();
        let mut sum = 0.0;
        for _ in 0..5000 {
            posts.step(1e-3);
            posts.output();
            sum += posts.fr.post_height.powi(2);
        }
        assert_abs_diff_eq!(sum / 5000.0, 0.375 * 0.04f64.powi(2), epsilon = 1e-12);
    }
}
