//! The command line as a user meets it.

use std::path::Path;
use std::process::{Command, Output, Stdio};

fn stribeck(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stribeck")).args(arguments).output().expect("the program starts")
}

fn refusal(arguments: &[&str]) -> String {
    let output = stribeck(arguments);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}");
    String::from_utf8(output.stderr).expect("text").trim().to_owned()
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a file")
}

#[test]
fn refusals_name_what_is_wrong_and_what_was_meant() {
    for (arguments, expected) in [
        (vec!["run", "--law", "LuGr"], "friction law 'LuGr' does not exist (did you mean 'LuGre'?)"),
        (vec!["run", "--system", "bellt"], "system 'bellt' does not exist (did you mean 'belt'?)"),
        (vec!["run", "--set", "mas=2"], "variable of the system 'mas' does not exist (did you mean 'mass'?)"),
        (vec!["run", "--set", "mass=-1"], "rig: mass = -1: must be > 0 and finite"),
        (vec!["run", "--set", "friction.velocity=1"], "friction.velocity comes from rig.velocity and cannot be set"),
        (vec!["run", "--tol", "0"], "tolerance = 0: must be > 0 and finite"),
        (
            vec!["run", "--tol", "1e-14", "--check"],
            "tolerance = 1e-14: a check needs a tenth of it, and that must be at least 1e-14",
        ),
        (vec!["run", "--every=-1"], "every = -1 s: must be > 0 and finite"),
        (vec!["run", "--every", "1e-9"], "every = 1e-9 s gives 40000000000 rows: at most 20000000"),
        (vec!["run", "--law", "LuGre", "Dahl"], "several laws: use `stribeck compare`"),
        (vec!["compare", "--law", "LuGre", "Dahl", "--set", "x=1"], "variable of the system 'x' does not exist"),
    ] {
        assert_eq!(refusal(&arguments), format!("stribeck: {expected}"));
    }
    for arguments in [&["run", "--vary", "mass=1:2:1"][..], &["study", "s.toml", "--out", "o", "--threads", "0"]] {
        assert_eq!(stribeck(arguments).status.code(), Some(2), "a usage error of the arguments: {arguments:?}");
    }
}

/// `stribeck show ... | head -1`.
#[test]
fn output_that_nobody_reads_is_no_failure() {
    let mut program = Command::new(env!("CARGO_BIN_EXE_stribeck"));
    let mut child = program
        .args(["systems", "belt"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!((output.status.code(), String::from_utf8(output.stderr).expect("text")), (Some(0), String::new()));
}

/// The guids are compared with those of the committed descriptions, which the FMUs hold.
#[test]
fn a_report_names_version_platform_and_the_guids_of_the_fmus() {
    let output = stribeck(&["report"]);
    let report = String::from_utf8(output.stdout).expect("text");
    assert!(report.starts_with(concat!("Stribeck    ", env!("CARGO_PKG_VERSION"), "\n")), "{report}");
    let platform = format!("\nplatform    {} {}, ", std::env::consts::OS, std::env::consts::ARCH);
    assert!(report.contains(&platform), "{report}");
    assert!(report.contains("registers   Scalar") && report.contains("in use: "), "{report}");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../modelDescription");
    let paths = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let mut count = 0;
    for file in paths.filter(|path| path.is_file()) {
        let (description, model) = (text(&file), file.file_stem().and_then(|name| name.to_str()).expect("a name"));
        let guid = description.split("guid=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("a guid");
        let is_row = |line: &str| line.split_whitespace().eq([model, guid]);
        assert!(report.lines().any(is_row), "{model} {guid}: {report}");
        count += 1;
    }
    assert_eq!(report.lines().skip_while(|line| *line != "guids").count(), 1 + count);
    let one = String::from_utf8(stribeck(&["report", "LuGre"]).stdout).expect("text");
    assert_eq!(one.lines().skip_while(|line| *line != "guids").count(), 2, "{one}");
    let wrong = refusal(&["report", "LuGr"]);
    assert_eq!(wrong, "stribeck: model 'LuGr' does not exist (did you mean 'LuGre'?)");
}

/// A device that is full.
#[cfg(target_os = "linux")]
#[test]
fn output_that_cannot_be_written_is_a_failure() {
    for arguments in
        [&["models"][..], &["run", "--until", "1"], &["compare", "--law", "Dahl", "--until", "1", "--json"]]
    {
        let full = std::fs::File::options().write(true).open("/dev/full").expect("a device");
        let mut program = Command::new(env!("CARGO_BIN_EXE_stribeck"));
        let output = program.args(arguments).stdout(full).output().expect("the program starts");
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(String::from_utf8(output.stderr).expect("text").starts_with("stribeck: standard output: "));
    }
}

/// k x + F_0, and x = 20 mm + 10 mm sin(4 pi t).
#[test]
fn a_system_without_states_is_evaluated() {
    let folder = tempfile::tempdir().expect("a folder");
    let [system, out] =
        ["spring.toml", "out.csv"].map(|name| folder.path().join(name).to_str().expect("text").to_owned());
    let spring = "title = \"Spring\"\nsource = \"Chosen\"\nuntil = 1.0\nevery = 0.1\n[part.spring]\nmodel = \"CoilSpring\"\n\
                  [input]\n\"spring.compression\" = { sine = { mean = 0.02, amplitude = 0.01, frequency = 2.0 } }\n\
                  [show]\nforce = \"spring.force\"\n";
    std::fs::write(&system, spring).expect("a file");
    assert!(stribeck(&["run", "--system", &system, "--out", &out]).status.success());
    let rows = text(Path::new(&out));
    let numbers = rows.lines().skip(1).map(|row| row.split(',').map(|cell| cell.parse().expect("a number")).collect());
    let numbers: Vec<Vec<f64>> = numbers.collect();
    assert_eq!(numbers.len(), 11);
    for row in numbers {
        let expected = 150.0 + 45_000.0 * (0.02 + 0.01 * (4.0 * std::f64::consts::PI * row[0]).sin());
        assert!((row[1] - expected).abs() < 1e-9, "{row:?} {expected}");
    }
    let refused = refusal(&["run", "--system", &system, "--solver", "bdf"]);
    assert!(refused.ends_with("solver bdf: the system has no continuous state that it could integrate"), "{refused}");
}

#[test]
fn a_run_that_does_not_converge_says_why_and_keeps_its_results() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out.csv");
    let output =
        stribeck(&["run", "--law", "RooneyDeravi", "--set", "variant=Printed", "--out", out.to_str().expect("text")]);
    assert_eq!(output.status.code(), Some(3));
    let line = String::from_utf8(output.stdout).expect("text");
    assert!(line.contains("did not converge at 3.7") && line.contains("friction chatters"), "{line}");
    assert!(text(&out).lines().count() > 300, "what was computed before is there");
}

/// The differences are those of two runs made one by one.
#[test]
fn a_check_says_what_a_finer_run_says() {
    let runs = |arguments: &[&str]| {
        let output = stribeck(&[&["run", "--law", "LuGre", "--json"], arguments].concat());
        let told: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        (output.status.code(), told["runs"][0].clone())
    };
    let (code, checked) = runs(&["--tol", "1e-5", "--check"]);
    let [(_, coarse), (_, fine)] = ["1e-5", "3.2e-8"].map(|tolerance| runs(&["--tol", tolerance]));
    assert!(code == Some(0) && coarse["check"].is_null() && checked["results"] == coarse["results"]);
    let values = |run: &serde_json::Value| -> Vec<f64> {
        let all = run["results"]["rig.position"]["values"].as_array().expect("an array").iter();
        all.map(|value| value.as_f64().expect("a number")).collect()
    };
    let apart = values(&coarse).iter().zip(values(&fine)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let differences = checked["check"]["differences"].as_array().expect("an array");
    let position = differences.iter().find(|one| one["name"] == "rig.position").expect("a difference");
    let largest = position["largest"].as_f64().expect("a number");
    assert!((largest / apart - 1.0).abs() < 0.01 && largest > 0.0, "{largest:e} {apart:e}");

    let run = ["run", "--law", "LuGre", "--solver", "co-simulation", "--step", "0.02", "--check"];
    let output = stribeck(&run);
    let said = String::from_utf8(output.stdout).expect("text");
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(said.starts_with("LuGre: reached; co-simulation"), "{said}");
    assert!(said.contains("  a run with steps of 0.002 s differs by at most\n"), "{said}");
    assert!(said.contains("\n    rig.position  "), "{said}");
    assert!(said.contains("\n  the step does not hold: a run with steps of 0.002 s differs by up to "), "{said}");
}

#[test]
fn a_communication_step_is_found() {
    let search = ["run", "--law", "CoulombStiction", "--solver", "co-simulation", "--step", "find"];
    let output = stribeck(&[&search[..], &["--exchange", "parallel", "--json"]].concat());
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let order = &told["steps"][0]["orders"][0];
    assert_eq!((&order["exchange"], &told["steps"][0]["end"]), (&"parallel".into(), &"reached".into()));
    let step = order["step"].as_f64().expect("a step");
    let output = stribeck(&[&search[..], &["--within", "0.05"]].concat());
    let said = String::from_utf8(output.stdout).expect("text");
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(
        said.starts_with("CoulombStiction: communication steps within 5 % of the solution (rodas5p at 1e-8)"),
        "{said}"
    );
    let found = said.lines().find_map(|line| line.strip_prefix("  parallel: ")?.strip_suffix(" s")).expect("a step");
    assert!(found.parse::<f64>().expect("a number") >= step, "{said}");
    for part in ["\n  sequential: ", "\n  feedthrough: ", "\n    period of friction ", " % off\n"] {
        assert!(said.contains(part), "{part}: {said}");
    }
    for (more, expected) in [
        ("--out=o.csv", "step = find: is a search, without --vary and without results to write"),
        ("--check", "check: step = find compares with the solution anyway"),
        ("--within=2", "within = 2: must be between 0.0001 and 0.5"),
    ] {
        let refused = refusal(&[&search[..], &[more]].concat());
        assert!(refused.starts_with(&format!("stribeck: {expected}")), "{refused}");
    }
    assert!(refusal(&["run", "--step", "find"]).ends_with("solver auto: step = find is for co-simulation"));
}

#[test]
fn a_study_by_parts_is_the_whole_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let study =
        "samples = 1200\nkeep = [\"max rig.position\"]\n[vary]\nmu_s = { uniform = [0.1, 0.2] }\n[run]\nuntil = 1.0\n";
    std::fs::write(folder.path().join("study.toml"), study).expect("a file");
    let [description, whole, parts] = [file("study.toml"), file("whole"), file("parts")];
    let output = stribeck(&["study", &description, "--out", &whole]);
    let said = String::from_utf8(output.stdout).expect("text");
    assert!(
        output.status.success() && said.starts_with("1200 rows run, 0 found, 0 did not come to their end"),
        "{said}"
    );
    assert!(stribeck(&["study", &description, "--out", &parts, "--shard", "2/2", "--threads", "1"]).status.success());
    let refusal = refusal(&["study", &description, "--out", &parts, "--merge"]);
    assert!(refusal.ends_with("1 of 2 chunks are missing, the first one is 0"), "{refusal}");
    assert!(stribeck(&["study", &description, "--out", &parts, "--shard", "1/2"]).status.success());
    assert!(stribeck(&["study", &description, "--out", &parts, "--merge"]).status.success());
    assert_eq!(text(&folder.path().join("whole/study.csv")), text(&folder.path().join("parts/study.csv")));
}

#[test]
fn a_saved_configuration_gives_the_same_bits() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let [config, first, second] = [file("run.toml"), file("first.csv"), file("second.csv")];
    let values = ["--set", "mu_s=0.2", "--set", "rig.belt_velocity=0.05", "--until", "10", "--tol", "1e-6"];
    let run = [&["run", "--law", "LuGre", "--out", &first, "--save-config", &config], &values[..]].concat();
    assert!(stribeck(&run).status.success());
    assert!(stribeck(&["run", "--config", &config, "--out", &second]).status.success());
    assert_eq!(text(Path::new(&first)), text(Path::new(&second)));
    let heading = text(Path::new(&first)).lines().next().expect("a heading").to_owned();
    assert!(heading.starts_with("time [s],") && heading.contains("rig.position [m]"), "{heading}");
}

#[test]
fn a_variable_takes_each_of_its_values() {
    let output = stribeck(&["run", "--law", "Dahl", "--vary", "mu_k=0.1:0.2:3", "--until", "1", "--json"]);
    assert!(output.status.success());
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let runs = value["runs"].as_array().expect("runs");
    let varied: Vec<f64> = runs.iter().map(|run| run["varied"]["value"].as_f64().expect("a number")).collect();
    assert_eq!(varied, [0.1, 0.15000000000000002, 0.2]);
    assert_eq!(runs[0]["results"]["rig.position"]["unit"], "m");
}

#[test]
fn built_in_systems_are_listed_and_printed() {
    let list = String::from_utf8(stribeck(&["systems"]).stdout).expect("text");
    assert!(list.starts_with("belt "), "{list}");
    let file = String::from_utf8(stribeck(&["systems", "belt"]).stdout).expect("text");
    assert!(file.contains("[part.rig]"), "{file}");
}

#[test]
fn the_benchmark_writes_a_page_and_a_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("text");
    assert!(
        stribeck(&["bench", "thesis", "--law", "CoulombStiction", "--repeats", "1", "--out", out]).status.success()
    );
    let table = text(&folder.path().join("benchmark.csv"));
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let rows: Vec<csv::StringRecord> = rows.records().map(|row| row.expect("a row")).collect();
    let of_ours = |events: &str| rows.iter().find(|row| &row[1] == "rodas5p" && &row[3] == events).expect("a run");
    let [located, refused] = ["true", "false"].map(of_ours);
    let number = |column: usize| located[column].parse::<f64>().expect("a number");
    assert!(number(10) < 1e-7 && number(11) < 1e-7, "errors of motion and switching: {located:?}");
    assert_eq!(&located[12], "right");
    assert!(&refused[12] == "refused" && refused[13].contains("never stick"), "{refused:?}");
    assert!(text(&folder.path().join("benchmark.md")).contains("| CoulombStiction | "));
}

#[test]
fn pictures_and_report_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let arguments = ["compare", "--law", "LuGre", "Dahl", "--tol", "1e-6", "--pictures"];
    let [pictures, page] = [file("pictures"), file("report.html")];
    let run = [&arguments[..], &[&pictures, "--report", &page]].concat();
    assert!(stribeck(&run).status.success());
    let pictures = std::fs::read_dir(file("pictures")).expect("a folder").count();
    assert_eq!(pictures, 14, "seven kinds, as SVG and PNG");
    let report = text(Path::new(&file("report.html")));
    assert!(report.contains("LuGre") && report.contains("Dahl") && report.contains("<svg"));
}

/// A virtual rig, its law found again, and the result run.
#[test]
fn a_virtual_rig_is_identified_and_the_result_runs() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let truth = ["--set", "mu_k=0.2", "--set", "sigma_0=3e4"];
    let out = file("rig");
    let rig = [&["rig", "--law", "Dahl", "--duration", "1", "--out", &out], &truth[..]].concat();
    assert_eq!(stribeck(&rig).status.code(), Some(0));
    let record = file("rig/force.csv");
    let known = ["identify", &record, "--mass", "2", "--normal-force", "20", "--law"];
    let outputs =
        [file("fitted.toml"), file("fitted.csv"), file("curves"), file("report.html"), file("rig/truth.toml")];
    let [toml, csv, curves, report, reference] = outputs.each_ref().map(String::as_str);
    let more = ["Dahl", "--reference", reference, "--out", toml, "--curves", curves, "--report", report];
    let output = stribeck(&[&known[..], &more].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let shown = String::from_utf8(output.stdout).expect("text");
    assert!(
        shown.contains("one normal force (20 N)") && shown.contains("at rest, with the contact unloaded"),
        "{shown}"
    );
    assert!(shown.contains("reference 0.20000, difference 0."), "{shown}");
    let page = text(Path::new(report));
    assert!(page.contains("Identification of Dahl") && page.matches("<svg").count() == 3, "{page}");
    assert!(
        page.contains(">Seed</td><td data-title=\"Value\">1</td>")
            && page.contains("--mass 2 --normal-force 20 --law Dahl"),
        "{page}"
    );
    roxmltree::Document::parse(page.trim_start_matches("<!DOCTYPE html>\n")).expect("a page");
    assert!(text(&Path::new(curves).join("force.csv")).lines().count() == 1002);
    let line = stribeck(&["run", "--config", toml, "--until", "1"]);
    assert!(String::from_utf8_lossy(&line.stdout).starts_with("Dahl: reached"));

    let output = stribeck(&[&known[..], &["Dahl,Coulomb", "--json", "--repetitions", "0", "--out", csv]].concat());
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let laws = found["laws"].as_array().expect("laws");
    assert_eq!([&laws[0]["law"], &laws[1]["law"]], ["Dahl", "Coulomb"]);
    assert!(laws[1]["delta_bic"].as_f64().expect("a number") > 10.0 && laws[1]["tied"] == false);
    let estimates = laws[0]["estimates"].as_array().expect("estimates");
    let stiffness = estimates.iter().find(|one| one["name"] == "sigma_0").expect("sigma_0");
    assert!((stiffness["value"].as_f64().expect("a number") / 3e4 - 1.0).abs() < 0.02, "{stiffness}");
    assert!(text(Path::new(csv)).contains("sigma_0"));
}

/// An elastic mount, which no normal force presses together.
#[test]
fn a_mount_is_identified_without_a_system_to_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let [record, csv, toml, report] = ["mount.csv", "set.csv", "set.toml", "report.html"].map(file);
    let row =
        |t: f64| format!("{t},{},{}\n", 3e5 * (1.0 - (6.0 * t).cos()) + (1e4 * t * t).sin(), 1.0 - (6.0 * t).cos());
    let rows: String = (0..1000).map(|k| row(f64::from(k) * 2e-3)).collect();
    std::fs::write(&record, format!("time [s],force [N],displacement [m]\n{rows}")).expect("a file");
    let held = ["F_max=0", "x_2=1e-3", "k_v=0", "c=1"].iter().flat_map(|one| ["--fix", one]);
    let known: Vec<&str> =
        ["identify", &record, "--law", "RubberMount", "--repetitions", "0"].into_iter().chain(held).collect();
    let output = stribeck(&[&known[..], &["--out", &csv, "--report", &report]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(text(Path::new(&csv)).contains("\nk_e,"), "{}", text(Path::new(&csv)));
    let page = text(Path::new(&report));
    assert!(page.contains(">k_e</td>") && !page.contains("stribeck run"), "{page}");
    let refused = refusal(&[&known[..], &["--out", &toml]].concat());
    assert!(refused.ends_with("RubberMount: the file is for a system with a friction law, and it has none: write a parameter set, .csv or .ssv"), "{refused}");
}

/// The values of the rig, judged beside a fit in terminal and report, and alone in JSON.
#[test]
fn given_values_are_judged() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let rig = ["rig", "--law", "Dahl", "--set", "sigma_0=3e4", "--duration", "1", "--out", &file("rig")];
    assert_eq!(stribeck(&rig).status.code(), Some(0));
    let [record, reference, report] = ["rig/force.csv", "rig/truth.toml", "report.html"].map(file);
    let known = ["identify", &record, "--mass", "2", "--normal-force", "20", "--law", "Dahl", "--repetitions", "0"];
    let output = stribeck(&[&known[..], &["--reference", &reference, "--report", &report]].concat());
    let (shown, page) = (String::from_utf8(output.stdout).expect("text"), text(Path::new(&report)));
    assert!([&shown, &page].iter().all(|text| text.contains("truth.toml: RMS residual 0.")), "{shown}\n{page}");
    assert!(page.contains("Values that were given") && page.contains(">sigma_0</td>"), "{page}");
    let cell = |title: &str| {
        let title = format!("data-title=\"{title}\">");
        let row = page.split("<tr").find(|row| row.contains(">mu_k</td>") && row.contains(&title));
        row.and_then(|row| row.split(&title).nth(1)?.split("</td>").next()).unwrap_or_else(|| panic!("{title} {page}"))
    };
    assert_eq!(cell("Value"), cell("Reference"));

    let output = stribeck(&[&known[..], &["--evaluate", &reference, "--json"]].concat());
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let judged = &found["laws"][0]["judgement"];
    assert_eq!((&judged["values"]["sigma_0"], &judged["source"]), (&3e4.into(), &reference.as_str().into()));
    assert_eq!((&judged["rms"], &judged["fit_rms"]), (&found["laws"][0]["rms"], &serde_json::Value::Null));
    assert_eq!(judged["verdict"], "the values explain the data");
}

#[test]
fn a_reference_of_another_law_is_said_to_be_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("rig").to_str().expect("text").to_owned();
    assert_eq!(stribeck(&["rig", "--law", "Dahl", "--duration", "1", "--out", &out]).status.code(), Some(0));
    let [record, reference] = ["force.csv", "truth.toml"].map(|name| format!("{out}/{name}"));
    let known = ["--mass", "2", "--normal-force", "20", "--repetitions", "0", "--reference", &reference];
    let said = |law: &str| {
        let output = stribeck(&[&["identify", &record, "--law", law][..], &known].concat());
        String::from_utf8(output.stderr).expect("text")
    };
    let expected = "is a set of Dahl, not of Coulomb; compared where names are the same\n";
    assert!(said("Coulomb").ends_with(&format!("--reference {reference}: {expected}")), "{}", said("Coulomb"));
    assert!(!said("Dahl").contains("is a set of"));
}

/// Arguments take precedence over a description in a file, entry by entry.
#[test]
fn a_saved_description_of_a_job_does_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let [rig, saved, again] = ["rig", "saved.toml", "again.toml"].map(file);
    stribeck(&["rig", "--law", "Dahl", "--duration", "1", "--out", &rig]);
    let record = file("rig/force.csv");
    let known = ["--law", "Dahl", "--mass", "2", "--normal-force", "20", "--budget", "50", "--repetitions", "0"];
    let told = |arguments: &[&str]| {
        let output = stribeck(&[&["identify"], arguments, &["--json"]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("text")
    };
    let first = told(&[&[record.as_str()], &known[..], &["--fix", "sigma_0=2e4", "--save-config", &saved]].concat());
    let all = "budget = 50\nlaw = [\"Dahl\"]\nmass = 2.0\nnormal_force = 20.0\n";
    let expected = format!("{all}records = [{record:?}]\nrepetitions = 0\n\n[fix]\nsigma_0 = 20000.0\n");
    assert_eq!(text(Path::new(&saved)), expected);
    assert_eq!(told(&["--config", &saved]), first);
    let other = told(&["--config", &saved, "--fix", "mu_k=0.1", "--fit", "offset", "--save-config", &again]);
    assert!(other.contains("\"offset\"") && !first.contains("\"offset\""), "{other}");
    assert!(text(Path::new(&again)).ends_with("[fix]\nmu_k = 0.1\nsigma_0 = 20000.0\n"), "{}", text(Path::new(&again)));
    std::fs::write(&saved, "laws = \"Dahl\"").expect("a file");
    for command in ["identify", "damper", "tyre"] {
        let unknown = refusal(&[command, "--config", &saved]);
        assert!(unknown.contains("unknown field `laws`"), "{unknown}");
        let missing = if command == "identify" { "law" } else { "record" };
        assert_eq!(refusal(&[command]), format!("stribeck: no {missing} was given"));
    }
    std::fs::write(&saved, "record = \"absent.csv\"\naxes = \"sae\"\nradius = 0.2").expect("a file");
    assert!(refusal(&["tyre", "--config", &saved]).starts_with("stribeck: absent.csv: "));
}

/// A test whose columns have other names is the same test.
#[test]
fn columns_of_a_damper_test_are_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let rows: String = (-40..=40).filter(|v| *v != 0).map(|v| format!("{},{}\n", 25 * v, 30 * v)).collect();
    let [plain, other] = [path("plain.csv"), path("other.csv")];
    std::fs::write(&plain, format!("velocity [mm/s],force [N]\n{rows}")).expect("a file");
    std::fs::write(&other, format!("Speed [mm/s],Load [N]\n{rows}")).expect("a file");
    let told = |arguments: &[&str]| String::from_utf8(stribeck(arguments).stdout).expect("text");
    let expected = told(&["damper", &plain]);
    assert!(expected.starts_with("80 samples; the force is the resistance\n"), "{expected}");
    assert_eq!(told(&["damper", &other, "--column", "velocity=Speed", "--column", "force=load"]), expected);
    let missing = format!("stribeck: {other}: no column 'velocity'; there are Speed, Load");
    assert_eq!(refusal(&["damper", &other]), format!("{missing}; --column velocity=NAME names it"));
}

/// `--check` says what a record can determine, without numbers, and refuses `--json`.
#[test]
fn what_can_be_determined_is_told_first() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("rig").to_str().expect("text").to_owned();
    assert_eq!(stribeck(&["rig", "--law", "Dahl", "--duration", "1", "--out", &out]).status.code(), Some(0));
    let record = format!("{out}/force.csv");
    let known = ["identify", &record, "--mass", "2", "--normal-force", "20", "--law", "Dahl", "--check"];
    let check = String::from_utf8(stribeck(&known).stdout).expect("text");
    assert!(check.ends_with("Dahl:\n  mu_k: can be determined\n  sigma_0: can be determined\n"), "{check}");
    assert_eq!(refusal(&[&known[..], &["--json"]].concat()), "stribeck: --check: writes no JSON");
}

#[test]
fn refusals_of_an_identification_name_what_is_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("r.csv");
    let record = path.to_str().expect("text");
    let rows = |k: i32| format!("{},{},{}\n", k, (k % 7) - 3, (k * k) % 11);
    std::fs::write(&path, "time,force,displacement\n".to_owned() + &(0..30).map(rows).collect::<String>())
        .expect("a file");
    let film = folder.path().join("film.csv");
    let camera = film.to_str().expect("text");
    let frame = |k: i32| if k == 1 { "1,abc\n".to_owned() } else { format!("{k},{}\n", k % 7) };
    std::fs::write(&film, "time,displacement\n".to_owned() + &(0..30).map(frame).collect::<String>()).expect("a file");
    let law = ["identify", record, "--law"];
    for (arguments, expected) in [
        (vec!["LuGr"], "friction law 'LuGr' does not exist (did you mean 'LuGre'?)".to_owned()),
        (vec!["Dahl"], format!("{record}: no column 'normal_force', and no value was given for it")),
        (vec!["Dahl", "--normal-force", "-1"], format!("{record}: normal_force = -1: must be >= 0 and finite, in N")),
        (vec!["Dahl", "--mass", "-1"], format!("{record}: mass = -1: must be >= 0 and finite, in kg")),
        (vec!["Dahl", "--mass", "2", "--fix", "mass=3"], "fix mass = 3 contradicts mass = 2".to_owned()),
        (vec!["Dahl", "--fix", "mass=3", "--fit", "mass"], "fix mass = 3 contradicts fit mass".to_owned()),
        (vec!["Dahl", "--motion", "absent.csv"], "absent.csv: No such file or directory (os error 2)".to_owned()),
        (
            vec!["Dahl", "--normal-force=1", "--motion", camera],
            format!("{camera}: line 3, displacement: 'abc' is not a finite number"),
        ),
    ] {
        assert_eq!(refusal(&[&law[..], &arguments].concat()), format!("stribeck: {expected}"));
    }
    let rig = refusal(&["rig", "--law", "LuGrePlanar", "--out", "x"]);
    assert!(rig.starts_with("stribeck: friction law 'LuGrePlanar' does not exist"), "{rig}");
    for (option, value, expected) in [
        ("--range", "mu_k=1", "mu_k = 1: must be LOW:HIGH"),
        ("--fix", "mu_k=x", "mu_k = x: must be a number"),
        ("--delay", "late", "delay = late: must be a number in s, find, or find:LONGEST"),
    ] {
        let usage = stribeck(&[&law[..], &["Dahl", option, value]].concat());
        assert_eq!(usage.status.code(), Some(2), "{option}");
        let said = String::from_utf8(usage.stderr).expect("text");
        assert!(said.contains(expected), "{said}");
    }
}

/// Without a single fit.
#[test]
fn files_of_an_identification_are_judged_by_what_they_are() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("r.csv");
    let record = path.to_str().expect("text");
    std::fs::write(&path, "").expect("a file");
    let blanks = folder.path().join("blanks.txt");
    std::fs::write(&blanks, "Pos [mm]  Millis [ms]  Load [N]\n1 2 3\n").expect("a file");
    let unnamed = refusal(&["identify", blanks.to_str().expect("text"), "--law", "Dahl"]);
    let expected = "no column 'time'; there are Pos (displacement), Millis, Load; --column time=NAME names it, ";
    assert!(unnamed.contains(expected), "{unnamed}");
    let again = folder.path().join(".").join("r.csv");
    let again = again.to_str().expect("text");
    let twice = refusal(&["identify", record, again, "--law", "Dahl"]);
    assert_eq!(twice, format!("stribeck: {again}: is given twice"));
    let held_out = refusal(&["identify", record, "--law", "Dahl", "--hold-out", again]);
    assert_eq!(held_out, format!("stribeck: {again}: is a record and held out too"));
}

/// Before a record is read: there is none.
#[test]
fn files_that_cannot_be_written_are_refused_first() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let [taken, text, page, nowhere] = ["taken", "out.txt", "page.htm", "absent/out.csv"].map(file);
    std::fs::write(&taken, "").expect("a file");
    let identify = ["identify", "absent.csv", "--law", "Dahl"];
    let tyre = ["tyre", "absent.csv", "--axes", "sae", "--radius", "0.2"];
    let damper = ["damper", "absent.csv"];
    for (command, option, name, expected) in [
        (&identify[..], "--out", &text, "must end in .toml, .csv, .ssv, .py, .xml or .urdf".to_owned()),
        (&identify[..], "--out", &nowhere, format!("folder {} does not exist", file("absent"))),
        (&identify[..], "--report", &page, "must end in .html".to_owned()),
        (&identify[..], "--curves", &taken, format!("must be a folder; {taken} is a file")),
        (&tyre[..], "--out", &text, "must end in .tir".to_owned()),
        (&tyre[..], "--pictures", &taken, format!("must be a folder; {taken} is a file")),
        (&["tyre", "absent.tir"][..], "--out", &text, "must end in .csv or .ssv".to_owned()),
        (&damper[..], "--out", &text, "must end in .csv or .ssv".to_owned()),
    ] {
        let found = refusal(&[command, &[option, name]].concat());
        assert!(found.ends_with(&format!("{name}: {expected}")), "{found}");
    }
}

#[test]
fn columns_of_a_tyre_test_have_the_names_that_were_given() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("t.csv");
    let test = path.to_str().expect("text");
    std::fs::write(&path, "Radlast [kN],alpha,Winkel [deg],Quer [N]\n-1,x,1,-5\n-1,x,2,-9\n").expect("a file");
    let tyre = ["tyre", test, "--axes", "sae", "--radius", "0.2"];
    for (arguments, expected) in [
        (vec![], format!("{test}: no column 'F_z', 'FZ', 'normal_force'; there are Radlast,")),
        (vec!["--column", "FZ=Last"], format!("{test}: no column 'Last' for FZ")),
        (vec!["--column", "FW=Radlast"], "quantity of a tyre test 'FW' does not exist".to_owned()),
        (
            vec!["--column", "FZ=Radlast", "--column", "SA=Winkel", "--column", "FY=Quer"],
            format!("{test}: 2 samples; at least 40 are needed"),
        ),
    ] {
        let found = refusal(&[&tyre[..], &arguments].concat());
        assert!(found.starts_with(&format!("stribeck: {expected}")), "{found}");
    }
}

/// A file as fitting tools write it: most of it is for other models, some of it is missing.
#[test]
fn a_tyre_property_file_is_converted_and_what_is_not_used_is_listed() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("t.tir");
    let file = "[MODEL]\nFITTYP = 6\nTYRESIDE = 'LEFT'\nROAD_INCREMENT =\n[D]\nUNLOADED_RADIUS = 0.2\nFNOMIN = 800\n\
                PCY1 = 1.4\nPDY1 = 1.5D0\nPKY1 = -30\nPKY2 = 1.6\nPDXP1 = 0.4\nQSX4 = 0.1\nYAW_STIFFNESS = 5\nNEW = 1\n";
    std::fs::write(&path, file).expect("a file");
    let output = stribeck(&["tyre", path.to_str().expect("text")]);
    assert!(output.status.success());
    assert!(String::from_utf8_lossy(&output.stdout).contains("tyre.pdy1,1.5,"), "{output:?}");
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    for line in [
        "without value, as if absent: ROAD_INCREMENT",
        "VERTICAL_STIFFNESS: not in the file, a car keeps its own",
        "would change forces, but not here: turn slip: PDXP1; Magic Formula 6: QSX4",
        "not used: relaxation and structure: YAW_STIFFNESS; unknown: NEW",
    ] {
        assert!(told.lines().any(|other| other == line), "{line}: {told}");
    }
}

#[test]
fn a_tyre_test_may_have_several_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("a file");
        path.to_str().expect("text").to_owned()
    };
    let side: String = (-30..30).map(|k| format!("700,{k},{}\n", -40 * k)).collect();
    let side = file("side.csv", &format!("FZ [N],SA [deg],FY [N]\n{side}"));
    let along = file("along.csv", "FZ [N],SR,FX [N]\n700,0.1,800\n700,-0.1,-800\n");
    let saved = file("saved.toml", "");
    let tyre = ["tyre", &side, &along, "--axes", "iso", "--radius", "0.2", "--save-config", &saved];
    let expected = format!("stribeck: {along}: 2 samples; at least 40 are needed");
    assert_eq!(refusal(&tyre), expected);
    assert!(text(Path::new(&saved)).ends_with(&format!("records = [{side:?}, {along:?}]\n")));
    assert_eq!(refusal(&["tyre", "--config", &saved]), expected);
    let refused = refusal(&["tyre", &side, "b.tir"]);
    assert_eq!(refused, "stribeck: b.tir: a tyre property file stands alone, without other files");
}

/// Every command and option that `--help` of the program and of its commands shows is completed and has its page.
#[test]
fn shells_and_manuals_know_every_command_and_option() {
    let folder = tempfile::tempdir().expect("a folder");
    let printed = |arguments: &[&str]| String::from_utf8(stribeck(arguments).stdout).expect("text");
    let out = folder.path().join("new").join("man");
    assert!(stribeck(&["manual", "--out", out.to_str().expect("a path")]).status.success());
    let scripts = ["bash", "zsh", "fish", "powershell", "elvish"].map(|shell| printed(&["completions", shell]));
    let help = printed(&["--help"]);
    let listed = help.split("Commands:\n").nth(1).expect("commands").split("\n\n").next().expect("their list");
    let commands: Vec<&str> = listed.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).collect();
    let commands: Vec<&str> = commands.into_iter().filter(|name| !["", "help"].contains(name)).collect();
    assert!(commands.contains(&"identify") && commands.contains(&"manual"), "{commands:?}");
    for command in commands {
        // In roff a hyphen that is none of a word has a backslash before it.
        let page = text(&out.join(format!("stribeck-{command}.1"))).replace("\\-", "-");
        let help = printed(&[command, "--help"]);
        let words = help.split_whitespace().filter(|word| word.starts_with("--") && word.len() > 4);
        let options: Vec<&str> =
            words.map(|word| word.trim_end_matches([',', '.', ';', ':', ')', '`', '\''])).collect();
        for option in options.iter().map(|option| option.split(['=', '`']).next().unwrap_or(option)) {
            assert!(page.contains(option), "the page of {command} has no {option}");
            assert!(scripts.iter().all(|script| script.contains(&option[2..])), "{command} {option}");
        }
    }
    assert_eq!(stribeck(&["completions", "tcl"]).status.code(), Some(2));
    let file = folder.path().join("file");
    std::fs::write(&file, "").expect("a file");
    assert!(refusal(&["manual", "--out", file.to_str().expect("a path")]).contains("file: "));
}
