//! Studies against single runs, and against themselves after interruptions.

use std::fs;
use std::sync::atomic::AtomicUsize;

use super::*;

/// The block on the belt with Coulomb friction and stiction: the first slip is at mu_s m g / (k v_b), and no event comes
/// before it.
const STUDY: &str = r#"
samples = 2500
seed = 7
keep = ["max rig.position", "last rig.position", "mean rig.position", "events"]
[vary]
mu_s = { uniform = [0.12, 0.2] }
"rig.mass" = { log = [0.5, 2.0] }
"rig.stiffness" = { normal = [2.0, 0.1] }
[run]
law = ["CoulombStiction"]
until = 8.0
tol = 1e-6
"#;

const ALL: Shard = Shard { number: 1, count: 1 };

fn study(text: &str) -> Result<Study, Fault> {
    Study::new(toml::from_str(text).map_err(|error| Fault::File(error.to_string()))?, Path::new(""))
}

fn quiet(_rows: usize) {}

fn make(study: &Study, folder: &Path, shard: Shard, threads: usize) -> Done {
    study.make(folder, shard, NonZeroUsize::new(threads).unwrap(), None, &AtomicBool::new(false), &quiet).unwrap()
}

fn table(study: &Study, folder: &Path) -> String {
    study.merge(folder, &folder.join("study.csv")).unwrap();
    fs::read_to_string(folder.join("study.csv")).unwrap()
}

/// While it sticks, the block moves with the belt; at the largest position of its first slip it has the energy of its
/// start, less what friction took: x_max = x_k + sqrt((x_s - x_k)^2 + (v_b / w)^2), with x = mu m g / k.
#[test]
fn results_are_closed_forms_of_their_samples() {
    let folder = tempfile::tempdir().unwrap();
    let study = study(STUDY).unwrap();
    assert_eq!(make(&study, folder.path(), ALL, 2), Done { rows: 2500, found: 0, failed: 0, cancelled: false });
    let text = table(&study, folder.path());
    assert!(
        text.starts_with("row,law,mu_s,rig.mass,rig.stiffness,max rig.position,last rig.position,mean"),
        "{text:.99}"
    );
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let (mut rows, mut slipped, mut sums) = (0, 0, [0.0; 3]);
    for record in reader.records() {
        let record = record.unwrap();
        let number = |at: usize| record[at].parse::<f64>().unwrap();
        let (mu_s, mass, stiffness, highest) = (number(2), number(3), number(4), number(5));
        assert!((0.12..0.2).contains(&mu_s) && (0.5..2.0).contains(&mass), "{record:?}");
        sums = [sums[0] + mu_s, sums[1] + mass.ln(), sums[2] + stiffness];
        let [static_limit, middle] = [mu_s, 0.1].map(|mu| mu * mass * 9.81 / stiffness);
        let crest = middle + ((static_limit - middle).powi(2) + 0.01 * mass / stiffness).sqrt();
        // The crest is reached before the end, and the results are 10 ms apart.
        if static_limit / 0.1 < 5.0 {
            assert!((highest - crest).abs() < 2e-4 * crest, "{record:?} {crest}");
            slipped += 1;
        }
        rows += 1;
    }
    assert_eq!(rows, 2500);
    let [mu, mass, stiffness] = sums.map(|sum| sum / 2500.0);
    // Four standard errors of each mean.
    assert!((mu - 0.16).abs() < 4.0 * 0.08 / (12.0f64 * 2500.0).sqrt(), "{mu}");
    assert!(mass.abs() < 4.0 * 4.0f64.ln() / (12.0f64 * 2500.0).sqrt(), "{mass}");
    assert!((stiffness - 2.0).abs() < 4.0 * 0.1 / 50.0, "{stiffness}");
    assert!(slipped > 100, "{slipped}");
}

#[test]
fn shards_threads_and_interruptions_give_the_same_bytes() {
    let whole = tempfile::tempdir().unwrap();
    let study = study(STUDY).unwrap();
    make(&study, whole.path(), ALL, 1);
    let expected = table(&study, whole.path());
    let parts = tempfile::tempdir().unwrap();
    for (number, rows) in [(3, 500), (1, 1000), (2, 1000)] {
        let shard = Shard { number, count: 3 };
        assert_eq!(study.rows_of(shard), rows);
        assert_eq!(make(&study, parts.path(), shard, 3).rows, rows);
    }
    assert!(table(&study, parts.path()) == expected);
    let resumed = tempfile::tempdir().unwrap();
    let cancel = AtomicBool::new(false);
    let stop = AtomicUsize::new(0);
    let interrupt = |rows: usize| {
        if stop.fetch_add(rows, Ordering::Relaxed) == 1700 {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    let done = study.make(resumed.path(), ALL, NonZeroUsize::MIN, None, &cancel, &interrupt).unwrap();
    assert_eq!((done.rows, done.cancelled), (1000, true));
    let refusal = study.merge(resumed.path(), &resumed.path().join("study.csv")).unwrap_err().to_string();
    assert!(refusal.ends_with("2 of 3 chunks are missing, the first one is 1"), "{refusal}");
    assert_eq!(make(&study, resumed.path(), ALL, 2), Done { rows: 1500, found: 1000, failed: 0, cancelled: false });
    assert!(table(&study, resumed.path()) == expected);
}

/// Neither the beginning of a table nor a file of another name is left.
#[test]
fn a_table_is_there_as_a_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let study = study(STUDY).unwrap();
    make(&study, folder.path(), ALL, 2);
    let (last, to) = (folder.path().join("chunk-000002.csv"), folder.path().join("study.csv"));
    let mut bytes = fs::read(&last).unwrap();
    bytes.extend(b"\xff\n");
    fs::write(&last, bytes).unwrap();
    let refusal = study.merge(folder.path(), &to).unwrap_err().to_string();
    assert!(refusal.contains("chunk-000002.csv: "), "{refusal}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
}

#[test]
fn rows_that_fail_keep_their_reason_and_the_others() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("samples.csv"), "mass, mu_s\n1.0, 0.15\n1.0, 0.05\n2.0, 0.2\n").unwrap();
    let text =
        "table = \"samples.csv\"\nkeep = [\"events\"]\n[run]\nlaw = [\"CoulombStiction\", \"LuGre\"]\nuntil = 9.0\n";
    let study = Study::new(toml::from_str(text).unwrap(), folder.path()).unwrap();
    assert_eq!(make(&study, folder.path(), ALL, 2).failed, 2);
    let table = table(&study, folder.path());
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows.len(), 7, "{table}");
    assert!(rows[1].starts_with("0,CoulombStiction,1,0.15,") && rows[1].ends_with(",reached"), "{table}");
    assert!(rows[2].starts_with("1,CoulombStiction,1,0.05,,") && rows[2].contains("mu_s = 0.05"), "{table}");
    assert!(rows[6].starts_with("5,LuGre,2,0.2,"), "{table}");
}

/// As spreadsheets of countries with decimal commas write it.
#[test]
fn a_table_of_samples_may_have_decimal_commas_and_comments() {
    let folder = tempfile::tempdir().unwrap();
    let samples = |text: &str| {
        fs::write(folder.path().join("samples.csv"), text).unwrap();
        let description =
            "table = \"samples.csv\"\nkeep = [\"events\"]\n[run]\nlaw = [\"CoulombStiction\"]\nuntil = 1.0\n";
        Study::new(toml::from_str(description).unwrap(), folder.path())
    };
    let study = samples("\u{feff}# drawn by hand\nrig.mass; mu_s\n1,5; 0,15\n2; 0,2\n").unwrap();
    make(&study, folder.path(), ALL, 1);
    let table = table(&study, folder.path());
    assert!(table.contains("\n0,CoulombStiction,1.5,0.15,") && table.contains("\n1,CoulombStiction,2,0.2,"), "{table}");
    let refused = |text: &str| samples(text).unwrap_err().to_string();
    assert!(
        refused("rig.mass [kg]\n1\n")
            .ends_with("samples.csv: rig.mass [kg]: must have no unit: the values are in SI units")
    );
    assert!(refused("rig.mass\n1\nnan\n").ends_with("samples.csv: line 3, rig.mass: 'nan' is not a finite number"));
}

#[test]
fn a_row_whose_step_does_not_hold_fails() {
    let text = "samples = 2\nkeep = [\"last rig.position\"]\n[vary]\nmu_k = { uniform = [0.09, 0.1] }\n[run]\n\
                law = [\"CoulombStiction\", \"LuGre\"]\nsolver = \"co-simulation\"\nstep = 0.02\ncheck = true\n";
    let (study, folder) = (study(text).unwrap(), tempfile::tempdir().unwrap());
    assert_eq!(make(&study, folder.path(), ALL, 1).failed, 2);
    let rows = table(&study, folder.path());
    let ends: Vec<&str> = rows.lines().skip(1).map(|row| row.splitn(5, ',').nth(4).unwrap()).collect();
    assert_eq!(ends[..2], ["reached", "reached"]);
    assert!(ends[2..].iter().all(|end| end.contains("the step does not hold: ")), "{ends:?}");
}

#[test]
fn mistakes_are_refused_before_anything_runs() {
    for (from, to, expected) in [
        ("rig.mass\" =", "rig.mas\" =", "variable of rig (BeltRig) 'mas' does not exist (did you mean 'mass'?)"),
        ("mu_s =", "mu_ss =", "variable of the system 'mu_ss' does not exist (did you mean 'mu_s'?)"),
        (
            "[0.12, 0.2]",
            "[0.2, 0.12]",
            "vary.mu_s = [0.2, 0.12]: uniform: must be finite, and the first below the second",
        ),
        ("[0.5, 2.0]", "[0.0, 2.0]", "vary.rig.mass = [0, 2]: log: must be > 0, and the first below the second"),
        (
            "{ uniform = [0.12, 0.2] }",
            "[0.12, 0.2]",
            "mu_s = [0.12, 0.2]: must be a distribution, such as { uniform = [0.1, 0.2] }",
        ),
        ("{ uniform =", "{ unifrom =", "mu_s: unknown variant `unifrom`, expected one of `uniform`, `log`, `normal`"),
        ("\"events\"", "\"maxi rig.position\"", "quantity 'maxi' does not exist (did you mean 'max'?)"),
        ("\"max rig.position\"", "\"max rig.positon\"", "'positon' does not exist (did you mean 'position'?)"),
        ("samples = 2500", "samples = 0", "samples = 0: must be from 1 to 1000000000"),
        ("samples = 2500", "", "samples: must be given, or a table"),
        ("samples = 2500", "table = \"none.csv\"", "none.csv: "),
        ("tol = 1e-6", "tol = 0.5", "tolerance = 5e-1: must be between 1e-14 and 0.1"),
        ("seed = 7", "seeds = 7", "unknown field `seeds`"),
    ] {
        assert!(STUDY.contains(from), "{from}");
        let refusal = study(&STUDY.replacen(from, to, 1)).unwrap_err().to_string();
        assert!(refusal.contains(expected), "{refusal}");
    }
    for text in ["0/2", "3/2", "1", "a/b", "1/0"] {
        let refusal = text.parse::<Shard>().unwrap_err().to_string();
        assert_eq!(refusal, format!("shard '{text}': must be i/n with i from 1 to n"));
    }
    let folder = tempfile::tempdir().unwrap();
    let small = STUDY.replace("2500", "3");
    make(&study(&small).unwrap(), folder.path(), ALL, 1);
    let other = study(&small.replace("seed = 7", "seed = 8")).unwrap();
    let refusal = other
        .make(folder.path(), ALL, NonZeroUsize::MIN, None, &AtomicBool::new(false), &quiet)
        .unwrap_err()
        .to_string();
    assert!(refusal.ends_with("belongs to another study: choose another folder, or remove it"), "{refusal}");
}

/// Chunks of a system or a signal as it was before are not taken for those of the present one.
#[test]
fn a_file_that_changed_makes_another_study() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let drive = include_str!("../system/built_in/belt-drive.toml");
    let drive =
        drive.replace("{ ramp = { rate = 0.01, to = 0.2 } }", "{ csv = { file = \"belt.csv\", column = \"v\" } }");
    let file = path("drive.toml");
    let text = format!("samples = 2\nkeep = [\"events\"]\n[run]\nsystem = '{}'\n", file.display());
    let hash = |system: &str, signal: &str| {
        fs::write(&file, system).unwrap();
        fs::write(path("belt.csv"), signal).unwrap();
        study(&text).unwrap().hash
    };
    let (signal, other) = ("time,v\n0,0\n20,0.2\n", "time,v\n0,0\n20,0.3\n");
    let before = hash(&drive, signal);
    assert_eq!(hash(&drive, signal), before);
    assert_ne!(hash(&drive, other), before);
    assert_ne!(hash(&drive.replace("until = 40.0", "until = 30.0"), signal), before);
}

/// As clusters number the jobs of an array.
#[test]
fn a_job_of_an_array_knows_its_part() {
    let of = |text: &str, set: &[(&str, &str)]| {
        let variable = |name: &str| set.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned());
        Shard::of_array(text, &variable).map_err(|fault| fault.to_string())
    };
    let slurm = |id| {
        let [step, count] = [("SLURM_ARRAY_TASK_STEP", "10"), ("SLURM_ARRAY_TASK_COUNT", "4")];
        [("SLURM_ARRAY_TASK_ID", id), ("SLURM_ARRAY_TASK_MIN", "5"), step, count]
    };
    assert_eq!(of("array", &slurm("5")), Ok(Shard { number: 1, count: 4 }));
    assert_eq!(of("array", &slurm("35")), Ok(Shard { number: 4, count: 4 }));
    assert!(of("array", &slurm("45")).unwrap_err().contains("SLURM_ARRAY_TASK_ID = 45 is not one of the jobs"));
    assert!(of("array", &slurm("x")).unwrap_err().contains("'x' is not a number"));
    let aws = [("AWS_BATCH_JOB_ARRAY_INDEX", "0"), ("AWS_BATCH_JOB_ARRAY_SIZE", "3")];
    assert_eq!(of("array", &aws), Ok(Shard { number: 1, count: 3 }));
    assert_eq!(of("array/8", &[("PBS_ARRAY_INDEX", "8")]), Ok(Shard { number: 8, count: 8 }));
    assert!(of("array", &[("PBS_ARRAY_INDEX", "8")]).unwrap_err().contains("give array/n"));
    assert!(of("array/8", &[("SGE_TASK_ID", "undefined")]).unwrap_err().contains("is not a job of an array"));
}
