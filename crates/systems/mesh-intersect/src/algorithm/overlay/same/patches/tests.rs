//! Patches of spiral stairs: graphs over the plane up to about one turn.

use std::collections::{BTreeMap, BTreeSet};

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, Vertex};

use super::*;

/// The number of steps of one turn.
const PARTS: usize = 24;
/// The number of vertices on each step, from the inner wall to the outer one.
const RINGS: usize = 6;

/// Stairs of some steps around the x axis, and their copy above, with walls between them.
fn stairs(steps: usize) -> (Scene, MaterialMesh, Vec<[u32; 3]>) {
    let mut places: Vec<[f64; 3]> = Vec::new();
    for floor in [0.0, 1000.0] {
        for step in 0..=steps {
            for ring in 0..RINGS {
                let angle = f64::from(number(step)) / f64::from(number(PARTS)) * std::f64::consts::TAU;
                let radius = 100.0 + 50.0 * f64::from(number(ring));
                let [y, z] = [angle.cos(), angle.sin()].map(|x| (radius * x).round());
                places.push([floor + f64::from(number(step)), y, z]);
            }
        }
    }
    let place = |[step, ring]: [usize; 2]| RINGS * step + ring;
    let squares = (0..steps).flat_map(|step| (1..RINGS).map(move |ring| [step, ring - 1]));
    let below: Vec<[u32; 3]> = squares
        .flat_map(|[step, ring]| {
            let [a, b, c, d] =
                [[step, ring], [step, ring + 1], [step + 1, ring + 1], [step + 1, ring]].map(|at| number(place(at)));
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let above = number(places.len() / 2);
    let mut all: Vec<[u32; 3]> = below.clone();
    all.extend(below.iter().map(|&[a, b, c]| [a + above, c + above, b + above]));
    let edges: BTreeSet<[u32; 2]> = below.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    for &[u, v] in edges.iter().filter(|[u, v]| !edges.contains(&[*v, *u])) {
        all.extend([[v, u, u + above], [v, u + above, v + above]]);
    }
    let triangles: Vec<[Vertex; 3]> = all.iter().map(|t| t.map(|v| Vertex::input(v as usize))).collect();
    (Scene::from_points3(&places).unwrap(), MaterialMesh::of_closed(places.len(), triangles).unwrap(), below)
}

/// The patches of some triangles of stairs below.
fn patches(scene: &Scene, mesh: &MaterialMesh, of: &[u32]) -> Patches {
    let boxes: Vec<Bounds<3>> =
        of.iter().map(|&at| Bounds::of(mesh.triangles()[at as usize].map(|v| scene.point3(v)))).collect();
    Patches::of(scene, mesh, Vertices::of(mesh), of, &boxes)
}

/// True if the images of two triangles of stairs have no point in common, by whole numbers.
fn are_images_apart(scene: &Scene, [s, t]: [[u32; 3]; 2]) -> bool {
    #[allow(clippy::cast_possible_truncation)] // rounded above
    let image = |v: u32| {
        let [_, y, z] = scene.point3(Vertex::input(v as usize));
        [y as i64, z as i64]
    };
    let turn = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(image);
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let is_beyond = |[a, b, c]: [u32; 3], t: [u32; 3]| {
        [[a, b], [b, c], [c, a]].iter().any(|&[a, b]| t.iter().all(|&v| turn([a, b, v]) < 0))
    };
    is_beyond(s, t) || is_beyond(t, s)
}

/// True if images of two triangles without a common corner have a point in common.
fn overlaps(scene: &Scene, below: &[[u32; 3]], of: &[u32]) -> bool {
    let pairs = of.iter().enumerate().flat_map(|(i, &a)| of[i + 1..].iter().map(move |&b| [a, b]));
    let mut triangles = pairs.map(|pair| pair.map(|at| below[at as usize]));
    triangles.any(|[s, t]| !s.iter().any(|v| t.contains(v)) && !are_images_apart(scene, [s, t]))
}

/// The triangles of stairs without corners at the walls, all or those that a rule accepts.
fn inner(below: &[[u32; 3]], steps: usize, accepts: impl Fn(usize) -> bool) -> Vec<u32> {
    let is_inner = |v: u32| {
        let [step, ring] = [v as usize / RINGS, v as usize % RINGS];
        step != 0 && step != steps && ring != 0 && ring != RINGS - 1
    };
    let all = (0..below.len()).filter(|&at| below[at].iter().all(|&v| is_inner(v)) && accepts(at));
    all.map(number).collect()
}

#[test]
fn stairs_are_a_patch_until_they_overlap() {
    let mut seen = BTreeMap::new();
    for steps in [4, PARTS / 2, PARTS, PARTS + 1, PARTS + 2, PARTS + 3, PARTS + 6, 2 * PARTS] {
        let (scene, mesh, below) = stairs(steps);
        let of = inner(&below, steps, |_| true);
        let found = patches(&scene, &mesh, &of);
        let is_patch = (0..of.len()).all(|at| found.patch(at) == 0);
        assert_eq!(is_patch, !overlaps(&scene, &below, &of), "{steps} steps");
        assert!(is_patch || (0..of.len()).all(|at| found.patch(at) == NONE));
        let tested = (0..of.len()).filter(|&at| found.is_near_others(at, &Bounds::of([[0.0; 3]]))).count();
        assert!(tested == if is_patch { 0 } else { of.len() });
        *seen.entry(is_patch).or_insert(0) += 1;
    }
    assert!(seen[&true] >= 4 && seen[&false] >= 3, "{seen:?}");
}

#[test]
fn patches_with_holes_do_not_overlap_and_may_not_touch_themselves() {
    let mut seen = BTreeMap::new();
    for hole in 0..60 {
        for steps in [PARTS - 4, PARTS + 4] {
            let (scene, mesh, below) = stairs(steps);
            // One or more triangles are missing.
            let of = inner(&below, steps, |at| at != 3 * hole && (hole % 3 != 0 || !(at + hole).is_multiple_of(7)));
            let found = patches(&scene, &mesh, &of);
            for patch in 0..number(found.bounds.len() - 1) {
                let own: Vec<u32> = (0..of.len()).filter(|&at| found.patch(at) == patch).map(|at| of[at]).collect();
                assert!(!overlaps(&scene, &below, &own), "{hole} {steps}");
                *seen.entry(!own.is_empty()).or_insert(0) += 1;
            }
        }
    }
    assert!(seen[&true] > 20 && seen[&false] > 60, "{seen:?}");
}

/// Two triangles that share one vertex: the loop goes through it twice.
#[test]
fn a_patch_has_no_vertex_twice_at_its_edge() {
    let (scene, mesh, below) = stairs(8);
    let of = inner(&below, 8, |_| true);
    let common = |s: &[u32; 3], t: &[u32; 3]| s.iter().filter(|v| t.contains(v)).count();
    let first = of[0];
    let with = |count: usize| {
        let second = of[1..].iter().find(|&&at| common(&below[first as usize], &below[at as usize]) == count);
        let found = patches(&scene, &mesh, &[first, *second.unwrap()]);
        [found.patch(0), found.patch(1)]
    };
    assert_eq!([with(1), with(2)], [[NONE; 2], [0; 2]]);
    assert!(with(0) == [0, 1]);
}
