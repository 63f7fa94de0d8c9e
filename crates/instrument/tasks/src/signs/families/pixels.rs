//! The pixel maps of Kettner, Mehlhorn, Pion, Schirra and Yap: every pixel is a neighbour of p, coloured by its turn
//! with q and r.

use predicament_predicates::Vertex;

use super::{Asked, Cloud};
use predicament_corpus::Recipe;
use predicament_formats::CorpusError;
use predicament_formats::bits::{integer, power_of_two};
use predicament_formats::{Field, Fields};

/// Reads `p`, `q`, `r`, `side` and `step`.
pub(super) fn read(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError> {
    let map = PixelMap::read(fields)?;
    let asked = Asked::read(task, fields, None)?;
    let size = map.pixels();
    let width = asked.dimension.count() as u64;
    Ok(Recipe::new(move |n| (n + 2) * width, move |making| asked.placed(map.points(), making)).of_size(size))
}

/// A square of points against two fixed ones.
#[derive(Clone, PartialEq, Debug)]
struct PixelMap {
    /// The coordinates of columns and of rows: those of p plus k steps, exactly.
    grid: [Vec<f64>; 2],
    q: [f64; 2],
    r: [f64; 2],
}

impl PixelMap {
    /// Reads `p`, `q`, `r`, `side` (256) and `step` (2^-53).
    fn read(fields: &Fields<'_, '_>) -> Result<PixelMap, CorpusError> {
        let corner_field = fields.required("p")?;
        let corner = point(&corner_field)?;
        let (q, r) = (point(&fields.required("q")?)?, point(&fields.required("r")?)?);
        let side = fields.integer_or("side", 256, 1..=4096)?.cast_signed();
        let step = match fields.get("step") {
            None => power_of_two(-53),
            Some(field) => match field.coordinate()? {
                step if is_power_of_two(step) => step,
                _ => return Err(field.error("`step` is not a power of two", "write one such as \"0x1p-53\"")),
            },
        };
        let moved = |x: f64, k: i64| {
            exact_sum(x, integer(k) * step).ok_or_else(|| {
                let message = format!("{x:e} + {k} steps is not a double");
                corner_field.error(message, "choose a larger `step`")
            })
        };
        let [columns, rows] = corner.map(|c| (0..side).map(|k| moved(c, k)).collect::<Result<Vec<_>, _>>());
        Ok(PixelMap { grid: [columns?, rows?], q, r })
    }

    /// The number of pixels, with one query each.
    fn pixels(&self) -> usize {
        self.grid[0].len() * self.grid[1].len()
    }

    /// The pixels, row by row, then q and r; one query (pixel, q, r) for each.
    fn points(&self) -> Cloud {
        let n = self.pixels();
        let [columns, rows] = &self.grid;
        let mut coordinates: Vec<f64> = Vec::with_capacity(2 * (n + 2));
        coordinates.extend(rows.iter().flat_map(|&y| columns.iter().flat_map(move |&x| [x, y])));
        coordinates.extend([self.q, self.r].as_flattened());
        let args = (0..n).flat_map(|pixel| [pixel, n, n + 1].map(Vertex::input)).collect();
        Cloud { coordinates, args: Some(args), constructions: Vec::new() }
    }
}

/// True if x is a power of two, so that every multiple with up to 53 bits is a double, too.
fn is_power_of_two(x: f64) -> bool {
    x.is_normal() && x.to_bits() & ((1 << 52) - 1) == 0 && x > 0.0
}

fn point(field: &Field<'_, '_>) -> Result<[f64; 2], CorpusError> {
    let coordinates = field.items("a point: an array of two coordinates")?;
    let coordinates = coordinates.map(|x| x.coordinate()).collect::<Result<Vec<_>, _>>()?;
    let found = coordinates.len();
    coordinates
        .try_into()
        .map_err(|_| field.error(format!("a point of {found} coordinates"), "a pixel map is flat: write two"))
}

/// The value x + y if that is a double: if the error term of Knuth's sum is zero.
fn exact_sum(x: f64, y: f64) -> Option<f64> {
    let sum = x + y;
    let y_seen = sum - x;
    let error = (x - (sum - y_seen)) + (y - y_seen);
    (sum.is_finite() && error == 0.0).then_some(sum)
}
