//! `stribeck page`: the page for a browser.

use std::path::PathBuf;

use clap::Args;
use stribeck_solve::system::Fault;

use super::{Failure, Verdict, write};

/// The file for the page.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// File for the page (.html)
    #[arg(long, short, default_value = "stribeck.html")]
    out: PathBuf,
}

/// Where the project has the page. A released program does not hold the path of its sources.
const OF_PROJECT: Option<&str> =
    if cfg!(debug_assertions) { Some(concat!(env!("CARGO_MANIFEST_DIR"), "/../../dist/page.html")) } else { None };

/// Writes the page for a browser: that beside the program or that in the folder of the project, since only Node builds it.
pub fn page(arguments: &Arguments) -> Result<Verdict, Failure> {
    let beside = std::env::current_exe().ok().and_then(|program| Some(program.parent()?.join("page.html")));
    let candidates: Vec<PathBuf> = beside.into_iter().chain(OF_PROJECT.map(PathBuf::from)).collect();
    write(&arguments.out, read(&candidates)?)?;
    println!("{}: opens in a browser, from here or from a server", arguments.out.display());
    Ok(Verdict::Done)
}

/// The first of these files that exists.
fn read(candidates: &[PathBuf]) -> Result<String, Failure> {
    let Some(path) = candidates.iter().find(|path| path.is_file()) else {
        let names: Vec<String> = candidates.iter().map(|path| path.display().to_string()).collect();
        let text = format!(
            "page not found ({}): put dist/page.html, which `make page` writes (needs Node.js), beside the program",
            names.join(", ")
        );
        return Err(Fault::File(text).into());
    };
    let text = std::fs::read_to_string(path).map_err(|source| Failure::File { path: path.clone(), source })?;
    let version = env!("CARGO_PKG_VERSION");
    if !text.contains(&format!("<meta name=\"generator\" content=\"Stribeck {version}\">")) {
        let text = format!("{}: is not the page of version {version}: run `make page`", path.display());
        return Err(Fault::File(text).into());
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_page_of_this_version_is_taken() {
        let folder = tempfile::tempdir().unwrap();
        let [absent, here] = ["absent.html", "page.html"].map(|name| folder.path().join(name));
        let refusal = |candidates: &[PathBuf]| read(candidates).unwrap_err().to_string();
        let text = refusal(std::slice::from_ref(&absent));
        assert!(text.starts_with("page not found (") && text.contains("absent.html"), "{text}");
        std::fs::write(&here, "<meta name=\"generator\" content=\"Stribeck 0.0.1\">").unwrap();
        assert!(refusal(&[absent.clone(), here.clone()]).contains("is not the page of version"));
        let page = concat!("<meta name=\"generator\" content=\"Stribeck ", env!("CARGO_PKG_VERSION"), "\">");
        std::fs::write(&here, page).unwrap();
        assert_eq!(read(&[absent, here]).unwrap(), page);
    }
}
