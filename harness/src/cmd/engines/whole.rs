//! `engines new --task`: the source of an engine that answers a whole task, in Python.

use predicament_formats::use_one_of;

use crate::exit::Failure;
use crate::out::{program, word};

use super::new::Language;

/// A task, the suites with its scenes, and a function that answers it in plain doubles.
type Example = (&'static str, &'static str, &'static str);

macro_rules! example {
    ($task:literal, $suites:literal, $file:literal) => {
        ($task, $suites, include_str!(concat!("../../../templates/engine/python/tasks/", $file, ".py")))
    };
}

const EXAMPLES: [Example; 8] = [
    example!("delaunay2d", "delaunay", "delaunay2d"),
    example!("hull2d", "hulls -f hull2d", "hull2d"),
    example!("hull3d", "hulls -f hull3d", "hull3d"),
    example!("triangulate", "polygons", "triangulate"),
    example!("overlay2d", "overlays", "overlay2d"),
    example!("polygon-locate", "tilings", "polygon_locate"),
    example!("mesh-locate", "mesh-points", "mesh_locate"),
    example!("mesh-intersect", "intersections", "mesh_intersect"),
];

const HEAD: &str = include_str!("../../../templates/engine/python/tasks/head.py");
const TAIL: &str = include_str!("../../../templates/engine/python/tasks/tail.py");

/// The source of an engine for a task, and the suites with scenes of the task.
pub fn source(name: &str, task: &str, language: Language) -> Result<(String, &'static str), Failure> {
    let known = EXAMPLES.map(|(task, ..)| task);
    let Some((task, suites, body)) = EXAMPLES.into_iter().find(|(of, ..)| *of == task) else {
        return Err(Failure::usage(format!("no task `{task}` is open to engines; {}", use_one_of(task, &known))));
    };
    if language != Language::Python {
        return Err(Failure::usage(
            "--task writes engines in Python; docs/ENGINES.md says how the other languages answer tasks",
        ));
    }
    let fill = |text: &str| {
        text.replace("{name}", name).replace("{task}", task).replace("{function}", &task.replace('-', "_"))
    };
    Ok((format!("{}{body}{}", fill(HEAD), fill(TAIL)), suites))
}

/// The two commands to go on with.
pub fn next(engine: &str, suites: &str) -> [String; 2] {
    let backends = word(&format!("engine:{engine},exact"));
    [format!("{} engines check {}", program(), word(engine)), format!("{} run {suites} -b {backends}", program())]
}
