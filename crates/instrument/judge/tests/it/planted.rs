//! Faults planted in algorithms: each is caught by the truth of its task, and
//! the honest algorithm is not, on the same scenes.

use std::collections::BTreeSet;

use predicament_algorithms::contacts::contacts_planted;
use predicament_algorithms::contacts::planted::{self as of_contacts, ForgottenSubPairs, LostSubPair};
use predicament_algorithms::cube_union::planted::{self as of_cubes, DroppedBorderCube};
use predicament_algorithms::cube_union::{ScaledCubes, cube_union_planted};
use predicament_algorithms::interval::planted::{self as of_cells, ClosedInterval};
use predicament_algorithms::interval::{Place, cells_at_planted};
use predicament_algorithms::planted::Honest;
use predicament_algorithms::polygon_locate::planted::{self as of_maps, SkippedEdge};
use predicament_algorithms::polygon_locate::{LocateIndex, Scratch};
use predicament_exact::Exact;
use predicament_judge::contacts::registered_twice;
use predicament_judge::cubes::Cubes;
use predicament_judge::interval;
use predicament_judge::locate::Borders;
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Axis, Backend, Dimension, Off, Plane, Predicates, Scene, Vertex, forward_to};

use crate::contacts::of_judge;
use crate::cubes::in_scene_units;
use crate::random::{Grid, Random, complexes, cubes, map};

/// In how many of so many scenes the truth catches an algorithm.
fn caught(scenes: usize, mut is_caught: impl FnMut(&mut Random) -> bool) -> usize {
    let mut random = Random::new(10);
    (0..scenes).filter(|_| is_caught(&mut random)).count()
}

fn contacts_of<F: of_contacts::Planted, S: Predicates>(session: &S, [a, b]: [&Complex; 2]) -> Vec<[Vec<Vertex>; 2]> {
    let of = contacts_planted::<F, S>(session, a, b);
    of.registered.iter().map(|c| [a.vertices_of(c.a).to_vec(), b.vertices_of(c.b).to_vec()]).collect()
}

#[test]
fn a_lost_sub_pair_is_caught() {
    fn is_caught<F: of_contacts::Planted>(random: &mut Random) -> bool {
        let (scene, [a, b]) = complexes(random, Dimension::Three, Grid::Whole);
        let session = Exact.prepare(&scene, Off).unwrap();
        let found: BTreeSet<_> = contacts_of::<F, _>(&session, [&a, &b]).into_iter().collect();
        found != of_judge(&scene, [&a, &b])
    }
    assert_eq!(caught(100, is_caught::<Honest>), 0);
    assert!(caught(100, is_caught::<LostSubPair>) > 50);
}

/// A session with a band: what is within one of a vertex along each axis, or of
/// the box of an edge, is on it.
struct Banded<S>(S);

impl<S: Predicates> Predicates for Banded<S> {
    forward_to!(0: scene, compare, orient2d, orient3d, incircle, insphere);

    fn reach(&self) -> f64 {
        1.0
    }
    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        self.edge_vertex([a, a], p).is_some()
    }
    fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        let [[a, b], p] = [edge, [p, p]].map(|of| of.map(|v| self.scene().point2(Plane::Xy, v)));
        let is_near = |axis: usize| {
            let [low, high] = [a[axis].min(b[axis]) - 1.0, a[axis].max(b[axis]) + 1.0];
            low <= p[0][axis] && p[0][axis] <= high
        };
        (0..2).all(is_near).then_some(0.5)
    }
}

#[test]
fn forgotten_sub_pairs_are_caught_under_a_band() {
    fn is_caught<F: of_contacts::Planted>(random: &mut Random) -> bool {
        let (scene, [a, b]) = complexes(random, Dimension::Two, Grid::Whole);
        let session = Banded(Exact.prepare(&scene, Off).unwrap());
        !registered_twice(&contacts_of::<F, _>(&session, [&a, &b])).is_empty()
    }
    assert_eq!(caught(100, is_caught::<Honest>), 0);
    assert!(caught(100, is_caught::<ForgottenSubPairs>) > 30);
}

#[test]
fn a_closed_interval_is_caught() {
    fn is_caught<F: of_cells::Planted>(random: &mut Random) -> bool {
        let scene = Scene::new(Dimension::Two, Grid::Whole.coordinates(random, 12, 6)).unwrap();
        let session = Exact.prepare(&scene, Off).unwrap();
        let mut ends: Vec<Vertex> = scene.vertices().take(5).collect();
        ends.sort_by(|&a, &b| scene.point(a)[0].total_cmp(&scene.point(b)[0]));
        let cells: Vec<[Vertex; 2]> = ends.windows(2).map(|ends| [ends[0], ends[1]]).collect();
        scene.vertices().any(|point| {
            let found = cells_at_planted::<F, _>(&session, Axis::X, &cells, point).map(|(cell, place)| match place {
                Place::Outside => (cell, interval::Place::Outside),
                Place::AtEnd => (cell, interval::Place::AtEnd),
                Place::Inside => (cell, interval::Place::Inside),
            });
            found.collect::<Vec<_>>() != interval::cells_at(&scene, Axis::X, &cells, point)
        })
    }
    assert_eq!(caught(100, is_caught::<Honest>), 0);
    assert_eq!(caught(100, is_caught::<ClosedInterval>), 100, "each end is at an end");
}

#[test]
fn an_edge_that_the_grid_skips_is_caught() {
    fn is_caught<F: of_maps::Planted>(random: &mut Random) -> bool {
        let (scene, regions, map) = map(random, Grid::Whole);
        let (index, session) = (LocateIndex::planted::<F>(&map, &scene), Exact.prepare(&scene, Off).unwrap());
        let borders = Borders::new(&scene, &regions);
        let mut scratch = Scratch::new();
        scene.vertices().any(|probe| {
            let (found, truth) = (index.locate(&session, probe, &mut scratch), borders.locate(probe));
            (found.inside, found.boundary) != (&truth.inside[..], &truth.boundary[..])
        })
    }
    assert_eq!(caught(100, is_caught::<Honest>), 0);
    assert!(caught(100, is_caught::<SkippedEdge>) > 50);
}

#[test]
fn a_cube_dropped_at_the_border_of_a_cell_is_caught() {
    fn is_caught<F: of_cubes::Planted>(random: &mut Random) -> bool {
        let scene = cubes(random, 40, 6, 2.0, 1.0);
        let of = ScaledCubes::of_scene(&scene).unwrap();
        let found = cube_union_planted::<F, i64>(&of.lowers, of.edge).unwrap();
        in_scene_units(&found, of.exponent) != Cubes::of_scene(&scene).unwrap().measures()
    }
    assert_eq!(caught(30, is_caught::<Honest>), 0);
    assert!(caught(30, is_caught::<DroppedBorderCube>) > 25);
}

/// Complexes without simplices have no contacts to lose.
#[test]
fn a_fault_needs_something_to_go_wrong_with() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0]]).unwrap();
    let empty = Complex::new(&scene, &Simplices::default()).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    assert_eq!(contacts_of::<LostSubPair, _>(&session, [&empty, &empty]), Vec::<[Vec<Vertex>; 2]>::new());
}
