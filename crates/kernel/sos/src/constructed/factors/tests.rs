//! Products of factors against the search through the whole determinant.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Plane, Predicates};

use super::super::testing::{Random, search_all};
use super::*;

/// Points of one plane, and of lines with a common vertex: ties that have factors, in a small grid.
#[test]
fn products_are_those_of_the_search() {
    let mut random = Random(77);
    let (mut turns, mut sides, mut degrees) = (0, 0, [0; 12]);
    for round in 0..predicament_effort::scaled(900) {
        let units = [[1.0, 1.0, 1.0], [0.1, 3.0, 1e30], [3e-320, 1e-320, 5e-324]][round % 3];
        let points: Vec<[f64; 3]> =
            (0..9).map(|_| units.map(|unit| f64::from(u32::try_from(random.below(3)).unwrap()) * unit)).collect();
        let scene = Scene::from_points3(&points).unwrap();
        let mut session = Exact.prepare(&scene, Off).unwrap();
        let all: [Vertex; 9] = random.different(9);
        let [a, b, c, p, q, r, s, t, u] = all;
        let mut made: Vec<Vertex> = [
            Construction::Lpi { line: [p, q], plane: [a, b, c] },
            Construction::Lpi { line: [r, p], plane: [c, a, b] },
            Construction::Lpi { line: [q, r], plane: [b, a, c] },
            Construction::Lpi { line: [s, t], plane: [a, b, c] },
            Construction::Lpi { line: [p, q], plane: [t, u, c] },
            Construction::Tpi([[p, q, s], [b, c, a], [r, s, u]]),
            Construction::Tpi([[p, t, u], [s, q, p], [b, a, c]]),
            Construction::Tpi([[t, u, p], [a, b, c], [r, s, u]]),
        ]
        .into_iter()
        .filter_map(|of| session.construct(&[of]).ok())
        .flatten()
        .collect();
        made.extend([a, p, q, r]);
        let scene = session.scene();
        let rows = Rows::new(scene);
        for _ in 0..12 {
            // The points of the plane come first.
            let (arity, others) = [(3, 3), (4, 0)][random.below(2)];
            let mut left = made[..made.len() - others].to_vec();
            if left.len() < arity {
                continue;
            }
            let args: Vec<Vertex> = (0..arity).map(|_| left.swap_remove(random.below(left.len()))).collect();
            let question = match arity {
                3 => Question::Orient2d([Plane::Xy, Plane::Yz, Plane::Zx][random.below(3)]),
                _ => Question::Orient3d,
            };
            if !question.ask(&session, &args).is_zero() {
                continue;
            }
            let Some(decided) = decide(scene, &rows, question, &args) else { continue };
            assert_eq!(decided, search_all(scene, question, &args), "{question:?} of {args:?} in {scene:?}");
            *if args.len() == 3 { &mut turns } else { &mut sides } += 1;
            degrees[decided.map_or(0, |(_, degree)| degree)] += 1;
        }
    }
    assert!(turns > 50 && sides > 50 && degrees[..4].iter().all(|count| *count > 5), "{turns} {sides} {degrees:?}");
}
