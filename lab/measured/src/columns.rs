//! Columns of records: their names in files, and factors for signals in other units.

use crate::drive::Drive;
use crate::error::MeasuredError;
use crate::movement::Movement;
use crate::record::Setup;
use crate::units;
use stribeck_sheet::{
    CURRENT, DISPLACEMENT, FORCE, MOMENT, NORMAL_FORCE, Quantity, Sheet, SheetError, TIME, VELOCITY, check_names,
};

/// Quantities of a record.
const QUANTITIES: [&Quantity; 5] = [&TIME, &FORCE, &DISPLACEMENT, &VELOCITY, &NORMAL_FORCE];

/// Names that a column may have besides that of its quantity. Single letters are case-sensitive, longer names are not.
fn others(quantity: &Quantity) -> &'static [&'static str] {
    match quantity.name {
        "time" => &["t"],
        "force" => &["F", "drive_force", "load_cell"],
        "displacement" => &["x", "q", "qm", "pos", "position", "disp", "stroke", "joint_position"],
        "velocity" => &["v", "vel", "speed", "qd", "dq", "joint_velocity"],
        "normal_force" => &["N", "Fn", "f_n", "Fz", "f_z"],
        _ => &[],
    }
}

/// Names that the torque of a joint may have.
const TORQUES: [&str; 6] = ["torque", "tau", "moment", "friction_torque", "joint_torque", "motor_torque"];

/// Names that count where no column has one of the others: those of the motion are of a joint.
fn later(quantity: &Quantity) -> &'static [&'static str] {
    match quantity.name {
        "force" => &["friction", "friction_force", "effort"],
        "displacement" => &["angle", "theta", "phi", "joint_angle", "angular_position"],
        "velocity" => &["omega", "angular_velocity", "angular_speed"],
        _ => &[],
    }
}

/// Names of signals that are proportional to a force; they need a factor.
const SIGNALS: [&str; 6] = ["u", "i", "vir", "voltage", "current", "torque"];

/// Names of the current of a motor.
const CURRENTS: [&str; 3] = ["i", "current", "motor_current"];

/// Choice of the columns by the user.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// Quantities and the columns that have them.
    pub names: Vec<(String, String)>,
    /// Quantities and the factors of their columns.
    pub factors: Vec<(String, f64)>,
    /// Motor and gear of a joint, which give factors as well.
    pub drive: Drive,
    /// Whether the body turns, as the user says: columns without a unit are then those of a joint.
    pub is_joint: bool,
    /// Further quantities that are read where a record has them, each in a column of its name.
    pub further: Vec<Quantity>,
}

impl Columns {
    /// Whether a record may have a quantity of this name.
    pub fn knows(&self, name: &str) -> bool {
        self.quantities().any(|known| known.name == name)
    }

    fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        QUANTITIES.into_iter().chain(&self.further)
    }

    fn is_further(&self, name: &str) -> bool {
        self.further.iter().any(|known| known.name.eq_ignore_ascii_case(name))
    }

    /// Rejects quantities that no record has, factors that are 0 or not finite, and two for one column.
    pub fn check(&self) -> Result<(), MeasuredError> {
        check_names(&self.names, &self.quantities().collect::<Vec<_>>())?;
        if let Some((name, _)) = self.factors.iter().find(|(name, _)| !self.knows(name)) {
            let wanted = self.quantities().map(|quantity| quantity.name).collect::<Vec<_>>().join(", ");
            return Err(SheetError::Quantity { name: name.clone(), wanted }.into());
        }
        if let Some((name, factor)) = self.factors.iter().find(|(_, factor)| !(factor.is_finite() && *factor != 0.0)) {
            return Err(SheetError::Factor { name: name.clone(), factor: *factor }.into());
        }
        self.drive.check()?;
        match self.factors.iter().find(|(name, _)| self.drive.factor(name).is_some()) {
            Some((name, _)) => Err(MeasuredError::TwoFactors { name: name.clone() }),
            None => Ok(()),
        }
    }

    /// Names the columns of the tables of a record after their quantities and applies the factors; returns a note for each
    /// column that was called otherwise. `motion` are the tables of the motion if it has some of its own. A normal force
    /// is looked up only where none is known, and not for an axis.
    pub fn apply(
        &self,
        record: &mut [Sheet],
        motion: &mut [Sheet],
        setup: &Setup,
    ) -> Result<Vec<String>, MeasuredError> {
        self.rename(record, motion)?;
        let is_apart = !motion.is_empty();
        let of_motion = |error: MeasuredError| if is_apart { MeasuredError::of_motion(error) } else { error };
        let read = record.iter().chain(&*motion).filter_map(Sheet::note);
        let mut notes: Vec<String> = read.map(str::to_owned).collect();
        for table in &mut *record {
            notes.extend(self.find(std::slice::from_mut(table), &TIME)?);
        }
        for table in &mut *motion {
            notes.extend(self.find(std::slice::from_mut(table), &TIME).map_err(MeasuredError::of_motion)?);
        }
        let moving = if is_apart { &mut *motion } else { &mut *record };
        let of_moving = self.find_motion(moving, setup.has_gravity).map_err(|error| of_motion(error.into()))?;
        notes.extend(self.find_torque(record, motion)?);
        notes.extend(self.find(record, &FORCE)?);
        notes.extend(of_moving);
        let movement = self.movement(record, motion)?;
        if setup.normal_force.is_none() && !setup.is_axis {
            notes.extend(self.find(record, &NORMAL_FORCE)?);
        }
        notes.extend(self.assumed_units(record, motion, movement));
        self.scale(record, motion, movement)?;
        for table in if is_apart { motion } else { record } {
            notes.extend(units::motion(table, movement).map_err(of_motion)?);
        }
        Ok(notes)
    }

    /// Whether tables have force and velocity, but neither a time nor a displacement: a map of friction.
    pub fn are_of_map(&self, tables: &[Sheet]) -> bool {
        let is_named = |quantity: &Quantity| self.names.iter().any(|(name, _)| name == quantity.name);
        let has = |quantity: &Quantity| {
            let is_it = |name: &str| name.eq_ignore_ascii_case(quantity.name) || is_among(name, others(quantity));
            is_named(quantity) || tables.iter().any(|table| table.names().any(is_it))
        };
        let has_later = |quantity| tables.iter().any(|table| table.names().any(|name| is_among(name, later(quantity))));
        let is_signal = |name: &str| is_among(name, &SIGNALS) || is_among(name, &TORQUES);
        let has_signal = || tables.iter().any(|table| table.names().any(is_signal));
        tables.len() == 1
            && (has(&VELOCITY) || has_later(&VELOCITY))
            && (has(&FORCE) || has_later(&FORCE) || has_signal())
            && !has(&TIME)
            && !has(&DISPLACEMENT)
    }

    /// As [`Columns::apply`] for a map; returns whether its body slides or turns as well.
    pub fn apply_to_map(&self, table: &mut Sheet, setup: &Setup) -> Result<(Movement, Vec<String>), MeasuredError> {
        let tables = std::slice::from_mut(table);
        self.rename(tables, &mut [])?;
        let mut notes: Vec<String> = tables[0].note().map(str::to_owned).into_iter().collect();
        notes.extend(self.find(tables, &VELOCITY)?);
        notes.extend(self.find_torque(tables, &[])?);
        notes.extend(self.find(tables, &FORCE)?);
        let movement = self.movement(tables, &[])?;
        if setup.normal_force.is_none() {
            notes.extend(self.find(tables, &NORMAL_FORCE)?);
        }
        notes.extend(self.assumed_units(tables, &[], movement));
        self.scale(tables, &mut [], movement)?;
        Ok((movement, notes))
    }

    /// Renames the columns that the user has named.
    fn rename(&self, record: &mut [Sheet], motion: &mut [Sheet]) -> Result<(), MeasuredError> {
        for (name, column) in &self.names {
            if !record.iter().chain(&*motion).any(|table| table.has(column)) {
                return Err(record.first().map_or(SheetError::Empty, |table| table.missing(column)).into());
            }
            record.iter_mut().chain(&mut *motion).for_each(|table| table.rename(column, name));
        }
        Ok(())
    }

    fn scale(&self, record: &mut [Sheet], motion: &mut [Sheet], movement: Movement) -> Result<(), MeasuredError> {
        for name in &self.drive.motor_side {
            if !record.iter().chain(&*motion).any(|table| table.has(name)) {
                return Err(record.first().map_or(SheetError::Empty, |table| table.missing(name)).into());
            }
        }
        let signals = movement.signals();
        for (name, factor) in &self.factors {
            for quantity in self.quantities().filter(|quantity| quantity.name == name) {
                let quantity = movement.quantity(quantity);
                record.iter_mut().chain(&mut *motion).for_each(|table| table.scale(&quantity, &signals, *factor));
            }
        }
        for quantity in QUANTITIES {
            let Some(factor) = self.drive.factor(quantity.name) else { continue };
            let (turned, is_force) = (movement.quantity(quantity), quantity.name == FORCE.name);
            let own = if is_force && self.drive.torque_constant.is_some() { &CURRENT } else { &turned };
            for table in record.iter_mut().chain(&mut *motion) {
                table.convert(quantity.name, own, factor, turned.units[0].0)?;
            }
        }
        if self.is_joint { with_units(record.iter_mut().chain(motion), movement) } else { Ok(()) }
    }

    /// Whether a factor turns a signal into a quantity; one of -1 turns only its sign, and a gear turns the quantities of a
    /// motor into those of a joint.
    fn is_scaled(&self, quantity: &Quantity) -> bool {
        let is_current = quantity.name == FORCE.name && self.drive.torque_constant.is_some();
        is_current || self.given(quantity).is_some_and(|factor| factor.abs() != 1.0)
    }

    /// Whether the body turns whatever the units.
    fn turns(&self) -> bool {
        self.is_joint || self.drive.is_known()
    }

    /// Whether the body slides or turns, by the units of the columns that are not signals.
    fn movement(&self, record: &[Sheet], motion: &[Sheet]) -> Result<Movement, MeasuredError> {
        match self.told(record, motion)? {
            Some((Movement::Translation, column)) if self.turns() => Err(MeasuredError::NoJoint { column }),
            Some((movement, _)) => Ok(movement),
            None if self.turns() => Ok(Movement::Rotation),
            None => self.named_by_a_joint(if motion.is_empty() { record } else { motion }),
        }
    }

    /// Refuses an angle by its name where no unit tells what turns or slides: it might be in degrees.
    fn named_by_a_joint(&self, moving: &[Sheet]) -> Result<Movement, MeasuredError> {
        let of = |quantity: &&Quantity| {
            let own =
                moving.iter().find(|table| table.has(quantity.name)).map(|table| table.own_name(quantity.name))?;
            let is_named = self.names.iter().any(|(_, column)| column == own);
            let is_it = is_among(own, later(quantity)) && !is_named && !self.is_scaled(quantity);
            is_it.then(|| MeasuredError::no_units(own, quantity.name))
        };
        [&DISPLACEMENT, &VELOCITY].iter().find_map(of).map_or(Ok(Movement::Translation), Err)
    }

    /// The movement that the units tell, with the first column that tells it.
    fn told(&self, record: &[Sheet], motion: &[Sheet]) -> Result<Option<(Movement, String)>, MeasuredError> {
        let [record, motion] = [record, motion].map(|tables| tables.iter().collect::<Vec<_>>());
        Movement::told(&record, &motion, |quantity| !self.is_scaled(quantity))
    }

    /// Refuses a column that is a torque by its name where no unit tells what turns or slides.
    fn refuse_without_units(&self, record: &[Sheet], motion: &[Sheet]) -> Result<(), MeasuredError> {
        if self.turns() || self.told(record, motion)?.is_some() {
            return Ok(());
        }
        let of = |table: &Sheet| {
            let is_it = |name: &&str| is_among(name, &TORQUES) && table.unit(name) == Some("");
            table.names().find(is_it).map(str::to_owned)
        };
        match record.iter().find_map(of) {
            Some(column) => Err(MeasuredError::no_units(&column, FORCE.name)),
            None => Ok(()),
        }
    }

    /// Finds the torque of a joint: a column that is one by its unit, or by its name where the motion is that of a joint.
    fn find_torque(&self, record: &mut [Sheet], motion: &[Sheet]) -> Result<Option<String>, MeasuredError> {
        let has_force =
            |table: &Sheet| table.has(FORCE.name) || table.names().any(|name| is_among(name, others(&FORCE)));
        let is_current = self.drive.torque_constant.is_some();
        if is_current || self.given(&FORCE).is_some() || record.iter().any(has_force) {
            return Ok(None);
        }
        let turns = self.movement(record, motion)? == Movement::Rotation;
        self.refuse_without_units(record, motion)?;
        let is_torque = |table: &Sheet, name: &str| {
            let unit = table.unit(name).unwrap_or_default();
            is_among(name, &TORQUES) && (MOMENT.units.iter().any(|known| known.0 == unit) || turns && unit.is_empty())
        };
        let of = |table: &Sheet| -> Vec<String> {
            table.names().filter(|name| is_torque(table, name)).map(str::to_owned).collect()
        };
        let candidates: Vec<String> = record.iter().flat_map(of).collect();
        Ok(self.take(record, &FORCE, &candidates)?)
    }

    /// Factor of a quantity, by the user or by the drive.
    fn factor(&self, quantity: &Quantity) -> Option<f64> {
        self.given(quantity).or_else(|| self.drive.factor(quantity.name))
    }

    fn given(&self, quantity: &Quantity) -> Option<f64> {
        self.factors.iter().find(|(name, _)| name == quantity.name).map(|(_, factor)| *factor)
    }

    /// A note on the quantities that have a unit neither in the file nor by a factor.
    fn assumed_units(&self, record: &[Sheet], motion: &[Sheet], movement: Movement) -> Option<String> {
        let of_motion = if motion.is_empty() { record } else { motion };
        let columns = self.quantities().filter(|quantity| !self.is_scaled(quantity)).flat_map(|quantity| {
            let has_time = quantity.name == TIME.name;
            let is_of_motion = has_time || [DISPLACEMENT.name, VELOCITY.name].contains(&quantity.name);
            let record = record.iter().filter(move |_| !is_of_motion || has_time);
            let motion = of_motion.iter().filter(move |_| is_of_motion);
            record.chain(motion).map(move |table| (table, movement.quantity(quantity)))
        });
        units::assumed(&columns.collect::<Vec<_>>())
    }

    /// Finds the columns of the motion by their other names, unless one has its own; the angle of an arm in any case.
    fn find_motion(&self, tables: &mut [Sheet], needs_angle: bool) -> Result<Vec<String>, SheetError> {
        let has = |quantity: &Quantity| tables.iter().any(|table| table.has(quantity.name));
        if has(&DISPLACEMENT) || has(&VELOCITY) && !needs_angle {
            return Ok(Vec::new());
        }
        let notes = [self.find(tables, &DISPLACEMENT)?, self.find(tables, &VELOCITY)?];
        Ok(notes.into_iter().flatten().collect())
    }

    /// Finds the column of a quantity by its other names, renames it and returns a note.
    fn find(&self, tables: &mut [Sheet], quantity: &Quantity) -> Result<Option<String>, SheetError> {
        if tables.iter().any(|table| table.has(quantity.name)) {
            return Ok(None);
        }
        let of = |names: &[&str]| -> Vec<String> {
            let all = tables.iter().flat_map(|table| table.names().filter(|name| is_among(name, names)));
            all.map(str::to_owned).collect()
        };
        let mut candidates = of(others(quantity));
        if candidates.is_empty() {
            candidates = of(later(quantity));
        }
        if quantity.name == FORCE.name && candidates.is_empty() {
            candidates = of(if self.drive.torque_constant.is_some() { &CURRENTS } else { &SIGNALS });
            candidates.retain(|name| !self.is_further(name));
            if let ([column], None) = (candidates.as_slice(), self.factor(quantity)) {
                return Err(SheetError::NoFactor { column: column.clone() });
            }
        }
        self.take(tables, quantity, &candidates)
    }

    /// Renames the only candidate for a quantity and returns a note.
    fn take(
        &self,
        tables: &mut [Sheet],
        quantity: &Quantity,
        candidates: &[String],
    ) -> Result<Option<String>, SheetError> {
        match candidates {
            [] => Ok(None),
            [column] => {
                tables.iter_mut().for_each(|table| table.rename(column, quantity.name));
                let times = self.factor(quantity).map_or(String::new(), |factor| format!(", times {factor}"));
                Ok(Some(format!("column '{column}' was taken as {}{times}", quantity.name)))
            }
            _ => Err(SheetError::Ambiguous { wanted: quantity.name.to_owned(), candidates: candidates.join("', '") }),
        }
    }
}

/// Gives columns without a unit that of their quantity, by which the movement is known later.
fn with_units<'a>(tables: impl Iterator<Item = &'a mut Sheet>, movement: Movement) -> Result<(), MeasuredError> {
    for table in tables {
        for quantity in [&FORCE, &DISPLACEMENT, &VELOCITY].map(|quantity| movement.quantity(quantity)) {
            if table.unit(quantity.name) == Some("") {
                table.convert(quantity.name, &quantity, 1.0, quantity.units[0].0)?;
            }
        }
    }
    Ok(())
}

fn is_among(name: &str, names: &[&str]) -> bool {
    let name = name.replace([' ', '-'], "_");
    names.iter().any(|known| if known.len() == 1 { *known == name } else { known.eq_ignore_ascii_case(&name) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn applied(text: &str, factors: &[(&str, f64)]) -> (Result<Vec<String>, String>, Vec<Sheet>) {
        let mut tables = vec![Sheet::parse(text).unwrap()];
        let factors = factors.iter().map(|(name, factor)| ((*name).to_owned(), *factor)).collect();
        let columns = Columns { factors, ..Columns::default() };
        let said = columns.apply(&mut tables, &mut [], &Setup::default()).map_err(|error| error.to_string());
        (said, tables)
    }

    #[test]
    fn usual_names_are_taken_and_said() {
        let (said, tables) = applied("t [ms];qm;vir [V];qg\n1;2;3;4\n", &[("force", 35.15)]);
        let expected =
            ["'t' was taken as time", "'vir' was taken as force, times 35.15", "'qm' was taken as displacement"];
        let said = said.unwrap();
        assert_eq!(said[..3], expected.map(|text| format!("column {text}")));
        assert_eq!(said[3..], ["displacement: no unit in the file, taken as m"]);
        let values = [&TIME, &FORCE, &DISPLACEMENT].map(|quantity| tables[0].column(quantity).unwrap().unwrap()[0]);
        assert_eq!(values, [1e-3, 3.0 * 35.15, 2.0]);
        // A name that says it all leaves the others alone.
        let (said, tables) = applied("time,force,displacement,v,N\n1,2,3,4,5\n", &[("displacement", -1.0)]);
        let units = "time, force, displacement, normal_force: no unit in the file, taken as s, N, m, N";
        assert_eq!(said.unwrap(), ["column 'N' was taken as normal_force", units]);
        assert_eq!(tables[0].column(&DISPLACEMENT).unwrap(), Some(vec![-3.0]));
        assert!(tables[0].column(&VELOCITY).unwrap().is_none());
    }

    /// With a unit, by itself or beside others; alone it might be in degrees.
    #[test]
    fn a_joint_has_an_angle_or_an_angular_velocity() {
        let read = |text: &str| applied(text, &[]).1;
        for heading in ["time,torque [N.m],angle [deg]", "t,Friction torque [N.m],theta [deg]", "t,effort,phi [deg]"] {
            let tables = read(&format!("{heading}\n1,2,90\n"));
            let turned = Movement::Rotation.quantity(&DISPLACEMENT);
            let angle = tables[0].column(&turned).unwrap().unwrap()[0];
            assert!((angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15, "{heading}: {angle}");
        }
        let tables = read("t,torque [N.m],omega [rpm]\n1,2,60\n");
        let speed = tables[0].column(&Movement::Rotation.quantity(&VELOCITY)).unwrap().unwrap()[0];
        assert!((speed - std::f64::consts::TAU).abs() < 1e-15);
        // An angle that stands beside the displacement, such as that of a wheel that steers.
        let tables = read("t,F,x [mm],angle [deg],friction\n1,2,3,4,5\n");
        assert_eq!(tables[0].column(&DISPLACEMENT).unwrap(), Some(vec![3e-3]));
        assert_eq!(tables[0].column(&FORCE).unwrap(), Some(vec![2.0]));
        for (text, column, otherwise) in [
            ("t,force,angle\n1,2,3\n", "angle", "--column displacement=angle takes it as a displacement in m"),
            ("t,force,omega\n1,2,3\n", "omega", "--column velocity=omega takes it as a velocity in m/s"),
            ("t,torque,theta\n1,2,3\n", "theta", "--column displacement=theta takes it as a displacement in m"),
            ("t,torque,x\n1,2,3\n", "torque", "--column force=torque takes it as a force in N"),
        ] {
            let refusal = applied(text, &[]).0.unwrap_err();
            assert!(
                refusal.starts_with(&format!("'{column}' may be the ")) && refusal.ends_with(otherwise),
                "{refusal}"
            );
        }
        assert_eq!(applied("t,force,angle\n1,2,3\n", &[("displacement", 0.1)]).0.err(), None);
        let mut tables = [Sheet::parse("t,force,angle\n1,2,3\n").unwrap()];
        let names = vec![("displacement".to_owned(), "angle".to_owned())];
        Columns { names, ..Columns::default() }.apply(&mut tables, &mut [], &Setup::default()).unwrap();
        assert_eq!(tables[0].column(&DISPLACEMENT).unwrap(), Some(vec![3.0]));
        let mut tables = [Sheet::parse("t,torque,angle\n1,2,3\n").unwrap()];
        Columns { is_joint: true, ..Columns::default() }.apply(&mut tables, &mut [], &Setup::default()).unwrap();
        assert_eq!(tables[0].column(&Movement::Rotation.quantity(&DISPLACEMENT)).unwrap(), Some(vec![3.0]));
    }

    /// A camera has no force, whatever its columns are called, and a column is named in the table that has it.
    #[test]
    fn a_table_of_the_motion_needs_no_force() {
        let tables = || ["t,Kraft,x\n1,2,3\n", "time,displacement,i\n4,5,6\n"].map(|text| Sheet::parse(text).unwrap());
        let named = |name: &str, column: &str| Columns {
            names: vec![(name.to_owned(), column.to_owned())],
            ..Columns::default()
        };
        let [mut record, mut motion] = tables().map(|table| [table]);
        let said = named("force", "Kraft").apply(&mut record, &mut motion, &Setup::default()).unwrap();
        let units = "time, force, displacement: no unit in the file, taken as s, N, m";
        assert_eq!(said, ["column 't' was taken as time", units]);
        assert_eq!(record[0].column(&FORCE).unwrap(), Some(vec![2.0]));
        assert_eq!(motion[0].column(&DISPLACEMENT).unwrap(), Some(vec![5.0]));
        assert!(motion[0].column(&FORCE).unwrap().is_none());
        let [mut record, mut motion] = tables().map(|table| [table]);
        let error = named("force", "Kraf").apply(&mut record, &mut motion, &Setup::default()).unwrap_err().to_string();
        assert_eq!(error, "no column 'Kraf'; there are t, Kraft, x");
    }

    /// So that the user looks into the right file.
    #[test]
    fn what_is_wrong_with_the_motion_is_said_of_the_motion() {
        let refusal = |motion: &str| {
            let [mut record, mut motion] = ["time,force\n1,2\n", motion].map(|text| [Sheet::parse(text).unwrap()]);
            let said = Columns::default().apply(&mut record, &mut motion, &Setup::default());
            said.unwrap_err().to_string()
        };
        assert_eq!(
            refusal("time,x,pos\n1,2,3\n"),
            "the motion: displacement: 'x', 'pos' may be it; say which: --column displacement=..."
        );
        assert!(refusal("time,v,speed\n1,2,3\n").starts_with("the motion: velocity: "));
    }

    /// Its column N may be a counter, and it needs no normal force.
    #[test]
    fn an_axis_has_a_normal_force_only_if_it_is_named() {
        let axis = Setup { is_axis: true, ..Setup::default() };
        let named = Columns { names: vec![("normal_force".into(), "N".into())], ..Columns::default() };
        let known = Setup { normal_force: Some(2.0), ..Setup::default() };
        let cases = [
            (Columns::default(), &axis, None),
            (named, &axis, Some(vec![4.0])),
            (Columns::default(), &Setup::default(), Some(vec![4.0])),
            (Columns::default(), &known, None),
        ];
        for (columns, rig, expected) in cases {
            let mut tables = [Sheet::parse("t,F,x,N\n1,2,3,4\n").unwrap()];
            columns.apply(&mut tables, &mut [], rig).unwrap();
            assert_eq!(tables[0].column(&NORMAL_FORCE).unwrap(), expected, "{columns:?}, {rig:?}");
        }
    }

    #[test]
    fn what_is_ambiguous_or_not_a_force_is_refused() {
        let refusals = [
            ("t,F,q,x\n1,2,3,4\n", &[][..], "displacement: 'q', 'x' may be it; say which: --column displacement=..."),
            (
                "t,u,x\n1,2,3\n",
                &[],
                "'u' may be the force, but not in N: give the factor to N, --scale force=..., or --column",
            ),
            ("t,V,x\n1,2,3\n", &[], ""),
        ];
        for (text, factors, part) in refusals {
            let (said, tables) = applied(text, factors);
            match said {
                Err(error) => assert!(!part.is_empty() && error.contains(part), "{text}: {error}"),
                Ok(_) => assert!(part.is_empty() && tables[0].column(&FORCE).unwrap().is_none(), "{text}"),
            }
        }
        // Moments, percentages and angles of a drive become forces and displacements by their factors.
        for heading in ["t,torque [Nm],q [rad]", "t,current [%],pos (deg)"] {
            let factors = [("force", 12.0), ("displacement", 0.5)];
            let (said, tables) = applied(&format!("{heading}\n1,2,3\n"), &factors);
            assert_eq!(said.unwrap()[3..], ["time: no unit in the file, taken as s"]);
            let values = [&FORCE, &DISPLACEMENT].map(|quantity| tables[0].column(quantity).unwrap().unwrap()[0]);
            assert_eq!(values, [24.0, 1.5], "{heading}");
        }
        // A factor does not turn a length into a force.
        let (_, tables) = applied("t,F [mm],x\n1,2,3\n", &[("force", 2.0)]);
        let error = tables[0].column(&FORCE).unwrap_err().to_string();
        assert_eq!(error, "force: unit 'mm', must be one of N, kN, lbf, lb");
        for (columns, part) in [
            (Columns { factors: vec![("force".into(), 0.0)], ..Columns::default() }, "must be finite and not 0"),
            (
                Columns { names: vec![("forces".into(), "F".into())], ..Columns::default() },
                "'forces': must be one of time",
            ),
        ] {
            assert!(columns.check().unwrap_err().to_string().contains(part));
        }
    }

    #[test]
    fn a_quantity_has_one_column() {
        let names = [("force", "A"), ("force", "B")].map(|(name, column)| (name.to_owned(), column.to_owned()));
        let columns = Columns { names: names.into(), ..Columns::default() };
        assert_eq!(columns.check().unwrap_err().to_string(), "column force = B: force is A already");
    }
}
