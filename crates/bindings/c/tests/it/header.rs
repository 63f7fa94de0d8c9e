//! The committed header is the one of the sources.
//!
//! `UPDATE=1 cargo test -p predicament-c --features header header` makes it by cbindgen; `cargo xtask nightly` compares
//! it. cbindgen takes longer to compile than this library, so the test of every day reads the sources on its own: each
//! comment, prototype and enum is in the header, and nothing else is.

use super::file;

/// The files with types and functions of the header, in its order, and the file of the helpers.
pub const SOURCES: [&str; 11] = [
    "src/failure.rs",
    "src/ffi/names.rs",
    "src/ffi/about.rs",
    "src/ffi/doubles.rs",
    "src/ffi/floats.rs",
    "src/ffi/integers.rs",
    "src/ffi/longs.rs",
    "src/ffi/scenes.rs",
    "src/ffi/constructed.rs",
    "src/ffi/queries.rs",
    "src/ffi/mod.rs",
];

/// The text with single blanks between words.
fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A parameter or a result in C.
fn in_c(kind: &str, name: &str) -> String {
    if let Some(kind) = kind.strip_prefix("*const ") {
        return in_c(kind, &format!("*{name}")).replacen("", "const ", 1);
    }
    if let Some(kind) = kind.strip_prefix("*mut ") {
        return in_c(kind, &format!("*{name}"));
    }
    let kind = match kind {
        "f64" => "double",
        "f32" => "float",
        "i8" => "int8_t",
        "i32" => "int32_t",
        "i64" => "int64_t",
        "u32" => "uint32_t",
        "usize" => "size_t",
        "c_char" => "char",
        other => other,
    };
    format!("{kind} {name}")
}

/// The comment that ends above this part of a source, as in the header; its words only.
fn comment(above: &str) -> String {
    let lines = above.trim_end().lines().rev().skip_while(|line| line.trim_start().starts_with("#["));
    let mut lines: Vec<&str> = lines.map_while(|line| line.trim_start().strip_prefix("///")).collect();
    lines.reverse();
    let lines = lines.iter().map(|line| format!(" *{line}"));
    flat(&format!("/** {} */", lines.collect::<Vec<_>>().join(" ")))
}

/// The prototype of a function, from behind its `fn`.
fn prototype(source: &str) -> String {
    let (name, rest) = source.split_once('(').expect("parameters");
    let (parameters, rest) = rest.split_once(')').expect("the end of the parameters");
    let result = rest.split(" {").next().and_then(|rest| rest.trim().strip_prefix("-> ")).unwrap_or("void");
    let parameters = parameters.split(',').filter_map(|one| one.trim().split_once(": "));
    let parameters: Vec<String> = parameters.map(|(name, kind)| in_c(kind, name)).collect();
    let parameters = if parameters.is_empty() { "void".to_owned() } else { parameters.join(", ") };
    flat(&format!("{}({parameters});", in_c(result, name)))
}

/// The enum from behind its `enum`, with comments.
fn enumeration(source: &str) -> String {
    let (name, rest) = source.split_once(" {\n").expect("a body");
    let body = rest.split("\n}").next().unwrap_or_default();
    let mut text = "typedef enum {".to_owned();
    for (above, variant) in body.match_indices(" = ").map(|(at, _)| body[..at].rsplit_once('\n').expect("a line")) {
        let value =
            body.split(&format!("{variant} = ")).nth(1).and_then(|rest| rest.split(',').next()).expect("a value");
        text += &format!(" {}{variant} = {value},", comment(above));
    }
    flat(&format!("{text} }} {name};"))
}

/// All pieces of the header that a source asks for, each with its comment.
fn pieces(source: &str) -> Vec<String> {
    let mut pieces = Vec::new();
    for (at, found) in source.match_indices("#[unsafe(no_mangle)]\n") {
        let behind = &source[at + found.len()..];
        let (_, function) = behind.split_once("extern \"C\" fn ").expect("a function");
        pieces.push(format!("{} {}", comment(&source[..at]), prototype(function)));
    }
    for (at, found) in source.match_indices("#[repr(C)]\n") {
        let (_, behind) = source[at + found.len()..].split_once("pub enum ").expect("an enum");
        pieces.push(format!("{} {}", comment(&source[..at]), enumeration(behind)));
    }
    for (at, found) in source.match_indices("\npub struct predicament_") {
        let name = source[at + found.len()..].split(['(', ' ']).next().unwrap_or_default();
        let name = format!("predicament_{name}");
        pieces.push(format!("{} typedef struct {name} {name};", comment(&source[..at])));
    }
    pieces
}

/// The constants behind the includes.
fn constants() -> String {
    // (cbindgen would write a decimal, which is signed in C.)
    let constants = [
        "\n/** The version of this header. */",
        &format!("#define PREDICAMENT_VERSION \"{}\"", env!("CARGO_PKG_VERSION")),
        "\n/** The bit that the ids of constructed vertices have, and the indices of points do not have. */",
        &format!("#define PREDICAMENT_CONSTRUCTED UINT32_C({:#x})", predicament::ffi::PREDICAMENT_CONSTRUCTED),
    ];
    constants.join("\n")
}

/// The differences between a header and the pieces of the sources.
fn differences(header: &str, pieces: &[String]) -> Vec<String> {
    let (mut text, mut wrong) = (flat(header), Vec::new());
    for piece in pieces {
        if text.contains(piece.as_str()) {
            text = text.replacen(piece.as_str(), "", 1);
        } else {
            wrong.push(format!("not in the header: {piece}"));
        }
    }
    let rest = text.match_indices("/**").map(|(at, _)| text[at..].split("*/").next().unwrap_or_default());
    wrong.extend(rest.map(|comment| format!("only in the header: {comment}*/")));
    wrong
}

#[test]
fn the_header_has_what_the_sources_say() {
    let sources = SOURCES.map(file);
    let mut all: Vec<String> = sources.iter().flat_map(|source| pieces(source)).collect();
    all.push(flat(&constants()));
    assert!(all.len() > 50, "{} pieces", all.len());
    let header = file("include/predicament.h");
    let wrong = differences(&header, &all);
    assert!(wrong.is_empty(), "make the header anew (see cbindgen.toml):\n{}", wrong.join("\n"));
    // A changed comment, type, parameter or value, and a function too many or too few.
    for (old, new) in [
        ("below the number", "under the number"),
        ("const uint32_t *indices", "const int32_t *indices"),
        ("uint32_t d,", "uint32_t d, uint32_t e,"),
        ("PREDICAMENT_INDEX = 4", "PREDICAMENT_INDEX = 5"),
        ("size_t predicament_scene_points(", "int predicament_scene_points("),
        ("/** The version of this header. */", "/** A function. */ void f(void);"),
        ("UINT32_C(0x80000000)", "0"),
    ] {
        let planted = flat(&header).replacen(old, new, 1);
        assert!(planted != flat(&header) && !differences(&planted, &all).is_empty(), "{old}");
    }
    assert!(!differences(&format!("{header}/** Old. */ void f(void);"), &all).is_empty());
}

/// The header as cbindgen makes it.
#[cfg(feature = "header")]
#[test]
fn the_header_is_the_one_of_cbindgen() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(folder.join("cbindgen.toml")).expect("cbindgen.toml");
    let about = file("include/about.txt");
    let about = about.trim_end().lines().map(|line| format!(" * {line}").trim_end().to_owned());
    let about = format!("/*\n{}\n */", about.collect::<Vec<_>>().join("\n"));
    let builder = cbindgen::Builder::new().with_config(config).with_header(about).with_after_include(constants());
    let builder = SOURCES[..10].iter().fold(builder, |builder, name| builder.with_src(folder.join(name)));
    let mut made = Vec::new();
    builder.generate().expect("a header").write(&mut made);
    let made = String::from_utf8(made).expect("text");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(folder.join("include/predicament.h"), &made).expect("written");
    }
    assert!(made == file("include/predicament.h"), "the header is old; run the test with UPDATE=1");
}
