//! Ties between two meshes about vertices that lines and planes of one mesh each define.
//!
//! A rigid move δ of a mesh changes no direction. So the weight of such a vertex, which is a product of directions, is a constant,
//! and its coordinates are linear in δ: where the line p, q meets the plane with normal n through a, the distances n·(p − a) and n·(q − a)
//! both change by n·δ, and the quadratic terms of p·(n·(q − a)) − q·(n·(p − a)) cancel. With δ = (ε, ε², ε³) a coordinate
//! is four integers, and a determinant is of degree 9 at most, where that of general constructions goes up to 84.

use predicament_predicates::{Axis, Construction, Question, Scene, Sign, Vertex};
use rug::Integer;

use super::moved::inputs;
use super::place::Place;
use super::search::integers;

/// A polynomial in ε: its coefficients from the constant on.
type Series = Vec<Integer>;
/// The coordinates of a vector, or of a point.
type Space = [Integer; 3];

/// A point as the second mesh moves: coordinates times the weight, and the weight. Each coordinate is its value, and its
/// derivatives by the three coordinates of δ.
struct Row {
    at: [[Integer; 4]; 3],
    weight: Integer,
}

/// The side of a tie, and the power of ε that decides, or that it is zero however far the second mesh moves; the outer none where
/// this is not the way to find it.
pub(super) fn decide(
    scene: &Scene,
    second: &[bool],
    question: Question,
    places: &[Place],
) -> Option<Option<(Sign, usize)>> {
    let inputs = inputs(places);
    let (_, coordinates) = integers(scene, &inputs);
    let points = Points { inputs, coordinates, stride: scene.dimension().count(), second };
    let rows: Vec<Row> = places.iter().map(|place| points.row(place)).collect::<Option<_>>()?;
    let series = match (question, &rows[..]) {
        (Question::Compare(axis), [a, b]) => wedge(&a.series(axis), &b.weight, &b.series(axis), &a.weight),
        (Question::Orient2d(plane), [a, b, c]) => {
            let [x, y] = plane.axes().map(|axis| [a, b, c].map(|row| row.series(axis)));
            let minor = |i: usize, j: usize, k: usize| {
                let product = difference(times(&x[i], &y[j]), &times(&x[j], &y[i]));
                scaled(product, &rows[k].weight)
            };
            sum(sum(minor(0, 1, 2), &minor(1, 2, 0)), &minor(2, 0, 1))
        }
        (Question::Orient3d, [_, _, _, _]) => side(&rows),
        _ => return None,
    };
    let power = series.iter().position(|coefficient| !coefficient.is_zero());
    Some(power.map(|power| {
        let sign = rows.iter().fold(Sign::from(series[power].cmp0()), |sign, row| sign * row.weight.cmp0().into());
        (sign, power)
    }))
}

/// The determinant of four rows: minors of the first two columns times those of the last two.
fn side(rows: &[Row]) -> Series {
    let column = |axis: Axis| -> Vec<Series> { rows.iter().map(|row| row.series(axis)).collect() };
    let [x, y, z] = [Axis::X, Axis::Y, Axis::Z].map(column);
    let mut all = Vec::new();
    // Rows of the first minor, those of the second, and the sign.
    for (i, j, k, l, is_even) in [
        (0, 1, 2, 3, true),
        (0, 2, 1, 3, false),
        (0, 3, 1, 2, true),
        (1, 2, 0, 3, true),
        (1, 3, 0, 2, false),
        (2, 3, 0, 1, true),
    ] {
        let first = difference(times(&x[i], &y[j]), &times(&x[j], &y[i]));
        let second = wedge(&z[k], &rows[l].weight, &z[l], &rows[k].weight);
        let product = times(&first, &second);
        all = if is_even { sum(all, &product) } else { difference(all, &product) };
    }
    all
}

/// Input vertices as integers.
struct Points<'q> {
    inputs: Vec<Vertex>,
    /// Significands and exponents, vertex after vertex.
    coordinates: Vec<(i64, u32)>,
    stride: usize,
    second: &'q [bool],
}

impl Points<'_> {
    fn point(&self, v: Vertex) -> Space {
        let at = self.inputs.binary_search(&v).expect("a vertex of the question") * self.stride;
        let all = &self.coordinates[at..at + self.stride];
        [0, 1, 2].map(|axis: usize| all.get(axis).map_or_else(Integer::new, |&(m, k)| Integer::from(m) << k))
    }

    /// Whether a line or a plane moves; none where its vertices are of two meshes.
    fn moves(&self, flat: &[Vertex]) -> Option<bool> {
        let first = self.second[flat[0].index()];
        flat.iter().all(|v| self.second[v.index()] == first).then_some(first)
    }

    fn row(&self, place: &Place) -> Option<Row> {
        match *place {
            Place::Input(v) => {
                let moves = Integer::from(u8::from(self.second[v.index()]));
                Some(Row::new(self.point(v), [0, 1, 2].map(|axis| unit(axis, &moves)), Integer::from(1)))
            }
            Place::Meet(Construction::Ssi([line, other])) => {
                let [a, b] = other.map(|v| self.point(v));
                let [x, y, _] = minus(&b, &a);
                self.meet(line, [-y, x, Integer::new()], a, self.moves(&other)?)
            }
            Place::Meet(Construction::Lpi { line, plane }) => {
                let (normal, a) = self.plane(plane);
                self.meet(line, normal, a, self.moves(&plane)?)
            }
            Place::Meet(Construction::Tpi(planes)) => {
                let [(n, a), (o, b), (p, c)] = planes.map(|plane| self.plane(plane));
                let [i, j, k] = planes.map(|plane| self.moves(&plane));
                let moves = [i?, j?, k?];
                let crossed = [cross(&o, &p), cross(&p, &n), cross(&n, &o)];
                let weight = dot(&n, &crossed[0]);
                let normals = [n, o, p];
                let offsets = [dot(&normals[0], &a), dot(&normals[1], &b), dot(&normals[2], &c)];
                let along = |axis: usize| (0..3).map(|i| Integer::from(&offsets[i] * &crossed[i][axis])).sum();
                // The offset of a plane that moves by δ changes by its normal times δ.
                let derivative = |axis: usize| {
                    [0, 1, 2].map(|by: usize| {
                        let moving = (0..3).filter(|&i| moves[i]);
                        moving.map(|i| Integer::from(&normals[i][by] * &crossed[i][axis])).sum()
                    })
                };
                Some(Row::new([along(0), along(1), along(2)], [0, 1, 2].map(derivative), weight))
            }
        }
    }

    /// A normal of a plane, and a point of it.
    fn plane(&self, plane: [Vertex; 3]) -> (Space, Space) {
        let [a, b, c] = plane.map(|v| self.point(v));
        (cross(&minus(&b, &a), &minus(&c, &a)), a)
    }

    /// Where a line meets the flat with this normal through a point.
    fn meet(&self, line: [Vertex; 2], normal: Space, through: Space, flat_moves: bool) -> Option<Row> {
        let line_moves = self.moves(&line)?;
        let [p, q] = line.map(|v| self.point(v));
        let [at_p, at_q] = [&p, &q].map(|v| dot(&normal, &minus(v, &through)));
        let weight = Integer::from(&at_q - &at_p);
        let along = minus(&p, &q);
        let at = [0, 1, 2].map(|axis: usize| Integer::from(&p[axis] * &at_q) - Integer::from(&q[axis] * &at_p));
        let moved = if line_moves { weight.clone() } else { Integer::new() };
        let derivative = [0, 1, 2].map(|axis: usize| {
            let mut row = unit(axis, &moved);
            for (by, entry) in row.iter_mut().enumerate() {
                let change = Integer::from(&normal[by] * &along[axis]);
                match (line_moves, flat_moves) {
                    (true, false) => *entry += change,
                    (false, true) => *entry -= change,
                    _ => {}
                }
            }
            row
        });
        Some(Row::new(at, derivative, weight))
    }
}

impl Row {
    fn new(at: Space, derivatives: [Space; 3], weight: Integer) -> Row {
        let [x, y, z] = at;
        let [[a, b, c], [d, e, f], [g, h, i]] = derivatives;
        Row { at: [[x, a, b, c], [y, d, e, f], [z, g, h, i]], weight }
    }

    /// A coordinate times the weight, as a polynomial in ε.
    fn series(&self, axis: Axis) -> Series {
        self.at[axis.index()].to_vec()
    }
}

/// A vector along one axis.
fn unit(axis: usize, length: &Integer) -> Space {
    [0, 1, 2].map(|i| if i == axis { length.clone() } else { Integer::new() })
}

fn minus(a: &Space, b: &Space) -> Space {
    [0, 1, 2].map(|i: usize| Integer::from(&a[i] - &b[i]))
}

fn dot(a: &Space, b: &Space) -> Integer {
    (0..3).map(|i| Integer::from(&a[i] * &b[i])).sum()
}

fn cross(a: &Space, b: &Space) -> Space {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| Integer::from(&a[i] * &b[j]) - Integer::from(&a[j] * &b[i]))
}

fn times(a: &Series, b: &Series) -> Series {
    let mut product = vec![Integer::new(); (a.len() + b.len()).saturating_sub(1)];
    for (i, a) in a.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
        for (j, b) in b.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

fn scaled(mut series: Series, by: &Integer) -> Series {
    series.iter_mut().for_each(|coefficient| *coefficient *= by);
    series
}

fn sum(mut a: Series, b: &Series) -> Series {
    a.resize(a.len().max(b.len()), Integer::new());
    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    a
}

fn difference(mut a: Series, b: &Series) -> Series {
    a.resize(a.len().max(b.len()), Integer::new());
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= b);
    a
}

/// a·v − b·u.
fn wedge(a: &Series, v: &Integer, b: &Series, u: &Integer) -> Series {
    difference(scaled(a.clone(), v), &scaled(b.clone(), u))
}
