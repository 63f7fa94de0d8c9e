//! The truth about points in maps: crossing numbers, edge by edge.
//!
//! # Definition
//! A region is a list of rings, a ring a closed list of vertices: outer boundaries,
//! holes and islands alike. An edge is known by its two vertices, whichever
//! way it runs; the edges of a region are those that its rings use an *odd* number of
//! times. (Used twice by one region, an edge bounds nothing.)
//! * A point is **on the boundary** of a region iff it is on one of its edges, ends
//!   included; an edge whose ends are in one place is that place.
//! * Else it is **inside** iff a ray from it crosses the region's edges an odd number
//!   of times: the even-odd rule. Regions may overlap, and rings may touch and
//!   cross themselves and each other; nothing is repaired.
//!
//! A point on the boundary is not inside, whatever the parity. Vertices with
//! equal coordinates are one place here, and a probe that is a vertex of the map is
//! on the boundary of that vertex' regions.
//!
//! # How
//! The ray goes to the right. An edge is crossed iff its lower end is at the probe's y
//! or below, its upper end above (half-open, so that a vertex at the ray's
//! height counts once or twice as it should), and the probe is left of it. Sides are
//! signs of [integers](crate::sign); where the box of an edge doesn't hold the
//! probe, comparing doubles is enough, and exact. Every edge is looked at for
//! every probe. (The algorithm that this is held against sends a vertical ray,
//! through an index.)

use std::collections::BTreeMap;

use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};

use crate::{Sample, sign};

/// Where a point is; no region is in both lists.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Location {
    /// The regions that it is inside of, ascending.
    pub inside: Vec<u32>,
    /// The regions whose boundary it is on, ascending.
    pub boundary: Vec<u32>,
}

/// A map by the edges of its regions.
pub struct Borders<'s> {
    scene: &'s Scene,
    /// By region.
    edges: Vec<Edge>,
}

/// An edge of a region.
struct Edge {
    region: u32,
    /// The lower end first.
    ends: [Vertex; 2],
    /// The coordinates of the ends.
    at: [[f64; 2]; 2],
}

/// How an edge meets the ray to the right from a point.
enum Meeting {
    Missed,
    Crossed,
    /// The point is on the edge.
    Touched,
}

impl<'s> Borders<'s> {
    /// The edges of regions that are lists of rings of vertices.
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

    /// The number of edges, those between two regions counted for each.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// Whether the map bounds nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// Where an input vertex of the scene is.
    ///
    /// # Panics
    /// If the scene lacks it.
    #[must_use]
    pub fn locate(&self, probe: Vertex) -> Location {
        let p = self.scene.point2(Plane::Xy, probe);
        let mut found = Location::default();
        // The last region with an edge at the probe's height: how often it is crossed, and whether touched.
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

    /// For an edge at the probe's height, ends included.
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
            // In the box of the edge and on its line.
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

/// Where each probe is: [`Borders::locate`].
///
/// # Panics
/// If the scene lacks a vertex of the map or a probe.
#[must_use]
pub fn locate(scene: &Scene, regions: &[Vec<Vec<Vertex>>], probes: &[Vertex]) -> Vec<Location> {
    let borders = Borders::new(scene, regions);
    probes.iter().map(|&probe| borders.locate(probe)).collect()
}

/// What a scene's probes may cost, in looks at an edge.
const BUDGET: u64 = 150_000_000;
/// What a probe's signs cost besides, in looks at an edge.
const SIGNS: u64 = 10_000;

/// Which of so many probes are judged in a map of so many edges: all as long as
/// that takes a few tenths of a second, else every n-th.
#[must_use]
pub fn sample(probes: usize, edges: usize) -> Sample {
    Sample::within(BUDGET, probes, edges as u64 + SIGNS)
}
