//! What must be true of all contacts together, checked by name.
//!
//! In the plane, closed curves cross an even number of times once they are
//! merged where they are in contact, wherever merged points sit. In space, the
//! intersection curves of closed surfaces have no loose ends, and a closed
//! curve pierces a closed surface as often inwards as outwards. What is not
//! closed is not checked: there is no law about it.

use crate::algorithm::arrangement::{Arrangement, Seat, Side};
use crate::algorithm::pairs::Contacts;
use crate::checks::pairs::{crossings, loose_ends, piercings};
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Predicates};

/// A violated law: the name of its check, and what is wrong in words.
pub(crate) type Violation = (&'static str, String);

/// The laws that the contacts violate. `sides` decides on which side of a
/// triangle an edge's end is: exact signs, or the perturbed ones where these
/// made the contacts.
pub(crate) fn violations<S: Predicates>(sides: &S, complexes: [&Complex; 2], contacts: &Contacts) -> Vec<Violation> {
    if contacts.registered.is_empty() {
        return Vec::new();
    }
    let arrangement = Arrangement::new(sides.scene(), complexes, contacts);
    match sides.scene().dimension() {
        Dimension::Two => {
            let count = |seat| crossings(sides.scene(), complexes, contacts, &arrangement, seat).ok();
            let counts = Seat::ALL.into_iter().filter_map(|seat| Some((seat, count(seat)?)));
            let odd = counts.filter(|(_, crossings)| crossings.is_odd());
            odd.map(|(seat, crossings)| {
                let (count, edges) = (crossings.count(), crossings.of_edges);
                let text = format!("closed curves cross {count} times, {edges} of them edges, merged points at {seat}");
                ("crossing parity", text)
            })
            .collect()
        }
        Dimension::Three => {
            let ends = loose_ends(complexes, contacts, &arrangement).ok();
            let loose = ends.filter(|ends| !ends.loose.is_empty()).map(|ends| {
                let (loose, pieces) = (ends.loose.len(), ends.pieces);
                ("loose ends", format!("{loose} loose ends of intersection curves with {pieces} pieces"))
            });
            let pierced = Side::BOTH.into_iter().filter_map(|side| piercings(sides, complexes, side, contacts).ok());
            let uneven = pierced.flatten().filter(|(_, piercings)| piercings.is_violated()).map(|(_, piercings)| {
                let (forward, backward) = (piercings.forward, piercings.backward);
                (
                    "signed piercings",
                    format!("a closed curve pierces a closed surface {forward} times one way, {backward} the other"),
                )
            });
            loose.into_iter().chain(uneven).collect()
        }
    }
}
