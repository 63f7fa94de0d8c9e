//! Tests of limits of perturbed results against counted cells.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use predicament_exact::Exact;
use predicament_judge::{Points, nearest};
use predicament_mesh::MaterialMesh;
use predicament_mesh_intersect::algorithm::limit::{Counts, Limit, limit};
use predicament_mesh_intersect::algorithm::overlay::{Zeros, mesh_overlay};
use predicament_mesh_intersect::truth;
use predicament_mesh_intersect::truth::contacts::{Touching, contacts as touching_of};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::PerMesh;
use rug::Rational;

use crate::common::shapes::Random;

type Cell = [i64; 3];

/// Cubes of a lattice: the length of their edges, the origin of the lattice, and the cubes present.
#[derive(Clone, Debug)]
struct Cubes {
    size: i64,
    from: Cell,
    cells: BTreeSet<Cell>,
}

impl Cubes {
    fn random(random: &mut Random, size: i64, from: Cell, along: i64) -> Cubes {
        let mut cells = BTreeSet::new();
        for x in 0..along {
            for y in 0..along {
                for z in 0..along {
                    if random.whole(1) == 0.0 {
                        cells.insert([x, y, z]);
                    }
                }
            }
        }
        cells.insert([0, 0, 0]);
        Cubes { size, from, cells }
    }

    /// Its unit cells.
    fn units(&self) -> BTreeSet<Cell> {
        let unit = |cell: &Cell| {
            let low = [0, 1, 2].map(|i: usize| self.from[i] + cell[i] * self.size);
            let size = self.size;
            (0..size.pow(3)).map(move |at| [low[0] + at / size / size, low[1] + at / size % size, low[2] + at % size])
        };
        self.cells.iter().flat_map(unit).collect()
    }

    /// Its surface: two triangles for each square, divided along either diagonal.
    fn surface(&self, random: &mut Random) -> (Vec<Cell>, Vec<[usize; 3]>) {
        let (mut points, mut triangles, mut known) = (Vec::new(), Vec::new(), BTreeMap::new());
        for cell in &self.cells {
            for axis in 0..3 {
                for up in [0, 1] {
                    let mut beside = *cell;
                    beside[axis] += 2 * up - 1;
                    if self.cells.contains(&beside) {
                        continue;
                    }
                    let mut corner = |i: i64, j: i64| {
                        let mut at = *cell;
                        at[axis] += up;
                        at[(axis + 1) % 3] += i;
                        at[(axis + 2) % 3] += j;
                        let at = [0, 1, 2].map(|i: usize| self.from[i] + at[i] * self.size);
                        *known.entry(at).or_insert_with(|| {
                            points.push(at);
                            points.len() - 1
                        })
                    };
                    let mut square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    if up == 0 {
                        square.reverse();
                    }
                    square.rotate_left(usize::from(random.whole(1) == 0.0));
                    let [a, b, c, d] = square;
                    triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
        (points, triangles)
    }
}

/// The number of squares between cells of a set and others.
fn squares(cells: &BTreeSet<Cell>) -> usize {
    let beside = |cell: &Cell| {
        (0..6)
            .filter(|&way| {
                let mut beside = *cell;
                beside[way / 2] += if way % 2 == 0 { 1 } else { -1 };
                !cells.contains(&beside)
            })
            .count()
    };
    cells.iter().map(beside).sum()
}

/// Two sets of cubes in one scene.
struct Pair {
    scene: Scene,
    meshes: [Arc<MaterialMesh>; 2],
}

impl Pair {
    fn new(cubes: [&Cubes; 2], random: &mut Random) -> Pair {
        let [first, second] = cubes.map(|cubes| cubes.surface(random));
        let points: Vec<[f64; 3]> =
            first.0.iter().chain(&second.0).map(|p| p.map(|x| f64::from(i32::try_from(x).unwrap()))).collect();
        let before = first.0.len();
        let scene = Scene::from_points3(&points).unwrap().with_second_mesh((before..points.len()).map(Vertex::input));
        let mesh = |triangles: Vec<[usize; 3]>, by: usize| {
            let triangles = triangles.into_iter().map(|t| t.map(|at| Vertex::input(at + by))).collect();
            Arc::new(MaterialMesh::of_closed(points.len(), triangles).unwrap())
        };
        let meshes = [mesh(first.1, 0), mesh(second.1, before)];
        Pair { scene, meshes }
    }

    /// The limit of a result by a backend that moves the second mesh.
    fn limit(&self, operation: Operation) -> Result<(Limit, Scene), String> {
        self.limit_by(&mut PerMesh.prepare(&self.scene, Off).unwrap(), operation)
    }

    /// The result without any move, as a limit that changes nothing.
    fn exactly(&self, operation: Operation) -> Result<(Limit, Scene), String> {
        let (limit, scene) = self.limit_by(&mut Exact.prepare(&self.scene, Off).unwrap(), operation)?;
        let is_same = limit.counts == Counts::default();
        if is_same { Ok((limit, scene)) } else { Err(format!("it is not regular: {:?}", limit.counts)) }
    }

    fn limit_by(&self, session: &mut dyn Predicates, operation: Operation) -> Result<(Limit, Scene), String> {
        let overlay = mesh_overlay(session, self.meshes.clone(), Zeros::Zero).map_err(|why| why.to_string())?;
        let perturbed = session.scene().clone();
        let mut exact = Exact.prepare(&perturbed, Off).unwrap();
        let limit = limit(&mut exact, &overlay, overlay.solid(operation)).map_err(|why| why.to_string())?;
        Ok((limit, exact.scene().clone()))
    }
}

/// The position of a vertex of a scene.
fn place(scene: &Scene, v: Vertex) -> [Rational; 3] {
    let mut points = Points::of(scene);
    let point = match scene.construction(v) {
        None => scene.point3(v).map(predicament_judge::rational).to_vec(),
        Some(definition) => {
            let v = points.construct(&[*definition]).unwrap()[0];
            points.point(v).unwrap().into_owned()
        }
    };
    point.try_into().unwrap()
}

/// The normal of a triangle, of the length of twice its area.
fn normal([a, b, c]: [&[Rational; 3]; 3]) -> [Rational; 3] {
    let minor = |i: usize, j: usize| {
        let minus = |p: &[Rational; 3], i: usize| Rational::from(&p[i] - &a[i]);
        minus(b, i) * minus(c, j) - minus(b, j) * minus(c, i)
    };
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn dot(p: &[Rational; 3], q: &[Rational; 3]) -> Rational {
    p.iter().zip(q).map(|(p, q)| Rational::from(p * q)).sum()
}

/// The flaw of a limit of these meshes, given the right numbers of unit cells and of squares around them.
fn flaw(limit: &Limit, scene: &Scene, meshes: &[Arc<MaterialMesh>; 2], cells: usize, squares: usize) -> Option<String> {
    let mut place = BTreeMap::new();
    for &v in limit.solid.triangles.as_flattened() {
        place.entry(v).or_insert_with(|| self::place(scene, v));
    }
    for (&v, point) in &place {
        assert_eq!(limit.places.nearest(scene, v), point.each_ref().map(nearest));
        assert!(limit.places.is_exact(v));
    }
    let mut edges: BTreeMap<[Vertex; 2], i32> = BTreeMap::new();
    let (mut volume, mut area) = (Rational::new(), Rational::new());
    let labels = limit.solid.sources.iter().zip(&limit.solid.turned);
    if [limit.solid.sources.len(), limit.solid.turned.len()] != [limit.solid.triangles.len(); 2] {
        return Some("not each triangle has a source".to_owned());
    }
    for (triangle, (source, is_turned)) in limit.solid.triangles.iter().zip(labels) {
        let corners = triangle.map(|v| &place[&v]);
        let normal = normal(corners);
        let own: Rational = normal.iter().map(|x| x.clone().abs()).sum();
        if own == 0 {
            return Some(format!("a triangle has no area: {triangle:?}"));
        }
        let of = meshes[usize::from(source.mesh)].triangles()[source.triangle as usize];
        let of = of.map(|v| self::place(scene, v));
        let of_source = self::normal(of.each_ref());
        let is_on_source = corners.iter().all(|corner| dot(&of_source, corner) == dot(&of_source, &of[0]));
        if !is_on_source || (dot(&normal, &of_source) < 0) != *is_turned {
            return Some(format!("{triangle:?} is not of its source, {source:?}, turned: {is_turned}"));
        }
        area += own / 2;
        volume += dot(&normal, corners[0]) / 6_u32;
        let [a, b, c] = *triangle;
        for [a, b] in [[a, b], [b, c], [c, a]] {
            *edges.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    if edges.values().any(|uses| *uses != 0) {
        return Some("the surface is open".to_owned());
    }
    let different: BTreeSet<&[Rational; 3]> = place.values().collect();
    if different.len() != place.len() {
        return Some("two vertices at one place".to_owned());
    }
    let found = [volume, area];
    let wanted = [cells, squares].map(Rational::from);
    (found != wanted).then(|| format!("volume and area are {found:?}, not {wanted:?}"))
}

fn combined(operation: Operation, [a, b]: &[BTreeSet<Cell>; 2]) -> BTreeSet<Cell> {
    a.union(b).filter(|cell| operation.holds([a.contains(*cell), b.contains(*cell)])).copied().collect()
}

/// The flaws of the limits of many pairs, and statistics of the limits.
fn flaws(cases: u64) -> (Vec<String>, Counts) {
    let (mut flaws, mut all) = (Vec::new(), Counts::default());
    for seed in 0..cases {
        let mut random = Random(seed + 1);
        let size = |random: &mut Random| if random.whole(1) == 0.0 { 1 } else { 2 };
        let sizes = [size(&mut random), 1 + size(&mut random)];
        let offset = [(); 3].map(|()| if random.whole(1) == 0.0 { 0 } else { 1 });
        let first = Cubes::random(&mut random, sizes[0], [0; 3], 3);
        let second = Cubes::random(&mut random, sizes[1], offset, 2);
        let pair = Pair::new([&first, &second], &mut random);
        let units = [first.units(), second.units()];
        for operation in Operation::ALL {
            let cells = combined(operation, &units);
            let why = match pair.limit(operation) {
                Err(why) => Some(why),
                Ok((limit, scene)) => {
                    let Counts { merged, flat, cancelled, covered, divided } = limit.counts;
                    all.merged += merged;
                    all.flat += flat;
                    all.cancelled += cancelled;
                    all.covered += covered;
                    all.divided += divided;
                    flaw(&limit, &scene, &pair.meshes, cells.len(), squares(&cells))
                }
            };
            flaws.extend(why.map(|why| format!("{seed}, {}: {why}", operation.name())));
            let why = match pair.exactly(operation) {
                Err(why) => Some(why),
                Ok((limit, scene)) => flaw(&limit, &scene, &pair.meshes, cells.len(), squares(&cells)),
            };
            flaws.extend(why.map(|why| format!("{seed}, {} exactly: {why}", operation.name())));
        }
    }
    (flaws, all)
}

/// The area, the length and the number of points where two sets of cells touch without a common cell beside.
fn touching([a, b]: &[BTreeSet<Cell>; 2]) -> [usize; 3] {
    // Around a square, an edge or a corner are the cells before and after it along each axis across it.
    let around = |at: Cell, across: &[usize]| -> Vec<Cell> {
        let mut cells = vec![at];
        for &axis in across {
            let before: Vec<Cell> = cells.iter().map(|&cell| moved(cell, axis, -1)).collect();
            cells.extend(before);
        }
        cells
    };
    let touch = |at: Cell, across: &[usize]| {
        let cells = around(at, across);
        let has = |set: &BTreeSet<Cell>| cells.iter().any(|cell| set.contains(cell));
        has(a) && has(b) && !cells.iter().any(|cell| a.contains(cell) && b.contains(cell))
    };
    // The squares at an edge along an axis, and the edges at a corner, each by the cell after it.
    let squares_at = |at: Cell, axis: usize| -> Vec<(Cell, usize)> {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        vec![(at, u), (moved(at, v, -1), u), (at, v), (moved(at, u, -1), v)]
    };
    let edges_at = |at: Cell| (0..3).flat_map(move |axis| [(at, axis), (moved(at, axis, -1), axis)]);
    let is_square = |(at, axis): (Cell, usize)| touch(at, &[axis]);
    let is_edge = |(at, axis): (Cell, usize)| {
        touch(at, &[(axis + 1) % 3, (axis + 2) % 3]) && !squares_at(at, axis).into_iter().any(is_square)
    };
    let is_corner = |at: Cell| {
        let squares = || edges_at(at).flat_map(|(at, axis)| squares_at(at, axis));
        touch(at, &[0, 1, 2]) && !edges_at(at).any(is_edge) && !squares().any(is_square)
    };
    let range = || 0..7_i64;
    let all = || range().flat_map(move |x| range().flat_map(move |y| range().map(move |z| [x, y, z])));
    let along = |holds: &dyn Fn((Cell, usize)) -> bool| {
        all().flat_map(|at| (0..3).map(move |axis| (at, axis))).filter(|&one| holds(one)).count()
    };
    [along(&is_square), along(&is_edge), all().filter(|&at| is_corner(at)).count()]
}

fn moved(mut cell: Cell, axis: usize, by: i64) -> Cell {
    cell[axis] += by;
    cell
}

/// The area of triangles, the length of segments, both along axes, and the number of points.
fn measures(
    triangles: impl Iterator<Item = [[Rational; 3]; 3]>,
    segments: impl Iterator<Item = [[Rational; 3]; 2]>,
    points: usize,
) -> [Rational; 3] {
    let minus = |p: &[Rational; 3], q: &[Rational; 3]| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &q[i]));
    let area = triangles.fold(Rational::new(), |sum, [a, b, c]| {
        let [p, q] = [minus(&b, &a), minus(&c, &a)];
        let minor = |i: usize, j: usize| Rational::from(&p[i] * &q[j]) - Rational::from(&p[j] * &q[i]);
        sum + (minor(0, 1).abs() + minor(1, 2).abs() + minor(2, 0).abs()) / 2
    });
    let length = segments
        .fold(Rational::new(), |sum, [a, b]| sum + minus(&a, &b).into_iter().map(Rational::abs).sum::<Rational>());
    [area, length, Rational::from(points)]
}

#[test]
fn contacts_of_cubes_are_counted() {
    let mut seen = [0; 3];
    for seed in 0..predicament_effort::some_or_all(30, 1_000) {
        let mut random = Random(seed + 1);
        let offset = [(); 3].map(|()| i64::from(random.whole(1) == 0.0));
        let first = Cubes::random(&mut random, 1, [0; 3], 3);
        let second = Cubes::random(&mut random, 2, offset, 2);
        let units = [first.units(), second.units()];
        // Without the cells of the first one, so that there are contacts.
        let apart = Cubes { size: 1, from: [0; 3], cells: units[1].difference(&units[0]).copied().collect() };
        for second in [&second, &apart] {
            if second.cells.is_empty() {
                continue;
            }
            let pair = Pair::new([&first, second], &mut random);
            let mut session = Exact.prepare(&pair.scene, Off).unwrap();
            let contacts = mesh_overlay(&mut session, pair.meshes.clone(), Zeros::Zero).unwrap().contacts();
            let at = |v: Vertex| place(session.scene(), v);
            let triangles = contacts.faces.iter().flat_map(|face| &face.triangles).map(|of| of.map(at));
            let segments = contacts.segments.iter().map(|ends| ends.map(at));
            let found = measures(triangles, segments, contacts.points.len());
            let counted = touching(&[first.units(), second.units()]);
            let wanted = counted.map(Rational::from);
            assert_eq!(found, wanted, "{seed}: {first:?} and {second:?}");
            // The truth of the judge compares all pairs of triangles.
            if seed % 10 == 0 {
                let Touching { faces, segments, points } =
                    touching_of(&truth::given(&pair.scene), pair.meshes.each_ref().map(|mesh| &**mesh)).unwrap();
                let fan = |(_, polygon): ([u32; 2], Vec<[Rational; 3]>)| {
                    let corners = |at: usize| [0, at, at + 1].map(|at| polygon[at].clone());
                    (1..polygon.len() - 1).map(corners).collect::<Vec<_>>()
                };
                let of_truth = measures(faces.into_iter().flat_map(fan), segments.into_iter(), points.len());
                assert_eq!(of_truth, wanted, "{seed}: {first:?} and {second:?}");
            }
            (0..3).for_each(|kind| seen[kind] += counted[kind]);
        }
    }
    assert!(seen.iter().all(|count| *count > 1), "{seen:?}");
}

#[test]
fn limits_of_cubes_are_their_cells() {
    let (flaws, counts) = flaws(predicament_effort::some_or_all(24, 2_000));
    assert!(flaws.is_empty(), "{} flaws, first: {}", flaws.len(), flaws[0]);
    let Counts { merged, flat, cancelled, covered, divided } = counts;
    assert!([merged, flat, cancelled, covered, divided].iter().all(|count| *count > 0), "{counts:?}");
}
