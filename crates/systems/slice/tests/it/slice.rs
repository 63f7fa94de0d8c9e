//! Tests of slicing: parts of solids under exact signs, under broken ties, and under meaningless signs.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use predicament_exact::Exact;
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::{
    Backend, Construction, Off, Plane, Predicates, Question, Refused, Scene, Sign, Vertex, answer_by,
};
use predicament_slice::algorithm::{Sliced, Source, slice};
use predicament_sos::Sos;

/// Points, faces, and for each face three corners that turn as it does.
struct Shape {
    points: Vec<[f64; 3]>,
    faces: IndexedFaces,
    supports: Vec<[Vertex; 3]>,
}

/// A prism over a polygon in the plane, whose second corner is convex.
fn prism(polygon: &[[f64; 2]]) -> Shape {
    let n = u32::try_from(polygon.len()).unwrap();
    let points = [0.0, 1.0].iter().flat_map(|&z| polygon.iter().map(move |&[x, y]| [x, y, z])).collect();
    let mut faces: Vec<Vec<u32>> = vec![(0..n).rev().collect(), (n..2 * n).collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
    let mut supports: Vec<[u32; 3]> = faces.iter().map(|face| [face[0], face[1], face[2]]).collect();
    (supports[0], supports[1]) = ([2, 1, 0], [n, n + 1, n + 2]);
    let supports = supports.into_iter().map(|support| support.map(|v| Vertex::input(v as usize))).collect();
    Shape { points, faces: faces.into_iter().collect(), supports }
}

/// A comb with teeth of one height.
fn comb(teeth: i32) -> Shape {
    let mut polygon = vec![[0.0, -1.0], [f64::from(2 * teeth - 1), -1.0]];
    for tooth in (0..teeth).rev() {
        let left = f64::from(2 * tooth);
        polygon.extend([[left + 1.0, 8.0], [left, 8.0]]);
        if tooth > 0 {
            polygon.extend([[left, 0.0], [left - 1.0, 0.0]]);
        }
    }
    prism(&polygon)
}

impl Shape {
    fn scene(&self) -> Scene {
        Scene::from_points3(&self.points).unwrap()
    }

    fn mesh(&self) -> HalfEdgeMesh {
        HalfEdgeMesh::new((0..self.points.len()).map(Vertex::input).collect(), &self.faces).unwrap()
    }

    fn sliced(&self, session: &mut dyn Predicates, planes: &[[usize; 3]]) -> Result<Sliced, Refused> {
        let planes: Vec<[Vertex; 3]> = planes.iter().map(|plane| plane.map(Vertex::input)).collect();
        slice(session, self.mesh(), &self.supports, &planes)
    }
}

/// Three numbers below n, from a seed.
fn three(n: usize, seed: u64) -> [usize; 3] {
    let mut hasher = DefaultHasher::new();
    seed.hash(&mut hasher);
    let hash = usize::try_from(hasher.finish() >> 1).unwrap();
    let first = hash % n;
    let second = (first + 1 + hash / n % (n - 1)) % n;
    let third = (0..n).map(|at| (hash / n / n + at) % n).find(|&at| at != first && at != second).unwrap();
    [first, second, third]
}

/// Checks that each directed edge of a part occurs as often as its reverse.
fn check_closed(sliced: &Sliced) {
    for part in &sliced.parts {
        assert_eq!(part.sources.len(), part.triangles.len());
        let mut surplus: BTreeMap<[Vertex; 2], i32> = BTreeMap::new();
        for [a, b, c] in &part.triangles {
            for [p, q] in [[a, b], [b, c], [c, a]] {
                *surplus.entry([*p.min(q), *p.max(q)]).or_default() += if p < q { 1 } else { -1 };
            }
        }
        assert!(surplus.values().all(|&surplus| surplus == 0) || !part.open.is_empty(), "a part is open");
    }
}

/// Planes through three vertices each, not all on one line.
fn planes(shape: &Shape, count: usize, seed: u64) -> Vec<[usize; 3]> {
    let scene = shape.scene();
    let flat = |plane: &[usize; 3]| {
        let [a, b, c] = plane.map(Vertex::input);
        let exact = Exact.prepare(&scene, Off).unwrap();
        use predicament_predicates::Plane::{Xy, Yz, Zx};
        [Xy, Yz, Zx].into_iter().all(|plane| exact.orient2d(plane, a, b, c).is_zero())
    };
    let mut found: Vec<[usize; 3]> =
        (0..).map(|at| three(shape.points.len(), 1000 * seed + at)).filter(|plane| !flat(plane)).take(count).collect();
    found.dedup();
    found
}

fn lattice(side: u32) -> Shape {
    let mut numbers: BTreeMap<[u32; 3], u32> = BTreeMap::new();
    let (mut points, mut faces, mut supports) = (Vec::new(), IndexedFaces::default(), Vec::new());
    for axis in 0..3 {
        for level in [0, side] {
            for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
                let mut square = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[u, v]| {
                    let mut place = [0; 3];
                    (place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]) = (level, u, v);
                    *numbers.entry(place).or_insert_with(|| {
                        points.push(place.map(f64::from));
                        u32::try_from(points.len() - 1).unwrap()
                    })
                });
                if level == 0 {
                    square.reverse();
                }
                faces.push(square);
                supports.push([square[0], square[1], square[2]].map(|v| Vertex::input(v as usize)));
            }
        }
    }
    Shape { points, faces, supports }
}

/// True if each triangle of the parts has an area.
fn have_areas(sliced: &Sliced, exact: &dyn Predicates) -> bool {
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
    let has_area = |&[a, b, c]: &[Vertex; 3]| planes.iter().any(|&plane| !exact.orient2d(plane, a, b, c).is_zero());
    sliced.parts.iter().flat_map(|part| &part.triangles).all(has_area)
}

/// Slices a shape by many sets of planes through its vertices, under exact signs, and some under broken ties.
fn check(shape: impl Fn(u64) -> Shape) {
    let mut wrong = Vec::new();
    let mut broken_ties = 0;
    for seed in 0..u64::from(predicament_effort::cases(120)) {
        let shape = shape(seed);
        let planes = planes(&shape, 1 + usize::try_from(seed % 6).unwrap(), seed);
        let scene = shape.scene();
        let mut note = |name: &str, sliced: &Sliced| match sliced.broken {
            None => check_closed(sliced),
            Some(what) => wrong.push(format!("{name} {seed} {what:?} {planes:?}")),
        };
        let mut exact = Exact.prepare(&scene, Off).unwrap();
        let sliced = shape.sliced(&mut exact, &planes).unwrap();
        note("exact", &sliced);
        assert!(have_areas(&sliced, &exact), "{seed} {planes:?}");
        if planes.len() < 3 {
            // The session refuses if an edge lies in a plane with other vertices.
            if let Ok(sliced) = shape.sliced(&mut Sos::default().prepare(&scene, Off).unwrap(), &planes) {
                note("sos", &sliced);
                broken_ties += 1;
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(broken_ties > 0, "{broken_ties}");
}

#[test]
fn combs_by_planes_through_their_corners() {
    check(|seed| comb(2 + i32::try_from(seed % 4).unwrap()));
}

/// Tests caps with several corners in one point: the inside between two of them has no width there, or an edge without
/// length joins them, which an earlier plane has made.
#[test]
fn a_cap_with_several_corners_in_a_point_is_split_there() {
    let cases: [(i32, &[[usize; 3]]); 4] = [
        (3, &[[15, 4, 20], [18, 8, 23]]),
        (3, &[[11, 18, 3], [5, 0, 4], [19, 12, 3], [18, 11, 5], [18, 13, 23], [21, 16, 4]]),
        (2, &[[11, 5, 1], [7, 13, 15], [0, 9, 12], [14, 7, 5]]),
        (2, &[[7, 5, 13], [11, 9, 6], [4, 7, 6], [12, 0, 7], [12, 13, 0], [2, 14, 4]]),
    ];
    for (teeth, planes) in cases {
        let shape = comb(teeth);
        let scene = shape.scene();
        let mut exact = Exact.prepare(&scene, Off).unwrap();
        let sliced = shape.sliced(&mut exact, planes).unwrap();
        assert_eq!(sliced.broken, None, "{planes:?}");
        check_closed(&sliced);
        assert!(have_areas(&sliced, &exact), "{planes:?}");
    }
}

#[test]
fn lattices_by_planes_through_their_vertices() {
    check(|seed| lattice(1 + u32::try_from(seed % if predicament_effort::whole() { 3 } else { 2 }).unwrap()));
}

/// Slices triangles of input vertices by three planes of three points each, with exact signs.
fn cut(points: &[[f64; 3]], faces: &[[u32; 3]], planes: [[[f64; 3]; 3]; 3]) -> Sliced {
    let all: Vec<[f64; 3]> = points.iter().copied().chain(planes.into_iter().flatten()).collect();
    let scene = Scene::from_points3(&all).unwrap();
    let indexed: IndexedFaces = faces.iter().map(|face| face.to_vec()).collect();
    let mesh = HalfEdgeMesh::new((0..points.len()).map(Vertex::input).collect(), &indexed).unwrap();
    let supports: Vec<[Vertex; 3]> = faces.iter().map(|f| f.map(|v| Vertex::input(v as usize))).collect();
    let planes: Vec<[Vertex; 3]> = (0..3).map(|k| [0, 1, 2].map(|i| Vertex::input(points.len() + 3 * k + i))).collect();
    slice(&mut Exact.prepare(&scene, Off).unwrap(), mesh, &supports, &planes).unwrap()
}

/// The planes across the three axes at this distance from the origin.
fn planes_at(distance: f64) -> [[[f64; 3]; 3]; 3] {
    let plane = [[distance, 0.0, 0.0], [distance, 1.0, 0.0], [distance, 0.0, 1.0]];
    [0, 1, 2].map(|by| {
        plane.map(|mut p| {
            p.rotate_right(by);
            p
        })
    })
}

/// Tests an open mesh whose faces nearly lie on each other: the border of a part visits one constructed vertex more
/// than once.
#[test]
fn covers_of_borders_that_pass_a_vertex_twice_have_no_corner_twice() {
    let tiny = |x: f32| f64::from(x);
    let points = [
        [0.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 0.0, 4.0],
        [4.0, -0.0, tiny(2.24e-44)],
        [0.0, tiny(4.59e-41), 4.0],
    ];
    let sliced = cut(&points, &[[0, 1, 2], [0, 2, 3], [4, 1, 5], [1, 0, 3]], planes_at(2.0));
    assert_eq!(sliced.broken, None);
    check_closed(&sliced);
    let mut covers = 0;
    for part in &sliced.parts {
        covers += part.sources.iter().filter(|&&source| source == Source::Cover).count();
        assert!(part.triangles.iter().all(|[a, b, c]| a != b && b != c && c != a), "{:?}", part.triangles);
    }
    assert!(covers > 0);
}

/// Two triangles that share a vertex: a plane cuts one of them there, and the other gets a vertex of its own.
#[test]
fn a_vertex_of_two_fans_is_divided() {
    let points = [[1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [2.0, 0.0, -1.0], [-1.0, -2.0, -2.0], [1.0, 0.0, 2.0]];
    let sliced = cut(&points, &[[0, 1, 2], [1, 3, 4]], planes_at(0.0));
    assert_eq!(sliced.broken, None);
    check_closed(&sliced);
    let of = |face: u32| {
        let sources = sliced.parts.iter().flat_map(|part| &part.sources);
        sources.filter(|&&source| source == Source::Face(face)).count()
    };
    assert!(of(0) >= 2 && of(1) >= 2, "{:?}", sliced.parts);
}

/// A session whose signs come from a hash of the question; it constructs every point.
struct Whim {
    scene: Scene,
    seed: u64,
}

impl Whim {
    fn sign<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let mut hasher = DefaultHasher::new();
        (question, args, self.seed).hash(&mut hasher);
        match hasher.finish() % 5 {
            0 => Sign::Zero,
            1 | 2 => Sign::Negative,
            _ => Sign::Positive,
        }
    }
}

impl Predicates for Whim {
    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.scene.construct_all(definitions, |_, _| Ok(()))
    }

    answer_by!(sign);
}

#[test]
fn whatever_signs_come_there_is_an_end() {
    let (mut named, mut closed) = (0, 0);
    for seed in 0..u64::from(predicament_effort::cases(3000)) {
        let shape = if seed % 2 == 0 { comb(3) } else { lattice(2) };
        let planes = planes(&shape, 4, seed % 16);
        let mut session = Whim { scene: shape.scene(), seed };
        let Ok(sliced) = shape.sliced(&mut session, &planes) else { continue };
        if sliced.broken.is_some() {
            named += 1;
        } else {
            closed += 1;
        }
    }
    assert!(named > 10, "{named} and {closed}");
}
