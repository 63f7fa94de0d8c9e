//! `derive`: what is printed, what is written, and the written predicates in three languages.

use std::path::Path;
use std::process::Command;

use tempfile::tempdir;

use crate::common::{at, expect, run};

/// Runs a program in a folder; panics with its output if it fails.
fn succeeds(folder: &Path, program: &str, args: &[&str]) -> String {
    let output = Command::new(program).args(args).current_dir(folder).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{program} {args:?}: {text}");
    text
}

#[test]
fn a_turn_is_derived() {
    let printed = expect(0, &["derive", "det(a - c, b - c)", "--name", "turn"]).stdout;
    for line in [
        "turn(a, b, c)",
        "6 monomials, degree 2, homogeneous",
        "2 keep the sign, 3 turn it",
        "3 roundings of a term, 4 of the magnitude",
        "coordinates of 30 in 64, 62 in 128",
        "take 110 bits with the sign",
        "eps(a.y) eps(b.x)",
    ] {
        assert!(printed.contains(line), "`{line}` is missing in\n{printed}");
    }
}

#[test]
fn a_mistake_is_shown_in_the_formula() {
    let said = expect(2, &["derive", "det(a - c, b - c) / sq(a)"]).stderr;
    assert!(
        said.contains("line 1, column 19") && said.contains("no division") && said.contains("                    ^"),
        "{said}"
    );
    let said = expect(2, &["ask", "--formula", "nowhere.toml", "compare", "0,0", "1,0"]).stderr;
    assert!(said.contains("nowhere.toml"), "{said}");
}

#[test]
fn a_written_predicate_is_asked_and_compiled() {
    let folder = tempdir().unwrap();
    let formula = "sq(a - p) - sq(b - p)";
    let out = at(&folder, "nearer");
    expect(0, &["derive", formula, "--name", "nearer", "--points", "p,a,b", "--out", &out]);
    let written = Path::new(&out);
    succeeds(written, "rustc", &["--edition", "2021", "--test", "nearer.rs", "-o", "tests"]);
    succeeds(written, "./tests", &[]);
    let toml = written.join("nearer.toml");
    let toml = toml.to_str().unwrap();
    // The nearest doubles of a tie: plain doubles say zero, and exact numbers do not.
    let asked =
        expect(0, &["ask", "--formula", toml, "nearer", "0,0", "0x1p0,0", "0,0x1.0000000000001p0", "-b", "exact,sos"]);
    assert!(asked.stdout.contains("exact value  -"), "{}", asked.stdout);
    let suite = at(&folder, "mine.toml");
    std::fs::write(&suite, "title = \"t\"\n[[generate]]\nfamily = \"near\"\ntask = \"nearer\"\nn = 200\n").unwrap();
    let (runs, hunt) = (at(&folder, "run"), at(&folder, "hunt"));
    expect(0, &["run", "--formula", toml, &suite, "-b", "exact,sos,tolerance", "--out", &runs]);
    let seeds = ["--class", "sign_flip", "--check", "sign", "--out", &hunt];
    let hunted = run(&[&["hunt", "--formula", toml, "nearer", "-b", "naive"][..], &seeds].concat());
    assert!(hunted.stdout.contains("sign_flip"), "{}{}", hunted.stdout, hunted.stderr);
}

#[test]
#[ignore = "needs python3: run by `cargo xtask test`"]
fn a_written_predicate_is_an_engine_in_python() {
    let folder = tempdir().unwrap();
    let out = folder.path().join("power");
    expect(0, &["derive", POWER, "--name", "power", "--out", out.to_str().unwrap()]);
    succeeds(&out, "python3", &["power.py", "--test"]);
    let suite = folder.path().join("mine.toml");
    std::fs::write(&suite, "title = \"t\"\n[[generate]]\nfamily = \"near\"\ntask = \"power\"\nn = 100\n").unwrap();
    let engine = format!("engine:{}", out.join("engine.toml").display());
    let toml = out.join("power.toml");
    let (toml, suite, runs) = (toml.to_str().unwrap(), suite.to_str().unwrap(), at(&folder, "run"));
    expect(0, &["run", "--formula", toml, suite, "-b", &engine, "--out", &runs]);
}

#[test]
#[ignore = "needs a C++ compiler: run by `cargo xtask test`"]
fn a_written_predicate_is_right_in_cpp() {
    let folder = tempdir().unwrap();
    let out = folder.path();
    let volume = "det([a - e, sq(a - e)], [b - e, sq(b - e)], [c - e, sq(c - e)], [d - e, sq(d - e)])";
    expect(0, &["derive", volume, "--name", "inside", "--out", out.to_str().unwrap()]);
    std::fs::write(
        out.join("main.cpp"),
        "#include \"inside.hpp\"\nint main() { return inside_predicate::failures(); }\n",
    )
    .unwrap();
    let flags = [
        "-std=c++17",
        "-O1",
        "-Wall",
        "-Wextra",
        "-pedantic",
        "-Werror",
        "-ffp-contract=off",
        "main.cpp",
        "-o",
        "main",
    ];
    succeeds(out, "c++", &flags);
    succeeds(out, "./main", &[]);
}

/// Builds the engine of a predicate and runs it on the adversaries; returns the exit code and what was printed.
fn judged_in_cpp(out: &Path, name: &str) -> (i32, String) {
    let toml = out.join("engine-cpp.toml");
    expect(0, &["engines", "build", toml.to_str().unwrap()]);
    let suite = out.join("suite.toml");
    let family = |family: &str| format!("[[generate]]\nfamily = \"{family}\"\ntask = \"{name}\"\nn = 100\n");
    std::fs::write(&suite, format!("title = \"t\"\n{}{}{}", family("near"), family("degen"), family("wide-mixed")))
        .unwrap();
    let (engine, runs) = (format!("engine:{}", toml.display()), out.join("run"));
    let (formula, suite, runs) = (out.join(format!("{name}.toml")), suite.to_str().unwrap(), runs.to_str().unwrap());
    let ran = run(&["run", "--formula", formula.to_str().unwrap(), suite, "-b", &engine, "--out", runs]);
    (ran.code, ran.stdout + &ran.stderr)
}

const POWER: &str = "u = a - d; v = b - d; s = c - d; \
                     det([u, sq(u) - (a.w - d.w)], [v, sq(v) - (b.w - d.w)], [s, sq(s) - (c.w - d.w)])";

#[test]
#[ignore = "needs a C++ compiler: run by `cargo xtask test`"]
fn a_written_predicate_is_an_engine_in_cpp() {
    let folder = tempdir().unwrap();
    for (name, formula) in [("power", POWER), ("nearer", "sq(a - p) - sq(b - p)")] {
        let out = folder.path().join(name);
        expect(0, &["derive", formula, "--name", name, "--out", out.to_str().unwrap()]);
        let (code, said) = judged_in_cpp(&out, name);
        assert_eq!(code, 0, "{name}: {said}");
        succeeds(&out, &format!("./{name}-cpp"), &["--test"]);
    }
}

/// The planted fault is a filter whose bound is zero: every estimate passes.
#[test]
#[ignore = "needs a C++ compiler: run by `cargo xtask test`"]
fn a_written_predicate_in_cpp_that_is_wrong_is_seen() {
    let folder = tempdir().unwrap();
    let out = folder.path().join("power");
    expect(0, &["derive", POWER, "--name", "power", "--out", out.to_str().unwrap()]);
    let header = out.join("power.hpp");
    let text = std::fs::read_to_string(&header).unwrap();
    let other = text.replace("const double bound = ", "const double bound = 0 * ");
    assert!(text != other, "the bound is there");
    std::fs::write(&header, other).unwrap();
    let (code, said) = judged_in_cpp(&out, "power");
    assert!(code == 100 && said.contains("sign_flip"), "{code}: {said}");
    let tests = Command::new("./power-cpp").arg("--test").current_dir(&out).status().unwrap();
    assert_eq!(tests.code(), Some(1), "the tests of the header");
}
