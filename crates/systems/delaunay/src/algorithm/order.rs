//! The order of insertion: rounds of random points, each along a Hilbert curve.
//!
//! A biased randomized insertion order (Amenta, Choi and Rote 2003) keeps the expected number of steps low for any
//! points: each round has about sixteen times the points of all rounds before it. Along the curve, each point is close
//! to the previous one. Only raw coordinates decide the order; the triangulation does not depend on it.
//!
//! A point's round is a hash of its coordinates, so that points in one place are consecutive, in the order of their
//! indices.

use predicament_predicates::Vertex;

/// The bits of a cell along each axis.
const BITS: u32 = 14;
/// The number of points in one cell above which they are ordered along a separate curve.
const CROWD: usize = 4;
/// Each round has about two to this power times the points of the rounds before it. More rounds replace fewer
/// triangles, but each round has to fetch from memory all that the curve passes.
const SHARE: u32 = 4;
/// The approximate minimum number of points in the first round.
const FIRST_ROUND: usize = 128;
/// The bits of one pass of the sort.
const DIGIT: u32 = 11;

/// The points with these indices in the order of insertion; the indices ascend.
pub(super) fn insertion_order(points: &[[f64; 2]], mut items: Vec<u64>) -> Vec<Vertex> {
    let rounds = (1..8).take_while(|round| items.len() >> (SHARE * round) >= FIRST_ROUND).count();
    let last = u32::try_from(rounds).unwrap_or(0);
    let mut scratch = Vec::new();
    along_curve(points, &mut items, &mut scratch, last);
    items.into_iter().map(|item| Vertex::input(index(item))).collect()
}

/// The point of an item: the item's lower half.
fn index(item: u64) -> usize {
    usize::try_from(item & u64::from(u32::MAX)).unwrap_or(0)
}

/// A hash of a point's coordinates; zeros of either sign are equal.
fn hash([x, y]: [f64; 2]) -> u64 {
    let mix = |hash: u64, x: f64| (hash ^ (x + 0.0).to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(31);
    let hash = mix(mix(0x2545_f491_4f6c_dd1d, x), y);
    (hash ^ hash >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 20
}

/// Sorts items by round, up to the last one, and by place on the curve; crowded cells are sorted again, in finer cells.
fn along_curve(points: &[[f64; 2]], items: &mut [u64], scratch: &mut Vec<u64>, last: u32) {
    let cells = Cells::around(points, items);
    for item in &mut *items {
        let point = points[index(*item)];
        let round = if last == 0 { 0 } else { last - (hash(point).trailing_zeros() / SHARE).min(last) };
        let key = round << (2 * BITS) | curve(cells.cell(point));
        *item = u64::from(key) << 32 | (*item & u64::from(u32::MAX));
    }
    sort(items, scratch);
    if cells.size <= 0.0 {
        return;
    }
    for crowd in items.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|crowd| crowd.len() > CROWD) {
        along_curve(points, crowd, scratch, 0);
    }
}

/// A square of cells around some points.
struct Cells {
    low: [f64; 2],
    /// Half the side of the square: a difference of finite numbers may not be finite.
    size: f64,
}

impl Cells {
    fn around(points: &[[f64; 2]], items: &[u64]) -> Cells {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for &item in items {
            for ((low, high), x) in low.iter_mut().zip(&mut high).zip(points[index(item)]) {
                *low = low.min(x / 2.0);
                *high = high.max(x / 2.0);
            }
        }
        Cells { low, size: (high[0] - low[0]).max(high[1] - low[1]) }
    }

    /// The cell of a point: numbers below 2^14 along each axis.
    #[inline]
    fn cell(&self, point: [f64; 2]) -> [u32; 2] {
        const LAST: u32 = (1 << BITS) - 1;
        let mut cell = [0; 2];
        for ((cell, low), x) in cell.iter_mut().zip(self.low).zip(point) {
            let share = (x / 2.0 - low) / self.size;
            // Truncation is intended; a NaN, for a square of size zero, becomes 0.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let at = (share * f64::from(LAST)) as u32;
            *cell = at.min(LAST);
        }
        cell
    }
}

/// A table of two steps along the curve: from the state and two bits of each coordinate to four bits of the place and
/// the next state.
///
/// A state has two bits: one if the axes are exchanged, one if both are reversed.
const STEPS: [u8; 64] = {
    let mut steps = [0; 64];
    let mut at = 0;
    while at < 64 {
        let (mut state, x, y) = (at >> 4, at >> 2 & 3, at & 3);
        let mut place = 0;
        let mut bit = 2;
        while bit > 0 {
            bit -= 1;
            let (mut right, mut up) = (x >> bit & 1, y >> bit & 1);
            if state & 1 == 1 {
                (right, up) = (up, right);
            }
            if state & 2 == 2 {
                (right, up) = (1 - right, 1 - up);
            }
            place = place << 2 | (3 * right) ^ up;
            if up == 0 {
                state ^= 1 | right << 1;
            }
        }
        #[allow(clippy::cast_possible_truncation)] // six bits
        {
            steps[at] = (state << 4 | place) as u8;
        }
        at += 1;
    }
    steps
};

/// The place of a cell on the Hilbert curve.
#[inline]
fn curve([x, y]: [u32; 2]) -> u32 {
    let (mut state, mut place) = (0, 0);
    let mut bit = BITS;
    while bit > 0 {
        bit -= 2;
        let step = STEPS[(state << 4 | (x >> bit & 3) << 2 | y >> bit & 3) as usize];
        place = place << 4 | u32::from(step & 15);
        state = u32::from(step >> 4);
    }
    place
}

/// Sorts by the upper half; stable if the items are in the order of their lower half.
fn sort(items: &mut [u64], scratch: &mut Vec<u64>) {
    const FEW: usize = 2000;
    if items.len() < FEW {
        return items.sort_unstable();
    }
    let own = std::mem::take(scratch);
    let mut to = own;
    to.clear();
    to.resize(items.len(), 0);
    for shift in (32..64).step_by(DIGIT as usize) {
        let digit = |item: u64| usize::try_from(item >> shift & ((1 << DIGIT) - 1)).unwrap_or(0);
        let mut starts = [0_usize; 1 << DIGIT];
        items.iter().for_each(|&item| starts[digit(item)] += 1);
        if starts.contains(&items.len()) {
            continue;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += std::mem::replace(start, sum);
        }
        for &item in &*items {
            let place = &mut starts[digit(item)];
            to[*place] = item;
            *place += 1;
        }
        items.copy_from_slice(&to);
    }
    *scratch = to;
}
