//! A reader of faults from `tests/faults.toml` of the crates.
//!
//! It supports the part of TOML that these files need: tables in arrays, and values that are strings on one line,
//! literal strings on several, or lists.

use std::path::{Path, PathBuf};

use super::{Change, Planted, Seen};

/// The file of a crate that holds its faults.
const FILE: &str = "tests/faults.toml";

/// The faults of all crates of a tree, by crate and in the order of their files.
///
/// # Errors
/// If a file is wrong, with its line.
pub(super) fn all(tree: &Path) -> Result<Vec<Planted>, String> {
    let crates = tree.join("crates");
    let groups = folders(&crates)?;
    let mut own: Vec<PathBuf> = groups.clone();
    for group in &groups {
        own.extend(folders(group)?);
    }
    own.retain(|folder| folder.join(FILE).is_file());
    own.sort();
    let mut all = Vec::new();
    for folder in own {
        let path = folder.join(FILE);
        let text = std::fs::read_to_string(&path).map_err(|why| format!("{}: {why}", path.display()))?;
        let folder = folder.strip_prefix(tree).expect("a folder of the tree");
        all.extend(faults(&text, folder).map_err(|why| format!("{}: {why}", path.display()))?);
    }
    Ok(all)
}

fn folders(of: &Path) -> Result<Vec<PathBuf>, String> {
    let entries = std::fs::read_dir(of).map_err(|why| format!("{}: {why}", of.display()))?;
    Ok(entries.filter_map(|entry| entry.ok().map(|entry| entry.path())).filter(|path| path.is_dir()).collect())
}

/// The faults of one file, whose changes are to files in a folder.
///
/// # Errors
/// The error, with its line.
pub(super) fn faults(text: &str, folder: &Path) -> Result<Vec<Planted>, String> {
    let mut faults: Vec<Planted> = Vec::new();
    for Table { line, name, mut entries } in tables(text)? {
        let wrong = |what: &str| format!("line {line}: {what}");
        let mut take = |key: &str| {
            let at = entries.iter().position(|(name, _)| name == key)?;
            Some(entries.remove(at).1)
        };
        let told = |value: Option<Value>, key: &str| match value {
            Some(Value::Text(text)) => Ok(text),
            _ => Err(wrong(&format!("`{key}` is not a string"))),
        };
        match name.as_str() {
            "fault" => {
                let [name, what] = ["name", "what"].map(|key| told(take(key), key));
                let seen = match (take("test"), take("run"), take("finds")) {
                    (Some(test), None, None) => {
                        let [package, name] = test.pair().ok_or_else(|| wrong("`test` is [PACKAGE, NAME]"))?;
                        Seen::Test { package, name }
                    }
                    (None, Some(run), Some(Value::List(finds))) => {
                        let [suite, backend] = run.pair().ok_or_else(|| wrong("`run` is [SUITE, BACKEND]"))?;
                        let finds: Option<Vec<[String; 2]>> = finds.into_iter().map(Value::pair).collect();
                        let finds = finds.filter(|finds| !finds.is_empty());
                        Seen::Run { suite, backend, finds: finds.ok_or_else(|| wrong("`finds` is [[CLASS, CHECK]]"))? }
                    }
                    _ => return Err(wrong("a fault has `test`, or `run` and `finds`")),
                };
                faults.push(Planted { name: name?, what: what?, changes: Vec::new(), seen });
            }
            "fault.change" => {
                let [file, is, becomes] = ["file", "is", "becomes"].map(|key| told(take(key), key));
                let change = Change { file: folder.join(file?), is: is?, becomes: becomes? };
                faults.last_mut().ok_or_else(|| wrong("a change before any fault"))?.changes.push(change);
            }
            other => return Err(wrong(&format!("there is no table `{other}`"))),
        }
        if let Some((key, _)) = entries.first() {
            return Err(wrong(&format!("there is no key `{key}`, or it comes twice")));
        }
    }
    Ok(faults)
}

/// A table of an array, the line of its name, and its entries in order.
struct Table {
    line: usize,
    name: String,
    entries: Vec<(String, Value)>,
}

enum Value {
    Text(String),
    List(Vec<Value>),
}

impl Value {
    /// The strings of a list of two.
    fn pair(self) -> Option<[String; 2]> {
        match self {
            Value::List(list) => match <[Value; 2]>::try_from(list).ok()? {
                [Value::Text(first), Value::Text(second)] => Some([first, second]),
                _ => None,
            },
            Value::Text(_) => None,
        }
    }
}

fn tables(text: &str) -> Result<Vec<Table>, String> {
    let mut tables: Vec<Table> = Vec::new();
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let line = text[..text.len() - rest.len()].lines().count() + 1;
        let wrong = |what: &str| format!("line {line}: {what}");
        let (first, next) = rest.split_once('\n').unwrap_or((rest, ""));
        if first.starts_with('#') {
            rest = next.trim_start();
        } else if let Some(name) = first.strip_prefix("[[") {
            let name = name.trim_end().strip_suffix("]]").ok_or_else(|| wrong("`]]` is missing"))?;
            tables.push(Table { line, name: name.to_owned(), entries: Vec::new() });
            rest = next.trim_start();
        } else {
            let (key, of_key) = rest.split_once('=').ok_or_else(|| wrong("neither a table nor a key"))?;
            let (value, left) = value(of_key.trim_start()).ok_or_else(|| wrong("not a value that is read here"))?;
            let table = tables.last_mut().ok_or_else(|| wrong("a key before any table"))?;
            table.entries.push((key.trim().to_owned(), value));
            rest = left.trim_start();
        }
    }
    Ok(tables)
}

/// A value, and the rest of the text.
fn value(text: &str) -> Option<(Value, &str)> {
    let until = |text: &'_ str, end: &str| text.split_once(end).map(|(value, left)| (value.to_owned(), left.len()));
    if let Some(literal) = text.strip_prefix("'''") {
        // A line's end right after the quotes is not part of the string.
        let (value, left) = until(literal.strip_prefix('\n').unwrap_or(literal), "'''")?;
        return Some((Value::Text(value), &text[text.len() - left..]));
    }
    for quote in ["'", "\""] {
        if let Some(string) = text.strip_prefix(quote) {
            let (value, left) = until(string, quote)?;
            return (!value.contains(['\n', '\\']) || quote == "'" && !value.contains('\n'))
                .then_some((Value::Text(value), &text[text.len() - left..]));
        }
    }
    let mut rest = text.strip_prefix('[')?.trim_start();
    let mut list = Vec::new();
    loop {
        if let Some(left) = rest.strip_prefix(']') {
            return Some((Value::List(list), left));
        }
        let (item, left) = value(rest)?;
        list.push(item);
        rest = left.trim_start();
        rest = rest.strip_prefix(',').map_or(rest, str::trim_start);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO: &str = "# Faults.\n[[fault]]\nname = \"a\"\nwhat = \"an 'a'\"\ntest = [\"judge\", \"of_a\"]\n\n[[fault.change]]\n\
                       file = \"src/a.rs\"\nis = ' \\n\"x\"'\nbecomes = '''\n  y\n  '''\n\n[[fault]]\nname = \"b\"\nwhat = \"b\"\n\
                       run = [\"hulls\", \"sos\"]\nfinds = [\n  [\"topology\", \"gap, wide\"],\n  [\"nan\", \"z\"],\n]\n";

    #[test]
    fn a_file_of_faults_is_read() {
        let faults = faults(TWO, Path::new("crates/c")).expect("two faults");
        let [a, b] = &faults[..] else { panic!("two") };
        assert_eq!((a.name.as_str(), a.what.as_str()), ("a", "an 'a'"));
        assert_eq!(a.seen, Seen::Test { package: "judge".to_owned(), name: "of_a".to_owned() });
        let [change] = &a.changes[..] else { panic!("one") };
        assert_eq!(change.file, Path::new("crates/c/src/a.rs"));
        assert_eq!((change.is.as_str(), change.becomes.as_str()), (" \\n\"x\"", "  y\n  "));
        let finds = vec![["topology", "gap, wide"], ["nan", "z"]];
        let finds = finds.into_iter().map(|pair| pair.map(str::to_owned)).collect();
        assert_eq!(b.seen, Seen::Run { suite: "hulls".to_owned(), backend: "sos".to_owned(), finds });
        assert!(b.changes.is_empty());
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (is, becomes, why) in [
            ("\"of_a\"]", "\"of_a\", \"c\"]", "line 2: `test` is [PACKAGE, NAME]"),
            ("what = \"an 'a'\"", "whit = \"a\"", "line 2: `what` is not a string"),
            ("test = [", "size = \"1\"\ntest = [", "line 2: there is no key `size`, or it comes twice"),
            ("[[fault.change]]", "[[change]]", "line 7: there is no table `change`"),
            ("becomes = '''\n  y\n  '''", "becomes = 1", "line 10: not a value that is read here"),
            ("[[fault]]\nname = \"a\"", "name = \"a\"", "line 2: a key before any table"),
            ("finds = [\n", "found = [\n", "line 14: a fault has `test`, or `run` and `finds`"),
        ] {
            assert_eq!(TWO.matches(is).count(), 1, "{is}");
            let found = faults(&TWO.replace(is, becomes), Path::new("c")).map(|faults| faults.len());
            assert_eq!(found, Err(why.to_owned()));
        }
    }
}
