//! The tests that an algorithm makes of a pair, by exact values.
//!
//! The guarantee of a whole pair assumes that no sub-pair is registered. Under that assumption most tests have only one
//! right answer: areas and volumes are well beyond their tolerances. There, a tolerance of twice the right size can
//! stay unnoticed. But each test also makes a promise, (1) of the paper: a value up to T₋ is found to be within T, a
//! value beyond T₊ is not. So an algorithm is also checked by its tests, for a pair with any sub-pairs:
//!
//! * if one test has to fail, the pair must not be registered;
//! * if all tests have to pass, the pair must be registered;
//! * otherwise a value is between T₋ and T₊, and either answer is right.
//!
//! The signs of the feet along an edge are compared without a tolerance. Their error bounds, E\[â\] and E\[ā\] of 4.3
//! and 5.3, replace it.

use std::cmp::Ordering;

use predicament_error_calculus::vector::{cross, dot, minus, norm_squared};
use predicament_predicates::Dimension;
use rug::{Integer, Rational};

use super::pair::{Pair, PairKind, area, volume};
use super::quantity::Quantity;
use predicament_laws::published::{Published, Symbol};

/// The required outcome of a test.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Outcome {
    Passes,
    Fails,
    Either,
}

/// A compared value that is near T₋, T or T₊.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Hit {
    /// The tolerance.
    pub symbol: Symbol,
    /// 0, 1 or 2: T₋, T or T₊.
    pub limit: usize,
    /// True if the value is beyond the limit.
    pub beyond: bool,
}

/// The outcomes of all tests of the algorithm for a pair.
#[derive(Clone, Debug, Default)]
pub struct Readings {
    outcomes: Vec<Outcome>,
    compared: Vec<(Symbol, Quantity)>,
}

impl Readings {
    /// True if the pair has to be registered, false if it must not be; `None` if either answer is right.
    #[must_use]
    pub fn expected(&self) -> Option<bool> {
        if self.outcomes.contains(&Outcome::Fails) {
            return Some(false);
        }
        self.outcomes.iter().all(|outcome| *outcome == Outcome::Passes).then_some(true)
    }

    /// The compared values that are within this fraction of a limit.
    pub fn hits(&self, published: &Published, near: f64) -> impl Iterator<Item = Hit> {
        self.compared.iter().flat_map(move |(symbol, square)| {
            let limits = published.limits(*symbol).iter().enumerate();
            limits.filter_map(move |(limit, bound)| {
                let off = (square.over(bound).sqrt() - 1.0).abs();
                let beyond = square.compare(bound) == Ordering::Greater;
                (off <= near).then_some(Hit { symbol: *symbol, limit, beyond })
            })
        })
    }

    /// Adds a test that passes up to the tolerance.
    fn within(&mut self, published: &Published, symbol: Symbol, square: Quantity) {
        let [lower, _, upper] = published.limits(symbol);
        self.outcomes.push(match (square.compare(lower), square.compare(upper)) {
            (Ordering::Less | Ordering::Equal, _) => Outcome::Passes,
            (_, Ordering::Greater) => Outcome::Fails,
            _ => Outcome::Either,
        });
        self.compared.push((symbol, square));
    }

    /// Adds a test that passes beyond the tolerance.
    fn beyond(&mut self, published: &Published, symbol: Symbol, square: Quantity) {
        let [lower, _, upper] = published.limits(symbol);
        self.outcomes.push(match (square.compare(lower), square.compare(upper)) {
            (Ordering::Less | Ordering::Equal, _) => Outcome::Fails,
            (_, Ordering::Greater) => Outcome::Passes,
            _ => Outcome::Either,
        });
        self.compared.push((symbol, square));
    }

    /// Adds a test that passes beyond the tolerance, for positive values.
    fn positive(&mut self, published: &Published, symbol: Symbol, value: &Integer, exponent: i32) {
        if value.is_positive() {
            self.beyond(published, symbol, Quantity::integer(Integer::from(value.square_ref()), 2 * exponent));
        } else {
            self.outcomes.push(Outcome::Fails);
        }
    }

    /// Adds tests that pass beyond the tolerance, for values whose signs fit.
    fn signed(
        &mut self,
        published: &Published,
        symbol: Symbol,
        values: &[Integer],
        exponent: i32,
        fits: fn(&Integer, &Integer) -> bool,
    ) {
        for value in values {
            self.beyond(published, symbol, Quantity::integer(Integer::from(value.square_ref()), 2 * exponent));
        }
        // A sign is computed right if the value is beyond T₋; otherwise the pair is not registered anyway.
        if !values.windows(2).all(|two| fits(&two[0], &two[1])) {
            self.outcomes.push(Outcome::Fails);
        }
    }

    /// Adds a test that a value is not negative; the computed value has an error of up to `error` εL.
    fn not_negative(&mut self, published: &Published, error: u32, positive: bool, square: &Quantity) {
        let bound = Rational::from(&published.unit_squared * (error * error));
        self.outcomes.push(match (square.compare(&bound), positive) {
            (Ordering::Greater, true) => Outcome::Passes,
            (Ordering::Greater, false) => Outcome::Fails,
            _ => Outcome::Either,
        });
    }
}

fn same(a: &Integer, b: &Integer) -> bool {
    a.is_positive() == b.is_positive()
}

fn opposite(a: &Integer, b: &Integer) -> bool {
    a.is_positive() != b.is_positive()
}

impl Readings {
    /// The tests of the algorithm for this pair, with the published tolerances.
    ///
    /// # Panics
    /// If the pair has another dimension.
    #[must_use]
    pub fn of(published: &Published, pair: &Pair) -> Readings {
        assert_eq!(pair.dimension(), published.dimension(), "tolerances of the pair's dimension");
        let ([a, b, c, d, e], exponent) = pair.points();
        let mut all = Readings::default();
        match (pair.kind(), pair.dimension()) {
            (PairKind::VertexVertex, _) => {
                let square = Quantity::integer(norm_squared(&minus(a, b)), 2 * exponent);
                all.within(published, Symbol::Sigma, square);
            }
            (PairKind::EdgeVertex, dimension) => {
                let errors = if dimension == Dimension::Two { [19, 26] } else { [31, 42] };
                all.edge_vertex(published, [a, b, c], exponent, errors);
            }
            (PairKind::EdgeEdge, Dimension::Two) => {
                let [of_ab, of_cd] = [[area(a, c, d), area(b, c, d)], [area(c, a, b), area(d, a, b)]];
                all.signed(published, Symbol::Kappa, &of_ab, 2 * exponent, opposite);
                all.signed(published, Symbol::Kappa, &of_cd, 2 * exponent, opposite);
            }
            (PairKind::TriangleVertex, Dimension::Two) => {
                let areas = [area(d, b, c), area(a, d, c), area(a, b, d)];
                all.signed(published, Symbol::Kappa, &areas, 2 * exponent, same);
            }
            (PairKind::EdgeEdge, Dimension::Three) => {
                let (u, v, w) = (minus(b, a), minus(d, c), minus(c, a));
                let r = cross(&u, &v);
                let m_squared = norm_squared(&r);
                let [on_ab, on_cd] = [dot(&cross(&w, &v), &r), dot(&cross(&w, &u), &r)];
                let rest = [&on_ab, &on_cd].map(|on| Integer::from(&m_squared - on));
                all.plane_test(published, [Symbol::Lambda, Symbol::Gamma], &r, &w, exponent);
                for part in [on_ab, on_cd].iter().chain(&rest) {
                    all.positive(published, Symbol::Phi, part, 4 * exponent);
                }
            }
            (PairKind::TriangleVertex, Dimension::Three) => {
                let (u, v, w) = (minus(b, a), minus(c, a), minus(d, a));
                let r = cross(&u, &v);
                let [of_b, of_c] = [dot(&cross(&w, &v), &r), dot(&cross(&u, &w), &r)];
                let of_a = norm_squared(&r) - &of_b - &of_c;
                all.plane_test(published, [Symbol::Nu, Symbol::Delta], &r, &w, exponent);
                for part in [of_a, of_b, of_c] {
                    all.positive(published, Symbol::Zeta, &part, 4 * exponent);
                }
            }
            (PairKind::TriangleEdge, _) => {
                let around = [volume(b, c, d, e), volume(c, a, d, e), volume(a, b, d, e)];
                let ends = [volume(a, b, c, d), volume(a, b, c, e)];
                all.signed(published, Symbol::Mu, &around, 3 * exponent, same);
                all.signed(published, Symbol::Xi, &ends, 3 * exponent, opposite);
            }
            (PairKind::TetrahedronVertex, _) => {
                let volumes = [volume(e, b, c, d), volume(a, e, c, d), volume(a, b, e, d), volume(a, b, c, e)];
                all.signed(published, Symbol::Rho, &volumes, 3 * exponent, same);
            }
        }
        all
    }

    /// Adds the tests m > σ̂, d ≤ τ, â ≥ 0 and ā ≥ 0.
    fn edge_vertex(&mut self, published: &Published, [a, b, p]: [&[Integer; 3]; 3], exponent: i32, errors: [u32; 2]) {
        let (u, w) = (minus(b, a), minus(p, a));
        let m_squared = norm_squared(&u);
        self.beyond(published, Symbol::SigmaHat, Quantity::integer(m_squared.clone(), 2 * exponent));
        if m_squared.is_zero() {
            return;
        }
        let forward = dot(&u, &w);
        let back = Integer::from(&m_squared - &forward);
        let over_m =
            |numerator: Integer| Quantity { numerator, denominator: m_squared.clone(), exponent: 2 * exponent };
        let distance = norm_squared(&w) * &m_squared - Integer::from(forward.square_ref());
        self.within(published, Symbol::Tau, over_m(distance));
        for (along, error) in [forward, back].iter().zip(errors) {
            let square = over_m(Integer::from(along.square_ref()));
            self.not_negative(published, error, along.is_positive(), &square);
        }
    }

    /// Adds the tests m² beyond λ or ν, and d̂² ≤ γ²m² or δ²m², with r · w = d̂ and m = ‖r‖.
    fn plane_test(
        &mut self,
        published: &Published,
        [least, distance]: [Symbol; 2],
        r: &[Integer; 3],
        w: &[Integer; 3],
        exponent: i32,
    ) {
        let m_squared = norm_squared(r);
        self.beyond(published, least, Quantity::integer(Integer::from(m_squared.square_ref()), 8 * exponent));
        if !m_squared.is_zero() {
            let height = Quantity { numerator: dot(r, w).square(), denominator: m_squared, exponent: 2 * exponent };
            self.within(published, distance, height);
        }
    }
}

#[cfg(test)]
mod tests;
