//! Points in multi-material meshes: the judge's two computations against each other, and both against known results.
//!
//! Both add up crossings in the same way, so a third computation checks the sums too: the location of a point in each
//! of the tetrahedra whose sum is the mesh.

use std::collections::BTreeMap;

use predicament_effort::some_or_all;
use predicament_judge::sign;
use predicament_judge::solids::{Materials, Place};
use predicament_predicates::{Question, Scene, Sign, Vertex};

use crate::random::{Grid, Random};

/// The maximum number of ray directions tried for a point; the last ones are drawn from 2001³.
const TRIES: usize = 8;

/// A sum of closed surfaces, any of which may cross itself and the others.
#[derive(Default)]
struct Chain {
    points: Vec<[f64; 3]>,
    triangles: Vec<[Vertex; 3]>,
    sides: Vec<[u32; 2]>,
    /// The tetrahedra whose faces are the triangles (four triangles each), if the chain was made from tetrahedra.
    tetrahedra: Vec<[Vertex; 4]>,
}

/// The faces of a tetrahedron, counterclockwise as seen from outside if `orient3d` of its corners is positive.
fn faces([a, b, c, d]: [Vertex; 4]) -> [[Vertex; 3]; 4] {
    [[a, b, c], [b, a, d], [c, b, d], [a, c, d]]
}

impl Chain {
    /// Random tetrahedra over common points, of either orientation, between any two regions.
    fn of_tetrahedra(random: &mut Random, grid: Grid) -> Chain {
        let count = 4 + random.below(5);
        let end = 2 + random.below(6);
        let mut chain = Chain::default();
        chain.add_points(random, grid, count, end);
        for _ in 0..1 + random.below(4) {
            let mut of: Vec<usize> = (0..count).collect();
            let corners = [(); 4].map(|()| Vertex::input(of.swap_remove(random.below(of.len()))));
            let sides = regions(random);
            chain.tetrahedra.push(corners);
            chain.triangles.extend(faces(corners));
            chain.sides.extend([sides; 4]);
        }
        chain
    }

    /// Tori of a few triangles each, with vertices at random positions.
    fn of_tori(random: &mut Random, grid: Grid) -> Chain {
        let mut chain = Chain::default();
        for _ in 0..1 + random.below(2) {
            let first = chain.points.len();
            let [rows, columns] = [3, 3 + random.below(2)];
            let end = 2 + random.below(8);
            chain.add_points(random, grid, rows * columns, end);
            let at = |i: usize, j: usize| Vertex::input(first + i % rows * columns + j % columns);
            let sides = regions(random);
            for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                chain.triangles.extend([[a, b, c], [a, c, d]]);
                chain.sides.extend([sides; 2]);
            }
        }
        chain
    }

    /// Cubes around the origin with these half edge lengths, from the outermost inwards; inside each cube is the next
    /// region.
    fn nested(halves: &[f64]) -> Chain {
        let mut chain = Chain::default();
        for (region, half) in (0..).zip(halves) {
            let first = chain.points.len();
            let corner = |at: usize| [0, 1, 2].map(|axis: usize| if at >> axis & 1 == 0 { -half } else { *half });
            chain.points.extend((0..8).map(corner));
            for [a, b, c, d] in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
                let [a, b, c, d] = [a, b, c, d].map(|corner: usize| Vertex::input(first + corner));
                chain.triangles.extend([[a, b, c], [a, c, d]]);
                chain.sides.extend([[region, region + 1]; 2]);
            }
        }
        chain
    }

    fn add_points(&mut self, random: &mut Random, grid: Grid, count: usize, end: usize) {
        let coordinates = grid.coordinates(random, 3 * count, end);
        self.points.extend_from_slice(coordinates.as_chunks().0);
    }

    /// A few points of each kind: vertices of the mesh, points on axis-parallel lines through it, points near both, and
    /// arbitrary points.
    fn probes(&self, random: &mut Random) -> Vec<[f64; 3]> {
        let mut probes: Vec<[f64; 3]> = Vec::new();
        for _ in 0..4 {
            let [a, b, c] = self.triangles[random.below(self.triangles.len())].map(|v| self.points[v.index()]);
            let middle = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|axis: usize| f64::midpoint(p[axis], q[axis]));
            let third = [0, 1, 2].map(|axis: usize| a[axis] / 3.0 + b[axis] / 3.0 + c[axis] / 3.0);
            for point in [a, middle(a, b), middle(a, middle(b, c)), third] {
                let mut beside = point;
                let x = &mut beside[random.below(3)];
                *x = if random.below(2) == 0 { x.next_up() } else { x.next_down() };
                let mut along = point;
                along[random.below(3)] = self.coordinate(random);
                probes.extend([point, beside, along]);
            }
        }
        // Between corners of two triangles, which may share an edge, a corner or nothing.
        for _ in 0..12 {
            let at = random.below(self.triangles.len());
            let of = [at, (at + 1) % self.triangles.len()].map(|at| self.triangles[at].map(|v| self.points[v.index()]));
            probes.push([0, 1, 2].map(|axis: usize| of.iter().flatten().map(|p| p[axis] / 6.0).sum()));
        }
        // Points of the lattice that the vertices span.
        probes.extend((0..8).map(|_| [(); 3].map(|()| self.coordinate(random))));
        probes
    }

    fn coordinate(&self, random: &mut Random) -> f64 {
        self.points[random.below(self.points.len())][random.below(3)]
    }
}

/// The regions in front and behind: usually outside is in front; sometimes both are the same region.
fn regions(random: &mut Random) -> [u32; 2] {
    [[0, 0, 0, 1, 2, 3], [1, 2, 3, 1, 2, 0]].map(|of| of[random.below(of.len())])
}

/// Counts of the locations found, and of ray directions that failed.
#[derive(Default, Debug)]
struct Counts {
    on: usize,
    of_region: BTreeMap<u32, usize>,
    windings: usize,
    again: usize,
}

/// Asserts that all computations agree about all probes; returns their locations.
fn agree(random: &mut Random, chain: &Chain, probes: &[[f64; 3]], counts: &mut Counts) -> Vec<Place> {
    let scene = Scene::from_points3(&[&chain.points[..], probes].concat()).unwrap();
    let materials = Materials::new(&scene, &chain.triangles, &chain.sides);
    let mut places = Vec::new();
    for q in (chain.points.len()..scene.len()).map(Vertex::input) {
        let place = materials.locate(q);
        let winding = (0..TRIES).find_map(|tries| {
            let most = [1, 2, 1000, 1000][tries.min(3)];
            let direction = [(); 3].map(|()| i32::try_from(random.below(2 * most + 1)).unwrap());
            let direction = direction.map(|x| x - i32::try_from(most).unwrap());
            let found = if direction == [0; 3] { None } else { materials.winding(q, direction) };
            counts.again += usize::from(found.is_none());
            found
        });
        let point = scene.point3(q);
        assert_eq!(winding.as_ref(), Some(&place), "{point:?} {:?} {:?}", chain.points, chain.triangles);
        if let Some(known) = by_tetrahedra(&scene, chain, q) {
            assert_eq!(place, known, "{point:?} {:?} {:?}", chain.points, chain.tetrahedra);
        }
        match &place {
            Place::On(_) => counts.on += 1,
            Place::In(region) => *counts.of_region.entry(*region).or_default() += 1,
            Place::Windings(_) => counts.windings += 1,
        }
        places.push(place);
    }
    places
}

/// The location of a point by definition: a tetrahedron that contains the point winds around it once, no other does.
///
/// Returns `None` if there are no tetrahedra, or some have no volume.
fn by_tetrahedra(scene: &Scene, chain: &Chain, q: Vertex) -> Option<Place> {
    let orient3d = |[a, b, c]: [Vertex; 3], d: Vertex| sign(scene, Question::Orient3d, &[a, b, c, d]);
    let (mut on, mut windings) = (Vec::new(), BTreeMap::from([(0_u32, 1_i64)]));
    for (at, &corners) in chain.tetrahedra.iter().enumerate() {
        let [a, b, c, d] = corners;
        let turn = orient3d([a, b, c], d);
        let sides = faces(corners).map(|face| orient3d(face, q) * turn);
        if turn == Sign::Zero {
            return None;
        }
        if sides.contains(&Sign::Negative) {
            continue;
        }
        let of_zeros = (0..4).filter(|&face| sides[face] == Sign::Zero);
        on.extend(of_zeros.map(|face| u32::try_from(4 * at + face).unwrap()));
        let [front, back] = chain.sides[4 * at];
        let by = if turn == Sign::Positive { 1 } else { -1 };
        *windings.entry(back).or_default() += by;
        *windings.entry(front).or_default() -= by;
    }
    let windings: Vec<(u32, i64)> = windings.into_iter().filter(|(_, winding)| *winding != 0).collect();
    let place = match windings[..] {
        _ if !on.is_empty() => Place::On(on),
        [(region, 1)] => Place::In(region),
        _ => Place::Windings(windings),
    };
    (!chain.tetrahedra.is_empty()).then_some(place)
}

fn agree_about(meshes: usize, make: impl Fn(&mut Random, Grid) -> Chain) -> Counts {
    let mut random = Random::new(20);
    let mut counts = Counts::default();
    for mesh in 0..meshes {
        let grid = [Grid::Whole, Grid::Whole, Grid::Fine, Grid::Wide][mesh % 4];
        let chain = make(&mut random, grid);
        let probes = chain.probes(&mut random);
        agree(&mut random, &chain, &probes, &mut counts);
    }
    counts
}

#[test]
fn tetrahedra_that_cross_and_share_corners() {
    let meshes = some_or_all(48, 480);
    let counts = agree_about(meshes, Chain::of_tetrahedra);
    println!("{counts:?}");
    assert!(counts.on > 10 * meshes && counts.windings > meshes && counts.again > meshes, "{counts:?}");
    assert!((1..4).all(|region| counts.of_region[&region] > meshes * 2 / 5), "{counts:?}");
}

#[test]
fn tori_that_cross_themselves() {
    let meshes = some_or_all(4, 120);
    let counts = agree_about(meshes, Chain::of_tori);
    println!("{counts:?}");
    assert!(counts.on > 10 * meshes && counts.windings > meshes && counts.again > meshes, "{counts:?}");
}

#[test]
fn cubes_in_each_other_are_told_apart_by_the_largest_coordinate() {
    let mut random = Random::new(21);
    let mut counts = Counts::default();
    for halves in [vec![8.0, 5.0, 4.5, 1.0], vec![1.0, 1.0_f64.next_down(), 1.0_f64.next_down().next_down()]] {
        let chain = Chain::nested(&halves);
        let mut probes = chain.probes(&mut random);
        probes.extend(halves.iter().flat_map(|half| [half.next_up(), half.next_down()]).map(|x| [0.5, -x, 0.25]));
        probes.extend([[0.0; 3], [9.0, 0.0, 1.0], [-6.0, 6.0, 0.0], [0.0, 4.75, 4.75], [2.0, -3.0, 3.5]]);
        let places = agree(&mut random, &chain, &probes, &mut counts);
        for (probe, place) in probes.iter().zip(places) {
            let out = probe.map(f64::abs).into_iter().fold(0.0, f64::max);
            let is_on = halves.contains(&out);
            let region = u32::try_from(halves.iter().filter(|&&half| half > out).count()).unwrap();
            assert!(matches!(place, Place::On(_)) == is_on && (is_on || place == Place::In(region)), "{probe:?}");
        }
    }
    assert!(counts.on > 40 && counts.of_region.len() == 5 && counts.windings == 0, "{counts:?}");
}

#[test]
fn a_triangle_without_area_is_met_by_its_points_only() {
    // A tetrahedron with a corner in the middle of an edge, and a triangle that closes the gap of zero width.
    let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0], [2.0, 0.0, 0.0]];
    let triangles = [[0, 2, 1], [0, 4, 3], [4, 1, 3], [1, 2, 3], [2, 0, 3], [0, 1, 4]];
    let chain = Chain {
        points: points.to_vec(),
        triangles: triangles.map(|corners| corners.map(Vertex::input)).to_vec(),
        sides: vec![[0, 1]; 6],
        tetrahedra: Vec::new(),
    };
    let probes =
        [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.5, 0.5], [1.0, 0.0, -1.0]];
    let places = agree(&mut Random::new(22), &chain, &probes, &mut Counts::default());
    let [outside, inside] = [0, 1].map(Place::In);
    let on = [vec![0, 1, 5], vec![0, 2, 5]].map(Place::On);
    assert_eq!(places, [&on[..], &[outside.clone(), outside.clone(), inside, outside]].concat());
}

#[test]
#[should_panic(expected = "a ray has a direction")]
fn a_ray_has_a_direction() {
    let chain = Chain::nested(&[1.0]);
    let scene = Scene::from_points3(&chain.points).unwrap();
    let _ = Materials::new(&scene, &chain.triangles, &chain.sides).winding(Vertex::input(0), [0; 3]);
}
