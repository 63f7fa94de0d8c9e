//! The argument about near ties: a filter's error matters only where it can change a sign.

use crate::chain::Chain;
use crate::gappa::Number;
use crate::rules::Claim;

impl Chain<'_> {
    /// The error of (s + t) + y where the sign could be wrong, over P.
    ///
    /// Let x = fl(s + t). The error of x is u|s + t|, and where |x + y| is at most the error itself, |s + t| is hardly more
    /// than P/2.
    pub(crate) fn near_tie(&self, [s, t, y]: [&Claim; 3], lemma: bool, name: &str) -> Result<Number, String> {
        let rules = self.rules();
        let u = rules.u();
        let terms = rules.sum_before_rounding(&rules.sum_before_rounding(s, t, name)?, y, name)?;
        let (e, b) = (&terms.error, &terms.computed);
        // A difference is its rounded self times 1 + η with |η| ≤ h. Its four occurrences in a term move D by
        // `linear` + `beyond`.
        let differences = "h = 1b-53 / (1 - 1b-53);\nall = (1 + h) * (1 + h) * (1 + h) * (1 + h) - 1;\n";
        let moved = if lemma { "all" } else { "0" };
        let crude = rules.gappa.bound(&format!(
            "# {name}: the error without the argument about near ties\n{differences}{{ {e} + {u} * {b} + {moved} in ? }}\n"
        ))?;
        // S = |s + t|, T = |y|, X = |x|. Of the triangle inequality: X − T ≤ |x + y|, at most the crude error.
        let half = rules.gappa.bound(&format!(
            "# {name}: the first of two sums near a tie\n{{ S in [0, {b}] /\\ S + T in [0, {b}] /\\ S * (1 + d) - T in [-2, \
             {crude}] /\\ |d| <= {u} -> S in ? }}\nS -> ((S + T) + (S * (1 + d) - T) - S * d) / 2;\n"
        ))?;
        let lemma = if lemma { format!(" + h * (3 + 14 * ({crude} + all)) + (all - 4 * h)") } else { String::new() };
        rules
            .gappa
            .bound(&format!("# {name}: the error near a tie\n{differences}{{ {e} + {u} * {half}{lemma} in ? }}\n"))
    }
}
