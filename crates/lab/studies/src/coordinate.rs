//! Coordinates in suites that studies write.

use predicament_formats::{hexfloat, is_exact};

/// A coordinate as it is read back without loss: a decimal if it is one, else a hex float.
pub(crate) fn coordinate(x: f64) -> toml::Value {
    // adding zero takes the sign of a negative one
    let text = (x + 0.0).to_string();
    match text.parse::<i64>() {
        // Beyond 2^53 the shortest digits may be those of no double.
        Ok(whole) if is_exact(&text) => toml::Value::Integer(whole),
        _ if is_exact(&text) => toml::Value::String(text),
        _ => toml::Value::String(hexfloat::format(x)),
    }
}
