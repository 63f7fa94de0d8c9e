//! Faults in filters and integers: correct parts of the exact ladder, used outside of their conditions.

use predicament_arithmetic::bound::{static_incircle, static_insphere, static_orient2d, static_orient3d};
use predicament_arithmetic::{Fixed, Plan, units};
use predicament_exact::determinant::{self, Determinant};
use predicament_exact::filter;
use predicament_predicates::{Plane, Predicates, Question, Sign, Vertex};

use super::Session;

impl Session<'_> {
    /// The sign by the filter with this share of its bound; `None` if the filter cannot decide.
    pub(super) fn filtered(&self, question: Question, args: &[Vertex], share: f64) -> Option<Sign> {
        fn bound<const D: usize>(determinant: Determinant, points: &[[f64; D]]) -> f64 {
            let allowed = Plan::of(points).allows_filters(determinant.form);
            if allowed { determinant.bound } else { f64::NAN }
        }
        let scene = self.exact.scene();
        let flat = |plane, v: &[Vertex]| v.iter().map(|&v| scene.point2(plane, v)).collect::<Vec<_>>();
        let solid = || args.iter().map(|&v| scene.point3(v)).collect::<Vec<_>>();
        match question {
            Question::Compare(_) | Question::Derived(_) => None,
            Question::Orient2d(plane) => {
                let p = flat(plane, args);
                filter::orient2d(p[0], p[1], p[2], share * bound(determinant::ORIENT2D, &p))
            }
            Question::Orient3d => {
                let p = solid();
                filter::orient3d(p[0], p[1], p[2], p[3], share * bound(determinant::ORIENT3D, &p))
            }
            Question::Incircle => {
                let p = flat(Plane::Xy, args);
                filter::incircle(p[0], p[1], p[2], p[3], share * bound(determinant::INCIRCLE, &p))
            }
            Question::Insphere => {
                let p = solid();
                filter::insphere(p[0], p[1], p[2], p[3], p[4], share * bound(determinant::INSPHERE, &p))
            }
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
        fn rows<const D: usize, const N: usize>(points: &[[f64; D]]) -> Option<[[Fixed<1>; D]; N]> {
            let plan = Plan::of(points);
            let last = points.last()?;
            // The lower half of the difference, even if the upper half is significant.
            #[allow(clippy::cast_possible_truncation)]
            let entry = |row: usize, axis: usize| {
                Fixed::from(
                    units(points[row][axis], plan.lowest()).wrapping_sub(units(last[axis], plan.lowest())) as i64
                )
            };
            let fits = plan.bits() <= 126 && plan.has_finite_differences();
            fits.then(|| std::array::from_fn(|row| std::array::from_fn(|axis| entry(row, axis))))
        }
        let scene = self.exact.scene();
        let flat = |plane| args.iter().map(|&v| scene.point2(plane, v)).collect::<Vec<_>>();
        let solid = || args.iter().map(|&v| scene.point3(v)).collect::<Vec<_>>();
        match question {
            Question::Compare(_) | Question::Derived(_) => None,
            Question::Orient2d(plane) => rows(&flat(plane)).map(determinant::orient2d::<1, 2>),
            Question::Orient3d => rows(&solid()).map(determinant::orient3d::<1, 2, 3>),
            Question::Incircle => rows(&flat(Plane::Xy)).map(determinant::incircle::<1, 2, 4>),
            Question::Insphere => rows(&solid()).map(determinant::insphere::<1, 2, 3, 5>),
        }
    }
}
