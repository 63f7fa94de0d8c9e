//! The C library: built, laid out under a prefix as packages have it, and its examples compiled and run.
//!
//! `cargo xtask test` needs a C compiler only. Checks that need a C++ compiler, pkg-config or CMake do not run where
//! these are missing, and the step says how many.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::command::{answers, cargo_command, ended, fresh, root, step, target_directory, words};
use crate::cpu;

/// The folder of the crate.
const CRATE: &str = "crates/bindings/c";
/// Warnings are errors in all examples.
const WARNINGS: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];
/// The programs that are compiled as examples; beside each is a file with its output.
const EXAMPLES: [&str; 3] = ["signs.c", "migrate.c", "cut.cpp"];
/// The system's libraries that the static library needs.
const SYSTEM: [&str; 3] = ["-lpthread", "-ldl", "-lm"];

/// Builds the library by a profile; returns the folder with it.
fn build(profile: &str) -> Result<PathBuf, String> {
    let build = ["build", "--profile", profile, "--package", "predicament-c"];
    step("build the C library", &cargo_command(&build), &[])?;
    built(profile)
}

/// The folder with the library after a build of it or of its tests.
fn built(profile: &str) -> Result<PathBuf, String> {
    Ok(target_directory()?.join(profile).join("deps"))
}

/// Copies the library, its headers, and its files for pkg-config and CMake into folders under a prefix.
fn lay_out(built: &Path, prefix: &Path) -> Result<(), String> {
    let from = root().join(CRATE);
    let (lib, include, cmake) = (prefix.join("lib"), prefix.join("include"), prefix.join("lib/cmake/predicament"));
    let template = read(&from.join("predicament.pc.in"))?;
    for folder in [&lib, &include, &cmake, &lib.join("pkgconfig")] {
        std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    for name in libraries() {
        copy(&built.join(name), &lib.join(name))?;
    }
    for name in ["predicament.h", "predicament_predicates.h"] {
        copy(&from.join("include").join(name), &include.join(name))?;
    }
    for name in ["predicamentConfig.cmake", "predicamentConfigVersion.cmake"] {
        copy(&from.join("cmake").join(name), &cmake.join(name))?;
    }
    let path = lib.join("pkgconfig/predicament.pc");
    std::fs::write(&path, filled(&template, prefix)).map_err(|error| format!("{}: {error}", path.display()))
}

/// The file of pkg-config for a prefix.
fn filled(template: &str, prefix: &Path) -> String {
    let text = template.replace("@prefix@", &prefix.display().to_string());
    text.replace("@version@", env!("CARGO_PKG_VERSION")).replace("@libs@", &SYSTEM.join(" "))
}

/// The files of the shared and of the static library.
fn libraries() -> [&'static str; 2] {
    if cfg!(target_os = "macos") {
        ["libpredicament.dylib", "libpredicament.a"]
    } else {
        ["libpredicament.so", "libpredicament.a"]
    }
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    std::fs::copy(from, to).map(|_| ()).map_err(|error| format!("{}: {error}", from.display()))
}

/// Makes a release of the library under a prefix, checks its examples, or times its calls.
///
/// The words after `c-library` choose.
pub fn make(arguments: &[String]) -> Result<(), String> {
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["check"] => build("ci").and_then(|_| check()),
        // The bench depends on the judge, which computes in GMP.
        ["bench"] => crate::m4::ensure().and_then(|()| bench(&build("release")?)),
        [] => install(&build("release")?, &root().join(fresh("target/c-library/release")?)),
        ["--prefix", prefix] => {
            let prefix = std::env::current_dir().map_err(|error| format!("the folder: {error}"))?.join(prefix);
            install(&build("release")?, &prefix)
        }
        _ => Err("`c-library` takes `check`, `bench`, `--prefix DIR`, or nothing".to_owned()),
    }
}

fn install(built: &Path, prefix: &Path) -> Result<(), String> {
    lay_out(built, prefix)?;
    let shown = prefix.canonicalize().unwrap_or_else(|_| prefix.to_owned());
    println!("The C library is in {}", shown.display());
    Ok(())
}

/// Times calls from C beside calls from Rust.
fn bench(built: &Path) -> Result<(), String> {
    let folder = root().join(fresh("target/c-library/bench")?);
    lay_out(built, &folder)?;
    let program = folder.join("border").display().to_string();
    let source = root().join(CRATE).join("benches/border.c").display().to_string();
    let include = format!("-I{}", folder.join("include").display());
    let library = format!("-L{}", folder.join("lib").display());
    let rpath = format!("-Wl,-rpath,{}", folder.join("lib").display());
    let compile = ["-std=c11", "-O2", &include, &source, "-o", &program, &library, &rpath, "-lpredicament"];
    step("compile the loops in C", &words("cc", &compile), &[])?;
    let bench = cargo_command(&["bench", "--package", "predicament-c", "--bench", "border"]);
    step("calls from C and from Rust", &bench, &[("PREDICAMENT_BORDER", program)])
}

/// A program from an example: the compiler and its arguments, and the file of the program.
struct Program {
    words: Vec<String>,
    path: PathBuf,
    example: &'static str,
}

/// The command that compiles an example against a prefix, with these flags behind the source.
fn compile(example: &'static str, prefix: &Path, name: &str, flags: &[String]) -> Program {
    let is_cpp = example.ends_with(".cpp");
    let (compiler, standard) = if is_cpp { ("c++", "-std=c++17") } else { ("cc", "-std=c11") };
    let path = prefix.join(format!("{example}-{name}"));
    let mut all = words(compiler, &[standard, "-pthread"]);
    all.extend(WARNINGS.map(str::to_owned));
    all.extend([root().join(CRATE).join("examples").join(example).display().to_string()]);
    all.extend(["-o".to_owned(), path.display().to_string()]);
    all.extend(flags.iter().cloned());
    Program { words: all, path, example }
}

/// Compiles and runs the examples with the library that the tests have used.
pub fn check() -> Result<(), String> {
    let (start, cpu) = (Instant::now(), cpu::of_children());
    let built = built("ci")?;
    let prefix = root().join(fresh("target/c-library/ci")?);
    lay_out(&built, &prefix)?;
    let show = |path: &str| prefix.join(path).display().to_string();
    let include = format!("-I{}", show("include"));
    let is_static = [vec![include.clone(), show("lib/libpredicament.a")], SYSTEM.map(str::to_owned).to_vec()].concat();
    let rpath = format!("-Wl,-rpath,{}", show("lib"));
    let is_shared = vec![include, format!("-L{}", show("lib")), rpath.clone(), "-lpredicament".to_owned()];

    let has = |program: &'static str| answers(program, &["--version"]);
    let [has_cpp, has_pkg_config, has_cmake] = ["c++", "pkg-config", "cmake"].map(has);
    let (mut programs, mut missing) = (Vec::new(), Vec::new());
    for example in EXAMPLES {
        if example.ends_with(".cpp") && !has_cpp {
            missing.push("the example in C++ (no `c++`)");
            continue;
        }
        programs.push(compile(example, &prefix, "static", &is_static));
        programs.push(compile(example, &prefix, "shared", &is_shared));
    }
    if has_pkg_config {
        let flags = [pkg_config(&prefix, &["--cflags", "--libs", "predicament"])?, vec![rpath]].concat();
        programs.push(compile("signs.c", &prefix, "pkg-config", &flags));
    } else {
        missing.push("pkg-config (no `pkg-config`)");
    }
    for program in &programs {
        let what = format!("compile {}", program.path.file_name().unwrap_or_default().to_string_lossy());
        quietly(&what, &mut command(&program.words))?;
    }
    if has_cmake && has_cpp {
        let folder = prefix.join("cmake");
        by_cmake(&prefix, &folder)?;
        for (example, linked) in EXAMPLES.iter().flat_map(|&example| [(example, "shared"), (example, "static")]) {
            let stem = example.split('.').next().unwrap_or_default();
            programs.push(Program { words: Vec::new(), path: folder.join(format!("{stem}-{linked}")), example });
        }
    } else {
        missing.push("the CMake package (no `cmake` or no `c++`)");
    }
    for Program { path, example, .. } in &programs {
        let said = quietly(&format!("run {}", path.display()), &mut Command::new(path))?;
        let expected = read(&root().join(CRATE).join("examples").join(example).with_extension("txt"))?;
        same(example, &expected, &said)?;
    }
    let count = format!("{} programs compiled and run", programs.len());
    ended(&format!("examples of the C library, {count}"), true, "", start, cpu)?;
    if !missing.is_empty() {
        println!("== C library: {} checks NOT RUN: {}", missing.len(), missing.join(", "));
    }
    Ok(())
}

/// Fails if a program has not written its expected lines.
fn same(example: &str, expected: &str, said: &str) -> Result<(), String> {
    if said == expected { Ok(()) } else { Err(format!("{example} wrote\n{said}and not\n{expected}")) }
}

/// The flags that pkg-config prints for the library.
fn pkg_config(prefix: &Path, arguments: &[&str]) -> Result<Vec<String>, String> {
    let mut command = Command::new("pkg-config");
    command.args(arguments).env("PKG_CONFIG_PATH", prefix.join("lib/pkgconfig"));
    Ok(quietly("pkg-config", &mut command)?.split_whitespace().map(str::to_owned).collect())
}

/// Builds all examples by CMake, which finds the library as a package.
fn by_cmake(prefix: &Path, folder: &Path) -> Result<(), String> {
    let examples = root().join(CRATE).join("examples");
    let mut configure = Command::new("cmake");
    configure.arg("-S").arg(examples).arg("-B").arg(folder);
    configure.arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display()));
    quietly("configure by CMake", &mut configure)?;
    quietly("build by CMake", Command::new("cmake").arg("--build").arg(folder).args(["--parallel", "2"])).map(|_| ())
}

fn command(words: &[String]) -> Command {
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]);
    command
}

/// Runs a command and returns what it wrote; shows it only if the command fails.
fn quietly(what: &str, command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{what}: {error}"))?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(said);
    }
    Err(format!("{what} failed: {}\n{said}{}", output.status, String::from_utf8_lossy(&output.stderr)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_filled_template_has_no_field_left() {
        let template = read(&root().join(CRATE).join("predicament.pc.in")).expect("the template");
        let text = filled(&template, Path::new("/opt/predicament"));
        assert!(text.starts_with("prefix=/opt/predicament\n") && !text.contains('@'), "{text}");
        assert!(template.contains("@version@") && text.contains(env!("CARGO_PKG_VERSION")));
    }

    #[test]
    fn other_output_is_an_error() {
        assert_eq!(same("a.c", "1\n", "1\n"), Ok(()));
        assert!(same("a.c", "1\n", "-1\n").unwrap_err().contains("a.c wrote\n-1\n"));
    }

    #[test]
    fn examples_are_compiled_with_warnings_as_errors() {
        let program = compile("cut.cpp", Path::new("/p"), "static", &["-lm".to_owned()]);
        assert!(program.words[0] == "c++" && program.words.contains(&"-Werror".to_owned()));
        assert!(program.words.iter().any(|word| word.ends_with("examples/cut.cpp")));
        for example in EXAMPLES {
            let file = root().join(CRATE).join("examples").join(example);
            assert!(file.is_file() && file.with_extension("txt").is_file(), "{example} and its output");
        }
    }
}
