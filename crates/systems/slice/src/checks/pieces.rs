//! Points in all cells of a solid between planes, approximately.
//!
//! Each triangle of the solid's surface and a corner, the apex, are a tetrahedron. Each point of the solid is in one of
//! these tetrahedra, or on a side. The planes cut the tetrahedra into pieces. So each part of the solid has a piece,
//! however small the part is, and the middle of a piece is a point in that cell. The points are places to look at: the
//! caller decides exactly whether they are in the solid.

use std::collections::BTreeMap;

use predicament_judge::skin::Corners;

type Double = [f64; 3];
type Tetrahedron = [Double; 4];

/// The number of pieces that are kept of each cell: the largest ones.
const OF_EACH_CELL: usize = 8;

/// The middles of about `most` pieces of a solid: of each cell the largest ones, and of the others an even choice.
pub(super) fn middles(solid: &[Corners], planes: &[Corners], most: usize) -> Vec<Double> {
    let Some([apex, ..]) = solid.first().copied() else { return Vec::new() };
    let mut cells: BTreeMap<Vec<bool>, Vec<(f64, Double)>> = BTreeMap::new();
    for &[a, b, c] in solid {
        let mut pieces = vec![[apex, a, b, c]];
        for plane in planes {
            pieces = pieces.into_iter().flat_map(|piece| cut(piece, plane)).collect();
        }
        for piece in pieces {
            let [p, q, r, s] = piece;
            let middle = [0, 1, 2].map(|axis: usize| (p[axis] + q[axis] + r[axis] + s[axis]) / 4.0);
            let cell = planes.iter().map(|plane| side(plane, middle) > 0.0).collect();
            cells.entry(cell).or_default().push((six([p, q, r], s).abs(), middle));
        }
    }
    let (mut kept, mut others) = (Vec::new(), Vec::new());
    for mut cell in cells.into_values() {
        cell.sort_by(|p, q| q.0.total_cmp(&p.0));
        let places = cell.into_iter().map(|(_, middle)| middle);
        let (large, small): (Vec<_>, Vec<_>) = places.enumerate().partition(|(at, _)| *at < OF_EACH_CELL);
        kept.extend(large.into_iter().map(|(_, middle)| middle));
        others.extend(small.into_iter().map(|(_, middle)| middle));
    }
    kept.truncate(most);
    let step = others.len().div_ceil((most - kept.len()).max(1)).max(1);
    kept.extend(others.into_iter().step_by(step));
    kept.retain(|p| p.iter().all(|x| x.is_finite()));
    kept
}

/// The pieces of a tetrahedron on both sides of a plane: each edge that crosses the plane is cut there.
fn cut(whole: Tetrahedron, plane: &Corners) -> Vec<Tetrahedron> {
    let mut done = Vec::new();
    let mut open = vec![(whole, whole.map(|p| side(plane, p)))];
    while let Some((piece, sides)) = open.pop() {
        let edges = (0..4).flat_map(|i| (0..i).map(move |j| [i, j]));
        let Some([i, j]) = edges.into_iter().find(|&[i, j]| sides[i] * sides[j] < 0.0) else {
            done.push(piece);
            continue;
        };
        let part = sides[i] / (sides[i] - sides[j]);
        let at = [0, 1, 2].map(|axis: usize| piece[i][axis] + part * (piece[j][axis] - piece[i][axis]));
        for end in [i, j] {
            let mut half = (piece, sides);
            (half.0[end], half.1[end]) = (at, 0.0);
            open.push(half);
        }
    }
    done
}

/// Six times the volume of a tetrahedron.
fn six([a, b, c]: Corners, d: Double) -> f64 {
    let [p, q, r] = [a, b, c].map(|point| [point[0] - d[0], point[1] - d[1], point[2] - d[2]]);
    p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
}

/// A number with the sign of the side of a point on a plane.
fn side(plane: &Corners, p: Double) -> f64 {
    six(*plane, p)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_fill_the_tetrahedron_on_both_sides() {
        let whole = [[0.0; 3], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 8.0]];
        let volume = |[p, q, r, s]: Tetrahedron| six([p, q, r], s).abs();
        for x in [1.0, 4.0, 8.0, 9.0] {
            let plane = [[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
            let pieces = cut(whole, &plane);
            assert_eq!(pieces.iter().copied().map(volume).sum::<f64>(), volume(whole), "{x}");
            let small = pieces.iter().filter(|piece| piece.iter().all(|p| p[0] >= x));
            assert_eq!(small.copied().map(volume).sum::<f64>(), (8.0 - x).max(0.0).powi(3), "{x}");
        }
    }
}
