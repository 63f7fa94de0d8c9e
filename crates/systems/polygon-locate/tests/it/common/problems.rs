//! Maps for planted faults.

use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};

/// A map, its scene, and the vertices to locate.
pub struct Problem {
    pub map: PolygonMap,
    pub scene: Scene,
    pub probes: Vec<Vertex>,
}

impl Problem {
    /// Adds probes as new vertices: at every corner, halfway along every edge, and at the doubles next to all of those,
    /// above, below, left and right. The map's own vertices follow.
    pub fn new(corners: &[[f64; 2]], regions: &[Vec<Vec<usize>>]) -> Problem {
        let mut map = PolygonMap::new();
        for (at, rings) in regions.iter().enumerate() {
            let rings = rings.iter().map(|ring| ring.iter().map(|&v| Vertex::input(v)).collect()).collect();
            map.push(at.to_string(), rings).expect("rings");
        }
        let mut on_borders = corners.to_vec();
        for (_, ends) in map.edges() {
            let [a, b] = ends.map(|v| corners[v.index()]);
            on_borders.push([(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]);
        }
        let mut points = corners.to_vec();
        for [x, y] in on_borders {
            points.extend([[x, y], [x, y.next_up()], [x, y.next_down()], [x.next_up(), y], [x.next_down(), y]]);
            points.extend([[x + 0.25, y + 0.125], [x, y - 0.25]]);
        }
        let scene = Scene::from_points2(&points).expect("finite");
        let probes = (corners.len()..points.len()).chain(0..corners.len()).map(Vertex::input).collect();
        Problem { map, scene, probes }
    }
}

impl Problem {
    /// The same map with other numbers. A perturbation depends on the number; if all probes came last, they would all
    /// move less than the map does.
    pub fn scattered(&self) -> Problem {
        let count = self.scene.len();
        let stride = (count / 3..).find(|&stride| gcd(stride, count) == 1).expect("there are primes");
        let renumber = |v: Vertex| Vertex::input((v.index() * stride + 1) % count);
        let mut points = vec![[0.0; 2]; count];
        for v in self.scene.vertices() {
            points[renumber(v).index()] = [self.scene.point(v)[0], self.scene.point(v)[1]];
        }
        let mut map = PolygonMap::new();
        for region in self.map.regions() {
            let rings =
                region.rings.iter().map(|ring| ring.vertices().iter().map(|&v| renumber(v)).collect()).collect();
            map.push(region.name.clone(), rings).expect("rings");
        }
        let scene = Scene::from_points2(&points).expect("finite");
        Problem { map, scene, probes: self.probes.iter().map(|&v| renumber(v)).collect() }
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// A map of n × n unit squares with integer corners: every second edge is vertical.
pub fn squares(n: usize) -> Problem {
    let (corners, regions) = square_cells(n);
    Problem::new(&corners, &regions)
}

/// The corners, row by row, and the cells of [`squares`].
pub fn square_cells(n: usize) -> (Vec<[f64; 2]>, Vec<Vec<Vec<usize>>>) {
    let at = |x: usize, y: usize| x + y * (n + 1);
    let corners = (0..(n + 1) * (n + 1)).map(|v| [small(v % (n + 1)), small(v / (n + 1))]).collect();
    let cell = |c: usize| {
        let (x, y) = (c % n, c / n);
        vec![vec![at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]]
    };
    (corners, (0..n * n).map(cell).collect())
}

/// Courses of bricks of length 2, each shifted by 1 against the one below. A brick has the joints of its neighbours as
/// vertices on its long sides.
pub fn bricks(courses: usize) -> Problem {
    let width = 2 * courses + 2;
    let at = |x: usize, y: usize| x + y * width;
    let corners: Vec<[f64; 2]> = (0..(courses + 1) * width).map(|v| [small(v % width), small(v / width)]).collect();
    let mut regions = Vec::new();
    for y in 0..courses {
        for x in (y % 2..width - 2).step_by(2) {
            regions.push(vec![vec![
                at(x, y),
                at(x + 1, y),
                at(x + 2, y),
                at(x + 2, y + 1),
                at(x + 1, y + 1),
                at(x, y + 1),
            ]]);
        }
    }
    Problem::new(&corners, &regions)
}

/// An L with a hole, an island in the hole, and a sea around everything.
pub fn island() -> Problem {
    let l = [[0., 0.], [8., 0.], [8., 3.], [6., 6.], [6., 8.], [0., 8.]];
    let hole = [[2., 2.], [4., 2.], [5., 4.], [2., 5.]];
    let inner = [[3., 3.], [3.5, 3.], [3.25, 3.75]];
    let corners = [&l[..], &hole, &inner].concat();
    Problem::new(&corners, &[vec![(0..6).collect(), (6..10).collect()], vec![vec![10, 11, 12]]])
}

#[allow(clippy::cast_precision_loss)] // as the name says
fn small(x: usize) -> f64 {
    x as f64
}
