//! Runs of systems as programs in C: a master of co-simulation over the models of the C library.

use std::fmt::Write;

use stribeck_solve::couple::{Exchange, Train, hold, is_host};
use stribeck_solve::run::{Configuration, Settings, Solver, run};
use stribeck_solve::system::{Fault, Place, Signal, System, WireSource};

use crate::answer::{Answer, Text};
use crate::solution::assembled;
use crate::values::filled;

/// A program that runs the system with the same steps, the same exchange and the same bits.
pub fn c(chosen: &Configuration, law: Option<&str>) -> Result<Answer, Fault> {
    let (mut system, source) = assembled(chosen, law)?;
    let settings = chosen.settings(&system)?;
    settings.check()?;
    check(&system, &settings)?;
    hold(&mut system, Exchange::Sequential)?;
    let results = chosen.results(&source).into_iter().filter(|name| !name.starts_with("der("));
    let results = results.map(|name| Ok((system.place(&name)?, name))).collect::<Result<Vec<_>, Fault>>()?;
    let course = course(&system, &settings, &results)?;
    let text = Program { system: &system, settings: &settings, results: &results, course: &course }.text()?;
    Ok(Answer::plain(Text { text }))
}

/// Refuses what the program cannot do.
fn check(system: &System, settings: &Settings) -> Result<(), Fault> {
    let refused = |text: std::fmt::Arguments| Err(Fault::value(text));
    if settings.solver != Solver::CoSimulation {
        let solver = settings.solver;
        return refused(format_args!(
            "solver {solver}: a program in C makes steps of the models; choose co-simulation"
        ));
    }
    if settings.master.exchange != Exchange::Sequential || settings.master.jitter != 0.0 {
        return refused(format_args!("exchange, jitter: a program in C has a sequential exchange and equal steps"));
    }
    let steps = settings.until / settings.master.step;
    if moving(system).next().is_some() && steps > MOST_STEPS {
        let until = settings.until;
        return refused(format_args!(
            "until = {until} s: {steps} steps of inputs that move; a program in C has {MOST_STEPS}"
        ));
    }
    let derived = system.wires.iter().find(|wire| matches!(wire.from, WireSource::Derivative(_)));
    derived.map_or(Ok(()), |wire| {
        let name = system.name(wire.to);
        refused(format_args!("{name} is the derivative of a state, which the C library does not give"))
    })
}

/// Steps for which a program has a table of inputs (chosen: 2 MB of text for two inputs).
const MOST_STEPS: f64 = 50_000.0;

/// Inputs that move.
fn moving(system: &System) -> impl Iterator<Item = &(Place, Signal)> {
    system.signals.iter().filter(|(_, signal)| !matches!(signal, Signal::Constant(_)))
}

/// The values of the inputs that move at the beginning of each step.
fn course(system: &System, settings: &Settings, results: &[(Place, String)]) -> Result<Vec<Vec<f64>>, Fault> {
    if moving(system).next().is_none() {
        return Ok(Vec::new());
    }
    let names: Vec<String> = results.iter().map(|(_, name)| name.clone()).collect();
    // Twice as fine, so that every communication point is one of the results.
    let outcome = run(system, &Settings { every: 0.5 * settings.master.step, is_checked: false, ..*settings }, &names)?;
    if !outcome.is_reached() {
        return Err(Fault::value(outcome.end));
    }
    let begins = &outcome.time[..outcome.time.len() - 1];
    Ok(begins.iter().map(|time| moving(system).map(|(_, signal)| signal.at(*time).0).collect()).collect())
}

struct Program<'a> {
    system: &'a System,
    settings: &'a Settings<'a>,
    results: &'a [(Place, String)],
    course: &'a [Vec<f64>],
}

impl Program<'_> {
    fn text(&self) -> Result<String, Fault> {
        let Program { system, settings, .. } = self;
        let list = |items: &mut dyn Iterator<Item = String>| items.collect::<Vec<String>>().join(", ");
        let parts = system.parts.len();
        let intervals = ((settings.until / settings.every).round() as usize).max(1);
        let unit = |place: Place| system.unit(WireSource::Variable(place)).name;
        let names = self.results.iter().map(|(place, name)| format!("{name} [{}]", unit(*place)));
        let marks = [
            ("title", system.description.title.clone()),
            ("step", format!("{:?}", settings.master.step)),
            ("end", format!("{:?}", settings.until)),
            ("intervals", intervals.to_string()),
            ("parts", parts.to_string()),
            ("wires", system.wires.len().to_string()),
            ("results", self.results.len().to_string()),
            ("hosts", list(&mut (0..parts).map(|at| u8::from(is_host(system, at)).to_string()))),
            ("order", list(&mut Train::new(system)?.order.iter().map(usize::to_string))),
            ("from", list(&mut self.results.iter().map(|(place, _)| place.part.to_string()))),
            ("names", names.collect::<Vec<String>>().join(",")),
            ("course", self.course()),
            ("set_up", self.set_up()),
        ];
        Ok(filled(include_str!("program.c.in"), &marks.each_ref().map(|(name, value)| (*name, value.as_str()))))
    }

    /// Creates the parts and finds variables.
    fn set_up(&self) -> String {
        let mut text = String::new();
        self.parts(&mut text);
        self.wires(&mut text);
        for (at, (place, _)) in self.results.iter().enumerate() {
            let _ = writeln!(text, "    result[{at}] = find({}, \"{}\");", place.part, self.variable(*place));
        }
        for (at, (place, _)) in moving(self.system).enumerate() {
            let _ = writeln!(text, "    input[{at}] = find({}, \"{}\");", place.part, self.variable(*place));
        }
        text
    }

    /// Inputs that move: the parts that they belong to, and their values.
    fn course(&self) -> String {
        let parts: Vec<String> = moving(self.system).map(|(place, _)| place.part.to_string()).collect();
        if parts.is_empty() {
            return "\n/* No input moves. */\nstatic void drive(int step) { (void)step; }\n\n".to_owned();
        }
        let mut text = String::new();
        let (inputs, steps, parts) = (parts.len(), self.course.len(), parts.join(", "));
        let _ = writeln!(text, "#define INPUTS {inputs}\n#define STEPS {steps}\n");
        let _ = writeln!(text, "/* Inputs that move, and their values at the beginning of each step. */");
        let _ = writeln!(text, "static uint32_t input[INPUTS];\nstatic const int moved[INPUTS] = {{{parts}}};");
        text += "static const double course[STEPS][INPUTS] = {\n";
        for row in self.course {
            let row: Vec<String> = row.iter().map(|value| format!("{value:?}")).collect();
            let _ = writeln!(text, "    {{{}}},", row.join(", "));
        }
        text + "};\n" + DRIVE
    }

    fn variable(&self, place: Place) -> String {
        self.system.variable(place).path.to_string()
    }

    /// Parts with what differs from their start values; constants are start values of inputs.
    fn parts(&self, text: &mut String) {
        for (number, part) in self.system.parts.iter().enumerate() {
            let name = part.model.name;
            let _ = writeln!(text, "    check(stribeck_create(\"{name}\", &part[{number}]), part[{number}]);");
            for (column, variable) in part.model.table.iter().enumerate() {
                let value = part.row[column];
                if variable.role.is_computed() || value == variable.start {
                    continue;
                }
                let path = &variable.path;
                let _ = writeln!(
                    text,
                    "    check(stribeck_set_by_name(part[{number}], \"{path}\", {value:?}), part[{number}]); /* {} */",
                    part.name
                );
            }
        }
    }

    fn wires(&self, text: &mut String) {
        for (number, wire) in self.system.wires.iter().enumerate() {
            let WireSource::Variable(from) = wire.from else { continue };
            let _ = writeln!(
                text,
                "    wires[{number}] = (wire){{{}, find({}, \"{}\"), {}, find({}, \"{}\")}};",
                from.part,
                from.part,
                self.variable(from),
                wire.to.part,
                wire.to.part,
                self.variable(wire.to)
            );
        }
    }
}

/// Sets the inputs that move.
const DRIVE: &str = r#"
static void drive(int step) {
    for (int i = 0; i < INPUTS; i++) check(stribeck_set(part[moved[i]], input[i], course[step][i]), part[moved[i]]);
}

"#;
