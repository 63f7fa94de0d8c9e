//! `engines new --task`: the source of an engine that answers a whole task. Each task brings its function in each
//! language.

use predicament_formats::use_one_of;

use super::new::Language;
use crate::exit::Failure;
use crate::out::{program, word};
use crate::tool::Tool;

/// The text around a task's function in a language: the language's name in the tasks' examples, head and tail.
const AROUND: [(Language, &str, [&str; 2]); 4] = [
    (
        Language::Python,
        "python",
        [
            include_str!("../../../templates/engine/python/tasks/head.py"),
            include_str!("../../../templates/engine/python/tasks/tail.py"),
        ],
    ),
    (
        Language::Cpp,
        "cpp",
        [
            include_str!("../../../templates/engine/cpp/tasks/head.cpp"),
            include_str!("../../../templates/engine/cpp/tasks/tail.cpp"),
        ],
    ),
    (
        Language::Rust,
        "rust",
        [
            include_str!("../../../templates/engine/rust/tasks/head.rs"),
            include_str!("../../../templates/engine/rust/tasks/tail.rs"),
        ],
    ),
    (
        Language::Node,
        "node",
        [
            include_str!("../../../templates/engine/node/tasks/head.mjs"),
            include_str!("../../../templates/engine/node/tasks/tail.mjs"),
        ],
    ),
];

/// The source of an engine for a task, and the suites with scenes of the task.
pub fn source(tool: &Tool, name: &str, task: &str, language: Language) -> Result<(String, &'static str), Failure> {
    let tasks = tool.tasks();
    let open = || tasks.iter().filter_map(|task| Some((task.name(), task.example_engine()?)));
    let Some((task, example)) = open().find(|(of, _)| *of == task) else {
        let known: Vec<&str> = open().map(|(of, _)| of).collect();
        return Err(Failure::usage(format!("no task `{task}` is open to engines; {}", use_one_of(task, &known))));
    };
    let around = AROUND.iter().find(|(of, ..)| *of == language);
    let function = around.and_then(|(_, word, _)| example.functions.iter().find(|(of, _)| of == word));
    let (Some((.., [head, tail])), Some((_, function))) = (around, function) else {
        return Err(Failure::usage(format!(
            "{task} has no example in this language; docs/ENGINES.md has the protocol"
        )));
    };
    let fill = |text: &str| {
        text.replace("{name}", name)
            .replace("{task}", task)
            .replace("{function}", &task.replace('-', "_"))
            .replace("{variant}", &variant(task))
    };
    Ok((format!("{}{function}{}", fill(head), fill(tail)), example.suites))
}

/// The name of a task's variant in the helper for Rust: `CubeUnion` for `cube-union`.
fn variant(task: &str) -> String {
    let capital = |part: &str| {
        let mut letters = part.chars();
        letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect::<String>()
    };
    task.split('-').map(capital).collect()
}

/// The two commands to go on with; `first` is the part of `engines` to call before the engine runs.
pub fn next(engine: &str, first: &str, suites: &str) -> [String; 2] {
    let backends = word(&format!("engine:{engine},exact"));
    [format!("{} engines {first} {}", program(), word(engine)), format!("{} run {suites} -b {backends}", program())]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each task that is open to engines has a function in each language, and its name is in the source.
    #[test]
    fn each_task_has_an_example_in_each_language() {
        let tool = Tool::new((), &predicament_bundle::Systems, crate::tool::Guests::default());
        let mut count = 0;
        for task in tool.tasks().iter().filter(|task| task.example_engine().is_some()).map(|task| task.name()) {
            for (language, word, _) in AROUND {
                let Ok((source, suites)) = source(&tool, "mine", task, language) else {
                    panic!("{task} has no example in {word}")
                };
                let named = source.matches(&format!(" {}(", task.replace('-', "_"))).count();
                assert!(named > 0 && source.contains("mine") && !suites.is_empty(), "{word}: {source}");
                let marks = ["{name}", "{task}", "{function}", "{variant}"];
                assert!(!marks.iter().any(|mark| source.contains(mark)), "{word}: {source}");
                count += 1;
            }
        }
        assert_eq!(count, 17 * AROUND.len());
    }
}
