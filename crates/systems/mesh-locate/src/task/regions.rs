//! The key `regions`: the regions in front of each face of a mesh and behind it, written in the suite or in a CSV file.

use predicament_corpus::{Context, Origin};
use predicament_formats::{Cache, CorpusError, Decimals, Field, RowKind, TableKind, read_csv_rows};

static FILE: TableKind = TableKind::new("reference to regions", &["path"]);

/// The largest region number that is accepted; larger numbers are typing errors.
const MOST: u32 = 1 << 31;

const CURE: &str = "write for each face the region in front of it and the one behind, 0 for outside";

static PAIR: RowKind = RowKind { name: "pair", widths: 2..=2, numbers: "regions", cure: CURE };

/// The value of `regions`.
pub enum Regions {
    /// Written out in the suite.
    Written(Pairs),
    /// Regions in a separate file.
    File(Origin),
}

/// A pair of regions for each face, and their place in the text.
#[derive(Clone)]
pub struct Pairs {
    pairs: Vec<[u32; 2]>,
    file: String,
    lines: Vec<usize>,
    /// The common line of all pairs, if they are in a suite.
    line: Option<usize>,
}

impl Regions {
    /// Reads an array of pairs, or `{ path = "regions.csv" }`.
    pub fn read(context: &Context<'_>, field: &Field<'_, '_>) -> Result<Regions, CorpusError> {
        if field.is_table() {
            let table = field.fields(&FILE)?;
            let origin = Origin::path(context, &table.required("path")?)?;
            table.finish()?;
            return Ok(Regions::File(origin));
        }
        let items = field.items("pairs of region numbers, or `{ path = \"regions.csv\" }`")?;
        let (mut pairs, mut lines) = (Vec::with_capacity(items.len()), Vec::with_capacity(items.len()));
        for item in items {
            let pair: Vec<u64> = item
                .items("two region numbers")?
                .map(|region| region.integer(0..=u64::from(MOST)))
                .collect::<Result<_, _>>()?;
            let [front, behind] = pair[..] else {
                return Err(item.error(format!("{} regions for one face", pair.len()), CURE));
            };
            pairs.push([front, behind].map(|region| u32::try_from(region).expect("in range")));
            lines.push(item.line());
        }
        Ok(Regions::Written(Pairs { pairs, file: field.file().to_owned(), lines, line: Some(field.line()) }))
    }

    /// The pairs, one for each of `faces` faces.
    pub(super) fn load(&self, cache: &Cache, faces: usize) -> Result<Pairs, CorpusError> {
        let pairs = match self {
            Regions::Written(pairs) => pairs.clone(),
            Regions::File(origin) => {
                let (file, bytes) = origin.bytes(cache)?;
                Pairs::of_file(file, bytes)?
            }
        };
        let count = pairs.pairs.len();
        if count != faces {
            // The first surplus pair, or the last pair present.
            let line = pairs.line.or(pairs.lines.get(faces).or(pairs.lines.last()).copied());
            let error = CorpusError::file(&pairs.file, format!("{count} pairs of regions for {faces} faces"), CURE);
            return Err(line.map_or(error.clone(), |line| error.at_line(line)));
        }
        Ok(pairs)
    }
}

impl Pairs {
    fn of_file(file: String, bytes: Vec<u8>) -> Result<Pairs, CorpusError> {
        let integer = format!("write an integer from 0 to {MOST}");
        // The usual fix for a coordinate, rounding, does not apply here.
        let rows = read_csv_rows(&file, bytes, &PAIR, &Decimals::new(false)).map_err(|error| {
            let is_decimal = error.message.contains("has digits that no double holds");
            if is_decimal { CorpusError { cure: integer.clone(), ..error } } else { error }
        })?;
        let wrong = |line: usize, x: f64| {
            let message = format!("`{x}` is not a region number");
            CorpusError::file(&file, message, integer.clone()).at_line(line)
        };
        let region = |x: f64| {
            // The cast is exact: the range is checked first.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            (x.fract() == 0.0 && (0.0..=f64::from(MOST)).contains(&x)).then_some(x as u32)
        };
        let (written, _): (&[[f64; 2]], _) = rows.numbers.as_chunks();
        let mut pairs = Vec::with_capacity(written.len());
        for (&[front, behind], &line) in written.iter().zip(&rows.lines) {
            let front = region(front).ok_or_else(|| wrong(line, front))?;
            pairs.push([front, region(behind).ok_or_else(|| wrong(line, behind))?]);
        }
        Ok(Pairs { pairs, file, lines: rows.lines, line: None })
    }

    /// The regions in front of a face and behind it.
    pub(super) fn of(&self, face: usize) -> [u32; 2] {
        self.pairs[face]
    }

    /// The place where the regions of a face are written, as in `regions.csv:3`.
    pub(super) fn place(&self, face: usize) -> String {
        format!("{}:{}", self.file, self.lines[face])
    }
}
