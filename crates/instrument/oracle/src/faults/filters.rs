//! Faults in filters and integers: correct parts of the exact ladder, used outside of their conditions.

use predicament_arithmetic::bound::{static_incircle, static_insphere, static_orient2d, static_orient3d};
use predicament_arithmetic::{Fixed, Plan, units};
use predicament_exact::determinant;
use predicament_exact::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use predicament_predicates::{Plane, Predicates, Question, Sign, Vertex};

use super::Session;

impl Session<'_> {
    /// The sign by the filter with this share of its bound; `None` if the filter cannot decide.
    pub(super) fn filtered(&self, question: Question, args: &[Vertex], share: f64) -> Option<Sign> {
        fn certain<P: Predicate<D, N>, const D: usize, const N: usize>(
            points: [[f64; D]; N],
            share: f64,
        ) -> Option<Sign> {
            let is_allowed = Plan::of(&points).allows_filters(P::DETERMINANT.form);
            if is_allowed { P::estimate(points).certain(share * P::DETERMINANT.bound) } else { None }
        }
        match question {
            Question::Compare(_) | Question::Derived(_) => None,
            Question::Orient2d(plane) => certain::<Orient2d, 2, 3>(self.flat(plane, args), share),
            Question::Orient3d => certain::<Orient3d, 3, 4>(self.solid(args), share),
            Question::Incircle => certain::<Incircle, 2, 4>(self.flat(Plane::Xy, args), share),
            Question::Insphere => certain::<Insphere, 3, 5>(self.solid(args), share),
        }
    }

    /// The sign of the plain floating-point determinant, if it is a number beyond the bound.
    pub(super) fn fooled(&self, question: Question, args: &[Vertex], bound: f64) -> Option<Sign> {
        let determinant = self.float.estimate(question, args)?;
        (determinant.is_finite() && determinant.abs() > bound).then(|| Sign::of(determinant))
    }

    /// The static bound for the bounding box of the scene's first half of vertices.
    pub(super) fn stale(&self, question: Question) -> f64 {
        let scene = self.exact.scene();
        let count = scene.dimension().count();
        let half = &scene.coordinates()[..scene.len().div_ceil(2) * count];
        let length = |axis: usize| {
            let along = half.iter().skip(axis).step_by(count);
            let [low, high] =
                along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &x| [low.min(x), high.max(x)]);
            high - low
        };
        let flat = |plane: Plane| plane.axes().map(|axis| length(axis.index()));
        match question {
            Question::Compare(_) | Question::Derived(_) => 0.0,
            Question::Orient2d(plane) => static_orient2d(flat(plane)),
            Question::Orient3d => static_orient3d([0, 1, 2].map(length)),
            Question::Incircle => static_incircle(flat(Plane::Xy)),
            Question::Insphere => static_insphere([0, 1, 2].map(length)),
        }
    }

    /// The sign by integers of one limb; `None` if two limbs would not suffice.
    pub(super) fn one_limb(&self, question: Question, args: &[Vertex]) -> Option<Sign> {
        fn sign<P: Predicate<D, N>, const D: usize, const N: usize>(points: [[f64; D]; N]) -> Option<Sign> {
            let plan = Plan::of(&points);
            let last = points[N - 1];
            // The lower half of the difference, even if the upper half is significant.
            #[allow(clippy::cast_possible_truncation)]
            let entry = |row: usize, axis: usize| {
                Fixed::from(
                    units(points[row][axis], plan.lowest()).wrapping_sub(units(last[axis], plan.lowest())) as i64
                )
            };
            let fits = plan.bits() <= 126 && plan.has_finite_differences();
            let rows = || std::array::from_fn(|row| std::array::from_fn(|axis| entry(row, axis)));
            fits.then(|| P::integer(rows(), P::DETERMINANT.limbs(determinant::BITS[0])))
        }
        match question {
            Question::Compare(_) | Question::Derived(_) => None,
            Question::Orient2d(plane) => sign::<Orient2d, 2, 3>(self.flat(plane, args)),
            Question::Orient3d => sign::<Orient3d, 3, 4>(self.solid(args)),
            Question::Incircle => sign::<Incircle, 2, 4>(self.flat(Plane::Xy, args)),
            Question::Insphere => sign::<Insphere, 3, 5>(self.solid(args)),
        }
    }

    /// The points of a query in a plane.
    fn flat<const N: usize>(&self, plane: Plane, args: &[Vertex]) -> [[f64; 2]; N] {
        std::array::from_fn(|at| self.exact.scene().point2(plane, args[at]))
    }

    /// The points of a query in space.
    fn solid<const N: usize>(&self, args: &[Vertex]) -> [[f64; 3]; N] {
        std::array::from_fn(|at| self.exact.scene().point3(args[at]))
    }
}
