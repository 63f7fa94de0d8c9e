//! Moments in UTC as text: `2026-01-31T23:59:59Z`.
//!
//! Years 1970 to 9999. Local time and leap seconds are not supported.

use chrono::{DateTime, SecondsFormat, Utc};

/// The moment `seconds` after the start of 1970, as text.
#[must_use]
pub fn text(seconds: u64) -> String {
    let moment = i64::try_from(seconds).ok().and_then(DateTime::from_timestamp_secs);
    moment.unwrap_or(DateTime::<Utc>::MAX_UTC).to_rfc3339_opts(SecondsFormat::Secs, true)
}

/// The number of seconds from the start of 1970 to a moment; `None` if the text is not as [`text`] writes it.
#[must_use]
pub fn seconds(moment: &str) -> Option<u64> {
    let seconds = u64::try_from(moment.parse::<DateTime<Utc>>().ok()?.timestamp()).ok()?;
    // RFC 3339 allows other spellings of a moment, and leap seconds.
    (text(seconds) == moment).then_some(seconds)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_calendar() {
        // Expected values by `date -u -d @SECONDS`.
        for (number, moment) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_798_761_599, "2026-12-31T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
            (253_402_300_799, "9999-12-31T23:59:59Z"),
        ] {
            assert_eq!(text(number), moment);
            assert_eq!(seconds(moment), Some(number));
        }
        for day in 0..200_000 {
            assert_eq!(seconds(&text(day * 86_400 + 1)), Some(day * 86_400 + 1));
        }
    }

    #[test]
    fn what_is_no_moment_is_refused() {
        for no in [
            "",
            "2026-02-29T00:00:00Z",
            "2026-13-01T00:00:00Z",
            "2026-01-01",
            "2026-01-01T24:00:00Z",
            "1969-12-31T23:59:59Z",
            "2026-01-01T00:00:00+00:00",
            "2026-01-01 00:00:00Z",
            "2016-12-31T23:59:60Z",
        ] {
            assert_eq!(seconds(no), None, "{no}");
        }
    }
}
