//! Values for variables of one model, with a name: checked against the model's table, written and read as CSV and as
//! SSP 1.0 parameter set (`.ssv`).

mod ssv;

use std::fs;
use std::path::{Path, PathBuf};

use stribeck::instance::Phase;
use stribeck::model::{Fault, Kind, ModelType, Variable};
use stribeck::unit::DisplayUnit;
use thiserror::Error;

use crate::units::unit_of;

/// Values for variables of one model, all of which the model accepts.
///
/// ```
/// use ssp::parameter_set::ParameterSet;
/// let lugre = stribeck::catalogue::by_name("LuGre").unwrap();
/// let set = ParameterSet::new(lugre, "rubber", [("mu_s", 0.9), ("mu_k", 0.8)])?;
/// assert_eq!(set.to_csv(), "variable,value,unit\nmu_s,0.9,1\nmu_k,0.8,1\n");
/// assert_eq!(ParameterSet::from_csv(lugre, "rubber", &set.to_csv())?, set);
/// # Ok::<(), ssp::parameter_set::SetError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterSet {
    model: &'static ModelType,
    name: String,
    /// Column and value, in the order in which they were given.
    values: Vec<(usize, f64)>,
}

/// Reason why a set was rejected.
#[derive(Debug, Error)]
pub enum SetError {
    /// The model has no such variable.
    #[error("{model} has no variable '{name}'")]
    Unknown {
        /// The model.
        model: &'static str,
        /// The requested name.
        name: String,
    },
    /// The variable is a result.
    #[error("{model} computes '{name}': it cannot be set")]
    Computed {
        /// The model.
        model: &'static str,
        /// The variable.
        name: String,
    },
    /// The name of the set has characters that no XML file can hold.
    #[error("the set's name {0:?}: must have no control characters")]
    Name(String),
    /// The variable occurs twice.
    #[error("'{0}' is given twice")]
    Twice(String),
    /// The text is not a value of this variable.
    #[error("{name} = '{text}': must be {wanted}")]
    Kind {
        /// The variable.
        name: String,
        /// The given text.
        text: String,
        /// The accepted values.
        wanted: String,
    },
    /// The unit is neither that of the variable nor one of its display units.
    #[error("{name}: unit '{unit}', must be {wanted}")]
    Unit {
        /// The variable.
        name: String,
        /// The given text.
        unit: String,
        /// The accepted values.
        wanted: String,
    },
    /// The value is outside its bound, or values are inconsistent.
    #[error(transparent)]
    Fault(#[from] Fault),
    /// The CSV text is not a parameter set.
    #[error("not a table with the columns variable, value and optionally unit: {0}")]
    Csv(#[from] csv::Error),
    /// The XML text is not a parameter set.
    #[error("not an SSP parameter set:  {0}")]
    Ssv(String),
    /// The file has an unknown extension.
    #[error("{}: the name must end in .csv or .ssv", .0.display())]
    Ending(PathBuf),
    /// The file cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file was read, but its contents were rejected.
    #[error("{}: {source}", path.display())]
    Contents {
        /// The file.
        path: PathBuf,
        /// Why.
        source: Box<SetError>,
    },
}

impl ParameterSet {
    /// A set of values in SI units; choices by their number, Booleans as 0 and 1.
    pub fn new<Name: AsRef<str>>(
        model: &'static ModelType,
        name: &str,
        values: impl IntoIterator<Item = (Name, f64)>,
    ) -> Result<ParameterSet, SetError> {
        let mut columns = Vec::new();
        for (variable, value) in values {
            columns.push((settable(model, variable.as_ref())?, value));
        }
        ParameterSet::of_columns(model, name, columns)
    }

    fn of_columns(model: &'static ModelType, name: &str, values: Vec<(usize, f64)>) -> Result<ParameterSet, SetError> {
        if name.chars().any(|letter| letter.is_control() || matches!(letter, '\u{fffe}' | '\u{ffff}')) {
            return Err(SetError::Name(name.to_owned()));
        }
        let mut row: Vec<f64> = model.table.iter().map(|variable| variable.start).collect();
        let mut given = vec![false; row.len()];
        for &(column, value) in &values {
            let variable = &model.table.at(column);
            if given[column] {
                return Err(SetError::Twice(variable.path.to_string()));
            }
            if !variable.admits(value) {
                return Err(variable.fault(value).into());
            }
            given[column] = true;
            row[column] = value;
        }
        model.check(&row)?;
        Ok(ParameterSet { model, name: name.to_owned(), values })
    }

    /// The set with more values.
    pub fn with<Name: AsRef<str>>(
        &self,
        values: impl IntoIterator<Item = (Name, f64)>,
    ) -> Result<ParameterSet, SetError> {
        let more = ParameterSet::new(self.model, &self.name, values)?;
        ParameterSet::of_columns(self.model, &self.name, [self.values.as_slice(), more.values.as_slice()].concat())
    }

    /// The model.
    pub fn model(&self) -> &'static ModelType {
        self.model
    }

    /// Name of the set.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The variables with their values, in the order in which they were given.
    pub fn values(&self) -> impl Iterator<Item = (Variable, f64)> {
        self.values.iter().map(|(column, value)| (self.model.table.at(*column), *value))
    }

    /// The value that the set has for a variable.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.values().find(|(variable, _)| variable.path.to_string() == name).map(|(_, value)| value)
    }

    /// Start values of variables of a model.
    pub fn starts<const N: usize>(model: &'static ModelType, names: [&str; N]) -> Result<[f64; N], SetError> {
        let mut starts = [0.0; N];
        for (start, name) in starts.iter_mut().zip(names) {
            *start = model.table.at(settable(model, name)?).start;
        }
        Ok(starts)
    }

    /// The set as CSV: variable, value, unit. Choices by their name.
    pub fn to_csv(&self) -> String {
        let mut table = String::from("variable,value,unit\n");
        for (variable, value) in self.values() {
            // Names, numbers and units contain neither commas nor quotes.
            table += &format!("{},{},{}\n", variable.path, text_of(&variable, value), unit_name(&variable));
        }
        table
    }

    /// Reads what [`ParameterSet::to_csv`] writes. The unit may be omitted; display units of the model are converted.
    pub fn from_csv(model: &'static ModelType, name: &str, text: &str) -> Result<ParameterSet, SetError> {
        #[derive(serde::Deserialize)]
        struct Line {
            variable: String,
            value: String,
            #[serde(default)]
            unit: String,
        }
        let mut reader =
            csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(text.as_bytes());
        let mut values = Vec::new();
        for line in reader.deserialize() {
            let Line { variable, value, unit } = line?;
            let column = settable(model, &variable)?;
            values.push((column, value_of(&model.table.at(column), &value, &unit)?));
        }
        ParameterSet::of_columns(model, name, values)
    }

    /// The set as SSP 1.0 parameter set.
    pub fn to_ssv(&self) -> String {
        ssv::write(self)
    }

    /// Reads an SSP 1.0 parameter set; its name is in the file.
    pub fn from_ssv(model: &'static ModelType, text: &str) -> Result<ParameterSet, SetError> {
        ssv::read(model, text)
    }

    /// Writes a file; its extension selects the format.
    pub fn save(&self, path: &Path) -> Result<(), SetError> {
        let text = match Form::of(path)? {
            Form::Csv => self.to_csv(),
            Form::Ssv => self.to_ssv(),
        };
        fs::write(path, text).map_err(|source| SetError::File { path: path.into(), source })
    }

    /// Reads a file; its extension selects the format. A set from a CSV file is named after the file.
    pub fn load(model: &'static ModelType, path: &Path) -> Result<ParameterSet, SetError> {
        let form = Form::of(path)?;
        let text = fs::read_to_string(path).map_err(|source| SetError::File { path: path.into(), source })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let set = match form {
            Form::Csv => ParameterSet::from_csv(model, &name, &text),
            Form::Ssv => ParameterSet::from_ssv(model, &text),
        };
        set.map_err(|source| SetError::Contents { path: path.into(), source: source.into() })
    }
}

/// The format of a file.
enum Form {
    Csv,
    Ssv,
}

impl Form {
    fn of(path: &Path) -> Result<Form, SetError> {
        match path.extension().map(|ending| ending.to_ascii_lowercase()) {
            Some(ending) if ending == "csv" => Ok(Form::Csv),
            Some(ending) if ending == "ssv" => Ok(Form::Ssv),
            _ => Err(SetError::Ending(path.into())),
        }
    }
}

/// The column of a variable that may be set.
fn settable(model: &'static ModelType, name: &str) -> Result<usize, SetError> {
    let unknown = || SetError::Unknown { model: model.name, name: name.to_owned() };
    let column = model.find(name).ok_or_else(unknown)?;
    if !Phase::Setup.admits(&model.table.at(column)) {
        return Err(SetError::Computed { model: model.name, name: name.to_owned() });
    }
    Ok(column)
}

/// A value as text: choices by their name.
pub fn text_of(variable: &Variable, value: f64) -> String {
    match variable.kind {
        Kind::Real(_) | Kind::Integer => value.to_string(),
        Kind::Boolean => (value != 0.0).to_string(),
        Kind::Enumeration(choices) => choices.items[value as usize - 1].name.to_owned(),
    }
}

/// The number of a choice of a variable, by its name.
pub fn choice(model: &'static ModelType, name: &str, choice: &str) -> Result<f64, SetError> {
    value_of(&model.table.at(settable(model, name)?), choice, "")
}

/// Name of the unit; none if the value is not a physical quantity.
fn unit_name(variable: &Variable) -> &'static str {
    unit_of(variable).map_or("", |unit| unit.name)
}

/// The number given by a text, in the variable's own unit.
fn value_of(variable: &Variable, text: &str, unit: &str) -> Result<f64, SetError> {
    let number = match variable.kind {
        Kind::Real(_) => text.parse::<f64>().ok(),
        Kind::Integer => text.parse::<i32>().ok().map(f64::from),
        Kind::Boolean => match text {
            "true" | "1" => Some(1.0),
            "false" | "0" => Some(0.0),
            _ => None,
        },
        Kind::Enumeration(choices) => {
            let at = choices.items.iter().position(|item| item.name == text);
            at.map(|at| at as f64 + 1.0).or_else(|| text.parse::<i32>().ok().map(f64::from))
        }
    };
    let refuse =
        || SetError::Kind { name: variable.path.to_string(), text: text.to_owned(), wanted: wanted_value(variable) };
    let number = number.ok_or_else(refuse)?;
    Ok(display_unit(variable, unit)?.map_or(number, |display| (number - display.offset) / display.factor))
}

/// Description of the texts that are values of this variable.
fn wanted_value(variable: &Variable) -> String {
    match variable.kind {
        Kind::Real(_) => "a number".into(),
        Kind::Integer => "a whole number".into(),
        Kind::Boolean => "true or false".into(),
        Kind::Enumeration(choices) => {
            let names: Vec<&str> = choices.items.iter().map(|item| item.name).collect();
            format!("one of {}", names.join(", "))
        }
    }
}

/// The display unit of that name; none if the name is empty or that of the variable's own unit.
fn display_unit(variable: &Variable, name: &str) -> Result<Option<&'static DisplayUnit>, SetError> {
    if name.is_empty() || name == unit_name(variable) {
        return Ok(None);
    }
    let display = match variable.kind {
        Kind::Real(own) => own.display,
        _ => &[],
    };
    let refuse = || {
        let units = [unit_name(variable)].into_iter().chain(display.iter().map(|display| display.name));
        let units: Vec<&str> = units.filter(|name| !name.is_empty()).collect();
        let wanted = if units.is_empty() { "omitted".into() } else { units.join(" or ") };
        SetError::Unit { name: variable.path.to_string(), unit: name.to_owned(), wanted }
    };
    display.iter().find(|display| display.name == name).map(Some).ok_or_else(refuse)
}

#[cfg(test)]
mod tests {
    use super::*;
    use roxmltree::Document;
    use stribeck::catalogue;

    fn model(name: &str) -> &'static ModelType {
        catalogue::by_name(name).unwrap()
    }

    /// A set with a value of every kind that shipped models have.
    fn karnopp() -> ParameterSet {
        let values = [("mu_s", 0.3), ("mu_k", 1.0 / 3.0 - 0.1), ("exchange", 2.0), ("velocity", -1e-300)];
        ParameterSet::new(model("Karnopp"), "a <b> & \"c\"", values).unwrap()
    }

    fn refusal(set: Result<ParameterSet, SetError>) -> String {
        set.unwrap_err().to_string()
    }

    #[test]
    fn both_formats_preserve_every_bit() {
        let set = karnopp();
        assert_eq!(ParameterSet::from_csv(set.model(), set.name(), &set.to_csv()).unwrap(), set);
        assert_eq!(ParameterSet::from_ssv(set.model(), &set.to_ssv()).unwrap(), set);
        assert_eq!(set.get("mu_s"), Some(0.3));
        assert_eq!(set.get("band"), None);
    }

    #[test]
    fn file_extensions_select_the_format() {
        let folder = tempfile::tempdir().unwrap();
        let set = ParameterSet::new(model("LuGre"), "rubber", [("mu_s", 0.9)]).unwrap();
        for name in ["rubber.csv", "other.SSV"] {
            let path = folder.path().join(name);
            set.save(&path).unwrap();
            assert_eq!(ParameterSet::load(set.model(), &path).unwrap(), set);
        }
        assert!(set.save(Path::new("rubber.txt")).unwrap_err().to_string().contains("must end in .csv or .ssv"));
        let absent = ParameterSet::load(set.model(), &folder.path().join("absent.csv"));
        assert!(refusal(absent).contains("absent.csv: "));
        let wrong = folder.path().join("wrong.csv");
        fs::write(&wrong, "variable,value\nmu,1\n").unwrap();
        assert!(refusal(ParameterSet::load(set.model(), &wrong)).ends_with("wrong.csv: LuGre has no variable 'mu'"));
    }

    /// Another XML parser finds the names, types and units of the standard.
    #[test]
    fn parameter_sets_have_the_elements_of_the_standard() {
        let text = karnopp().to_ssv();
        let document = Document::parse(&text).unwrap();
        let root = document.root_element();
        let values = "http://ssp-standard.org/SSP1/SystemStructureParameterValues";
        assert_eq!(root.tag_name(), (values, "ParameterSet").into());
        assert_eq!([root.attribute("version"), root.attribute("name")], [Some("1.0"), Some("a <b> & \"c\"")]);
        let children: Vec<&str> =
            root.children().filter(|node| node.is_element()).map(|node| node.tag_name().name()).collect();
        assert_eq!(children, ["Parameters", "Units"]);
        let of = |name: &str| {
            let parameter = document.descendants().find(|node| node.attribute("name") == Some(name)).unwrap();
            let value = parameter.first_element_child().unwrap();
            (value.tag_name().name(), value.attribute("value"), value.attribute("unit"))
        };
        assert_eq!(of("mu_s"), ("Real", Some("0.3"), Some("1")));
        assert_eq!(of("exchange"), ("Integer", Some("2"), None));
        let unit = document.descendants().find(|node| node.attribute("name") == Some("m/s")).unwrap();
        assert_eq!(unit.tag_name().name(), "Unit");
        assert_eq!(unit.first_element_child().unwrap().attribute("s"), Some("-1"));
    }

    #[test]
    fn display_units_are_converted_and_choices_may_be_named() {
        let table = "variable, value, unit\n# a seal\nvelocity, 250, mm/s\nexchange, Parallel\nmu_s, 0.2, 1\n";
        let table = table.replace("Parallel", "Parallel,");
        let set = ParameterSet::from_csv(model("Karnopp"), "seal", &table).unwrap();
        assert_eq!([set.get("velocity"), set.get("exchange"), set.get("mu_s")], [Some(0.25), Some(2.0), Some(0.2)]);
        let warm = "variable,value,unit\ntemperature_ambient,20,degC\n";
        let set = ParameterSet::from_csv(model("ShockAbsorber"), "warm", warm).unwrap();
        assert_eq!(set.get("temperature_ambient"), Some(293.15));
        let set = ParameterSet::from_csv(model("Karnopp"), "seal", "variable,value\nexchange,2\n").unwrap();
        assert_eq!(set.get("exchange"), Some(2.0));
        let enumeration = karnopp().to_ssv().replace("ssv:Integer value=\"2\"", "ssv:Enumeration value=\"Parallel\"");
        assert_eq!(ParameterSet::from_ssv(model("Karnopp"), &enumeration).unwrap(), karnopp());
    }

    #[test]
    fn mistakes_are_rejected_with_name_value_and_limit() {
        let read = |line: &str| {
            refusal(ParameterSet::from_csv(model("Karnopp"), "x", &format!("variable,value,unit\n{line}\n")))
        };
        for (line, answer) in [
            ("mu,1,", "Karnopp has no variable 'mu'"),
            ("friction_force,1,N", "Karnopp computes 'friction_force': it cannot be set"),
            ("mu_s,0.2,\nmu_s,0.2,", "'mu_s' is given twice"),
            ("mu_s,high,", "mu_s = 'high': must be a number"),
            ("mu_s,-1,", "mu_s = -1: must be >= 0 and finite"),
            ("mu_s,NaN,", "mu_s = NaN: must be >= 0 and finite"),
            ("exchange,Both,", "exchange = 'Both': must be one of Sequential, Parallel"),
            ("exchange,3,", "exchange = 3: must be >= 1 and <= 2"),
            ("velocity,1,km/h", "velocity: unit 'km/h', must be m/s or mm/s"),
            ("exchange,1,s", "exchange: unit 's', must be omitted"),
        ] {
            assert_eq!(read(line), answer);
        }
        assert!(read("mu_s").starts_with("not a table with the columns variable, value"));
        let fault = ParameterSet::new(model("Karnopp"), "x", [("mu_s", 0.1), ("mu_k", 0.2)]);
        assert!(refusal(fault).contains("mu_s"), "values that do not go together");
        assert!(refusal(ParameterSet::new(model("Karnopp"), "x", [("exchange", 1.5)])).contains("exchange = 1.5"));
    }

    /// Found by fuzzing: a line end in the name became a space when the set was written and read again.
    #[test]
    fn names_that_no_file_can_hold_are_rejected() {
        for name in ["a\nb", "a\t", "\u{1}", "\u{ffff}"] {
            let refused = refusal(ParameterSet::new(model("Karnopp"), name, [("mu_s", 0.3)]));
            assert_eq!(refused, format!("the set's name {name:?}: must have no control characters"));
        }
        let good = karnopp().to_ssv();
        let read = |name: &str| ParameterSet::from_ssv(model("Karnopp"), &good.replace("a &lt;b", name));
        assert!(read("a &#228; b").is_ok());
        assert!(refusal(read("a&#10;b")).contains("no control characters"));
    }

    #[test]
    fn xml_that_is_not_a_parameter_set_is_rejected() {
        let read = |text: &str| refusal(ParameterSet::from_ssv(model("Karnopp"), text));
        let good = karnopp().to_ssv();
        assert!(read("").starts_with("not an SSP parameter set:  "));
        assert!(read(&good[..good.len() / 2]).starts_with("not an SSP parameter set:  "));
        assert!(
            read(&good.replace("version=\"1.0\" name", "version=\"2.0\" name")).contains("version '2.0', must be 1.0")
        );
        assert!(read(&good.replace("ssv:Integer", "ssv:Boolean")).contains("exchange is not of type Boolean"));
        assert!(read(&good.replace("ssv:Integer", "ssv:Binary")).starts_with("not an SSP parameter set:  "));
        assert!(read(&good.replace("ssv:ParameterSet", "ssv:Other")).starts_with("not an SSP parameter set:  "));
    }
}
