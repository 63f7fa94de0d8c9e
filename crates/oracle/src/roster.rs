//! All backends by name. The only place that knows every one of them.

use predicament_controls::{Epsilon, Naive, Pivot, Shewchuk};
use predicament_exact::Exact;
use predicament_sos::{PerMesh, Scheme, Sos, infinitesimal};
use predicament_tolerance::Tolerance;

use crate::{Contestant, Entry, faults};

/// The backends that run when nobody chooses, in the order of reports.
pub const DEFAULT: &[&str] =
    &["exact", "sos", "sos:edelsbrunner-mucke", "tolerance", "naive", "naive:first", "epsilon:1e-10", "shewchuk"];

/// What can be written after `-b`, for help texts.
pub const HELP: &str = "\
exact                   the sign of the real determinant
sos                     Simulation of Simplicity, x_i + eps^(2^i) (Franklin)
sos:edelsbrunner-mucke  Simulation of Simplicity, last coordinate strongest
sos:per-mesh            the second of two meshes moved by (eps, eps^2, eps^3), for contacts
tolerance               the hierarchical tolerances of Wang et al.
tolerance:f32           the same in single precision, for scenes whose coordinates it holds exactly
naive, naive:first      plain floating point, pivot at the last or the first argument
epsilon:EPS             plain floating point, zero where |det| < EPS (1e-10 if left out)
shewchuk                the crate `robust` as it is
fault:NAME              a planted fault; `predicament selftest --list` names them
Where the tool is built with --features peers, Simulation of Simplicity from crates.io:
simplicity, geogram, rgeometry, delaunay, delaunay:sorted (by vertex, as the crate asks its kernel)";

/// Backends that are crates from crates.io, with the feature `peers`.
pub const WILD: &[&str] = &["simplicity", "geogram", "rgeometry", "delaunay", "delaunay:sorted"];

/// The backend with this name.
///
/// # Errors
/// One line with the names that there are.
pub fn backend(name: &str) -> Result<Box<dyn Contestant>, String> {
    Ok(match name {
        "exact" => Box::new(Entry::new(Exact)),
        "sos" | "sos:per-coordinate" => sos(Scheme::PerCoordinate),
        "sos:edelsbrunner-mucke" => sos(Scheme::EdelsbrunnerMucke),
        "sos:per-mesh" => Box::new(Entry::breaking_ties(PerMesh, infinitesimal::judge_per_mesh)),
        "tolerance" | "tolerance:f64" => Box::new(Entry::new(Tolerance::<f64>::new())),
        "tolerance:f32" => Box::new(Entry::new(Tolerance::<f32>::new())),
        "naive" | "naive:last" => Box::new(Entry::new(Naive { pivot: Pivot::Last })),
        "naive:first" => Box::new(Entry::new(Naive { pivot: Pivot::First })),
        "epsilon" => Box::new(Entry::new(Epsilon::default())),
        "shewchuk" => Box::new(Entry::new(Shewchuk)),
        _ => {
            if let Some(eps) = name.strip_prefix("epsilon:") {
                let eps: f64 =
                    eps.parse().map_err(|_| format!("`{name}`: `{eps}` is no number; write e.g. epsilon:1e-10"))?;
                let epsilon = Epsilon::new(eps).map_err(|error| format!("`{name}`: {error}"))?;
                return Ok(Box::new(Entry::new(epsilon)));
            }
            if let Some(fault) = name.strip_prefix("fault:") {
                return faults::backend(fault)
                    .ok_or_else(|| format!("no fault is called `{fault}`; `predicament selftest --list` names them"));
            }
            #[cfg(feature = "peers")]
            if let Some(wild) = crate::wild::backend(name) {
                return Ok(wild);
            }
            if WILD.contains(&name) {
                return Err(format!("`{name}` is there where the tool is built with --features peers"));
            }
            let names = DEFAULT.join(", ");
            return Err(format!("no backend is called `{name}`; there are {names}, and fault:NAME"));
        }
    })
}

fn sos(scheme: Scheme) -> Box<dyn Contestant> {
    Box::new(Entry::breaking_ties(Sos { scheme }, move |scene, question, args| {
        infinitesimal::judge(scheme, scene, question, args)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_backend_has_the_name_it_is_picked_by() {
        for name in DEFAULT.iter().copied().chain(["sos:per-mesh", "tolerance:f32", "fault:tolerance-as-printed"]) {
            assert_eq!(backend(name).unwrap().name(), name);
        }
    }

    #[test]
    fn mistakes_are_answered_with_what_there_is() {
        let error = |name| backend(name).err().unwrap();
        assert!(error("exat").contains("sos:edelsbrunner-mucke"));
        assert!(error("epsilon:tiny").contains("`tiny` is no number"));
        assert!(error("epsilon:-1").contains("epsilon:-1"));
        assert!(error("epsilon:nan").contains("epsilon:nan"));
        assert!(error("fault:none").contains("selftest --list"));
    }
}
