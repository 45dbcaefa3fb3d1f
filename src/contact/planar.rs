//! Motion of a contact in its tangent plane, and of a bristle that it moves within or along a circle.

use nalgebra::Vector3;

use crate::contact::turning;
use crate::number::elementary::atan2;
use crate::numerics::root;
use crate::numerics::vector::{direction, in_plane, length};

/// A deflection counts as at its limit from this part of the limit on (chosen), the resolution of a sum of squares.
pub(crate) const AT_LIMIT: f64 = 1.0 - 1e-12;

/// Velocity and load that move linearly in a plane.
#[derive(Clone, Copy)]
pub(crate) struct Ramp {
    /// Tangential velocity at both ends.
    pub velocity: [Vector3<f64>; 2],
    /// Load at both ends.
    pub load: [f64; 2],
    pub duration: f64,
}

impl Ramp {
    pub fn velocity_at(&self, share: f64) -> Vector3<f64> {
        self.velocity[0] + (self.velocity[1] - self.velocity[0]) * share
    }

    fn load_at(&self, share: f64) -> f64 {
        self.load[0] + (self.load[1] - self.load[0]) * share
    }

    /// The part between two shares of the duration.
    pub fn part(&self, from: f64, to: f64) -> Ramp {
        Ramp {
            velocity: [self.velocity_at(from), self.velocity_at(to)],
            load: [self.load_at(from), self.load_at(to)],
            duration: (to - from) * self.duration,
        }
    }

    /// Shares of the duration at which the speed passes `speed`, and at which it is lowest, in rising order.
    pub fn cuts(&self, speed: f64) -> [f64; 3] {
        let (start, change) = (self.velocity[0], self.velocity[1] - self.velocity[0]);
        let square = change.dot(&change);
        let lowest = -start.dot(&change) / square;
        let least = start + change * lowest;
        let half = ((speed * speed - least.dot(&least)) / square).max(0.0).sqrt();
        [lowest - half, lowest, lowest + half]
    }

    /// A speed below which there is only rounding and no direction.
    pub fn rounded(mut self) -> Ramp {
        let largest = length(&self.velocity[0]).max(length(&self.velocity[1]));
        for velocity in &mut self.velocity {
            if length(velocity) <= 1e-12 * largest {
                *velocity = Vector3::zeros();
            }
        }
        self
    }

    /// Directions of the motion at both ends.
    pub fn forward(&self) -> [Vector3<f64>; 2] {
        let [a, b] = self.velocity.map(|velocity| direction(&velocity));
        let is_zero = |vector: &Vector3<f64>| *vector == Vector3::zeros();
        [if is_zero(&a) { b } else { a }, if is_zero(&b) { a } else { b }]
    }
}

/// A bristle within or on its circle, and the energy that it has taken out of the motion.
pub(crate) struct Bristle {
    pub deflection: Vector3<f64>,
    pub energy: f64,
    /// Normal of the plane; of length 0 if there is none.
    pub normal: Vector3<f64>,
    pub stiffness: f64,
    pub damping: f64,
    /// Whether a bristle that slides has the direction of the velocity.
    pub is_led: bool,
}

impl Bristle {
    /// Follows a ramp over which z_max moves linearly.
    pub fn follow(&mut self, ramp: &Ramp, limit: [f64; 2]) {
        let growth = (limit[1] - limit[0]) / ramp.duration;
        let (mut from, mut has_left) = (0.0, false);
        // It seldom takes more than two: a bristle that swings back and forth within a part is accepted as it is.
        for _ in 0..8 {
            if from >= 1.0 {
                break;
            }
            let rest = ramp.part(from, 1.0);
            let circle = [limit[0] + (limit[1] - limit[0]) * from, limit[1]];
            if !has_left && length(&self.deflection) >= AT_LIMIT * circle[0] {
                self.clamp(&rest.velocity[0], circle[0]);
                let outward = if circle[0] > 0.0 { direction(&self.deflection) } else { rest.forward()[0] };
                let ahead = rest.velocity[0].dot(&outward) - growth;
                if ahead > 0.0 || ahead == 0.0 && (rest.velocity[1] - rest.velocity[0]).dot(&outward) > 0.0 {
                    let done = self.slide_part(&rest, circle, ahead);
                    from = if done < 1.0 { from + (1.0 - from) * done } else { 1.0 };
                    has_left = true;
                    continue;
                }
            }
            let done = self.move_freely(&rest, circle);
            from = if done < 1.0 { from + (1.0 - from) * done } else { 1.0 };
            has_left = false;
        }
        self.clamp(&ramp.velocity[1], limit[1]);
    }

    /// Shortens a deflection to its limit.
    fn clamp(&mut self, velocity: &Vector3<f64>, limit: f64) {
        let z = &mut self.deflection;
        if length(z) * AT_LIMIT > limit {
            *z = direction(if self.is_led && length(velocity) > 0.0 { velocity } else { z }) * limit;
        }
    }

    /// Slides until the bristle leaves the circle; returns the share of the ramp that this takes. `ahead` is the speed
    /// outwards, less that of the circle.
    fn slide_part(&mut self, ramp: &Ramp, limit: [f64; 2], ahead: f64) -> f64 {
        let growth = (limit[1] - limit[0]) / ramp.duration;
        let (end, _) = self.slid(ramp, limit);
        let ahead_end = ramp.velocity[1].dot(&direction(&end)) - growth;
        let share = if ahead_end < 0.0 { ahead / (ahead - ahead_end) } else { 1.0 };
        let (part, limit) = (ramp.part(0.0, share), [limit[0], limit[0] + (limit[1] - limit[0]) * share]);
        let (deflection, work) = self.slid(&part, limit);
        self.deflection = deflection;
        self.energy += work;
        share
    }

    /// Deflection after sliding over the whole ramp, and the work.
    fn slid(&self, ramp: &Ramp, limit: [f64; 2]) -> (Vector3<f64>, f64) {
        let mut z = self.deflection;
        let (forward, middle) = (ramp.forward(), 0.5 * (limit[0] + limit[1]));
        let speed = length(&ramp.velocity_at(0.5));
        let distance = speed * ramp.duration;
        if distance == 0.0 || middle == 0.0 {
            return (direction(&z) * limit[1], 0.0);
        }
        if z == Vector3::zeros() || self.is_led {
            z = forward[0] * middle;
        }
        let (mut along, mut across) = slide(&mut z, &forward, &self.normal, distance, middle);
        if self.is_led {
            (z, along, across) = (forward[1], distance / middle, 0.0);
        }
        let outward = middle * along / ramp.duration;
        // Damping of the outward motion that the circle allows, and of a free bristle that a shrinking circle
        // overtakes.
        let radial = if outward > 0.0 { ((limit[1] - limit[0]) / ramp.duration).max(0.0) } else { outward };
        let work = self.stiffness * middle * middle * along
            + self.damping * (speed * middle * across + radial * outward * ramp.duration);
        (direction(&z) * limit[1], work)
    }

    /// Moves within the circle until the bristle reaches it; returns the share of the ramp that this takes.
    fn move_freely(&mut self, ramp: &Ramp, limit: [f64; 2]) -> f64 {
        let start = self.deflection;
        let at = |share: f64| start + (ramp.velocity[0] + ramp.velocity_at(share)) * (0.5 * share * ramp.duration);
        let beyond = |share: f64| length(&at(share)) - (limit[0] + (limit[1] - limit[0]) * share);
        let share = if beyond(1.0) > 0.0 { root::bisect(beyond, 0.0, 1.0) } else { 1.0 };
        let end = at(share);
        let [a, b] = [ramp.velocity[0], ramp.velocity_at(share)];
        let squares = (a.dot(&a) + a.dot(&b) + b.dot(&b)) / 3.0;
        self.energy +=
            self.stiffness * 0.5 * (end - start).dot(&(end + start)) + self.damping * squares * (share * ramp.duration);
        self.deflection = end;
        share
    }
}

/// The time until |z + v t| = limit for a z within it; infinite at rest.
pub(crate) fn time_to_limit(z: &Vector3<f64>, velocity: &Vector3<f64>, limit: f64) -> f64 {
    let speed = length(velocity);
    if speed == 0.0 {
        return f64::INFINITY;
    }
    // In lengths of the limit: distance d with d^2 + 2 b d - c = 0.
    let z = z / limit;
    let b = z.dot(&direction(velocity));
    let c = (1.0 - length(&z)) * (1.0 + length(&z));
    let root = (b * b + c).max(0.0).sqrt();
    let distance = if b > 0.0 { c / (b + root) } else { root - b };
    distance.max(0.0) * (limit / speed)
}

/// Lets a bristle slide along the circle of the radius `limit` over a distance, while the direction of the motion turns
/// from one to the other. Returns the integrals of cos(phi) and sin(phi)^2 over the distance, in lengths of the limit.
pub(crate) fn slide(
    z: &mut Vector3<f64>,
    forward: &[Vector3<f64>; 2],
    normal: &Vector3<f64>,
    distance: f64,
    limit: f64,
) -> (f64, f64) {
    let start = direction(z);
    let side = in_plane(&start, &forward[0]);
    // Without a normal the bristle turns in the plane of its own and of the motion.
    let has_plane = forward[0] != forward[1] && length(normal) > 0.0;
    let left = forward.map(|forward| if has_plane { normal.cross(&forward) } else { -direction(&side) });
    let sin = if has_plane { -start.dot(&left[0]) } else { length(&side) };
    let w = atan2(forward[1].dot(&left[0]), forward[1].dot(&forward[0]));
    let turn = turning::follow(sin, start.dot(&forward[0]), distance / limit, if has_plane { w } else { 0.0 });
    *z = (forward[1] * turn.cos - left[1] * turn.sin) * limit;
    (turn.along, turn.across)
}

/// A vector in the plane of one normal, carried along as the plane turns into that of another.
pub(crate) fn carried(vector: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>) -> Vector3<f64> {
    // The plane does not depend on which way its normal points.
    let cos = from.dot(to);
    let to = if cos < 0.0 { -to } else { *to };
    vector - (from + to) * (vector.dot(&to) / (1.0 + cos.abs()))
}
