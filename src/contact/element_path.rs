//! Motion of an element of generalised Maxwell-slip friction while speed and level move linearly.

use crate::number::elementary::exp_m1;

/// Integral of the square of a linear function.
fn square_integral([a, b]: [f64; 2], duration: f64) -> f64 {
    (a * a + a * b + b * b) / 3.0 * duration
}

/// An element in the direction of the motion.
#[derive(Default)]
pub(crate) struct Follower {
    pub force: f64,
    pub slips: bool,
    pub work: f64,
    /// Integral of the velocity over the force.
    pub damping: f64,
}

/// Limits of an element while speed and level move linearly.
pub(crate) struct Path {
    pub stiffness: f64,
    /// alpha_i s(v) at both ends.
    pub strength: [f64; 2],
    /// C alpha_i.
    pub attraction: f64,
    pub speed: [f64; 2],
    pub duration: f64,
}

impl Path {
    /// Moves an element along the path.
    pub(crate) fn follow(&self, element: &mut Follower) {
        let slips = element.slips && element.force > 0.0;
        let onset = if slips { 0.0 } else { self.onset(element.force) };
        element.slips = onset < self.duration;
        if onset > 0.0 {
            self.stick(element, onset.min(self.duration));
        }
        if element.slips {
            if onset > 0.0 {
                element.force = self.strength_at(onset);
            }
            self.slip(element, onset);
        }
    }

    fn strength_at(&self, time: f64) -> f64 {
        self.strength[0] + (self.strength[1] - self.strength[0]) * (time / self.duration)
    }

    fn speed_at(&self, time: f64) -> f64 {
        self.speed[0] + (self.speed[1] - self.speed[0]) * (time / self.duration)
    }

    /// The instant at which a spring reaches its moving level; infinite if it does not.
    fn onset(&self, force: f64) -> f64 {
        // c + b t + a t^2 >= 0
        let a = 0.5 * self.stiffness * (self.speed[1] - self.speed[0]) / self.duration;
        let b = self.stiffness * self.speed[0] - (self.strength[1] - self.strength[0]) / self.duration;
        let c = force - self.strength[0];
        let square = b * b - 4.0 * a * c;
        if c > 0.0 || c == 0.0 && (b > 0.0 || b == 0.0 && a >= 0.0) {
            0.0
        } else if b > 0.0 && square >= 0.0 {
            -2.0 * c / (b + square.sqrt())
        } else if a > 0.0 {
            (square.sqrt() - b) / (2.0 * a)
        } else {
            f64::INFINITY
        }
    }

    fn stick(&self, element: &mut Follower, time: f64) {
        let speed = [self.speed[0], self.speed_at(time)];
        let (before, distance) = (element.force, 0.5 * (speed[0] + speed[1]) * time);
        element.force += self.stiffness * distance;
        element.work += 0.5 * (before + element.force) * distance;
        element.damping += self.stiffness * square_integral(speed, time);
    }

    /// Slips from an instant to the end. The difference g of force and level follows `dg/dt = -rate g - slope`, with
    /// the rate in the middle.
    fn slip(&self, element: &mut Follower, from: f64) {
        let (time, strength) = (self.duration - from, [self.strength_at(from), self.strength[1]]);
        let (before, change) = (element.force, strength[1] - strength[0]);
        let rate = self.attraction / (0.5 * (strength[0] + strength[1]));
        let gap = before - strength[0];
        let decay = -exp_m1(-rate * time);
        let lag = change * (if rate * time > 0.0 { decay / (rate * time) } else { 1.0 });
        let gap_end = gap * (1.0 - decay) - lag;
        element.force = strength[1] + gap_end;
        let short = rate * time < 1e-5;
        let gaps = if short { 0.5 * time * (gap + gap_end) } else { (gap - gap_end - change) / rate };
        let speed = 0.5 * (self.speed_at(from) + self.speed[1]);
        element.work += speed * (0.5 * (strength[0] + strength[1]) * time + gaps);
        element.damping += speed * (element.force - before);
    }
}
