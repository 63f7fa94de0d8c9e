//! The points of a query: input points, and points given by the lines and planes that meet there.

use predicament_judge::portable;

use crate::Number;

/// The form of a point: the number of input points that define it, and their roles.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Shape {
    /// An input point.
    Input,
    /// Two lines of the plane, each through two points.
    Ssi,
    /// A line through two points and a plane through three.
    Lpi,
    /// Three planes, each through three points.
    Tpi,
}

impl Shape {
    /// The number of input points.
    #[must_use]
    pub const fn size(self) -> usize {
        match self {
            Shape::Input => 1,
            Shape::Ssi => 4,
            Shape::Lpi => 5,
            Shape::Tpi => 9,
        }
    }

    /// The point that these input points define; `None` if they define none.
    pub(crate) fn solve(self, inputs: &[portable::Point]) -> Option<portable::Point> {
        let at = |index: usize| &inputs[index];
        let plane = |first: usize| [at(first), at(first + 1), at(first + 2)];
        match self {
            Shape::Input => Some(at(0).clone()),
            Shape::Ssi => portable::Point::ssi([[at(0), at(1)], [at(2), at(3)]]),
            Shape::Lpi => portable::Point::lpi([at(0), at(1)], plane(2)),
            Shape::Tpi => portable::Point::tpi([plane(0), plane(3), plane(6)]),
        }
    }
}

/// A point as closures receive it: `[T; 2]`, `[T; 3]`, [`Point2`] or [`Point3`].
pub trait Point: Clone + PartialEq + std::fmt::Debug + 'static {
    /// The type of coordinates.
    type Number: Number;

    /// The number of coordinates of an input point.
    const DIMENSION: usize;

    /// The point of a shape with the coordinates of its input points; `None` if the type has no such shape.
    fn assemble(shape: Shape, coordinates: &[Self::Number]) -> Option<Self>;

    /// The point as an expression of Rust.
    fn literal(&self) -> String;
}

impl<T: Number, const D: usize> Point for [T; D] {
    type Number = T;

    const DIMENSION: usize = D;

    fn assemble(shape: Shape, coordinates: &[T]) -> Option<[T; D]> {
        (shape == Shape::Input).then(|| coordinates.try_into().ok())?
    }

    fn literal(&self) -> String {
        array(self)
    }
}

/// A point of the plane by its definition.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Point2<T = f64> {
    /// An input point.
    Input([T; 2]),
    /// The point where two lines meet, each through two points.
    Ssi([[[T; 2]; 2]; 2]),
}

/// A point of space by its definition.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Point3<T = f64> {
    /// An input point.
    Input([T; 3]),
    /// The point where a line through two points meets a plane through three.
    Lpi {
        /// Two points of the line.
        line: [[T; 3]; 2],
        /// Three points of the plane.
        plane: [[T; 3]; 3],
    },
    /// The point where three planes meet, each through three points.
    Tpi([[[T; 3]; 3]; 3]),
}

/// The points in a list of coordinates.
fn points<T: Number, const D: usize, const N: usize>(coordinates: &[T]) -> Option<[[T; D]; N]> {
    let (points, rest) = coordinates.as_chunks::<D>();
    if rest.is_empty() { points.try_into().ok() } else { None }
}

impl<T: Number> Point for Point2<T> {
    type Number = T;

    const DIMENSION: usize = 2;

    fn assemble(shape: Shape, coordinates: &[T]) -> Option<Point2<T>> {
        match shape {
            Shape::Input => coordinates.try_into().ok().map(Point2::Input),
            Shape::Ssi => points(coordinates).map(|[a, b, c, d]| Point2::Ssi([[a, b], [c, d]])),
            Shape::Lpi | Shape::Tpi => None,
        }
    }

    fn literal(&self) -> String {
        match self {
            Point2::Input(point) => format!("Point2::Input({})", array(point)),
            Point2::Ssi(lines) => format!("Point2::Ssi({})", nested(lines, |line| nested(line, |point| array(point)))),
        }
    }
}

impl<T: Number> Point for Point3<T> {
    type Number = T;

    const DIMENSION: usize = 3;

    fn assemble(shape: Shape, coordinates: &[T]) -> Option<Point3<T>> {
        match shape {
            Shape::Input => coordinates.try_into().ok().map(Point3::Input),
            Shape::Ssi => None,
            Shape::Lpi => points(coordinates).map(|[p, q, a, b, c]| Point3::Lpi { line: [p, q], plane: [a, b, c] }),
            Shape::Tpi => {
                points(coordinates).map(|[a, b, c, d, e, f, g, h, i]| Point3::Tpi([[a, b, c], [d, e, f], [g, h, i]]))
            }
        }
    }

    fn literal(&self) -> String {
        match self {
            Point3::Input(point) => format!("Point3::Input({})", array(point)),
            Point3::Lpi { line, plane } => {
                let [line, plane] = [nested(line, |point| array(point)), nested(plane, |point| array(point))];
                format!("Point3::Lpi {{ line: {line}, plane: {plane} }}")
            }
            Point3::Tpi(planes) => {
                format!("Point3::Tpi({})", nested(planes, |plane| nested(plane, |point| array(point))))
            }
        }
    }
}

fn array<T: Number>(point: &[T]) -> String {
    nested(point, |x| x.literal())
}

fn nested<X>(all: &[X], one: impl Fn(&X) -> String) -> String {
    format!("[{}]", all.iter().map(one).collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_as_expressions() {
        assert_eq!([1_i32, -2].literal(), "[1, -2]");
        let ssi = Point2::assemble(Shape::Ssi, &[0, 1, 2, 3, 4, 5, 6, 7_i64]).unwrap();
        assert_eq!(ssi.literal(), "Point2::Ssi([[[0, 1], [2, 3]], [[4, 5], [6, 7]]])");
        let lpi: Vec<i32> = (0..15).collect();
        let lpi = Point3::assemble(Shape::Lpi, &lpi).unwrap();
        assert_eq!(
            lpi.literal(),
            "Point3::Lpi { line: [[0, 1, 2], [3, 4, 5]], plane: [[6, 7, 8], [9, 10, 11], [12, 13, 14]] }"
        );
        let tpi: Vec<i32> = (0..27).collect();
        let Some(Point3::Tpi(planes)) = Point3::assemble(Shape::Tpi, &tpi) else { panic!("three planes") };
        assert_eq!(planes[2][2], [24, 25, 26]);
        assert_eq!(<[f64; 2]>::assemble(Shape::Ssi, &[0.0; 8]), None);
        assert_eq!(Point3::assemble(Shape::Ssi, &[0.0; 8]), None);
        assert_eq!(<[f64; 2]>::assemble(Shape::Input, &[0.0; 3]), None);
    }
}
