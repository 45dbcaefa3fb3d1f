//! Setting and getting variables, by reference or by name: the one place that asks whether a variable may be set now and
//! whether it admits a value.

use std::fmt;

use super::Instance;
use crate::model::{Computed, Fault, Kind, Path, Role, Variable};
use crate::reference::{Place, Reference};

/// Part of an instance's life, as far as it decides which variables may be set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Before a run, and wherever no interface restricts it: everything except results.
    Setup,
    /// Between steps and at events: inputs and tunable parameters.
    Stepping,
    /// Between the events of Model Exchange: inputs and the states that a solver integrates.
    Integrating,
}

impl Phase {
    /// Whether a variable may be set. These are the conditions of FMI 2.0.5, tables in sections 3.2.3 (1, 3, 4 and 5)
    /// and 4.2.4 (1, 3 and 6).
    pub fn admits(self, variable: &Variable) -> bool {
        match variable.role {
            Role::Input => true,
            Role::Tunable => self != Phase::Integrating,
            Role::State | Role::StateOutput if self == Phase::Integrating => variable.is_continuous_state(),
            Role::Fixed | Role::State | Role::StateOutput => self == Phase::Setup,
            Role::Output => false,
        }
    }
}

/// Why a variable was not set or read. Nothing was changed.
#[derive(Debug)]
pub enum Refused {
    /// The model has no such variable.
    Unknown(Fault),
    /// The variable is computed and can never be set, or has no slope.
    NotSettable(Fault),
    /// The variable cannot be set in this [`Phase`].
    NotNow(Path),
    /// The variable does not admit the value.
    Value(Fault),
    /// A result would not be finite.
    NotFinite(Fault),
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Refused::Unknown(fault)
            | Refused::NotSettable(fault)
            | Refused::Value(fault)
            | Refused::NotFinite(fault) => fault.fmt(f),
            Refused::NotNow(path) => write!(f, "{path} cannot be set now"),
        }
    }
}

impl std::error::Error for Refused {}

impl Instance {
    /// The column of a value reference.
    #[inline]
    pub fn column(&self, reference: Reference) -> Result<usize, Refused> {
        match self.model.place(reference) {
            Some(Place::Column(column)) => Ok(column),
            _ => {
                let text = format_args!("{} has no variable with the reference {reference}", self.model.name);
                Err(Refused::Unknown(Fault::new(text)))
            }
        }
    }

    /// The column of the variable with this name.
    pub fn column_by_name(&self, name: &str) -> Result<usize, Refused> {
        let unknown = || Refused::Unknown(Fault::new(format_args!("{} has no variable '{name}'", self.model.name)));
        self.model.find(name).ok_or_else(unknown)
    }

    /// Whether a column may be set to a value in this phase.
    pub fn check_value(&self, phase: Phase, column: usize, value: f64) -> Result<(), Refused> {
        let variable = &self.model.table.at(column);
        if variable.role == Role::Output {
            let text = format_args!("{} is computed and cannot be set", variable.path);
            return Err(Refused::NotSettable(Fault::new(text)));
        }
        if !phase.admits(variable) {
            return Err(Refused::NotNow(variable.path));
        }
        let checked = match self.exchange {
            None => variable.check_for_steps(value),
            Some(_) if variable.admits(value) => Ok(()),
            Some(_) => Err(variable.fault(value)),
        };
        checked.map_err(Refused::Value)
    }

    /// Sets columns: all, or none if one is refused. Outputs follow at once.
    #[inline]
    pub fn set_all(&mut self, phase: Phase, values: impl Iterator<Item = (usize, f64)> + Clone) -> Result<(), Refused> {
        values.clone().try_for_each(|(column, value)| self.check_value(phase, column, value))?;
        values.for_each(|(column, value)| self.write(column, value));
        Ok(())
    }

    /// Sets the variable with this value reference, in the phase [`Phase::Setup`].
    #[inline]
    pub fn set(&mut self, reference: Reference, value: f64) -> Result<(), Refused> {
        self.set_column(self.column(reference)?, value)
    }

    /// Sets the variable with this name, in the phase [`Phase::Setup`].
    pub fn set_by_name(&mut self, name: &str, value: f64) -> Result<(), Refused> {
        self.set_column(self.column_by_name(name)?, value)
    }

    /// Sets the variable of a column, in the phase [`Phase::Setup`].
    #[inline]
    pub fn set_column(&mut self, column: usize, value: f64) -> Result<(), Refused> {
        // The usual one is an input with no rule but its range.
        if !self.model.ports.takes(column, value) {
            self.check_value(Phase::Setup, column, value)?;
        }
        self.write(column, value);
        Ok(())
    }

    /// The variable with this value reference; a result is computed first if it lags behind.
    #[inline]
    pub fn get(&mut self, reference: Reference) -> Result<f64, Refused> {
        self.get_column(self.column(reference)?)
    }

    /// The variable with this name; a result is computed first if it lags behind.
    pub fn get_by_name(&mut self, name: &str) -> Result<f64, Refused> {
        self.get_column(self.column_by_name(name)?)
    }

    /// The variable of a column; a result is computed first if it lags behind.
    #[inline]
    pub fn get_column(&mut self, column: usize) -> Result<f64, Refused> {
        self.refresh_to(self.model.table.needs(column)).map_err(Refused::NotFinite)?;
        Ok(self.row[column])
    }

    /// Gives an input a slope over the next step.
    pub fn set_slope(&mut self, column: usize, slope: f64) -> Result<(), Refused> {
        self.check_slope(column, slope)?;
        self.slopes.set(column, slope);
        Ok(())
    }

    /// Whether a column may have this slope.
    pub fn check_slope(&self, column: usize, slope: f64) -> Result<(), Refused> {
        let variable = &self.model.table.at(column);
        if variable.role != Role::Input || !matches!(variable.kind, Kind::Real(_)) {
            return Err(Refused::NotSettable(Fault::new(format_args!("{} is not an input", variable.path))));
        }
        if !slope.is_finite() {
            let text = format_args!("derivative of {} = {slope}: must be finite", variable.path);
            return Err(Refused::Value(Fault::new(text)));
        }
        Ok(())
    }

    /// Reads Real variables that need no computing. False if there is anything else among them; the values written so
    /// far must then not be used.
    #[inline(always)]
    pub fn read_at_once(&self, references: &[Reference], values: &mut [f64]) -> bool {
        for (reference, value) in references.iter().zip(values) {
            let Some(Place::Column(column)) = self.model.place(*reference) else { return false };
            match self.row.get(column) {
                Some(found) if self.model.ports.gives(column, self.computed) => *value = *found,
                _ => return false,
            }
        }
        true
    }

    /// Sets inputs with no rule but their range to admitted values. False, with nothing changed, if there is anything
    /// else among them.
    #[inline(always)]
    pub fn write_at_once(&mut self, references: &[Reference], values: &[f64]) -> bool {
        for (reference, value) in references.iter().zip(values) {
            let Some(Place::Column(column)) = self.model.place(*reference) else { return false };
            if !self.model.ports.takes(column, *value) {
                return false;
            }
        }
        for (reference, value) in references.iter().zip(values) {
            if let Some(Place::Column(column)) = self.model.place(*reference)
                && let Some(place) = self.row.get_mut(column)
            {
                *place = *value;
            }
        }
        self.computed = Computed::Nothing;
        true
    }

    /// Writes a column that may be set to an admitted value.
    #[inline]
    pub(crate) fn write(&mut self, column: usize, value: f64) {
        self.row[column] = value;
        self.computed = Computed::Nothing;
        self.unchecked |= self.model.table.role(column).is_parameter();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue;

    fn instance(name: &str) -> Instance {
        Instance::new(catalogue::by_name(name).expect("a model"))
    }

    #[test]
    fn refusals_name_variable_value_and_limit() {
        let mut law = instance("LuGre");
        let before = law.save();
        let text = |refused: Result<(), Refused>| refused.expect_err("a refusal").to_string();
        assert_eq!(text(law.set_by_name("mu", 0.2)), "LuGre has no variable 'mu'");
        assert_eq!(text(law.set(7, 0.2)), "LuGre has no variable with the reference 7");
        assert_eq!(text(law.set_by_name("friction_force", 1.0)), "friction_force is computed and cannot be set");
        assert_eq!(text(law.set_by_name("mu_k", -1.0)), "mu_k = -1: must be > 0 and finite");
        assert_eq!(text(law.set_by_name("velocity", f64::NAN)), "velocity = NaN: must be a finite number");
        let mu_k = law.column_by_name("mu_k").expect("a column");
        assert_eq!(text(law.set_slope(mu_k, 1.0)), "mu_k is not an input");
        assert_eq!(text(law.set_slope(0, f64::INFINITY)), "derivative of velocity = inf: must be finite");
        let values = [(0, 0.5), (mu_k, 0.0)];
        assert!(matches!(law.set_all(Phase::Setup, values.into_iter()), Err(Refused::Value(_))));
        assert!(matches!(law.set_all(Phase::Integrating, [(mu_k, 0.2)].into_iter()), Err(Refused::NotNow(_))));
        assert_eq!(law.save(), before, "nothing was changed");
    }

    /// Only an instance for Model Exchange has events, and so the states that they lead to.
    #[test]
    fn steps_admit_no_state_of_an_event() {
        let model = catalogue::by_name("Coulomb").expect("a model");
        let phase = model.find("phase").expect("a state");
        assert!(matches!(Instance::new(model).set_column(phase, 2.0), Err(Refused::Value(_))));
        assert!(Instance::for_model_exchange(model).set_column(phase, 2.0).is_ok());
        assert!(Instance::new(model).at_event().is_err());
    }

    /// The short way of a call on every step and the long way agree about every variable of every model.
    #[test]
    fn both_ways_agree() {
        for model in catalogue::models() {
            let mut instance = Instance::new(model);
            instance.refresh().expect("outputs at the start values");
            for (column, variable) in model.variables() {
                let (reference, mut value) = ([model.reference(column)], [f64::NAN]);
                if instance.read_at_once(&reference, &mut value) {
                    assert_eq!(instance.get(reference[0]).ok(), Some(value[0]), "{} {}", model.name, variable.path);
                }
                for value in [variable.start, 0.5, -1.0, f64::NAN, f64::INFINITY] {
                    let (mut short, mut long) = (Instance::new(model), Instance::new(model));
                    let done = short.write_at_once(&reference, &[value]);
                    let result = long.set_all(Phase::Stepping, [(column, value)].into_iter());
                    assert!(!done || result.is_ok(), "{} {} = {value}", model.name, variable.path);
                    assert!(done || variable.role != Role::Input || result.is_err() || !is_real(&variable));
                    if done {
                        assert_eq!(short.save(), long.save(), "{} {} = {value}", model.name, variable.path);
                    }
                }
            }
        }
    }

    fn is_real(variable: &Variable) -> bool {
        matches!(variable.kind, Kind::Real(_))
    }
}
