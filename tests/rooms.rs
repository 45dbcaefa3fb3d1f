//! The modules of each crate import downwards only, no files import each other in a circle; files and functions stay
//! short.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A crate with its top-level modules: each may use those before it.
struct House {
    folder: &'static str,
    rooms: &'static [&'static str],
}

const HOUSES: &[House] = &[
    House {
        folder: "src",
        rooms: &[
            "number",
            "numerics",
            "unit",
            "memory",
            "table",
            "guid",
            "reference",
            "model",
            "arrays",
            "laws",
            "contact",
            "friction",
            "component",
            "host",
            "shock_absorber",
            "catalogue",
            "consistency",
            "instance",
            "serial",
            "series",
            "batch",
        ],
    },
    House { folder: "ffi/src", rooms: &["guard", "models", "component", "fmi2", "fmi3", "c"] },
    House { folder: "ssp/src", rooms: &["xml", "units", "parameter_set", "system"] },
    House { folder: "lab/draw/src", rooms: &["text", "axis", "curve", "frame"] },
    House {
        folder: "lab/sheet/src",
        rooms: &["units", "time_stamp", "error", "guard", "heading", "sheet", "spreadsheet", "mat", "binary"],
    },
    House {
        folder: "lab/measured/src",
        rooms: &[
            "error",
            "statistics",
            "stencil",
            "movement",
            "drive",
            "clock",
            "record",
            "cycle",
            "quality",
            "polynomial",
            "window",
            "matched_filter",
            "plausible",
            "reduce",
            "units",
            "columns",
        ],
    },
    House { folder: "lab/solve/src", rooms: &["work", "solve", "system", "job", "couple", "run", "study"] },
    House { folder: "lab/fit/src", rooms: &["thesis", "dyno", "tir", "identify", "rig"] },
    House { folder: "lab/plot/src", rooms: &["palette", "picture", "report"] },
    House { folder: "lab/cli/src", rooms: &["benchmark", "standard_output", "outputs", "command", "damper", "tyre"] },
    House {
        folder: "web/src",
        rooms: &[
            "answer",
            "values",
            "progress",
            "catalogue",
            "parameters",
            "series",
            "strokes",
            "rig",
            "copied",
            "system",
            "solution",
            "program",
            "question",
            "types",
        ],
    },
    House { folder: "fmu-build/src", rooms: &["project", "build", "describe", "page", "sources", "pack"] },
    House { folder: "sources/src", rooms: &["model", "room", "state", "law", "calls"] },
];

/// Macros that are exported from the root of their crate, and the rooms that declare them.
const MACROS: &[(&str, &str)] = &[("choices", "model"), ("packed", "table"), ("part", "model")];

/// Folders of Rust code; a crate within a crate has its own.
const FOLDERS: &[&str] = &[
    "benches",
    "ffi",
    "ffi/library",
    "fmu-build",
    "fuzz",
    "lab/cli",
    "lab/draw",
    "lab/fit",
    "lab/plot",
    "lab/sheet",
    "lab/measured",
    "lab/solve",
    "python",
    "sources",
    "src",
    "ssp",
    "tests",
    "tests/importers",
    "tests/lanes",
    "web",
    "web/clock",
];

/// Longest file, in lines.
const LONGEST_FILE: usize = 700;

/// Largest crate, in lines without its tests.
const LARGEST_CRATE: usize = 12_000;

/// Longest function, in lines from `fn` to the closing brace.
const LONGEST_FUNCTION: usize = 45;

/// Files that may use each other, with the reason.
const CIRCLES: &[(&str, &str, &str)] = &[("src", "model", "the trait Model names the types that are made from it")];

/// Use of a room of the same crate.
#[derive(Debug, PartialEq)]
struct Import {
    room: String,
    line: usize,
}

/// Function with the number of its lines.
#[derive(Debug, PartialEq)]
struct Function {
    name: String,
    line: usize,
    lines: usize,
}

/// Contents of a file, apart from comments and test code.
#[derive(Debug, Default)]
struct Contents {
    imports: Vec<Import>,
    /// Paths of what it uses, from the root of its crate.
    paths: Vec<Vec<String>>,
    /// Names that it passes on, with their paths.
    passed_on: Vec<(String, Vec<String>)>,
    /// Modules in files of their own that only tests have.
    test_modules: Vec<String>,
}

impl Contents {
    /// Contents of a module with this path from the root of its crate.
    fn of(text: &str, module: &[&str]) -> Contents {
        let mut contents = Contents::default();
        let module: Vec<String> = module.iter().map(ToString::to_string).collect();
        contents.read(text.parse().expect("Rust"), &module);
        contents
    }

    fn read(&mut self, stream: TokenStream, module: &[String]) {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let depth = module.len();
        let mut at = 0;
        while at < tokens.len() {
            if is_test_attribute(&tokens[at..]) {
                at = self.skip_test(&tokens, at + 2);
                continue;
            }
            if let Some(path) = path_from_root(&tokens[at..], depth) {
                self.import(&tokens[at + path]);
            }
            if at == 0 || !is(&tokens[at - 1], ":") {
                self.paths.extend(paths(&tokens[at..], module));
            }
            if is(&tokens[at], "pub") {
                self.passed_on.extend(passed_on(&tokens[at + 1..], module));
            }
            if let TokenTree::Group(group) = &tokens[at] {
                let is_module = at >= 2 && is(&tokens[at - 2], "mod") && group.delimiter() == Delimiter::Brace;
                let inner = is_module.then(|| tokens[at - 1].to_string());
                self.read(group.stream(), &module.iter().cloned().chain(inner).collect::<Vec<String>>());
            }
            at += 1;
        }
    }

    /// Passes over the item or statement at `at`, which only tests have.
    fn skip_test(&mut self, tokens: &[TokenTree], at: usize) -> usize {
        let is_end = |token: &TokenTree| is(token, ";") || as_block(token).is_some();
        let end = (at..tokens.len()).find(|&end| is_end(&tokens[end])).expect("end of an item");
        if let [.., keyword, name, semicolon] = &tokens[at..=end]
            && is(keyword, "mod")
            && is(semicolon, ";")
        {
            self.test_modules.push(name.to_string());
        }
        end + 1
    }

    /// Adds the rooms named by this token: a name, or names in braces.
    fn import(&mut self, token: &TokenTree) {
        match token {
            TokenTree::Ident(name) => {
                self.imports.push(Import { room: name.to_string(), line: name.span().start().line });
            }
            TokenTree::Group(group) => {
                let mut is_first = true;
                for token in group.stream() {
                    if is_first {
                        self.import(&token);
                    }
                    is_first = is(&token, ",");
                }
            }
            _ => {}
        }
    }
}

/// Paths that begin here with `crate` or `super`, from the root; several if they end in braces.
fn paths(tokens: &[TokenTree], module: &[String]) -> Vec<Vec<String>> {
    let is_step = |at: usize, name: &str| {
        tokens.len() > at + 3 && is(&tokens[at], name) && is(&tokens[at + 1], ":") && is(&tokens[at + 2], ":")
    };
    if is_step(0, "crate") {
        return branches(&tokens[3..], &[]);
    }
    let steps = (0..).take_while(|step| is_step(3 * step, "super")).count();
    match module.len().checked_sub(steps) {
        Some(rest) if steps > 0 => branches(&tokens[3 * steps..], &module[..rest]),
        _ => Vec::new(),
    }
}

/// Paths that go on here from `base`.
fn branches(tokens: &[TokenTree], base: &[String]) -> Vec<Vec<String>> {
    match tokens {
        [TokenTree::Ident(name), rest @ ..] => {
            let path: Vec<String> = base.iter().cloned().chain([name.to_string()]).collect();
            match rest {
                [first, second, rest @ ..] if is(first, ":") && is(second, ":") => branches(rest, &path),
                _ => vec![path],
            }
        }
        [TokenTree::Group(group), ..] => {
            let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
            tokens.split(|token| is(token, ",")).flat_map(|one| branches(one, base)).collect()
        }
        _ => Vec::new(),
    }
}

/// Names that a module passes on from the modules within it, by a `use` behind `pub`.
fn passed_on(tokens: &[TokenTree], module: &[String]) -> Vec<(String, Vec<String>)> {
    let tokens = if matches!(tokens.first(), Some(TokenTree::Group(_))) { &tokens[1..] } else { tokens };
    let [keyword, rest @ ..] = tokens else { return Vec::new() };
    if !is(keyword, "use") {
        return Vec::new();
    }
    let named = |path: Vec<String>| Some((path.last()?.clone(), path));
    branches(rest, module).into_iter().filter_map(named).collect()
}

/// Functions of a file, those of tests too.
fn functions(stream: TokenStream) -> Vec<Function> {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let mut found = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        found.extend(function(&tokens[at..]));
        if let TokenTree::Group(group) = token {
            found.extend(functions(group.stream()));
        }
    }
    found
}

/// The function that begins here, if one does.
fn function(tokens: &[TokenTree]) -> Option<Function> {
    let [keyword, name, rest @ ..] = tokens else { return None };
    if !is(keyword, "fn") || matches!(name, TokenTree::Group(_)) {
        return None;
    }
    let body = as_block(rest.iter().find(|token| is(token, ";") || as_block(token).is_some())?)?;
    let line = keyword.span().start().line;
    Some(Function { name: name.to_string(), line, lines: body.span_close().end().line - line + 1 })
}

fn is(token: &TokenTree, text: &str) -> bool {
    !matches!(token, TokenTree::Group(_)) && token.to_string() == text
}

fn as_block(token: &TokenTree) -> Option<&proc_macro2::Group> {
    match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    }
}

/// Whether `#[cfg(test)]` stands here.
fn is_test_attribute(tokens: &[TokenTree]) -> bool {
    let [hash, TokenTree::Group(attribute), ..] = tokens else { return false };
    is(hash, "#") && attribute.to_string().replace(' ', "") == "[cfg(test)]"
}

/// Position of the token behind a path to the root, `crate::` or enough `super::` for a module of this depth.
fn path_from_root(tokens: &[TokenTree], depth: usize) -> Option<usize> {
    let is_step = |at: usize, name: &str| {
        tokens.len() > at + 3 && is(&tokens[at], name) && is(&tokens[at + 1], ":") && is(&tokens[at + 2], ":")
    };
    if is_step(0, "crate") {
        return Some(3);
    }
    let steps = (0..).take_while(|step| is_step(3 * step, "super")).count();
    (steps > 0 && steps == depth).then_some(3 * steps)
}

/// Refusals of the imports of a file in `room`.
fn refusals(house: &House, room: &str, file: &str, imports: &[Import]) -> Vec<String> {
    let place = |room: &str| house.rooms.iter().position(|known| *known == room);
    let Some(own) = place(room) else { return vec![format!("{file}: the room {room} has no place in the order")] };
    let mut refusals = Vec::new();
    for Import { room: used, line } in imports {
        let used = MACROS.iter().find(|(name, _)| name == used).map_or(used.as_str(), |(_, room)| room);
        match place(used) {
            Some(place) if place <= own => {}
            Some(_) => refusals.push(format!("{file}:{line}: {room} stands below {used} and must not use it")),
            None => refusals.push(format!("{file}:{line}: the room {used} has no place in the order")),
        }
    }
    refusals
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All Rust files in a folder of the project, by their paths in it; not those that builds have written.
fn rust_files(folder: &str) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.ends_with("target") {
                continue;
            }
            if path.is_dir() && !path.join("Cargo.toml").exists() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path.strip_prefix(root()).unwrap().to_path_buf());
            }
        }
    }
    files.sort();
    files
}

/// Path of the module in a file, from the root of its crate; that of the root is empty.
fn module_of<'a>(file: &'a Path, house: &House) -> Vec<&'a str> {
    let file = file.strip_prefix(house.folder).unwrap();
    let mut module: Vec<&str> = file.iter().map(|part| part.to_str().unwrap().trim_end_matches(".rs")).collect();
    if matches!(module.last(), Some(&("mod" | "lib" | "main"))) {
        module.pop();
    }
    module
}

/// Every file of a crate apart from those that only tests have, with its module path and its contents.
fn contents(house: &House) -> Vec<(String, Vec<String>, Contents)> {
    let mut tests = BTreeSet::new();
    let mut files = Vec::new();
    for file in rust_files(house.folder) {
        let module = module_of(&file, house);
        let contents = Contents::of(&fs::read_to_string(root().join(&file)).unwrap(), &module);
        let module: Vec<String> = module.into_iter().map(str::to_string).collect();
        let of_tests = contents.test_modules.iter();
        tests.extend(of_tests.map(|name| module.iter().chain([name]).cloned().collect::<Vec<String>>()));
        files.push((file.display().to_string(), module, contents));
    }
    files.retain(|(_, module, _)| !tests.iter().any(|test| module.starts_with(test)));
    files
}

#[test]
fn imports_run_down() {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for house in HOUSES {
        for (file, module, contents) in contents(house) {
            seen += contents.imports.len();
            if let [room, ..] = module.as_slice() {
                wrong.extend(refusals(house, room, &file, &contents.imports));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(seen > 300, "only {seen} imports were found");
}

#[test]
fn every_room_of_the_order_exists() {
    for house in HOUSES {
        let files = rust_files(house.folder);
        let rooms: BTreeSet<&str> = files.iter().filter_map(|file| module_of(file, house).first().copied()).collect();
        for room in house.rooms {
            assert!(rooms.contains(room), "{}: {room}", house.folder);
        }
    }
}

#[test]
fn files_are_short() {
    for folder in FOLDERS {
        for file in rust_files(folder) {
            let lines = fs::read_to_string(root().join(&file)).unwrap().lines().count();
            assert!(lines <= LONGEST_FILE, "{}: {lines} lines", file.display());
        }
    }
}

#[test]
fn crates_are_small() {
    for house in HOUSES.iter().filter(|house| house.folder.starts_with("lab/")) {
        let lines = |(file, ..): &(String, Vec<String>, Contents)| {
            let text = fs::read_to_string(root().join(file)).unwrap();
            text.lines().take_while(|line| *line != "mod tests {").count()
        };
        let all: usize = contents(house).iter().map(lines).sum();
        assert!((100..=LARGEST_CRATE).contains(&all), "{}: {all} lines", house.folder);
    }
}

#[test]
fn functions_are_short() {
    let mut long = Vec::new();
    let mut seen = 0;
    for folder in FOLDERS {
        for file in rust_files(folder) {
            let functions = functions(fs::read_to_string(root().join(&file)).unwrap().parse().expect("Rust"));
            seen += functions.len();
            for Function { name, line, lines } in functions {
                if lines > LONGEST_FUNCTION {
                    long.push(format!("{}:{line}: {name} has {lines} lines", file.display()));
                }
            }
        }
    }
    assert!(long.is_empty(), "{}", long.join("\n"));
    assert!(seen > 4000, "only {seen} functions were found");
}

/// Uses of files by each other: from module to module. Modules that consist of others only pass names on.
fn uses(files: &[(String, Vec<String>, Contents)]) -> BTreeMap<&[String], BTreeSet<&[String]>> {
    let modules: BTreeMap<&[String], &Contents> =
        files.iter().map(|(_, module, contents)| (module.as_slice(), contents)).collect();
    let has_rooms =
        |module: &[String]| modules.keys().any(|other| other.len() > module.len() && other.starts_with(module));
    let target = |path: &[String]| -> Option<&[String]> {
        let mut path = path.to_vec();
        loop {
            let length = (0..=path.len()).rev().find(|length| modules.contains_key(&path[..*length]))?;
            let (module, contents) = modules.get_key_value(&path[..length])?;
            let name = path.get(length);
            let passed = contents.passed_on.iter().find(|(known, to)| Some(known) == name && to.len() > length + 1);
            match passed {
                Some((_, to)) => path.clone_from(to),
                None => return (!has_rooms(module)).then_some(*module),
            }
        }
    };
    let of_file = |(_, module, contents): &'_ (String, Vec<String>, Contents)| -> BTreeSet<&[String]> {
        let targets = contents.paths.iter().filter_map(|path| target(path));
        targets.filter(|target| target != module).collect()
    };
    files.iter().map(|file| (file.1.as_slice(), of_file(file))).filter(|(module, _)| !has_rooms(module)).collect()
}

/// Modules that use each other, directly or through others; each with those it is in a circle with.
fn circles(files: &[(String, Vec<String>, Contents)]) -> BTreeSet<Vec<String>> {
    let uses = uses(files);
    let reached = |from: &[String]| {
        let (mut reached, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(module) = open.pop() {
            open.extend(uses.get(module).into_iter().flatten().filter(|next| reached.insert(next.to_vec())));
        }
        reached
    };
    let reaches: BTreeMap<&[String], BTreeSet<Vec<String>>> = uses.keys().map(|from| (*from, reached(from))).collect();
    let circle = |from: &&[String]| -> Vec<String> {
        let both = reaches.keys().filter(|to| reaches[from].contains(**to) && reaches[*to].contains(*from));
        both.map(|module| module.join("::")).collect()
    };
    reaches.keys().map(circle).filter(|circle| !circle.is_empty()).collect()
}

#[test]
fn no_files_use_each_other() {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for house in HOUSES {
        let files = contents(house);
        seen += uses(&files).values().map(BTreeSet::len).sum::<usize>();
        for circle in circles(&files) {
            let is_known = |(folder, room, _): &(&str, &str, &str)| {
                *folder == house.folder && circle.iter().all(|file| file.starts_with(&format!("{room}::")))
            };
            if !CIRCLES.iter().any(is_known) {
                wrong.push(format!("{}: {}", house.folder, circle.join(", ")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(seen > 500, "only {seen} uses were found");
}

/// The line of a room's crate in the map must name it.
#[test]
fn the_map_names_every_room() {
    let map = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    for House { folder, rooms } in HOUSES {
        let begin = map.find(&format!("- `{folder}`:")).unwrap_or_else(|| panic!("{folder} has no list of rooms"));
        let list = &map[begin + 2..];
        let list = ["\n- ", "\n\n"].iter().fold(list, |list, end| list.split(end).next().unwrap());
        let named =
            |room: &str| list.find(&format!("`{room}`")).unwrap_or_else(|| panic!("{folder}: {room} is missing"));
        let places: Vec<usize> = rooms.iter().map(|room| named(room)).collect();
        assert!(places.is_sorted(), "{folder}: {list}");
    }
}

/// A crate for the tests of the walk.
const SMALL: House = House { folder: "src", rooms: &["cellar", "hall", "attic"] };

fn refused(room: &str, text: &str) -> Vec<String> {
    refusals(&SMALL, room, "file.rs", &Contents::of(text, &[room, "corner"]).imports)
}

#[test]
fn an_import_that_runs_up_is_found() {
    let up = "file.rs:2: hall stands below attic and must not use it";
    for line in [
        "use crate::attic::Box;",
        "use crate::{cellar, attic::{Box, Chest}};",
        "fn f() { crate::attic::f(); }",
        "use super::super::attic;",
        "mod inner { use super::super::super::attic; }",
        "macro_rules! f { () => { $crate::attic::f() }; }",
        "mod test { fn f() { crate::attic::f() } }",
    ] {
        assert_eq!(refused("hall", &format!("// First line.\n{line}")), [up], "{line}");
    }
    let unknown = "file.rs:1: the room loft has no place in the order";
    assert_eq!(refused("hall", "use crate::loft::Box;"), [unknown]);
    assert_eq!(refused("loft", ""), ["file.rs: the room loft has no place in the order"]);
}

#[test]
fn imports_that_run_down_and_tests_are_passed() {
    for text in [
        "use crate::cellar::{Box, attic};",
        "use crate::hall::corner;",
        "use super::attic;",
        "pub(crate) use self::attic::f;",
        "// use crate::attic;\n/// [`crate::attic`]\nfn f() { \"crate::attic\"; }",
        "#[cfg(test)]\nmod tests { use crate::attic; }",
        "fn f() {\n    #[cfg(test)]\n    let x = crate::attic::x;\n    use crate::cellar;\n}",
    ] {
        assert_eq!(refused("hall", text), [""; 0], "{text}");
    }
    assert_eq!(Contents::of("#[cfg(test)]\nmod probe;", &[]).test_modules, ["probe"]);
}

#[test]
fn a_function_is_measured_to_its_closing_brace() {
    let text = "type F = fn(u8);\ntrait A {\n    fn a();\n    fn b(\n    ) {\n        {\n        }\n    }\n}";
    let expected = [Function { name: "b".into(), line: 4, lines: 5 }];
    assert_eq!(functions(text.parse().unwrap()), expected);
    assert_eq!(functions(format!("#[cfg(test)]\nmod tests {{{text}}}").parse().unwrap())[0].lines, 5);
}

#[test]
fn a_circle_of_files_is_found() {
    let files = |texts: &[(&str, &str)]| -> Vec<(String, Vec<String>, Contents)> {
        let file = |(module, text): &(&str, &str)| {
            let path: Vec<&str> = module.split("::").collect();
            (module.to_string(), path.iter().map(ToString::to_string).collect(), Contents::of(text, &path))
        };
        texts.iter().map(file).collect()
    };
    let hall = ("hall", "pub use table::{Lamp, Table};");
    let circle = |table: &str, chair: &str| circles(&files(&[hall, ("hall::table", table), ("hall::chair", chair)]));
    let found = BTreeSet::from([vec!["hall::chair".to_string(), "hall::table".to_string()]]);
    for chair in ["use super::table::Lamp;", "use super::Table;", "use crate::hall::{Lamp as Light};"] {
        assert_eq!(circle("fn f() { super::chair::f() }", chair), found, "{chair}");
        assert_eq!(circle("use super::lamp;", chair), BTreeSet::new(), "{chair}");
        let of_tests = format!("#[cfg(test)]\nmod tests {{ {chair} }}");
        assert_eq!(circle("use super::chair;", &of_tests), BTreeSet::new(), "{chair}");
    }
}
