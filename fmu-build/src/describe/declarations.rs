//! Declarations of a C header: functions, types and constants. Reads the header made from cbindgen's output and the
//! tables, not every C header.

/// Something that a C program can name.
#[derive(Debug, PartialEq)]
pub struct Declaration {
    /// Its kind.
    pub kind: Kind,
    /// Its name.
    pub name: String,
    /// The whole text of a function or type in one line, or the value of a constant.
    pub text: String,
}

/// Kind of a declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A function.
    Function,
    /// A type.
    Type,
    /// A macro with a value, or an item of an enum.
    Constant,
}

impl Kind {
    /// The kind in one word.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Function => "function",
            Kind::Type => "type",
            Kind::Constant => "constant",
        }
    }
}

/// All declarations, in the order of the header.
pub fn of(header: &str) -> Vec<Declaration> {
    let (mut declarations, mut code) = (Vec::new(), String::new());
    let mut is_for_cpp = false;
    for line in without_comments(header).lines().map(str::trim) {
        is_for_cpp = (is_for_cpp || line == "#ifdef __cplusplus") && !line.starts_with("#endif");
        if let Some(definition) = line.strip_prefix("#define ") {
            declarations.extend(definition.split_once(' ').map(|(name, value)| constant(name, value.trim())));
        } else if !is_for_cpp && !line.starts_with('#') {
            code.push_str(line);
            code.push(' ');
        }
    }
    for statement in statements(&code) {
        declare(&mut declarations, &statement);
    }
    declarations
}

fn constant(name: &str, value: &str) -> Declaration {
    Declaration { kind: Kind::Constant, name: name.into(), text: value.into() }
}

fn without_comments(header: &str) -> String {
    let mut parts = header.split("/*");
    let before = parts.next().unwrap_or_default().to_owned();
    parts.fold(before, |text, part| text + part.split_once("*/").map_or("", |(_, after)| after))
}

/// The code between the semicolons outside braces, with single spaces.
fn statements(code: &str) -> Vec<String> {
    let mut depth = 0;
    let ends = move |letter: char| {
        depth += i32::from(letter == '{') - i32::from(letter == '}');
        letter == ';' && depth == 0
    };
    let words = |statement: &str| statement.split_whitespace().collect::<Vec<_>>().join(" ");
    code.split(ends).map(words).filter(|statement| !statement.is_empty()).collect()
}

fn declare(declarations: &mut Vec<Declaration>, statement: &str) {
    let kind = if statement.starts_with("typedef ") { Kind::Type } else { Kind::Function };
    let name = name(statement, kind);
    if !statement.starts_with("typedef enum") {
        return declarations.push(Declaration { kind, name, text: statement.into() });
    }
    declarations.push(Declaration { kind, name, text: "enum".into() });
    let items = statement.split_once('{').and_then(|(_, rest)| rest.rsplit_once('}')).map_or("", |(items, _)| items);
    let mut next = 0;
    for item in items.split(',').map(str::trim).filter(|item| !item.is_empty()) {
        let (name, value) = item.split_once(" = ").unwrap_or((item, ""));
        let value: i32 = value.parse().unwrap_or(next);
        declarations.push(constant(name, &value.to_string()));
        next = value.saturating_add(1);
    }
}

/// The name in `typedef result (*name)(arguments)`, `typedef ... name` or `result name(arguments)`.
fn name(statement: &str, kind: Kind) -> String {
    let head = match (statement.split_once("(*"), kind) {
        (Some((_, rest)), Kind::Type) if !statement.contains('{') => {
            rest.split_once(')').map_or(rest, |(name, _)| name)
        }
        (_, Kind::Type) => statement,
        _ => statement.split_once('(').map_or(statement, |(head, _)| head),
    };
    head.rsplit([' ', '*']).next().unwrap_or(head).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "/**\n * Not this: call(1);\n */\n#ifndef A_H\n#define A_H\n#include <stddef.h>\n\
        #define A_VERSION \"1.0\"\n#define TRUE 1\n\
        typedef enum {\n  /** Well; all. */\n  OK,\n  BAD = 4,\n  WORSE,\n} status;\n\
        typedef struct model model;\ntypedef struct {\n  const char *text; /* a text */\n  void *(*f)(int);\n} info;\n\
        typedef void *(*callback)(size_t size,\n                          int);\ntypedef const char *string;\n\
        #ifdef __cplusplus\nextern \"C\" {\n#endif // __cplusplus\n\
        const char *text(void);\nstatus set(model *m,\n           int (*other)(void));\n\
        #ifdef __cplusplus\n}  // extern \"C\"\n#endif  // __cplusplus\n#endif /* A_H */\n";

    fn found(kind: Kind) -> Vec<(String, String)> {
        let of_kind = of(HEADER).into_iter().filter(|declaration| declaration.kind == kind);
        of_kind.map(|Declaration { name, text, .. }| (name, text)).collect()
    }

    fn expected(pairs: &[(&str, &str)]) -> Vec<(String, String)> {
        pairs.iter().map(|(name, text)| ((*name).into(), (*text).into())).collect()
    }

    #[test]
    fn functions_have_their_signature_in_one_line() {
        let functions = [("text", "const char *text(void)"), ("set", "status set(model *m, int (*other)(void))")];
        assert_eq!(found(Kind::Function), expected(&functions));
    }

    #[test]
    fn types_have_their_fields() {
        let types = [
            ("status", "enum"),
            ("model", "typedef struct model model"),
            ("info", "typedef struct { const char *text; void *(*f)(int); } info"),
            ("callback", "typedef void *(*callback)(size_t size, int)"),
            ("string", "typedef const char *string"),
        ];
        assert_eq!(found(Kind::Type), expected(&types));
    }

    #[test]
    fn constants_have_their_value_written_or_counted() {
        let constants = [("A_VERSION", "\"1.0\""), ("TRUE", "1"), ("OK", "0"), ("BAD", "4"), ("WORSE", "5")];
        assert_eq!(found(Kind::Constant), expected(&constants));
    }

    #[test]
    fn functions_of_the_library_are_found() {
        let header = std::fs::read_to_string(crate::project::root().join("include/stribeck.h")).unwrap();
        let declarations = of(&header);
        for name in ["fmi2DoStep", "fmi2GetTypesPlatform", "stribeck_create", "stribeck_model_name"] {
            let is_it = |known: &Declaration| known.kind == Kind::Function && known.name == name;
            assert!(declarations.iter().any(is_it), "{name}");
        }
    }
}
