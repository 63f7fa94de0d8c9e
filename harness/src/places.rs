//! Places where output is refused: an input, another output, or the files of a run.

use std::path::{Path, PathBuf};

use crate::exit::Failure;

/// Refuses output that would replace a file that the command reads or writes, or that would look like a file of a run.
///
/// `outputs` are the options with their files or folders, `inputs` are files that are read, and `runs` are folders of
/// runs.
///
/// # Errors
/// The first such option, with the reason.
pub fn apart(outputs: &[(&str, &Path)], inputs: &[&Path], runs: &[&Path]) -> Result<(), Failure> {
    let inputs: Vec<PathBuf> = inputs.iter().map(|path| resolved(path)).collect();
    let runs: Vec<PathBuf> = runs.iter().map(|path| resolved(path)).collect();
    for (at, (option, path)) in outputs.iter().enumerate() {
        let place = resolved(path);
        let other = outputs[..at].iter().find(|(_, other)| resolved(other) == place);
        let why = if let Some((other, _)) = other {
            format!("{other} writes it, too")
        } else if inputs.contains(&place) {
            "the command reads it".to_owned()
        } else if let Some(run) = runs.iter().find(|run| is_of_run(run, &place)) {
            format!("it would change the run {}, which must stay as it was written", run.display())
        } else {
            continue;
        };
        return Err(Failure::usage(format!("{}: {why}; name another place for {option}", path.display())));
    }
    Ok(())
}

/// True if a place is the folder of a run, or is in it and has a name like the run's own files.
fn is_of_run(run: &Path, place: &Path) -> bool {
    place.strip_prefix(run).is_ok_and(|file| {
        let ending = file.extension().and_then(|ending| ending.to_str());
        file.as_os_str().is_empty()
            || file.starts_with("maps")
            || matches!(ending, Some("csv" | "json" | "lock" | "png"))
    })
}

/// The absolute name of a file or folder that may not exist yet, with links resolved.
fn resolved(path: &Path) -> PathBuf {
    if let Ok(whole) = path.canonicalize() {
        return whole;
    }
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    match (path.parent(), path.file_name()) {
        (Some(parent), Some(name)) => resolved(parent).join(name),
        _ => path,
    }
}
