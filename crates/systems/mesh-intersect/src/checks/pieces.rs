//! Checks of all pieces: each region is closed, pieces cover their triangles once and are on their sides, and results
//! consist of them.

use std::collections::BTreeMap;

use crate::answer::Source;
use predicament_mesh::OUTSIDE;
use predicament_overlay::answer::Operation;
use predicament_predicates::Vertex;
use predicament_slice::checks::{Expected, Part, Piece, Slices};

use super::{Laws, Violations, name, note};

impl Laws<'_> {
    /// Checks that the boundary of each region of the overlay is closed: it passes each edge equally often in both
    /// directions.
    pub fn closed(&self, found: &mut Violations) {
        let mut uses: BTreeMap<(u32, [Vertex; 2]), i64> = BTreeMap::new();
        for (&[a, b, c], &[front, behind]) in self.regions.triangles.iter().zip(&self.regions.sides) {
            if front == behind {
                continue;
            }
            for [a, b] in [[a, b], [b, c], [c, a]] {
                let way = if a < b { 1 } else { -1 };
                *uses.entry((front, [a.min(b), a.max(b)])).or_default() -= way;
                *uses.entry((behind, [a.min(b), a.max(b)])).or_default() += way;
            }
        }
        let open: Vec<_> = uses.into_iter().filter(|(_, uses)| *uses != 0).collect();
        if let Some(((region, [a, b]), _)) = open.first() {
            let pair = self.regions.pairs[*region as usize];
            let got = format!(
                "{} times, first: at the edge of {a} and {b} the region of {} and {} is open",
                open.len(),
                pair[0],
                pair[1]
            );
            note(found, "region not closed", got, "the boundary of each region is closed");
        }
    }

    /// Checks that each piece has the regions of its triangle on its sides, and one region of the other mesh on both.
    pub fn sides(&self, found: &mut Violations) {
        let regions = self.regions;
        let wrong = regions.sources.iter().zip(&regions.sides).filter(|(source, sides)| {
            let (own, other) = (usize::from(source.mesh), 1 - usize::from(source.mesh));
            let pairs = sides.map(|side| regions.pairs[side as usize]);
            let of = self.meshes[own].sides()[source.triangle as usize];
            pairs.map(|pair| pair[own]) != of || pairs[0][other] != pairs[1][other]
        });
        let wrong: Vec<_> = wrong.collect();
        if let Some((source, _)) = wrong.first() {
            let got = format!("{} times, first: a piece of {}", wrong.len(), name(**source));
            note(
                found,
                "sides of a piece",
                got,
                "a piece separates the regions of its triangle, inside one region of the other mesh",
            );
        }
    }

    /// Checks that the surface of an operation consists of the pieces with the inside of its result on one side,
    /// oriented with the inside behind them.
    pub fn operations(&self, found: &mut Violations) {
        let regions = self.regions;
        // A triangle from its smallest corner on: this form is unique for an orientation.
        let from_smallest = |[a, b, c]: [Vertex; 3]| {
            let least = a.min(b).min(c);
            if least == a {
                [a, b, c]
            } else if least == b {
                [b, c, a]
            } else {
                [c, a, b]
            }
        };
        for (operation, solid) in Operation::ALL.into_iter().zip(self.solids) {
            let surface = regions.triangles.iter().zip(&regions.sides).filter_map(|(&[a, b, c], sides)| {
                let inside = |side: u32| operation.holds(regions.pairs[side as usize].map(|region| region != OUTSIDE));
                match sides.map(inside) {
                    [false, true] => Some(from_smallest([a, b, c])),
                    [true, false] => Some(from_smallest([a, c, b])),
                    _ => None,
                }
            });
            let mut wanted: Vec<[Vertex; 3]> = surface.collect();
            let mut got: Vec<[Vertex; 3]> = solid.iter().map(|&triangle| from_smallest(triangle)).collect();
            wanted.sort_unstable();
            got.sort_unstable();
            if wanted != got {
                let got = format!(
                    "{}: {} triangles, but {} pieces are its surface",
                    operation.name(),
                    got.len(),
                    wanted.len()
                );
                note(
                    found,
                    "operation",
                    got,
                    "the surface of a result consists of the pieces between its inside and its outside",
                );
            }
        }
    }

    /// Checks that pieces are in the planes of their triangles and cover them, and that none passes through another
    /// one.
    pub fn pieces(&self, expected: Expected, found: &mut Violations) {
        let regions = self.regions;
        let number = |place: usize| u32::try_from(place).expect("fewer than 2^32 vertices");
        let triangles = |mesh: usize| self.meshes[mesh].triangles();
        let faces = (0..2).flat_map(triangles).map(|t| t.map(|v| number(v.index())).to_vec()).collect();
        let place = |source: &Source| match source.mesh {
            0 => Piece::Face(source.triangle as usize),
            _ => Piece::Face(triangles(0).len() + source.triangle as usize),
        };
        let part = Part {
            triangles: regions.triangles.iter().map(|t| t.map(|v| number(self.place(v)))).collect(),
            pieces: regions.sources.iter().map(place).collect(),
            open: Vec::new(),
        };
        let slices = Slices { points: self.points.clone(), faces, planes: Vec::new(), parts: vec![part] };
        for flaw in slices.flaws_of_pieces(expected) {
            note(found, flaw.check.name(), format!("{} times, first: {}", flaw.count, flaw.what), flaw.check.law());
        }
    }
}
