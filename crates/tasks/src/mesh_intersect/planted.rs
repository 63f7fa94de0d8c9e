//! Faults planted in answers: what is judged about results, curves and other ways to ask can fail.
//!
//! The overlay is right, and what is handed over is not.

use predicament_algorithms::overlay::Operation;
use predicament_algorithms::planted::Fault;
use predicament_mesh::OUTSIDE;
use predicament_predicates::Vertex;

use super::Overlaid;

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
