//! Questions about constructed vertices, answered without rounding them.
//!
//! A vertex that lines and planes define has rational coordinates in general.
//! [`Constructed`] keeps, for each of a scene's [`Construction`]s, what is
//! needed to answer about the very point (*indirect predicates*: Attene,
//! "Indirect predicates for geometric constructions", 2020):
//!
//! * its coordinates, rounded to doubles, for a [`filter`] that knows how far
//!   they can be off: about the price of a question about input vertices;
//! * its exact homogeneous coordinates, integers over a common positive weight,
//!   for the determinants of homogeneous rows, in integers on the stack whose
//!   capacity suffices for every finite input: no rational, no allocation, and
//!   no condition on exponents.
//!
//! Lines and planes may go through constructed vertices in turn. Such `deep`
//! vertices have a row like the others, in lowest terms, and the same filter;
//! only where their rows are longer than any that input vertices define,
//! determinants are `whole` integers on the heap.
//!
//! Compare, orient2d in all projections, orient3d and incircle take constructed
//! vertices in any place and input vertices in the others; incircle has no filter
//! and is a determinant of `whole` integers. Insphere takes input vertices only.

#[macro_use]
mod capacity;
mod deep;
mod determinant;
pub mod filter;
mod points;
mod rows;
mod whole;

use predicament_arithmetic::dyadic::Space;
use predicament_predicates::{Axis, Construction, Declined, Plane, Scene, Sign, Vertex};

use crate::stage;
use filter::Approximate;
use rows::Rows;

/// The stage that settles a question which floating point can settle.
pub const FILTER: usize = stage::SEMI_STATIC;
/// The stage that settles the others.
pub const EXACT: usize = stage::DYADIC;

/// The constructed vertices of one scene.
#[derive(Clone, Debug)]
pub struct Constructed<'s> {
    /// Asked for its input vertices only.
    scene: &'s Scene,
    /// Coordinates, vertex after vertex, for the filter.
    approximations: Vec<f64>,
    rows: Rows<'s>,
}

impl<'s> Constructed<'s> {
    /// Evaluates the scene's constructions; where there is none, nothing is
    /// computed and nothing allocated.
    ///
    /// # Errors
    /// [`Declined`] names the first construction that does not define a point:
    /// parallel lines, a plane of collinear vertices, and the like.
    pub fn new(scene: &'s Scene) -> Result<Constructed<'s>, Declined> {
        let constructions = scene.constructions();
        let mut constructed = Constructed { scene, approximations: Vec::new(), rows: Rows::new(scene) };
        constructed.approximations.reserve(constructions.len() * scene.dimension().count());
        for (index, construction) in constructions.iter().enumerate() {
            constructed.push(construction).map_err(|why| {
                let vertex = Vertex::constructed(index);
                Declined::scene(format!("{vertex}, constructed as {construction}, is no point: {why}"))
            })?;
        }
        Ok(constructed)
    }

    /// Adds the next vertex, or says why it is no point.
    pub(crate) fn push(&mut self, construction: &Construction) -> Result<(), &'static str> {
        self.rows.align();
        let index = self.len();
        points::push(&mut self.rows, construction)?;
        let axes = 0..self.scene.dimension().count();
        self.approximations.extend(axes.map(|axis| self.rows.approximation(index, axis)));
        Ok(())
    }

    /// Removes all vertices but the first so many.
    pub(crate) fn truncate(&mut self, count: usize) {
        self.rows.truncate(count);
        self.approximations.truncate(count * self.scene.dimension().count());
    }

    /// How many vertices there are.
    pub(crate) fn len(&self) -> usize {
        self.approximations.len() / self.scene.dimension().count()
    }

    /// The approximate coordinates of a vertex, for output and broad phases: an
    /// input vertex' own, a constructed one's rounded to the nearest
    /// doubles or next to them, or within 2^-400. NaN where they are 2^1000 or more.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[inline(always)]
    #[must_use]
    pub fn approximation(&self, v: Vertex) -> &[f64] {
        let (table, at) = match v.construction() {
            None => (self.scene.coordinates(), v.index()),
            Some(index) => (self.approximations.as_slice(), index),
        };
        let stride = self.scene.dimension().count();
        &table[at * stride..][..stride]
    }

    /// The sign of a's coordinate minus b's, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex or axis.
    #[inline]
    #[must_use]
    pub fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> (Sign, usize) {
        match self.compare_by_filter(axis, a, b) {
            Some(sign) => (sign, FILTER),
            None => (self.compare_exactly(axis, [a, b]), EXACT),
        }
    }

    /// The sign of [`Constructed::compare`], or none if its filter leaves it open.
    ///
    /// # Panics
    /// As there.
    #[inline]
    #[must_use]
    pub fn compare_by_filter(&self, axis: Axis, a: Vertex, b: Vertex) -> Option<Sign> {
        let at = |v| self.approximate(v).coordinate(axis);
        filter::compare(at(a), at(b), filter::COMPARE)
    }

    /// The turn a, b, c in a coordinate plane, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex, or lacks an axis of the plane.
    #[inline]
    #[must_use]
    pub fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        match self.orient2d_by_filter(plane, a, b, c) {
            Some(sign) => (sign, FILTER),
            None => (self.orient2d_exactly(plane, [a, b, c]), EXACT),
        }
    }

    /// The sign of [`Constructed::orient2d`], or none if its filter leaves it open.
    ///
    /// # Panics
    /// As there.
    #[inline]
    #[must_use]
    pub fn orient2d_by_filter(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Option<Sign> {
        let [first, second] = plane.axes();
        let at = |v| {
            let point = self.approximate(v);
            [point.coordinate(first), point.coordinate(second)]
        };
        filter::orient2d(at(a), at(b), at(c), filter::ORIENT2D)
    }

    /// The side of d on the plane of a, b, c, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline]
    #[must_use]
    pub fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v| {
            let point = self.approximate(v);
            [point.coordinate(Axis::X), point.coordinate(Axis::Y), point.coordinate(Axis::Z)]
        };
        match filter::orient3d(at(a), at(b), at(c), at(d), filter::ORIENT3D) {
            Some(sign) => (sign, FILTER),
            None => (self.orient3d_exactly([a, b, c, d]), EXACT),
        }
    }

    /// Whether d is in the circle of a, b, c, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 3D.
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn incircle(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        let (mut limbs, [a, b, c, d]) = ([0; 2 * 8], vertices);
        let space = &mut Space::new(&mut limbs);
        let mut row = |v| self.rows.of(space, v, [Axis::X, Axis::Y]);
        (whole::incircle(&[row(a), row(b), row(c), row(d)]), EXACT)
    }

    /// [`Constructed::compare`] without its filter.
    ///
    /// # Panics
    /// As there.
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn compare_exactly(&self, axis: Axis, vertices: [Vertex; 2]) -> Sign {
        let (mut limbs, [a, b]) = ([0; 2 * 2], vertices);
        let space = &mut Space::new(&mut limbs);
        determinant::compare(&[self.rows.of(space, a, [axis]), self.rows.of(space, b, [axis])])
    }

    /// [`Constructed::orient2d`] without its filter.
    ///
    /// # Panics
    /// As there.
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn orient2d_exactly(&self, plane: Plane, vertices: [Vertex; 3]) -> Sign {
        let (mut limbs, [a, b, c]) = ([0; 2 * 6], vertices);
        let space = &mut Space::new(&mut limbs);
        let mut row = |v| self.rows.of(space, v, plane.axes());
        determinant::orient2d(&[row(a), row(b), row(c)])
    }

    /// [`Constructed::orient3d`] without its filter.
    ///
    /// # Panics
    /// As there.
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn orient3d_exactly(&self, vertices: [Vertex; 4]) -> Sign {
        let (mut limbs, [a, b, c, d]) = ([0; 2 * 12], vertices);
        let space = &mut Space::new(&mut limbs);
        let mut row = |v| self.rows.of(space, v, [Axis::X, Axis::Y, Axis::Z]);
        determinant::orient3d(&[row(a), row(b), row(c), row(d)])
    }

    /// What the filter knows of a vertex.
    #[inline(always)]
    fn approximate(&self, v: Vertex) -> Point<'_> {
        let errors = if v.is_constructed() { rows::ERRORS } else { 0.0 };
        Point { coordinates: self.approximation(v), errors }
    }
}

/// The coordinates of a vertex, exact or not.
#[derive(Clone, Copy)]
struct Point<'a> {
    coordinates: &'a [f64],
    errors: f64,
}

impl Point<'_> {
    #[inline(always)]
    fn coordinate(self, axis: Axis) -> Approximate {
        Approximate::within(self.coordinates[axis.index()], self.errors)
    }
}
