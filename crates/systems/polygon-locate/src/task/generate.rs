//! Generated maps, without any download: tilings with shared vertices.

use predicament_corpus::{Family, Level, Making, Random, Recipe};
use predicament_formats::bits::integer;
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::PolygonMap;
use predicament_predicates::Vertex;

use super::content::Probing;
use super::probes::with_probes;

/// The families of maps.
pub(super) static FAMILIES: [Family; 2] = [
    Family {
        name: "tiling",
        reported_as: Some("tiling"),
        parameters: &[],
        about: "a jittered n×n quadrilateral tiling with lakes, islands and sea",
        read: |_, fields| recipe(fields, |making| tiling(making.n, &mut making.random())),
    },
    Family {
        name: "bricks",
        reported_as: Some("bricks"),
        parameters: &[],
        about: "n courses of n bricks: axis-parallel borders and collinear runs",
        read: |_, fields| recipe(fields, |making| bricks(making.n)),
    },
];

/// Reads the rules for probing the map.
fn recipe(fields: &Fields<'_, '_>, map: fn(&Making) -> (Vec<[f64; 2]>, PolygonMap)) -> Result<Recipe, CorpusError> {
    let probing = Probing::read(fields)?;
    // A cell has at most two vertices, and there are twice as many edges as vertices. All may be probed, the vertices
    // three times.
    let coordinates = move |n: u64| {
        let vertices = (n + 1).saturating_mul(2 * n + 2);
        let probes = |level: Level| {
            let stride = probing.stride(level) as u64;
            vertices.checked_div(stride).map_or(0, |each| 5 * (each + 1)) + probing.random(level) as u64
        };
        2 * (vertices.saturating_add(probes(Level::Quick).max(probes(Level::Full))))
    };
    Ok(Recipe::new(coordinates, move |making| {
        let (points, map) = map(making);
        with_probes(points, map, &[], probing, making.level)
    }))
}

/// The distance of neighbouring lattice points before they are moved.
const PITCH: i64 = 16;
/// The maximum displacement of a lattice point: less than a quarter of the pitch keeps every quadrilateral simple.
const JITTER: i64 = 3;

/// A tiling of n×n quadrilaterals on integer coordinates.
///
/// Every third column of vertices keeps its x, so that there are vertical edges and vertices straight above each other;
/// every fourth row keeps its y, so that borders run straight through vertices. Blocks of 3×3 cells are, at random,
/// nine regions, or one ring-shaped region around an island; cells and islands are left out as sea and lakes one time
/// in eight.
fn tiling(n: usize, rng: &mut Random) -> (Vec<[f64; 2]>, PolygonMap) {
    let mut points = Vec::with_capacity((n + 1) * (n + 1));
    for row in 0..=n {
        for column in 0..=n {
            let (dx, dy) = (rng.integer(-JITTER, JITTER), rng.integer(-JITTER, JITTER));
            let x = lattice(column) + if column.is_multiple_of(3) { 0 } else { dx };
            let y = lattice(row) + if row.is_multiple_of(4) { 0 } else { dy };
            points.push([integer(x), integer(y)]);
        }
    }
    let vertex = |column: usize, row: usize| Vertex::input(row * (n + 1) + column);
    let cell = |c: usize, r: usize| vec![vertex(c, r), vertex(c + 1, r), vertex(c + 1, r + 1), vertex(c, r + 1)];
    let mut map = PolygonMap::new();
    let mut push = |name: String, rings| map.push(name, rings).expect("lattice cells are rings");
    for block_row in (0..n).step_by(3) {
        for block in (0..n).step_by(3) {
            let whole = block + 3 <= n && block_row + 3 <= n;
            if whole && rng.one_in(3) {
                let (c, r) = (block, block_row);
                let mut outer: Vec<_> = (0..3).map(|k| vertex(c + k, r)).collect();
                outer.extend((0..3).map(|k| vertex(c + 3, r + k)));
                outer.extend((0..3).map(|k| vertex(c + 3 - k, r + 3)));
                outer.extend((0..3).map(|k| vertex(c, r + 3 - k)));
                let mut hole = cell(c + 1, r + 1);
                hole.reverse();
                push(format!("ring {c},{r}"), vec![outer, hole]);
                if !rng.one_in(8) {
                    push(format!("island {c},{r}"), vec![cell(c + 1, r + 1)]);
                }
                continue;
            }
            for row in block_row..n.min(block_row + 3) {
                for column in block..n.min(block + 3) {
                    if !rng.one_in(8) {
                        push(format!("cell {column},{row}"), vec![cell(column, row)]);
                    }
                }
            }
        }
    }
    (points, map)
}

/// A map of `n` courses of `n` bricks, each course half a brick further than the one below. All borders are parallel to
/// an axis, and every brick has vertices of its neighbours in the middle of its long edges.
fn bricks(n: usize) -> (Vec<[f64; 2]>, PolygonMap) {
    // A line of joints at every height, in half bricks, long enough for both kinds of course.
    let joints = 2 * n + 2;
    let mut points = Vec::with_capacity(joints * (n + 1));
    for height in 0..=n {
        for joint in 0..joints {
            points.push([integer(lattice(joint)), integer(lattice(height))]);
        }
    }
    let vertex = |joint: usize, height: usize| Vertex::input(height * joints + joint);
    let mut map = PolygonMap::new();
    for course in 0..n {
        for brick in 0..n {
            let left = 2 * brick + course % 2;
            let bottom = (left..=left + 2).map(|joint| vertex(joint, course));
            let top = (left..=left + 2).rev().map(|joint| vertex(joint, course + 1));
            map.push(format!("brick {brick},{course}"), vec![bottom.chain(top).collect()]).expect("bricks are rings");
        }
    }
    (points, map)
}

fn lattice(index: usize) -> i64 {
    PITCH * i64::try_from(index).expect("maps are smaller than memory")
}
