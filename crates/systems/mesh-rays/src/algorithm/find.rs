//! The features that one query hits, by signs of input vertices.
//!
//! A line p, q meets the plane of a triangle a, b, c in one point if the signs of `orient3d` of the line with the three
//! edges are not all zero. These signs say where: all equal, in the face; one zero and two equal, in an edge; two zero,
//! in a vertex; different, outside. If all are zero, the line is in the plane of the triangle, and `orient2d` in a
//! coordinate plane decides about each corner and edge.
//!
//! The place on the line is known by two signs, of t and of t − 1, where t is 0 at p and 1 at q.

use std::collections::{BTreeMap, BTreeSet};

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use crate::answer::{Extent, Feature, Hit, edge, edges};

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const PLANES: [Plane; 3] = [Plane::Yz, Plane::Zx, Plane::Xy];

/// The signs of t and of t − 1 at a place of the line.
pub(super) type At = [Sign; 2];

/// A line to be asked about.
pub(super) struct Asking<'s, P: ?Sized> {
    pub(super) session: &'s P,
    pub(super) ends: [Vertex; 2],
    pub(super) extent: Extent,
    /// Along each axis, the sign of the second point's coordinate minus the first one's.
    pub(super) ahead: [Sign; 3],
}

/// The way in which a feature was found: it orders the feature against others.
#[derive(Clone, Copy, Debug)]
pub(super) enum Cut {
    /// A vertex on the line.
    Vertex(Vertex),
    /// A triangle whose plane the line crosses there; the sign is that of t − t₀ for positive `orient3d`.
    Plane([Vertex; 3], Sign),
    /// An edge in one plane with the line, and in which projection their lines cross; the sign is that of t − t₀ for
    /// positive `orient2d`.
    Edge([Vertex; 2], Plane, Sign),
}

/// A point that the query has in common with the mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) feature: Feature,
    pub(super) at: At,
    pub(super) cut: Cut,
}

/// An interval that the query has in common with the mesh.
#[derive(Clone, Debug)]
pub(super) struct Interval {
    pub(super) feature: Feature,
    /// The features at its ends, with their places.
    pub(super) ends: Vec<(Feature, At)>,
}

/// All that a query has in common with a mesh.
#[derive(Clone, Default, Debug)]
pub(super) struct Found {
    pub(super) points: Vec<Point>,
    pub(super) intervals: Vec<Interval>,
    pub(super) crossings: Option<i64>,
}

impl Found {
    /// The hit of a point.
    pub(super) fn hit(point: &Point) -> Hit {
        Hit { feature: point.feature, is_along: false }
    }
}

impl<'s, P: Predicates + ?Sized> Asking<'s, P> {
    pub(super) fn new(session: &'s P, ends: [Vertex; 2], extent: Extent) -> Asking<'s, P> {
        let ahead = AXES.map(|axis| session.compare(axis, ends[1], ends[0]));
        Asking { session, ends, extent, ahead }
    }

    /// The order of two vertices along the line, constructed or not: negative if the first one comes first.
    pub(super) fn order(&self, u: Vertex, v: Vertex) -> Sign {
        let along = AXES.into_iter().zip(self.ahead).filter(|(_, ahead)| *ahead != Sign::Zero);
        let mut signs = along.map(|(axis, ahead)| self.session.compare(axis, u, v) * ahead);
        signs.find(|sign| *sign != Sign::Zero).unwrap_or(Sign::Zero)
    }

    fn turn(&self, plane: Plane, v: Vertex) -> Sign {
        self.session.orient2d(plane, self.ends[0], self.ends[1], v)
    }

    /// True if a place is in the part that counts.
    fn counts(&self, [from, to]: At) -> bool {
        !(self.extent.has_start() && from == Sign::Negative || self.extent.has_end() && to == Sign::Positive)
    }

    /// True if a place is an end of the query.
    fn is_end(&self, [from, to]: At) -> bool {
        self.extent.has_start() && from == Sign::Zero || self.extent.has_end() && to == Sign::Zero
    }

    /// Finds what the query has in common with these triangles.
    pub(super) fn find(&self, triangles: &[[Vertex; 3]], near: &[u32]) -> Found {
        let mut search =
            Search { asking: self, sides: BTreeMap::new(), known: BTreeSet::new(), found: Found::default() };
        let (mut sum, mut touches) = (0, false);
        for &at in near {
            let corners = triangles[at as usize];
            let sides = edges(corners).map(|edge| search.side(edge));
            if sides.contains(&Sign::Positive) && sides.contains(&Sign::Negative) {
                continue;
            }
            match sides.into_iter().find(|side| *side != Sign::Zero) {
                Some(side) => {
                    let place = self.across(corners, side);
                    touches |= self.is_end(place);
                    if self.counts(place) {
                        search.through(at, corners, sides, side, place);
                        sum += self.crossing(corners, sides);
                    }
                }
                None => touches |= search.within(at, corners),
            }
        }
        let mut found = search.found;
        found.crossings = (!touches).then_some(sum);
        found
    }

    /// The place at which the line crosses the plane of a triangle; `side` is the sign of the line with its edges.
    fn across(&self, [a, b, c]: [Vertex; 3], side: Sign) -> At {
        self.ends.map(|end| -(self.session.orient3d(a, b, c, end) * side))
    }

    /// 1 if the moved line leaves through the triangle, −1 if it enters, 0 if it misses the triangle.
    fn crossing(&self, corners: [Vertex; 3], mut sides: [Sign; 3]) -> i64 {
        for (side, edge) in sides.iter_mut().zip(edges(corners)) {
            if *side == Sign::Zero {
                *side = self.moved(edge);
            }
        }
        match sides {
            [Sign::Positive, Sign::Positive, Sign::Positive] => -1,
            [Sign::Negative, Sign::Negative, Sign::Negative] => 1,
            _ => 0,
        }
    }

    /// The side of an edge that the line meets, once the line has moved by (ε, ε², ε³): the first minor that is not
    /// zero, of the edge and the line. As the line meets the edge, the turns of the edge's ends show its sign.
    fn moved(&self, [u, v]: [Vertex; 2]) -> Sign {
        let minor = |plane| match self.turn(plane, u) {
            Sign::Zero => -self.turn(plane, v),
            turn => turn,
        };
        PLANES.into_iter().map(minor).find(|sign| *sign != Sign::Zero).unwrap_or(Sign::Zero)
    }

    /// True if a vertex is on the line.
    fn is_on(&self, v: Vertex) -> bool {
        PLANES.into_iter().all(|plane| self.turn(plane, v) == Sign::Zero)
    }

    /// The place of a vertex on the line.
    fn place(&self, v: Vertex) -> At {
        self.ends.map(|end| self.order(v, end))
    }

    /// The crossing of the line and an edge in one plane with it, neither end on the line.
    fn crossed(&self, [a, b]: [Vertex; 2]) -> Option<(At, Cut)> {
        PLANES.into_iter().find_map(|plane| {
            let ahead = self.turn(plane, a);
            if ahead == Sign::Zero || self.turn(plane, b) != -ahead {
                return None;
            }
            let place = self.ends.map(|end| -(self.session.orient2d(plane, a, b, end) * ahead));
            Some((place, Cut::Edge([a, b], plane, ahead)))
        })
    }
}

struct Search<'a, 's, P: ?Sized> {
    asking: &'a Asking<'s, P>,
    /// The sign of the line with each edge, the smaller id first.
    sides: BTreeMap<[Vertex; 2], Sign>,
    /// The vertices and edges that are known already.
    known: BTreeSet<Feature>,
    found: Found,
}

impl<P: Predicates + ?Sized> Search<'_, '_, P> {
    fn side(&mut self, [u, v]: [Vertex; 2]) -> Sign {
        let [p, q] = self.asking.ends;
        let session = self.asking.session;
        if v < u {
            return -*self.sides.entry([v, u]).or_insert_with(|| session.orient3d(p, q, v, u));
        }
        *self.sides.entry([u, v]).or_insert_with(|| session.orient3d(p, q, u, v))
    }

    /// Adds a point, if its feature is new.
    fn add(&mut self, feature: Feature, at: At, cut: Cut) {
        if self.asking.counts(at) && self.known.insert(feature) {
            self.found.points.push(Point { feature, at, cut });
        }
    }

    /// Adds the point in which the line crosses the plane of a triangle: of the face, an edge or a corner.
    fn through(&mut self, face: u32, corners: [Vertex; 3], sides: [Sign; 3], side: Sign, place: At) {
        let [a, b, c] = corners;
        let plane = Cut::Plane(corners, side);
        match sides.map(|side| side == Sign::Zero) {
            [false, false, false] => self.add(Feature::Face(face), place, plane),
            [true, false, false] => self.add(edge(a, b), place, plane),
            [false, true, false] => self.add(edge(b, c), place, plane),
            [false, false, true] => self.add(edge(c, a), place, plane),
            [true, false, true] => self.corner(a),
            [true, true, false] => self.corner(b),
            [false, true, true] => self.corner(c),
            [true, true, true] => {}
        }
    }

    fn corner(&mut self, v: Vertex) {
        self.add(Feature::Vertex(v), self.asking.place(v), Cut::Vertex(v));
    }

    /// Adds what the line has in common with a triangle in whose plane it is. True if an end of the query is there.
    fn within(&mut self, face: u32, corners: [Vertex; 3]) -> bool {
        let asking = self.asking;
        let mut ends: Vec<(Feature, At)> = Vec::new();
        let is_on = corners.map(|v| asking.is_on(v));
        for (v, _) in corners.into_iter().zip(is_on).filter(|(_, is_on)| *is_on) {
            self.corner(v);
            ends.push((Feature::Vertex(v), asking.place(v)));
        }
        let mut touches = false;
        for (at, [u, v]) in edges(corners).into_iter().enumerate() {
            match [is_on[at], is_on[(at + 1) % 3]] {
                // (An edge without length has no points but its ends.)
                [true, true] if asking.order(u, v) != Sign::Zero => {
                    let between = [u, v].map(|v| (Feature::Vertex(v), asking.place(v))).to_vec();
                    touches |= self.interval(edge(u, v), between);
                }
                [false, false] => {
                    if let Some((place, cut)) = asking.crossed([u, v]) {
                        self.add(edge(u, v), place, cut);
                        ends.push((edge(u, v), place));
                    }
                }
                _ => {}
            }
        }
        touches |= ends.iter().any(|(_, place)| asking.is_end(*place));
        // The line passes through the face if corners are on both sides of it.
        let passes = PLANES.into_iter().any(|plane| {
            let turns = corners.map(|v| asking.turn(plane, v));
            turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative) && {
                let [a, b, c] = corners;
                asking.session.orient2d(plane, a, b, c) != Sign::Zero
            }
        });
        if passes {
            touches |= self.interval(Feature::Face(face), ends);
        }
        touches
    }

    /// Adds an interval between these places, if the query reaches into it. True if it holds an end of the query.
    fn interval(&mut self, feature: Feature, ends: Vec<(Feature, At)>) -> bool {
        let asking = self.asking;
        let has = |which: usize, sign: Sign| ends.iter().any(|(_, place)| place[which] == sign);
        let [starts, stops] = [asking.extent.has_start(), asking.extent.has_end()];
        let holds = |which: usize| has(which, Sign::Negative) && has(which, Sign::Positive);
        let touches = starts && holds(0) || stops && holds(1);
        let reaches = (!starts || has(0, Sign::Positive)) && (!stops || has(1, Sign::Negative));
        if reaches && self.known.insert(feature) {
            self.found.intervals.push(Interval { feature, ends });
        }
        touches
    }
}
