//! `engines new --task`: the source of an engine that answers a whole task. Each task brings its function.

use predicament_formats::use_one_of;

use super::new::Language;
use crate::exit::Failure;
use crate::out::{program, word};
use crate::tool::Tool;

const HEAD: &str = include_str!("../../../templates/engine/python/tasks/head.py");
const TAIL: &str = include_str!("../../../templates/engine/python/tasks/tail.py");

/// The source of an engine for a task, and the suites with scenes of the task.
pub fn source(tool: &Tool, name: &str, task: &str, language: Language) -> Result<(String, &'static str), Failure> {
    let tasks = tool.tasks();
    let open = || tasks.iter().filter_map(|task| Some((task.name(), task.example_engine()?)));
    let Some((task, example)) = open().find(|(of, _)| *of == task) else {
        let known: Vec<&str> = open().map(|(of, _)| of).collect();
        return Err(Failure::usage(format!("no task `{task}` is open to engines; {}", use_one_of(task, &known))));
    };
    if language != Language::Python {
        return Err(Failure::usage(
            "--task writes engines in Python; docs/ENGINES.md says how the other languages answer tasks",
        ));
    }
    let function = example.functions.iter().find(|(of, _)| *of == "python").map_or("", |(_, function)| function);
    let fill = |text: &str| {
        text.replace("{name}", name).replace("{task}", task).replace("{function}", &task.replace('-', "_"))
    };
    Ok((format!("{}{function}{}", fill(HEAD), fill(TAIL)), example.suites))
}

/// The two commands to go on with.
pub fn next(engine: &str, suites: &str) -> [String; 2] {
    let backends = word(&format!("engine:{engine},exact"));
    [format!("{} engines check {}", program(), word(engine)), format!("{} run {suites} -b {backends}", program())]
}
