//! The pairs in contact in a perturbed scene, which is in general position.
//!
//! Then the interiors of two simplices have a single common point only if their ranks add up to the dimension. If
//! larger simplices meet, some of their faces do so. A vertex of both complexes stays one vertex however it moves. So
//! the truth does not need a hierarchy: every pair of such ranks whose boxes meet is tested, and a few signs decide
//! whether it crosses.

use std::collections::BTreeSet;

use predicament_judge::{Judged, TieJudge};
use predicament_mesh::Simplex;
use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex};
use rayon::prelude::*;

use super::{Pair, simplices, vertices_of};
use crate::task::content::Complexes;
use predicament_tasks::{Stop, Watch};

/// The crossing pairs with these simplices of the first complex, and the crossing pairs among `said`.
pub(crate) fn perturbed(
    scene: &Scene,
    ties: &TieJudge,
    content: &Complexes,
    first: &BTreeSet<Simplex>,
    said: impl Iterator<Item = Pair>,
    watch: &Watch,
) -> Result<BTreeSet<Pair>, Stop> {
    let session = Judged::perturbed(scene, ties);
    let second = simplices(&content.b);
    let boxes: Vec<[[f64; 2]; 3]> = second.iter().map(|(_, vertices)| extent(scene, vertices)).collect();
    let of = |&s: &Simplex| -> Result<Vec<Pair>, Stop> {
        watch.done(0)?;
        let vertices = content.a.vertices_of(s);
        let reach = extent(scene, vertices);
        let near = second.iter().zip(&boxes).filter(|(_, other)| overlap(&reach, other));
        let crossing = near.filter(|((_, others), _)| cross(&session, vertices, others));
        Ok(crossing.map(|(&(t, _), _)| [s, t]).collect())
    };
    let first: Vec<Simplex> = first.iter().copied().collect();
    let found: Vec<Vec<Pair>> = first.par_iter().map(of).collect::<Result<_, _>>()?;
    let said = said.filter(|&pair| {
        let [s, t] = vertices_of(content, pair);
        cross(&session, s, t)
    });
    Ok(found.into_iter().flatten().chain(said).collect())
}

/// The bounding box of unperturbed vertices; a perturbation does not reach a disjoint box.
fn extent(scene: &Scene, vertices: &[Vertex]) -> [[f64; 2]; 3] {
    let axes = [Axis::X, Axis::Y, Axis::Z];
    std::array::from_fn(|axis| {
        if axis >= scene.dimension().count() {
            return [0.0; 2];
        }
        let along = vertices.iter().map(|&v| scene.coordinate(axes[axis], v));
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(x), most.max(x)])
    })
}

/// True if two closed boxes meet: comparing doubles is exact.
fn overlap(a: &[[f64; 2]; 3], b: &[[f64; 2]; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

/// True if the interiors have a single common point; for two vertices, if they are equal.
fn cross(session: &Judged<'_>, s: &[Vertex], t: &[Vertex]) -> bool {
    if s.iter().any(|v| t.contains(v)) {
        return s.len() == 1 && t.len() == 1;
    }
    let flat = session.scene().dimension().count() == 2;
    match (flat, s, t) {
        (true, &[a, b], &[p, q]) => {
            let sides = |a, b, [p, q]: [Vertex; 2]| [p, q].map(|v| session.orient2d(Plane::Xy, a, b, v));
            are_opposite(sides(a, b, [p, q])) && are_opposite(sides(p, q, [a, b]))
        }
        (true, &[a, b, c], &[p]) | (true, &[p], &[a, b, c]) => {
            are_alike([[a, b], [b, c], [c, a]].map(|[a, b]| session.orient2d(Plane::Xy, a, b, p)))
        }
        (false, &[a, b, c], &[p, q]) | (false, &[p, q], &[a, b, c]) => {
            are_opposite([p, q].map(|v| session.orient3d(a, b, c, v)))
                && are_alike([[a, b], [b, c], [c, a]].map(|[a, b]| session.orient3d(p, q, a, b)))
        }
        (false, &[a, b, c, d], &[p]) | (false, &[p], &[a, b, c, d]) => {
            let with = [[p, b, c, d], [a, p, c, d], [a, b, p, d], [a, b, c, p]];
            are_alike(with.map(|[a, b, c, d]| session.orient3d(a, b, c, d)))
        }
        _ => false,
    }
}

fn are_opposite([one, other]: [Sign; 2]) -> bool {
    one * other == Sign::Negative
}

fn are_alike<const N: usize>(signs: [Sign; N]) -> bool {
    signs[0] != Sign::Zero && signs.iter().all(|&sign| sign == signs[0])
}
