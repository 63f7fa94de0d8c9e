//! The polygons that `triangulate` promises to handle. If sides cross or overlap, the input is not a polygon, and every
//! answer breaks some rule.

use predicament_judge as judge;
use predicament_predicates::{Axis, Dimension, Plane, Question, Scene, Sign, Vertex};

/// True if the sides of loops in the plane have nothing in common but the corners between consecutive sides.
///
/// (Loops may touch further and still be polygons; this function does not recognize those, nor faces in space.)
#[must_use]
pub fn is_simple(scene: &Scene, loops: &[Vec<Vertex>]) -> bool {
    let mut corners: Vec<Vertex> = loops.concat();
    corners.sort_unstable();
    if scene.dimension() != Dimension::Two || corners.windows(2).any(|pair| pair[0] == pair[1]) {
        return false;
    }
    let turn = |a: Vertex, b: Vertex, c: Vertex| judge::sign(scene, Question::Orient2d(Plane::Xy), &[a, b, c]);
    let sides: Vec<[Vertex; 2]> = loops
        .iter()
        .flat_map(|corners| (0..corners.len()).map(|at| [corners[at], corners[(at + 1) % corners.len()]]))
        .collect();
    sides.iter().enumerate().all(|(at, &[a, b])| {
        sides[at + 1..].iter().all(|&[c, d]| {
            let shared = [a, b].iter().filter(|v| [c, d].contains(v)).count();
            let signs = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
            match shared {
                // Disjoint: both ends of one side are on the same side of the other's line.
                0 => [[0, 1], [2, 3]].iter().any(|&[p, q]| signs[p] == signs[q] && signs[p] != Sign::Zero),
                // Consecutive: they turn, or continue in the same direction.
                1 => {
                    let way = |[from, to]: [Vertex; 2]| {
                        [Axis::X, Axis::Y].map(|axis| judge::sign(scene, Question::Compare(axis), &[from, to]))
                    };
                    signs.iter().any(|&sign| sign != Sign::Zero) || way([a, b]) == way([c, d])
                }
                _ => false,
            }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_that_meet_are_no_polygon() {
        let is_simple = |points: &[f64]| {
            let scene = Scene::new(Dimension::Two, points.to_vec()).unwrap();
            let all: Vec<Vertex> = scene.vertices().collect();
            is_simple(&scene, &[all])
        };
        assert!(is_simple(&[0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 1.0, 1.0]) && is_simple(&[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]));
        // They cross, they turn back, one ends on another, two corners coincide.
        assert!(!is_simple(&[0.0, 0.0, 4.0, 4.0, 4.0, 0.0, 0.0, 4.0]));
        assert!(!is_simple(&[2.0, 3.0, 0.0, 1.0, 2.0, 0.0, 0.0, 1.0]));
        assert!(!is_simple(&[0.0, 0.0, 4.0, 0.0, 2.0, 0.0, 0.0, 4.0]));
        assert!(!is_simple(&[0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 0.0, -1.0, 5.0]));
    }
}
