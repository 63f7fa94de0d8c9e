//! Backends from the command line.

use predicament_oracle::{Contestant, roster};

use crate::exit::Failure;

/// The backends named by `-b`, or all that run by default; each once.
pub fn pick(names: &[String]) -> Result<Vec<Box<dyn Contestant>>, Failure> {
    let names: Vec<&str> = if names.is_empty() {
        roster::DEFAULT.to_vec()
    } else {
        names.iter().flat_map(|names| names.split(',')).filter(|name| !name.is_empty()).collect()
    };
    let mut picked: Vec<Box<dyn Contestant>> = Vec::new();
    for name in names {
        let backend = roster::backend(name).map_err(Failure::usage)?;
        if picked.iter().all(|other| other.name() != backend.name()) {
            picked.push(backend);
        }
    }
    if picked.is_empty() {
        return Err(Failure::nothing("no backend is left; name one with -b"));
    }
    Ok(picked)
}
