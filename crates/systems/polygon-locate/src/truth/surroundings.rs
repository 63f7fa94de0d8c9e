//! The sectors of a map around a point, decided exactly.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};
use rayon::prelude::*;

use super::Edges;
use super::edge::{Place, place};

/// The kind of ground under a probe.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Ground {
    /// Every sector is in exactly one region.
    Land,
    /// Some sectors are in one region and some in none.
    Coast,
    /// Every sector is in no region.
    Sea,
    /// Some sector is in two regions or more, by the map itself.
    Overlap,
    /// The probe lies on a flaw of the map: on a crossing, a T-junction, a
    /// duplicate vertex or on overlapping edges.
    Defect,
}

impl Ground {
    /// All kinds, in the order of reports.
    pub const ALL: [Ground; 5] = [Ground::Land, Ground::Coast, Ground::Sea, Ground::Overlap, Ground::Defect];

    /// The name used in CSV files and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Ground::Land => "land",
            Ground::Coast => "coast",
            Ground::Sea => "sea",
            Ground::Overlap => "overlap",
            Ground::Defect => "defect",
        }
    }
}

/// The surroundings of many probes. Sets of regions are stored once.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Surroundings {
    probes: Vec<Probe>,
    /// The sets of the sectors, probe after probe.
    sectors: Vec<u32>,
    sets: Vec<Vec<u32>>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Probe {
    ground: Ground,
    is_map_vertex: bool,
    boundary: u32,
    /// The end of the probe's sectors in the list of all sectors.
    sectors_end: usize,
}

impl Surroundings {
    /// The number of probes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.probes.len()
    }

    /// True if there are no probes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.probes.is_empty()
    }

    /// The ground of a probe.
    ///
    /// # Panics
    /// If there is no such probe.
    #[must_use]
    pub fn ground(&self, probe: usize) -> Ground {
        self.probes[probe].ground
    }

    /// True if the probe is itself a vertex of the map, not only at the coordinates of one: no perturbation takes it
    /// off its own edges.
    ///
    /// # Panics
    /// If there is no such probe.
    #[must_use]
    pub fn is_map_vertex(&self, probe: usize) -> bool {
        self.probes[probe].is_map_vertex
    }

    /// The regions whose boundary contains a probe exactly, ascending.
    ///
    /// # Panics
    /// If there is no such probe.
    #[must_use]
    pub fn boundary(&self, probe: usize) -> &[u32] {
        &self.sets[self.probes[probe].boundary as usize]
    }

    /// The distinct sets of regions that cover a sector around a probe, each ascending. There is at least one set; a
    /// set may be empty.
    ///
    /// # Panics
    /// If there is no such probe.
    pub fn sectors(&self, probe: usize) -> impl Iterator<Item = &[u32]> + '_ {
        let start = if probe == 0 { 0 } else { self.probes[probe - 1].sectors_end };
        self.sectors[start..self.probes[probe].sectors_end].iter().map(|&set| &self.sets[set as usize][..])
    }
}

/// Decides the surroundings of every probe, on all threads of the current pool.
///
/// `exact` must return exact signs; otherwise the result means nothing.
///
/// # Panics
/// If the session's scene is not the one of the edges.
#[must_use]
pub fn surroundings<P: Predicates + ?Sized>(edges: &Edges, exact: &P, probes: &[Vertex]) -> Surroundings {
    let around: Vec<Around> = probes.par_iter().map(|&probe| Around::of(edges, exact, probe)).collect();
    let mut sets = BTreeMap::new();
    let mut intern = |set: Vec<u32>| {
        let next = u32::try_from(sets.len()).expect("fewer than 2^32 distinct sets of regions");
        *sets.entry(set).or_insert(next)
    };
    let mut sectors = Vec::new();
    let probes = around
        .into_iter()
        .map(|around| {
            sectors.extend(around.sectors.into_iter().map(&mut intern));
            Probe {
                ground: around.ground,
                is_map_vertex: around.is_map_vertex,
                boundary: intern(around.boundary),
                sectors_end: sectors.len(),
            }
        })
        .collect();
    let mut by_number = vec![Vec::new(); sets.len()];
    for (set, number) in sets {
        by_number[number as usize] = set;
    }
    Surroundings { probes, sectors, sets: by_number }
}

/// The surroundings of one probe.
struct Around {
    ground: Ground,
    is_map_vertex: bool,
    boundary: Vec<u32>,
    sectors: Vec<Vec<u32>>,
}

/// An edge, or a part of it, that leaves the probe.
#[derive(Clone, Copy)]
struct Ray {
    towards: Vertex,
    edge: u32,
}

impl Around {
    fn of<P: Predicates + ?Sized>(edges: &Edges, exact: &P, probe: Vertex) -> Around {
        // The first sector is just clockwise of straight up. By the half-open rule, a ray upward from there crosses
        // exactly the edges strictly above the probe, and no edge through the probe.
        let mut cover = Vec::new();
        let mut boundary = Vec::new();
        let mut rays = Vec::new();
        let mut vertices_here = Vec::new();
        let mut edges_through = 0;
        let owners = |edge: u32| &edges.all()[edge as usize].1[..];
        for edge in edges.above(exact.scene().point2(Plane::Xy, probe)) {
            let [u, v] = edges.all()[edge as usize].0;
            let mut leave_towards = |towards: &[Vertex]| {
                boundary.extend_from_slice(owners(edge));
                rays.extend(towards.iter().map(|&towards| Ray { towards, edge }));
            };
            match place(exact, [u, v], probe) {
                Place::Elsewhere => {}
                Place::Below => toggle(&mut cover, owners(edge)),
                Place::Between => {
                    edges_through += 1;
                    leave_towards(&[u, v]);
                }
                Place::AtFirst => {
                    vertices_here.push(u);
                    leave_towards(&[v]);
                }
                Place::AtSecond => {
                    vertices_here.push(v);
                    leave_towards(&[u]);
                }
                Place::AtBoth => {
                    vertices_here.extend([u, v]);
                    leave_towards(&[]);
                }
            }
        }
        sort_dedup(&mut boundary);
        sort_dedup(&mut vertices_here);

        rays.sort_unstable_by(|a, b| clockwise_from_up(exact, probe, a.towards, b.towards));
        let mut sectors = vec![cover.clone()];
        let mut sound = vertices_here.len() + edges_through <= 1;
        for together in rays.chunk_by(|a, b| clockwise_from_up(exact, probe, a.towards, b.towards).is_eq()) {
            sound &= together.len() == 1;
            for ray in together {
                toggle(&mut cover, owners(ray.edge));
            }
            sectors.push(cover.clone());
        }
        assert_eq!(sectors.first(), sectors.last(), "boundaries are closed");
        sort_dedup(&mut sectors);

        let most = sectors.iter().map(Vec::len).max().unwrap_or(0);
        let least = sectors.iter().map(Vec::len).min().unwrap_or(0);
        let ground = match (sound, least, most) {
            (false, _, _) => Ground::Defect,
            (true, 1, 1) => Ground::Land,
            (true, 0, 1) => Ground::Coast,
            (true, 0, 0) => Ground::Sea,
            (true, _, _) => Ground::Overlap,
        };
        Around { ground, is_map_vertex: vertices_here.contains(&probe), boundary, sectors }
    }
}

fn sort_dedup<T: Ord>(list: &mut Vec<T>) {
    list.sort_unstable();
    list.dedup();
}

/// Toggles regions: adds the regions that are not in the set, and removes the regions that are.
fn toggle(set: &mut Vec<u32>, regions: &[u32]) {
    for region in regions {
        match set.binary_search(region) {
            Ok(at) => {
                set.remove(at);
            }
            Err(at) => set.insert(at, *region),
        }
    }
}

/// The order of two directions by their clockwise angle from straight up, in (0°, 360°]: up itself comes last, because
/// the first sector begins beyond it.
fn clockwise_from_up<P: Predicates + ?Sized>(exact: &P, p: Vertex, a: Vertex, b: Vertex) -> Ordering {
    let in_second_half = |v| match exact.compare(Axis::X, v, p) {
        Sign::Positive => false,
        Sign::Zero => exact.compare(Axis::Y, v, p) == Sign::Positive,
        Sign::Negative => true,
    };
    let by_turn = || match exact.orient2d(Plane::Xy, p, a, b) {
        Sign::Negative => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Positive => Ordering::Greater,
    };
    in_second_half(a).cmp(&in_second_half(b)).then_with(by_turn)
}
