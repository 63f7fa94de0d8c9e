//! `m4`, a C compiler and make: the requirements of GMP besides Rust.

use std::io::{IsTerminal, Write};
use std::process::{Command, Stdio};

/// The known package managers, with the command that installs m4.
const INSTALLERS: &[(&str, &[&[&str]])] = &[
    ("apt-get", &[&["apt-get", "update", "-qq"], &["apt-get", "install", "-y", "-qq", "m4"]]),
    ("dnf", &[&["dnf", "install", "-y", "-q", "m4"]]),
    ("apk", &[&["apk", "add", "--quiet", "m4"]]),
    ("brew", &[&["brew", "install", "--quiet", "m4"]]),
];

/// The action for a missing package.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Way {
    /// Install it: root needs no permission, and in a container there is nobody to ask.
    Install,
    /// Ask the user at the terminal first.
    Ask,
    /// Print the command to type.
    Print,
}

/// The action for this user; nothing is installed without a yes, except by root.
fn way(is_root: bool, is_terminal: bool) -> Way {
    match (is_root, is_terminal) {
        (true, _) => Way::Install,
        (false, true) => Way::Ask,
        (false, false) => Way::Print,
    }
}

/// Checks that GMP can be built, and offers to install m4 if it is missing.
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
    let is_root = is_root();
    // brew refuses to run as root; the others need it.
    let prefix: &[&str] = if is_root || *manager == "brew" { &[] } else { &["sudo"] };
    let with_prefix = |words: &[&'static str]| -> Vec<&str> { prefix.iter().chain(words).copied().collect() };
    let last = commands.last().map(|words| with_prefix(words).join(" ")).unwrap_or_default();
    match way(is_root, std::io::stdin().is_terminal()) {
        Way::Install => {}
        Way::Ask if agrees(&last)? => {}
        Way::Ask | Way::Print => return Err(format!("`m4` is missing; type `{last}` and run this again")),
    }
    eprintln!("xtask: m4 is missing, GMP needs it to build; installing it with {manager}");
    for command in *commands {
        let words = with_prefix(command);
        let ran = Command::new(words[0])
            .args(&words[1..])
            .env("DEBIAN_FRONTEND", "noninteractive")
            .stdout(Stdio::null())
            .status();
        // An outdated package list must not stop the installation: only the last command counts.
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

/// Returns true if the user says yes to this command.
fn agrees(command: &str) -> Result<bool, String> {
    eprint!("xtask: m4 is missing, GMP needs it to build. Run `{command}` now? [y/N] ");
    std::io::stderr().flush().map_err(|error| error.to_string())?;
    let mut answer = String::new();
    std::io::stdin().read_line(&mut answer).map_err(|error| error.to_string())?;
    Ok(is_yes(&answer))
}

fn is_yes(answer: &str) -> bool {
    matches!(answer.trim().to_ascii_lowercase().as_str(), "y" | "yes")
}

fn on_path(name: &str) -> bool {
    std::env::var_os("PATH").is_some_and(|path| std::env::split_paths(&path).any(|dir| dir.join(name).is_file()))
}

fn is_root() -> bool {
    let output = Command::new("id").arg("-u").stdin(Stdio::null()).stderr(Stdio::null()).output();
    output.is_ok_and(|output| output.status.success() && String::from_utf8_lossy(&output.stdout).trim() == "0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_installed_for_a_user_who_was_not_asked() {
        assert_eq!(way(false, true), Way::Ask);
        assert_eq!(way(false, false), Way::Print);
        assert_eq!([way(true, false), way(true, true)], [Way::Install; 2]);
    }

    #[test]
    fn only_yes_is_yes() {
        assert!([" y\n", "Yes\n"].into_iter().all(is_yes));
        assert!(["\n", "", "n\n", "no\n", "maybe\n"].into_iter().all(|answer| !is_yes(answer)));
    }
}
