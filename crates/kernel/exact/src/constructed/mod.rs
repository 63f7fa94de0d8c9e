//! Predicates on constructed vertices, answered without rounding the vertices.
//!
//! A vertex that lines and planes define, or an exact share of a segment, has rational coordinates in general.
//! [`Constructed`] stores, for each of a scene's [`Construction`]s, the data to answer about the exact point (*indirect
//! predicates*: Attene, "Indirect predicates for geometric constructions", 2020):
//!
//! * coordinates in doubles with an error bound, for a [`filter`] that uses it, at about the price of a query about
//!   input vertices. They are computed at construction, in floating point (`approximate`), which also proves that there
//!   is a point; exact numbers are used only if it can't;
//! * its exact homogeneous coordinates, integers over a common positive weight, computed on first use and then kept
//!   (`rows`). With them come coordinates that are rounded only once, for the same filter. Then come determinants of
//!   homogeneous rows, in integers on the stack whose capacity suffices for every finite input: no rational, no
//!   allocation, and no condition on exponents.
//!
//! The stage that settles a query depends on the query alone, not on earlier queries.
//!
//! Lines and planes may go through constructed vertices in turn. Such `deep` vertices have approximations and a row
//! like the others, in lowest terms, and the same filter. Only if their rows are longer than any that input vertices
//! define, determinants are `whole` integers on the heap.
//!
//! Compare, orient2d in all projections, orient3d and incircle take constructed vertices in any place and input
//! vertices in the others; incircle has no filter and is a determinant of `whole` integers. Insphere takes input
//! vertices only.

use alloc::{format, vec::Vec};

#[macro_use]
mod capacity;
pub mod approximate;
mod deep;
mod demand;
mod determinant;
pub mod filter;
mod points;
mod rows;
pub mod tight;
mod whole;

use predicament_arithmetic::dyadic::Space;
use predicament_predicates::{
    Axis, Construction, Declined, DefinitionError, Dimension, NoPoint, Plane, Refused, Scene, Sign, Vertex,
};

use crate::stage;
use approximate::Near;
use filter::{Approximate, FLOOR};
use rows::{Found, Row, Rows, View};

/// The stage that settles a query which floating point can settle.
pub const FILTER: usize = stage::SEMI_STATIC;
/// The stage that settles all other queries.
pub const EXACT: usize = stage::DYADIC;

/// The constructed vertices of one scene.
#[derive(Clone, Debug)]
pub struct Constructed {
    /// The scene, including the vertices constructed since.
    scene: Scene,
    table: Table,
    rows: Rows,
}

/// Doubles and slack of each vertex; only the list of the scene's dimension is filled.
#[derive(Clone, Default, Debug)]
struct Table {
    flat: Vec<[f64; 3]>,
    solid: Vec<[f64; 4]>,
}

impl Constructed {
    /// Computes the scene's constructed points.
    ///
    /// For a scene without constructed vertices nothing is computed and nothing allocated.
    ///
    /// # Errors
    /// [`Declined`] names the first construction that does not define a point: parallel lines, a plane of collinear
    /// vertices, and the like.
    pub fn new(scene: &Scene) -> Result<Constructed, Declined> {
        let mut constructed = Constructed { scene: scene.clone(), table: Table::default(), rows: Rows::default() };
        let Constructed { table, rows, .. } = &mut constructed;
        table.reserve(scene.dimension(), scene.constructions().len());
        rows.reserve(scene.constructions().len());
        for (index, construction) in scene.constructions().iter().enumerate() {
            push(scene, table, rows, construction).map_err(|why| {
                let vertex = Vertex::constructed(index);
                Declined::scene(format!("{vertex}, constructed as {construction}, is not a point: {why}"))
            })?;
        }
        Ok(constructed)
    }

    /// Adds vertices, as described in [`Session::construct_where`](crate::Session::construct_where).
    pub(crate) fn construct_where(
        &mut self,
        definitions: &[Construction],
        accepts: &dyn Fn(&Construction) -> Result<(), DefinitionError>,
    ) -> Result<Vec<Vertex>, Refused> {
        let Constructed { scene, table, rows } = self;
        let before = scene.constructions().len();
        let mut is_first = true;
        let vertices = scene.construct_all(definitions, |scene, vertex| {
            let construction = scene.construction(vertex).expect("just constructed");
            accepts(construction)?;
            if core::mem::take(&mut is_first) && definitions.len() > 1 {
                table.reserve(scene.dimension(), definitions.len());
                rows.reserve(definitions.len());
            }
            push(scene, table, rows, construction).map_err(DefinitionError::from)
        });
        if vertices.is_err() {
            table.truncate(before);
            rows.truncate(before);
        }
        vertices
    }

    /// The scene, with all constructed vertices.
    #[inline(always)]
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The approximate coordinates of a vertex, for output and broad phases.
    ///
    /// An input vertex has its own coordinates. A constructed vertex has the nearest doubles, or doubles next to them,
    /// or doubles within 2^-400; NaN for coordinates of 2^1000 or more. The method uses the exact row: the first call
    /// for a vertex costs as much as the row.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn approximation(&self, v: Vertex) -> &[f64] {
        match v.construction() {
            None => self.scene.point(v),
            Some(index) => self.view().row(index).rounded(self.scene.dimension().count()),
        }
    }

    /// Doubles near a vertex, and their slack: they are off by at most the slack times 2^-53.
    ///
    /// The coordinates of an input vertex are exact. For a constructed vertex they were computed at construction. If a
    /// coordinate is NaN, so is the slack.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[inline(always)]
    #[must_use]
    pub fn near(&self, v: Vertex) -> (&[f64], f64) {
        match (v.construction(), self.scene.dimension()) {
            (None, _) => (self.scene.point(v), FLOOR),
            (Some(index), Dimension::Two) => {
                let [point @ .., slack] = &self.table.flat[index];
                (point, *slack)
            }
            (Some(index), Dimension::Three) => {
                let [point @ .., slack] = &self.table.solid[index];
                (point, *slack)
            }
        }
    }

    #[inline(always)]
    fn view(&self) -> View<'_> {
        View { scene: &self.scene, rows: &self.rows }
    }

    /// The sign of a's coordinate minus b's, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex or axis.
    #[inline]
    #[must_use]
    pub fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> (Sign, usize) {
        match self.first_compare(axis, [a, b]) {
            Some(sign) => (sign, FILTER),
            None => self.next_compare(axis, [a, b]),
        }
    }

    #[inline(always)]
    fn first_compare(&self, axis: Axis, [a, b]: [Vertex; 2]) -> Option<Sign> {
        let at = |v| self.computed(v, [axis]);
        let ([a], [b]) = (at(a), at(b));
        filter::compare(a, b, filter::COMPARE)
    }

    #[cold]
    #[inline(never)]
    fn next_compare(&self, axis: Axis, [a, b]: [Vertex; 2]) -> (Sign, usize) {
        let view = self.view();
        let (a, b) = (view.find(a), view.find(b));
        let ([x], [y]) = (a.rounded([axis]), b.rounded([axis]));
        match filter::compare(x, y, filter::COMPARE) {
            Some(sign) => (sign, FILTER),
            None => (self.order(axis, [a, b]), EXACT),
        }
    }

    #[inline(always)]
    fn order(&self, axis: Axis, found: [Found; 2]) -> Sign {
        let (mut limbs, [a, b]) = ([0; 2 * 2], found);
        let space = &mut Space::new(&mut limbs);
        determinant::compare(&[self.view().of(space, a, [axis]), self.view().of(space, b, [axis])])
    }

    /// The sign of [`Constructed::compare`]; `None` if its filters leave it open.
    ///
    /// # Panics
    /// As [`Constructed::compare`].
    #[inline]
    #[must_use]
    pub fn compare_by_filter(&self, axis: Axis, a: Vertex, b: Vertex) -> Option<Sign> {
        self.first_compare(axis, [a, b]).or_else(|| {
            let ([a], [b]) = (self.view().find(a).rounded([axis]), self.view().find(b).rounded([axis]));
            filter::compare(a, b, filter::COMPARE)
        })
    }

    /// The turn a, b, c in a coordinate plane, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex, or lacks an axis of the plane.
    #[inline]
    #[must_use]
    pub fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        match self.first_orient2d(plane, [a, b, c]) {
            Some(sign) => (sign, FILTER),
            None => self.next_orient2d(plane, [a, b, c]),
        }
    }

    #[inline(always)]
    fn first_orient2d(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> Option<Sign> {
        let axes = plane.axes();
        let at = |v| self.computed(v, axes);
        filter::orient2d(at(a), at(b), at(c), filter::ORIENT2D)
    }

    #[cold]
    #[inline(never)]
    fn next_orient2d(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> (Sign, usize) {
        match self.tight_orient2d(plane, [a, b, c]) {
            Some(sign) => (sign, FILTER),
            None => (self.turn(plane, [a, b, c].map(|v| self.view().find(v))), EXACT),
        }
    }

    /// The turn by the computed points, or else by the exact rows, rounded once.
    #[inline(always)]
    fn tight_orient2d(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> Option<Sign> {
        let axes = plane.axes();
        let computed = |v| self.computed(v, axes);
        let rounded = |v| self.view().find(v).rounded(axes);
        tight::orient2d(computed(a), computed(b), computed(c))
            .or_else(|| tight::orient2d(rounded(a), rounded(b), rounded(c)))
    }

    #[inline(always)]
    fn turn(&self, plane: Plane, found: [Found; 3]) -> Sign {
        let (mut limbs, [a, b, c]) = ([0; 2 * 6], found);
        let space = &mut Space::new(&mut limbs);
        let axes = plane.axes();
        let mut row = |v| self.view().of(space, v, axes);
        determinant::orient2d(&[row(a), row(b), row(c)])
    }

    /// The sign of [`Constructed::orient2d`]; `None` if the first of its filters leaves it open.
    ///
    /// # Panics
    /// As [`Constructed::orient2d`].
    #[inline]
    #[must_use]
    pub fn orient2d_by_first_filter(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Option<Sign> {
        self.first_orient2d(plane, [a, b, c])
    }

    /// The sign of [`Constructed::orient2d`]; `None` if its filters leave it open.
    ///
    /// # Panics
    /// As [`Constructed::orient2d`].
    #[inline]
    #[must_use]
    pub fn orient2d_by_filter(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Option<Sign> {
        self.first_orient2d(plane, [a, b, c]).or_else(|| self.tight_orient2d(plane, [a, b, c]))
    }

    /// The side of d on the plane of a, b, c, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline]
    #[must_use]
    pub fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v| self.computed(v, AXES);
        match filter::orient3d(at(a), at(b), at(c), at(d), filter::ORIENT3D) {
            Some(sign) => (sign, FILTER),
            None => self.next_orient3d([a, b, c, d]),
        }
    }

    #[cold]
    #[inline(never)]
    fn next_orient3d(&self, [a, b, c, d]: [Vertex; 4]) -> (Sign, usize) {
        let computed = |v| self.computed(v, AXES);
        if let Some(sign) = tight::orient3d(computed(a), computed(b), computed(c), computed(d)) {
            return (sign, FILTER);
        }
        let view = self.view();
        let (a, b, c, d) = (view.find(a), view.find(b), view.find(c), view.find(d));
        let rounded = |found: Found| found.rounded(AXES);
        match tight::orient3d(rounded(a), rounded(b), rounded(c), rounded(d)) {
            Some(sign) => (sign, FILTER),
            None => (self.side([a, b, c, d]), EXACT),
        }
    }

    #[inline(always)]
    fn side(&self, found: [Found; 4]) -> Sign {
        let (mut limbs, [a, b, c, d]) = ([0; 2 * 12], found);
        let space = &mut Space::new(&mut limbs);
        let mut row = |v| self.view().of(space, v, AXES);
        determinant::orient3d(&[row(a), row(b), row(c), row(d)])
    }

    /// The position of d relative to the circle of a, b, c, and the stage that settled it.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 3D.
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn incircle(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        let (mut limbs, [a, b, c, d]) = ([0; 2 * 8], vertices);
        let space = &mut Space::new(&mut limbs);
        let mut row = |v| self.view().of(space, self.view().find(v), [Axis::X, Axis::Y]);
        (whole::incircle(&[row(a), row(b), row(c), row(d)]), EXACT)
    }

    /// The answer of [`Constructed::compare`] without its filters.
    ///
    /// # Panics
    /// As [`Constructed::compare`].
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn compare_exactly(&self, axis: Axis, vertices: [Vertex; 2]) -> Sign {
        assert!(axis.index() < self.scene.dimension().count(), "the scene has no such axis");
        self.order(axis, vertices.map(|v| self.view().find(v)))
    }

    /// The answer of [`Constructed::orient2d`] without its filters.
    ///
    /// # Panics
    /// As [`Constructed::orient2d`].
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn orient2d_exactly(&self, plane: Plane, vertices: [Vertex; 3]) -> Sign {
        assert!(plane == Plane::Xy || self.scene.dimension() == Dimension::Three, "the scene has no such plane");
        self.turn(plane, vertices.map(|v| self.view().find(v)))
    }

    /// The answer of [`Constructed::orient3d`] without its filters.
    ///
    /// # Panics
    /// As [`Constructed::orient3d`].
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn orient3d_exactly(&self, vertices: [Vertex; 4]) -> Sign {
        assert!(self.scene.dimension() == Dimension::Three, "the scene is 2D");
        self.side(vertices.map(|v| self.view().find(v)))
    }

    /// The coordinates of a vertex for the first filter.
    #[inline(always)]
    fn computed<const K: usize>(&self, v: Vertex, axes: [Axis; K]) -> [Approximate; K] {
        let (point, slack) = self.near(v);
        axes.map(|axis| Approximate::near(point[axis.index()], slack))
    }
}

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

impl Table {
    fn reserve(&mut self, dimension: Dimension, count: usize) {
        match dimension {
            Dimension::Two => self.flat.reserve(count),
            Dimension::Three => self.solid.reserve(count),
        }
    }

    fn truncate(&mut self, count: usize) {
        self.flat.truncate(count);
        self.solid.truncate(count);
    }

    /// The approximate point of a vertex of a 2D scene.
    #[inline(always)]
    fn flat(&self, points: &[[f64; 2]], v: Vertex) -> Near<2> {
        match v.construction() {
            None => Near { point: points[v.index()], slack: 0.0 },
            Some(index) => {
                let [x, y, slack] = self.flat[index];
                Near { point: [x, y], slack }
            }
        }
    }

    /// The approximate point of a vertex of a 3D scene.
    #[inline(always)]
    fn solid(&self, points: &[[f64; 3]], v: Vertex) -> Near<3> {
        match v.construction() {
            None => Near { point: points[v.index()], slack: 0.0 },
            Some(index) => {
                let [x, y, z, slack] = self.solid[index];
                Near { point: [x, y, z], slack }
            }
        }
    }
}

/// Adds the next vertex of the scene, or returns the reason why it has no point.
///
/// Points are read one by one: `map` on nested arrays is a call, unless the compiler happens to inline it.
#[inline(always)]
fn push(scene: &Scene, table: &mut Table, rows: &mut Rows, construction: &Construction) -> Result<(), NoPoint> {
    rows.push();
    match scene.dimension() {
        Dimension::Two => {
            let points = scene.coordinates().as_chunks().0;
            let at = |v| table.flat(points, v);
            let near = match *construction {
                Construction::Ssi([[a, b], [c, d]]) => approximate::segments(&[[at(a), at(b)], [at(c), at(d)]]),
                Construction::Ratio { ends: [a, c], share } => approximate::shared(&[at(a), at(c)], share),
                _ => unreachable!("the scene has taken it"),
            };
            let entry = match near {
                Some(Near { point: [x, y], slack }) => [x, y, slack],
                None => admitted(View { scene, rows })?,
            };
            table.flat.push(entry);
        }
        Dimension::Three => {
            let points = scene.coordinates().as_chunks().0;
            let at = |v| table.solid(points, v);
            let near = match *construction {
                Construction::Lpi { line: [p, q], plane: [a, b, c] } => {
                    approximate::line_plane(&[at(p), at(q)], &[at(a), at(b), at(c)])
                }
                Construction::Tpi([[a, b, c], [d, e, f], [g, h, i]]) => {
                    approximate::planes(&[[at(a), at(b), at(c)], [at(d), at(e), at(f)], [at(g), at(h), at(i)]])
                }
                Construction::Ratio { ends: [a, c], share } => approximate::shared(&[at(a), at(c)], share),
                Construction::Ssi(_) => unreachable!("the scene has taken it"),
            };
            let entry = match near {
                Some(Near { point: [x, y, z], slack }) => [x, y, z, slack],
                None => admitted(View { scene, rows })?,
            };
            table.solid.push(entry);
        }
    }
    Ok(())
}

/// Doubles and slack of the last vertex, for which floating point can't prove that there is a point.
///
/// N is the number of axes plus one.
#[cold]
#[inline(never)]
fn admitted<const N: usize>(rows: View) -> Result<[f64; N], NoPoint> {
    let row: &Row = rows.admit()?;
    let rounded = row.rounded(N - 1);
    let mut entry = [0.0; N];
    entry[..N - 1].copy_from_slice(rounded);
    let largest = rounded.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let is_known = rounded.iter().all(|x| !x.is_nan());
    entry[N - 1] = if is_known { rows::ERRORS * largest + FLOOR } else { f64::NAN };
    Ok(entry)
}
