//! Generated pairs of objects: far apart, parallel, nearly parallel, touching, crossing, one inside the other.

use predicament_corpus::{Family, Making, Parts, Random, Recipe};
use predicament_formats::bits::integer;
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::solids::{self, Shape};

use super::content::{Loops, parts};

/// The points of an object, with its loops or triangles.
type Made = (Vec<Vec<f64>>, Loops);

macro_rules! family {
    ($name:literal, $about:literal, $make:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, _: &Fields<'_, '_>| recipe($make),
        }
    };
}

/// The families of pairs.
pub(super) static FAMILIES: [Family; 9] = [
    family!("distance-polygons", "two random polygons of about n edges together, apart", polygons),
    family!("distance-stairs", "two staircases of about n edges together, with parallel edges at one distance", stairs),
    family!("distance-near-stairs", "the same, with the vertices of one moved by a few doubles", near_stairs),
    family!("distance-spheres", "two spheres of about n triangles together, apart", spheres),
    family!("distance-lattices", "two cubes of unit cells, face to face, with about n triangles together", lattices),
    family!("distance-near-lattices", "the same, with the vertices of one moved by a few doubles", near_lattices),
    family!("distance-touching", "the same as lattices, on one plane: they touch", touching),
    family!("distance-inside", "a small sphere inside a large one, with about n triangles together", inside),
    family!("distance-needles", "n long and thin triangles with integer corners, half of them in each object", needles),
];

fn recipe(make: fn(usize, &mut Random) -> [Made; 2]) -> Result<Recipe, CorpusError> {
    // At most four vertices of three coordinates for each part; a few are made even for the smallest n.
    Ok(Recipe::new(|n| 12 * (n + 100), move |making: &Making| joined(make(making.n, &mut making.random()))))
}

/// The scene of two objects: the points of the first, then those of the second.
fn joined([(points, loops), (others, behind)]: [Made; 2]) -> Parts {
    let dimension = if points[0].len() == 2 { Dimension::Two } else { Dimension::Three };
    let shifted = |part: Vec<Vertex>| part.into_iter().map(|v| Vertex::input(v.index() + points.len())).collect();
    let behind = behind.into_iter().map(shifted).collect();
    let scene = Scene::new(dimension, [points.concat(), others.concat()].concat()).expect("finite points");
    parts(scene, [loops, behind])
}

/// The index of an item as a number.
fn number(at: usize) -> f64 {
    integer(i64::try_from(at).expect("scenes are smaller than memory"))
}

/// A polygon around the origin, with radii from 1/2 to 1, moved along x.
fn star(count: usize, by: f64, random: &mut Random) -> Made {
    let count = count.max(3);
    let point = |at: usize| {
        let (angle, radius) = (std::f64::consts::TAU * number(at) / number(count), random.between(0.5, 1.0));
        vec![radius * angle.cos() + by, radius * angle.sin()]
    };
    ((0..count).map(point).collect(), vec![(0..count).map(Vertex::input).collect()])
}

fn polygons(n: usize, random: &mut Random) -> [Made; 2] {
    [star(n / 2, 0.0, random), star(n / 2, 3.0, random)]
}

/// Steps from the origin to the right and up, closed on the right (`side` = 1) or on the left (−1).
fn steps(count: usize, side: f64, by: f64) -> Made {
    let count = (count / 2).max(1);
    let top = number(count);
    let mut points: Vec<Vec<f64>> = Vec::new();
    for at in 0..count {
        points.extend([vec![number(at) + by, number(at)], vec![number(at + 1) + by, number(at)]]);
    }
    points.push(vec![top + by, top]);
    // The steps go up and to the right: the inside is below them or above.
    points.push(if side > 0.0 { vec![top + by, -1.0] } else { vec![by - 1.0, top] });
    points.push(if side > 0.0 { vec![by, -1.0] } else { vec![by - 1.0, 0.0] });
    let mut ring: Vec<Vertex> = (0..points.len()).map(Vertex::input).collect();
    if side > 0.0 {
        ring.reverse();
    }
    (points, vec![ring])
}

fn stairs(n: usize, _: &mut Random) -> [Made; 2] {
    [steps(n / 2, -1.0, 0.0), steps(n / 2, 1.0, 3.0)]
}

fn near_stairs(n: usize, random: &mut Random) -> [Made; 2] {
    let [first, second] = stairs(n, random);
    [first, moved(second, random)]
}

/// The same object with each coordinate moved by at most two doubles.
fn moved((mut points, loops): Made, random: &mut Random) -> Made {
    for x in points.iter_mut().flatten() {
        for _ in 0..random.integer(0, 2) {
            *x = if random.one_in(2) { x.next_up() } else { x.next_down() };
        }
    }
    (points, loops)
}

/// The triangles of a shape, scaled and moved along x.
fn solid(shape: &Shape, scale: f64, by: f64) -> Made {
    let points = shape.points.iter().map(|[x, y, z]| vec![x * scale + by, y * scale, z * scale]).collect();
    (points, shape.cut(Vertex::input).into_iter().map(Vec::from).collect())
}

fn spheres(n: usize, random: &mut Random) -> [Made; 2] {
    let shape = solids::sphere(n / 2, random);
    let by = random.between(2.5, 3.5);
    let (mut points, loops) = solid(&shape, 1.0, by);
    // Turned a little, so that nothing is parallel.
    let [angle, other] = [random.between(0.1, 0.5), random.between(0.1, 0.5)];
    for point in &mut points {
        let [x, y, z] = [point[0] - by, point[1], point[2]];
        let [x, y] = [x * angle.cos() - y * angle.sin(), x * angle.sin() + y * angle.cos()];
        let [y, z] = [y * other.cos() - z * other.sin(), y * other.sin() + z * other.cos()];
        *point = vec![x + by, y, z];
    }
    [solid(&shape, 1.0, 0.0), (points, loops)]
}

/// The number of cells along an edge of a lattice.
fn width(shape: &Shape) -> f64 {
    shape.points.iter().fold(0.0, |width, point| f64::max(width, point[0]))
}

fn facing(n: usize, gap: f64, random: &mut Random) -> [Made; 2] {
    let shape = solids::lattice(n / 4, random);
    let by = width(&shape) + gap;
    [solid(&shape, 1.0, 0.0), solid(&shape, 1.0, by)]
}

fn lattices(n: usize, random: &mut Random) -> [Made; 2] {
    facing(n, 3.0, random)
}

fn near_lattices(n: usize, random: &mut Random) -> [Made; 2] {
    let [first, second] = facing(n, 3.0, random);
    [first, moved(second, random)]
}

fn touching(n: usize, random: &mut Random) -> [Made; 2] {
    facing(n, 0.0, random)
}

fn inside(n: usize, random: &mut Random) -> [Made; 2] {
    let shape = solids::sphere(n / 2, random);
    [solid(&shape, 1.0, 0.0), solid(&shape, 0.25, 0.25)]
}

fn needles(n: usize, random: &mut Random) -> [Made; 2] {
    let mut object = |by: i64| {
        let (mut points, mut loops) = (Vec::new(), Loops::new());
        for at in 0..(n / 2).max(1) {
            let mut corner = || [random.integer(-4, 4), random.integer(-4, 4), random.integer(-4, 4)];
            let [start, mut end] = [corner(), corner()];
            end[at % 3] += 1 << 20;
            let mut beside = start;
            beside[(at + 1) % 3] += 1;
            let double = |[x, y, z]: [i64; 3]| vec![integer(x), integer(y), integer(z + by)];
            loops.push((3 * at..3 * at + 3).map(Vertex::input).collect());
            points.extend([start, beside, end].map(double));
        }
        (points, loops)
    };
    [object(0), object(-(1 << 21))]
}
