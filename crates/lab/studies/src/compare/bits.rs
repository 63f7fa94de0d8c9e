//! The bit length of the arithmetic that settled the answers.

use predicament_exact::Precision as Planned;
use predicament_exact::determinant::{INCIRCLE, INSPHERE, ORIENT2D, ORIENT3D};
use predicament_predicates::{PredicateKind, Scene};
use predicament_tasks::Contestant;

use crate::Precision;

/// The bits of a double's significand.
const DOUBLE: i32 = 53;
/// The bits of a single's significand.
const SINGLE: i32 = 24;

/// The names of stages that compute in floating point alone.
const FLOAT: [&str; 7] =
    ["compare", "double", "static filter", "semi-static filter", "float", "shifted float", "estimate"];

/// The bits of the widest arithmetic that settled a query of a scene.
///
/// If floating point settled all queries, the result is the bits of a significand. Otherwise it bounds the bits of a
/// determinant, for the queried predicate of the highest degree: the degree times the bits of differences, plus the
/// growth of sums. `None` if unknown: for points that a task constructs, and for libraries that do not say what they
/// compute in.
pub(super) fn bits(
    backend: &dyn Contestant,
    scene: &Scene,
    (kinds, constructs): (&[PredicateKind], bool),
    stages: &[(&'static str, u64)],
) -> Option<i32> {
    // Contacts, for example, are not counted by stage: then any stage of the backend may have settled them.
    let all_float = if stages.is_empty() {
        backend.stages().iter().all(|stage| FLOAT.contains(stage))
    } else {
        stages.iter().all(|(stage, _)| FLOAT.contains(stage))
    };
    if all_float {
        return Some(if Precision::of_backend(&backend.name()) == Precision::Single { SINGLE } else { DOUBLE });
    }
    let has_ladder = predicament_exact::stage::NAMES.iter().all(|stage| backend.stages().contains(stage));
    (has_ladder && !constructs && !stages.is_empty()).then(|| exact(scene, kinds))
}

/// A bound on the bits of the largest determinant of these predicates in a scene.
fn exact(scene: &Scene, kinds: &[PredicateKind]) -> i32 {
    let bits = Planned::of(scene).bits;
    let of = |kind: &PredicateKind| {
        let form = match kind {
            // A difference.
            PredicateKind::Compare => return bits,
            PredicateKind::Orient2d => ORIENT2D.form,
            PredicateKind::Orient3d => ORIENT3D.form,
            PredicateKind::Incircle => INCIRCLE.form,
            PredicateKind::Insphere => INSPHERE.form,
            PredicateKind::Derived(derived) => {
                let bits = derived.formula().bits().of(bits.unsigned_abs());
                return i32::try_from(bits).unwrap_or(i32::MAX);
            }
        };
        form.degree * bits + form.growth
    };
    kinds.iter().map(of).max().unwrap_or(DOUBLE).max(DOUBLE)
}
