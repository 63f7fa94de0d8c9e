//! Ties between two meshes about vertices that lines and planes of one mesh each define.
//!
//! A rigid move δ of a mesh changes no direction. So the weight of such a vertex, which is a product of directions, is
//! a constant, and its coordinates are linear in δ. Where the line p, q meets the plane with normal n through a, the
//! distances n·(p − a) and n·(q − a) both change by n·δ, and the quadratic terms of p·(n·(q − a)) − q·(n·(p − a))
//! cancel. So a coordinate is four integers, and a determinant has degree 3 at most in δ, whereas that of general
//! constructions has up to 28. The monomials are those of [`rigid`](super::rigid).

use predicament_predicates::{Axis, Construction, Question, Scene, Share, Sign, Vertex};

use super::moved::inputs;
use super::place::Place;
use super::search::integers;
use crate::integer::Integer;

/// A polynomial in δ: its coefficients, those of larger monomials first.
///
/// The 2·d + 1 monomials of degree d begin at the place d²: the powers of ε from d to 3·d.
type Series = Vec<Integer>;
/// The coordinates of a vector, or of a point.
type Space = [Integer; 3];

/// A point that moves with the second mesh: coordinates times the weight, and the weight.
///
/// Each coordinate is its value, and its derivatives by the three coordinates of δ.
struct Row {
    at: [[Integer; 4]; 3],
    weight: Integer,
}

/// The side of a tie and the deciding power of ε.
///
/// The inner `None`: zero however far the second mesh moves. The outer `None`: this method does not apply.
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
    let place = series.iter().position(|coefficient| !coefficient.is_zero());
    Some(place.map(|place| {
        let sign = rows.iter().fold(Sign::from(series[place].cmp0()), |sign, row| sign * row.weight.cmp0().into());
        let degree = place.isqrt();
        (sign, place - degree * degree + degree)
    }))
}

/// The determinant of four rows: minors of the first two columns times those of the last two.
fn side(rows: &[Row]) -> Series {
    let column = |axis: Axis| -> Vec<Series> { rows.iter().map(|row| row.series(axis)).collect() };
    let [x, y, z] = [Axis::X, Axis::Y, Axis::Z].map(column);
    let mut all = Vec::new();
    // The rows of the first minor, those of the second, and the sign.
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
        [0, 1, 2].map(|axis: usize| all.get(axis).map_or(Integer::ZERO, |&(m, k)| Integer::from(m) << k))
    }

    /// Returns true if a line or a plane moves; `None` if its vertices are of two meshes.
    fn moves(&self, flat: &[Vertex]) -> Option<bool> {
        let first = self.second[flat[0].index()];
        flat.iter().all(|v| self.second[v.index()] == first).then_some(first)
    }

    fn row(&self, place: &Place) -> Option<Row> {
        match *place {
            Place::Input(v) => {
                let moves = Integer::from(i64::from(self.second[v.index()]));
                Some(Row::new(self.point(v), [0, 1, 2].map(|axis| unit(axis, &moves)), Integer::ONE))
            }
            Place::Meet(Construction::Ssi([line, other])) => {
                let [a, b] = other.map(|v| self.point(v));
                let [x, y, _] = minus(&b, &a);
                self.meet(line, [-y, x, Integer::ZERO], a, self.moves(&other)?)
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
                let along = |axis: usize| total((0..3).map(|i| [&offsets[i], &crossed[i][axis]]));
                // The offset of a plane that moves by δ changes by its normal times δ.
                let derivative = |axis: usize| {
                    [0, 1, 2].map(|by: usize| {
                        let moving = (0..3).filter(|&i| moves[i]);
                        total(moving.map(|i| [&normals[i][by], &crossed[i][axis]]))
                    })
                };
                Some(Row::new([along(0), along(1), along(2)], [0, 1, 2].map(derivative), weight))
            }
            Place::Meet(Construction::Ratio { ends, share }) => Some(self.shared(ends, share)),
        }
    }

    /// The row of a share of a segment, whose ends may be of two meshes: each moves its share.
    fn shared(&self, ends: [Vertex; 2], share: Share) -> Row {
        let ([p, q], [rest, _]) = (share.fraction().map(Integer::from), share.rest().fraction().map(Integer::from));
        let (parts, points) = ([p, rest], ends.map(|v| self.point(v)));
        let at = [0, 1, 2].map(|axis: usize| total((0..2).map(|end| [&parts[end], &points[end][axis]])));
        let moving = (0..2).filter(|&end| self.second[ends[end].index()]);
        let moves = total(moving.map(|end| [&parts[end], &Integer::ONE]));
        Row::new(at, [0, 1, 2].map(|axis| unit(axis, &moves)), q)
    }

    /// A normal of a plane, and a point on it.
    fn plane(&self, plane: [Vertex; 3]) -> (Space, Space) {
        let [a, b, c] = plane.map(|v| self.point(v));
        (cross(&minus(&b, &a), &minus(&c, &a)), a)
    }

    /// The row of the point where a line meets the line or plane with this normal through a point.
    fn meet(&self, line: [Vertex; 2], normal: Space, through: Space, flat_moves: bool) -> Option<Row> {
        let line_moves = self.moves(&line)?;
        let [p, q] = line.map(|v| self.point(v));
        let [at_p, at_q] = [&p, &q].map(|v| dot(&normal, &minus(v, &through)));
        let weight = &at_q - &at_p;
        let along = minus(&p, &q);
        let at = [0, 1, 2].map(|axis: usize| &(&p[axis] * &at_q) - &(&q[axis] * &at_p));
        let moved = if line_moves { weight.clone() } else { Integer::ZERO };
        let derivative = [0, 1, 2].map(|axis: usize| {
            let mut row = unit(axis, &moved);
            for (by, entry) in row.iter_mut().enumerate() {
                let change = &normal[by] * &along[axis];
                match (line_moves, flat_moves) {
                    (true, false) => *entry += &change,
                    (false, true) => *entry -= &change,
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

    /// A coordinate times the weight, as a polynomial in δ.
    fn series(&self, axis: Axis) -> Series {
        self.at[axis.index()].to_vec()
    }
}

/// A vector along one axis.
fn unit(axis: usize, length: &Integer) -> Space {
    [0, 1, 2].map(|i| if i == axis { length.clone() } else { Integer::ZERO })
}

fn minus(a: &Space, b: &Space) -> Space {
    [0, 1, 2].map(|i: usize| &a[i] - &b[i])
}

/// The sum of products.
fn total<'a>(products: impl Iterator<Item = [&'a Integer; 2]>) -> Integer {
    let mut total = Integer::ZERO;
    products.for_each(|[a, b]| total.add_product(a, b));
    total
}

fn dot(a: &Space, b: &Space) -> Integer {
    total(a.iter().zip(b).map(|(a, b)| [a, b]))
}

fn cross(a: &Space, b: &Space) -> Space {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| &(&a[i] * &b[j]) - &(&a[j] * &b[i]))
}

fn times(a: &Series, b: &Series) -> Series {
    let [degree, other] = [a, b].map(|series| (series.len() - 1).isqrt());
    let mut product = vec![Integer::ZERO; (degree + other + 1).pow(2)];
    for (i, a) in a.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
        for (j, b) in b.iter().enumerate() {
            let [degree, other] = [i, j].map(usize::isqrt);
            // The powers of ε beyond those of the degrees.
            let more = i - degree * degree + j - other * other;
            product[(degree + other).pow(2) + more].add_product(a, b);
        }
    }
    product
}

fn scaled(mut series: Series, by: &Integer) -> Series {
    series.iter_mut().for_each(|coefficient| *coefficient = &*coefficient * by);
    series
}

fn sum(mut a: Series, b: &Series) -> Series {
    a.resize(a.len().max(b.len()), Integer::ZERO);
    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    a
}

fn difference(mut a: Series, b: &Series) -> Series {
    a.resize(a.len().max(b.len()), Integer::ZERO);
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= b);
    a
}

/// The polynomial a·v − b·u.
fn wedge(a: &Series, v: &Integer, b: &Series, u: &Integer) -> Series {
    difference(scaled(a.clone(), v), &scaled(b.clone(), u))
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact;
    use predicament_predicates::{Backend, Dimension, Off, Plane};

    use super::super::rigid;
    use super::super::testing::Random;
    use super::*;

    /// Points of a small grid, and points of lines and planes with vertices of one half each.
    fn scene(random: &mut Random, dimension: Dimension) -> Scene {
        let axes = dimension.count();
        let coordinates = (0..10 * axes).map(|_| f64::from(u32::try_from(random.below(3)).unwrap()));
        let mut scene =
            Scene::new(dimension, coordinates.collect()).unwrap().with_second_mesh((5..10).map(Vertex::input));
        for _ in 0..8 {
            let mut flat = |vertices: usize| -> Vec<Vertex> {
                let from = 5 * random.below(2);
                random.different::<3>(5)[..vertices].iter().map(|v| Vertex::input(v.index() + from)).collect()
            };
            let mut line = || <[Vertex; 2]>::try_from(flat(2)).unwrap();
            let construction = match dimension {
                Dimension::Two => Construction::Ssi([line(), line()]),
                Dimension::Three => {
                    let line = line();
                    let mut plane = || <[Vertex; 3]>::try_from(flat(3)).unwrap();
                    let planes = [plane(), plane(), plane()];
                    let [first, ..] = planes;
                    if scene.constructions().len().is_multiple_of(2) {
                        Construction::Lpi { line, plane: first }
                    } else {
                        Construction::Tpi(planes)
                    }
                }
            };
            let mut with = scene.clone();
            with.construct(construction).unwrap();
            if Exact.prepare(&with, Off).is_ok() {
                scene = with;
            }
        }
        scene
    }

    #[test]
    fn what_is_linear_is_found_here_and_is_what_whole_polynomials_say() {
        let mut random = Random(0x0fed_cba9_8765_4321);
        let (mut asked, mut zeros) = (0, 0);
        for round in 0..1200 {
            let dimension = if round % 2 == 0 { Dimension::Two } else { Dimension::Three };
            let scene = scene(&mut random, dimension);
            let second = scene.second_mesh().unwrap();
            let questions: &[Question] = match dimension {
                Dimension::Two => &[Question::Compare(Axis::X), Question::Orient2d(Plane::Xy)],
                Dimension::Three => &[Question::Compare(Axis::Z), Question::Orient2d(Plane::Zx), Question::Orient3d],
            };
            for &question in questions {
                let mut all: Vec<Vertex> = scene.vertices().collect();
                all.extend((0..scene.constructions().len()).map(Vertex::constructed));
                let mut one = || all.swap_remove(all.len() - 1 - random.below(all.len().min(6)));
                let args: Vec<Vertex> = (0..question.kind().arity()).map(|_| one()).collect();
                let places: Vec<Place> = args.iter().map(|&v| Place::of(&scene, v)).collect();
                let context = format!("{question:?} of {args:?} in {scene:?}");
                let here = decide(&scene, second, question, &places).unwrap_or_else(|| panic!("left: {context}"));
                assert_eq!(here, rigid::by_powers(&scene, second, question, &places), "{context}");
                asked += 1;
                zeros += usize::from(here.is_none());
            }
        }
        assert!(asked == 3000 && zeros > 100 && zeros < 2000, "{zeros} of {asked}");
    }

    #[test]
    fn lines_and_planes_of_two_meshes_are_left_and_so_are_circles() {
        let v = Vertex::input;
        let flat = [[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0], [1.0, 1.0]];
        let mut scene = Scene::from_points2(&flat).unwrap();
        let middle = scene.construct(Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])).unwrap();
        for (second, is_left) in [(vec![0, 1], false), (vec![2, 3], false), (vec![0], true), (vec![1, 2], true)] {
            let scene = scene.clone().with_second_mesh(second.iter().map(|&at| v(at)));
            let places: Vec<Place> = [middle, v(4)].iter().map(|&v| Place::of(&scene, v)).collect();
            let mesh = scene.second_mesh().unwrap();
            assert_eq!(decide(&scene, mesh, Question::Compare(Axis::X), &places).is_none(), is_left, "{second:?}");
            let inputs: Vec<Place> = (0..4).map(|at| Place::of(&scene, v(at))).collect();
            assert!(decide(&scene, mesh, Question::Incircle, &inputs).is_none());
        }
    }
}
