//! Generators of points in general position, and near and in every position with collinear or cocircular points.

use predicament_corpus::{Family, Parts, Random, Recipe};
use predicament_formats::bits::integer;
use predicament_predicates::{Scene, Vertex};

use super::content::Sites;

/// A generator: this number of points of a family, from these random numbers.
type Points = fn(usize, &mut Random) -> Vec<[f64; 2]>;

/// A generator of points and of constraints by their indices.
type Edges = fn(usize, &mut Random) -> (Vec<[f64; 2]>, Vec<[usize; 2]>);

macro_rules! family {
    ($name:literal, $points:expr, $about:literal) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, _| Ok(recipe($points)),
        }
    };
    (constrained: $name:literal, $edges:expr, $about:literal) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, _| Ok(constrained($edges)),
        }
    };
}

/// The families of scenes.
pub(super) static FAMILIES: [Family; 12] = [
    family!("delaunay-uniform", uniform, "points uniform in the unit square"),
    family!("delaunay-grid", grid, "all points of a square grid, in random order: every square is cocircular"),
    family!("delaunay-ring", ring, "integer points on one circle, exactly; up to 236,196 different ones"),
    family!("delaunay-rings", rings, "integer points on concentric circles, exactly"),
    family!("delaunay-near-ring", near_ring, "points on one circle, moved by up to two ulps"),
    family!("delaunay-line", line, "integer points on one line, and one beside it"),
    family!("delaunay-clusters", clusters, "ten clusters, each a millionth as wide as they are far apart"),
    family!("delaunay-repeated", repeated, "integer points, each about four times"),
    family!("delaunay-sliver", sliver, "points within a few ulps of a line"),
    family!(constrained: "constraints-star", star, "points uniform in a square, and constraints that cross each other near its centre"),
    family!(constrained: "constraints-lattice", lattice, "the lines of a lattice: each line crosses all perpendicular lines"),
    family!(constrained: "constraints-overlapping", overlapping, "constraints that overlap on a few lines, and pass through points"),
];

fn recipe(points: Points) -> Recipe {
    Recipe::new(
        |n| n.saturating_mul(2),
        move |making| {
            let points = points(making.n, &mut making.random());
            let scene = Scene::from_points2(&points).expect("generators make finite points");
            let sites = Sites { points: scene.len(), constraints: Vec::new() };
            Parts::new(scene, sites)
        },
    )
}

fn constrained(edges: Edges) -> Recipe {
    Recipe::new(
        |n| n.saturating_mul(8),
        move |making| {
            let (points, constraints) = edges(making.n, &mut making.random());
            let scene = Scene::from_points2(&points).expect("generators make finite points");
            let constraints = constraints.into_iter().map(|ends| ends.map(Vertex::input)).collect();
            let sites = Sites { points: scene.len(), constraints };
            Parts::new(scene, sites)
        },
    )
}

/// A few pairs of nearly opposite points as constraints, and more points.
fn star(n: usize, rng: &mut Random) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let rays = n.isqrt().min(40);
    let mut points = Vec::with_capacity(n + 2 * rays);
    for _ in 0..rays {
        let [x, y] = [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)];
        points.push([x, y]);
        points.push([-x + rng.between(-0.1, 0.1), -y + rng.between(-0.1, 0.1)]);
    }
    points.extend((0..n).map(|_| [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)]));
    (points, (0..rays).map(|at| [2 * at, 2 * at + 1]).collect())
}

/// Constraints on the lines x = i and y = j with about n crossings; they end half a unit beyond.
fn lattice(n: usize, _: &mut Random) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let side = signed(n.isqrt().max(1));
    let (low, high) = (-0.5, integer(side) - 0.5);
    let lines =
        (0..side).flat_map(|i| [[[integer(i), low], [integer(i), high]], [[low, integer(i)], [high, integer(i)]]]);
    let points: Vec<[f64; 2]> = lines.flatten().collect();
    let constraints = (0..points.len() / 2).map(|at| [2 * at, 2 * at + 1]).collect();
    (points, constraints)
}

/// Points of a few horizontal lines in random order; constraints join each to the next one and to the third after it.
fn overlapping(n: usize, rng: &mut Random) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let lines = n.isqrt().max(1);
    let width = n.div_ceil(lines);
    let points: Vec<[f64; 2]> =
        (0..n).map(|_| [rng.integer(0, 2 * signed(width)), rng.integer(0, signed(lines) - 1)].map(integer)).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| {
        points[i][1].total_cmp(&points[j][1]).then(points[i][0].total_cmp(&points[j][0])).then(i.cmp(&j))
    });
    let is_level = |ends: &[usize; 2]| points[ends[0]][1].total_cmp(&points[ends[1]][1]).is_eq();
    let near = order.windows(2).map(|pair| [pair[0], pair[1]]);
    let far = order.windows(4).map(|four| [four[3], four[0]]);
    let constraints = near.chain(far).filter(is_level).collect();
    (points, constraints)
}

/// A size as a signed integer. Scenes are smaller than memory.
fn signed(n: usize) -> i64 {
    i64::try_from(n).expect("scenes are smaller than memory")
}

fn shuffled<T>(mut items: Vec<T>, rng: &mut Random) -> Vec<T> {
    for at in (1..items.len()).rev() {
        items.swap(at, usize::try_from(rng.integer(0, signed(at))).unwrap_or(0));
    }
    items
}

fn uniform(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    (0..n).map(|_| [rng.unit(), rng.unit()]).collect()
}

/// The smallest side of a square with this number of places.
fn side(places: usize) -> i64 {
    (1_i64..).find(|side| side * side >= signed(places)).unwrap_or(1)
}

fn grid(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let side = side(n);
    shuffled((0..signed(n)).map(|at| [integer(at % side), integer(at / side)]).collect(), rng)
}

/// At least `n` different points on a circle around the origin, if there are as many.
///
/// x² + y² is the square of a product of primes 4k + 1; each prime gives three choices, by the Gaussian primes and
/// their conjugates.
fn circle(n: usize) -> Vec<[i64; 2]> {
    let times = |[a, b]: [i64; 2], [c, d]: [i64; 2]| [a * c - b * d, a * d + b * c];
    let mut all = vec![[1, 0], [0, 1], [-1, 0], [0, -1]];
    for prime in [[2, 1], [3, 2], [4, 1], [5, 2], [6, 1], [5, 4], [7, 2], [6, 5], [8, 3], [8, 5]] {
        if all.len() >= n {
            break;
        }
        let conjugate = [prime[0], -prime[1]];
        let factors = [times(prime, prime), times(prime, conjugate), times(conjugate, conjugate)];
        all = factors.into_iter().flat_map(|factor| all.iter().map(move |&z| times(z, factor))).collect();
    }
    all
}

fn ring(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let mut points = shuffled(circle(n), rng);
    points.truncate(n);
    // If `n` exceeds the number of different points, they repeat.
    let points: Vec<[f64; 2]> = points.into_iter().map(|point| point.map(integer)).collect();
    points.iter().copied().cycle().take(n).collect()
}

fn rings(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let circle = circle(if n < 10_000 { 36 } else { 2_916 });
    let all = (1..=signed(n)).flat_map(|scale| circle.iter().map(move |point| point.map(|x| integer(x * scale))));
    shuffled(all.take(n).collect(), rng)
}

fn near_ring(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    (0..n)
        .map(|_| {
            loop {
                let [x, y] = [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)];
                let square = x * x + y * y;
                if (1e-4..=1.0).contains(&square) {
                    return [x, y].map(|x| {
                        let ulps = rng.integer(-2, 2);
                        f64::from_bits((x / square.sqrt()).to_bits().wrapping_add_signed(ulps))
                    });
                }
            }
        })
        .collect()
}

fn line(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let on = (0..signed(n) - 1).map(|at| [integer(3 * at), integer(-7 * at)]);
    shuffled(on.chain([[1.0, 5.0]]).take(n).collect(), rng)
}

fn clusters(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let centres: Vec<[f64; 2]> = (0..10).map(|_| [rng.between(0.0, 1000.0), rng.between(0.0, 1000.0)]).collect();
    (0..n).map(|at| centres[at % 10].map(|x| x + rng.between(-0.0005, 0.0005))).collect()
}

fn repeated(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let side = side(n.div_ceil(4));
    (0..n).map(|_| [(); 2].map(|()| integer(rng.integer(0, side - 1)))).collect()
}

fn sliver(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    (0..n)
        .map(|_| {
            let x = rng.between(0.5, 24.0);
            [x, f64::from_bits(x.to_bits().wrapping_add_signed(rng.integer(-2, 2)))]
        })
        .collect()
}
