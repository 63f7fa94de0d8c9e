//! A row that is measured in this process.

use std::time::Instant;

use predicament_corpus::LoadedScene;
use predicament_records::approximately;
use predicament_tasks::{Contestant, Purpose, caught};

use super::{Row, Scale};
use crate::Error;
use crate::compare::{Input, peak};

/// The size of the scene that is answered before: it loads code and starts threads, which the row does not count.
const FIRST: usize = 100;

/// The row of a backend on a scene.
pub(super) fn row(study: &Scale, input: &Input, backend: &dyn Contestant) -> Result<Row, Error> {
    let task = input.task;
    let loaded = input.scene(study.common.seed)?;
    let known = |bytes: Option<u64>| bytes.map_or(f64::NAN, approximately);
    let stated = task.memory_of(&loaded);
    let row = Row { size: task.size_of(&loaded), stated: known(stated), ..Row::unanswered(input, backend) };
    if let Some(stated) = stated.filter(|stated| stated >> 30 >= u64::from(study.memory)) {
        let needed = stated.div_ceil(1 << 30);
        return Ok(row.ended("refused", format!("needs {needed} GiB by its task; --memory allows {}", study.memory)));
    }
    let answer = |loaded: &LoadedScene| {
        let (scene, content) = (&loaded.scene, loaded.content.as_ref());
        caught(|| backend.answer_any(task.name(), scene, content, Purpose::Use, &mut |_| {}))
    };
    // A backend that fails here fails below.
    let _ = answer(&input.sized(input.of.n.min(FIRST)).scene(study.common.seed)?);
    let (mut answered, mut seconds) = (None, f64::NAN);
    let most = peak(|| {
        let start = Instant::now();
        answered = Some(answer(&loaded));
        seconds = start.elapsed().as_secs_f64();
    });
    Ok(match answered {
        Some(Ok(Ok(()))) => Row { seconds, bytes: known(most), ..row.ended("answered", String::new()) },
        Some(Err(broken)) => row.ended(broken.class.name(), broken.message),
        _ => row.ended("declined", String::new()),
    })
}
