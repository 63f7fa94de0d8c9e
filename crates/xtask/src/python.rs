//! The Python package: its tests on the library that the workspace has built, and the wheel by maturin.

use std::path::{Path, PathBuf};

use crate::command::{Beside, answers, fresh, root, step, target_directory, words};

/// The folder of the package.
const PACKAGE: &str = "crates/bindings/python";
/// The packages that the tests can't do without, as modules.
const NEEDED: [&str; 2] = ["numpy", "pytest"];
/// The packages without which some tests are skipped.
const MORE: [&str; 4] = ["hypothesis", "pandas", "nbclient", "ipykernel"];
/// The file of cargo's library, by system, and its name as a module of Python.
const LIBRARIES: [(&str, &str); 3] =
    [("lib_native.so", "_native.abi3.so"), ("lib_native.dylib", "_native.abi3.so"), ("_native.dll", "_native.pyd")];

/// The interpreter: `PREDICAMENT_PYTHON`, or `python3`.
pub fn interpreter() -> String {
    std::env::var("PREDICAMENT_PYTHON").unwrap_or_else(|_| "python3".to_owned())
}

/// Starts the tests of the package on the library of the profile `ci`; `None` if something is missing, which is
/// printed.
///
/// # Errors
/// If the library was not built, or the package can't be laid out.
pub fn start() -> Result<Option<Beside>, String> {
    let python = interpreter();
    if !answers(&python, &["--version"]) {
        println!("\n== tests in Python: NOT RUN: there is no `{python}` here");
        return Ok(None);
    }
    let missing = |names: &[&'static str]| -> Vec<&'static str> {
        names.iter().copied().filter(|name| !answers(&python, &["-c", &format!("import {name}")])).collect()
    };
    let (needed, more) = (missing(&NEEDED), missing(&MORE));
    if !needed.is_empty() {
        println!(
            "\n== tests in Python: NOT RUN: {} of {} packages are missing: {}; type `{python} -m pip install {}`",
            needed.len(),
            NEEDED.len(),
            needed.join(", "),
            [needed.as_slice(), &more].concat().join(" ")
        );
        return Ok(None);
    }
    if !more.is_empty() {
        println!("\n== tests in Python: some are skipped, for want of {}", more.join(", "));
    }
    let folder = laid_out()?.display().to_string();
    let tests = format!("{PACKAGE}/tests");
    let run = ["-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider", "-p", "predicament.pytest_plugin"];
    let run = words(&python, &[&run[..], &["--rootdir", PACKAGE, &tests]].concat());
    let env = [("PYTHONPATH", folder), ("PYTHONDONTWRITEBYTECODE", "1".to_owned())];
    Beside::start("tests in Python", &run, &env).map(Some)
}

/// Puts the package's sources and cargo's library together, as an installed package has them; returns the folder.
fn laid_out() -> Result<PathBuf, String> {
    let target = target_directory()?;
    let built = target.join("ci").join("deps");
    let library = LIBRARIES.iter().find(|(file, _)| built.join(file).is_file());
    let (file, module) = library.ok_or_else(|| format!("{}: there is no library for Python", built.display()))?;
    let folder = target.join("python");
    let package = folder.join("predicament");
    let failed = |what: &Path| {
        let what = what.display().to_string();
        move |error| format!("{what}: {error}")
    };
    if package.exists() {
        std::fs::remove_dir_all(&package).map_err(failed(&package))?;
    }
    std::fs::create_dir_all(&package).map_err(failed(&package))?;
    let sources = root().join(PACKAGE).join("python").join("predicament");
    for entry in std::fs::read_dir(&sources).map_err(failed(&sources))? {
        let path = entry.map_err(failed(&sources))?.path();
        if path.is_file() {
            let to = package.join(path.file_name().unwrap_or_default());
            std::fs::copy(&path, to).map_err(failed(&path))?;
        }
    }
    // A link is enough, where the system has them: the library is large.
    let (from, to) = (built.join(file), package.join(module));
    if std::fs::hard_link(&from, &to).is_err() {
        std::fs::copy(&from, &to).map_err(failed(&from))?;
    }
    Ok(folder)
}

/// Checks the types of a user's program and of the package by mypy, and the stubs against the package as it runs.
fn types(python: &str, folder: &Path) -> Result<(), String> {
    step("install mypy", &words(python, &["-m", "pip", "install", "--quiet", "mypy>=1.10"]), &[])?;
    let path = |name: &str| root().join(PACKAGE).join(name).display().to_string();
    let (config, program) = (path("pyproject.toml"), path("tests/typed.py"));
    let mypy = ["-m", "mypy", "--strict", "--explicit-package-bases", "--config-file", &config];
    step("types of a user's program", &words(python, &[&mypy[..], &[&program]].concat()), &[])?;
    step("types of the package", &words(python, &[&mypy[..], &["-p", "predicament"]].concat()), &[])?;
    // A cached function of the package's own has the parameters of the cache; the native module lists its names itself.
    let (allowed, names) =
        (folder.join("allowed.txt"), "predicament\\._run\\._types\npredicament\\._native\\.__all__\n");
    std::fs::write(&allowed, names).map_err(|why| format!("{}: {why}", allowed.display()))?;
    let allowed = allowed.display().to_string();
    let test = ["-m", "mypy.stubtest", "--allowlist", &allowed, "--mypy-config-file", &config, "predicament"];
    step("stubs of the package", &words(python, &test), &[])
}

/// Makes the wheel and the source distribution by maturin, installs each in an environment of its own, and runs the
/// tests on the wheel.
///
/// # Errors
/// If there is no Python with venv, a package can't be installed, or a step fails.
pub fn wheel() -> Result<(), String> {
    let python = interpreter();
    if !answers(&python, &["-m", "venv", "--help"]) {
        return Err(format!("a wheel needs `{python}` with venv, so none was made"));
    }
    let folder = root().join(fresh("target/wheel")?);
    let path = |name: &str| folder.join(name).display().to_string();
    let environment = |name: &str| -> Result<String, String> {
        step(&format!("environment {name}"), &words(&python, &["-m", "venv", &path(name)]), &[])?;
        let bin = if cfg!(windows) { "Scripts" } else { "bin" };
        Ok(folder.join(name).join(bin).join("python").display().to_string())
    };
    let pip = |python: &str, packages: &[&str]| {
        let install = [&["-m", "pip", "install", "--quiet"], packages].concat();
        step(&format!("install {}", packages.join(" ")), &words(python, &install), &[])
    };
    let maker = environment("maker")?;
    pip(&maker, &["maturin>=1.9,<2"])?;
    let manifest = format!("{PACKAGE}/Cargo.toml");
    let build = ["-m", "maturin", "build", "--release", "--sdist", "-m", &manifest, "--out", &path("dist")];
    step("the wheel and its sources", &words(&maker, &build), &[])?;
    let made = |end: &str| -> Result<String, String> {
        let entries = std::fs::read_dir(folder.join("dist")).map_err(|error| format!("{}: {error}", path("dist")))?;
        let mut paths = entries.flatten().map(|entry| entry.path().display().to_string());
        paths.find(|path| path.ends_with(end)).ok_or_else(|| format!("maturin has made no file with the end {end}"))
    };
    let user = environment("user")?;
    pip(&user, &[&format!("{}[test]", made(".whl")?), "pandas"])?;
    let test = ["-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider", "--rootdir", PACKAGE, PACKAGE];
    step("tests of the wheel", &words(&user, &test), &[])?;
    types(&user, &folder)?;
    let builder = environment("builder")?;
    pip(&builder, &[&made(".tar.gz")?])?;
    let ask = ["-m", "predicament", "ask", "orient2d", "0,0", "1,0", "0,1", "-b", "exact"];
    step("the program of the sources", &words(&builder, &ask), &[])
}
