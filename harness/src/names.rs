//! The names of commands: their groups in the help, and their earlier names.

use std::ffi::OsString;

use clap::Command;
use predicament_studies::Entry;

/// The command that runs studies.
pub const STUDY: &str = "study";

/// The top-level commands by group, in the order of the help.
const GROUPS: [(&str, &[&str]); 6] = [
    ("Ask and draw", &["ask", "solve", "draw", "derive"]),
    ("Run and gate", &["run", "gate", "judge", "bench", "report", "scoreboard"]),
    ("Search", &["hunt", "shrink", "replay"]),
    ("Studies", &[STUDY]),
    ("Data", &["corpus", "data", "shard"]),
    ("Set-up", &["engines", "setup"]),
];

/// Command names of version 0.0 and their replacements. They will be removed in version 0.2.
const EARLIER: [(&str, [&str; 2]); 14] = [
    ("completions", ["setup", "completions"]),
    ("diff", ["data", "diff"]),
    ("doctor", ["setup", "doctor"]),
    ("expect", ["corpus", "expect"]),
    ("export", ["data", "export"]),
    ("man", ["setup", "man"]),
    ("map", ["draw", "map"]),
    ("merge", ["shard", "merge"]),
    ("new", ["corpus", "new"]),
    ("plan", ["shard", "plan"]),
    ("resolve", ["corpus", "resolve"]),
    ("schema", ["data", "schema"]),
    ("selftest", ["setup", "selftest"]),
    ("show", ["draw", "scene"]),
];

/// Short names of commands, which stay.
const SHORT: [(&str, [&str; 2]); 1] = [("cite", ["setup", "cite"])];

/// Earlier names of options, by command: `--old`, and the words that replace it.
const OPTIONS: [(&[&str], &str, &[&str]); 8] = [
    (&["report"], "--against", &["--baseline"]),
    (&["draw", "map"], "--suite", &[]),
    (&["setup", "doctor"], "--scene", &["-f"]),
    (&["setup", "doctor"], "--suite", &[]),
    (&["gate"], "--json", &["--format", "json"]),
    (&["data", "diff"], "--json", &["--format", "json"]),
    (&["corpus", "list"], "--json", &["--format", "json"]),
    (&["setup", "selftest"], "--json", &["--format", "json"]),
];

/// The list of commands by group, for the main help page.
pub fn groups(command: &Command) -> String {
    let width = command.get_subcommands().map(|one| one.get_name().len()).max().unwrap_or(0);
    let line = |name: &&str| {
        let about = command.find_subcommand(name).and_then(Command::get_about).map(ToString::to_string);
        format!("  {name:<width$}  {}\n", about.unwrap_or_default())
    };
    let group = |(title, names): &(&str, &[&str])| format!("{title}:\n{}", names.iter().map(line).collect::<String>());
    GROUPS.iter().map(group).collect::<Vec<_>>().join("\n")
}

/// The page `docs/COMMANDS.md`: the help of every command, by group.
pub fn page(command: &Command) -> String {
    let mut page = "<!-- made by `predicament setup man --format md`; a test holds this page to it -->\n# Commands\n\n\
                    The help of every command. `predicament COMMAND --help` prints more about each option.\n"
        .to_owned();
    page += &block(command);
    for (title, names) in GROUPS {
        page += &format!("\n## {title}\n");
        for name in names {
            page += &section(command.find_subcommand(name).expect("every group names commands"), "predicament");
        }
    }
    page
}

/// A command and the commands below it.
fn section(command: &Command, above: &str) -> String {
    let name = format!("{above} {}", command.get_name());
    let below = command.get_subcommands().filter(|one| one.get_name() != "help");
    format!("\n### {name}\n{}", block(command)) + &below.map(|one| section(one, &name)).collect::<String>()
}

/// The short help of a command, as a block of text.
fn block(command: &Command) -> String {
    let help = command.clone().render_help().to_string();
    let lines = help.trim_end().lines().map(|line| format!("{}\n", line.trim_end()));
    format!("\n```text\n{}```\n", lines.collect::<String>())
}

/// Replaces earlier names in a command line by current ones, and returns a note about each change.
pub fn current(mut words: Vec<OsString>, studies: &[Entry]) -> (Vec<OsString>, Vec<String>) {
    let mut notes = Vec::new();
    let is_option = |word: &OsString| word.to_str().is_some_and(|text| text.starts_with('-'));
    let Some(at) = words.iter().skip(1).position(|word| !is_option(word)).map(|at| at + 1) else {
        return (words, notes);
    };
    let name = words[at].to_string_lossy().into_owned();
    if let Some((_, now)) = SHORT.iter().find(|(short, _)| *short == name) {
        words.splice(at..=at, now.map(OsString::from));
    }
    let study = studies.iter().find(|study| study.name == name).map(|study| [STUDY, study.name]);
    if let Some(now) = EARLIER.iter().find(|(old, _)| *old == name).map(|(_, now)| *now).or(study) {
        notes.push(format!("`{name}` is `{}` now", now.join(" ")));
        words.splice(at..=at, now.map(OsString::from));
    }
    for (command, old, now) in OPTIONS {
        let is_of = command.iter().zip(&words[at..]).filter(|(name, word)| *word == *name).count() == command.len();
        if is_of && let Some(place) = words.iter().position(|word| word == old) {
            notes.push(format!("`{old}` is `{}` now", now.join(" ")));
            words.splice(place..=place, now.iter().map(OsString::from));
        }
    }
    (words, notes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(line: &str) -> (String, usize) {
        let words = line.split(' ').map(OsString::from).collect();
        let (words, notes) = current(words, predicament_bundle::STUDIES);
        let words: Vec<String> = words.into_iter().map(|word| word.into_string().expect("text")).collect();
        (words.join(" "), notes.len())
    }

    #[test]
    fn earlier_names_are_today_s_commands() {
        for (old, now, notes) in [
            ("p show tilings", "p draw scene tilings", 1),
            ("p -q compare --out out", "p -q study compare --out out", 1),
            ("p selftest --json", "p setup selftest --format json", 2),
            ("p report a --against b", "p report a --baseline b", 1),
            ("p cite --run a", "p setup cite --run a", 0),
            // A suite may have the name of a command.
            ("p run show", "p run show", 0),
            ("p --help", "p --help", 0),
        ] {
            assert_eq!(of(old), (now.to_owned(), notes));
        }
    }
}
