//! The arguments that studies have in common.

use std::path::PathBuf;

/// Seed, threads and folder of a study.
#[derive(Clone, PartialEq, Eq, Debug, clap::Args)]
pub struct Common {
    /// The seed of all random choices
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// Threads; all cores if left out
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

impl Default for Common {
    /// The default arguments, as if none was given.
    fn default() -> Common {
        Common { seed: 1, threads: None, out: None }
    }
}
