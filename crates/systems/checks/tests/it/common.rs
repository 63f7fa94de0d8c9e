//! Sessions with planted faults, and maps to try them on.

use predicament_mesh::PolygonMap;
use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex, forward_to};

/// A session that answers through `inner`, but for what the fault changes.
pub struct Faulty<P> {
    pub inner: P,
    pub fault: Fault,
}

/// What is wrong with a [`Faulty`] session.
#[derive(Clone, Copy, Debug)]
pub enum Fault {
    /// Nothing: the wrapper by itself must not be caught.
    None,
    /// One pair is compared the wrong way round in x.
    MirroredPair([usize; 2]),
    /// One ordered pair is compared the wrong way round, its swap is not.
    OneSidedPair([usize; 2]),
    /// One triple turns the other way, in every order.
    FlippedTriple([usize; 3]),
    /// One quadruple is on the other side, in every order.
    FlippedQuadruple([usize; 4]),
    /// Ties go by the place in the argument list and not by the vertex.
    TiesByPlace,
    /// All ties are broken towards positive, as a "≥" in place of a ">" does.
    TiesUp,
    /// Turns that are ties go by the parity of the sum of the indices: each
    /// tie broken for itself, not as part of one moved scene.
    TiesByParity,
    /// Everything within this distance of zero is zero, without a promise.
    Epsilon(f64),
    /// The last answer of a batch of turns is the opposite of what it is alone.
    LastOfBatch,
    /// The first point beside a line is taken for on the other side.
    FirstOfLine,
    /// Ties are broken by the number of vertices that come after the first argument.
    CountedFromTheEnd,
}

fn sorted<const N: usize>(args: [Vertex; N]) -> [usize; N] {
    let mut sorted = args.map(Vertex::index);
    sorted.sort_unstable();
    sorted
}

impl<P: Predicates> Faulty<P> {
    /// The determinant in plain floating point; exact on small integers.
    fn plain(&self, plane: Plane, args: [Vertex; 3]) -> f64 {
        let [a, b, c] = args.map(|v| self.scene().point2(plane, v));
        (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
    }

    fn break_tie(&self, sign: Sign) -> Sign {
        match self.fault {
            Fault::TiesUp | Fault::TiesByPlace if sign.is_zero() => Sign::Positive,
            _ => sign,
        }
    }
}

impl<P: Predicates> Predicates for Faulty<P> {
    fn scene(&self) -> &Scene {
        self.inner.scene()
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        let sign = self.inner.compare(axis, a, b);
        match self.fault {
            Fault::MirroredPair(pair) if axis == Axis::X && sorted([a, b]) == pair => -sign,
            Fault::OneSidedPair(pair) if axis == Axis::X && [a, b].map(Vertex::index) == pair => -sign,
            Fault::TiesUp if sign.is_zero() => Sign::Positive,
            _ => sign,
        }
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let sign = self.inner.orient2d(plane, a, b, c);
        match self.fault {
            Fault::FlippedTriple(triple) if sorted([a, b, c]) == triple => -sign,
            Fault::TiesByParity if self.plain(plane, [a, b, c]) == 0.0 => {
                let sum = a.index() + b.index() + c.index();
                if sum.is_multiple_of(2) { Sign::Positive } else { Sign::Negative }
            }
            Fault::CountedFromTheEnd if self.plain(plane, [a, b, c]) == 0.0 => {
                if (self.scene().len() - a.index()).is_multiple_of(3) { -sign } else { sign }
            }
            Fault::Epsilon(eps) if self.plain(plane, [a, b, c]).abs() < eps => Sign::Zero,
            _ => self.break_tie(sign),
        }
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.inner.orient2d_batch(plane, queries, out);
        if let (Fault::LastOfBatch, Some(last)) = (self.fault, out.last_mut()) {
            *last = -*last;
        }
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        self.inner.orient2d_line(plane, line, points, out);
        if let (Fault::FirstOfLine, Some(first)) = (self.fault, out.first_mut()) {
            *first = -*first;
        }
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let sign = self.inner.orient3d(a, b, c, d);
        match self.fault {
            Fault::FlippedQuadruple(quadruple) if sorted([a, b, c, d]) == quadruple => -sign,
            _ => self.break_tie(sign),
        }
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.break_tie(self.inner.incircle(a, b, c, d))
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.break_tie(self.inner.insphere(a, b, c, d, e))
    }
}

/// Comparisons and orientations of one session, circles and spheres of another.
pub struct Patched<'a, P, Q> {
    pub sides: &'a P,
    pub circles: &'a Q,
}

impl<P: Predicates, Q: Predicates> Predicates for Patched<'_, P, Q> {
    forward_to!(sides: scene, compare, orient2d, orient3d);

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.circles.incircle(a, b, c, d)
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.circles.insphere(a, b, c, d, e)
    }
}

/// A map, its scene, and the vertices to locate.
pub struct Problem {
    pub map: PolygonMap,
    pub scene: Scene,
    pub probes: Vec<Vertex>,
}

impl Problem {
    /// Probes are new vertices: at every corner, halfway along every edge, and
    /// at the doubles next to all of those, above, below, left and right; then
    /// the map's own vertices.
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
    /// The same map with other numbers. A perturbation goes by the number, and
    /// as long as all probes come last, they all move less than the map does.
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

/// n × n unit squares with integer corners: every second edge is vertical.
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

/// Courses of bricks of length 2, each shifted by 1 against the one below;
/// a brick has the joints of its neighbours as vertices on its long sides.
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

/// An L with a hole, an island in the hole, and a sea around all.
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
