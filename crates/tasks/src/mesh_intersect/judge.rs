//! The overlay of two meshes against the laws that it satisfies, decided in rationals.
//!
//! Pieces of each triangle cover it once, no piece passes through another one, and each piece is in the region of the other mesh that its
//! middle is in, as the judge of points in meshes says: that is all there is to it. Besides, each region of the overlay is closed, and
//! volumes add up.

use std::collections::BTreeMap;

use predicament_algorithms::mesh_overlay::{Regions, Source};
use predicament_algorithms::overlay::Operation;
use predicament_checks::slice::{Expected, Part, Piece, Slices};
use predicament_judge::solids::{Materials, Place};
use predicament_judge::{Points, rational};
use predicament_mesh::OUTSIDE;
use predicament_predicates::{PredicateKind, Scene, Vertex, ZeroMeaning};
use rug::Rational;

use super::content::TwoMeshes;
use super::{MeshIntersect, Overlaid};
use crate::{Asked, Case, Class, Finding, Outcome, Stop};

/// Triangles held against their neighbours, at the two levels.
const CROSSED: [usize; 2] = [16, 2_000];
/// Triangles that middles of pieces are held against, all together, at the two levels.
const LOCATED: [usize; 2] = [2_000, 400_000];
/// Overlays of more triangles have no volumes added up, at the two levels.
const ADDED_UP: [usize; 2] = [1_500, 40_000];

type Point = [Rational; 3];

/// What is sampled.
pub(super) fn sampled(content: &TwoMeshes) -> Option<String> {
    (content.triangles() > CROSSED[0])
        .then(|| "pieces cover all triangles, and regions are closed; regions and crossings: an even sample".to_owned())
}

/// Judges an overlay.
pub(super) fn judge(
    case: &Case<'_, MeshIntersect>,
    asked: &Asked<'_>,
    answer: &Overlaid,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    if let Some(rule) = answer.broken {
        note(outcome, rule, "violated".to_owned(), rule);
        return Ok(());
    }
    let points = match points(case.scene(), answer) {
        Ok(points) => points,
        Err(v) => {
            note(outcome, "vertex not finite", format!("{v} has no finite coordinates"), "every vertex is a point");
            return Ok(());
        }
    };
    let level = usize::from(asked.budget.thorough);
    let laws = Laws { scene: case.scene(), content: case.content, answer, points };
    asked.watch.done(0)?;
    laws.closed(outcome);
    laws.sides(outcome);
    laws.operations(outcome);
    asked.watch.done(0)?;
    let has_areas = asked.contract(PredicateKind::Orient3d).zero != ZeroMeaning::Never;
    laws.pieces(Expected { is_closed: false, has_areas, triangles_crossed: CROSSED[level] }, outcome);
    asked.watch.done(0)?;
    laws.located(LOCATED[level], outcome);
    asked.watch.done(0)?;
    if laws.regions().triangles.len() <= ADDED_UP[level] {
        laws.volumes(outcome);
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    Ok(())
}

fn note(outcome: &mut Outcome, check: &str, got: String, law: &str) {
    outcome.counts.add(Class::Topology, 1);
    outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), got, law.to_owned()));
}

/// All points: those of the scene, then the constructed ones, as they are or as the session has rounded them.
fn points(scene: &Scene, answer: &Overlaid) -> Result<Vec<Point>, Vertex> {
    let mut all: Vec<Point> = scene.vertices().map(|v| scene.point3(v).map(rational)).collect();
    let vertex = |at: usize| Vertex::constructed(answer.before + at);
    if let Some(rounded) = &answer.rounded {
        for (at, point) in rounded.iter().enumerate() {
            if point.iter().any(|x| !x.is_finite()) {
                return Err(vertex(at));
            }
            all.push(point.map(rational));
        }
        return Ok(all);
    }
    let mut exact = Points::of(scene);
    let vertices = exact.construct(&answer.constructions).map_err(|why| vertex(why.index().unwrap_or(0)))?;
    for v in vertices {
        let point = exact.point(v).map(std::borrow::Cow::into_owned).ok_or(v)?;
        all.push(<Point>::try_from(point).map_err(|_| v)?);
    }
    Ok(all)
}

struct Laws<'a> {
    scene: &'a Scene,
    content: &'a TwoMeshes,
    answer: &'a Overlaid,
    points: Vec<Point>,
}

impl Laws<'_> {
    fn regions(&self) -> &Regions {
        &self.answer.regions
    }

    fn place(&self, v: Vertex) -> usize {
        v.construction().map_or(v.index(), |index| self.scene.len() + index - self.answer.before)
    }

    fn corners(&self, triangle: [Vertex; 3]) -> [&Point; 3] {
        triangle.map(|v| &self.points[self.place(v)])
    }

    /// The boundary of each region of the overlay is closed: it passes each edge as often one way as the other.
    fn closed(&self, outcome: &mut Outcome) {
        let mut uses: BTreeMap<(u32, [Vertex; 2]), i64> = BTreeMap::new();
        for (&[a, b, c], &[front, behind]) in self.regions().triangles.iter().zip(&self.regions().sides) {
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
            let pair = self.regions().pairs[*region as usize];
            let got = format!(
                "{} times, first: at the edge of {a} and {b} the region of {} and {} is open",
                open.len(),
                pair[0],
                pair[1]
            );
            note(outcome, "region not closed", got, "the boundary of each region is closed");
        }
    }

    /// Each piece has the regions of its triangle on its sides, and one region of the other mesh on both.
    fn sides(&self, outcome: &mut Outcome) {
        let regions = self.regions();
        let wrong = regions.sources.iter().zip(&regions.sides).filter(|(source, sides)| {
            let (own, other) = (usize::from(source.mesh), 1 - usize::from(source.mesh));
            let pairs = sides.map(|side| regions.pairs[side as usize]);
            let of = self.content.meshes[own].sides()[source.triangle as usize];
            pairs.map(|pair| pair[own]) != of || pairs[0][other] != pairs[1][other]
        });
        let wrong: Vec<_> = wrong.collect();
        if let Some((source, _)) = wrong.first() {
            let got = format!("{} times, first: a piece of {}", wrong.len(), name(**source));
            note(
                outcome,
                "sides of a piece",
                got,
                "a piece is between the regions of its triangle, in one of the other mesh",
            );
        }
    }

    /// The surface of an operation is the pieces with the inside of its result on one side, turned so that it is behind them.
    fn operations(&self, outcome: &mut Outcome) {
        let regions = self.regions();
        // A triangle from its smallest corner on: turned the same way, it is the same.
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
        for (operation, solid) in Operation::ALL.into_iter().zip(&self.answer.solids) {
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
                let got =
                    format!("{}: {} triangles, where {} are its surface", operation.name(), got.len(), wanted.len());
                note(outcome, "operation", got, "a result's surface is the pieces between its inside and its outside");
            }
        }
    }

    /// Pieces are in the planes of their triangles and cover them, and none passes through another one.
    fn pieces(&self, expected: Expected, outcome: &mut Outcome) {
        let regions = self.regions();
        let number = |place: usize| u32::try_from(place).expect("fewer than 2^32 vertices");
        let triangles = |mesh: usize| self.content.meshes[mesh].triangles();
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
            note(outcome, flaw.check.name(), format!("{} times, first: {}", flaw.count, flaw.what), flaw.check.law());
        }
    }

    /// The middle of each piece of a sample is in the region that the piece is said to be in; where it is on the other mesh, either
    /// side is right.
    fn located(&self, budget: usize, outcome: &mut Outcome) {
        let regions = self.regions();
        let mut wrong = 0;
        for mesh in 0..2 {
            let other = &self.content.meshes[1 - mesh];
            let materials = Materials::new(self.scene, other.triangles(), other.sides());
            let judge = materials.in_integers();
            let own: Vec<usize> =
                (0..regions.triangles.len()).filter(|&at| usize::from(regions.sources[at].mesh) == mesh).collect();
            let many = (budget / other.triangles().len()).clamp(4, own.len().max(4));
            for &at in own.iter().step_by(own.len().div_ceil(many).max(1)) {
                let corners = self.corners(regions.triangles[at]);
                let middle = [0, 1, 2].map(|axis: usize| {
                    let sum: Rational = corners.iter().map(|corner| &corner[axis]).sum();
                    sum / 3
                });
                let said = regions.pairs[regions.sides[at][0] as usize][1 - mesh];
                let place = DIRECTIONS.iter().find_map(|&direction| judge.winding(&middle, direction));
                let is_right = match &place {
                    // No ray of these misses all edges: nothing is known.
                    None | Some(Place::On(_)) => true,
                    Some(Place::In(region)) => *region == said,
                    Some(Place::Windings(_)) => true,
                };
                if !is_right {
                    wrong += 1;
                    if wrong == 1 {
                        let of = name(regions.sources[at]);
                        let got = format!(
                            "a piece of {of} is said to be in region {said} of the other mesh, and is in {place:?}"
                        );
                        note(outcome, "region of a piece", got, "a piece is in the region that its middle is in");
                    }
                }
            }
        }
    }

    /// The volume of a region of a mesh is that of all its parts.
    fn volumes(&self, outcome: &mut Outcome) {
        let six = |triangle: [Vertex; 3]| {
            let [a, b, c] = self.corners(triangle);
            let minor = |i: usize, j: usize| Rational::from(&b[i] * &c[j]) - Rational::from(&b[j] * &c[i]);
            Rational::from(&a[0] * &minor(1, 2))
                + Rational::from(&a[1] * &minor(2, 0))
                + Rational::from(&a[2] * &minor(0, 1))
        };
        for mesh in 0..2 {
            // Of a region: of its boundary as the overlay has it, less as the mesh has it, triangle by triangle.
            let mut missing: BTreeMap<(u32, Source), Rational> = BTreeMap::new();
            let regions = self.regions();
            for ((&triangle, sides), &source) in regions.triangles.iter().zip(&regions.sides).zip(&regions.sources) {
                let [front, behind] = sides.map(|side| regions.pairs[side as usize][mesh]);
                if front != behind {
                    let volume = six(triangle);
                    *missing.entry((behind, source)).or_default() += &volume;
                    *missing.entry((front, source)).or_default() -= &volume;
                }
            }
            let of = &self.content.meshes[mesh];
            for ((&triangle, &[front, behind]), at) in of.triangles().iter().zip(of.sides()).zip(0..) {
                if front != behind {
                    let source = Source { mesh: u8::from(mesh == 1), triangle: at };
                    let volume = six(triangle);
                    *missing.entry((behind, source)).or_default() -= &volume;
                    *missing.entry((front, source)).or_default() += &volume;
                }
            }
            let mut by_region: BTreeMap<u32, Rational> = BTreeMap::new();
            for ((region, _), volume) in missing.into_iter().filter(|(_, volume)| !volume.is_zero()) {
                *by_region.entry(region).or_default() += volume;
            }
            if let Some((region, volume)) = by_region.iter().find(|(_, volume)| !volume.is_zero()) {
                let name = ["first", "second"][mesh];
                let got = format!(
                    "parts of region {region} of the {name} mesh have {:e} more than it",
                    volume.to_f64() / 6.0
                );
                note(outcome, "volume", got, "the volumes of a region's parts add up to its volume");
            }
        }
    }
}

/// Directions of rays, one of which misses all edges.
const DIRECTIONS: [[i32; 3]; 4] = [[83, 31, 17], [-29, 71, 43], [13, -47, 97], [-61, -7, 89]];

fn name(source: Source) -> String {
    format!("triangle {} of the {} mesh", source.triangle, ["first", "second"][usize::from(source.mesh)])
}
