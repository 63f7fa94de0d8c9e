//! Chains of hot pixels: their order along a segment, and the division of edges until they meet no other pixel.

use super::pixel::{Pixel, meets};
use super::plane::double;
use super::tree::Tree;

/// Sorts the pixels that a segment meets from its first end to its second, each once, with both ends.
///
/// A segment has one direction along each axis, and so do the pixels that it meets: the order is that of their centres.
pub fn sort(chain: &mut Vec<u32>, [first, last]: [u32; 2], pixels: &[Pixel]) {
    chain.extend([first, last]);
    let [a, b] = [first, last].map(|at| pixels[at as usize]);
    let forward = |axis: usize, of: &Pixel| if b[axis] >= a[axis] { of[axis] } else { -of[axis] };
    chain.sort_unstable_by_key(|&at| {
        let pixel = pixels[at as usize];
        (forward(0, &pixel), forward(1, &pixel))
    });
    chain.dedup();
}

/// A chain whose edges meet no hot pixels except those of their ends.
///
/// An edge that meets others is replaced by the chain of the pixels that it meets. All of these are in the box of its
/// ends, and the parts have smaller boxes, so the process ends.
pub fn iterated(chain: &[u32], pixels: &[Pixel], tree: &Tree) -> Vec<u32> {
    let mut done: Vec<u32> = chain.first().copied().into_iter().collect();
    // The next edges, as a stack.
    let mut waiting: Vec<[u32; 2]> = chain.windows(2).rev().map(|edge| [edge[0], edge[1]]).collect();
    while let Some([from, to]) = waiting.pop() {
        let edge = [from, to].map(|at| pixels[at as usize].map(double));
        let mut met = Vec::new();
        tree.near(edge, &mut |at| {
            if at != from && at != to && meets(edge, pixels[at as usize]) {
                met.push(at);
            }
        });
        if met.is_empty() {
            done.push(to);
        } else {
            sort(&mut met, [from, to], pixels);
            waiting.extend(met.windows(2).rev().map(|edge| [edge[0], edge[1]]));
        }
    }
    done
}
