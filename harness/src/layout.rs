//! The width of help texts. Help texts are written without line breaks inside paragraphs and wrapped at the terminal's
//! width.

use clap::Command;

/// The maximum width of help; clap uses the same if the terminal is wider or is not a terminal.
const WIDEST: usize = 100;

/// The width of help, in columns.
fn width() -> usize {
    let columns = || std::env::var("COLUMNS").ok()?.parse().ok();
    let terminal = terminal_size::terminal_size().map(|(terminal_size::Width(width), _)| usize::from(width));
    terminal.or_else(columns).map_or(WIDEST, |width: usize| width.clamp(40, WIDEST))
}

/// The command with all help texts wrapped at the terminal's width.
pub fn laid_out(command: Command) -> Command {
    fit(command, width())
}

/// The command with all help texts wrapped at the maximum width, for pages.
pub fn of_pages(command: Command) -> Command {
    fit(command, WIDEST)
}

fn fit(command: Command, width: usize) -> Command {
    let after = command.get_after_help().map(|text| broken(&text.to_string(), width));
    let command = match after {
        Some(text) => command.after_help(text),
        None => command,
    };
    command.term_width(width).mut_subcommands(|one| fit(one, width))
}

/// A text wrapped at this width. Text after two spaces is a second column: it keeps its indentation, or goes to a line
/// of its own if the first column takes most of the width.
pub fn broken(text: &str, width: usize) -> String {
    let mut lines = Vec::new();
    for line in text.lines() {
        let indent = line.len() - line.trim_start().len();
        let columns = line.trim_start().split_once("  ").map(|(first, second)| (first, second.trim_start()));
        match columns.filter(|_| line.chars().count() > width) {
            Some((first, second)) if !second.is_empty() => {
                let place = line.len() - second.len();
                if place <= width / 2 {
                    let filled = format!("{:indent$}{first:<rest$}", "", rest = place - indent);
                    lines.extend(wrapped(second, &filled, &" ".repeat(place), width));
                } else {
                    lines.extend(wrapped(first, &" ".repeat(indent), &" ".repeat(indent + 4), width));
                    let behind = " ".repeat(indent + 6);
                    lines.extend(wrapped(second, &behind, &behind, width));
                }
            }
            _ => {
                let start = " ".repeat(indent);
                let hang = " ".repeat(if indent == 0 { 0 } else { indent + 4 });
                lines.extend(wrapped(line.trim_start(), &start, &hang, width));
            }
        }
    }
    lines.join("\n")
}

/// The words of a text in lines; the first line begins with `first` and the others with `other`.
fn wrapped(text: &str, first: &str, other: &str, width: usize) -> Vec<String> {
    if first.chars().count() + text.chars().count() <= width {
        return vec![format!("{first}{text}").trim_end().to_owned()];
    }
    let (mut lines, mut line) = (Vec::new(), first.to_owned());
    let mut is_empty = true;
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        if !is_empty && line.chars().count() + 1 + word.chars().count() > width {
            lines.push(std::mem::replace(&mut line, other.to_owned()));
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        line.push_str(word);
        is_empty = false;
    }
    lines.push(line);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_at_the_width() {
        let text = "A paragraph of some words.\n\nExamples:\n  tool run --out out    what it does, said in words\n  \
                    tool run --with-a-very-long-option    what it does";
        let expected = "A paragraph of some\nwords.\n\nExamples:\n  tool run --out out\n        what it does,\n        said \
                        in words\n  tool run\n      --with-a-very-long-option\n        what it does";
        assert_eq!(broken(text, 21), expected);
        let rows = "exact    the sign of the real determinant\nb        short";
        assert_eq!(broken(rows, 24), "exact    the sign of the\n         real\n         determinant\nb        short");
        assert_eq!(broken(text, 100), text);
    }
}
