//! The bit budget of a program: the integers that hold every intermediate.

use crate::program::{Op, Program};

/// The bits of a program's intermediates, if coordinates are integers.
#[derive(Clone, PartialEq, Debug)]
pub struct Bits {
    /// For each intermediate its degree, and the logarithm of its largest magnitude if |coordinates| ≤ 1, rounded up.
    forms: Vec<[u32; 2]>,
    is_homogeneous: bool,
}

impl Bits {
    /// Derives the bits of a program; `is_homogeneous` says whether its polynomial is.
    #[must_use]
    pub fn of_program(program: &Program, is_homogeneous: bool) -> Bits {
        // The degree, and the magnitude at coordinates of magnitude 1, rounded up.
        let mut sizes: Vec<(u32, f64)> = Vec::new();
        // Whole numbers below 2^53 are not rounded.
        let up = |x: f64| if x < 9_007_199_254_740_992.0 { x } else { x.next_up() };
        for &op in program.ops() {
            let size = match op {
                Op::Coordinate { .. } => (1, 1.0),
                Op::Constant(number) => (0, number.abs()),
                Op::Neg(a) => sizes[a],
                Op::Add(a, b) | Op::Sub(a, b) => (sizes[a].0.max(sizes[b].0), up(sizes[a].1 + sizes[b].1)),
                Op::Mul(a, b) => (sizes[a].0 + sizes[b].0, up(sizes[a].1 * sizes[b].1)),
            };
            sizes.push(size);
        }
        let forms = sizes.into_iter().map(|(degree, magnitude)| [degree, logarithm(magnitude)]).collect();
        Bits { forms, is_homogeneous }
    }

    /// Returns true if the polynomial is homogeneous: coordinates can be scaled to integers by any power of two.
    #[must_use]
    pub fn is_homogeneous(&self) -> bool {
        self.is_homogeneous
    }

    /// The bits, with the sign, of the largest intermediate, if coordinates are integers below 2^`coordinate`.
    #[must_use]
    pub fn of(&self, coordinate: u32) -> u32 {
        self.forms.iter().map(|[degree, more]| degree * coordinate + more + 1).max().unwrap_or(1)
    }

    /// The longest coordinates, in bits without the sign, for integers of `width` bits; `None` if not even one fits.
    #[must_use]
    pub fn longest(&self, width: u32) -> Option<u32> {
        (1..=width).take_while(|&coordinate| self.of(coordinate) <= width).last()
    }
}

/// The logarithm of a number of at least 0 to base 2, rounded up; 0 for numbers up to 1.
fn logarithm(number: f64) -> u32 {
    let mut power = 1.0;
    (0..1024)
        .find(|_| {
            let holds = number <= power;
            power *= 2.0;
            holds
        })
        .unwrap_or(1024)
}
