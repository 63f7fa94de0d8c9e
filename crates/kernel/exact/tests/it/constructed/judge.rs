//! The judge of constructed vertices: rational points, textbook determinants.
//!
//! Gauss' elimination computes the points, and substitution proves each: it lies on every line and plane that defines
//! it.

use predicament_predicates::{Axis, Construction, Plane, Scene, Sign, Vertex};
use rug::Rational;

/// A point, with one coordinate for each axis.
pub type Point = Vec<Rational>;

/// A scene's vertices, input and constructed, as rational points.
pub struct Judge {
    input: Vec<Point>,
    constructed: Vec<Point>,
}

impl Judge {
    /// The judge of a scene; panics if a construction defines no point.
    pub fn new(scene: &Scene) -> Judge {
        let input = scene.vertices().map(|v| rational(scene.point(v))).collect();
        let mut judge = Judge { input, constructed: Vec::new() };
        for construction in scene.constructions() {
            let point = judge.meet(construction).expect("a point");
            judge.add(point);
        }
        judge
    }

    /// Adds the next constructed vertex.
    pub fn add(&mut self, point: Point) {
        self.constructed.push(point);
    }

    /// The point that the construction defines, if it does; proved by substitution.
    pub fn meet(&self, construction: &Construction) -> Option<Point> {
        let point = self.solve(construction)?;
        for flat in construction.flats() {
            let points: Vec<&Point> = flat.iter().map(|&v| self.point(v)).collect();
            match points[..] {
                [p, q] if point.len() == 2 => assert!(turn(Plane::Xy, [p, q, &point]).is_zero()),
                [p, q] => assert!(PLANES.iter().all(|&plane| turn(plane, [p, q, &point]).is_zero())),
                [p, q, r] => assert!(side([p, q, r, &point]).is_zero()),
                _ => unreachable!("a line or a plane"),
            }
        }
        Some(point)
    }

    /// The point that the construction defines, without the proof.
    pub fn solve(&self, construction: &Construction) -> Option<Point> {
        let equations = match *construction {
            Construction::Ratio { ends, share } => {
                let ([a, c], part) =
                    (ends.map(|v| self.point(v)), Rational::from(<(i64, i64)>::from(share.fraction())));
                let way = |(a, c): (&Rational, &Rational)| difference(a, c) * &part + c;
                return Some(a.iter().zip(c).map(way).collect());
            }
            Construction::Ssi(lines) => lines.iter().map(|line| self.line2(*line)).collect(),
            Construction::Lpi { line, plane } => {
                let [p, q] = line.map(|v| self.point(v));
                let along = (0..3).find(|&axis| p[axis] != q[axis])?;
                // A line is the intersection of two planes: those that it spans with the other two axes.
                let beside = |axis: usize| {
                    let mut off = p.clone();
                    off[axis] += 1;
                    plane3(p, q, &off)
                };
                let mut sides: Vec<Point> = (0..3).filter(|&axis| axis != along).map(beside).collect();
                sides.push(self.plane(plane));
                sides
            }
            Construction::Tpi(planes) => planes.iter().map(|plane| self.plane(*plane)).collect(),
        };
        solve(equations)
    }

    pub fn point(&self, v: Vertex) -> &Point {
        match v.construction() {
            None => &self.input[v.index()],
            Some(index) => &self.constructed[index],
        }
    }

    pub fn compare(&self, axis: Axis, vertices: [Vertex; 2]) -> Sign {
        order(axis, vertices.map(|v| self.point(v)))
    }

    pub fn orient2d(&self, plane: Plane, vertices: [Vertex; 3]) -> Sign {
        turn(plane, vertices.map(|v| self.point(v)))
    }

    pub fn incircle(&self, vertices: [Vertex; 4]) -> Sign {
        let [a, b, c, d] = vertices.map(|v| self.point(v));
        let [a, b, c] = [a, b, c].map(|p| {
            let mut row = minus(p, d);
            row.push(row.iter().map(|x| Rational::from(x.square_ref())).sum());
            row
        });
        let determinant = Rational::from(&a[0] * &determinant2(&b[1..], &c[1..]))
            - Rational::from(&b[0] * &determinant2(&a[1..], &c[1..]))
            + Rational::from(&c[0] * &determinant2(&a[1..], &b[1..]));
        Sign::from(determinant.cmp0())
    }

    pub fn orient3d(&self, vertices: [Vertex; 4]) -> Sign {
        side(vertices.map(|v| self.point(v)))
    }

    /// The coefficients and the right-hand side of a line.
    fn line2(&self, line: [Vertex; 2]) -> Point {
        let [p, q] = line.map(|v| self.point(v));
        let [u, v] = [difference(&q[0], &p[0]), difference(&q[1], &p[1])];
        let right = Rational::from(&v * &p[0]) - Rational::from(&u * &p[1]);
        vec![v, -u, right]
    }

    fn plane(&self, plane: [Vertex; 3]) -> Point {
        let [p, q, r] = plane.map(|v| self.point(v));
        plane3(p, q, r)
    }
}

/// The three coordinate planes.
pub const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

fn rational(point: &[f64]) -> Point {
    point.iter().map(|&x| Rational::from_f64(x).expect("finite")).collect()
}

/// The sign of one coordinate minus another.
pub fn order(axis: Axis, [a, b]: [&Point; 2]) -> Sign {
    Sign::from(a[axis.index()].cmp(&b[axis.index()]))
}

/// The turn of three points in a plane.
pub fn turn(plane: Plane, points: [&Point; 3]) -> Sign {
    let [a, b, c] = points.map(|p| plane.axes().map(|axis| &p[axis.index()]));
    let [a, b] = [a, b].map(|p| [difference(p[0], c[0]), difference(p[1], c[1])]);
    Sign::from(determinant2(&a, &b).cmp0())
}

/// The side of the last point on the plane of the others.
pub fn side([a, b, c, d]: [&Point; 4]) -> Sign {
    let [a, b, c] = [a, b, c].map(|p| minus(p, d));
    let determinant = Rational::from(&a[0] * &determinant2(&b[1..], &c[1..]))
        - Rational::from(&b[0] * &determinant2(&a[1..], &c[1..]))
        + Rational::from(&c[0] * &determinant2(&a[1..], &b[1..]));
    Sign::from(determinant.cmp0())
}

fn difference(a: &Rational, b: &Rational) -> Rational {
    Rational::from(a - b)
}

fn minus(p: &Point, q: &Point) -> Point {
    p.iter().zip(q).map(|(p, q)| difference(p, q)).collect()
}

fn determinant2(p: &[Rational], q: &[Rational]) -> Rational {
    Rational::from(&p[0] * &q[1]) - Rational::from(&p[1] * &q[0])
}

fn plane3(p: &Point, q: &Point, r: &Point) -> Point {
    let (u, v) = (minus(q, p), minus(r, p));
    let minor = |i: usize, j: usize| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]);
    let mut plane = vec![minor(1, 2), minor(2, 0), minor(0, 1)];
    plane.push((0..3).map(|i| Rational::from(&plane[i] * &p[i])).sum());
    plane
}

/// The unique solution of as many linear equations as unknowns, if there is one.
fn solve(mut rows: Vec<Point>) -> Option<Point> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).find(|&i| rows[i][k].cmp0().is_ne())?;
        rows.swap(k, pivot);
        let pivot = rows[k].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != k {
                let factor = Rational::from(&row[k] / &pivot[k]);
                for (x, y) in row.iter_mut().zip(&pivot) {
                    *x -= Rational::from(&factor * y);
                }
            }
        }
    }
    Some((0..n).map(|k| Rational::from(&rows[k][n] / &rows[k][k])).collect())
}
