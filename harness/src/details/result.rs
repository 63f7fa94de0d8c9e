//! Drawings of whole answers: the scene of a finding, with its backend's answer.
//!
//! Wrong signs can make an algorithm loop or crash, so a separate process with a time limit draws the answer.

use std::path::PathBuf;
use std::process::Stdio;
use std::time::Duration;

use predicament_corpus::LoadedScene;
use predicament_predicates::Dimension;
use predicament_records::{FindingRow, RunDir};
use predicament_report::Detail;
use predicament_tasks::Class;

use crate::child::{self, End};
use crate::select::suite_of;

/// The time limit for one answer.
const LIMIT: Duration = Duration::from_secs(2);

/// Adds to `detail` a picture or a view of the scene with the answer of the finding's backend, which is not an engine.
pub fn draw(run: &RunDir, loaded: &LoadedScene, finding: &FindingRow, detail: &mut Detail) -> Option<()> {
    let is_space = loaded.scene.dimension() == Dimension::Three;
    let file = Temporary::new(if is_space { "json" } else { "svg" });
    let mut command = child::command().ok()?;
    let suite = suite_of(&run.path, &run.plan, &finding.suite);
    let filter = format!("^{}$", regex::escape(&format!("{}/{}", finding.suite, finding.scene)));
    command.args(["show", &suite, "-f", &filter, "--level", &run.plan.level.to_string()]);
    // A backend that declines has no answer; the scene alone is drawn.
    let is_declined = finding.class == Class::Declined;
    if !is_declined {
        command.args(["-b", &finding.backend]);
    }
    command.arg("--out").arg(&file.0);
    let mut child = child::start(command, Stdio::null()).ok()?;
    let End::Exit(Some(status)) = child::wait(&mut child, Some(LIMIT)) else { return None };
    let text = status.success().then(|| std::fs::read_to_string(&file.0).ok()).flatten()?;
    let answers = if is_declined { String::new() } else { format!(" as {} answers it", finding.backend) };
    let alt = format!("{}/{}{answers}", finding.suite, finding.scene);
    if is_space {
        detail.views.push((alt, serde_json::from_str(&text).ok()?));
    } else {
        detail.pictures.push((alt, text));
    }
    Some(())
}

/// A file that is removed when this is dropped.
struct Temporary(PathBuf);

impl Temporary {
    fn new(extension: &str) -> Temporary {
        Temporary(std::env::temp_dir().join(format!("predicament-show-{}.{extension}", std::process::id())))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}
