//! Tests of determinants at the limit of each capacity.

use std::panic::catch_unwind;

use rug::{Integer, Rational, integer::Order};

use super::*;

/// The capacities, each tested at its limit.
const CAPACITIES: [usize; 5] = [9, 18, 36, 128, 1024];

/// A generator of numbers with many zeros and ones in them.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        // xorshift64 (Marsaglia 2003).
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.bits() % n as u64).expect("less than n")
    }

    fn limb(&mut self) -> u64 {
        match self.below(8) {
            0..4 => u64::MAX,
            4 => 1 << 63,
            5 => 1,
            _ => self.bits() | 1 << 63,
        }
    }
}

/// A number that owns its limbs.
struct Long {
    limbs: Vec<u64>,
    low: i32,
    negative: bool,
}

impl Long {
    /// A number of this many limbs from `low` on, with nonzero first and last limbs.
    fn random(random: &mut Random, limbs: usize, low: i32) -> Long {
        Long { limbs: (0..limbs).map(|_| random.limb()).collect(), low, negative: random.below(2) == 0 }
    }

    fn number(&self) -> Number<'_> {
        Number { limbs: &self.limbs, low: self.low, negative: self.negative }
    }

    fn value(&self) -> Rational {
        let magnitude = Rational::from(Integer::from_digits(&self.limbs, Order::Lsf)) << (64 * self.low);
        if self.negative { -magnitude } else { magnitude }
    }
}

/// N rows that span `limbs` limbs together, each entry as long as its row or shorter; weights are positive.
fn rows<const N: usize>(random: &mut Random, limbs: usize) -> [[Long; N]; N] {
    let mut spans = [1; N];
    (N..limbs).for_each(|_| spans[random.below(N)] += 1);
    spans.map(|span| {
        let low = -i32::try_from(random.below(span + 1)).expect("a few limbs");
        let full = random.below(N);
        std::array::from_fn(|j| {
            let length = if j == full { span } else { 1 + random.below(span) };
            let above = i32::try_from(random.below(span - length + 1)).expect("a few limbs");
            let long = Long::random(random, length, low + above);
            if j == N - 1 { Long { negative: false, ..long } } else { long }
        })
    })
}

/// The determinant by Laplace's expansion in rationals.
fn determinant(rows: &[Vec<Rational>]) -> Rational {
    let Some(((first, rest), columns)) = rows.split_first().map(|split| (split, 0..rows.len())) else {
        return Rational::from(1);
    };
    let term = |column: usize| {
        let without = |row: &Vec<Rational>| {
            row.iter().enumerate().filter(|&(j, _)| j != column).map(|(_, x)| x.clone()).collect::<Vec<_>>()
        };
        let minor = determinant(&rest.iter().map(without).collect::<Vec<_>>());
        let term = Rational::from(&first[column] * &minor);
        if column.is_multiple_of(2) { term } else { -term }
    };
    columns.map(term).sum()
}

fn truth<const N: usize>(rows: &[[Long; N]; N]) -> Sign {
    let values: Vec<Vec<Rational>> = rows.iter().map(|row| row.iter().map(Long::value).collect()).collect();
    Sign::from(determinant(&values).cmp0())
}

/// The sign of a determinant of N rows with this many limbs, by the capacity that is chosen for it.
type Chosen<const N: usize> = fn(&[[Number; N]; N]) -> Sign;

/// Tests rows that need as many limbs as a capacity has, and one more.
///
/// The chosen capacity answers both correctly, and for the first it is `CAP` itself. If rows need far more limbs, `CAP`
/// panics, which proves that another capacity was chosen. Beyond the largest, rows are whole integers.
fn edge<const N: usize, const CAP: usize>(chosen: Chosen<N>, by_capacity: Chosen<N>, least: usize) {
    let mut random = Random(CAP as u64 + 1);
    let rounds = if CAP > 128 { 3 } else { 60 };
    for need in [CAP, CAP + 1].into_iter().filter(|&need| need >= least) {
        for _ in 0..rounds {
            let rows = rows::<N>(&mut random, need - 1);
            let numbers = rows.each_ref().map(|row| row.each_ref().map(Long::number));
            assert_eq!(limbs(&numbers), need);
            let truth = truth(&rows);
            assert_eq!(chosen(&numbers), truth, "{need} limbs");
            if need == CAP {
                assert_eq!(by_capacity(&numbers), truth, "{need} limbs in {CAP}");
            }
        }
    }
    // Every entry as long as the determinant could be.
    let full = full_rows::<N>(&mut random, CAP);
    let numbers = full.each_ref().map(|row| row.each_ref().map(Long::number));
    assert!(catch_unwind(|| by_capacity(&numbers)).is_err(), "{} limbs in {CAP}", limbs(&numbers));
    assert_eq!(chosen(&numbers), truth(&full), "{} limbs", limbs(&numbers));
}

/// Rows of entries with this many limbs.
fn full_rows<const N: usize>(random: &mut Random, limbs: usize) -> [[Long; N]; N] {
    std::array::from_fn(|_| {
        std::array::from_fn(|j| {
            let long = Long::random(random, limbs, 0);
            if j == N - 1 { Long { negative: false, ..long } } else { long }
        })
    })
}

#[test]
fn the_least_capacity_is_chosen() {
    for limbs in 0..=1024 {
        let least = CAPACITIES.into_iter().find(|&capacity| capacity >= limbs).expect("1024 is the last");
        assert_eq!(with_capacity!(limbs, CAP => CAP), least);
    }
}

#[test]
fn comparisons_at_each_edge() {
    edge::<2, 9>(compare, order::<9>, 3);
    edge::<2, 18>(compare, order::<18>, 3);
    edge::<2, 36>(compare, order::<36>, 3);
    edge::<2, 128>(compare, order::<128>, 3);
    edge::<2, 1024>(compare, order::<1024>, 3);
}

#[test]
fn turns_at_each_edge() {
    edge::<3, 9>(orient2d, turn::<9>, 4);
    edge::<3, 18>(orient2d, turn::<18>, 4);
    edge::<3, 36>(orient2d, turn::<36>, 4);
    edge::<3, 128>(orient2d, turn::<128>, 4);
    edge::<3, 1024>(orient2d, turn::<1024>, 4);
}

#[test]
fn sides_at_each_edge() {
    edge::<4, 9>(orient3d, side::<9>, 5);
    edge::<4, 18>(orient3d, side::<18>, 5);
    edge::<4, 36>(orient3d, side::<36>, 5);
    edge::<4, 128>(orient3d, side::<128>, 5);
    edge::<4, 1024>(orient3d, side::<1024>, 5);
}

/// One of four vertices is an input vertex, with weight one: rows of differences.
#[test]
fn sides_of_an_input_vertex_at_each_edge() {
    fn edge<const CAP: usize>(by_capacity: fn([&[Number; 4]; 3], &[Number; 4]) -> Sign) {
        let mut random = Random(CAP as u64);
        let rounds = if CAP > 128 { 3 } else { 60 };
        for need in [CAP, CAP + 1] {
            for round in 0..rounds {
                let input = 1 + random.below(if CAP == 9 { 1 } else { 3 });
                let rest = rows::<3>(&mut random, need - 1 - 3 * input);
                let mut all: Vec<[Long; 4]> = rest
                    .into_iter()
                    .map(|[x, y, w]| {
                        let z = Long { limbs: w.limbs.clone(), low: w.low, negative: round % 2 == 0 };
                        [x, y, z, w]
                    })
                    .collect();
                // From its coordinates' lowest limb up to the limb of its weight.
                let low = 1 - i32::try_from(input).expect("a few limbs");
                let [x, y, z] = std::array::from_fn(|_| Long::random(&mut random, input, low));
                all.push([x, y, z, Long { limbs: vec![1], low: 0, negative: false }]);
                let rows: [[Long; 4]; 4] = all.try_into().ok().expect("four rows");
                let numbers = rows.each_ref().map(|row| row.each_ref().map(Long::number));
                let [a, b, c, d] = &numbers;
                assert_eq!(span(a) + span(b) + span(c) + 3 * span(d) + 1, need);
                let truth = truth(&rows);
                assert_eq!(orient3d(&numbers), truth, "{need} limbs");
                if need == CAP {
                    assert_eq!(by_capacity([a, b, c], d), truth, "{need} limbs in {CAP}");
                }
            }
        }
        let mut long = full_rows::<4>(&mut random, CAP);
        long[3] = std::array::from_fn(|_| Long { limbs: vec![1], low: 0, negative: false });
        let numbers = long.each_ref().map(|row| row.each_ref().map(Long::number));
        assert!(catch_unwind(|| by_capacity([&numbers[0], &numbers[1], &numbers[2]], &numbers[3])).is_err(), "{CAP}");
        assert_eq!(orient3d(&numbers), truth(&long), "another capacity than {CAP}");
    }
    edge::<9>(side_of::<9>);
    edge::<18>(side_of::<18>);
    edge::<36>(side_of::<36>);
    edge::<128>(side_of::<128>);
    edge::<1024>(side_of::<1024>);
}
