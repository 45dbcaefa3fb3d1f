//! Blocks of generated lines in files that are otherwise written by hand.

use anyhow::{Context, Result};

/// The text of a file with fresh content between the markers of a block.
pub fn replaced(file: &str, text: &str, block: &str, content: &str) -> Result<String> {
    let begin = format!("<!-- {block}:begin (written by fmu-build generate) -->\n");
    let end = format!("<!-- {block}:end -->");
    let missing = |marker: &str| format!("{file} lacks the line `{}` for generated lines", marker.trim());
    let (before, rest) = text.split_once(&begin).with_context(|| missing(&begin))?;
    let (_, after) = rest.split_once(&end).with_context(|| missing(&end))?;
    Ok(format!("{before}{begin}\n{content}\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEGIN: &str = "<!-- list:begin (written by fmu-build generate) -->";

    #[test]
    fn only_the_block_between_the_markers_changes() {
        let text = format!("# Title\n\n{BEGIN}\na stale block\n<!-- list:end -->\n\nRest.\n");
        let fresh = replaced("page.md", &text, "list", "fresh").unwrap();
        assert_eq!(fresh, format!("# Title\n\n{BEGIN}\n\nfresh\n<!-- list:end -->\n\nRest.\n"));
        assert_eq!(replaced("page.md", &fresh, "list", "fresh").unwrap(), fresh);
    }

    #[test]
    fn missing_markers_are_named() {
        let error = replaced("page.md", "# Title\n", "list", "").unwrap_err().to_string();
        assert!(error.contains("page.md") && error.contains("list:begin"), "{error}");
        let error = replaced("page.md", &format!("{BEGIN}\n"), "list", "").unwrap_err().to_string();
        assert!(error.contains("list:end"), "{error}");
    }
}
