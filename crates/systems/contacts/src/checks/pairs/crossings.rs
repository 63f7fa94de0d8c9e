//! The number of crossings of two closed curves of the plane after merging.

use std::collections::{BTreeMap, BTreeSet};

use crate::answer::Contacts;
use crate::answer::{Arrangement, Seat, Side};
use predicament_judge::boxes::Boxes;
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Scene};

use super::NotOriented;
use super::orient::degrees;
use super::seated::Seated;

/// Two edges, by their indices in the complexes, for which the number of crossings of their merged pieces, away from
/// merged points, is not the registered number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Unfaithful {
    /// The edges.
    pub edges: [u32; 2],
    /// The number of registered crossings of the two: 0 or 1.
    pub registered: usize,
    /// The number of actual crossings.
    pub found: usize,
}

/// The crossings of two merged curves.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Crossings {
    /// The number of registered crossings of two edges.
    pub of_edges: usize,
    /// The number of registered crossings of two edges that also pass through a common merged point: that point is the
    /// crossing.
    pub absorbed: usize,
    /// The number of crossings at and along the shared parts of the curves. Its parity is that of the number of places
    /// where the second curve changes sides of the first; one place can count more than once.
    pub at_points: usize,
    /// The pairs of edges where the merged curves contradict the registrations.
    pub unfaithful: Vec<Unfaithful>,
}

impl Crossings {
    /// The number of crossings that the registrations account for.
    #[must_use]
    pub fn count(&self) -> usize {
        self.of_edges + self.at_points
    }

    /// True if the number of crossings is odd: impossible for two closed curves.
    #[must_use]
    pub fn is_odd(&self) -> bool {
        !self.count().is_multiple_of(2)
    }
}

/// Counts the crossings of two closed curves of the plane after merging, as [the module](super) defines them.
///
/// A curve is closed if each vertex has an even number of edges; it need not be connected or simple. Triangles are
/// ignored.
///
/// # Errors
/// [`NotOriented::Open`] if a curve is not closed.
///
/// # Panics
/// If the scene is not that of the contacts or not 2D, or the arrangement does not belong to the contacts.
pub fn crossings(
    scene: &Scene,
    complexes: [&Complex; 2],
    contacts: &Contacts,
    arrangement: &Arrangement,
    seat: Seat,
) -> Result<Crossings, NotOriented> {
    assert_eq!(scene.dimension(), Dimension::Two, "curves of the plane");
    for (side, complex) in Side::BOTH.into_iter().zip(complexes) {
        let open = |&(_, degree): &(_, usize)| !degree.is_multiple_of(2);
        if let Some((vertex, degree)) = degrees(complex).into_iter().find(open) {
            return Err(NotOriented::Open { side, vertex, degree });
        }
    }
    let registered: BTreeSet<[u32; 2]> = contacts
        .registered
        .iter()
        .filter(|contact| contact.a.rank == 1 && contact.b.rank == 1)
        .map(|contact| [contact.a.index, contact.b.index])
        .collect();

    let seated = Seated::new(scene, complexes, arrangement, seat);
    let [of_a, of_b] = Side::BOTH.map(|side| pieces(arrangement, side, complexes[side as usize]));
    let names = names(&seated, arrangement.points().len(), of_a.iter().chain(&of_b).map(|&(_, piece)| piece));
    let meet =
        |piece: [usize; 2], other: [usize; 2]| piece.iter().any(|&p| other.iter().any(|&q| names[p] == names[q]));
    let bends = |side, edge| bends(arrangement, side, edge);
    let (absorbed, registered): (BTreeSet<[u32; 2]>, BTreeSet<[u32; 2]>) = registered
        .into_iter()
        .partition(|&[e, f]| bends(Side::A, e).any(|p| bends(Side::B, f).any(|q| names[p] == names[q])));

    let mut elsewhere: BTreeMap<[u32; 2], usize> = registered.iter().map(|&edges| (edges, 0)).collect();
    let mut crossings = Crossings { of_edges: registered.len(), absorbed: absorbed.len(), ..Crossings::default() };
    let index = Boxes::new(of_b.iter().map(|&(_, other)| seated.bounds(other)).collect());
    let mut near = Vec::new();
    for &(e, piece) in &of_a {
        index.near(&seated.bounds(piece), 0.0, &mut near);
        for &(f, other) in near.iter().map(|&at| &of_b[at as usize]) {
            if !seated.crosses(piece, other) {
                continue;
            }
            if meet(piece, other) {
                crossings.at_points += 1;
            } else {
                *elsewhere.entry([e, f]).or_default() += 1;
            }
        }
    }
    crossings.unfaithful = elsewhere
        .into_iter()
        .map(|(edges, found)| Unfaithful { edges, registered: usize::from(registered.contains(&edges)), found })
        .filter(|pair| pair.registered != pair.found)
        .collect();
    Ok(crossings)
}

/// The points where an edge's path can bend: points with vertices.
fn bends(arrangement: &Arrangement, side: Side, edge: u32) -> impl Iterator<Item = usize> {
    arrangement.path(side, edge).iter().copied().filter(|&at| !arrangement.points()[at].is_new())
}

/// The straight pieces of all paths, with their edges. If a path stays at one point, there is no piece.
fn pieces(arrangement: &Arrangement, side: Side, complex: &Complex) -> Vec<(u32, [usize; 2])> {
    let mut pieces = Vec::new();
    for (edge, _) in (0_u32..).zip(complex.edges()) {
        let bends: Vec<usize> = bends(arrangement, side, edge).collect();
        let straight = bends.windows(2).filter(|ends| ends[0] != ends[1]);
        pieces.extend(straight.map(|ends| (edge, [ends[0], ends[1]])));
    }
    pieces
}

/// A name for each point; points that are joined by pieces without length have one name. Such a piece is an edge
/// without length, or joins vertices in one place on an edge.
fn names(seated: &Seated, points: usize, pieces: impl Iterator<Item = [usize; 2]>) -> Vec<usize> {
    let mut names: Vec<usize> = (0..points).collect();
    for [p, q] in pieces.filter(|&ends| seated.coincide(ends)) {
        let [from, to] = [names[q], names[p]];
        names.iter_mut().filter(|name| **name == from).for_each(|name| *name = to);
    }
    names
}
