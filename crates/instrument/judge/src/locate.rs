//! The exact location of points in maps: crossing numbers, edge by edge.
//!
//! # Definition
//! A region is a list of rings, and a ring is a closed list of vertices; outer boundaries, holes and islands are all
//! rings. An edge is identified by its two vertices, in either direction. The edges of a region are those that its
//! rings use an *odd* number of times. (An edge that one region uses twice bounds nothing.)
//! * A point is **on the boundary** of a region iff it is on one of its edges, ends included; an edge whose ends
//!   coincide is that single point.
//! * Else it is **inside** iff a ray from it crosses the region's edges an odd number of times: the even-odd rule.
//!   Regions may overlap, and rings may touch and cross themselves and each other; nothing is repaired.
//!
//! A point on the boundary is not inside, whatever the parity. Vertices with equal coordinates are one point here, and
//! a probe that is a vertex of the map is on the boundary of that vertex' regions.
//!
//! # How
//! The ray goes to the right. An edge is crossed iff its lower end is at the probe's y or below, its upper end is
//! above, and the probe is left of the edge. This half-open rule counts a vertex at the ray's height once or twice, as
//! it should. Sides are signs of [integers](crate::sign). If the box of an edge does not hold the probe, comparing
//! doubles is enough, and exact. Every probe is tested against every edge. (The algorithm under test sends a vertical
//! ray, through an index.)

use std::collections::BTreeMap;

use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};

use crate::{Sample, sign};

/// The location of a point; no region is in both lists.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Location {
    /// The regions that the point is inside of, ascending.
    pub inside: Vec<u32>,
    /// The regions whose boundary the point is on, ascending.
    pub boundary: Vec<u32>,
}

/// A map, as the edges of its regions.
pub struct Borders<'s> {
    scene: &'s Scene,
    /// The edges, by region.
    edges: Vec<Edge>,
}

/// An edge of a region.
struct Edge {
    region: u32,
    /// The ends, the lower end first.
    ends: [Vertex; 2],
    /// The coordinates of the ends.
    at: [[f64; 2]; 2],
}

/// The relation of an edge to the ray that goes right from a point.
enum Meeting {
    Missed,
    Crossed,
    /// The point is on the edge.
    Touched,
}

impl<'s> Borders<'s> {
    /// Collects the edges of regions, each given as a list of rings of vertices.
    ///
    /// # Panics
    /// If the scene lacks one of the vertices, or there are 2^32 regions.
    #[must_use]
    pub fn new(scene: &'s Scene, regions: &[Vec<Vec<Vertex>>]) -> Borders<'s> {
        let mut edges = Vec::new();
        for (region, rings) in regions.iter().enumerate() {
            let region = u32::try_from(region).expect("a map has fewer than 2^32 regions");
            let mut uses: BTreeMap<[Vertex; 2], usize> = BTreeMap::new();
            for ring in rings {
                for (&u, &v) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                    *uses.entry([u.min(v), u.max(v)]).or_default() += 1;
                }
            }
            for ([u, v], uses) in uses {
                if uses % 2 == 1 {
                    let [p, q] = [u, v].map(|v| scene.point2(Plane::Xy, v));
                    let (ends, at) = if p[1] <= q[1] { ([u, v], [p, q]) } else { ([v, u], [q, p]) };
                    edges.push(Edge { region, ends, at });
                }
            }
        }
        Borders { scene, edges }
    }

    /// The number of edges; an edge between two regions counts for each.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// True if the map has no edges.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The location of an input vertex of the scene.
    ///
    /// # Panics
    /// If the scene lacks the vertex.
    #[must_use]
    pub fn locate(&self, probe: Vertex) -> Location {
        let p = self.scene.point2(Plane::Xy, probe);
        let mut found = Location::default();
        // The last region with an edge at the probe's height: its number of crossings, and whether an edge is touched.
        let mut last: Option<(u32, usize, bool)> = None;
        for edge in &self.edges {
            if p[1] < edge.at[0][1] || edge.at[1][1] < p[1] {
                continue;
            }
            let meeting = self.meeting(edge, probe, p);
            if last.is_none_or(|(region, ..)| region != edge.region) {
                found.add(last.replace((edge.region, 0, false)));
            }
            if let Some((_, crossings, touched)) = &mut last {
                *crossings += usize::from(matches!(meeting, Meeting::Crossed));
                *touched |= matches!(meeting, Meeting::Touched);
            }
        }
        found.add(last);
        found
    }

    /// The meeting of the ray from `p` with an edge at the probe's height, ends included.
    fn meeting(&self, edge: &Edge, probe: Vertex, p: [f64; 2]) -> Meeting {
        let [low, high] = edge.at;
        let is_between = low[1] <= p[1] && p[1] < high[1];
        if low[0].max(high[0]) < p[0] {
            return Meeting::Missed;
        }
        if p[0] < low[0].min(high[0]) {
            return if is_between { Meeting::Crossed } else { Meeting::Missed };
        }
        match sign(self.scene, Question::Orient2d(Plane::Xy), &[edge.ends[0], edge.ends[1], probe]) {
            // The probe is in the box of the edge and on its line.
            Sign::Zero => Meeting::Touched,
            Sign::Positive if is_between => Meeting::Crossed,
            Sign::Positive | Sign::Negative => Meeting::Missed,
        }
    }
}

impl Location {
    fn add(&mut self, of_region: Option<(u32, usize, bool)>) {
        match of_region {
            Some((region, _, true)) => self.boundary.push(region),
            Some((region, crossings, false)) if crossings % 2 == 1 => self.inside.push(region),
            _ => {}
        }
    }
}

/// The location of each probe: [`Borders::locate`].
///
/// # Panics
/// If the scene lacks a vertex of the map or a probe.
#[must_use]
pub fn locate(scene: &Scene, regions: &[Vec<Vec<Vertex>>], probes: &[Vertex]) -> Vec<Location> {
    let borders = Borders::new(scene, regions);
    probes.iter().map(|&probe| borders.locate(probe)).collect()
}

/// The budget for the probes of one scene, in edges tested.
const BUDGET: u64 = 150_000_000;
/// The further cost of a probe's signs, in edges tested.
const SIGNS: u64 = 10_000;

/// The sample of `probes` probes to judge in a map of `edges` edges: all if that takes a few tenths of a second at
/// most, else every n-th.
#[must_use]
pub fn sample(probes: usize, edges: usize) -> Sample {
    Sample::within(BUDGET, probes, edges as u64 + SIGNS)
}
