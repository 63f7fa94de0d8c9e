//! The key `cubes`: congruent axis-parallel cubes by their lower corners.

use predicament_corpus::{Canon, Content, Context, Elsewhere, Items, Level, List, Origin, Parts, Source, Spelled};
use predicament_formats::bits::{integer, lowest_bit, top_exponent};
use predicament_formats::{Cache, CorpusError, Decimals, Fields, RowKind, Rows, TableKind, read_csv_rows, read_rows};
use predicament_predicates::{Dimension, Scene};

static CUBES: TableKind = TableKind::new("reference to cubes", &["path"]);

const CUBE: RowKind = RowKind {
    name: "cube",
    widths: 4..=4,
    numbers: "numbers",
    cure: "give for each cube x, y and z of its lower corner and the length of its edges",
};

/// Congruent cubes: vertex 2i of the scene is the lower corner of cube i and
/// vertex 2i + 1 the upper one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Cubes {
    /// The number of cubes.
    pub cubes: usize,
}

impl Content for Cubes {
    fn count(&self) -> usize {
        self.cubes
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("cube-union");
    }

    /// The length of edges is exact: the upper corner was computed from it without rounding.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let corners: &[[f64; 6]] = scene.coordinates().as_chunks().0;
        let cubes = corners.iter().map(|&[x, y, z, upper, ..]| vec![x, y, z, upper - x]).collect();
        Some(Spelled { lists: vec![List::required("cubes", Items::Rows(cubes))], ..Spelled::default() })
    }
}

/// The maximum number of bits that all coordinates may span: sums of two are integers of 62 bits.
const MOST_BITS: i64 = 61;

/// The binary logarithm of the maximum volume: sums over the union are exact below 2^127.
const MOST_VOLUME: f64 = 126.0;

/// A CSV file of cubes: x, y, z and the edge length in each line.
struct Csv {
    origin: Origin,
    round: bool,
}

impl Elsewhere for Csv {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let decimals = Decimals::new(self.round);
        let (file, bytes) = self.origin.bytes(cache)?;
        let mut parts = scene(&file, &read_csv_rows(&file, bytes, &CUBE, &decimals)?)?;
        parts.notes.rounded += decimals.rounded();
        Ok(parts)
    }
}

/// Reads `cubes`.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let field = fields.required("cubes")?;
    if field.is_array() {
        return Ok(Source::Written(scene(fields.file(), &read_rows(&field, &CUBE)?)?));
    }
    let table = field.fields(&CUBES)?;
    let origin = Origin::path(context, &table.required("path")?)?;
    table.finish()?;
    Ok(Source::elsewhere(Csv { origin, round: context.round() }))
}

/// A scene with both corners of every cube.
fn scene(file: &str, rows: &Rows) -> Result<Parts, CorpusError> {
    let cubes: &[[f64; 4]] = rows.numbers.as_chunks().0;
    let error = |at: usize, message: String, cure: &str| {
        CorpusError::file(file, format!("cube {at}: {message}"), cure).at_line(rows.lines[at])
    };
    let mut corners = Vec::with_capacity(6 * cubes.len());
    let mut span: Option<([i64; 2], [usize; 2])> = None;
    for (at, &[x, y, z, edge]) in cubes.iter().enumerate() {
        if edge <= 0.0 {
            return Err(error(at, format!("the edge length is {edge}"), "give a positive length"));
        }
        if edge != cubes[0][3] {
            let message = format!("the edge length is {edge}; the edge length of cube 0 is {}", cubes[0][3]);
            return Err(error(at, message, "all cubes must have one size: divide the scene"));
        }
        let lower = [x, y, z];
        for number in [x, y, z, edge] {
            let (Some(low), Some(high)) = (lowest_bit(number), top_exponent(number)) else { continue };
            let ([least, most], [finest, largest]) = span.get_or_insert(([low, high], [at; 2]));
            if low < *least {
                (*least, *finest) = (low, at);
            }
            if high > *most {
                (*most, *largest) = (high, at);
            }
        }
        let upper = lower.map(|c| c + edge);
        if let Some(axis) = (0..3).find(|&axis| !is_exact(lower[axis], edge, upper[axis])) {
            let message = format!("{:?} + {edge:?} along axis {axis} is not a double", lower[axis]);
            return Err(error(at, message, "give coordinates with fewer bits"));
        }
        corners.extend(lower);
        corners.extend(upper);
    }
    if let Some(([least, most], [finest, largest])) = span {
        if most - least + 1 > MOST_BITS {
            let message = format!("with cube {largest} the coordinates span {} bits", most - least + 1);
            return Err(error(finest, message, &format!("give coordinates on one grid of {MOST_BITS} bits")));
        }
        let bits = volume_bits(&corners, least);
        if bits > MOST_VOLUME {
            let message = format!("the box around all cubes has a volume of 2^{bits:.1} in units of 2^{least}");
            let cure = format!("give coarser coordinates: up to 2^{MOST_VOLUME}, sums are exact");
            return Err(CorpusError::file(file, message, cure));
        }
    }
    let scene = Scene::new(Dimension::Three, corners)
        .map_err(|why| CorpusError::file(file, why.to_string(), "scale the cubes by a power of two"))?;
    Ok(Parts::new(scene, Cubes { cubes: cubes.len() }))
}

/// The binary logarithm of the volume of the bounding box of all corners, in units of 2^`unit`.
fn volume_bits(corners: &[f64], unit: i64) -> f64 {
    let extent = |axis: usize| {
        let along = corners.iter().skip(axis).step_by(3);
        let [low, high] = along.fold([f64::MAX, f64::MIN], |[low, high], &c| [low.min(c), high.max(c)]);
        high - low
    };
    // A logarithm of a rounded difference: the margin to 2^127 is far larger than its error.
    (0..3).map(|axis| extent(axis).log2() - integer(unit)).sum()
}

/// True if the sum is a + b without rounding: Knuth's error term is zero.
fn is_exact(a: f64, b: f64, sum: f64) -> bool {
    let b_seen = sum - a;
    sum.is_finite() && (a - (sum - b_seen)) + (b - b_seen) == 0.0
}
