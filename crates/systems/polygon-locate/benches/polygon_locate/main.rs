//! Benchmark of point location on a map of 217,600 edges and 256 regions, on one thread.
//!
//! It compares with the paper's own test and with the crate `geo`: its plain polygons and its interval trees, one per
//! region, each behind a bounding-box test, and the trees behind an R-tree of all boxes (`rstar`). Answers are compared
//! before anything is timed.
//!
//! Generic code and the paper's test are compared twice: by the index, as they are used, and edge by edge, where every
//! edge above a point is tested and boxes decide nothing.

mod wiggly;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use geo::algorithm::indexed::IntervalTreeMultiPolygon;
use geo::{BoundingRect, Contains, Coord, Intersects, LineString, MultiPolygon, Polygon, Rect};
use predicament_exact::{Exact, raw};
use predicament_mesh::PolygonMap;
use predicament_polygon_locate::algorithm::special::Point;
use predicament_polygon_locate::algorithm::{LocateIndex, Locations, Scratch, locate_all, locate_all_specially};
use predicament_predicates::{Backend, Off, Predicates, Scene, Sign, Vertex};
use predicament_sos::Sos;
use rstar::RTree;
use rstar::primitives::{GeomWithData, Rectangle};

const QUERIES: usize = 20_000;

fn coordinate(scene: &Scene, v: Vertex) -> Coord {
    let point = scene.point(v);
    Coord { x: point[0], y: point[1] }
}

fn polygons(map: &PolygonMap, scene: &Scene) -> Vec<Polygon> {
    let ring = |region: &predicament_mesh::Region| {
        let ring: Vec<Coord> = region.rings[0].vertices().iter().map(|&v| coordinate(scene, v)).collect();
        Polygon::new(LineString::new(ring), Vec::new())
    };
    map.regions().iter().map(ring).collect()
}

/// The regions that contain each query, by any test of one region.
fn located<R: Contains<Coord>>(regions: &[(Rect, R)], queries: &[Coord]) -> Vec<Vec<u32>> {
    let inside = |query: &Coord| {
        let hits =
            (0..).zip(regions).filter(|(_, (bounds, region))| bounds.intersects(query) && region.contains(query));
        hits.map(|(at, _)| at).collect()
    };
    queries.iter().map(inside).collect()
}

/// A tree of the boxes of regions.
type Boxes = RTree<GeomWithData<Rectangle<[f64; 2]>, u32>>;

/// The regions that contain each query, by a tree of the boxes.
fn located_by_boxes<R: Contains<Coord>>(boxes: &Boxes, regions: &[(Rect, R)], queries: &[Coord]) -> Vec<Vec<u32>> {
    let inside = |query: &Coord| {
        let held = boxes.locate_all_at_point(&[query.x, query.y]).map(|held| held.data);
        let mut hits: Vec<u32> = held.filter(|&at| regions[at as usize].1.contains(query)).collect();
        hits.sort_unstable();
        hits
    };
    queries.iter().map(inside).collect()
}

fn ours<P: Predicates>(index: &LocateIndex, session: &P, queries: &[Vertex]) -> Locations {
    locate_all(index, session, queries, &|_| true)
}

/// The sign of D by `robust`.
fn by_robust(l: Point, r: Point, p: Point) -> Sign {
    let [l, r, p] = [l, r, p].map(|[x, y]| robust::Coord { x, y });
    Sign::of(robust::orient2d(l, r, p))
}

/// The sign of D by our own exact arithmetic, without preparation.
fn by_exact(l: Point, r: Point, p: Point) -> Sign {
    raw::orient2d([l, r, p])
}

/// The paper's test of every edge that is not below a query.
fn edge_by_edge(index: &LocateIndex, scene: &Scene, queries: &[Vertex]) -> Vec<Vec<u32>> {
    let mut scratch = Scratch::new();
    let mut locate = |&q: &Vertex| index.question_specially(scene, q, &by_robust, &mut scratch).inside.to_vec();
    queries.iter().map(&mut locate).collect()
}

/// The test of every edge that is not below a query, by a session.
fn edge_by_edge_generic<P: Predicates>(index: &LocateIndex, session: &P, queries: &[Vertex]) -> Vec<Vec<u32>> {
    let mut scratch = Scratch::new();
    let mut locate = |&q: &Vertex| index.question(session, q, &mut scratch).inside.to_vec();
    queries.iter().map(&mut locate).collect()
}

fn bench(criterion: &mut Criterion) {
    let (map, scene, queries) = wiggly::map(16, 400, QUERIES);
    let index = LocateIndex::new(&map, &scene);
    assert_eq!((index.len(), index.regions()), (217_600, 256));
    let exact = Exact.prepare(&scene, Off).expect("a 2D scene");
    let perturbed = Sos::default();
    let sos = perturbed.prepare(&scene, Off).expect("a 2D scene");

    let bounded = |polygon: &Polygon| polygon.bounding_rect().expect("a polygon with points");
    let plain: Vec<(Rect, Polygon)> = polygons(&map, &scene).into_iter().map(|p| (bounded(&p), p)).collect();
    let trees: Vec<(Rect, IntervalTreeMultiPolygon<f64>)> = plain
        .iter()
        .map(|(bounds, polygon)| (*bounds, IntervalTreeMultiPolygon::new(&MultiPolygon::new(vec![polygon.clone()]))))
        .collect();
    let boxed = |(at, (bounds, _)): (u32, &(Rect, IntervalTreeMultiPolygon<f64>))| {
        let corners = [bounds.min(), bounds.max()].map(|corner| [corner.x, corner.y]);
        GeomWithData::new(Rectangle::from_corners(corners[0], corners[1]), at)
    };
    let boxes: Boxes = RTree::bulk_load((0..).zip(&trees).map(boxed).collect());
    let points: Vec<Coord> = queries.iter().map(|&q| coordinate(&scene, q)).collect();

    let answers = ours(&index, &exact, &queries);
    assert_eq!(answers, ours(&index, &sos, &queries));
    let by_robust_sign = || locate_all_specially(&index, &scene, &by_robust, &queries, &|_| true);
    let by_exact_sign = || locate_all_specially(&index, &scene, &by_exact, &queries, &|_| true);
    assert_eq!(answers, by_robust_sign());
    assert_eq!(answers, by_exact_sign());
    let by_boxes = || located_by_boxes(&boxes, &trees, &points);
    for geo in [located(&plain, &points), located(&trees, &points), by_boxes()] {
        assert!(answers.iter().map(|location| location.inside).eq(geo.iter()));
    }

    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let mut group = criterion.benchmark_group("polygon-locate");
    group.sample_size(10).throughput(Throughput::Elements(queries.len() as u64));
    group.bench_function("exact", |b| b.iter(|| one_thread.install(|| ours(&index, &exact, &queries))));
    group.bench_function("sos", |b| b.iter(|| one_thread.install(|| ours(&index, &sos, &queries))));
    group.bench_function("special/robust", |b| b.iter(|| one_thread.install(by_robust_sign)));
    group.bench_function("special/exact", |b| b.iter(|| one_thread.install(by_exact_sign)));
    group.bench_function("geo/polygon", |b| b.iter(|| located(&plain, &points)));
    group.bench_function("geo/interval-tree", |b| b.iter(|| located(&trees, &points)));
    group.bench_function("geo/interval-tree/r-tree", |b| b.iter(by_boxes));
    group.finish();

    let few = &queries[..queries.len() / 10];
    let all_asked = edge_by_edge(&index, &scene, few);
    assert!(all_asked.iter().eq(answers.iter().take(few.len()).map(|location| location.inside)));
    assert_eq!(all_asked, edge_by_edge_generic(&index, &exact, few));
    assert_eq!(all_asked, edge_by_edge_generic(&index, &sos, few));
    let mut group = criterion.benchmark_group("polygon-locate-edge-by-edge");
    group.sample_size(10).throughput(Throughput::Elements(few.len() as u64));
    group.bench_function("exact", |b| b.iter(|| edge_by_edge_generic(&index, &exact, few)));
    group.bench_function("sos", |b| b.iter(|| edge_by_edge_generic(&index, &sos, few)));
    group.bench_function("special/robust", |b| b.iter(|| edge_by_edge(&index, &scene, few)));
    group.finish();

    let mut group = criterion.benchmark_group("polygon-locate-build");
    group.sample_size(10).throughput(Throughput::Elements(index.len() as u64));
    group.bench_function("index", |b| b.iter(|| LocateIndex::new(&map, &scene)));
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
