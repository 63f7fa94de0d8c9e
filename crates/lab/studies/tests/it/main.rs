//! The studies, each with the results that it must find, and their common structure.

mod ablation;
mod audit;
mod border;
mod cascades;
mod cascades_counts;
mod cascades_pages;
mod compare;
mod cut;
mod decimals;
mod laws;
mod mesh_cascades;
mod parity;
mod parity_space;
mod repeat;
mod scale;
mod shape;
mod standing;
mod stress;
mod touching;
mod which;
mod worst;

use predicament_studies::{Error, Quiet};
use predicament_tasks::Contestant;

/// A host without a watch, with all tasks and backends.
fn quiet() -> Quiet {
    Quiet::on(predicament_bundle::tasks(), |name| predicament_bundle::backend(name).map_err(Error::unfit))
}

/// The backend with this name.
fn backend(name: &str) -> Box<dyn Contestant> {
    predicament_bundle::backend(name).unwrap_or_else(|why| panic!("{why}"))
}
