//! Errors of a record and of its setup.

use stribeck_sheet::SheetError;

/// Reason why a file is not a record.
#[derive(Debug, thiserror::Error)]
pub enum MeasuredError {
    /// The table cannot be read.
    #[error(transparent)]
    Sheet(#[from] SheetError),
    /// The table of the motion, if that is a file of its own.
    #[error("the motion: {0}")]
    Motion(Box<MeasuredError>),
    /// A value of the setup is out of range.
    #[error("{name} = {value}: must be {wanted}")]
    Setup {
        /// Its name.
        name: &'static str,
        /// The value.
        value: f64,
        /// The condition.
        wanted: String,
    },
    /// Times do not ascend.
    #[error("line {line}, time: {now} s after {before} s; times must ascend")]
    Time {
        /// Line of the file.
        line: u64,
        /// The time.
        now: f64,
        /// The time before it.
        before: f64,
    },
    /// There are too few samples.
    #[error("{count} samples; at least {least} are needed")]
    Short {
        /// Their number.
        count: usize,
        /// How many are needed.
        least: usize,
    },
    /// A channel is constant.
    #[error("{name}: all values are {value}; nothing can be identified from it")]
    Constant {
        /// The channel.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A channel of the motion is noise.
    #[error("{name}: its range, {range:.3e} {unit}, is that of its noise ({noise:.1e} {unit}): nothing moves")]
    Still {
        /// The channel.
        name: &'static str,
        /// Difference between its largest and its least value.
        range: f64,
        /// Standard deviation of its noise.
        noise: f64,
        /// Their unit.
        unit: &'static str,
    },
    /// A normal force is negative.
    #[error("line {line}, normal_force: {value} {unit}; must be >= 0")]
    Load {
        /// Line of the file.
        line: u64,
        /// The value.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A column of the motor, before the gear, is none.
    #[error("motor_side {name}: must be {wanted}")]
    MotorSide {
        /// Name that was given.
        name: String,
        /// Names that are admitted.
        wanted: &'static str,
    },
    /// A column has a factor, and another one by its drive.
    #[error("scale {name} contradicts torque_constant or gear_ratio, which give its factor")]
    TwoFactors {
        /// The quantity.
        name: String,
    },
    /// A joint, or its motor and gear, with a column of a body that slides.
    #[error("{column}: joint, torque_constant and gear_ratio are for bodies that turn, in N.m, rad and rad/s")]
    NoJoint {
        /// The column with its unit.
        column: String,
    },
    /// Column with a name of a joint, in a table without units.
    #[error(
        "'{column}' may be {turned} of a joint, but no column of force and motion has a unit: --joint takes them as N.m, \
         rad and rad/s, other units belong into the heading, velocity [rpm]; --column {quantity}={column} takes it as {slid}"
    )]
    NoUnits {
        /// The column.
        column: String,
        /// Quantity of a record.
        quantity: &'static str,
        /// The quantity of a joint, in words.
        turned: &'static str,
        /// The quantity of a body that slides, in words, with its unit.
        slid: &'static str,
    },
    /// Gravity of a body without an angle.
    #[error("gravity: is fitted to records of a joint, with a column of its angle, in rad or deg")]
    NoAngle,
    /// One column is of a body that slides, another of one that turns.
    #[error(
        "{first} and {second}: one is of a body that slides, the other of one that turns; force, displacement and velocity \
         must be in N, m and m/s, or in N.m, rad and rad/s, or such; --scale NAME=FACTOR turns one into the other"
    )]
    Mixture {
        /// A column with its unit.
        first: String,
        /// The other one.
        second: String,
    },
    /// No normal force is known.
    #[error("no column 'normal_force', and no value was given for it")]
    NoLoad,
    /// The motion ends before the force, or begins after it.
    #[error(
        "force from {} s to {} s, motion from {} s to {} s: they do not overlap",
        force[0], force[1], motion[0], motion[1]
    )]
    Apart {
        /// First and last time of the force.
        force: [f64; 2],
        /// First and last time of the motion.
        motion: [f64; 2],
    },
    /// Displacement and velocity do not belong to one motion.
    #[error(
        "displacement and velocity contradict each other: the displacement changes by {factor} times the integral of the \
         velocity, must be by 0.8 to 1.2 times it: is the unit or the sign of one of them wrong?"
    )]
    Contradiction {
        /// Slope of the displacement over the integral.
        factor: f64,
    },
    /// Numbers are too large or too small, or times too close.
    #[error(
        "{name} at {time} s is {value}: values or intervals of the file are too large or too small to compute with"
    )]
    OutOfRange {
        /// The quantity.
        name: &'static str,
        /// Where, s.
        time: f64,
        /// Outcome.
        value: f64,
    },
    /// No samples are left for the matched filter.
    #[error(
        "no samples are left between rest, reversals and the ends of the record: the body must keep its direction for \
         longer than {} s, the window of the filter, and for {} s on each side, the range of the delay; move it farther \
         or slower, sample faster, or give a shorter window or delay",
        short(*window), short(*tolerance)
    )]
    NoStroke {
        /// Length of the shortest window, s.
        window: f64,
        /// Largest admitted deviation of the delay, s.
        tolerance: f64,
    },
    /// Times in another unit than the file says.
    #[error(
        "time: samples are {} s apart, must be at most {longest} s: the unit of the column belongs into its heading, \
         time [ns], or --scale time=1e-9 turns it into s",
        short(*interval)
    )]
    Interval {
        /// Between two samples, s.
        interval: f64,
        /// The limit, s.
        longest: f64,
    },
    /// Friction would drive the slider.
    #[error(
        "friction gives {energy:.3e} J to the body, at up to {fastest:.4} {}: force and {motion} are positive in \
         opposite directions, or a unit, or the {} of {mass} {}, is wrong",
        units[0], inertia, units[1]
    )]
    Drives {
        /// The energy, J.
        energy: f64,
        /// Largest speed, m/s or rad/s.
        fastest: f64,
        /// Measured quantity of the motion.
        motion: &'static str,
        /// Mass between load cell and contact, kg, or moment of inertia, kg m2.
        mass: f64,
        /// Mass or moment of inertia, in words.
        inertia: &'static str,
        /// Units of the speed and of the inertia.
        units: [&'static str; 2],
    },
}

impl MeasuredError {
    /// An error in the table of the motion.
    pub(crate) fn of_motion(error: impl Into<MeasuredError>) -> MeasuredError {
        MeasuredError::Motion(Box::new(error.into()))
    }

    /// An error about a column with a name of a joint, in a table without units.
    pub(crate) fn no_units(column: &str, quantity: &'static str) -> MeasuredError {
        let (turned, slid) = match quantity {
            "displacement" => ("the angle", "a displacement in m"),
            "velocity" => ("the angular velocity", "a velocity in m/s"),
            _ => ("the torque", "a force in N"),
        };
        MeasuredError::NoUnits { column: column.to_owned(), quantity, turned, slid }
    }
}

/// Rounds to six significant digits, for messages.
pub(crate) fn short(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_texts_are_short() {
        let numbers = [0.008_999_999_999_999_009, 3.9995].map(|value| short(value).to_string());
        assert_eq!(numbers, ["0.009", "3.9995"]);
        assert_eq!(short(-12_345_678.0), -12_345_700.0);
        assert_eq!([0.0, 1e-300].map(short), [0.0, 1e-300]);
    }
}
