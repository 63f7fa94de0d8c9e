//! Tests of points in meshes at scale, against truths in closed form, by all sessions that are never wrong.

mod scenes;

use predicament_exact::Exact;
use predicament_grid::two_level::Sizes;
use predicament_mesh_locate::algorithm::{Location, MeshIndex, Ray, locate_all, question_all};
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::{PerMesh, Sos};

use self::scenes::{Case, Point, Random, boxes, coordinates, lattice, nested};

/// The number of queries of a kind for a scene: a twentieth of a twentieth by default.
fn queries() -> usize {
    predicament_effort::scaled(predicament_effort::scaled(3_000_000))
}

/// Returns `whole` at whole effort, and `small` by default.
fn size(whole: i64, small: i64) -> i64 {
    if predicament_effort::whole() { whole } else { small }
}

fn middle(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|axis| i64::midpoint(a[axis], b[axis]))
}

impl Case {
    fn corners(&self, triangle: usize) -> [Point; 3] {
        self.mesh.triangles()[triangle].map(|v| self.points[v.index()])
    }

    /// A random point in the box and a little around it.
    fn anywhere(&self, random: &mut Random, [low, high]: [Point; 2]) -> Point {
        [0, 1, 2].map(|axis| {
            let margin = (high[axis] - low[axis]) / 16;
            low[axis] - margin + random.below(high[axis] - low[axis] + 2 * margin + 1)
        })
    }

    /// A random vertex, midpoint of an edge or point between them.
    fn on_mesh(&self, random: &mut Random) -> Point {
        let [a, b, c] = random.of(self.mesh.triangles()).map(|v| self.points[v.index()]);
        *random.of(&[a, middle(a, b), middle(a, middle(b, c))])
    }

    /// A random degenerate point: on the mesh, next to it by a unit, on lines along the axes through it, in the lattice
    /// that its vertices span, or halfway between two of its points. Most points that turn out to be on the mesh are
    /// drawn again.
    fn degenerate(&self, random: &mut Random, bounds: [Point; 2]) -> Point {
        loop {
            let p = self.tied(random, bounds);
            if self.truth.region(p).is_some() || random.below(8) == 0 {
                return p;
            }
        }
    }

    fn tied(&self, random: &mut Random, bounds: [Point; 2]) -> Point {
        let [mut p, other, third] = [(); 3].map(|()| self.on_mesh(random));
        let axis = *random.of(&[0, 1, 2]);
        match random.below(8) {
            0 | 1 => p[2] = self.anywhere(random, bounds)[2],
            2 => p[axis] = self.anywhere(random, bounds)[axis],
            3 => p[axis] = other[axis],
            4 => p = [p[0], other[1], third[2]],
            5 => p = middle(*random.of(&self.points), *random.of(&self.points)),
            6 => p[axis] += random.of(&[-1, 1]),
            _ => {}
        }
        p
    }

    /// True if a point is one of a triangle's points.
    fn holds(&self, triangle: u32, p: Point) -> bool {
        let [a, b, c] = self.corners(triangle as usize);
        let less = |p: Point, q: Point| [0, 1, 2].map(|axis| i128::from(p[axis]) - i128::from(q[axis]));
        let normal = cross(less(b, a), less(c, a));
        let divisor = normal.into_iter().fold(0, divisor);
        let height: i128 = normal.iter().zip(less(p, a)).map(|(n, x)| n / divisor * x).sum();
        let turns = [[a, b], [b, c], [c, a]].map(|[u, v]| cross(less(v, u), less(p, u)));
        let is_within = |axis: usize| {
            let signs = turns.map(|turn| turn[axis].signum());
            !(signs.contains(&1) && signs.contains(&-1))
        };
        height == 0 && (0..3).all(is_within)
    }

    fn is_right(&self, answer: Location, p: Point, is_exact: bool) -> bool {
        match (answer, self.truth.region(p)) {
            (Location::In(region), Some(truth)) => region == truth,
            (Location::In(region), None) => !is_exact && self.truth.touches(region, p),
            (Location::On(triangle), None) => is_exact && self.holds(triangle, p),
            (Location::On(_), Some(_)) | (Location::Contradiction | Location::Undecided, _) => false,
        }
    }
}

fn cross(u: [i128; 3], v: [i128; 3]) -> [i128; 3] {
    [0, 1, 2].map(|i: usize| u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3])
}

fn divisor(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs() } else { divisor(b, a % b) }
}

/// The numbers of queries and of wrong answers.
#[derive(Default, Debug)]
struct Counts {
    random: usize,
    /// Degenerate queries that are on no triangle.
    degenerate: usize,
    on: usize,
    answers: usize,
    wrong: usize,
    first: Option<String>,
}

impl Counts {
    fn judge(&mut self, case: &Case, points: &[Point], session: &str, answers: &[Location]) {
        assert!(!answers.is_empty() && answers.len() <= points.len());
        self.answers += answers.len();
        for (&p, &answer) in points.iter().zip(answers) {
            if !case.is_right(answer, p, session == "exact") {
                self.wrong += 1;
                let region = || case.truth.region(p);
                self.first.get_or_insert_with(|| {
                    format!("{session}: {:?} is {:?}, not {answer:?}", coordinates(p), region())
                });
            }
        }
    }
}

/// Runs queries of both kinds, in parts that fit into memory: by exact and by broken ties, a twentieth by ties broken
/// from mesh to mesh, and a hundredth by all rays.
fn counts(case: &Case, queries: usize, sizes: Option<Sizes>) -> Counts {
    let mut counts = Counts::default();
    let mut random = Random(1);
    let end = |pick: fn(i64, i64) -> i64| {
        let both = |a: Point, b: Point| [0, 1, 2].map(|axis| pick(a[axis], b[axis]));
        case.points.iter().copied().reduce(both).unwrap()
    };
    let bounds = [end(i64::min), end(i64::max)];
    let vertices: Vec<[f64; 3]> = case.points.iter().map(|&p| coordinates(p)).collect();
    let index = MeshIndex::with_sizes(case.mesh.clone(), &Scene::from_points3(&vertices).unwrap(), sizes);
    let mut left = queries;
    while left > 0 {
        let part = left.min(250_000);
        left -= part;
        let mut points: Vec<Point> = Vec::with_capacity(2 * part);
        for _ in 0..part {
            points.extend([case.anywhere(&mut random, bounds), case.degenerate(&mut random, bounds)]);
        }
        let on = points.iter().skip(1).step_by(2).filter(|&&p| case.truth.region(p).is_none()).count();
        counts.random += part;
        counts.on += on;
        counts.degenerate += part - on;
        let mut all = vertices.clone();
        all.extend(points.iter().map(|&p| coordinates(p)));
        let queries: Vec<Vertex> = (vertices.len()..all.len()).map(Vertex::input).collect();
        let scene = Scene::from_points3(&all).unwrap().with_second_mesh(queries.iter().copied());
        let [some, few] = [20, 100].map(|of| &queries[..queries.len().div_ceil(of)]);
        let exact = Exact.prepare(&scene, Off).unwrap();
        counts.judge(case, &points, "exact", &locate(&index, &exact, &queries));
        let sos = Sos::default();
        let sos = sos.prepare(&scene, Off).unwrap();
        counts.judge(case, &points, "sos", &locate(&index, &sos, &queries));
        let per_mesh = PerMesh.prepare(&scene, Off).unwrap();
        counts.judge(case, &points, "sos:per-mesh", &locate(&index, &per_mesh, some));
        for ray in Ray::ALL {
            counts.judge(case, &points, "exact", &question_all(&index, &exact, few, &[ray], &|_| true));
            counts.judge(case, &points, "sos", &question_all(&index, &sos, few, &[ray], &|_| true));
        }
    }
    counts
}

fn locate<P: Predicates>(index: &MeshIndex, session: &P, queries: &[Vertex]) -> Vec<Location> {
    locate_all(index, session, queries, &|_| true)
}

/// Asserts that no answer about a scene is wrong.
fn all_are_right(case: &Case) {
    let queries = queries();
    let counts = counts(case, queries, None);
    println!("{} triangles, {counts:?}", case.mesh.triangles().len());
    assert_eq!((counts.wrong, &counts.first), (0, &None), "{counts:?}");
    assert!(counts.answers >= 4 * queries && counts.random == queries, "{counts:?}");
    assert!(3 * counts.degenerate > queries && 40 * counts.on > queries, "{counts:?}");
}

#[test]
fn lattices_of_tetrahedra() {
    all_are_right(&lattice(size(24, 7), false));
}

#[test]
fn turned_lattices_of_tetrahedra() {
    all_are_right(&lattice(size(24, 7), true));
}

#[test]
fn boxes_between_uneven_planes() {
    all_are_right(&boxes(size(32, 9), false));
}

#[test]
fn turned_boxes_between_uneven_planes() {
    all_are_right(&boxes(size(32, 9), true));
}

#[test]
fn cubes_in_each_other() {
    all_are_right(&nested(size(24, 12)));
}

#[test]
fn small_scenes_also_by_a_fine_grid() {
    let fine = Some(Sizes { coarse: [32; 3], fine: 2, full: 2 });
    for (case, sizes) in [(lattice(3, true), None), (boxes(4, true), None), (nested(4), fine)] {
        let counts = counts(&case, 400, sizes);
        assert_eq!((counts.wrong, &counts.first), (0, &None), "{counts:?}");
    }
}
