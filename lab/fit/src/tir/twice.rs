//! Keys that a tyre property file gives more than once.

use super::lines::Entry;

/// The entry that counts among those of one key: the last one with a value. Says so if there are several.
pub(super) fn last<'a, 'b>(
    entries: impl Iterator<Item = &'a Entry<'b>>,
    notes: &mut Vec<String>,
) -> Option<&'a Entry<'b>> {
    let all: Vec<&Entry> = entries.filter(|entry| !entry.value.is_empty()).collect();
    let (last, earlier) = all.split_last()?;
    let lines = |of: &[&Entry]| of.iter().map(|entry| entry.line.to_string()).collect::<Vec<_>>().join(", ");
    if let Some(other) = earlier.iter().find(|other| !other.agrees(last)) {
        notes.push(format!(
            "{}: line {} is used ({}) and line {} is not ({}): the last one counts",
            last.key, last.line, last.value, other.line, other.value
        ));
    } else if !earlier.is_empty() {
        notes.push(format!("{}: given more than once with the same value, in lines {}", last.key, lines(&all)));
    }
    Some(last)
}
