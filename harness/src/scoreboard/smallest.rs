//! The smallest scene behind a cell: written as a suite, drawn, and with the command that shows it.

use std::path::Path;

use predicament_corpus::{Heading, LoadedScene};
use predicament_records::{FindingRow, RunDir, replace};
use predicament_report::drawing::{Look, Window};
use predicament_tasks::output::Canvas;

use super::figures::{Board, Grade};
use crate::exit::Failure;
use crate::found::load;
use crate::out::{program, word};
use crate::tool::Tool;

/// Scenes with more parts are not written out.
const MOST: u64 = 2_000;

/// The smallest scene of a library with a grade.
pub struct Shown {
    /// The library.
    pub library: String,
    /// The grade.
    pub grade: Grade,
    /// The suite and the name of the scene.
    pub scene: String,
    /// The first finding, in words.
    pub got: String,
    /// The path of the suite in the scoreboard's folder.
    pub suite: Option<String>,
    /// The path of the picture there.
    pub picture: Option<String>,
    /// The command that shows the finding.
    pub command: String,
}

/// The smallest scenes of each library on a task, for the grades that are not right; declined scenes are not shown.
pub fn shown(board: &Board, task: &str, runs: &[RunDir], tool: &Tool, out: &Path) -> Result<Vec<Shown>, Failure> {
    let mut all = Vec::new();
    for (library, row) in board.tasks.get(task).into_iter().flatten() {
        for (grade, (run, scene, size)) in row.all().smallest {
            if matches!(grade, Grade::Right | Grade::Declined) {
                continue;
            }
            let run = &runs[run];
            let of_scene = |row: &&FindingRow| row.scene == scene && row.backend == *library && row.task == task;
            let Some(finding) = run.findings.iter().find(of_scene) else { continue };
            let loaded = if size <= MOST { load(run, finding, None, tool).ok() } else { None };
            let loaded = loaded.filter(|loaded| is_small(loaded, tool));
            let name = format!("{task}-{}-{}", file_name(library), grade.name());
            let [mut suite, mut picture] = [None, None];
            if let Some(loaded) = &loaded {
                suite = written(loaded, &name, out)?;
                picture = drawn(loaded, &name, tool, out)?;
            }
            let command = match &suite {
                Some(suite) => format!("{} run {suite} -b {}", program(), word(library)),
                None => format!("{} run {} -f {} -b {}", program(), finding.suite, word(&scene), word(library)),
            };
            let scene = format!("{}/{scene}", finding.suite);
            let got = format!("{} ({}): {}", finding.check, finding.class, finding.got.replace('\n', " "));
            all.push(Shown { library: library.clone(), grade, scene, got, suite, picture, command });
        }
    }
    Ok(all)
}

/// True for a scene that people can look at: few questions can be asked about a large mesh.
fn is_small(loaded: &LoadedScene, tool: &Tool) -> bool {
    let parts = tool.task(loaded.task).size_of(loaded).max(loaded.scene.vertices().count());
    u64::try_from(parts).is_ok_and(|parts| parts <= MOST)
}

/// A name that is a file's name on every system.
fn file_name(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect()
}

fn written(loaded: &LoadedScene, name: &str, out: &Path) -> Result<Option<String>, Failure> {
    let Some(spelled) = loaded.spelled() else { return Ok(None) };
    let source = format!("{}/{} ({})", loaded.suite, loaded.name, loaded.id);
    let text = spelled.suite("The smallest scene", Heading { name, source: &source, ..Heading::default() });
    let path = format!("scenes/{name}.toml");
    replace(&out.join(&path), text.as_bytes()).map_err(Failure::usage)?;
    Ok(Some(path))
}

fn drawn(loaded: &LoadedScene, name: &str, tool: &Tool, out: &Path) -> Result<Option<String>, Failure> {
    let draw = || -> std::io::Result<String> {
        let mut canvas = Canvas::new(&loaded.scene, None)?;
        tool.task(loaded.task).draw_scene(loaded, None, &mut canvas)?;
        Ok(canvas.finish().svg(Look::default(), Window::Whole))
    };
    let Ok(picture) = draw() else { return Ok(None) };
    let path = format!("scenes/{name}.svg");
    replace(&out.join(&path), picture.as_bytes()).map_err(Failure::usage)?;
    Ok(Some(path))
}
