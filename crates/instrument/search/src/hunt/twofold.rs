//! Determinants in plain doubles, in pairs of doubles, and by magnitude.
//!
//! The rounding error of a determinant is the difference of the first two; it is divided by the third. Pairs hold some
//! 106 bits, which is enough for an objective: it decides nothing. If a product underflows or overflows, pairs are as
//! wrong as doubles.

use predicament_predicates::{Derived, PredicateKind, Question, Scene, Vertex};

/// The points of a query, with zeros for missing points and third coordinates.
pub(super) type Points = [[f64; 3]; 5];

/// A number type for the computation of determinants.
trait Ring: Copy {
    fn difference(a: f64, b: f64) -> Self;
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn times(self, other: Self) -> Self;
}

impl Ring for f64 {
    fn difference(a: f64, b: f64) -> f64 {
        a - b
    }

    fn plus(self, other: f64) -> f64 {
        self + other
    }

    fn minus(self, other: f64) -> f64 {
        self - other
    }

    fn times(self, other: f64) -> f64 {
        self * other
    }
}

/// An unevaluated sum of two doubles, the second much smaller than the first.
#[derive(Clone, Copy)]
struct Pair(f64, f64);

/// The exact sum of two doubles (Knuth).
fn sum(a: f64, b: f64) -> Pair {
    let s = a + b;
    let of_b = s - a;
    Pair(s, (a - (s - of_b)) + (b - of_b))
}

/// The exact sum of two doubles, the first at least as large as the second (Dekker).
fn sum_of_large_and_small(a: f64, b: f64) -> Pair {
    let s = a + b;
    Pair(s, b - (s - a))
}

/// The exact product of two doubles, unless it overflows (Dekker).
fn product(a: f64, b: f64) -> Pair {
    let halves = |x: f64| {
        let wide = 134_217_729.0 * x;
        let high = wide - (wide - x);
        [high, x - high]
    };
    let (p, [ah, al], [bh, bl]) = (a * b, halves(a), halves(b));
    Pair(p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl Ring for Pair {
    fn difference(a: f64, b: f64) -> Pair {
        sum(a, -b)
    }

    fn plus(self, other: Pair) -> Pair {
        let (high, low) = (sum(self.0, other.0), sum(self.1, other.1));
        let first = sum_of_large_and_small(high.0, high.1 + low.0);
        sum_of_large_and_small(first.0, first.1 + low.1)
    }

    fn minus(self, other: Pair) -> Pair {
        self.plus(Pair(-other.0, -other.1))
    }

    fn times(self, other: Pair) -> Pair {
        let high = product(self.0, other.0);
        sum_of_large_and_small(high.0, high.1 + (self.0 * other.1 + self.1 * other.0))
    }
}

/// The magnitude of terms; a determinant of magnitudes is a permanent.
#[derive(Clone, Copy)]
struct Magnitude(f64);

impl Ring for Magnitude {
    fn difference(a: f64, b: f64) -> Magnitude {
        Magnitude((a - b).abs())
    }

    fn plus(self, other: Magnitude) -> Magnitude {
        Magnitude(self.0 + other.0)
    }

    fn minus(self, other: Magnitude) -> Magnitude {
        self.plus(other)
    }

    fn times(self, other: Magnitude) -> Magnitude {
        Magnitude(self.0 * other.0)
    }
}

/// The determinant by the textbook formula, with the last point as pivot.
fn determinant<T: Ring>(kind: PredicateKind, points: &Points) -> T {
    let d = |row: usize, axis: usize, pivot: usize| T::difference(points[row][axis], points[pivot][axis]);
    match kind {
        PredicateKind::Derived(_) => unreachable!("formulas have programs"),
        PredicateKind::Compare => d(0, 0, 1),
        PredicateKind::Orient2d => d(0, 0, 2).times(d(1, 1, 2)).minus(d(0, 1, 2).times(d(1, 0, 2))),
        PredicateKind::Orient3d => {
            let [a, b, c] = [0, 1, 2].map(|row| [d(row, 0, 3), d(row, 1, 3), d(row, 2, 3)]);
            expand([a[2], b[2], c[2]], minors([a, b, c]))
        }
        PredicateKind::Incircle => {
            let [a, b, c] = [0, 1, 2].map(|row| {
                let [x, y] = [d(row, 0, 3), d(row, 1, 3)];
                [x, y, x.times(x).plus(y.times(y))]
            });
            expand([a[2], b[2], c[2]], minors([a, b, c]))
        }
        PredicateKind::Insphere => {
            let rows = [0, 1, 2, 3].map(|row| [d(row, 0, 4), d(row, 1, 4), d(row, 2, 4)]);
            let lifts = rows.map(|[x, y, z]| x.times(x).plus(y.times(y)).plus(z.times(z)));
            let minor = |i: usize, j: usize| rows[i][0].times(rows[j][1]).minus(rows[j][0].times(rows[i][1]));
            let [ab, bc, cd, da, ac, bd] =
                [minor(0, 1), minor(1, 2), minor(2, 3), minor(3, 0), minor(0, 2), minor(1, 3)];
            let z = |row: usize| rows[row][2];
            let abc = z(0).times(bc).minus(z(1).times(ac)).plus(z(2).times(ab));
            let bcd = z(1).times(cd).minus(z(2).times(bd)).plus(z(3).times(bc));
            let cda = z(2).times(da).plus(z(3).times(ac)).plus(z(0).times(cd));
            let dab = z(3).times(ab).plus(z(0).times(bd)).plus(z(1).times(da));
            let first = lifts[3].times(abc).minus(lifts[2].times(dab));
            first.plus(lifts[1].times(cda).minus(lifts[0].times(bcd)))
        }
    }
}

/// The 2×2 minors of the first two columns, without each row in turn.
fn minors<T: Ring>([a, b, c]: [[T; 3]; 3]) -> [T; 3] {
    let minor = |p: [T; 3], q: [T; 3]| p[0].times(q[1]).minus(q[0].times(p[1]));
    [minor(b, c), minor(c, a), minor(a, b)]
}

fn expand<T: Ring>(column: [T; 3], minors: [T; 3]) -> T {
    column[0].times(minors[0]).plus(column[1].times(minors[1])).plus(column[2].times(minors[2]))
}

/// A determinant in plain floating point, and its rounding error.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Rounding {
    /// The determinant in doubles.
    pub computed: f64,
    /// The determinant in pairs of doubles, nearly exact.
    pub nearly: f64,
    /// The difference of the two.
    pub error: f64,
    /// The permanent.
    pub permanent: f64,
}

/// The value 1/u: errors are in units of u times the permanent.
const PER_ROUNDOFF: f64 = 2.0 / f64::EPSILON;

impl Rounding {
    /// The rounding of a predicate's determinant.
    pub(super) fn of(kind: PredicateKind, points: &Points) -> Rounding {
        let computed: f64 = determinant(kind, points);
        let pair: Pair = determinant(kind, points);
        let Magnitude(permanent) = determinant(kind, points);
        let error = Pair(computed, 0.0).minus(pair).0.abs();
        Rounding { computed, nearly: pair.0, error, permanent }
    }

    /// The rounding of a formula's estimate; its value is exact, and rounded once.
    pub(super) fn of_formula(derived: Derived, scene: &Scene, args: &[Vertex]) -> Rounding {
        let program = derived.formula().program();
        let computed = derived.with_points(scene, args, |points| program.estimate(|point, axis| points[point][axis]));
        let verdict = predicament_judge::verdict(scene, Question::Derived(derived), args);
        let exact = verdict.determinant.to_f64();
        let distance = |x| (predicament_judge::rational(x) - &verdict.determinant).abs().to_f64();
        let error = if computed.is_finite() { distance(computed) } else { f64::NAN };
        Rounding { computed, nearly: exact, error, permanent: verdict.permanent.to_f64() }
    }

    /// The margin by which rounding carries the determinant to the other side, in units of u times the permanent: the
    /// error, less the price of a nonzero determinant. If that is not a number, the result is an arbitrary negative
    /// number.
    pub(super) fn carried(&self, price: f64) -> f64 {
        if !self.is_in_range() {
            return -1e9;
        }
        (self.error - price * self.nearly.abs()) / self.permanent * PER_ROUNDOFF
    }

    /// The distance of the computed determinant on the wrong side, in the same units; `None` if the sign is right.
    pub(super) fn wrong(&self) -> Option<f64> {
        let is_wrong = (self.computed > 0.0 && self.nearly <= 0.0) || (self.computed < 0.0 && self.nearly >= 0.0);
        (is_wrong && self.is_in_range()).then(|| self.computed.abs() / self.permanent * PER_ROUNDOFF)
    }

    /// True if underflow and overflow cannot matter; otherwise pairs of doubles and units of u mean nothing.
    fn is_in_range(&self) -> bool {
        (1e-180..1e270).contains(&self.permanent) && self.error.is_finite()
    }

    /// True if the determinant is zero, as far as pairs of doubles show.
    pub(super) fn vanishes(&self) -> bool {
        self.nearly == 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_judge::verdict;
    use predicament_predicates::Dimension;

    #[test]
    fn pairs_agree_with_rationals() {
        let mut random = predicament_corpus::Random::new("hunt", "pairs", 1);
        for kind in PredicateKind::ALL {
            let question = kind.first_question();
            for _ in 0..50 {
                let dimension = kind.dimension().unwrap_or(Dimension::Two);
                let mut points = [[0.0; 3]; 5];
                points.iter_mut().flatten().for_each(|x| *x = random.mantissa());
                let coordinates = points.iter().take(kind.arity()).flat_map(|p| p[..dimension.count()].to_vec());
                let scene = Scene::new(dimension, coordinates.collect()).unwrap();
                let args: Vec<Vertex> = scene.vertices().collect();
                let truth = verdict(&scene, question, &args);
                let rounding = Rounding::of(kind, &points);
                let exact = truth.determinant.to_f64();
                assert!((rounding.nearly - exact).abs() <= 1e-12 * exact.abs(), "{kind:?}: {rounding:?}, {exact}");
                let permanent = truth.permanent.to_f64();
                // For a comparison, the permanent is that of the difference.
                let is_same = (rounding.permanent - permanent).abs() <= 1e-13 * permanent;
                assert!(is_same || kind == PredicateKind::Compare, "{kind:?}: {rounding:?}, {permanent}");
                assert!(rounding.carried(0.0) <= 15.0, "{kind:?}: {rounding:?}");
            }
        }
    }
}
