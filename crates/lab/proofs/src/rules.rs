//! The steps of a proof as scripts of Gappa: the error of one operation, from the errors of its operands.
//!
//! # The claim
//! Let z be a computed number, Z its exact value and P its *permanent*: the exact value with every term by magnitude.
//! A [`Claim`] says
//!
//! |Z| ≤ a·P, |z| ≤ b·P, |z − Z| ≤ e·P.
//!
//! Scripts are about numbers over P, so they hold for all magnitudes. Where P is zero, so are z and Z.
//!
//! # The model of rounding
//! For doubles x and y, fl(x ± y) = (x ± y)(1 + δ) with |δ| ≤ u, also where it is subnormal. For any real t, fl(t) =
//! (t + η)(1 + δ) with |η| ≤ 2⁻¹⁰⁷⁵, where one of η and δ is zero. [`MODEL`] proves both of Gappa's binary64. The η of a
//! product is a further term of the sum that the product belongs to: it goes through the last rounding of the product
//! only, and e ≥ u. So a claim holds with P enlarged by |η|. All this assumes that nothing overflows.

use crate::gappa::{Gappa, Number};

/// The claim about one number of a formula.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Claim {
    /// The bound of the exact value over P.
    pub exact: Number,
    /// The bound of the computed value over P.
    pub computed: Number,
    /// The bound of the error over P.
    pub error: Number,
}

impl Claim {
    /// The claim about a number that is given: it has no error.
    #[must_use]
    pub fn given() -> Claim {
        Claim { exact: "1".into(), computed: "1".into(), error: "0".into() }
    }

    /// The claim about the computed difference of two given numbers, over the magnitude of the exact one.
    #[must_use]
    pub fn difference(precision: u32) -> Claim {
        let one = format!("{}b-{precision}", (1_u64 << precision) + 1);
        Claim { exact: "1".into(), computed: one, error: format!("1b-{precision}") }
    }

    /// The claim about the computed difference d of two numbers with slacks s and t, over |d| + s + t.
    ///
    /// Each is within u times its slack of the number that it stands for.
    #[must_use]
    pub fn slack(precision: u32) -> Claim {
        let of_difference = Claim::difference(precision);
        Claim { exact: of_difference.computed, computed: "1".into(), error: of_difference.error }
    }
}

/// The model of rounding, of binary64, as scripts of Gappa.
pub const MODEL: [(&str, &str); 4] = [
    (
        "a sum of two doubles",
        "@fl = float<ieee_64, ne>;\nx = fl(x_);\ny = fl(y_);\n{ fl(x + y) -/ (x + y) in [-1b-53, 1b-53] }\n",
    ),
    (
        "a difference of two doubles",
        "@fl = float<ieee_64, ne>;\nx = fl(x_);\ny = fl(y_);\n{ fl(x - y) -/ (x - y) in [-1b-53, 1b-53] }\n",
    ),
    ("a tiny product", "@fl = float<ieee_64, ne>;\n{ |t| <= 1b-1021 -> |fl(t) - t| <= 1b-1075 }\n"),
    (
        "a product that is not tiny",
        "@fl = float<ieee_64, ne>;\n{ |t| in [1b-1021, 1b1024] -> fl(t) -/ t in [-1b-53, 1b-53] }\n",
    ),
];

/// The rules, for a format of so many bits.
pub struct Rules<'a> {
    /// The prover.
    pub gappa: &'a Gappa,
    /// The bits of a significand: u is 2 to the minus this.
    pub precision: u32,
}

impl Rules<'_> {
    /// u as Gappa reads it.
    #[must_use]
    pub fn u(&self) -> Number {
        format!("1b-{}", self.precision)
    }

    /// The claim about a product, over the product of the permanents.
    ///
    /// # Errors
    /// The script that Gappa does not prove.
    pub fn product(&self, x: &Claim, y: &Claim, what: &str) -> Result<Claim, String> {
        let u = self.u();
        let script = format!(
            "# {what}\n{{ |X| <= {} /\\ |x| <= {} /\\ |x - X| <= {}\n  /\\ |Y| <= {} /\\ |y| <= {} /\\ |y - Y| <= {} /\\ \
             |d| <= {u}\n  -> |X * Y| in ? /\\ |x * y * (1 + d)| in ? /\\ |x * y * (1 + d) - X * Y| in ? }}\nx * y * (1 + \
             d) - X * Y -> (x - X) * y + X * (y - Y) + x * y * d;\n",
            x.exact, x.computed, x.error, y.exact, y.computed, y.error
        );
        self.claim(&script, ["|X * Y|", "|x * y * (1 + d)|", "|x * y * (1 + d) - X * Y|"])
    }

    /// The claim about a sum or difference before it is rounded, over the sum of the permanents.
    ///
    /// p and q are the permanents over their sum. A relative error of the sum of two nonnegative numbers is between
    /// theirs, which is a theorem of Gappa; so each bound is written as a relative error of a permanent.
    ///
    /// # Errors
    /// The script that Gappa does not prove.
    pub fn sum_before_rounding(&self, x: &Claim, y: &Claim, what: &str) -> Result<Claim, String> {
        let script = format!(
            "# {what}, before it is rounded\n{{ p / (p + q) in [0, 1] /\\ p + q in [1, 1]\n  /\\ (p + X) -/ p in [0, {}] \
             /\\ (q + Y) -/ q in [0, {}]\n  /\\ (p + x) -/ p in [0, {}] /\\ (q + y) -/ q in [0, {}]\n  /\\ (p + v) -/ p in \
             [-{e}, {e}] /\\ (q + w) -/ q in [-{f}, {f}]\n  -> ((p + X) + (q + Y)) -/ (p + q) in ?\n  /\\ ((p + x) + (q + \
             y)) -/ (p + q) in ?\n  /\\ ((p + v) + (q + w)) -/ (p + q) in ? }}\n",
            x.exact,
            y.exact,
            x.computed,
            y.computed,
            e = x.error,
            f = y.error
        );
        self.claim(&script, ["X", "x", "v"].map(sum_of).each_ref().map(String::as_str))
    }

    /// The claim about a sum or difference.
    ///
    /// # Errors
    /// The script that Gappa does not prove.
    pub fn sum(&self, x: &Claim, y: &Claim, what: &str) -> Result<Claim, String> {
        let before = self.sum_before_rounding(x, y, what)?;
        self.rounded(&before, what)
    }

    /// The claim about a number after one rounding.
    ///
    /// # Errors
    /// The script that Gappa does not prove.
    pub fn rounded(&self, before: &Claim, what: &str) -> Result<Claim, String> {
        let script = format!(
            "# {what}, rounded\n{{ |S| <= {} /\\ |s| <= {} /\\ |s - S| <= {} /\\ |d| <= {}\n  -> |S| in ? /\\ |s * (1 + d)| \
             in ? /\\ |s * (1 + d) - S| in ? }}\ns * (1 + d) - S -> (s - S) + s * d;\n",
            before.exact,
            before.computed,
            before.error,
            self.u()
        );
        self.claim(&script, ["|S|", "|s * (1 + d)|", "|s * (1 + d) - S|"])
    }

    /// The claim about the root of a number whose permanent is itself, over the root of the permanent.
    ///
    /// # Errors
    /// The script that Gappa does not prove.
    pub fn root(&self, x: &Claim, what: &str) -> Result<Claim, String> {
        let (e, u) = (&x.error, self.u());
        let script = format!(
            "# {what}\n{{ t in [-{e}, {e}] /\\ |d| <= {u} -> |sqrt(1 + t) * (1 + d)| in ? /\\ |sqrt(1 + t) * (1 + d) - 1| in \
             ? }}\nsqrt(1 + t) * (1 + d) - 1 -> (sqrt(1 + t) - 1) + sqrt(1 + t) * d;\nsqrt(1 + t) - 1 -> t / (sqrt(1 + t) + \
             1) {{ sqrt(1 + t) + 1 <> 0 }};\n"
        );
        let found = self.gappa.ask(&script, &["|sqrt(1 + t) * (1 + d)|", "|sqrt(1 + t) * (1 + d) - 1|"])?;
        Ok(Claim { exact: "1".into(), computed: found[0].clone(), error: found[1].clone() })
    }

    /// The claim about 1/x for a number whose permanent is itself, over its inverse.
    ///
    /// # Errors
    /// The script that Gappa does not prove.
    pub fn inverse(&self, x: &Claim, what: &str) -> Result<Claim, String> {
        let (e, u) = (&x.error, self.u());
        let script = format!(
            "# {what}\n{{ t in [-{e}, {e}] /\\ |d| <= {u} -> |(1 + d) / (1 + t)| in ? /\\ |(1 + d) / (1 + t) - 1| in ? }}\n(1 \
             + d) / (1 + t) - 1 -> (d - t) / (1 + t) {{ 1 + t <> 0 }};\n"
        );
        let found = self.gappa.ask(&script, &["|(1 + d) / (1 + t)|", "|(1 + d) / (1 + t) - 1|"])?;
        Ok(Claim { exact: "1".into(), computed: found[0].clone(), error: found[1].clone() })
    }

    fn claim(&self, script: &str, of: [&str; 3]) -> Result<Claim, String> {
        let found = self.gappa.ask(script, &of)?;
        let [exact, computed, error] =
            found.try_into().map_err(|_| format!("three bounds are asked for in\n{script}"))?;
        Ok(Claim { exact, computed, error })
    }
}

/// The relative error of a sum of permanents, as Gappa prints it.
fn sum_of(x: &str) -> String {
    let y = match x {
        "X" => "Y",
        "x" => "y",
        _ => "w",
    };
    format!("p + {x} + (q + {y}) -/ p + q")
}
