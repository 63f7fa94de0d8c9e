//! Other crates by name, with the feature `peers`: Simulation of Simplicity, and signs that claim to be certified.

use predicament_controls::wild::{Axiolid, Delaunay, Geogram, Hyperlimit, Rgeometry, Simplicity, Wild};
use predicament_predicates::{Question, Scene, Sign, Vertex};

use predicament_judge as judge;

use crate::roster::{Visit, hand};

/// Hands over the crate with this name, one of [`WILD`](crate::roster::WILD).
pub(crate) fn visit<V: Visit>(name: &str, visitor: V) -> V::Out {
    match name {
        "simplicity" => hand(visitor, Wild(Simplicity), None),
        "geogram" => hand(visitor, Wild(Geogram), Some(Box::new(by_lifts))),
        "delaunay" => hand(visitor, Wild(Delaunay { sorted: false }), None),
        "delaunay:sorted" => hand(visitor, Wild(Delaunay { sorted: true }), None),
        "rgeometry" => hand(visitor, Wild(Rgeometry), None),
        "axiolid" => hand(visitor, Wild(Axiolid), None),
        "hyperlimit" => hand(visitor, Wild(Hyperlimit), None),
        other => unreachable!("{other} is no crate of the list"),
    }
}

/// How geogram breaks ties, by the signs of minors: each vertex' lift is lowered by an
/// infinitesimal of its own, the larger the smaller its index. Points on one line, or
/// in one plane, stay degenerate however they are lifted.
fn by_lifts(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let exact = judge::sign(scene, question, args);
    let (base, column) = match question {
        Question::Incircle => (Question::Orient2d(predicament_predicates::Plane::Xy), 2),
        Question::Insphere => (Question::Orient3d, 3),
        _ => return exact,
    };
    let mut rows: Vec<usize> = (0..args.len()).collect();
    rows.sort_by_key(|&row| args[row]);
    let repeated = rows.windows(2).any(|pair| args[pair[0]] == args[pair[1]]);
    let cofactors = rows.into_iter().filter(|_| !repeated).map(|row| {
        let others = [&args[..row], &args[row + 1..]].concat();
        let minor = judge::sign(scene, base, &others);
        // The derivative by the row's lift, which is lowered.
        if (row + column) % 2 == 0 { -minor } else { minor }
    });
    std::iter::once(exact).chain(cofactors).find(|sign| !sign.is_zero()).unwrap_or(Sign::Zero)
}
