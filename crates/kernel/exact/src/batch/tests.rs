//! Tests that every width of registers answers like single queries.

use predicament_lanes::{Along, View, Whole, Width, Xy, Yz, Zx, run_on};
use predicament_predicates::{Sign, Vertex};
use proptest::prelude::*;

use super::{Batch, Of, Sweep, Unbroken, sweep};
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::side::Side;
use crate::stage;

/// A bound of the static filter that leaves about half of all queries to the second filter.
const STATIC_BOUND: f64 = 0.3;
const POINTS: usize = 40;

/// The ladder's answer in these tests, which only check which queries reach it.
const CLIMBED: Sign = Sign::Zero;

/// Vertices of a scene; the last few have no points.
fn vertices() -> impl Strategy<Value = Vec<Vertex>> {
    let within = |end: usize| prop::collection::vec((0..end).prop_map(Vertex::input), 0..700);
    // Often no vertex is the last, and often some vertices do not exist.
    prop_oneof![within(POINTS - 1), within(POINTS), within(POINTS + 2)]
}

fn points<const D: usize>() -> impl Strategy<Value = Vec<[f64; D]>> {
    prop::collection::vec(prop::array::uniform(-1.0..1.0), POINTS)
}

/// The widths that this machine has: at least one.
fn widths() -> impl Iterator<Item = Width> {
    Width::ALL.into_iter().filter(|width| width.is_available())
}

fn check<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
    points: &[[f64; E]],
    vertices: &[Vertex],
) {
    let queries = vertices.as_chunks::<N>().0;
    let mut expected = Vec::new();
    let mut counts = [0; 3];
    for query in queries {
        let seen = query.map(|v| points.get(v.index()).map_or([f64::NAN; D], |point| V::see(*point)));
        let (by_static, by_query) = (P::estimate(seen).above(STATIC_BOUND), P::anywhere(seen).certain());
        counts[if by_static.is_some() { 0 } else { 2 - usize::from(by_query.is_some()) }] += 1;
        expected.push(by_static.or(by_query).unwrap_or(CLIMBED));
    }
    for width in widths() {
        let mut out = vec![Sign::Positive; queries.len()];
        let settled = run_on(
            width,
            Of {
                batch: Batch {
                    static_bound: STATIC_BOUND,
                    points,
                    queries,
                    out: &mut out,
                    is_double: || false,
                    climb: |_: &[Vertex; N]| (CLIMBED, stage::DYADIC),
                    ties: Unbroken,
                },
                predicate: std::marker::PhantomData::<(P, V, [(); D])>,
            },
        );
        assert_eq!(out, expected, "{width:?}");
        let stages = [stage::STATIC, stage::SEMI_STATIC, stage::DYADIC];
        assert_eq!(stages.map(|stage| settled[stage]), counts, "{width:?}");
        assert_eq!(settled.iter().sum::<u64>(), queries.len() as u64);
    }
}

fn check_sweep<V: View<E, D>, const E: usize, const D: usize, const N: usize>(
    evaluate: impl Fn([[f64; D]; N]) -> f64,
    points: &[[f64; E]],
    vertices: &[Vertex],
) {
    let bound = 0.3;
    let queries = vertices.as_chunks::<N>().0;
    let expected = queries.iter().map(|query| {
        let seen = query.map(|v| points.get(v.index()).map_or([f64::NAN; D], |point| V::see(*point)));
        let value = evaluate(seen);
        if value.abs() >= bound { Sign::of(value) } else { CLIMBED }
    });
    let expected: Vec<Sign> = expected.collect();
    for width in widths() {
        let mut out = vec![Sign::Positive; queries.len()];
        let work = Sweep {
            evaluate: |points: [[f64; D]; N]| (evaluate(points), bound),
            points,
            queries,
            out: &mut out,
            stage: stage::COMPARE,
            climb: |_: &[Vertex; N]| (CLIMBED, stage::DYADIC),
        };
        let settled = run_on(width, sweep::In { sweep: work, view: std::marker::PhantomData::<(V, [(); D])> });
        assert_eq!(out, expected, "{width:?}");
        let open = expected.iter().filter(|sign| sign.is_zero()).count() as u64;
        assert_eq!(
            [settled[stage::COMPARE], settled[stage::DYADIC]],
            [expected.len() as u64 - open, open],
            "{width:?}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn all_widths_answer_alike(flat in points::<2>(), solid in points::<3>(), vertices in vertices()) {
        check::<Orient2d, Whole, 2, 2, 3>(&flat, &vertices);
        check::<Orient2d, Xy, 3, 2, 3>(&solid, &vertices);
        check::<Orient2d, Yz, 3, 2, 3>(&solid, &vertices);
        check::<Orient2d, Zx, 3, 2, 3>(&solid, &vertices);
        check::<Orient3d, Whole, 3, 3, 4>(&solid, &vertices);
        check::<Incircle, Whole, 2, 2, 4>(&flat, &vertices);
        check::<Insphere, Whole, 3, 3, 5>(&solid, &vertices);
    }

    #[test]
    fn all_widths_see_the_same_side(flat in points::<2>(), solid in points::<3>(), vertices in vertices()) {
        // Written out, in the order of evaluation.
        let side = Side::of_line([flat[0], flat[1]], [2.0; 2]);
        let ([nx, ny], [x, y]) = (side.normal, side.pivot);
        check_sweep::<Whole, 2, 2, 1>(|[p]| nx * (x - p[0]) + ny * (y - p[1]), &flat, &vertices);
        check_sweep::<Zx, 3, 2, 1>(|[p]| side.determinant(p), &solid, &vertices);
        let side = Side::of_plane([solid[0], solid[1], solid[2]], [2.0; 3]);
        let ([nx, ny, nz], [x, y, z]) = (side.normal, side.pivot);
        let written_out = |[p]: [[f64; 3]; 1]| nx * (x - p[0]) + ny * (y - p[1]) + nz * (z - p[2]);
        check_sweep::<Whole, 3, 3, 1>(written_out, &solid, &vertices);
        check_sweep::<Along<1>, 2, 1, 2>(|[[x], [y]]| x - y, &flat, &vertices);
        check_sweep::<Along<2>, 3, 1, 2>(|[[x], [y]]| x - y, &solid, &vertices);
    }
}
