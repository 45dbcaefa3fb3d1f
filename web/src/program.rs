//! Runs of systems as programs in C: a master of co-simulation over the models of the C library.

use std::fmt::Write;

use serde_json::json;
use stribeck_solve::couple::{Exchange, Train, hold, is_host};
use stribeck_solve::run::{Configuration, Settings, Solver, run};
use stribeck_solve::system::{Fault, Place, Signal, System, WireSource};

use crate::answer::Answer;
use crate::solution::assembled;

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
    Ok(Answer::plain(json!({ "text": text })))
}

/// Refuses what the program cannot do.
fn check(system: &System, settings: &Settings) -> Result<(), Fault> {
    if settings.solver != Solver::CoSimulation {
        let solver = settings.solver;
        let text = format_args!("solver {solver}: a program in C makes steps of the models; choose co-simulation");
        return Err(Fault::value(text));
    }
    if settings.master.exchange != Exchange::Sequential || settings.master.jitter != 0.0 {
        return Err(Fault::value("exchange, jitter: a program in C has a sequential exchange and equal steps"));
    }
    let steps = settings.until / settings.master.step;
    if moving(system).next().is_some() && steps > MOST_STEPS {
        let until = settings.until;
        let text =
            format_args!("until = {until} s: {steps} steps of inputs that move; a program in C has {MOST_STEPS}");
        return Err(Fault::value(text));
    }
    match system.wires.iter().find(|wire| matches!(wire.from, WireSource::Derivative(_))) {
        Some(wire) => {
            let name = system.name(wire.to);
            Err(Fault::value(format_args!("{name} is the derivative of a state, which the C library does not give")))
        }
        None => Ok(()),
    }
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
    let outcome = run(system, &Settings { every: 0.5 * settings.master.step, ..*settings }, &names)?;
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
        let order = Train::new(system)?.order;
        let numbers: Vec<String> = order.iter().map(usize::to_string).collect();
        let hosts: Vec<&str> = (0..system.parts.len()).map(|at| if is_host(system, at) { "1" } else { "0" }).collect();
        let intervals = ((settings.until / settings.every).round() as usize).max(1);
        let mut text = format!("/* {}: steps of {} s. */\n", system.description.title, settings.master.step);
        text += HEAD;
        let _ = writeln!(
            text,
            "#define PARTS {}\n#define WIRES {}\n#define RESULTS {}\n\nstatic stribeck_instance *part[PARTS];\nstatic const \
             int is_host[PARTS] = {{{}}}, order[PARTS] = {{{}}};\nstatic wire wires[WIRES];",
            system.parts.len(),
            system.wires.len(),
            self.results.len(),
            hosts.join(", "),
            numbers.join(", ")
        );
        text += CHECK;
        self.course(&mut text);
        text += EXCHANGE;
        let _ = writeln!(
            text,
            "int main(void) {{\n    const double step = {:?}, end = {:?}; /* s */\n    const int intervals = {intervals};",
            settings.master.step, settings.until
        );
        text += "    const int from[RESULTS] = ";
        text += &self.list(self.results.iter().map(|(place, _)| place.part.to_string()));
        text += "    uint32_t result[RESULTS];\n";
        self.parts(&mut text);
        self.wires(&mut text);
        for (at, (place, _)) in self.results.iter().enumerate() {
            let _ = writeln!(text, "    result[{at}] = find({}, \"{}\");", place.part, self.variable(*place));
        }
        for (at, (place, _)) in moving(system).enumerate() {
            let _ = writeln!(text, "    input[{at}] = find({}, \"{}\");", place.part, self.variable(*place));
        }
        let names = self
            .results
            .iter()
            .map(|(place, name)| format!("{name} [{}]", system.unit(WireSource::Variable(*place)).name));
        let _ = writeln!(text, "    puts(\"time [s],{}\");", names.collect::<Vec<_>>().join(","));
        Ok(text + RUN)
    }

    fn list(&self, items: impl Iterator<Item = String>) -> String {
        format!("{{{}}};\n", items.collect::<Vec<_>>().join(", "))
    }

    /// Inputs that move: the parts that they belong to, and their values.
    fn course(&self, text: &mut String) {
        let parts: Vec<String> = moving(self.system).map(|(place, _)| place.part.to_string()).collect();
        if parts.is_empty() {
            *text += "\n/* No input moves. */\nstatic void drive(int step) { (void)step; }\n\n";
            return;
        }
        let (inputs, steps, parts) = (parts.len(), self.course.len(), parts.join(", "));
        let _ = writeln!(text, "#define INPUTS {inputs}\n#define STEPS {steps}\n");
        let _ = writeln!(text, "/* Inputs that move, and their values at the beginning of each step. */");
        let _ = writeln!(text, "static uint32_t input[INPUTS];\nstatic const int moved[INPUTS] = {{{parts}}};");
        *text += "static const double course[STEPS][INPUTS] = {\n";
        for row in self.course {
            let row: Vec<String> = row.iter().map(|value| format!("{value:?}")).collect();
            let _ = writeln!(text, "    {{{}}},", row.join(", "));
        }
        *text += "};\n";
        *text += DRIVE;
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

const HEAD: &str = r#"#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "stribeck.h"

/* Results are passed on from one part to an input of another one. */
typedef struct {
    int from;
    uint32_t out;
    int to;
    uint32_t in;
} wire;

"#;

const CHECK: &str = r#"
static void check(stribeck_status status, const stribeck_instance *model) {
    if (status != STRIBECK_OK) {
        fprintf(stderr, "%s\n", stribeck_last_error(model));
        exit(1);
    }
}

"#;

const DRIVE: &str = r#"
static void drive(int step) {
    for (int i = 0; i < INPUTS; i++) check(stribeck_set(part[moved[i]], input[i], course[step][i]), part[moved[i]]);
}

"#;

const EXCHANGE: &str = r#"static uint32_t find(int at, const char *name) {
    uint32_t found = 0;
    check(stribeck_find(part[at], name, &found), part[at]);
    return found;
}

static double get(int at, uint32_t variable) {
    double value = 0.0;
    check(stribeck_get(part[at], variable, &value), part[at]);
    return value;
}

/* At the start values go round until nothing changes. */
static void settle(void) {
    drive(0);
    for (int round = 0, changed = 1; round <= WIRES && changed; round++) {
        changed = 0;
        for (int i = 0; i < WIRES; i++) {
            double value = get(wires[i].from, wires[i].out), now = get(wires[i].to, wires[i].in);
            if (memcmp(&value, &now, sizeof value) != 0) {
                check(stribeck_set(part[wires[i].to], wires[i].in, value), part[wires[i].to]);
                changed = 1;
            }
        }
    }
}

/* Passes values on to hosts, or to what acts on them: all are read before any is set. */
static void pass(int to_host) {
    double values[WIRES];
    for (int i = 0; i < WIRES; i++)
        if (is_host[wires[i].to] == to_host) values[i] = get(wires[i].from, wires[i].out);
    for (int i = 0; i < WIRES; i++)
        if (is_host[wires[i].to] == to_host) check(stribeck_set(part[wires[i].to], wires[i].in, values[i]), part[wires[i].to]);
}

static void advance(int hosts, double h) {
    for (int i = 0; i < PARTS; i++)
        if (is_host[order[i]] == hosts) check(stribeck_step(part[order[i]], h), part[order[i]]);
}

"#;

const RUN: &str = r#"    settle();
    /* Times are summed up with what the last digit loses (Kahan). */
    double time = 0.0, lost = 0.0;
    for (int number = 0, made = 0;; made++) {
        double reached = time + 1e-9 * step + 4.0 * 2.220446049250313e-16 * time;
        double due = number == intervals ? end : end * ((double)number / intervals);
        if (due <= reached) {
            printf("%.17g", time);
            for (int i = 0; i < RESULTS; i++) printf(",%.17g", get(from[i], result[i]));
            puts("");
            do {
                number++;
                due = number == intervals ? end : end * ((double)number / intervals);
            } while (number <= intervals && due <= reached);
        }
        if (number > intervals) break;
        double rest = end - time, h = step >= rest * (1.0 - 1e-9) ? rest : step, length = h - lost, next = time + length;
        drive(made);
        pass(0);
        advance(0, h);
        pass(1);
        advance(1, h);
        lost = (next - time) - length;
        time = next;
    }
    for (int i = 0; i < PARTS; i++) stribeck_free(part[i]);
    return 0;
}
"#;
