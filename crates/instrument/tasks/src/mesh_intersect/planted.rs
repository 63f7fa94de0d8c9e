//! Faults planted in the overlay, in limits, and in answers: what is judged can fail.
//!
//! Those in answers are of what is handed over, after the overlay was right.

use predicament_algorithms::mesh_limit::planted::Planted as WrongLimit;
use predicament_algorithms::mesh_limit::planted::{KeepsJoints, KeepsSheets, KeepsVertices};
use predicament_algorithms::mesh_overlay::planted::{
    DropsAPiece, ForgetsToTurn, LooksAtTwoSides, LosesAContact, Planted as Wrong, SortsPointsBackwards, SwapsSides,
    TakesComponentsForOutside,
};
use predicament_algorithms::overlay::Operation;
use predicament_algorithms::planted::{Fault, Honest};
use predicament_mesh::OUTSIDE;
use predicament_predicates::{Construction, Vertex};

use super::content::TwoMeshes;
use super::settled::Settled;
use super::{MeshIntersect, Overlaid};
use crate::{Catch, Class, Planted};

/// The checks that have to find an edge that is taken to pass through a triangle beside it, or not.
const SIDES_CHECKS: &[Catch] = &[(Class::Topology, "two triangles meet in one segment")];
/// The checks that have to find points out of order, or too few of them.
const BACKWARDS_CHECKS: &[Catch] = &[(Class::Topology, "vertices that no triangle parts are in one region")];
/// The checks that have to find a missing piece.
const DROPPED_CHECKS: &[Catch] =
    &[(Class::Topology, "region not closed"), (Class::Topology, "face area"), (Class::Topology, "volume")];
/// The checks that have to find a component in the wrong region.
const COMPONENT_CHECKS: &[Catch] = &[
    (Class::Topology, "region of a piece"),
    (Class::Topology, "point in a result"),
    (Class::Topology, "meshes exchanged"),
];
/// The checks that have to find pieces whose sides are exchanged.
const SWAPPED_CHECKS: &[Catch] = &[(Class::Topology, "sides of a piece")];
/// The checks that have to find a result whose surface is turned over in part.
const TURNED_CHECKS: &[Catch] = &[(Class::Topology, "operation")];

/// The checks that have to find a hole in a result.
const HOLE_CHECKS: &[Catch] = &[
    (Class::Topology, "result not closed"),
    (Class::Topology, "volumes of results"),
    (Class::Topology, "areas of results"),
    (Class::Topology, "a mesh with itself"),
];
/// The checks that have to find two points that are taken for one.
const JOINED_CHECKS: &[Catch] = &[
    (Class::Topology, "curve not closed"),
    (Class::Topology, "corner of a result"),
    (Class::Topology, "Euler characteristic"),
];
/// The checks that have to find a surface that is there twice, once each way.
const FLAP_CHECKS: &[Catch] = &[(Class::Topology, "edge of a result")];
/// The checks that have to find more pieces at an edge than there is room for.
const REPEATED_CHECKS: &[Catch] =
    &[(Class::Topology, "edge of a piece"), (Class::Topology, "segment of a curve"), (Class::Topology, "face area")];
/// The checks that have to find another difference.
const OTHER_CHECKS: &[Catch] = &[(Class::Topology, "difference by complement"), (Class::Topology, "point in a result")];

/// The checks that have to find vertices of a limit at one place.
const VERTICES_CHECKS: &[Catch] = &[(Class::Topology, "vertices of a limit")];
/// The checks that have to find what faces each other in a limit.
const SHEETS_CHECKS: &[Catch] = &[(Class::Topology, "settled result crosses itself")];
/// The checks that have to find an edge with a vertex on it.
const JOINTS_CHECKS: &[Catch] = &[(Class::Topology, "settled result not closed")];
/// The checks that have to find another limit.
const OVER_CHECKS: &[Catch] = &[(Class::Topology, "areas of a limit"), (Class::Topology, "point in a result")];
/// The checks that have to find a limit that is too large.
const UNION_CHECKS: &[Catch] =
    &[(Class::Topology, "limit of a mesh with itself"), (Class::Topology, "areas of a limit")];
/// The checks that have to find a vertex elsewhere.
const MOVED_CHECKS: &[Catch] = &[(Class::Topology, "place of a rounded vertex")];
/// The checks that have to find a hole in doubles.
const LOST_CHECKS: &[Catch] = &[(Class::Topology, "settled result not closed")];

/// The checks that have to find two places that are taken for one.
const MERGED_CHECKS: &[Catch] = &[(Class::Topology, "areas of a limit")];
/// The checks that have to find a triangle through others.
const PASSING_CHECKS: &[Catch] =
    &[(Class::Topology, "settled result crosses itself"), (Class::Topology, "place of a rounded vertex")];
/// The checks that have to find a triangle with its back.
const SHEET_CHECKS: &[Catch] = &[(Class::Topology, "sheet")];
/// The checks that have to find a vertex that is nowhere.
const NOWHERE_CHECKS: &[Catch] = &[(Class::Topology, "vertex of a limit")];

/// The algorithm and its results with all faults.
pub(super) fn all() -> Vec<Planted<MeshIntersect>> {
    fn fault<F: Wrong>(backend: &'static str, caught_by: &'static [Catch]) -> Planted<MeshIntersect> {
        Planted::new::<F>(backend, caught_by, |session, content: &TwoMeshes| {
            Overlaid::of::<F, Honest>(session, content, true)
        })
    }
    fn spoiled<F: Spoils>(backend: &'static str, caught_by: &'static [Catch]) -> Planted<MeshIntersect> {
        Planted::new::<F>(backend, caught_by, |session, content: &TwoMeshes| {
            let mut answer = Overlaid::of::<Honest, Honest>(session, content, true)?;
            F::spoil(&mut answer);
            Ok(answer)
        })
    }
    fn limit<F: WrongLimit>(caught_by: &'static [Catch]) -> Planted<MeshIntersect> {
        Planted::new::<F>("sos:per-mesh", caught_by, |session, content: &TwoMeshes| {
            Overlaid::of::<Honest, F>(session, content, true)
        })
    }
    vec![
        fault::<LooksAtTwoSides>("sos", SIDES_CHECKS),
        fault::<SortsPointsBackwards>("sos", BACKWARDS_CHECKS),
        fault::<DropsAPiece>("sos", DROPPED_CHECKS),
        fault::<TakesComponentsForOutside>("sos", COMPONENT_CHECKS),
        fault::<SwapsSides>("sos", SWAPPED_CHECKS),
        fault::<ForgetsToTurn>("sos", TURNED_CHECKS),
        fault::<LosesAContact>("tolerance", BACKWARDS_CHECKS),
        spoiled::<LosesATriangle>("sos", HOLE_CHECKS),
        spoiled::<JoinsPoints>("exact", JOINED_CHECKS),
        spoiled::<AddsAFlap>("exact", FLAP_CHECKS),
        spoiled::<RepeatsPieces>("exact", REPEATED_CHECKS),
        spoiled::<TakesTheOtherDifference>("exact", OTHER_CHECKS),
        limit::<KeepsVertices>(VERTICES_CHECKS),
        limit::<KeepsSheets>(SHEETS_CHECKS),
        limit::<KeepsJoints>(JOINTS_CHECKS),
        spoiled::<TurnsALimitOver>("exact", OVER_CHECKS),
        spoiled::<TakesTheUnionsLimit>("sos:per-mesh", UNION_CHECKS),
        spoiled::<MovesAVertex>("exact", MOVED_CHECKS),
        spoiled::<LosesARoundedTriangle>("exact", LOST_CHECKS),
        spoiled::<MergesPlaces>("exact", MERGED_CHECKS),
        spoiled::<PassesThrough>("exact", PASSING_CHECKS),
        spoiled::<AddsASheet>("exact", SHEET_CHECKS),
        spoiled::<LosesAPlace>("exact", NOWHERE_CHECKS),
    ]
}

/// What is handed over without a perturbation.
fn settled(answer: &mut Overlaid) -> Option<&mut Settled> {
    answer.settled.as_mut()?.as_mut().ok()
}

/// A fault in an answer.
pub(super) trait Spoils: Fault {
    /// Spoils an answer.
    fn spoil(answer: &mut Overlaid);
}

macro_rules! fault {
    ($type:ident, $about:literal, $name:literal, $what:literal, $spoil:expr) => {
        #[doc = $about]
        #[derive(Clone, Copy, Debug)]
        pub(super) struct $type;

        impl Fault for $type {
            const NAME: &'static str = $name;
            const WHAT: &'static str = $what;
        }

        impl Spoils for $type {
            fn spoil(answer: &mut Overlaid) {
                let spoil: fn(&mut Overlaid) = $spoil;
                spoil(answer);
            }
        }
    };
}

fault!(
    LosesATriangle,
    "A hole in the union.",
    "mesh-intersect-loses-a-triangle",
    "the union lacks its first triangle",
    |answer| {
        answer.solids[0] = answer.solids[0].split_off(usize::from(!answer.solids[0].is_empty()));
        answer.sources[0] = answer.sources[0].split_off(usize::from(!answer.sources[0].is_empty()));
    }
);
fault!(
    JoinsPoints,
    "One vertex where there are two.",
    "mesh-intersect-joins-points",
    "the last constructed vertex is taken for the first",
    |answer| {
        let [first, last] = [0, answer.constructions.len().saturating_sub(1)];
        let [first, last] = [first, last].map(|at| Vertex::constructed(answer.before + at));
        let triangles = answer.solids.iter_mut().flatten().chain(&mut answer.regions.triangles);
        triangles.flatten().filter(|v| **v == last).for_each(|v| *v = first);
    }
);
fault!(
    AddsAFlap,
    "A triangle with its back.",
    "mesh-intersect-adds-a-flap",
    "a triangle of the intersection is there again, and turned over",
    |answer| {
        if let (Some(&[a, b, c]), Some(&source)) = (answer.solids[1].first(), answer.sources[1].first()) {
            answer.solids[1].extend([[a, b, c], [a, c, b]]);
            answer.sources[1].extend([source; 2]);
        }
    }
);
fault!(
    RepeatsPieces,
    "Pieces that are there thrice.",
    "mesh-intersect-repeats-pieces",
    "the first piece and the last are there again, once as they are and once with their sides exchanged",
    |answer| {
        let regions = &mut answer.regions;
        for at in [0, regions.triangles.len().saturating_sub(1)] {
            let Some(&[front, behind]) = regions.sides.get(at) else { return };
            regions.triangles.extend([regions.triangles[at]; 2]);
            regions.sources.extend([regions.sources[at]; 2]);
            regions.sides.extend([[front, behind], [behind, front]]);
        }
    }
);
fault!(
    TakesTheOtherDifference,
    "The difference the other way round.",
    "mesh-intersect-takes-the-other-difference",
    "the second mesh less the first is the difference",
    |answer| {
        let regions = &answer.regions;
        answer.solids[2].clear();
        answer.sources[2].clear();
        for ((&[a, b, c], sides), &source) in regions.triangles.iter().zip(&regions.sides).zip(&regions.sources) {
            let is_inside = sides.map(|side| {
                let [first, second] = regions.pairs[side as usize].map(|region| region != OUTSIDE);
                Operation::Difference.holds([second, first])
            });
            match is_inside {
                [false, true] => answer.solids[2].push([a, b, c]),
                [true, false] => answer.solids[2].push([a, c, b]),
                _ => continue,
            }
            answer.sources[2].push(source);
        }
    }
);
fault!(
    TurnsALimitOver,
    "A limit inside out.",
    "mesh-intersect-turns-a-limit-over",
    "the limit of the union is inside out",
    |answer| {
        if let Some(settled) = settled(answer) {
            settled.results[0].solid.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
    }
);
fault!(
    TakesTheUnionsLimit,
    "Another result's limit.",
    "mesh-intersect-takes-the-unions-limit",
    "the limit of the union is taken for that of the difference",
    |answer| {
        if let Some(settled) = settled(answer) {
            settled.results[2] = settled.results[0].clone();
        }
    }
);
fault!(
    MovesAVertex,
    "A vertex in doubles elsewhere.",
    "mesh-intersect-moves-a-vertex",
    "the first vertex of the union in doubles is two ulps up",
    |answer| {
        if let Some(point) = settled(answer).and_then(|settled| settled.results[0].rounded.closed.points.first_mut()) {
            point[2] = point[2].next_up().next_up();
        }
    }
);
fault!(
    LosesARoundedTriangle,
    "A hole in doubles.",
    "mesh-intersect-loses-a-rounded-triangle",
    "the union in doubles lacks its last triangle",
    |answer| {
        if let Some(settled) = settled(answer) {
            settled.results[0].rounded.closed.triangles.pop();
        }
    }
);
fault!(
    MergesPlaces,
    "Two places of a limit that are taken for one.",
    "mesh-intersect-merges-places",
    "in the limit of the union the corner of its last triangle stands for that of its first one, too",
    |answer| {
        let Some(settled) = settled(answer) else { return };
        let triangles = &mut settled.results[0].solid.triangles;
        let (Some(&[first, ..]), Some(&last)) = (triangles.first(), triangles.last()) else { return };
        let [.., other] = last;
        triangles.iter_mut().flatten().filter(|v| **v == first).for_each(|v| *v = other);
        // (What has a vertex twice now has no area.)
        triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    }
);
fault!(
    PassesThrough,
    "A rounded triangle that passes through others.",
    "mesh-intersect-passes-through",
    "the first vertex of the union in doubles is beyond the one that is farthest from it",
    |answer| {
        let Some(settled) = settled(answer) else { return };
        let points = &mut settled.results[0].rounded.closed.points;
        let Some(&first) = points.first() else { return };
        let far = |p: &[f64; 3]| (0..3).map(|axis| (p[axis] - first[axis]).abs()).fold(0.0, f64::max);
        if let Some(&farthest) = points.iter().max_by(|p, q| far(p).total_cmp(&far(q))) {
            // (Not in line with anything.)
            let step = [1.25, 1.125, 1.375];
            points[0] = [0, 1, 2].map(|axis| first[axis] + step[axis] * (farthest[axis] - first[axis]));
        }
    }
);
fault!(
    AddsASheet,
    "A rounded triangle with its back.",
    "mesh-intersect-adds-a-sheet",
    "a triangle of the union in doubles is there again, and turned over",
    |answer| {
        if let Some(settled) = settled(answer)
            && let Some(&[a, b, c]) = settled.results[0].rounded.closed.triangles.first()
        {
            settled.results[0].rounded.closed.triangles.extend([[a, b, c], [a, c, b]]);
        }
    }
);
fault!(
    LosesAPlace,
    "A vertex of a limit that is nowhere.",
    "mesh-intersect-loses-a-place",
    "the line of the first constructed vertex is one in its plane",
    |answer| {
        if let Some(settled) = settled(answer)
            && let Some(Construction::Lpi { line, plane: [a, b, _] }) = settled.constructions.first_mut()
        {
            *line = [*a, *b];
        }
    }
);
