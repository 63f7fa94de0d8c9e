//! Every comparison of Algorithms 2 to 5 and 7 to 12 with its tolerance.
//!
//! A pair just within the tolerance is answered differently from a pair just beyond it, with everything else equal.

use predicament_predicates::Band;
use predicament_tolerance::algorithms::{plane, space};
use predicament_tolerance::{Float, Tolerances2d, Tolerances3d};

/// Returns whether the step passes for a value just below T and for one just above it.
fn passes(band: Band, registered: impl Fn(f64) -> bool) -> [bool; 2] {
    // Nearer to T than T₋ and T₊ are, and further than the rounding errors of these simple numbers.
    [15.0 / 16.0, 17.0 / 16.0].map(|factor| registered(band.width * factor))
}

/// The step registers up to T.
const WITHIN: [bool; 2] = [true, false];
/// The step registers beyond T.
const BEYOND: [bool; 2] = [false, true];

fn p<F: Float, const D: usize, const N: usize>(points: [[f64; D]; N]) -> [[F; D]; N] {
    points.map(|point| point.map(F::nearest))
}

fn check_plane<F: Float>() {
    let t = &Tolerances2d::<F>::from_length(F::one());
    let vertex_vertex = |d: f64| {
        let [a, b] = p([[0.0, 0.0], [0.0, d]]);
        plane::vertex_vertex(t, &a, &b)
    };
    assert_eq!(passes(t.sigma, vertex_vertex), WITHIN, "σ");

    let edge_vertex = |m: f64, d: f64| {
        let [a, b, v] = p([[0.0, 0.0], [m, 0.0], [m / 2.0, d]]);
        plane::edge_vertex(t, &[a, b], &v).is_some()
    };
    assert_eq!(passes(t.tau, |d| edge_vertex(0.5, d)), WITHIN, "τ");
    assert_eq!(passes(t.sigma_hat, |m| edge_vertex(m, 0.0)), BEYOND, "σ̂");

    // The arms of a cross; one of them is short.
    for short in 0..4 {
        let edge_edge = |area: f64| {
            let [a, b, c, d] = std::array::from_fn(|arm| if arm == short { 2.0 * area } else { 0.25 });
            plane::edge_edge(t, &p([[-a, 0.0], [b, 0.0]]), &p([[0.0, -c], [0.0, d]])).is_some()
        };
        assert_eq!(passes(t.kappa, edge_edge), BEYOND, "κ, arm {short}");
    }
    for (a, b, c) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        let triangle_vertex = |area: f64| {
            let mut triangle = [[0.0; 2]; 3];
            (triangle[a], triangle[b], triangle[c]) = ([0.0, 0.0], [0.5, 0.0], [0.0, 0.5]);
            let [v] = p([[0.25, 2.0 * area]]);
            plane::triangle_vertex(t, &p(triangle), &v).is_some()
        };
        assert_eq!(passes(t.kappa, triangle_vertex), BEYOND, "κ, corner {c}");
    }
}

fn check_space<F: Float>() {
    let t = &Tolerances3d::<F>::from_length(F::one());
    let vertex_vertex = |d: f64| {
        let [a, b] = p([[0.0; 3], [0.0, 0.0, d]]);
        space::vertex_vertex(t, &a, &b)
    };
    assert_eq!(passes(t.sigma, vertex_vertex), WITHIN, "σ");

    let edge_vertex = |m: f64, d: f64| {
        let [a, b, v] = p([[0.0; 3], [m, 0.0, 0.0], [m / 2.0, 0.0, d]]);
        space::edge_vertex(t, &[a, b], &v).is_some()
    };
    assert_eq!(passes(t.tau, |d| edge_vertex(0.75, d)), WITHIN, "τ");
    assert_eq!(passes(t.sigma_hat, |m| edge_vertex(m, 0.0)), BEYOND, "σ̂");

    let cross = |[a, b, c, d]: [f64; 4], height: f64| {
        let edges = (p([[-a, 0.0, 0.0], [b, 0.0, 0.0]]), p([[0.0, -c, height], [0.0, d, height]]));
        space::edge_edge(t, &edges.0, &edges.1).is_some()
    };
    assert_eq!(passes(t.gamma, |height| cross([0.5; 4], height)), WITHIN, "γ");
    // m = 2a · 1
    let thin = |m_squared: f64| cross([m_squared.sqrt() / 2.0, m_squared.sqrt() / 2.0, 0.5, 0.5], 0.0);
    assert_eq!(passes(t.lambda, thin), BEYOND, "λ");
    for short in 0..4 {
        // With arms s and ½ of one edge and ½ and ½ of the other, m = s + ½ and its weight s / m.
        let edge_edge = |weight: f64| {
            let s = 4.0 * weight / ((1.0 + 16.0 * weight).sqrt() + 1.0);
            cross(std::array::from_fn(|arm| if arm == short { s } else { 0.5 }), 0.0)
        };
        assert_eq!(passes(t.phi, edge_edge), BEYOND, "φ, arm {short}");
    }

    let triangle_vertex = |leg: f64, [x, y]: [f64; 2], height: f64| {
        let [v] = p([[x, y, height]]);
        space::triangle_vertex(t, &p([[0.0; 3], [leg, 0.0, 0.0], [0.0, 1.0, 0.0]]), &v).is_some()
    };
    assert_eq!(passes(t.delta, |height| triangle_vertex(1.0, [0.25, 0.25], height)), WITHIN, "δ");
    let thin = |m_squared: f64| triangle_vertex(m_squared.sqrt(), [m_squared.sqrt() / 3.0, 1.0 / 3.0], 0.0);
    assert_eq!(passes(t.nu, thin), BEYOND, "ν");
    assert_eq!(passes(t.zeta, |c| triangle_vertex(1.0, [0.5, c], 0.0)), BEYOND, "ζ, ĉ");
    assert_eq!(passes(t.zeta, |b| triangle_vertex(1.0, [b, 0.5], 0.0)), BEYOND, "ζ, b̂");
    assert_eq!(passes(t.zeta, |a| triangle_vertex(1.0, [0.5, 0.5 - a], 0.0)), BEYOND, "ζ, â");

    // Twice the triangle's area is 1, and the edge has length 1; the volume is a height.
    let pierced = |corners: [usize; 3], [x, y]: [f64; 2], ends: [f64; 2]| {
        let mut triangle = [[0.0; 3]; 3];
        for (corner, point) in corners.into_iter().zip([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]) {
            triangle[corner] = point;
        }
        space::triangle_edge(t, &p(triangle), &p(ends.map(|z| [x, y, z]))).is_some()
    };
    for corners in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        assert_eq!(passes(t.mu, |v| pierced(corners, [0.5, v], [0.5, -0.5])), BEYOND, "μ, {corners:?}");
    }
    assert_eq!(passes(t.xi, |v| pierced([0, 1, 2], [0.25, 0.25], [v, -0.5])), BEYOND, "ξ, v_P");
    assert_eq!(passes(t.xi, |v| pierced([0, 1, 2], [0.25, 0.25], [0.5, -v])), BEYOND, "ξ, v_Q");

    for corners in [[0, 1, 2, 3], [1, 2, 3, 0], [2, 3, 0, 1], [3, 0, 1, 2]] {
        let tetrahedron_vertex = |height: f64| {
            let mut tetrahedron = [[0.0; 3]; 4];
            let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            for (corner, point) in corners.into_iter().zip(points) {
                tetrahedron[corner] = point;
            }
            let [v] = p([[0.25, 0.25, height]]);
            space::tetrahedron_vertex(t, &p(tetrahedron), &v).is_some()
        };
        assert_eq!(passes(t.rho, tetrahedron_vertex), BEYOND, "ρ, {corners:?}");
    }
}

#[test]
fn each_step_turns_at_its_tolerance_in_double_precision() {
    check_plane::<f64>();
    check_space::<f64>();
}

#[test]
fn each_step_turns_at_its_tolerance_in_single_precision() {
    check_plane::<f32>();
    check_space::<f32>();
}

#[test]
fn tolerances_are_those_of_the_format() {
    // 2⁻²³ and its roots, not those of a double.
    let plane = Tolerances2d::<f32>::from_length(1.0);
    assert_eq!(plane.kappa.width, 21.0 * 2.0_f64.powi(-23));
    assert!((plane.sigma.lower - 6.0 * 2.0_f64.powi(-23).sqrt()).abs() < 1e-15);
    let space = Tolerances3d::<f32>::from_length(1.0);
    assert_eq!(space.lambda.width, 1215.0 * 2.0_f64.powi(-23));
    assert!(
        (space.xi.width - 56.0 * 2.0_f64.powi(-23).powf(0.75)).abs() < 4.0 * f64::from(f32::EPSILON) * space.xi.width
    );
}

/// Feet on and beside the ends of an edge, on its line: the weight is the fraction of the way; beyond an end there is
/// no contact.
#[test]
fn feet_on_edges_have_their_weights_and_none_beyond_an_end() {
    let (flat, deep) = (Tolerances2d::<f64>::from_length(1.0), Tolerances3d::<f64>::from_length(1.0));
    for eighths in -2..=6 {
        let x = f64::from(eighths) / 8.0;
        let expected = (0..=4).contains(&eighths).then_some(x / 0.5);
        for turn in 0..2 {
            let turned = |[x, y]: [f64; 2]| if turn == 0 { [x, y] } else { [y, x] };
            let edge = [[0.0, 0.0], [0.5, 0.0]].map(turned);
            assert_eq!(plane::edge_vertex(&flat, &edge, &turned([x, 0.0])), expected, "{x}");
        }
        for axis in 0..3 {
            let along = |x: f64| [0, 1, 2].map(|at: usize| if at == axis { x } else { 0.0 });
            assert_eq!(space::edge_vertex(&deep, &[along(0.0), along(0.5)], &along(x)), expected, "{x}");
        }
    }
}

/// Two edges that cross, and edges where one ends before the other's line.
#[test]
fn crossings_of_edges_have_their_weights_and_none_beyond_an_end() {
    let (flat, deep) = (Tolerances2d::<f64>::from_length(1.0), Tolerances3d::<f64>::from_length(1.0));
    for (i, j) in (-2..=6).flat_map(|i| (-2..=6).map(move |j| (i, j))) {
        // Edges of half a unit that start this far before the crossing of their lines. At an end nothing is beyond κ or
        // φ.
        let [s, t] = [i, j].map(|eighths| f64::from(eighths) / 8.0);
        let is_contact = (1..4).contains(&i) && (1..4).contains(&j);
        let expected = is_contact.then_some([s / 0.5, t / 0.5]);
        let (first, second) = ([[-s, 0.0], [0.5 - s, 0.0]], [[0.0, -t], [0.0, 0.5 - t]]);
        assert_eq!(plane::edge_edge(&flat, &first, &second), expected, "{s} {t}");
        for turn in 0..3 {
            let lifted = |[x, y]: [f64; 2]| {
                let mut point = [x, y, 0.25];
                point.rotate_right(turn);
                point
            };
            assert_eq!(space::edge_edge(&deep, &first.map(lifted), &second.map(lifted)), expected, "{s} {t}");
        }
    }
}

/// Points of simplices have their barycentric weights; beyond a side, and on one, there is no contact.
#[test]
fn points_in_simplices_have_their_weights_and_none_beyond_a_side() {
    let (flat, deep) = (Tolerances2d::<f64>::from_length(1.0), Tolerances3d::<f64>::from_length(1.0));
    let triangle = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]];
    for (i, j) in (-1..=5).flat_map(|i| (-1..=5).map(move |j| (i, j))) {
        let [x, y] = [i, j].map(|eighths| f64::from(eighths) / 8.0);
        let weights = [1.0 - (x + y) / 0.5, x / 0.5, y / 0.5];
        for (turn, (triangle, weights)) in (0..3).map(|turn| {
            let (mut triangle, mut weights) = (triangle, weights);
            triangle.rotate_left(turn);
            weights.rotate_left(turn);
            (turn, (triangle, weights))
        }) {
            let expected = weights.iter().all(|&weight| weight > 0.0).then_some(weights);
            assert_eq!(plane::triangle_vertex(&flat, &triangle, &[x, y]), expected, "{x} {y}, turn {turn}");
            for axis in 0..3 {
                let lifted = |[x, y]: [f64; 2]| {
                    let mut point = [x, y, 0.0];
                    point.rotate_right(axis);
                    point
                };
                let deep_triangle = triangle.map(lifted);
                assert_eq!(space::triangle_vertex(&deep, &deep_triangle, &lifted([x, y])), expected, "{x} {y}");
                // An edge through that point, from 1/8 below the plane to 3/8 above; and one that ends before it.
                let at = |height: f64| {
                    let mut point = [x, y, height];
                    point.rotate_right(axis);
                    point
                };
                let through = space::triangle_edge(&deep, &deep_triangle, &[at(-0.125), at(0.375)]);
                assert_eq!(through, expected.map(|weights| (weights, 0.25)), "{x} {y}");
                assert_eq!(space::triangle_edge(&deep, &deep_triangle, &[at(0.125), at(0.375)]), None);
            }
        }
    }
    let tetrahedron = [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]];
    let mut inside = 0;
    for (i, j, k) in (-1..=5).flat_map(|i| (-1..=5).flat_map(move |j| (-1..=5).map(move |k| (i, j, k)))) {
        let [x, y, z] = [i, j, k].map(|eighths| f64::from(eighths) / 8.0);
        let weights = [1.0 - (x + y + z) / 0.5, x / 0.5, y / 0.5, z / 0.5];
        let expected = weights.iter().all(|&weight| weight > 0.0).then_some(weights);
        for swap in 0..4 {
            let (mut corners, mut expected) = (tetrahedron, expected);
            corners.swap(0, swap);
            if let Some(weights) = &mut expected {
                weights.swap(0, swap);
            }
            assert_eq!(space::tetrahedron_vertex(&deep, &corners, &[x, y, z]), expected, "{x} {y} {z}");
        }
        inside += usize::from(expected.is_some());
    }
    assert_eq!(inside, 1, "(1/8, 1/8, 1/8) alone has four weights above zero");
}
