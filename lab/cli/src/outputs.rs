//! Checks of output files before the work for them.

use std::path::Path;

use stribeck_solve::system::Fault;

/// Whether a file has an extension, in upper or lower case.
pub fn has_ending(path: &Path, wanted: &str) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(wanted))
}

/// Rejects a file with another extension, in a folder that does not exist, or that is a folder.
pub fn file(path: &Path, endings: &[&str]) -> Result<(), Fault> {
    let refused = |why: String| Err(Fault::File(format!("{}: {why}", path.display())));
    if !endings.iter().any(|ending| has_ending(path, ending)) {
        return refused(format!("must end in {}", one_of(endings)));
    }
    if path.is_dir() {
        return refused("is a folder, must be a file".to_owned());
    }
    let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if parent.is_dir() { Ok(()) } else { refused(format!("folder {} does not exist", parent.display())) }
}

/// Endings as a text: `.a, .b or .c`.
fn one_of(endings: &[&str]) -> String {
    match endings {
        [others @ .., last] if !others.is_empty() => format!(".{} or .{last}", others.join(", .")),
        _ => format!(".{}", endings.concat()),
    }
}

/// Rejects a folder that cannot be created because it or one of its parents is a file.
pub fn folder(path: &Path) -> Result<(), Fault> {
    match path.ancestors().find(|part| part.exists()) {
        Some(part) if !part.is_dir() => {
            let text = format!("{}: must be a folder; {} is a file", path.display(), part.display());
            Err(Fault::File(text))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_written_is_refused() {
        let here = tempfile::tempdir().unwrap();
        let at = |name: &str| here.path().join(name);
        std::fs::write(at("taken"), "").unwrap();
        std::fs::create_dir(at("folder.toml")).unwrap();
        let refusal = |result: Result<(), Fault>| result.unwrap_err().to_string();
        let endings = ["toml", "csv"];
        assert!(file(&at("a.TOML"), &endings).is_ok() && file(Path::new("a.csv"), &endings).is_ok());
        assert!(refusal(file(&at("a.txt"), &endings)).ends_with("a.txt: must end in .toml or .csv"));
        assert!(refusal(file(&at("a"), &endings)).ends_with("a: must end in .toml or .csv"));
        assert!(refusal(file(&at("folder.toml"), &endings)).ends_with("is a folder, must be a file"));
        let absent = at("absent");
        assert!(
            refusal(file(&absent.join("a.csv"), &endings))
                .ends_with(&format!("folder {} does not exist", absent.display()))
        );
        assert!(folder(here.path()).is_ok() && folder(&absent.join("deeper")).is_ok());
        assert!(folder(Path::new("new")).is_ok());
        for path in [at("taken"), at("taken").join("in it")] {
            assert!(refusal(folder(&path)).ends_with("taken is a file"));
        }
    }
}
