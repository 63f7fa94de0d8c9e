//! Ties between input vertices of two meshes, decided by the determinant's derivatives. One of the meshes has moved as
//! a whole.
//!
//! A determinant of differences is linear in a translation (δx, δy, δz) of one of its points, and a translation of all
//! others equals the opposite translation of that one. So with one vertex of one mesh and the rest of the other, the
//! first nonzero derivative breaks the tie: with δ = η·(ε, ε², ε³), by x, y, z in turn. Derivatives of `orient2d` are
//! differences of coordinates, those of `orient3d` are `orient2d` of the other three vertices. With p, q of one mesh
//! and u, v of the other, det(p − v, q − v, u − v) changes by δ · ((q − p) × (v − u)) as u and v move by δ, and by
//! nothing more.

use predicament_predicates::{Axis, Off, Plane, Predicates, Scene, Sign, Vertex};

use crate::crossed;

type Exact<'s> = predicament_exact::Session<'s, Off>;

/// The sign after the move and the deciding power of ε.
///
/// The inner `None`: zero however far the mesh moves. The outer `None`: this method does not apply.
pub(crate) type Shifted = Option<Option<(Sign, usize)>>;

/// A bit mask of the N vertices that move; `None` if one is constructed.
#[inline(always)]
fn moving<const N: usize>(exact: &Exact, args: [Vertex; N]) -> Option<u32> {
    let second = exact.scene().second_mesh()?;
    let mut moving = 0;
    for (at, v) in args.into_iter().enumerate() {
        // (The index of a constructed vertex is beyond those of all input vertices.)
        moving |= u32::from(*second.get(v.index())?) << at;
    }
    Some(moving)
}

/// The one of N vertices that is of another mesh than the rest, and the sign of its move relative to them.
///
/// The outer `None` stands for two and two, the inner one for vertices of one mesh.
#[inline(always)]
fn odd_one<const N: usize>(exact: &Exact, args: [Vertex; N]) -> Option<Option<(usize, Sign)>> {
    let moving = moving(exact, args)?;
    match moving.count_ones() as usize {
        0 => Some(None),
        count if count == N => Some(None),
        1 => Some(Some((moving.trailing_zeros() as usize, Sign::Positive))),
        count if count == N - 1 => Some(Some((moving.trailing_ones() as usize, Sign::Negative))),
        _ => None,
    }
}

/// Breaks a tie of `compare`.
pub(crate) fn compare(exact: &Exact, axis: Axis, args: [Vertex; 2]) -> Shifted {
    Some(odd_one(exact, args)?.map(|(at, sign)| (if at == 0 { sign } else { -sign }, axis.index() + 1)))
}

/// Breaks a tie of `orient2d`.
pub(crate) fn orient2d(exact: &Exact, plane: Plane, args: [Vertex; 3]) -> Shifted {
    let Some((at, moves)) = odd_one(exact, args)? else { return Some(None) };
    // Rotated until the odd one comes last.
    let [a, b] = [args[(at + 1) % 3], args[(at + 2) % 3]];
    let [i, j] = plane.axes();
    let scene = exact.scene();
    let order = |axis: Axis, u: Vertex, v: Vertex| {
        let [u, v] = [u, v].map(|v| scene.coordinate(axis, v));
        match (u > v, u < v) {
            (true, _) => Sign::Positive,
            (_, true) => Sign::Negative,
            _ => Sign::Zero,
        }
    };
    // A move along the first axis counts more, and turns by the distance along the other.
    let derivative = |axis: Axis| if axis == i { order(j, a, b) } else { order(i, b, a) };
    let [first, second] = if i.index() < j.index() { [i, j] } else { [j, i] };
    let decided = [first, second].into_iter().find_map(|axis| {
        let sign = derivative(axis);
        (!sign.is_zero()).then_some((sign * moves, axis.index() + 1))
    });
    Some(decided)
}

/// Returns true if two input vertices of a scene in space coincide: two of different meshes, if they are distinct
/// vertices.
pub(crate) fn has_twins(scene: &Scene, [a, b, c, d]: [Vertex; 4]) -> bool {
    let points = scene.coordinates().as_chunks::<3>().0;
    let at = |v: Vertex| points.get(v.index());
    let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d)) else { return false };
    let is_one = |p: &[f64; 3], q: &[f64; 3]| (p[0] == q[0]) & (p[1] == q[1]) & (p[2] == q[2]);
    is_one(a, b) | is_one(a, c) | is_one(a, d) | is_one(b, c) | is_one(b, d) | is_one(c, d)
}

/// The sign of `orient3d` after the move, and the deciding power, for points of one mesh in a plane of the other.
///
/// All are input vertices. All points move alike, so the first nonzero component of the plane's normal decides.
pub(crate) struct PlaneTies {
    /// True if the plane moves.
    moves: bool,
    first: Option<(Sign, usize)>,
}

impl PlaneTies {
    /// The ties of a plane; `None` if it has constructed vertices, or vertices of both meshes.
    pub(crate) fn new(exact: &Exact, [a, b, c]: [Vertex; 3]) -> Option<PlaneTies> {
        let second = exact.scene().second_mesh()?;
        if [a, b, c].iter().any(|v| v.is_constructed()) {
            return None;
        }
        let moves = second[a.index()];
        if second[b.index()] != moves || second[c.index()] != moves {
            return None;
        }
        Some(PlaneTies { moves, first: normal(exact, [a, b, c]) })
    }

    /// The tie of an input vertex; the inner `None` stands for a tie that no move breaks.
    pub(crate) fn of(&self, exact: &Exact, d: Vertex) -> Shifted {
        if d.is_constructed() {
            return None;
        }
        let moves = exact.scene().second_mesh()?[d.index()];
        if moves == self.moves {
            return Some(None);
        }
        // The derivative by the last vertex is the negated normal.
        let sign = if moves { Sign::Negative } else { Sign::Positive };
        Some(self.first.map(|(first, power)| (first * sign, power)))
    }
}

/// The first nonzero component of a plane's normal, and the power of ε of a move along that axis.
fn normal(exact: &Exact, [a, b, c]: [Vertex; 3]) -> Option<(Sign, usize)> {
    let mut planes = [Plane::Yz, Plane::Zx, Plane::Xy].into_iter().zip(1..);
    planes.find_map(|(plane, power)| {
        let derivative = exact.decide_orient2d(plane, a, b, c).0;
        (!derivative.is_zero()).then_some((derivative, power))
    })
}

/// Breaks a tie of `orient3d`.
pub(crate) fn orient3d(exact: &Exact, args: [Vertex; 4]) -> Shifted {
    let Some((at, moves)) = (match odd_one(exact, args) {
        Some(odd) => odd,
        None => return two_and_two(exact, args),
    }) else {
        return Some(None);
    };
    let [mut a, mut b, mut c, d] = args;
    // Exchanged with the last, which changes the sign, as does the derivative by the last.
    let sign = if at == 3 { -moves } else { moves };
    match at {
        0 => a = d,
        1 => b = d,
        2 => c = d,
        _ => {}
    }
    Some(normal(exact, [a, b, c]).map(|(derivative, power)| (derivative * sign, power)))
}

/// Breaks a tie of `orient3d` about two vertices of each mesh.
fn two_and_two(exact: &Exact, args: [Vertex; 4]) -> Shifted {
    let [a, b, c, d] = args;
    // The vertices that stay first: an even permutation of the arguments, or an odd one.
    let (stay, move_, is_even) = match moving(exact, args)? {
        0b1100 => ([a, b], [c, d], true),
        0b0011 => ([c, d], [a, b], true),
        0b1010 => ([a, c], [b, d], false),
        0b0101 => ([b, d], [a, c], false),
        0b0110 => ([a, d], [b, c], true),
        0b1001 => ([b, c], [a, d], true),
        _ => return None,
    };
    let first = (0..3).find_map(|axis| {
        let derivative = crossed::along(exact.scene(), axis, stay, move_);
        (!derivative.is_zero()).then_some((if is_even { derivative } else { -derivative }, axis + 1))
    });
    Some(first)
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact as Backend;
    use predicament_predicates::{Backend as _, Dimension, Predicates as _};

    use super::*;

    fn vertices<const N: usize>(at: [usize; N]) -> [Vertex; N] {
        at.map(Vertex::input)
    }

    /// Six points, of which the last three are of the second mesh: the corners of a triangle, twice.
    fn twice() -> Scene {
        let triangle = [0.0, 0.0, 0.0, 4.0, 1.0, 0.0, 1.0, 4.0, 0.0];
        let scene = Scene::new(Dimension::Three, [triangle, triangle].concat()).unwrap();
        scene.with_second_mesh((3..6).map(Vertex::input))
    }

    /// Two meshes of four lattice points each, and the same with the second one moved by 1 along each axis.
    fn lattice(seed: usize) -> [Scene; 4] {
        [None, Some(0), Some(1), Some(2)].map(|moved| {
            let place = |at: usize| {
                let digits = (seed * 8 + at) * 7919 % 6841;
                [0, 1, 2].map(|axis| {
                    let by = u32::from(at >= 4 && moved == Some(axis));
                    // The fourth power of 3 at most: coordinates are 0, 1 or 2.
                    f64::from(u32::try_from(digits / [1, 3, 9][axis] % 3).unwrap() + by)
                })
            };
            let scene = Scene::new(Dimension::Three, (0..8).flat_map(place).collect()).unwrap();
            scene.with_second_mesh((4..8).map(Vertex::input))
        })
    }

    /// The ordered choices of N among eight vertices.
    fn choices<const N: usize>() -> impl Iterator<Item = [usize; N]> {
        let all = (0..8_usize.pow(u32::try_from(N).unwrap())).map(|code| {
            let mut rest = code;
            [(); N].map(|()| {
                let digit = rest % 8;
                rest /= 8;
                digit
            })
        });
        all.filter(|args| (0..N).all(|at| !args[..at].contains(&args[at])))
    }

    /// All predicates are linear in the move.
    ///
    /// A tie is broken as by a move of 1 along the first axis along which such a move breaks it.
    #[test]
    fn ties_are_broken_as_by_a_move_of_a_whole_unit() {
        let mut seen = [[0; 4]; 3];
        for seed in 0..12 {
            let scenes = lattice(seed);
            let [still, moved @ ..] = scenes.each_ref().map(|scene| Backend.prepare(scene, Off).unwrap());
            let first = |signs: [Sign; 3]| {
                let mut powers = signs.into_iter().zip(1..);
                powers.find(|(sign, _)| !sign.is_zero())
            };
            let mut count = |predicate: usize, found: Shifted, expected: Option<(Sign, usize)>, args: &[usize]| {
                assert_eq!(found, Some(expected), "predicate {predicate} of {args:?} in {:?}", scenes[0].coordinates());
                seen[predicate][expected.map_or(0, |(_, power)| power)] += 1;
            };
            for args in choices() {
                let v @ [a, b, c, d] = vertices(args);
                if still.orient3d(a, b, c, d).is_zero() {
                    let signs = moved.each_ref().map(|exact| exact.orient3d(a, b, c, d));
                    count(2, orient3d(&still, v), first(signs), &args);
                }
            }
            for args in choices() {
                let v @ [a, b, c] = vertices(args);
                for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
                    if still.orient2d(plane, a, b, c).is_zero() {
                        let signs = moved.each_ref().map(|exact| exact.orient2d(plane, a, b, c));
                        count(1, orient2d(&still, plane, v), first(signs), &args);
                    }
                }
            }
            for args in choices() {
                let v @ [a, b] = vertices(args);
                for axis in [Axis::X, Axis::Y, Axis::Z] {
                    if still.compare(axis, a, b).is_zero() {
                        let signs = moved.each_ref().map(|exact| exact.compare(axis, a, b));
                        count(0, compare(&still, axis, v), first(signs), &args);
                    }
                }
            }
        }
        for (predicate, powers) in seen.iter().enumerate() {
            assert!(powers.iter().all(|&of_power| of_power > 50), "predicate {predicate}: {powers:?}");
        }
    }

    /// The batch about one plane gives the same signs as its single queries.
    #[test]
    fn a_plane_breaks_ties_as_its_vertices_do() {
        let mut ties = 0;
        for seed in 0..12 {
            let [scene, ..] = lattice(seed);
            let exact = Backend.prepare(&scene, Off).unwrap();
            for [a, b, c, d] in choices() {
                let is_one_mesh = (a < 4) == (b < 4) && (b < 4) == (c < 4);
                let ready = PlaneTies::new(&exact, vertices([a, b, c]));
                assert_eq!(ready.is_some(), is_one_mesh);
                let Some(ready) = ready else { continue };
                let v @ [p, q, r, s] = vertices([a, b, c, d]);
                if exact.orient3d(p, q, r, s).is_zero() {
                    assert_eq!(ready.of(&exact, s), orient3d(&exact, v), "{a} {b} {c}, {d}");
                    ties += 1;
                }
            }
            let constructed = Vertex::constructed(0);
            assert!(PlaneTies::new(&exact, [constructed, Vertex::input(1), Vertex::input(2)]).is_none());
            let plane = PlaneTies::new(&exact, vertices([0, 1, 2])).unwrap();
            assert_eq!(plane.of(&exact, constructed), None);
        }
        assert!(ties > 300, "{ties}");
    }

    #[test]
    fn twins_are_seen_however_many_there_are() {
        let scene = twice();
        // One pair in each place, two pairs, none.
        for (args, has) in [
            ([0, 3, 1, 5], true),
            ([0, 1, 3, 5], true),
            ([0, 1, 5, 3], true),
            ([1, 0, 3, 5], true),
            ([1, 0, 5, 3], true),
            ([1, 5, 0, 3], true),
            ([0, 3, 1, 4], true),
            ([0, 1, 3, 4], true),
            ([0, 1, 4, 3], true),
            ([0, 1, 2, 0], true),
            ([0, 0, 0, 0], true),
        ] {
            assert_eq!(has_twins(&scene, vertices(args)), has, "{args:?}");
        }
        let apart =
            Scene::new(Dimension::Three, vec![0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 4.0]).unwrap();
        assert!(!has_twins(&apart, vertices([0, 1, 2, 3])));
    }

    #[test]
    fn derivatives_break_ties_of_one_and_three_and_of_two_and_two() {
        let scene = twice();
        let exact = Backend.prepare(&scene, Off).unwrap();
        // All in one plane, so that only a move along z has an effect: by the third power.
        let breaks = |args| orient3d(&exact, vertices(args));
        assert_eq!(breaks([0, 1, 2, 3]), Some(Some((Sign::Negative, 3))));
        assert_eq!(breaks([3, 4, 5, 0]), Some(Some((Sign::Positive, 3))));
        assert_eq!(breaks([0, 1, 4, 5]), Some(Some((Sign::Positive, 3))));
        assert_eq!(breaks([0, 1, 2, 2]), Some(None), "nothing moves against the rest");
        assert_eq!(moving(&exact, vertices([0, 3, 4])), Some(0b110));
        assert_eq!(moving(&exact, [Vertex::constructed(0)]), None);
        assert_eq!(compare(&exact, Axis::Y, vertices([0, 3])), Some(Some((Sign::Negative, 2))));
        assert_eq!(compare(&exact, Axis::Y, vertices([3, 0])), Some(Some((Sign::Positive, 2))));
    }
}
