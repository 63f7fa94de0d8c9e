//! Contacts between two complexes: the pairs of simplices that meet, the most degenerate first.
//!
//! Wang, Jiang, Schroeder and Teran register degeneracies in a hierarchy. Vertices with vertices come first, then
//! vertices with edges, and so on to the pairs whose dimensions add up to that of the space. A sub-pair of a pair is a
//! face of the one with a face of the other. If a sub-pair is registered, the pair has ended and is not queried:
//! simplices that meet in a common vertex do not meet again in an edge. So each query may assume that there is no more
//! degenerate contact. This makes floating point safe.
//!
//! The driver is the same for all kinds of backends. With exact signs it sorts the common points of two closed
//! complexes by their carriers. With perturbed signs only pairs of the last level can register. With tolerances it is
//! the paper's scheme.

mod ended;
mod near;

use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Dimension, Predicates};

pub use crate::answer::{Contact, Contacts, Level, Weights, ask, levels};
use ended::Ended;
use near::Near;

use predicament_grid::parallel;

/// The contacts of two complexes of the session's scene.
///
/// The pairs whose boxes are within the session's [reach](Predicates::reach) are queried, unless they have ended. The
/// complexes may share vertices; a vertex meets itself, however the session treats ties.
///
/// The answer doesn't depend on the number of threads, nor, up to the exchange of the two sides, on which complex comes
/// first.
///
/// # Panics
/// If the session doesn't [support](Predicates::supports_contacts) contacts, or `b` has 2^29 maximal simplices or more.
#[must_use]
pub fn contacts<S: Predicates + ?Sized>(session: &S, a: &Complex, b: &Complex) -> Contacts {
    if let Err(declined) = session.supports_contacts() {
        panic!("the session must support contacts: {declined}");
    }
    match session.scene().dimension() {
        Dimension::Two => hierarchy::<S, 2>(session, [a, b]),
        Dimension::Three => hierarchy::<S, 3>(session, [a, b]),
    }
}

/// The contacts of two complexes in the plane; see [`contacts`].
///
/// # Panics
/// Like [`contacts`], and if the scene is in space.
#[must_use]
pub fn contacts2d<S: Predicates + ?Sized>(session: &S, a: &Complex, b: &Complex) -> Contacts {
    assert_eq!(session.scene().dimension(), Dimension::Two, "contacts2d needs a 2D scene; contacts3d takes this one");
    contacts(session, a, b)
}

/// The contacts of two complexes in space; see [`contacts`].
///
/// # Panics
/// Like [`contacts`], and if the scene is in the plane.
#[must_use]
pub fn contacts3d<S: Predicates + ?Sized>(session: &S, a: &Complex, b: &Complex) -> Contacts {
    assert_eq!(session.scene().dimension(), Dimension::Three, "contacts3d needs a 3D scene; contacts2d takes this one");
    contacts(session, a, b)
}

fn hierarchy<S: Predicates + ?Sized, const D: usize>(session: &S, complexes: [&Complex; 2]) -> Contacts {
    let near = Near::<D>::new(session.scene(), complexes, session.reach(), session.allows("near-search"));
    let mut all = Contacts::default();
    let mut ended = Ended::default();
    let levels = levels(session.scene().dimension());
    for (level, pairs) in levels.iter().enumerate() {
        // A level's pairs come by the rank of the first simplex, so appending keeps the order.
        let start = all.registered.len();
        for &ranks in *pairs {
            all.levels.push(of_ranks(session, complexes, ranks, &near, &ended, &mut all.registered));
        }
        let is_last = level + 1 == levels.len();
        if all.registered.len() > start && !is_last {
            ended.learn(complexes, &all.registered);
        }
    }
    all
}

/// Appends the pairs of two ranks in ascending order.
fn of_ranks<S: Predicates + ?Sized, const D: usize>(
    session: &S,
    [a, b]: [&Complex; 2],
    ranks: [u8; 2],
    near: &Near<D>,
    ended: &Ended,
    all: &mut Vec<Contact>,
) -> Level {
    let none = Level { ranks, candidates: 0, ended: 0, asked: 0, registered: 0 };
    let piece = |piece: usize| {
        let (mut level, mut registered) = (none, Vec::new());
        let mut partners = Vec::new();
        near.each(piece, ranks, &mut |of_one| {
            level.candidates += of_one.len() as u64;
            let s = Simplex { rank: ranks[0], index: of_one[0][0] };
            ended.partners(s, &mut partners);
            for &[_, index] in of_one {
                let t = Simplex { rank: ranks[1], index };
                if ended.has_face(&partners, t) {
                    level.ended += 1;
                    continue;
                }
                level.asked += 1;
                registered.extend(ask(session, [a, b], [s, t]));
            }
        });
        level.registered = registered.len() as u64;
        (level, registered)
    };
    let pieces: Vec<(Level, Vec<Contact>)> = parallel::each(near.pieces(), &piece);
    let mut sum = none;
    let start = all.len();
    all.reserve(pieces.iter().map(|(_, registered)| registered.len()).sum());
    for (level, registered) in pieces {
        sum.candidates += level.candidates;
        sum.ended += level.ended;
        sum.asked += level.asked;
        sum.registered += level.registered;
        all.extend(registered);
    }
    // Simplices come by the maximal simplices that own them; if all of these have one rank, they are already sorted.
    all[start..].sort_unstable_by_key(|contact| (contact.a, contact.b));
    sum
}
