//! 20,000 queries of geometric predicates with their exact signs; `docs/VECTORS.md` describes the rows.

use std::collections::BTreeMap;

use serde::{Deserialize, de::DeserializeOwned};
use serde_json::Value;

/// One query with everything that is known about it.
#[derive(Clone, Debug, Deserialize)]
pub struct Vector {
    pub id: String,
    pub predicate: String,
    pub hex: Vec<Vec<String>>,
    pub vertices: Vec<String>,
    pub doubles: String,
    pub decimals: Option<String>,
    pub flags: Vec<String>,
    #[serde(default)]
    pub axis: Option<String>,
}

impl Vector {
    /// The arguments of the predicate, as points in order; `None` if a vertex is constructed.
    pub fn points(&self) -> Option<Vec<Vec<f64>>> {
        let point = |at: usize| self.hex[at].iter().map(|text| double(text)).collect();
        self.vertices.iter().map(|vertex| vertex.parse().ok().map(point)).collect()
    }
}

/// A whole scene of a task: arrays by name, coordinates as hex floats.
#[derive(Clone, Debug, Deserialize)]
pub struct Task {
    pub id: String,
    pub task: String,
    pub question: BTreeMap<String, Value>,
    pub doubles: BTreeMap<String, Value>,
    pub decimals: Option<BTreeMap<String, Value>>,
    pub flags: Vec<String>,
}

/// All rows.
pub fn vectors() -> Vec<Vector> {
    rows(include_bytes!("../vectors.json.gz"))
}

/// The whole scenes.
pub fn tasks() -> Vec<Task> {
    rows(include_bytes!("../tasks.json.gz"))
}

fn rows<Row: DeserializeOwned>(packed: &[u8]) -> Vec<Row> {
    #[derive(Deserialize)]
    struct File<Row> {
        rows: Vec<Row>,
    }
    let reader = std::io::BufReader::new(flate2::read::GzDecoder::new(packed));
    serde_json::from_reader::<_, File<Row>>(reader).expect("the file of the package").rows
}

/// The double of a hex float as in C: at most 53 bits, so that no step rounds.
pub fn double(text: &str) -> f64 {
    let (sign, text) = text.strip_prefix('-').map_or((1.0, text), |text| (-1.0, text));
    let (mantissa, exponent) = text.trim_start_matches("0x").split_once('p').expect("a hex float");
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("hex digits");
    let exponent = exponent.parse::<i32>().expect("an exponent") - 4 * fraction.len() as i32;
    // In two steps, each of a power that is a double.
    let half = exponent / 2;
    sign * digits as f64 * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}
