//! Laws of all contacts together, checked by name.
//!
//! In the plane, closed curves cross an even number of times after merging at their contacts, for any locations of
//! merged points. In space, the intersection curves of closed surfaces have no loose ends, and a closed curve pierces a
//! closed surface as often inwards as outwards. Complexes that are not closed are not checked, as there are no laws
//! about them.

use crate::algorithm::arrangement::{Arrangement, Seat, Side};
use crate::algorithm::pairs::Contacts;
use crate::checks::pairs::{crossings, loose_ends, piercings};
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Predicates};

/// A violated law: the name of its check, and a description.
pub(crate) type Violation = (&'static str, String);

/// The laws that the contacts violate. `sides` decides the side of a triangle that an edge's end is on: exact signs, or
/// the perturbed ones if these made the contacts.
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
                let text = format!(
                    "closed curves cross {count} times ({edges} crossings are edges), with merged points at {seat}"
                );
                ("crossing parity", text)
            })
            .collect()
        }
        Dimension::Three => {
            let ends = loose_ends(complexes, contacts, &arrangement).ok();
            let loose = ends.filter(|ends| !ends.loose.is_empty()).map(|ends| {
                let (loose, pieces) = (ends.loose.len(), ends.pieces);
                ("loose ends", format!("intersection curves have {loose} loose ends, in {pieces} pieces"))
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
