//! A filter for points of space that are certainly not vertices of the hull.
//!
//! The extreme points in 26 directions have a hull of few faces, by signs. A box in the middle of that hull is found by
//! rounded coordinates: each of its corners is on the inner side of each face by more than rounding errors. A point
//! within the box by more than the session's reach is inside the hull, also under a perturbation by infinitesimals. So
//! only the other points are asked about.

use predicament_grid::parallel;
use predicament_predicates::{Predicates, Scene, Vertex};

use super::scratch::Scratch;
use super::{PIECE, incremental};

/// The minimum number of points for which the filter saves time.
const FEW: usize = 4096;
/// The number of points that are compared together.
const CHUNK: usize = 512;
/// The value of no point.
const NOTHING: (f64, usize) = (f64::NEG_INFINITY, 0);
/// The directions, up to their signs.
const DIRECTIONS: [[f64; 3]; 13] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0],
    [0.0, 1.0, -1.0],
    [1.0, 1.0, 1.0],
    [1.0, 1.0, -1.0],
    [1.0, -1.0, 1.0],
    [1.0, -1.0, -1.0],
];
/// The number of halvings in the search for the largest box.
const STEPS: i32 = 10;

/// The vertices of a scene in space that are not certainly inside its hull, ascending.
pub(super) fn outer(session: &dyn Predicates, scratch: &mut Scratch) -> Vec<Vertex> {
    let scene = session.scene();
    let found = if scene.len() < FEW { None } else { middle(session, scratch) };
    let Some([low, high]) = found else { return scene.vertices().collect() };
    let is_inside = |[x, y, z]: [f64; 3]| {
        (low[0] < x) & (x < high[0]) & (low[1] < y) & (y < high[1]) & (low[2] < z) & (z < high[2])
    };
    let points = scene.coordinates().as_chunks::<3>().0;
    let pieces = parallel::each(points.len().div_ceil(PIECE), &|piece| {
        let piece = points.iter().zip(0..).skip(piece * PIECE).take(PIECE);
        piece.filter(|(point, _)| !is_inside(**point)).map(|(_, at)| Vertex::input(at)).collect::<Vec<Vertex>>()
    });
    pieces.concat()
}

/// The lowest and the highest corner of a box whose open inside is inside the hull; `None` if none is found.
fn middle(session: &dyn Predicates, scratch: &mut Scratch) -> Option<[[f64; 3]; 2]> {
    let scene = session.scene();
    let extreme = extreme(scene);
    let hull = incremental::hull(session, scratch, &extreme);
    if hull.broken.is_some() || hull.faces.len() < 4 {
        return None;
    }
    let faces: Vec<[[f64; 3]; 3]> =
        hull.faces.iter().map(|face| [face[0], face[1], face[2]].map(|v| scene.point3(v))).collect();
    let end = |least: f64, pick: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|axis| extreme.iter().map(|&v| scene.point3(v)[axis]).fold(least, pick))
    };
    let [least, most] = [end(f64::INFINITY, f64::min), end(f64::NEG_INFINITY, f64::max)];
    let sized = |share: f64| {
        let corner = |sign: f64| {
            [0, 1, 2].map(|axis: usize| {
                let [low, high] = [least[axis] / 2.0, most[axis] / 2.0];
                low + high + sign * share * (high - low)
            })
        };
        [corner(-1.0), corner(1.0)]
    };
    let fits = |share: f64| {
        let ends = sized(share);
        let corners = (0..8).map(|at| [0, 1, 2].map(|axis: usize| ends[at >> axis & 1][axis]));
        corners.into_iter().all(|corner| faces.iter().all(|face| is_certainly_inside(*face, corner)))
    };
    let mut share = 0.0;
    for step in 1..=STEPS {
        let wider = share + f64::from(1 << (STEPS - step)) / f64::from(1 << STEPS);
        if fits(wider) {
            share = wider;
        }
    }
    let [low, high] = (share > 0.0).then(|| sized(share))?;
    let by = session.reach().next_up();
    Some([low.map(|x| (x + by).next_up()), high.map(|x| (x - by).next_down())])
}

/// The extreme vertices in all directions, by rounded coordinates, each once.
fn extreme(scene: &Scene) -> Vec<Vertex> {
    let points = scene.coordinates().as_chunks::<3>().0;
    let pieces = parallel::each(points.len().div_ceil(PIECE), &|piece| {
        let from = piece * PIECE;
        utmost(&points[from..points.len().min(from + PIECE)], from)
    });
    let mut most = [[NOTHING; 2]; DIRECTIONS.len()];
    for piece in pieces {
        for (most, other) in most.as_flattened_mut().iter_mut().zip(piece.as_flattened()) {
            // Of equal values, the first one counts.
            *most = if other.0 > most.0 { *other } else { *most };
        }
    }
    let mut found: Vec<Vertex> = most.as_flattened().iter().map(|&(_, at)| Vertex::input(at)).collect();
    found.sort_unstable();
    found.dedup();
    found
}

/// The greatest value in each direction and in the opposite one, with the index of its point; the first has index
/// `from`.
fn utmost(points: &[[f64; 3]], from: usize) -> [[(f64, usize); 2]; DIRECTIONS.len()] {
    let mut most = [[NOTHING; 2]; DIRECTIONS.len()];
    let mut columns = [[0.0; CHUNK]; 3];
    let mut values = [0.0; CHUNK];
    for (chunk, from) in points.chunks(CHUNK).zip((from..).step_by(CHUNK)) {
        for (at, point) in chunk.iter().enumerate() {
            (0..3).for_each(|axis| columns[axis][at] = point[axis]);
        }
        let values = &mut values[..chunk.len()];
        for (direction, most) in DIRECTIONS.iter().zip(&mut most) {
            let [x, y, z] = columns.each_ref().map(|column| &column[..values.len()]);
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for at in 0..values.len() {
                let value = direction[0] * x[at] + direction[1] * y[at] + direction[2] * z[at];
                values[at] = value;
                low = if value < low { value } else { low };
                high = if value > high { value } else { high };
            }
            let [up, down] = most;
            for (best, value, own) in [(up, high, high), (down, -low, low)] {
                if value > best.0
                    && let Some(at) = values.iter().position(|&other| other == own)
                {
                    *best = (value, from + at);
                }
            }
        }
    }
    most
}

/// True if a point is certainly on the inner side of the plane through three points, which are counterclockwise as seen
/// from outside.
///
/// The bound on the error of the determinant is Shewchuk's (1997, section 4.3), with u = 2^-53, doubled. It holds
/// without underflow and overflow: differences of other sizes decide nothing.
fn is_certainly_inside(face: [[f64; 3]; 3], point: [f64; 3]) -> bool {
    let rows = face.map(|corner| [0, 1, 2].map(|axis: usize| corner[axis] - point[axis]));
    let is_moderate = |x: &f64| *x == 0.0 || (1e-100..1e100).contains(&x.abs());
    let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = rows;
    let of = |[p, q]: [f64; 2], factor: f64| [factor * (p - q), factor.abs() * (p.abs() + q.abs())];
    let terms = [of([bx * cy, cx * by], az), of([cx * ay, ax * cy], bz), of([ax * by, bx * ay], cz)];
    let [determinant, size] = [0, 1].map(|at: usize| terms[0][at] + terms[1][at] + terms[2][at]);
    rows.as_flattened().iter().all(is_moderate) && determinant > 8.0 * f64::EPSILON * size
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_certainly_inside_only_below_the_plane() {
        let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        for (z, is_inside) in
            [(-1.0, true), (0.0, false), (1.0, false), (-1e-300, false), (-1e99, true), (f64::MIN, false)]
        {
            assert_eq!(is_certainly_inside(face, [0.25, 0.25, z]), is_inside, "{z}");
        }
    }
}
