//! 20,000 queries of geometric predicates with their exact signs; `docs/VECTORS.md` describes the rows.

use serde_json::Value;

/// All rows.
pub fn vectors() -> Vec<Value> {
    rows(include_bytes!("../vectors.json.gz"))
}

/// Whole scenes of tasks.
pub fn tasks() -> Vec<Value> {
    rows(include_bytes!("../tasks.json.gz"))
}

/// The arguments of the predicate, as doubles in order; `None` if a vertex is constructed.
pub fn points(row: &Value) -> Option<Vec<Vec<f64>>> {
    let point = |vertex: &Value| doubles(&row["decimal"][vertex.as_str()?.parse::<usize>().ok()?]);
    row["vertices"].as_array()?.iter().map(point).collect()
}

/// The doubles of a list of decimals.
pub fn doubles(list: &Value) -> Option<Vec<f64>> {
    list.as_array()?.iter().map(|text| text.as_str()?.parse().ok()).collect()
}

fn rows(packed: &[u8]) -> Vec<Value> {
    let text = std::io::read_to_string(flate2::read::GzDecoder::new(packed)).expect("the file of the package");
    let mut file: Value = serde_json::from_str(&text).expect("its JSON");
    serde_json::from_value(file["rows"].take()).expect("its rows")
}
