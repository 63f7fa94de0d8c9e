//! `engines new --task`: the source of an engine that answers a whole task. Each task brings its function in each
//! language.

use predicament_formats::use_one_of;

use super::new::Language;
use crate::exit::Failure;
use crate::out::{program, word};
use crate::tool::Tool;

/// The text around a task's function in a language: the language's name in the tasks' examples, head and tail.
const AROUND: [(Language, &str, [&str; 2]); 2] = [
    (
        Language::Python,
        "python",
        [
            include_str!("../../../templates/engine/python/tasks/head.py"),
            include_str!("../../../templates/engine/python/tasks/tail.py"),
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
        return Err(Failure::usage(
            "--task writes engines in Python and in JavaScript (node); docs/ENGINES.md says how the other languages \
             answer tasks",
        ));
    };
    let fill = |text: &str| {
        text.replace("{name}", name).replace("{task}", task).replace("{function}", &task.replace('-', "_"))
    };
    Ok((format!("{}{function}{}", fill(head), fill(tail)), example.suites))
}

/// The two commands to go on with.
pub fn next(engine: &str, suites: &str) -> [String; 2] {
    let backends = word(&format!("engine:{engine},exact"));
    [format!("{} engines check {}", program(), word(engine)), format!("{} run {suites} -b {backends}", program())]
}
