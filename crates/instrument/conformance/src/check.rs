//! Checks of predicates: one function for each predicate.
//!
//! A closure receives points as arrays, `[T; 2]` or `[T; 3]`, where `T` is `f64`, `f32`, `i64` or `i32`. The type of
//! its arguments selects the type of coordinates. It returns anything that converts to [`Answer`].
//!
//! Signs follow one convention: [`orient2d`] is positive for a left turn; [`orient3d`] is positive if `d` is on the
//! side of the plane from which a, b and c are clockwise; [`incircle`] and [`insphere`] are positive inside, for a, b,
//! c (and d) in positive orientation. [`Check::opposite`] is for the other convention.

use std::ops::RangeInclusive;

use predicament_predicates::PredicateKind;

use crate::query::Subject;
use crate::{Answer, Number, Point, Report};

pub mod indirect;

/// A predicate: it takes the way in which it is asked, an axis or a plane, and the arguments.
type Predicate<'f, P> = Box<dyn FnMut(usize, &[P]) -> Answer + 'f>;

/// A check of one predicate; the functions of this module make it.
#[must_use = "a check runs when `assert` or `report` is called"]
pub struct Check<'f, P> {
    pub(crate) subject: Subject,
    pub(crate) is_indirect: bool,
    pub(crate) predicate: Predicate<'f, P>,
    pub(crate) call: String,
    pub(crate) seed: u64,
    pub(crate) cases: usize,
    pub(crate) may_be_undecided: bool,
    pub(crate) exponents: Option<RangeInclusive<i64>>,
}

/// The number of generated queries of a check, if nothing else is asked for.
pub const CASES: usize = 10_000;
/// The same for [`indirect`] predicates, whose points have to be solved.
pub const INDIRECT_CASES: usize = 3000;

impl<'f, P: Point> Check<'f, P> {
    fn new(
        kind: PredicateKind,
        ways: &'static [(&'static str, &'static [usize])],
        predicate: Predicate<'f, P>,
    ) -> Check<'f, P> {
        Check {
            subject: Subject { kind, dimension: P::DIMENSION, ways },
            is_indirect: false,
            predicate,
            call: kind.name().to_owned(),
            seed: 1,
            cases: CASES,
            may_be_undecided: false,
            exponents: None,
        }
    }

    /// Sets the seed of generated queries; the default is 1.
    pub fn seed(mut self, seed: u64) -> Check<'f, P> {
        self.seed = seed;
        self
    }

    /// Sets the number of generated queries, over all families; the default is [`CASES`] or [`INDIRECT_CASES`]. A scene
    /// that is written out gives at most a twentieth of this number.
    pub fn cases(mut self, cases: usize) -> Check<'f, P> {
        self.cases = cases;
        self
    }

    /// Turns the signs of the predicate, for the opposite convention.
    pub fn opposite(mut self) -> Check<'f, P> {
        let mut predicate = self.predicate;
        self.predicate = Box::new(move |way, points| predicate(way, points).opposite());
        self
    }

    /// Lets the predicate be undecided: a filter, for instance. It must still decide one query.
    pub fn may_be_undecided(mut self) -> Check<'f, P> {
        self.may_be_undecided = true;
        self
    }

    /// Asks only queries whose coordinates have all their bits between 2^start and 2^end, for a predicate that does not
    /// promise more. The report counts the others as left out.
    pub fn exponents(mut self, exponents: RangeInclusive<i64>) -> Check<'f, P> {
        self.exponents = Some(exponents);
        self
    }

    /// Names the predicate as regression tests call it, such as `mine::orient2d`.
    pub fn called(mut self, path: impl Into<String>) -> Check<'f, P> {
        self.call = path.into();
        self
    }

    /// Runs the check.
    #[must_use]
    pub fn report(self) -> Report<P> {
        crate::run::run(self)
    }

    /// Runs the check, and panics with the report unless the predicate conforms.
    ///
    /// # Panics
    /// Unless [`Report::conforms`].
    #[track_caller]
    pub fn assert(self) {
        let report = self.report();
        assert!(report.conforms(), "the predicate does not conform\n\n{report}");
    }
}

/// The only way to ask about all coordinates.
pub(crate) const PLANE: &[(&str, &[usize])] = &[("", &[0, 1])];
pub(crate) const SPACE: &[(&str, &[usize])] = &[("", &[0, 1, 2])];

/// Checks the turn of three points of the plane: positive if a, b and c are counterclockwise.
///
/// ```
/// use predicament_conformance::check;
///
/// fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
///     (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
/// }
///
/// let report = check::orient2d(orient2d).cases(1000).report();
/// assert!(report.wrong > 0, "plain doubles are not exact");
/// ```
pub fn orient2d<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut([T; 2], [T; 2], [T; 2]) -> A + 'f,
) -> Check<'f, [T; 2]> {
    let asked = move |_: usize, p: &[[T; 2]]| predicate(p[0], p[1], p[2]).into();
    Check::new(PredicateKind::Orient2d, PLANE, Box::new(asked))
}

/// Checks the side of a plane: positive if d is below the plane of a, b and c, which are counterclockwise from above.
pub fn orient3d<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut([T; 3], [T; 3], [T; 3], [T; 3]) -> A + 'f,
) -> Check<'f, [T; 3]> {
    let asked = move |_: usize, p: &[[T; 3]]| predicate(p[0], p[1], p[2], p[3]).into();
    Check::new(PredicateKind::Orient3d, SPACE, Box::new(asked))
}

/// Checks the side of a circle: positive if d is inside of the circle through a, b and c, which are counterclockwise.
pub fn incircle<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut([T; 2], [T; 2], [T; 2], [T; 2]) -> A + 'f,
) -> Check<'f, [T; 2]> {
    let asked = move |_: usize, p: &[[T; 2]]| predicate(p[0], p[1], p[2], p[3]).into();
    Check::new(PredicateKind::Incircle, PLANE, Box::new(asked))
}

/// Checks the side of a sphere: positive if e is inside of the sphere through a, b, c and d, for which [`orient3d`] is
/// positive.
pub fn insphere<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut([T; 3], [T; 3], [T; 3], [T; 3], [T; 3]) -> A + 'f,
) -> Check<'f, [T; 3]> {
    let asked = move |_: usize, p: &[[T; 3]]| predicate(p[0], p[1], p[2], p[3], p[4]).into();
    Check::new(PredicateKind::Insphere, SPACE, Box::new(asked))
}
