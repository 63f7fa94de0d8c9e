//! The effort of heavy tests: a twentieth by default, all of it under `cargo xtask nightly`.
//!
//! The hundredth run of a sweep over millions of inputs finds little that the first did not, so most runs take a
//! twentieth. A test asserts the same at either effort, and one variable decides for all tests: [`VARIABLE`]. Only
//! tests depend on this crate.

use std::sync::OnceLock;

/// The environment variable: `whole`, or unset for a twentieth.
pub const VARIABLE: &str = "PREDICAMENT_EFFORT";

/// The divisor of heavy tests: by default one of 20 inputs runs.
const DIVISOR: usize = 20;

/// The divisor of the number of inputs: 1 if heavy tests run in full, else 20.
///
/// # Panics
///
/// If [`VARIABLE`] is set to anything but `whole`, so that a misspelled word is not mistaken for it.
#[must_use]
pub fn divisor() -> usize {
    static READ: OnceLock<usize> = OnceLock::new();
    *READ.get_or_init(|| {
        let set = std::env::var_os(VARIABLE);
        let word = set.map(|word| word.to_string_lossy().into_owned());
        parse(word.as_deref()).unwrap_or_else(|message| panic!("{message}"))
    })
}

fn parse(word: Option<&str>) -> Result<usize, String> {
    match word {
        None => Ok(DIVISOR),
        Some("whole") => Ok(1),
        Some(other) => Err(format!("{VARIABLE} is `{other}`; only `whole` is known")),
    }
}

/// Returns true if heavy tests run in full.
#[must_use]
pub fn whole() -> bool {
    divisor() == 1
}

/// The first of two amounts by default, the second if heavy tests run in full.
///
/// It is for tests for which a twentieth would be too few inputs, or still too many.
#[must_use]
pub fn some_or_all<T>(some: T, all: T) -> T {
    if whole() { all } else { some }
}

/// The number of inputs that a heavy test tries: a twentieth of `all`, rounded up, or all.
#[must_use]
pub fn scaled(all: usize) -> usize {
    all.div_ceil(divisor())
}

/// The same number as [`scaled`], for the cases of property tests.
#[must_use]
pub fn cases(all: u32) -> u32 {
    u32::try_from(scaled(all as usize)).expect("at most as many as given")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_known_words_set_the_effort() {
        assert_eq!(parse(None), Ok(20));
        assert_eq!(parse(Some("whole")), Ok(1));
        for word in ["", "Whole", "1", "full"] {
            assert!(parse(Some(word)).unwrap_err().contains(VARIABLE), "`{word}` passes for an effort");
        }
    }

    #[test]
    fn something_is_left_of_everything() {
        assert_eq!(scaled(1), 1);
        assert_eq!(cases(4000), if whole() { 4000 } else { 200 });
    }
}
