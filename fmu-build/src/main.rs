//! Writes the files that are generated from the tables of the models, checks them, and packs FMUs.

mod build;
mod describe;
mod pack;
mod page;
mod project;
mod sources;
#[cfg(test)]
mod specimen;

use std::collections::BTreeMap;
use std::fs;
use std::path::{self, Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail, ensure};
use clap::{Parser, Subcommand};
use ssp::system;
use stribeck_ffi::fmi3;

use crate::build::crates::Parts;
use crate::build::library::{self, Library};
use crate::build::platform::{self, Choice, Platform};
use crate::build::toolchain;
use crate::describe::entry::{self, Entry};
use crate::describe::fmi2::Choices;
use crate::describe::generated::{self, Generated};
use crate::describe::interface::{Interface, Version};
use crate::describe::only_law::OnlyLaw;
use crate::describe::{compatibility, declarations, rules};
use crate::pack::archive::{self, Archiver};
use crate::pack::four_post;
use crate::pack::package::{self, Contents, Form, Packing};
use crate::pack::sbom::{self, Product};
use crate::pack::{licenses, sdk};
use crate::page::{html, texts};
use crate::sources::{Library as SourceLibrary, Purpose};

/// Generates files from the tables of Stribeck's models, and packs the FMUs.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    /// Project folder (default: the one this program was built from).
    #[arg(long, value_name = "FOLDER")]
    project: Option<PathBuf>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write the descriptions in modelDescription, include/stribeck.h and the tables in README.md and docs. Reject
    /// changes to the interface that break hosts, unless the version starts a new series.
    Generate {
        /// Accept changes that break hosts, as before the first release of a series.
        #[arg(long)]
        breaking: bool,
    },
    /// Write nothing; fail if one of these files is stale, a table breaks a rule, or a change breaks hosts.
    Check,
    /// Write only the documentation pages of the FMUs, for viewing.
    Pages {
        /// Models whose pages to write (default: all).
        models: Vec<String>,
        /// Folder for the pages.
        #[arg(long, default_value = "out/pages")]
        out: PathBuf,
    },
    /// Write the texts of the friction laws with their typeset equations, and round ranges for their curves, as JSON for
    /// the page in web.
    Texts {
        /// File for the texts.
        #[arg(long, default_value = "out/texts.json")]
        out: PathBuf,
    },
    /// Build the library and write the four-post rig as an SSP package, with its FMUs and parameter sets.
    Ssp {
        /// Folder for the package.
        #[arg(long, default_value = "dist")]
        out: PathBuf,
        /// Platforms to build for; repeatable.
        #[arg(long, value_name = "PLATFORM", default_value = "host")]
        platform: Vec<Choice>,
    },
    /// List the platforms of FMUs, each with the tools that this machine lacks to build for it.
    Platforms,
    /// Build the library and write the kit for C and C++: header, shared and static library, files for CMake and
    /// pkg-config, examples, licences; a folder for each platform.
    Sdk {
        /// Folder for the folders.
        #[arg(long, default_value = "out/sdk")]
        out: PathBuf,
        /// Platforms to build for; repeatable.
        #[arg(long, value_name = "PLATFORM", default_value = "host")]
        platform: Vec<Choice>,
    },
    /// Write the licences of everything that is linked into a package of the workspace, and the list of its components
    /// (CycloneDX).
    Components {
        /// The package.
        package: String,
        /// Rust's name of the target (default: this machine).
        #[arg(long, value_name = "TRIPLE")]
        target: Option<String>,
        /// Folder for the files.
        #[arg(long, default_value = "out/components")]
        out: PathBuf,
    },
    /// Check a built library as `pack` does: exports, imports, paths of this machine.
    Inspect {
        /// The library file.
        library: PathBuf,
        /// Platform of the library.
        #[arg(long, value_name = "PLATFORM")]
        platform: Choice,
    },
    /// Write C sources of models for controllers, NAME.h and NAME.c of each: C99, without memory of their own.
    Sources {
        /// Models to write (default: all without a choice of law).
        models: Vec<String>,
        /// The only law in the sources of models that have a choice, such as ShockAbsorber.
        #[arg(long, requires = "models")]
        law: Option<String>,
        /// Folder for the files.
        #[arg(long, default_value = "out/sources")]
        out: PathBuf,
    },
    /// Build the library and pack two FMUs per model: for FMI 2.0, and in the folder fmi3 for FMI 3.0.
    Pack {
        /// Models to pack (default: all).
        models: Vec<String>,
        /// Folder for the FMUs.
        #[arg(long, default_value = "dist")]
        out: PathBuf,
        /// Platforms to build for; repeatable. Those whose tools are missing are skipped, with the command that
        /// installs them.
        #[arg(long, value_name = "PLATFORM", default_value = "host")]
        platform: Vec<Choice>,
        /// Fail if a platform must be skipped.
        #[arg(long)]
        strict: bool,
        /// Pack for hosts that know Real variables only as well, in the folder plain: FMI 2.0, Booleans as 0 and 1, choices
        /// by number.
        #[arg(long)]
        plain: bool,
        /// Pack C sources in place of libraries, for targets that compile them: for co-simulation.
        #[arg(long, conflicts_with_all = ["platform", "strict", "plain"])]
        sources: bool,
        /// With --sources: the only law in the sources of models that have a choice, such as ShockAbsorber.
        #[arg(long, requires_all = ["models", "sources"])]
        law: Option<String>,
    },
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let result = root_of(arguments.project).and_then(|root| obey(arguments.command, &root));
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Folder of the project: the given one, or that of this program.
fn root_of(given: Option<PathBuf>) -> Result<PathBuf> {
    let root = path::absolute(given.unwrap_or(project::root().into())).context("cannot find the project folder")?;
    let has_manifest = root.join("Cargo.toml").is_file();
    ensure!(has_manifest, "{} has no Cargo.toml: --project must name the project folder", root.display());
    Ok(root)
}

fn obey(command: Command, root: &Path) -> Result<()> {
    match command {
        Command::Generate { breaking } => generate(root, breaking),
        Command::Check => check(root),
        Command::Pages { models, out } => pages(&models, &out),
        Command::Texts { out } => texts(&out),
        Command::Ssp { out, platform } => ssp(root, &out, &platform),
        Command::Platforms => list_platforms(root),
        Command::Components { package, target, out } => components(root, &package, target, &out),
        Command::Sdk { out, platform } => sdk(root, &out, &platform),
        Command::Inspect { library, platform } => inspect(root, &library, platform),
        Command::Sources { models, law, out } => sources(root, &models, law.as_deref(), &out),
        Command::Pack { models, out, sources: true, law, .. } => pack_sources(root, &models, law.as_deref(), &out),
        Command::Pack { models, out, platform, strict, plain, .. } => {
            let mut forms = vec![Form::Two(Choices::Named), Form::Three];
            forms.extend(plain.then_some(Form::Two(Choices::Plain)));
            pack(root, &models, &out, &platform, strict, &forms)
        }
    }
}

fn generate(root: &Path, may_break: bool) -> Result<()> {
    let Generated { stale, interface } = generated::of(root)?;
    let review = compatibility::review(&Interface::committed(root)?, &interface);
    if !may_break {
        review?;
    }
    for file in &stale {
        file.write(root)?;
        println!("wrote {}", file.path.display());
    }
    if stale.is_empty() {
        println!("nothing to do: all generated files are up to date");
    }
    Ok(())
}

fn check(root: &Path) -> Result<()> {
    let Generated { stale, interface } = generated::of(root)?;
    compatibility::review(&Interface::committed(root)?, &interface)?;
    let mut breaches = rules::breaches(root)?;
    let page = |entry: &Entry| html::Page::of(entry)?.text(Version::Two);
    let faulty_pages = entry::entries().into_iter().filter_map(|entry| page(&entry).err());
    breaches.extend(faulty_pages.map(|fault| format!("{fault:#}")));
    stale.iter().for_each(|file| println!("stale: {}", file.path.display()));
    breaches.iter().for_each(|breach| println!("{breach}"));
    ensure!(stale.is_empty(), "stale files: {}; run `cargo run -p fmu-build -- generate`", stale.len());
    ensure!(breaches.is_empty(), "broken rules: {}", breaches.len());
    println!("figure: {} items of the interface agree with the committed files", interface.rows.len());
    println!("generated files are up to date, and the tables follow the rules");
    Ok(())
}

fn pages(models: &[String], out: &Path) -> Result<()> {
    for entry in &entry::select(models)? {
        package::write_page(entry, out)?;
        println!("{}", out.join(entry.model.name).join("documentation/index.html").display());
    }
    Ok(())
}

fn texts(out: &Path) -> Result<()> {
    let text = texts::json()?.to_string();
    fs::create_dir_all(out.parent().unwrap_or(Path::new(""))).context("cannot make the folder")?;
    fs::write(out, &text).with_context(|| format!("cannot write {}", out.display()))?;
    println!("{}: {} bytes", out.display(), text.len());
    Ok(())
}

fn pack(root: &Path, models: &[String], out: &Path, choices: &[Choice], strict: bool, forms: &[Form]) -> Result<()> {
    let entries = entry::select(models)?;
    refuse_stale(root)?;
    let date = project::packing_date()?;
    let (platforms, left_out) = buildable(root, &platform::platforms(choices)?)?;
    if strict && !left_out.is_empty() {
        bail!("tools are missing:\n{}", left_out.join("\n"));
    }
    let (libraries, archiver) = (build(root, &platforms)?, Archiver::new(date)?);
    ensure!(!libraries.is_empty(), "nothing to pack: every platform was skipped\n{}", left_out.join("\n"));
    let mut bundles = Vec::new();
    for form in forms {
        for (folder, libraries) in bundles_of(*form, &libraries) {
            let packing = Packing::new(root, libraries, date, &archiver)?;
            bundles.push(Bundle { folder: out.join(folder).join(form.subfolder()), form: *form, packing });
        }
    }
    write(&entries, &bundles)?;
    for line in &left_out {
        println!("skipped: {line}");
    }
    Ok(())
}

/// Writes the sources of models for controllers. Their headers come from the tables, not from generated files.
fn sources(root: &Path, models: &[String], law: Option<&str>, out: &Path) -> Result<()> {
    for (entry, law) in with_sources(models, law)? {
        for (name, text) in SourceLibrary::of(root, &entry, Purpose::Controller, law)?.controller()?.files {
            let size = package::save(out, &name, text.as_bytes())?;
            println!("{:<28} {size:>9} bytes", out.join(&name).display());
        }
    }
    Ok(())
}

/// The chosen models, each with its only law if it has a choice, without those that have no C sources if they were not
/// chosen by name.
fn with_sources(models: &[String], law: Option<&str>) -> Result<Vec<(Entry, Option<OnlyLaw>)>> {
    let mut found = Vec::new();
    for entry in entry::select(models)? {
        match OnlyLaw::of(entry.model, law) {
            Ok(law) => found.push((entry, law)),
            Err(why) if models.is_empty() => println!("skipped: {why}"),
            Err(why) => return Err(why),
        }
    }
    Ok(found)
}

fn pack_sources(root: &Path, models: &[String], law: Option<&str>, out: &Path) -> Result<()> {
    let entries = with_sources(models, law)?;
    refuse_stale(root)?;
    let date = project::packing_date()?;
    let archiver = Archiver::new(date)?;
    let packing = Packing::of_sources(root, date, &archiver)?;
    for (entry, law) in &entries {
        let library = SourceLibrary::of(root, entry, Purpose::Fmu, *law)?;
        let contents = Contents::with_law(entry, *law)?;
        for form in [Form::Two(Choices::Named), Form::Three] {
            let folder = out.join(form.subfolder());
            let size = packing.write_sources(&contents, form, &library.fmu(form.version())?, &folder)?;
            println!("{:<28} {size:>9} bytes", folder.join(format!("{}.fmu", entry.model.name)).display());
        }
    }
    println!("{} models as FMUs with C sources in {}", entries.len(), out.display());
    Ok(())
}

/// FMUs that share a folder.
struct Bundle<'a> {
    folder: PathBuf,
    form: Form,
    packing: Packing<'a>,
}

/// The folders for FMUs, with their libraries. An FMU of FMI 3.0 has room for all of them.
fn bundles_of(form: Form, libraries: &[Library]) -> BTreeMap<&'static str, Vec<&Library>> {
    let mut bundles: BTreeMap<&str, Vec<&Library>> = BTreeMap::new();
    for library in libraries {
        let folder = if form == Form::Three { "" } else { library.platform.subfolder() };
        bundles.entry(folder).or_default().push(library);
    }
    bundles
}

/// The platforms for which this machine has the tools, and the missing tools of the others.
fn buildable(root: &Path, platforms: &[Platform]) -> Result<(Vec<Platform>, Vec<String>)> {
    let (mut buildable, mut left_out) = (Vec::new(), Vec::new());
    for platform in platforms {
        let missing = platform.targets.iter().map(|target| target.missing(root)).collect::<Result<Vec<_>>>()?.concat();
        if missing.is_empty() {
            buildable.push(*platform);
        }
        left_out.extend(missing.iter().map(|missing| format!("{}, which lacks {missing}", platform.name())));
    }
    Ok((buildable, left_out))
}

fn inspect(root: &Path, library: &Path, choice: Choice) -> Result<()> {
    let bytes = fs::read(library).with_context(|| format!("cannot read {}", library.display()))?;
    let exports = exports(root)?;
    ensure!(choice != Choice::All, "--platform all: a library is for one platform; name it");
    for platform in platform::platforms(&[choice])? {
        let checked = library::check(root, platform, &bytes, &exports);
        checked.with_context(|| format!("{} is not usable", library.display()))?;
    }
    println!("{} passes all checks: {} functions", library.display(), exports.len());
    Ok(())
}

/// Names of the functions that a library must export: those of the header, and those of FMI 3.0, which the standard's
/// headers declare.
fn exports(root: &Path) -> Result<Vec<String>> {
    let header = root.join("include").join("stribeck.h");
    let header = fs::read_to_string(&header).with_context(|| format!("cannot read {}", header.display()))?;
    let declared = declarations::of(&header).into_iter().filter(|found| found.kind == declarations::Kind::Function);
    Ok(declared.map(|function| function.name).chain(fmi3::lifecycle::functions()).collect())
}

fn build(root: &Path, platforms: &[Platform]) -> Result<Vec<Library>> {
    let functions = exports(root)?;
    let mut libraries = Vec::new();
    for platform in platforms {
        let library = library::build(root, *platform, &functions)?;
        let glibc = library.glibc.as_ref().map(|version| format!(", needs glibc {version}")).unwrap_or_default();
        println!("library for {:<14} {:>9} bytes{glibc}", platform.name(), library.bytes.len());
        libraries.push(library);
    }
    Ok(libraries)
}

fn write(entries: &[Entry], bundles: &[Bundle]) -> Result<()> {
    for entry in entries {
        let contents = Contents::of(entry)?;
        for Bundle { folder, form, packing } in bundles {
            let size = packing.write(&contents, *form, folder)?;
            println!("{:<28} {size:>9} bytes", folder.join(format!("{}.fmu", entry.model.name)).display());
        }
    }
    for Bundle { folder, packing, .. } in bundles {
        println!("{} FMUs for {} in {}", entries.len(), packing.platforms().join(", "), folder.display());
    }
    Ok(())
}

/// Fails if a generated file is stale: the library rejects an FMU whose XML was written from another table.
fn refuse_stale(root: &Path) -> Result<()> {
    if let Some(file) = generated::of(root)?.stale.first() {
        bail!("{} is stale: run `cargo run -p fmu-build -- generate` and review the change", file.path.display());
    }
    Ok(())
}

fn list_platforms(root: &Path) -> Result<()> {
    let (platforms, left_out) = buildable(root, &platform::platforms(&[Choice::All])?)?;
    platforms.iter().for_each(|platform| println!("{}: all tools are here", platform.name()));
    left_out.iter().for_each(|line| println!("skipped: {line}"));
    Ok(())
}

/// The libraries for these platforms, of which none may lack its tools.
fn built(root: &Path, choices: &[Choice]) -> Result<Vec<Library>> {
    refuse_stale(root)?;
    let (platforms, left_out) = buildable(root, &platform::platforms(choices)?)?;
    ensure!(left_out.is_empty(), "tools are missing:\n{}", left_out.join("\n"));
    build(root, &platforms)
}

fn sdk(root: &Path, out: &Path, choices: &[Choice]) -> Result<()> {
    for library in built(root, choices)? {
        let folder = out.join(library.platform.name());
        let files = sdk::files(root, &library)?;
        package::save_all(&folder, &files)?;
        println!("{} files in {}", files.len(), folder.display());
    }
    Ok(())
}

fn components(root: &Path, package: &str, target: Option<String>, out: &Path) -> Result<()> {
    let triple = target.map_or_else(toolchain::host, Ok)?;
    let parts = Parts::of_package(root, package, &triple)?;
    let product = Product { file: format!("{package} for {triple}"), name: package, summary: "Part of Stribeck" };
    let mut files = licenses::files(root, &parts)?;
    files.insert(sbom::FILE.into(), sbom::text(&product, &parts)?.into());
    package::save_all(out, &files)?;
    println!("{} crates, {} files in {}", parts.crates.len(), files.len(), out.display());
    Ok(())
}

fn ssp(root: &Path, out: &Path, choices: &[Choice]) -> Result<()> {
    let date = project::packing_date()?;
    let (libraries, archiver) = (built(root, choices)?, Archiver::new(date)?);
    // libcosim and Ecos do not support enumerations.
    let form = Form::Two(Choices::Numbered);
    for (folder, libraries) in bundles_of(form, &libraries) {
        let packing = Packing::new(root, libraries, date, &archiver)?;
        let mut files = archive::Files::new();
        let models: Vec<String> = four_post::add_to(&mut files, root)?.into_iter().map(str::to_owned).collect();
        for entry in entry::select(&models)? {
            let bytes = packing.fmu(&Contents::of(&entry)?, form)?;
            files.insert(system::fmu(entry.model.name), bytes);
        }
        let file = format!("{}.ssp", four_post::NAME);
        let size = package::save(&out.join(folder), &file, &archiver.zip(&files)?)?;
        println!("{:<20} {size:>9} bytes", Path::new(folder).join(file).display());
    }
    Ok(())
}
