//! Checks of all pieces: each region is closed, pieces cover their triangles once and are on their sides, and results
//! consist of them.

use std::collections::BTreeMap;

use crate::answer::Source;
use predicament_mesh::OUTSIDE;
use predicament_overlay::answer::Operation;
use predicament_predicates::Vertex;
use predicament_slice::checks::{Expected, Part, Piece, Slices};
use rug::Rational;

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

    /// Checks that each piece has the regions of its triangle on its sides, and one region of the other mesh on both,
    /// or those of the other mesh's triangle that it is also a part of, seen from the same side.
    pub fn sides(&self, found: &mut Violations) {
        let regions = self.regions;
        let alone = regions.triangles.len().saturating_sub(regions.also.len());
        let also = std::iter::repeat_n(None, alone).chain(regions.also.iter().copied().map(Some));
        let is_wrong = |(source, sides, also): (&Source, &[u32; 2], Option<u32>)| {
            let (own, other) = (usize::from(source.mesh), 1 - usize::from(source.mesh));
            let pairs = sides.map(|side| regions.pairs[side as usize]);
            let of = self.meshes[own].sides()[source.triangle as usize];
            let others = pairs.map(|pair| pair[other]);
            let is_right = match also {
                None => others[0] == others[1],
                Some(also) => {
                    let mut of = self.meshes[other].sides()[also as usize];
                    let [first, second] = [(own, source.triangle), (other, also)]
                        .map(|(mesh, at)| self.normal(self.meshes[mesh].triangles()[at as usize]));
                    let along: Rational = first.iter().zip(&second).map(|(a, b)| Rational::from(a * b)).sum();
                    if along < 0 {
                        of.reverse();
                    }
                    others == of
                }
            };
            (pairs.map(|pair| pair[own]) != of || !is_right).then_some(*source)
        };
        let all = regions.sources.iter().zip(&regions.sides).zip(also);
        let wrong: Vec<Source> = all.filter_map(|((source, sides), also)| is_wrong((source, sides, also))).collect();
        if let Some(source) = wrong.first() {
            let got = format!("{} times, first: a piece of {}", wrong.len(), name(*source));
            note(
                found,
                "sides of a piece",
                got,
                "a piece separates the regions of its triangle, inside one region of the other mesh, or those of the \
                 other mesh's triangle that it is in as well",
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
        // A part of two triangles covers both.
        let alone = regions.triangles.len().saturating_sub(regions.also.len());
        let also = regions.also.iter().map(|&triangle| Source { mesh: 1, triangle });
        let of = regions.triangles.iter().zip(regions.sources.iter().copied());
        let of = of.chain(regions.triangles[alone..].iter().zip(also)).map(|(&t, source)| (t, source));
        let turned = |([a, b, c], source): ([Vertex; 3], Source)| {
            let own = self.normal(self.meshes[usize::from(source.mesh)].triangles()[source.triangle as usize]);
            let along: Rational = own.iter().zip(&self.normal([a, b, c])).map(|(a, b)| Rational::from(a * b)).sum();
            (if along < 0 { [a, c, b] } else { [a, b, c] }, source)
        };
        let (triangles, sources): (Vec<_>, Vec<_>) =
            of.enumerate().map(|(at, part)| if at < regions.triangles.len() { part } else { turned(part) }).unzip();
        let part = Part {
            triangles: triangles.iter().map(|&t| self.places(t)).collect(),
            pieces: sources.iter().map(place).collect(),
            open: Vec::new(),
        };
        let slices = Slices { points: self.points.clone(), faces, planes: Vec::new(), parts: vec![part] };
        for flaw in slices.flaws_of_pieces(expected) {
            note(found, flaw.check.name(), format!("{} times, first: {}", flaw.count, flaw.what), flaw.check.law());
        }
    }
}
