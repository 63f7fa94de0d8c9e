//! orient3d(a, b, c, d): the sign of a formula.
//!
//! The sign of
//!     det(a - d, b - d, c - d)
//!
//! Degree 3. The filter holds for all finite doubles: a term goes through 7 roundings, a term of the magnitude
//! through 8, and sigma = 2^-960 covers underflow. The exact numbers behind it never round. Written by
//! `predicament derive`; docs/FORMULAS.md of that project has the proof.

use std::cmp::Ordering;

/// The sign, for any finite coordinates.
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Ordering {
    let [ax, ay, az] = a;
    let [bx, by, bz] = b;
    let [cx, cy, cz] = c;
    let [dx, dy, dz] = d;
    let v6 = ax - dx;
    let v7 = ay - dy;
    let v8 = az - dz;
    let v12 = bx - dx;
    let v13 = by - dy;
    let v14 = bz - dz;
    let v18 = cx - dx;
    let v19 = cy - dy;
    let v20 = cz - dz;
    let v21 = v12 * v19;
    let v22 = v13 * v18;
    let v23 = v21 - v22;
    let v24 = v8 * v23;
    let v25 = v6 * v19;
    let v26 = v7 * v18;
    let v27 = v25 - v26;
    let v28 = v14 * v27;
    let v29 = v6 * v13;
    let v30 = v7 * v12;
    let v31 = v29 - v30;
    let v32 = v20 * v31;
    let v33 = v24 - v28;
    let v34 = v32 + v33;
    let m23 = v21.abs() + v22.abs();
    let m24 = v8.abs() * m23;
    let m27 = v25.abs() + v26.abs();
    let m28 = v14.abs() * m27;
    let m31 = v29.abs() + v30.abs();
    let m32 = v20.abs() * m31;
    let m33 = m24 + m28;
    let m34 = m32 + m33;
    let sum = (((v6.abs() + v7.abs()) + v8.abs()) + (v12.abs() + v13.abs())) + ((v14.abs() + v18.abs()) + (v19.abs() + v20.abs()));
    const SIGMA: f64 = 1.0261342003245941e-289; // 2^-960
    let bound = 7.771561172376112e-16 * m34 + SIGMA * (1.0 + sum);
    if v34.abs() > bound {
        return if v34.is_sign_negative() { Ordering::Less } else { Ordering::Greater };
    }
    orient3d_exact(a, b, c, d)
}

/// The sign by exact numbers alone.
#[cold]
#[inline(never)]
fn orient3d_exact(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Ordering {
    let [ax, ay, az] = a;
    let [bx, by, bz] = b;
    let [cx, cy, cz] = c;
    let [dx, dy, dz] = d;
    let e0 = Exact::new(ax);
    let e1 = Exact::new(ay);
    let e2 = Exact::new(az);
    let e3 = Exact::new(dx);
    let e4 = Exact::new(dy);
    let e5 = Exact::new(dz);
    let e6 = e0.plus(&e3, true);
    let e7 = e1.plus(&e4, true);
    let e8 = e2.plus(&e5, true);
    let e9 = Exact::new(bx);
    let e10 = Exact::new(by);
    let e11 = Exact::new(bz);
    let e12 = e9.plus(&e3, true);
    let e13 = e10.plus(&e4, true);
    let e14 = e11.plus(&e5, true);
    let e15 = Exact::new(cx);
    let e16 = Exact::new(cy);
    let e17 = Exact::new(cz);
    let e18 = e15.plus(&e3, true);
    let e19 = e16.plus(&e4, true);
    let e20 = e17.plus(&e5, true);
    let e21 = e12.times(&e19);
    let e22 = e13.times(&e18);
    let e23 = e21.plus(&e22, true);
    let e24 = e8.times(&e23);
    let e25 = e6.times(&e19);
    let e26 = e7.times(&e18);
    let e27 = e25.plus(&e26, true);
    let e28 = e14.times(&e27);
    let e29 = e6.times(&e13);
    let e30 = e7.times(&e12);
    let e31 = e29.plus(&e30, true);
    let e32 = e20.times(&e31);
    let e33 = e24.plus(&e28, true);
    e32.plus(&e33, false).sign()
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
