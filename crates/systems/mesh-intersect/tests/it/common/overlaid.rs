//! Laws of every overlay of two meshes, in rationals.

use std::collections::BTreeMap;

use predicament_judge::solids::{Materials, Place};
use predicament_judge::{Points, rational};
use predicament_mesh_intersect::algorithm::overlay::{MeshOverlay, Regions, Source, Undone, Zeros, mesh_overlay};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Predicates, Scene, Vertex};
use rug::Rational;

use super::shapes::Shape;
use super::volumes::{Point, Surface, area, common, cross, dot, minus, volume};

/// Two meshes in one scene, the second of which may move, with the true volumes of their intersections.
pub struct Pair {
    pub shapes: [Shape; 2],
    pub scene: Scene,
    /// The volumes of all regions of either mesh.
    volumes: [Vec<Rational>; 2],
    /// The volume of the intersection of a region of the first mesh and one of the second, by both.
    common: BTreeMap<[u32; 2], Rational>,
}

/// Statistics of a checked overlay.
#[derive(Clone, Copy, Default, Debug)]
pub struct Seen {
    pub done: usize,
    pub refused: usize,
    /// Constructed vertices, triangles whose region the judge confirmed, and triangles of no area.
    pub constructed: usize,
    pub located: usize,
    pub flat: usize,
}

impl std::ops::AddAssign for Seen {
    fn add_assign(&mut self, other: Seen) {
        self.done += other.done;
        self.refused += other.refused;
        self.constructed += other.constructed;
        self.located += other.located;
        self.flat += other.flat;
    }
}

impl Pair {
    /// A pair whose volumes are not known.
    pub fn without_truth(first: Shape, second: Shape) -> Pair {
        let points = [&first.points[..], &second.points].concat();
        let moving = (first.points.len()..points.len()).map(Vertex::input);
        let scene = Scene::from_points3(&points).unwrap().with_second_mesh(moving);
        Pair { shapes: [first, second], scene, volumes: [Vec::new(), Vec::new()], common: BTreeMap::new() }
    }

    pub fn new(first: Shape, second: Shape) -> Pair {
        let pair = Pair::without_truth(first, second);
        let first = &pair.shapes[0];
        // Inside the first, not in any plane of small integers.
        let apex = [0, 1, 2].map(|i: usize| {
            let along = || first.points.iter().map(|p| p[i]);
            let [low, high] = [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)];
            rational(f64::midpoint(low, high).round() + [0.375, 0.28125, 0.2421875][i])
        });
        let boundaries =
            pair.shapes.each_ref().map(|shape| shape.regions().map(|region| shape.boundary(region)).collect());
        let [a, b]: &[Vec<Surface>; 2] = &boundaries;
        let volumes = [a, b].map(|regions| regions.iter().map(|surface| volume(surface)).collect());
        let mut all = BTreeMap::new();
        for (i, a) in (1..).zip(a) {
            for (j, b) in (1..).zip(b) {
                all.insert([i, j], common(a, b, &apex));
            }
        }
        Pair { volumes, common: all, ..pair }
    }

    pub fn meshes(&self) -> [std::sync::Arc<predicament_mesh::MaterialMesh>; 2] {
        let [a, b] = &self.shapes;
        [a.mesh(0, self.scene.len()), b.mesh(a.points.len(), self.scene.len())].map(std::sync::Arc::new)
    }

    /// The volume of the intersection.
    pub fn common(&self) -> Rational {
        self.common.values().sum()
    }

    /// Overlays the meshes and asserts all laws.
    pub fn check(&self, session: &mut dyn Predicates, zeros: Zeros) -> Seen {
        match mesh_overlay(session, self.meshes(), zeros) {
            Ok(overlay) => self.laws(session.scene(), &overlay),
            Err(Undone::Contact(simplices)) => panic!("{simplices:?}: signs register nothing"),
            Err(Undone::Refused(_)) => Seen { refused: 1, ..Seen::default() },
            Err(own @ Undone::Own { .. }) => panic!("{own}: {:?}", self.shapes),
            Err(Undone::Broken(rule)) => panic!("{rule}: {:?}", self.shapes),
        }
    }

    /// Asserts all laws of a finished overlay.
    pub fn laws(&self, scene: &Scene, overlay: &MeshOverlay) -> Seen {
        let points = Points::of(scene);
        let input = (0..scene.len()).map(Vertex::input);
        let constructed = (0..scene.constructions().len()).map(Vertex::constructed);
        let place: BTreeMap<Vertex, Point> =
            input.chain(constructed).map(|v| (v, points.point(v).unwrap().into_owned().try_into().unwrap())).collect();
        let at = |triangle: &[Vertex; 3]| triangle.map(|v| place[&v].clone());
        let inside = [0, 1].map(|mesh: usize| self.volumes[mesh].iter().sum::<Rational>());
        let both = self.common();
        let regions = overlay.regions();
        let each = regions.triangles.iter().zip(&regions.sources);
        let volumes: BTreeMap<([Vertex; 3], Source), Rational> =
            each.map(|(triangle, source)| ((*triangle, *source), volume(&[at(triangle)]))).collect();
        for operation in Operation::ALL {
            let solid = overlay.solid(operation);
            let wanted = match operation {
                Operation::Union => Rational::from(&inside[0] + &inside[1]) - &both,
                Operation::Intersection => both.clone(),
                Operation::Difference => Rational::from(&inside[0] - &both),
                Operation::SymmetricDifference => Rational::from(&inside[0] + &inside[1]) - &both - &both,
            };
            let uses = solid.triangles.iter().map(|triangle| (*triangle, 1));
            assert!(is_closed(uses), "{operation:?} of {:?}", self.shapes);
            let turned = solid.triangles.iter().zip(&solid.sources).map(|(&[a, b, c], source)| {
                let same = volumes.get(&([a, b, c], *source)).cloned();
                same.unwrap_or_else(|| -volumes[&([a, c, b], *source)].clone())
            });
            assert_eq!(turned.sum::<Rational>(), wanted, "{operation:?} of {:?}", self.shapes);
        }
        self.assert_regions(&regions, &volumes);
        self.assert_parts(&regions, &at);
        let (located, flat) = self.located(&regions, &at);
        Seen { done: 1, constructed: scene.constructions().len(), located, flat, ..Seen::default() }
    }

    fn source(&self, mesh: usize, triangle: usize) -> [Point; 3] {
        self.shapes[mesh].triangles[triangle].map(|at| self.shapes[mesh].points[at].map(rational))
    }

    /// Asserts that a triangle is in a triangle of a mesh.
    fn assert_of(&self, corners: &[Point; 3], mesh: usize, triangle: usize) {
        let source = self.source(mesh, triangle);
        let normal = area(&source);
        for p in corners {
            assert!(dot(&normal, &minus(p, &source[0])).cmp0().is_eq(), "in the plane: {:?}", self.shapes);
            for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                let side = area(&[source[i].clone(), source[j].clone(), p.clone()]);
                assert!(dot(&side, &normal).cmp0().is_ge(), "within: {:?}", self.shapes);
            }
        }
    }

    /// Asserts that each region of the result is closed and has the right volume.
    fn assert_regions(&self, regions: &Regions, volumes: &BTreeMap<([Vertex; 3], Source), Rational>) {
        assert_eq!(regions.pairs[0], [0, 0]);
        assert!(regions.pairs.is_sorted() && regions.sides.iter().all(|[front, behind]| front != behind));
        for (number, pair) in (0..).zip(&regions.pairs) {
            let way = |&[front, behind]: &[u32; 2]| i32::from(behind == number) - i32::from(front == number);
            let ways =
                || regions.triangles.iter().copied().zip(regions.sides.iter().map(way)).filter(|(_, way)| *way != 0);
            assert!(is_closed(ways()), "{pair:?} of {:?}", self.shapes);
            let each = regions.triangles.iter().zip(&regions.sources).zip(&regions.sides);
            let turned = each.filter(|(_, sides)| way(sides) != 0);
            let turned = turned.map(|((triangle, source), sides)| volumes[&(*triangle, *source)].clone() * way(sides));
            let found: Rational = turned.sum();
            let of = |mesh: usize| self.volumes[mesh].iter().sum::<Rational>();
            let by = |mesh: usize| {
                let with = self.common.iter().filter(|(of, _)| of[mesh] == pair[mesh]).map(|(_, common)| common);
                &self.volumes[mesh][pair[mesh] as usize - 1] - with.sum::<Rational>()
            };
            let wanted = match pair {
                [0, 0] => self.common() - of(0) - of(1),
                [_, 0] => by(0),
                [0, _] => by(1),
                pair => self.common[pair].clone(),
            };
            assert_eq!(found, wanted, "{pair:?} of {:?}", self.shapes);
        }
        for (pair, common) in &self.common {
            assert!(regions.pairs.contains(pair) || common.cmp0().is_eq(), "{pair:?} of {:?}", self.shapes);
        }
    }

    /// Asserts that pieces of a triangle are in it, have its orientation, and its area together.
    fn assert_parts(&self, regions: &Regions, at: &dyn Fn(&[Vertex; 3]) -> [Point; 3]) {
        let mut areas: BTreeMap<[usize; 2], Point> = BTreeMap::new();
        let alone = regions.triangles.len() - regions.also.len();
        let of_both = regions.triangles[alone..].iter().zip(regions.also.iter().map(|&at| (1, at as usize)));
        let all =
            regions.triangles.iter().zip(regions.sources.iter().map(|of| (usize::from(of.mesh), of.triangle as usize)));
        for (place, (triangle, (mesh, of))) in all.chain(of_both).enumerate() {
            let [corners, normal] = [at(triangle), self.source(mesh, of)];
            self.assert_of(&corners, mesh, of);
            let mut area = area(&corners);
            let is_turned = dot(&area, &super::volumes::area(&normal)).cmp0().is_lt();
            if is_turned && place >= regions.triangles.len() {
                area.iter_mut().for_each(|x| *x = -x.clone());
            } else {
                assert!(!is_turned, "turned over: {:?}", self.shapes);
            }
            let sum = areas.entry([mesh, of]).or_default();
            sum.iter_mut().zip(&area).for_each(|(sum, x)| *sum += x);
        }
        for mesh in [0, 1] {
            for of in 0..self.shapes[mesh].triangles.len() {
                assert_eq!(areas[&[mesh, of]], area(&self.source(mesh, of)), "all of a triangle: {:?}", self.shapes);
            }
        }
    }

    /// Compares the regions of triangles with the judge, if points around the centroid are all in one region of the
    /// other mesh; returns the number of compared triangles, and of those without area.
    fn located(&self, regions: &Regions, at: &dyn Fn(&[Vertex; 3]) -> [Point; 3]) -> (usize, usize) {
        let (mut queries, mut flat) = (Vec::new(), 0);
        for (place, triangle) in regions.triangles.iter().enumerate() {
            let corners = at(triangle);
            if cross(&minus(&corners[1], &corners[0]), &minus(&corners[2], &corners[0]))
                .iter()
                .all(|x| x.cmp0().is_eq())
            {
                flat += 1;
                continue;
            }
            let is_whole = triangle.iter().all(|v| !v.is_constructed());
            let is_alone = place + regions.also.len() < regions.triangles.len();
            if is_alone && (place % 5 == 0 || !is_whole && place % 3 == 0) {
                let centroid = [0, 1, 2]
                    .map(|i: usize| (Rational::from(&corners[0][i] + &corners[1][i]) + &corners[2][i]).to_f64() / 3.0);
                queries.push((place, centroid));
            }
        }
        let around = |&(_, p): &(usize, [f64; 3])| {
            let step = |i: usize, corner: u8| if corner >> i & 1 == 0 { -1e-8 } else { 1e-8 };
            (0..8).map(move |corner| [0, 1, 2].map(|i: usize| p[i] + step(i, corner)))
        };
        let first = self.scene.len();
        let mut points: Vec<[f64; 3]> = (0..first).map(|v| self.scene.point3(Vertex::input(v))).collect();
        points.extend(queries.iter().flat_map(around));
        let scene = Scene::from_points3(&points).unwrap();
        let meshes = self.meshes();
        let mut located = 0;
        for (&(place, centroid), query) in queries.iter().zip((first..).step_by(8)) {
            let mesh = usize::from(regions.sources[place].mesh);
            let other = &meshes[1 - mesh];
            let judge = Materials::new(&scene, other.triangles(), other.sides());
            let region = regions.pairs[regions.sides[place][0] as usize][1 - mesh];
            let place = |corner: usize| judge.locate(Vertex::input(query + corner));
            let Place::In(truth) = place(0) else { continue };
            if (1..8).all(|corner| place(corner) == Place::In(truth)) {
                assert_eq!(region, truth, "{centroid:?} of {:?}", self.shapes);
                located += 1;
            }
        }
        (located, flat)
    }

    /// True if anything touches.
    pub fn is_degenerate(&self) -> bool {
        let meshes = &self.meshes();
        let mut pairs = (0..2).flat_map(|mesh| {
            let edges = meshes[mesh].triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
            let edges = edges.filter(|[a, b]| a < b);
            edges.flat_map(move |edge| meshes[1 - mesh].triangles().iter().map(move |&triangle| (edge, triangle)))
        });
        pairs.any(|(edge, triangle)| self.touches(edge, triangle))
    }

    fn touches(&self, edge: [Vertex; 2], triangle: [Vertex; 3]) -> bool {
        let doubles = |v: Vertex| self.scene.point3(v);
        let [ends, corners] = [edge.map(doubles).to_vec(), triangle.map(doubles).to_vec()];
        let is_apart = |i: usize| {
            let beyond = |a: &[[f64; 3]], b: &[[f64; 3]]| a.iter().all(|p| b.iter().all(|q| p[i] < q[i]));
            beyond(&ends, &corners) || beyond(&corners, &ends)
        };
        if (0..3).any(is_apart) {
            return false;
        }
        let [p, q] = edge.map(|v| doubles(v).map(rational));
        let corners = triangle.map(|v| doubles(v).map(rational));
        let normal = area(&corners);
        // The sides of a point on the planes through the edges of the triangle, perpendicular to it.
        let beside = |p: &Point| {
            [(0, 1), (1, 2), (2, 0)]
                .map(|(i, j)| dot(&normal, &area(&[corners[i].clone(), corners[j].clone(), p.clone()])))
        };
        let [at_p, at_q] = [&p, &q].map(|p| dot(&normal, &minus(p, &corners[0])));
        if at_p.cmp0().is_eq() && at_q.cmp0().is_eq() {
            // The part of the edge within all three sides, as fractions of its length.
            let (mut from, mut to) = (Rational::new(), Rational::from(1));
            for (start, end) in beside(&p).iter().zip(&beside(&q)) {
                match (start.cmp0().is_ge(), end.cmp0().is_ge()) {
                    (true, true) => {}
                    (false, false) => return false,
                    (enters, _) => {
                        let at = start / Rational::from(start - end);
                        if enters { to = to.min(at) } else { from = from.max(at) }
                    }
                }
            }
            return from <= to;
        }
        if at_p.cmp0() == at_q.cmp0() {
            return false;
        }
        let fraction = &at_p / Rational::from(&at_p - &at_q);
        let way = minus(&q, &p);
        let meet = [0, 1, 2].map(|i: usize| &p[i] + Rational::from(&way[i] * &fraction));
        if fraction.cmp0().is_lt() || fraction > 1 {
            return false;
        }
        let beside = beside(&meet).map(|x| x.cmp0());
        let is_through = beside.iter().all(|side| side.is_gt()) && at_p.cmp0() == at_q.cmp0().reverse();
        beside.iter().all(|side| side.is_ge()) && !is_through
    }
}

/// True if each edge is used equally often in both directions, with these multiplicities of triangles, and no triangle
/// has a vertex twice.
pub fn is_closed(triangles: impl Iterator<Item = ([Vertex; 3], i32)>) -> bool {
    let mut uses: BTreeMap<[Vertex; 2], i32> = BTreeMap::new();
    for ([a, b, c], times) in triangles {
        for [a, b] in [[a, b], [b, c], [c, a]] {
            if a == b {
                return false;
            }
            *uses.entry([a.min(b), a.max(b)]).or_default() += if a < b { times } else { -times };
        }
    }
    uses.values().all(|&sum| sum == 0)
}
