//! The regions that contain each probe, by the crate `geo`.
//!
//! `geo` answers one polygon at a time and has no notion of a map, so each
//! region gets a bounding-box test in front: what a user of `geo` would write.
//! Two of its ways are timed behind a flat list of boxes: `Contains` on the
//! plain multipolygon, and the interval tree. Then the interval tree comes
//! behind an R-tree (`rstar`), of the regions' boxes and of the boxes of their
//! parts, the polygons of the multipolygons, which are much smaller.

use std::hint::black_box;
use std::time::{Duration, Instant};

use geo::indexed::IntervalTreeMultiPolygon;
use geo::{BoundingRect, Contains, CoordinatePosition, LineString, MultiPolygon, Point, Polygon, Rect};
use predicament_mesh::{PolygonMap, Ring};
use predicament_predicates::{Plane, Scene};
use predicament_records::Interface;
use predicament_tasks::{AnyCase, Class, Outcome, Stopwatch, digest};
use rstar::RTree;
use rstar::primitives::{GeomWithData, Rectangle};

use super::located::Case;
use super::{Peer, Timed};

/// All ways, judged and ready to be timed, where the case is a map.
pub fn peers(case: &dyn AnyCase) -> Vec<Peer<'_>> {
    Case::of(case).map(of).unwrap_or_default()
}

fn of(case: Case<'_>) -> Vec<Peer<'_>> {
    let regions = regions(case.map, case.scene);
    let tree = |region: &MultiPolygon| IntervalTreeMultiPolygon::new(region);
    let trees: Vec<_> = regions.iter().map(|(region, rect)| (tree(region), *rect)).collect();
    let whole = Boxed::new((0..).zip(&regions).map(|(at, (region, rect))| (at, tree(region), *rect)).collect());
    let parts = (0..).zip(&regions).flat_map(|(at, (region, _))| {
        let part = move |part: &Polygon| (at, tree(&MultiPolygon::from(part.clone())), bounds(part.bounding_rect()));
        region.iter().map(part)
    });
    let parts = Boxed::new(parts.collect());
    vec![
        if pairs(&case) > MOST_PAIRS {
            not_asked(&case, "geo:contains")
        } else {
            peer(case.clone(), "geo:contains", Flat(regions))
        },
        peer(case.clone(), "geo:interval-tree", Flat(trees)),
        peer(case.clone(), "geo:r-tree", whole),
        peer(case.clone(), "geo:r-tree:parts", parts),
    ]
}

/// Plain polygons go through all edges for every probe: with more pairs than
/// this of the two, minutes pass for nothing that fewer probes don't tell.
const MOST_PAIRS: usize = 100_000_000_000;

fn pairs(case: &Case<'_>) -> usize {
    case.index.len().saturating_mul(case.probes.len())
}

fn not_asked<'a>(case: &Case<'_>, name: &str) -> Peer<'a> {
    let why = format!("more than {MOST_PAIRS} pairs of an edge and a probe; ask it at level quick");
    Peer {
        name: name.to_owned(),
        version: env!("PREDICAMENT_GEO").to_owned(),
        remarks: vec![format!("{name} is not asked: {why}")],
        outcome: Outcome::of_scene(case.probes.len() as u64, Class::Declined, "pairs", why),
        timed: None,
    }
}

/// Regions that know which of them contain a point.
trait Find {
    /// Adds them, ascending.
    fn find(&self, point: Point, out: &mut Vec<u32>);
}

/// Regions with their boxes, in a list.
struct Flat<R>(Vec<(R, Rect)>);

impl<R: Contains<Point>> Find for Flat<R> {
    #[inline]
    fn find(&self, point: Point, out: &mut Vec<u32>) {
        let Point(at) = point;
        for (region, (contains, rect)) in (0..).zip(&self.0) {
            let (low, high) = (rect.min(), rect.max());
            let held = low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y;
            if held && contains.contains(&point) {
                out.push(region);
            }
        }
    }
}

/// Regions, or parts of them, in a tree of their boxes.
struct Boxed<R> {
    boxes: RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>,
    /// Each with its region.
    within: Vec<(u32, R)>,
}

impl<R> Boxed<R> {
    fn new(all: Vec<(u32, R, Rect)>) -> Boxed<R> {
        let corners = |rect: &Rect| [rect.min(), rect.max()].map(|corner| [corner.x, corner.y]);
        let boxes = all.iter().enumerate().map(|(at, (_, _, rect))| {
            let [low, high] = corners(rect);
            GeomWithData::new(Rectangle::from_corners(low, high), at)
        });
        let boxes = RTree::bulk_load(boxes.collect());
        Boxed { boxes, within: all.into_iter().map(|(region, contains, _)| (region, contains)).collect() }
    }
}

impl<R: Contains<Point>> Find for Boxed<R> {
    #[inline]
    fn find(&self, point: Point, out: &mut Vec<u32>) {
        let first = out.len();
        for held in self.boxes.locate_all_at_point(&[point.x(), point.y()]) {
            let (region, contains) = &self.within[held.data];
            // parts of a region may overlap
            if contains.contains(&point) && !out[first..].contains(region) {
                out.push(*region);
            }
        }
        // The tree has no order.
        out[first..].sort_unstable();
    }
}

fn peer<'a, R: Find + 'a>(case: Case<'a>, name: &str, regions: R) -> Peer<'a> {
    let mut watch = Watch { case, regions, out: Vec::new() };
    watch.pass();
    let wrong = watch.wrong();
    let first_wrong = wrong.first().map(|&(probe, theirs)| {
        let names = |regions: &[u32]| {
            let names = regions.iter().map(|&at| watch.case.map.regions()[at as usize].name.as_str());
            let names = names.collect::<Vec<_>>().join(", ");
            if names.is_empty() { "none".to_owned() } else { names }
        };
        let exact = watch.case.exact.inside(probe);
        format!("probe {probe}: {name} has it in {}, the exact answer is in {}", names(theirs), names(exact))
    });
    let (wrong, queries, judged) = (wrong.len() as u64, watch.case.exact.len() as u64, watch.digest());
    let mut outcome = Outcome { queries, ..Outcome::default() };
    outcome.counts.add(Class::Agree, queries - wrong);
    outcome.counts.add(Class::Topology, wrong);
    Peer {
        name: name.to_owned(),
        version: env!("PREDICAMENT_GEO").to_owned(),
        outcome,
        timed: Some(Timed { watch: Box::new(watch), interface: Interface::Whole, judged }),
        remarks: first_wrong.map(|first| format!("{wrong} wrong; first, {first}")).into_iter().collect(),
    }
}

/// Every region as `geo` wants it, with its box.
///
/// Our regions are bounded by rings under the even-odd rule; `geo` wants shells
/// and holes apart. A ring lies in a hole of the region iff an odd number of
/// its other rings hold it.
fn regions(map: &PolygonMap, scene: &Scene) -> Vec<(MultiPolygon, Rect)> {
    let line = |ring: &Ring| -> LineString {
        let points = ring.vertices().iter().map(|&v| scene.point2(Plane::Xy, v)).map(|[x, y]| (x, y));
        let mut line = LineString::from_iter(points);
        line.close();
        line
    };
    let region = |rings: &[Ring]| {
        let rings: Vec<Polygon> = rings.iter().map(|ring| Polygon::new(line(ring), Vec::new())).collect();
        let holders = |at: usize| -> Vec<usize> {
            let others = (0..rings.len()).filter(|&other| other != at);
            others.filter(|&other| holds(&rings[other], &rings[at])).collect()
        };
        let holders: Vec<Vec<usize>> = (0..rings.len()).map(holders).collect();
        let shells = (0..rings.len()).filter(|&at| holders[at].len().is_multiple_of(2));
        let polygons = shells.map(|shell| {
            let depth = holders[shell].len() + 1;
            let holes = (0..rings.len()).filter(|&at| holders[at].len() == depth && holders[at].contains(&shell));
            let holes = holes.map(|at| rings[at].exterior().clone()).collect();
            Polygon::new(rings[shell].exterior().clone(), holes)
        });
        let region = MultiPolygon::from_iter(polygons);
        let rect = bounds(region.bounding_rect());
        (region, rect)
    };
    map.regions().iter().map(|each| region(&each.rings)).collect()
}

fn bounds(rect: Option<Rect>) -> Rect {
    rect.unwrap_or_else(|| Rect::new((0.0, 0.0), (0.0, 0.0)))
}

/// Whether one ring lies in another: by its first vertex that is not on the other's boundary.
fn holds(outer: &Polygon, inner: &Polygon) -> bool {
    use geo::coordinate_position::CoordPos;
    let box_holds = outer
        .bounding_rect()
        .zip(inner.bounding_rect())
        .is_some_and(|(outer, inner)| outer.contains(&inner) || outer == inner);
    let place =
        || inner.exterior().coords().map(|at| outer.coordinate_position(at)).find(|at| *at != CoordPos::OnBoundary);
    box_holds && place() == Some(CoordPos::Inside)
}

struct Watch<'a, R> {
    case: Case<'a>,
    regions: R,
    /// The regions of each probe, then `u32::MAX`.
    out: Vec<u32>,
}

impl<R> Watch<'_, R> {
    /// The probes whose regions are not the exact ones, and what was answered.
    /// A point on a region's boundary is not contained, in `geo` and here.
    fn wrong(&self) -> Vec<(usize, &[u32])> {
        let theirs = self.out.split(|&region| region == u32::MAX).enumerate().take(self.case.exact.len());
        theirs.filter(|&(probe, theirs)| theirs != self.case.exact.inside(probe)).collect()
    }
}

impl<R: Find> Stopwatch for Watch<'_, R> {
    fn pass(&mut self) -> Duration {
        self.out.clear();
        let start = Instant::now();
        for &probe in &self.case.probes {
            let [x, y] = self.case.scene.point2(Plane::Xy, probe);
            self.regions.find(Point::new(x, y), &mut self.out);
            self.out.push(u32::MAX);
        }
        black_box(&mut self.out);
        start.elapsed()
    }

    fn digest(&self) -> u64 {
        digest(self.out.iter().copied().flat_map(u32::to_le_bytes))
    }
}
