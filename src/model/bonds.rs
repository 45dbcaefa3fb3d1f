//! Bonds between two surfaces: the motion strains all of them alike, and they snap one by one.
//!
//! The force of a contact with such bonds is linear in the displacement between two snaps, and where the next one happens is
//! known beforehand. There are far too many snaps for events: a solver follows them within its steps.

use crate::numerics::random::{key, uniform, uniform_of};

/// Largest number of bonds in a contact. Haessig and Friedland find fewer than 50 sufficient.
pub const MOST_BONDS: usize = 64;

/// Places for the bonds in their order, so that this can move on by one with each snap (chosen).
const PLACES: usize = 4 * MOST_BONDS;

/// Parameters that all bonds of a contact share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Strain at which a bond snaps.
    pub(crate) limit: f64,
    /// Largest strain that a bond loses when it snaps.
    pub(crate) span: f64,
    /// Seed of the random numbers.
    pub(crate) seed: f64,
}

impl Surface {
    /// The next random number of a bond that has used `draws` of them, in (0, 1].
    pub(crate) fn draw(&self, number: usize, draws: &mut f64) -> f64 {
        let value = uniform(self.seed as i32, number as u64, *draws as u64);
        *draws += 1.0;
        value
    }

    /// A strain in the direction of a long slide: limit - strain has the density 2 / span (1 - d / span).
    pub(crate) fn stationary(&self, number: usize, draws: &mut f64) -> f64 {
        self.limit - self.span * (1.0 - (1.0 - self.draw(number, draws)).sqrt())
    }
}

/// A bond.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bond {
    /// Number within the contact, from 0.
    pub number: usize,
    /// Strain.
    pub strain: f64,
    /// Random numbers that it has used.
    pub draws: f64,
}

/// The bonds of a contact.
#[derive(Clone, Copy, Debug)]
pub struct Bonds {
    surface: Surface,
    /// Strains of those in use, in their order, from the place `first` on.
    strains: [f64; PLACES],
    /// The numbers of the bonds that have them.
    numbers: [u8; PLACES],
    first: usize,
    /// Random numbers used, in the order of the bonds.
    draws: [u64; MOST_BONDS],
    /// Keys of their sequences of random numbers.
    keys: [u64; MOST_BONDS],
    count: usize,
    /// Reciprocal of the count, as a division would take a fifteenth of the time of a snap.
    share: f64,
    /// Displacement that is to be added to each strain.
    moved: f64,
    /// Sum of the strains.
    sum: f64,
    /// Integral of the sum over the displacement.
    area: f64,
    /// Force by strain of a bond.
    stiffness: f64,
    /// Energy dissipated before.
    energy: f64,
    /// Whether those that have used no random number wait for the motion, in whose direction they are then strained.
    waits: bool,
}

impl Bonds {
    /// The bonds of a contact, which has dissipated some energy.
    pub(crate) fn new(surface: Surface, stiffness: f64, energy: f64, bonds: impl Iterator<Item = Bond>) -> Bonds {
        let (mut room, mut count) = ([Bond::default(); MOST_BONDS], 0);
        for (place, bond) in room.iter_mut().zip(bonds) {
            *place = bond;
            count += 1;
        }
        let keys = std::array::from_fn(|number| key(surface.seed as i32, number as u64));
        let mut bonds = Bonds {
            surface,
            strains: [0.0; PLACES],
            numbers: [0; PLACES],
            first: 0,
            draws: [0; MOST_BONDS],
            keys,
            count,
            share: 1.0 / count as f64,
            moved: 0.0,
            sum: 0.0,
            area: 0.0,
            stiffness,
            energy,
            waits: false,
        };
        bonds.put(&mut room[..count]);
        bonds
    }

    /// Takes the bonds in use over.
    fn put(&mut self, bonds: &mut [Bond]) {
        bonds.sort_unstable_by(|a, b| a.strain.total_cmp(&b.strain));
        self.first = (PLACES - self.count) / 2;
        for (place, bond) in (self.first..).zip(bonds.iter()) {
            self.strains[place] = bond.strain - self.moved;
            self.numbers[place] = bond.number as u8;
            self.draws[bond.number] = bond.draws as u64;
        }
        self.sum = bonds.iter().map(|bond| bond.strain).sum();
    }

    /// Lets those that have used no random number take a stationary strain when the motion begins.
    pub(crate) fn waiting(self) -> Bonds {
        Bonds { waits: self.draws[..self.count].contains(&0), ..self }
    }

    /// The bonds in use.
    pub fn iter(&self) -> impl Iterator<Item = Bond> + '_ {
        (self.first..self.first + self.count).map(|place| {
            let number = usize::from(self.numbers[place]);
            Bond { number, strain: self.strains[place] + self.moved, draws: self.draws[number] as f64 }
        })
    }

    /// Strain of the first one.
    pub fn first(&self) -> f64 {
        self.iter().find(|bond| bond.number == 0).map_or(0.0, |bond| bond.strain)
    }

    /// Energy dissipated before the present step.
    pub fn energy(&self) -> f64 {
        self.energy
    }

    /// Whether the bonds wait for the motion.
    pub fn waits(&self) -> bool {
        self.waits
    }

    /// Distances, backwards and forwards, after which the next bond snaps.
    pub fn rooms(&self) -> [f64; 2] {
        let [least, most] = [0, self.count - 1].map(|at| self.strains[self.first + at] + self.moved);
        [self.surface.limit + least, self.surface.limit - most].map(|room| room.max(0.0))
    }

    /// Moves the surfaces, by no more than there is room.
    pub fn advance(&mut self, displacement: f64) {
        let change = self.count as f64 * displacement;
        self.area += displacement * (self.sum + 0.5 * change);
        self.sum += change;
        self.moved += displacement;
    }

    /// Moves the surfaces forwards, or backwards, as far as there is room, and lets the bond snap that has no room left.
    /// Returns by how much the mean strain jumps.
    pub fn snap(&mut self, is_forwards: bool) -> f64 {
        let [back, forth] = self.rooms();
        self.advance(if is_forwards { forth } else { -back });
        let place = if is_forwards { self.first + self.count - 1 } else { self.first };
        let (before, number) = (self.strains[place], self.numbers[place]);
        let bond = usize::from(number);
        let lost = self.surface.span * uniform_of(self.keys[bond], self.draws[bond]);
        self.draws[bond] += 1;
        let strain = self.surface.limit - lost;
        let strain = if is_forwards { strain } else { -strain } - self.moved;
        let place = self.make_room(strain, is_forwards);
        (self.strains[place], self.numbers[place]) = (strain, number);
        self.sum += strain - before;
        (strain - before) * self.share
    }

    /// Moves the bonds that are strained less in the direction of motion by one place. Returns that of the one that snaps.
    fn make_room(&mut self, strain: f64, is_forwards: bool) -> usize {
        let last = self.first + self.count - 1;
        if self.first == 0 || last + 1 == PLACES {
            self.centre();
            return self.make_room(strain, is_forwards);
        }
        let mut place = if is_forwards { self.first } else { last };
        if is_forwards {
            while place < last && self.strains[place] < strain {
                (self.strains[place - 1], self.numbers[place - 1]) = (self.strains[place], self.numbers[place]);
                place += 1;
            }
            self.first -= 1;
            return place - 1;
        }
        while place > self.first && self.strains[place] > strain {
            (self.strains[place + 1], self.numbers[place + 1]) = (self.strains[place], self.numbers[place]);
            place -= 1;
        }
        self.first += 1;
        place + 1
    }

    #[cold]
    fn centre(&mut self) {
        let (middle, all) = ((PLACES - self.count) / 2, self.first..self.first + self.count);
        self.strains.copy_within(all.clone(), middle);
        self.numbers.copy_within(all, middle);
        self.first = middle;
    }

    /// Begins a motion for which bonds have waited. Returns by how much the mean strain changes.
    pub fn begin(&mut self, is_forwards: bool) -> f64 {
        let (direction, before) = (if is_forwards { 1.0 } else { -1.0 }, self.sum);
        let mut room = [Bond::default(); MOST_BONDS];
        for (place, mut bond) in room.iter_mut().zip(self.iter()) {
            if bond.draws == 0.0 {
                bond.strain = direction * self.surface.stationary(bond.number, &mut bond.draws);
            }
            *place = bond;
        }
        self.put(&mut room[..self.count]);
        self.waits = false;
        (self.sum - before) * self.share
    }

    /// The bonds as a row has them after a step, with the work of the step as energy: by the mean of the loads at its
    /// ends, of which only the stiffness depends.
    pub fn renewed(&self, row: Bonds) -> Bonds {
        Bonds { energy: self.energy + 0.5 * (self.stiffness + row.stiffness) * self.area, ..row }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bonds(strains: &[f64]) -> Bonds {
        let surface = Surface { limit: 1.0, span: 1.5, seed: 3.0 };
        let bond = |(number, strain): (usize, &f64)| Bond { number, strain: *strain, draws: 0.0 };
        Bonds::new(surface, 2.0, 0.0, strains.iter().enumerate().map(bond))
    }

    /// Back and forth, each bond by itself: it snaps where its own strain reaches the limit.
    #[test]
    fn the_next_bond_is_the_one_that_reaches_its_limit_first() {
        for forwards in [60, 30] {
            back_and_forth(forwards);
        }
    }

    /// 600 snaps, so many of 90 forwards: the order moves on until no place is left.
    fn back_and_forth(forwards: u32) {
        let mut bonds = bonds(&[0.3, -0.9, 0.0, 0.8, -0.2]);
        let mut alone: Vec<Bond> = bonds.iter().collect();
        let (mut sum, mut area) = (0.0, 0.0);
        for snap in 0..600 {
            let is_forwards = snap % 90 < forwards;
            let direction = if is_forwards { 1.0 } else { -1.0 };
            let room = |bond: &Bond| 1.0 - direction * bond.strain;
            let next = (0..5).min_by(|a, b| room(&alone[*a]).total_cmp(&room(&alone[*b]))).unwrap();
            let distance = room(&alone[next]);
            assert!((bonds.rooms()[usize::from(is_forwards)] - distance).abs() < 1e-12, "{snap}");
            let before: f64 = alone.iter().map(|bond| bond.strain).sum();
            alone.iter_mut().for_each(|bond| bond.strain += direction * distance);
            let after: f64 = alone.iter().map(|bond| bond.strain).sum();
            area += direction * distance * 0.5 * (before + after);
            let lost = 1.5 * uniform(3, alone[next].number as u64, alone[next].draws as u64);
            alone[next].strain -= direction * lost;
            alone[next].draws += 1.0;
            sum += bonds.snap(is_forwards) * 5.0 + direction * lost;
            for bond in bonds.iter() {
                let expected = alone.iter().find(|other| other.number == bond.number).unwrap();
                assert!((bond.strain - expected.strain).abs() < 1e-12 && bond.draws == expected.draws, "{snap}");
            }
        }
        assert!(sum.abs() < 1e-11 && (bonds.area - area).abs() < 1e-10, "{sum} {} {area}", bonds.area);
        let row = Bonds::new(bonds.surface, 4.0, 7.0, bonds.iter());
        assert!((bonds.renewed(row).energy() - 3.0 * area).abs() < 1e-9);
    }

    /// 10,000 stationary strains: mean 1 - span / 3 and variance span^2 / 18, within 4 standard errors.
    #[test]
    fn bonds_that_waited_are_strained_in_the_direction_of_the_motion() {
        for is_forwards in [true, false] {
            let (mut mean, mut square, n) = (0.0, 0.0, 10_000.0);
            for seed in 0..200 {
                let mut bonds = bonds(&[0.0; 50]).waiting();
                bonds.surface.seed = f64::from(seed);
                let change = bonds.begin(is_forwards);
                assert!(!bonds.waits() && (change * 50.0 - bonds.sum).abs() < 1e-12);
                mean += bonds.iter().map(|bond| bond.strain / n).sum::<f64>();
                square += bonds.iter().map(|bond| bond.strain * bond.strain / n).sum::<f64>();
            }
            let (expected, variance) = (if is_forwards { 0.5 } else { -0.5 }, 1.5 * 1.5 / 18.0);
            assert!((mean - expected).abs() < 4.0 * (variance / n).sqrt(), "{mean}");
            assert!((square - mean * mean - variance).abs() < 4.0 * variance / (0.5 * n).sqrt(), "{square}");
        }
    }
}
