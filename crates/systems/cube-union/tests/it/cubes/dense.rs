//! A union of cubes moved by real displacements, without infinitesimals and sections.
//!
//! Coordinates are multiplied by a large K and cube i is moved by N − i. Each measure is a polynomial in K, and its
//! leading coefficient is the limit for small perturbations. Every box of the compressed grid is either in the union or
//! not.

use predicament_cube_union::checks::Measures;

pub const K: i64 = 1_000_000_000;

/// The cubes with their displacements.
pub fn moved(lowers: &[[i64; 3]]) -> Vec<[i64; 3]> {
    let last = i64::try_from(lowers.len()).unwrap();
    (0..).zip(lowers).map(|(i, lower)| lower.map(|c: i64| c * K + last - i)).collect()
}

/// The nearest integer to n/d, which is close to an integer.
fn leading(n: i128, d: i128) -> i128 {
    let nearest = (n + d / 2).div_euclid(d);
    assert!((n - nearest * d).abs() < d / 1000, "a perturbation that isn't small");
    nearest
}

fn inside(grid: &[Vec<Vec<bool>>], at: [usize; 3]) -> bool {
    // (places from 1; 0 is outside)
    let get = || grid.get(at[0].checked_sub(1)?)?.get(at[1].checked_sub(1)?)?.get(at[2].checked_sub(1)?);
    get().copied().unwrap_or(false)
}

/// The limit of the mass properties of the moved cubes.
pub fn limit(lowers: &[[i64; 3]], edge: i64) -> Measures {
    let (lowers, edge) = (moved(lowers), edge * K);
    let cuts = [0, 1, 2].map(|axis| {
        let mut cuts: Vec<i64> = lowers.iter().flat_map(|lower| [lower[axis], lower[axis] + edge]).collect();
        cuts.sort_unstable();
        cuts.dedup();
        cuts
    });
    let [nx, ny, nz] = [0, 1, 2].map(|axis| cuts[axis].len());
    let mut grid = vec![vec![vec![false; nz]; ny]; nx];
    for lower in &lowers {
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let find = |value| cuts[axis].binary_search(&value).unwrap();
            find(lower[axis])..find(lower[axis] + edge)
        });
        for i in x {
            for j in y.clone() {
                grid[i][j][z.clone()].fill(true);
            }
        }
    }
    let width = |axis: usize, at: usize| -> i128 {
        if at == 0 || at >= cuts[axis].len() { 0 } else { i128::from(cuts[axis][at] - cuts[axis][at - 1]) }
    };
    let (mut volume, mut area, mut length) = (0, 0, 0);
    for i in 1..=nx {
        for j in 1..=ny {
            for k in 1..=nz {
                let at = [i, j, k];
                let widths = [0, 1, 2].map(|axis| width(axis, at[axis]));
                if inside(&grid, at) {
                    volume += widths[0] * widths[1] * widths[2];
                }
                for axis in 0..3 {
                    let [other, third] = [(axis + 1) % 3, (axis + 2) % 3];
                    let back = |steps: [usize; 2]| {
                        let mut at = at;
                        at[other] -= steps[0];
                        at[third] -= steps[1];
                        inside(&grid, at)
                    };
                    // A face towards the box before, along `other`.
                    if back([0, 0]) != back([1, 0]) {
                        area += widths[axis] * widths[third];
                    }
                    // An edge along `axis`: an odd number of the boxes around it are in the union. (Never two opposite
                    // ones: moved cubes do not share planes.)
                    let around = [back([0, 0]), back([1, 0]), back([1, 1]), back([0, 1])];
                    assert!(around[0] != around[2] || around[1] != around[3] || around[0] == around[1]);
                    if around.iter().filter(|&&is_in| is_in).count() % 2 == 1 {
                        length += widths[axis];
                    }
                }
            }
        }
    }
    let k = i128::from(K);
    Measures { volume: leading(volume, k * k * k), area: leading(area, k * k), edge_length: leading(length, k) }
}
