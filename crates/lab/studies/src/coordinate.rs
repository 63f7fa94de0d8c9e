//! Coordinates in suites that studies write.

use predicament_formats::{hexfloat, is_exact};

/// A coordinate in a form that is read back without loss: a decimal if possible, else a hex float.
pub(crate) fn coordinate(x: f64) -> toml::Value {
    // adding zero removes the sign of negative zero
    let text = (x + 0.0).to_string();
    match text.parse::<i64>() {
        // Beyond 2^53 the shortest digits may not be those of a double.
        Ok(whole) if is_exact(&text) => toml::Value::Integer(whole),
        _ if is_exact(&text) => toml::Value::String(text),
        _ => toml::Value::String(hexfloat::format(x)),
    }
}
