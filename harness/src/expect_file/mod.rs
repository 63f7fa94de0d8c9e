//! A file of expectations, edited as text: lines that are not edited keep their text, comments and order.

mod array;
mod edits;
mod prune;
mod table;
mod update;

use std::collections::BTreeMap;

use predicament_oracle::pattern;
use predicament_records::{RunDir, Status, SummaryRow};
use predicament_tasks::Class;

pub use edits::Edits;
pub use prune::{Told, prune};
use table::tables;
pub use update::update;

/// An `[[expect]]` entry: backends, classes and scenes. Scene names are written as globs that match only themselves.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Entry {
    pub backends: Vec<String>,
    pub classes: Vec<String>,
    pub scenes: Vec<String>,
}

impl Entry {
    /// The entry as a TOML table; without a reason, with an empty one for a person to fill in.
    pub fn text(&self, level: &str, reason: Option<&str>) -> String {
        let reason = reason.map_or_else(|| "\"\" # say why".to_owned(), quoted);
        self.written(Some(&quoted(level)), &reason)
    }

    /// The entry as a TOML table, with a level and a reason in TOML syntax.
    pub fn written(&self, level: Option<&str>, reason: &str) -> String {
        let one_or_list = |items: &[String]| match items {
            [one] => quoted(one),
            more => format!("[{}]", more.iter().map(|item| quoted(item)).collect::<Vec<_>>().join(", ")),
        };
        let classes: Vec<String> = self.classes.iter().map(|class| quoted(class)).collect();
        let scenes: String = self.scenes.iter().map(|scene| format!("    {},\n", quoted(scene))).collect();
        let level = level.map_or_else(String::new, |level| format!("level = {level}\n"));
        format!(
            "[[expect]]\nbackend = {}\nclass = [{}]\nscene = [\n{scenes}]\n{level}reason = {reason}\n",
            one_or_list(&self.backends),
            classes.join(", ")
        )
    }
}

/// A TOML string.
pub fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

/// The unexpected rows of a run as entries. Rows of a backend with the same classes share an entry.
pub fn grouped(run: &RunDir, classes: impl Fn(&SummaryRow) -> Vec<Class>) -> Vec<Entry> {
    let mut alike: BTreeMap<(&str, Vec<&str>), Vec<String>> = BTreeMap::new();
    for row in run.summary.iter().filter(|row| row.status == Status::Unexpected) {
        let classes = classes(row).into_iter().map(Class::name).collect();
        let scene = pattern::escape(&format!("{}/{}", row.suite, row.scene));
        alike.entry((&row.backend, classes)).or_default().push(scene);
    }
    let strings = |names: Vec<&str>| names.into_iter().map(str::to_owned).collect();
    let entry =
        |((backend, classes), scenes)| Entry { backends: strings(vec![backend]), classes: strings(classes), scenes };
    alike.into_iter().map(entry).collect()
}
