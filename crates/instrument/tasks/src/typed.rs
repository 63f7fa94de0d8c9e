//! Generated decimals: their keys in suites, and pairs of boxes that share sides as written.

use predicament_corpus::Making;
use predicament_families::{Figure, MOST_DIGITS, Place, Typed};
use predicament_formats::{CorpusError, Fields, Written, use_one_of};

/// The keys that [`typed`] reads.
pub const TYPED_KEYS: &[&str] = &["digits", "figure", "place"];

/// Reads `digits`, `figure` and `place`.
///
/// # Errors
/// [`CorpusError`] at the line of a value that is none of these.
pub fn typed(fields: &Fields<'_, '_>) -> Result<Typed, CorpusError> {
    let digits = fields.integer_or("digits", 2, 0..=u64::from(MOST_DIGITS))?.try_into().unwrap_or(MOST_DIGITS);
    let figures: Vec<_> = Figure::ALL.iter().map(|figure| figure.name()).collect();
    let figure = word(fields, "figure", &figures)?.and_then(Figure::named).unwrap_or(Figure::General);
    let places: Vec<_> = Place::ALL.iter().map(|place| place.name()).collect();
    let place = word(fields, "place", &places)?.and_then(Place::named).unwrap_or(Place::Metres);
    Ok(Typed { digits, figure, place })
}

/// Reads a key whose value is one of these words.
pub(crate) fn word(
    fields: &Fields<'_, '_>,
    key: &'static str,
    known: &[&'static str],
) -> Result<Option<&'static str>, CorpusError> {
    let Some(field) = fields.get(key) else { return Ok(None) };
    let text = field.str()?;
    let found = known.iter().copied().find(|name| *name == text);
    found.map(Some).ok_or_else(|| field.error(format!("`{text}` is no {key}"), use_one_of(text, known)))
}

/// Two lists of boxes; the boxes with equal places share a part of a side as written.
pub struct Neighbours<const D: usize> {
    /// The decimals of all points: the corners of the first boxes, then those of the second, 2^D each.
    pub written: Written,
    /// The nearest doubles of the points.
    pub points: Vec<[f64; D]>,
    /// The number of boxes in each list.
    pub count: usize,
}

impl<const D: usize> Neighbours<D> {
    /// About `making.n` corners, at least those of one pair.
    #[must_use]
    pub fn new(typed: Typed, making: &Making) -> Neighbours<D> {
        let count = (making.n >> (D + 1)).max(1);
        let pairs = typed.neighbours::<D>(count, &mut making.random());
        let list = |at: usize| pairs.iter().flat_map(move |pair| pair[at].as_flattened());
        let written = Written::new(typed.digits, list(0).chain(list(1)).copied().collect());
        let points = written.doubles().chunks_exact(D).map(|point| std::array::from_fn(|i| point[i])).collect();
        Neighbours { written, points, count }
    }

    /// The numbers of each box's first corner: those of the first list, and those of the second.
    #[must_use]
    pub fn first_corners(&self) -> [Vec<usize>; 2] {
        [0, self.count].map(|from| (from..from + self.count).map(|at| at << D).collect())
    }
}

/// The corners of a parcel, counterclockwise from its first.
pub const RING: [usize; 4] = [0, 1, 3, 2];

/// The triangles of a box, counterclockwise as seen from outside.
pub const FACES: [[usize; 3]; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];
