//! Shared code of both engines of the crate: orientations in the tool's convention, and a base for circles and spheres.
//!
//! `orient_3d` is the opposite of ours. Circles and spheres return a side, not the sign of a determinant, and require a
//! base (three points, or four) that is positive by the crate's own orientation; the crate panics if the base is flat.
//! So the query point is the last point whose removal leaves a base that is not flat. The base is reversed if
//! necessary, and the orientation turns the side into the determinant's sign. The measured time includes these
//! orientation tests.
//!
//! If every base is flat, the answer is zero: the determinant is zero however the lift is perturbed. The answer is also
//! zero if a vertex occurs twice.

use geogram_predicates::Sign;
use predicament_engine::{Answer, Vertex, by_id};

/// The crate's sign as an answer.
pub fn ours(sign: Sign) -> Answer {
    match sign {
        Sign::Negative => Answer::Negative,
        Sign::Zero => Answer::Zero,
        Sign::Positive => Answer::Positive,
    }
}

/// The turn of three points.
pub fn orient2d([a, b, c]: [Vertex<2>; 3]) -> Answer {
    ours(geogram_predicates::orient_2d(&a.at, &b.at, &c.at))
}

/// The side of the fourth of four points.
pub fn orient3d([a, b, c, d]: [Vertex<3>; 4]) -> Answer {
    -ours(geogram_predicates::orient_3d(&a.at, &b.at, &c.at, &d.at))
}

/// The sign of the circle's determinant, by the side of the last point.
pub fn incircle(points: [Vertex<2>; 4], side: impl Fn([Vertex<2>; 4]) -> Sign) -> Answer {
    by_a_base(points, |[a, b, c, d]| match orient2d([a, b, c]) {
        Answer::Positive => Some(ours(side([a, b, c, d]))),
        Answer::Negative => Some(-ours(side([b, a, c, d]))),
        _ => None,
    })
}

/// The sign of the sphere's determinant, by the side of the last point.
pub fn insphere(points: [Vertex<3>; 5], side: impl Fn([Vertex<3>; 5]) -> Sign) -> Answer {
    by_a_base(points, |[a, b, c, d, e]| match orient3d([a, b, c, d]) {
        Answer::Positive => Some(ours(side([b, a, c, d, e]))),
        Answer::Negative => Some(-ours(side([a, b, c, d, e]))),
        _ => None,
    })
}

/// The answer for the last point, or for an earlier point if the base without the last point is flat.
fn by_a_base<const D: usize, const N: usize>(
    mut points: [Vertex<D>; N],
    ask: impl Fn([Vertex<D>; N]) -> Option<Answer>,
) -> Answer {
    if by_id(points).is_none() {
        return Answer::Zero;
    }
    let mut odd = false;
    for query in (0..N).rev() {
        if let Some(sign) = ask(points) {
            return if odd { -sign } else { sign };
        }
        if query > 0 {
            points.swap(query - 1, N - 1);
            odd = !odd;
        }
    }
    Answer::Zero
}
