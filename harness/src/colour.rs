//! Colours of results on a terminal: green for right, red for wrong, grey for what was not done.

use std::io::IsTerminal;
use std::sync::OnceLock;

/// A colour by its meaning.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Paint {
    /// Right, or as expected.
    Good,
    /// Wrong, or unexpected.
    Bad,
    /// Not done, or not selected.
    Faint,
    /// Without a colour.
    Plain,
}

impl Paint {
    /// The colour for a result with this exit code.
    pub fn of(code: u8) -> Paint {
        if code == crate::exit::OK { Paint::Good } else { Paint::Bad }
    }
}

/// True if stdout is a terminal that shows colours. The variable `NO_COLOR`, with any value, turns colours off. Texts
/// for a program that calls the tool have none.
fn is_on() -> bool {
    static ON: OnceLock<bool> = OnceLock::new();
    if crate::host::is_called() {
        return false;
    }
    *ON.get_or_init(|| {
        let has = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
        let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
        std::io::stdout().is_terminal() && !has("NO_COLOR") && !is_dumb
    })
}

/// The colours: marks that never occur in texts, and the escape sequences that replace them. A terminal never gets the
/// escape sequences of the texts themselves.
const MARKS: [(char, &str); 4] =
    [('\u{fdd0}', "\x1b[0m"), ('\u{fdd1}', "\x1b[32m"), ('\u{fdd2}', "\x1b[31m"), ('\u{fdd3}', "\x1b[90m")];

/// A text in a colour, for stdout.
pub fn paint(paint: Paint, text: &str) -> String {
    let [end, good, bad, faint] = MARKS.map(|(mark, _)| mark);
    let begin = match paint {
        _ if !is_on() => return text.to_owned(),
        Paint::Good => good,
        Paint::Bad => bad,
        Paint::Faint => faint,
        Paint::Plain => return text.to_owned(),
    };
    format!("{begin}{text}{end}")
}

/// A text for a terminal, with escape sequences in place of the marks.
pub fn obeyed(text: String) -> String {
    if !is_on() {
        return text;
    }
    MARKS.into_iter().fold(text, |text, (mark, code)| text.replace(mark, code))
}
