//! `doctor`: what this machine and this build are, and what data are missing.

use std::path::PathBuf;

use predicament_corpus::Library;

use crate::cmd::run::env;
use crate::exit;
use crate::select::Selector;

const EXAMPLES: &str = "\
Examples:
  predicament doctor
  predicament doctor --cache /data/predicament";

/// Tell what this build is, what the machine has, and which data are missing
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Where fetched data lie; $PREDICAMENT_CACHE or the user's cache if left out
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let env = env();
    let line = |key: &str, value: &str| println!("{key:<18} {value}");
    line("predicament", &env.package_version);
    line("compiler", env.rustc.as_deref().unwrap_or("unknown"));
    line("system", &env.os);
    line("processor", env.cpu.as_deref().unwrap_or("unknown"));
    line("cores", &env.cores.map_or_else(|| "unknown".to_owned(), |cores| cores.to_string()));
    line("compiled for", &list(&env.compiled_features));
    line("processor has", &list(&env.detected_features));
    for (peer, version) in &env.peers {
        line(peer, version);
    }
    let sound = arithmetic(&line);
    let library = Library::embedded()?;
    let selector = Selector {
        suites: Vec::new(),
        filter: None,
        level: predicament_corpus::Level::Quick,
        cache: args.cache.clone(),
    };
    let cache = selector.cache()?;
    line("cache", &cache.folder().display().to_string());
    for entry in library.manifest().entries() {
        let state = if cache.has(entry) { "present" } else { "missing; `predicament corpus fetch`" };
        line(&format!("  {}", entry.key), state);
    }
    let scenes: usize = library.suites().iter().map(|suite| suite.scenes.len()).sum();
    line("suites", &format!("{} with {scenes} scenes", library.suites().len()));
    Ok(if sound { exit::OK } else { exit::UNEXPECTED })
}

fn list(features: &[String]) -> String {
    if features.is_empty() { "nothing beyond the baseline".to_owned() } else { features.join(", ") }
}

/// The two things that every proof here stands on, tried at run time: doubles
/// round to nearest, ties to even, and subnormals are kept.
fn arithmetic(line: &impl Fn(&str, &str)) -> bool {
    let black_box = std::hint::black_box::<f64>;
    let u = f64::EPSILON / 2.0;
    let rounds = black_box(1.0) + black_box(u) == 1.0 && black_box(1.0) + black_box(3.0 * u) == 1.0 + 4.0 * u;
    let subnormals = black_box(f64::MIN_POSITIVE) / black_box(2.0) > 0.0;
    // (1 + e)(1 - e) - 1 = -e^2 is lost by two roundings and kept by a fused multiply-add.
    let e = f64::EPSILON;
    let fused = black_box(1.0 + e) * black_box(1.0 - e) + black_box(-1.0) != 0.0;
    line("rounding", if rounds { "to nearest, ties to even" } else { "NOT to nearest: no proof holds here" });
    line("subnormals", if subnormals { "kept" } else { "FLUSHED TO ZERO: no proof holds here" });
    line("a·b + c", if fused { "FUSED: no proof holds here" } else { "rounded twice, as written" });
    rounds && subnormals && !fused
}
