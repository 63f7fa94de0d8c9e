//! A query: the coordinates that define its points, and everything that can be said about it without a predicate.

use predicament_judge::portable;
use predicament_predicates::{PredicateKind, Sign};

use crate::{Number, Point, Shape};

/// A predicate that is checked: its kind, the dimension of its points, and the ways in which it is asked.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Subject {
    /// The predicate.
    pub kind: PredicateKind,
    /// The number of coordinates of an input point.
    pub dimension: usize,
    /// The coordinates that each way reads, and the name of the way: an axis, a plane, or nothing.
    pub ways: &'static [(&'static str, &'static [usize])],
}

/// One query.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Query<T> {
    /// The way in which it is asked: an index in [`Subject::ways`].
    pub way: usize,
    /// The form of each argument.
    pub shapes: Vec<Shape>,
    /// The coordinates of all input points, one argument after the other.
    pub coordinates: Vec<T>,
}

impl<T: Number> Query<T> {
    /// The arguments; `None` if the type of points has no such shape.
    pub(crate) fn points<P: Point<Number = T>>(&self) -> Option<Vec<P>> {
        self.arguments(P::DIMENSION).map(|(shape, coordinates)| P::assemble(shape, coordinates)).collect()
    }

    /// The shape of each argument, with its coordinates.
    fn arguments(&self, dimension: usize) -> impl Iterator<Item = (Shape, &[T])> {
        let mut rest = self.coordinates.as_slice();
        self.shapes.iter().map(move |&shape| {
            let (own, others) = rest.split_at(shape.size() * dimension);
            rest = others;
            (shape, own)
        })
    }

    /// The exact sign; `None` if a definition gives no point.
    pub(crate) fn truth(&self, subject: Subject) -> Option<Sign> {
        let numbers: Vec<portable::Number> = self.coordinates.iter().map(|x| x.judged()).collect();
        let inputs = portable::points(subject.dimension, &numbers);
        let mut rest = inputs.as_slice();
        let (_, axes) = subject.ways[self.way];
        let mut points = Vec::with_capacity(self.shapes.len());
        for shape in &self.shapes {
            let (own, others) = rest.split_at(shape.size());
            rest = others;
            points.push(shape.solve(own)?.on(axes));
        }
        let points: Vec<&portable::Point> = points.iter().collect();
        Some(if subject.kind.is_lifted() { portable::sphere(&points) } else { portable::orientation(&points) })
    }

    /// The query with two arguments exchanged.
    pub(crate) fn swapped(&self, dimension: usize, first: usize, second: usize) -> Query<T> {
        let mut arguments: Vec<(Shape, &[T])> = self.arguments(dimension).collect();
        arguments.swap(first, second);
        let coordinates = arguments.iter().flat_map(|(_, own)| own.iter().copied()).collect();
        Query { way: self.way, shapes: arguments.iter().map(|(shape, _)| *shape).collect(), coordinates }
    }

    /// The query with other coordinates; `None` if one of them is not representable.
    pub(crate) fn mapped(&self, map: impl FnMut((usize, &T)) -> Option<T>) -> Option<Query<T>> {
        let coordinates = self.coordinates.iter().enumerate().map(map).collect::<Option<_>>()?;
        Some(Query { way: self.way, shapes: self.shapes.clone(), coordinates })
    }

    /// The query with coordinates of another type; `None` if `map` gives none.
    pub(crate) fn mapped_to<U>(self, map: impl FnOnce(&[T]) -> Option<Vec<U>>) -> Option<Query<U>> {
        let coordinates = map(&self.coordinates)?;
        Some(Query { way: self.way, shapes: self.shapes, coordinates })
    }

    /// The query with all points moved along each axis; `None` if a sum is not exact.
    pub(crate) fn moved(&self, by: &[T]) -> Option<Query<T>> {
        self.mapped(|(at, x)| x.plus(by[at % by.len()]))
    }

    /// The query times 2^k; `None` if a product is not exact.
    pub(crate) fn times_power(&self, k: i32) -> Option<Query<T>> {
        self.mapped(|(_, x)| x.times_power(k))
    }

    /// The largest exponent of a highest bit and the smallest of a lowest bit; `None` if all coordinates are zero.
    pub(crate) fn exponents(&self) -> Option<[i64; 2]> {
        let bits = || self.coordinates.iter().filter_map(|x| x.bits());
        Some([bits().map(|[high, _]| high).max()?, bits().map(|[_, low]| low).min()?])
    }
}
