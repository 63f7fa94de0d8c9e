//! incircle(a, b, c, d): the sign of a formula.
//!
//! The sign of
//!     det([a - d, sq(a - d)], [b - d, sq(b - d)], [c - d, sq(c - d)])
//!
//! Degree 4. The filter holds for all finite doubles: a term goes through 10 roundings, a term of the magnitude
//! through 11, and sigma = 2^-960 covers underflow. The exact numbers behind it never round. Written by
//! `predicament derive`; docs/FORMULAS.md of that project has the proof.

use std::cmp::Ordering;

/// The sign, for any finite coordinates.
pub fn incircle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Ordering {
    let [ax, ay] = a;
    let [bx, by] = b;
    let [cx, cy] = c;
    let [dx, dy] = d;
    let v4 = ax - dx;
    let v5 = ay - dy;
    let v6 = v4 * v4;
    let v7 = v5 * v5;
    let v8 = v6 + v7;
    let v11 = bx - dx;
    let v12 = by - dy;
    let v13 = v11 * v11;
    let v14 = v12 * v12;
    let v15 = v13 + v14;
    let v18 = cx - dx;
    let v19 = cy - dy;
    let v20 = v18 * v18;
    let v21 = v19 * v19;
    let v22 = v20 + v21;
    let v23 = v11 * v19;
    let v24 = v12 * v18;
    let v25 = v23 - v24;
    let v26 = v8 * v25;
    let v27 = v4 * v19;
    let v28 = v5 * v18;
    let v29 = v27 - v28;
    let v30 = v15 * v29;
    let v31 = v4 * v12;
    let v32 = v5 * v11;
    let v33 = v31 - v32;
    let v34 = v22 * v33;
    let v35 = v26 - v30;
    let v36 = v34 + v35;
    let m25 = v23.abs() + v24.abs();
    let m26 = v8 * m25;
    let m29 = v27.abs() + v28.abs();
    let m30 = v15 * m29;
    let m33 = v31.abs() + v32.abs();
    let m34 = v22 * m33;
    let m35 = m26 + m30;
    let m36 = m34 + m35;
    let sum = (v8 + v15) + v22;
    const SIGMA: f64 = 1.0261342003245941e-289; // 2^-960
    let bound = 1.1102230246251595e-15 * m36 + SIGMA * (1.0 + sum);
    if v36.abs() > bound {
        return if v36.is_sign_negative() { Ordering::Less } else { Ordering::Greater };
    }
    incircle_exact(a, b, c, d)
}

/// The sign by exact numbers alone.
#[cold]
#[inline(never)]
fn incircle_exact(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Ordering {
    let [ax, ay] = a;
    let [bx, by] = b;
    let [cx, cy] = c;
    let [dx, dy] = d;
    let e0 = Exact::new(ax);
    let e1 = Exact::new(ay);
    let e2 = Exact::new(dx);
    let e3 = Exact::new(dy);
    let e4 = e0.plus(&e2, true);
    let e5 = e1.plus(&e3, true);
    let e6 = e4.times(&e4);
    let e7 = e5.times(&e5);
    let e8 = e6.plus(&e7, false);
    let e9 = Exact::new(bx);
    let e10 = Exact::new(by);
    let e11 = e9.plus(&e2, true);
    let e12 = e10.plus(&e3, true);
    let e13 = e11.times(&e11);
    let e14 = e12.times(&e12);
    let e15 = e13.plus(&e14, false);
    let e16 = Exact::new(cx);
    let e17 = Exact::new(cy);
    let e18 = e16.plus(&e2, true);
    let e19 = e17.plus(&e3, true);
    let e20 = e18.times(&e18);
    let e21 = e19.times(&e19);
    let e22 = e20.plus(&e21, false);
    let e23 = e11.times(&e19);
    let e24 = e12.times(&e18);
    let e25 = e23.plus(&e24, true);
    let e26 = e8.times(&e25);
    let e27 = e4.times(&e19);
    let e28 = e5.times(&e18);
    let e29 = e27.plus(&e28, true);
    let e30 = e15.times(&e29);
    let e31 = e4.times(&e12);
    let e32 = e5.times(&e11);
    let e33 = e31.plus(&e32, true);
    let e34 = e22.times(&e33);
    let e35 = e26.plus(&e30, true);
    e34.plus(&e35, false).sign()
}

/// An exact number: ± the digits, least first, in base 2^32, times 2^(32·`low`).
#[derive(Clone)]
struct Exact {
    is_negative: bool,
    digits: Vec<u32>,
    low: i32,
}

impl Exact {
    fn new(x: f64) -> Exact {
        let bits = x.to_bits();
        let (field, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
        let significand = if field == 0 {
            fraction
        } else {
            fraction | 1 << 52
        };
        let exponent = field.max(1) - 1075;
        let wide = u128::from(significand) << exponent.rem_euclid(32);
        let digits = (0..3).map(|at| (wide >> (32 * at)) as u32).collect();
        Exact {
            is_negative: x < 0.0,
            digits,
            low: exponent.div_euclid(32),
        }
        .trimmed()
    }

    fn trimmed(mut self) -> Exact {
        while self.digits.last() == Some(&0) {
            self.digits.pop();
        }
        let zeros = self.digits.iter().take_while(|&&digit| digit == 0).count();
        self.digits.drain(..zeros);
        self.low += zeros as i32;
        self
    }

    fn negated(&self) -> Exact {
        Exact {
            is_negative: !self.is_negative,
            ..self.clone()
        }
    }

    fn sign(&self) -> Ordering {
        match (self.digits.is_empty(), self.is_negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }

    /// The sum, or the difference if `minus` is true.
    fn plus(&self, other: &Exact, minus: bool) -> Exact {
        if self.digits.is_empty() || other.digits.is_empty() {
            let zero = other.digits.is_empty();
            return if zero {
                self.clone()
            } else if minus {
                other.negated()
            } else {
                other.clone()
            };
        }
        let low = self.low.min(other.low);
        let top = (self.low + self.digits.len() as i32).max(other.low + other.digits.len() as i32);
        // Each digit's sum is at most 2^33 in magnitude: carries fit into 64 bits.
        let mut sums = vec![0_i64; (top - low) as usize + 1];
        for (number, is_negative) in [
            (self, self.is_negative),
            (other, other.is_negative != minus),
        ] {
            for (at, &digit) in number.digits.iter().enumerate() {
                let digit = i64::from(digit);
                sums[(number.low - low) as usize + at] += if is_negative { -digit } else { digit };
            }
        }
        let is_negative = sums
            .iter()
            .rev()
            .find(|&&sum| sum != 0)
            .is_some_and(|&sum| sum < 0);
        let mut carry = 0;
        let digits = sums.into_iter().map(|sum| {
            let sum = carry + if is_negative { -sum } else { sum };
            carry = sum >> 32;
            sum as u32
        });
        Exact {
            is_negative,
            digits: digits.collect(),
            low,
        }
        .trimmed()
    }

    fn times(&self, other: &Exact) -> Exact {
        let mut digits = vec![0_u32; self.digits.len() + other.digits.len()];
        for (at, &a) in self.digits.iter().enumerate() {
            let mut carry = 0;
            for (next, &b) in other.digits.iter().chain([&0]).enumerate() {
                let sum = u64::from(a) * u64::from(b) + u64::from(digits[at + next]) + carry;
                digits[at + next] = sum as u32;
                carry = sum >> 32;
            }
        }
        let is_negative = self.is_negative != other.is_negative;
        Exact {
            is_negative,
            digits,
            low: self.low + other.low,
        }
        .trimmed()
    }
}
