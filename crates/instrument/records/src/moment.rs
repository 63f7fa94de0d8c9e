//! Moments in UTC as text: `2026-01-31T23:59:59Z`.
//!
//! Years 1970 to 9999, by the days of the Gregorian calendar. Local time and leap seconds are left to others.

/// How many days have passed since 1970-01-01 at the start of a day; `month` and `day` from 1.
///
/// Years begin in March here, so that the day that a leap year adds is the last one (Hinnant, "chrono-compatible low-level date algorithms").
const fn days(year: u64, month: u64, day: u64) -> u64 {
    let year = if month <= 2 { year - 1 } else { year };
    let (era, of_era) = (year / 400, year % 400);
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468
}

/// A moment so many seconds after 1970 began.
#[must_use]
pub fn text(seconds: u64) -> String {
    let (date, time) = (seconds / 86_400, seconds % 86_400);
    let year = (1970 + date / 366..).take_while(|&year| days(year, 1, 1) <= date).last().unwrap_or(1970);
    let month = (1..=12).take_while(|&month| days(year, month, 1) <= date).last().unwrap_or(1);
    let day = date - days(year, month, 1) + 1;
    format!("{year:04}-{month:02}-{day:02}T{:02}:{:02}:{:02}Z", time / 3_600, time / 60 % 60, time % 60)
}

/// How many seconds after 1970 began a moment is; none if it is no moment as [`text`] writes it.
#[must_use]
pub fn seconds(moment: &str) -> Option<u64> {
    let number = |from: usize, to: usize| moment.get(from..to)?.parse::<u64>().ok();
    let days = days(number(0, 4)?.max(1970), number(5, 7)?.clamp(1, 12), number(8, 10)?.clamp(1, 31));
    let seconds = days * 86_400 + number(11, 13)? * 3_600 + number(14, 16)? * 60 + number(17, 19)?;
    // What is no such day, or is written in another way, comes out as another text.
    (text(seconds) == moment).then_some(seconds)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_calendar() {
        // By `date -u -d @SECONDS`.
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
        ] {
            assert_eq!(seconds(no), None, "{no}");
        }
    }
}
