//! `doctor`: this machine, this build, missing data, and the precision plan of a scene.

use predicament_exact::Precision;

use crate::exit;
use crate::out::program;
use crate::planning::env;
use crate::precision;
use crate::select::Selector;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament setup doctor
  predicament setup doctor --cache /data/predicament
  predicament setup doctor -f 'near-.*orient3d'      which arithmetic the exact backend chose, and why";

/// Tell what this build is, what the machine has, and which data are missing
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    if args.selector.filter.is_some() || !args.selector.suites.is_empty() {
        return scenes(args, tool);
    }
    let env = env();
    let line = |key: &str, value: &str| say!("{key:<20} {value}");
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
    let library = tool.library()?;
    let cache = args.selector.cache()?;
    line("cache", &cache.folder().display().to_string());
    for entry in library.manifest().entries() {
        let missing = || format!("missing; `{} corpus fetch`", program());
        let state = if cache.has(entry) { "present".to_owned() } else { missing() };
        line(&format!("  {}", entry.key), &state);
    }
    let suites = library.suites()?;
    let scenes: usize = suites.iter().map(|suite| suite.scenes.len()).sum();
    line("suites", &format!("{} with {scenes} scenes", suites.len()));
    Ok(if sound { exit::OK } else { exit::UNEXPECTED })
}

/// The precision plans of all scenes that match.
fn scenes(args: &Args, tool: &Tool) -> exit::Outcome {
    let selection = args.selector.select(tool)?;
    let defs = selection.defs();
    if defs.is_empty() {
        return Err(selection.nothing());
    }
    for def in defs {
        let loaded = selection.load(def)?;
        let constructed = loaded.scene.constructions().len();
        let and = if constructed > 0 { format!(", {constructed} constructed vertices") } else { String::new() };
        say!("{}/{}: {} points{and}", def.suite, def.name, loaded.scene.len());
        for line in precision::lines(&Precision::of(&loaded.scene)) {
            say!("  {line}");
        }
    }
    Ok(exit::OK)
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
