//! `m4`, a C compiler and make: what building GMP takes besides Rust.

use std::process::{Command, Stdio};

/// The package managers we know, with the command that installs m4.
const INSTALLERS: &[(&str, &[&[&str]])] = &[
    ("apt-get", &[&["apt-get", "update", "-qq"], &["apt-get", "install", "-y", "-qq", "m4"]]),
    ("dnf", &[&["dnf", "install", "-y", "-q", "m4"]]),
    ("apk", &[&["apk", "add", "--quiet", "m4"]]),
    ("brew", &[&["brew", "install", "--quiet", "m4"]]),
];

/// Makes sure that GMP can be built, installing m4 where that needs no question.
pub fn ensure() -> Result<(), String> {
    for (tool, names) in [("a C compiler", &["cc", "gcc", "clang"][..]), ("make", &["make", "gmake"][..])] {
        if !names.iter().any(|name| on_path(name)) {
            return Err(format!("{tool} is missing (looked for {}); install it and run this again", names.join(", ")));
        }
    }
    if ["m4", "gm4"].iter().any(|name| on_path(name)) {
        return Ok(());
    }
    let Some((manager, commands)) = INSTALLERS.iter().find(|(manager, _)| on_path(manager)) else {
        return Err(
            "`m4` is missing, and GMP (through `rug`) needs it to build; install the package `m4` and run this \
                    again"
                .to_owned(),
        );
    };
    // brew refuses to run as root and needs no help; the others need root.
    let prefix: &[&str] = match (*manager, is_root()) {
        ("brew", _) | (_, true) => &[],
        _ if sudo_without_password() => &["sudo", "-n"],
        _ => {
            let last = commands.last().map(|words| words.join(" ")).unwrap_or_default();
            return Err(format!("`m4` is missing; type `sudo {last}` and run this again"));
        }
    };
    eprintln!("xtask: m4 is missing, GMP needs it to build; installing it with {manager}");
    for command in *commands {
        let words: Vec<&str> = prefix.iter().chain(command.iter()).copied().collect();
        let ran = Command::new(words[0])
            .args(&words[1..])
            .env("DEBIAN_FRONTEND", "noninteractive")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .status();
        // A stale package list is no reason to stop: only the last command counts.
        let last = Some(command) == commands.last();
        match ran {
            Ok(status) if status.success() => {}
            _ if !last => {}
            Ok(status) => return Err(format!("`{}` ended with {status}; install m4 by hand", words.join(" "))),
            Err(error) => return Err(format!("`{}`: {error}; install m4 by hand", words.join(" "))),
        }
    }
    if on_path("m4") || on_path("gm4") {
        Ok(())
    } else {
        Err(format!("{manager} said that it installed m4, but it is not on the PATH; install it by hand"))
    }
}

fn on_path(name: &str) -> bool {
    std::env::var_os("PATH").is_some_and(|path| std::env::split_paths(&path).any(|dir| dir.join(name).is_file()))
}

fn is_root() -> bool {
    stdout_of("id", &["-u"]).is_some_and(|out| out.trim() == "0")
}

fn sudo_without_password() -> bool {
    on_path("sudo") && stdout_of("sudo", &["-n", "true"]).is_some()
}

fn stdout_of(program: &str, args: &[&str]) -> Option<String> {
    let output = Command::new(program).args(args).stdin(Stdio::null()).stderr(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}
