//! The pixels near a segment: a k-d tree in one array, without pointers.

use predicament_grid::parallel;

use super::pixel::Pixel;
use super::plane::double;

/// The maximum number of pixels in a leaf.
const LEAF: usize = 8;

/// Indices in a list of pixels, ordered so that each range is divided at its middle by the wider side of its box.
pub struct Tree {
    order: Vec<u32>,
    /// The box of each node, in heap order.
    boxes: Vec<[Pixel; 2]>,
}

impl Tree {
    /// Builds the tree of these pixels.
    pub fn new(pixels: &[Pixel]) -> Tree {
        let mut order: Vec<u32> =
            (0..pixels.len()).map(|at| u32::try_from(at).expect("fewer than 2^32 pixels")).collect();
        let boxes = built(pixels, &mut order);
        Tree { order, boxes }
    }

    /// Calls `found` with the index of each pixel that a segment meets, and with some that it does not meet.
    pub fn near(&self, [a, b]: [[f64; 2]; 2], found: &mut dyn FnMut(u32)) {
        self.descend(0, &self.order, [a, b], found);
    }

    fn descend(&self, node: usize, range: &[u32], [a, b]: [[f64; 2]; 2], found: &mut dyn FnMut(u32)) {
        let Some([low, high]) = self.boxes.get(node).copied().filter(|_| !range.is_empty()) else { return };
        // Half a unit around the centres, and another half as a free margin; rounding below 2^50 does not need it.
        let [low, high] = [low.map(|i| double(i) - 1.0), high.map(|i| double(i) + 1.0)];
        if (0..2).any(|axis| a[axis].max(b[axis]) < low[axis] || a[axis].min(b[axis]) > high[axis])
            || beside([a, b], low, high)
        {
            return;
        }
        if range.len() <= LEAF {
            range.iter().for_each(|&at| found(at));
            return;
        }
        let (lower, upper) = range.split_at(range.len() / 2);
        self.descend(2 * node + 1, lower, [a, b], found);
        self.descend(2 * node + 2, upper, [a, b], found);
    }
}

/// True if all corners of a box are certainly on one side of a line.
fn beside([a, b]: [[f64; 2]; 2], low: [f64; 2], high: [f64; 2]) -> bool {
    let side = |x: f64, y: f64| {
        let [left, right] = [(b[0] - a[0]) * (y - a[1]), (b[1] - a[1]) * (x - a[0])];
        // Four roundings of relative 2^-53 each are less than 2^-50 of the magnitudes; underflow is below the least
        // normal double.
        let error = (left.abs() + right.abs()) * (8.0 * f64::EPSILON) + f64::MIN_POSITIVE;
        let side = left - right;
        if side > error {
            1
        } else if side < -error {
            -1
        } else {
            0
        }
    };
    let sum = side(low[0], low[1]) + side(low[0], high[1]) + side(high[0], low[1]) + side(high[0], high[1]);
    sum == 4 || sum == -4
}

/// Orders indices of pixels, and returns the boxes of the nodes: the parts of large trees in parallel.
fn built(pixels: &[Pixel], range: &mut [u32]) -> Vec<[Pixel; 2]> {
    let mut boxes = Vec::new();
    if parallel::threads(range.len()) == 1 {
        build(pixels, range, &mut boxes, 0);
        return boxes;
    }
    boxes.push(divide(pixels, range));
    let count = range.len();
    let (lower, upper) = range.split_at_mut(count / 2);
    let (lower, upper) = parallel::two(count, || built(pixels, lower), || built(pixels, upper));
    // In heap order, level by level.
    let mut level = 0..1;
    while level.start < lower.len().max(upper.len()) {
        for part in [&lower, &upper] {
            boxes.extend(level.clone().map(|node| part.get(node).copied().unwrap_or_default()));
        }
        level = level.end..2 * level.end + 1;
    }
    boxes
}

fn build(pixels: &[Pixel], range: &mut [u32], boxes: &mut Vec<[Pixel; 2]>, node: usize) {
    if boxes.len() <= node {
        boxes.resize(node + 1, [[0; 2]; 2]);
    }
    boxes[node] = divide(pixels, range);
    if range.len() > LEAF {
        let (lower, upper) = range.split_at_mut(range.len() / 2);
        build(pixels, lower, boxes, 2 * node + 1);
        build(pixels, upper, boxes, 2 * node + 2);
    }
}

/// Returns the box of some pixels, and divides them at their middle, unless they are few.
fn divide(pixels: &[Pixel], range: &mut [u32]) -> [Pixel; 2] {
    let mut around = [[i64::MAX; 2], [i64::MIN; 2]];
    for pixel in range.iter().map(|&at| pixels[at as usize]) {
        for axis in 0..2 {
            around[0][axis] = around[0][axis].min(pixel[axis]);
            around[1][axis] = around[1][axis].max(pixel[axis]);
        }
    }
    if range.len() > LEAF {
        let axis = usize::from(around[1][1] - around[0][1] > around[1][0] - around[0][0]);
        let middle = range.len() / 2;
        range.select_nth_unstable_by_key(middle, |&at| (pixels[at as usize][axis], pixels[at as usize], at));
    }
    around
}
