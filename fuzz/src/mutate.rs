//! Changes to a suite's text that keep it a suite: they replace numbers, and delete, repeat or swap rows of arrays.

use predicament_formats::hexfloat;

/// A stream of weak pseudo-random numbers: libFuzzer gives one seed per change.
struct Stream(u64);

impl Stream {
    fn next(&mut self) -> u64 {
        // Knuth's MMIX constants; the low bits are poor.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.next()).unwrap_or(0) % n.max(1)
    }
}

/// The text changed in one to four places; the same text if it has no numbers.
#[must_use]
pub fn mutated(text: &str, seed: u32) -> String {
    let mut stream = Stream(u64::from(seed).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut text = text.to_owned();
    for _ in 0..=stream.below(4) {
        text = match stream.below(8) {
            0..=4 => number(&text, &mut stream),
            _ => row(&text, &mut stream),
        };
    }
    text
}

/// Applies a change for libFuzzer: to the text, or occasionally to its bytes, by `bytewise`. Returns the new size.
#[must_use]
pub fn in_place(
    data: &mut [u8],
    size: usize,
    most: usize,
    seed: u32,
    bytewise: impl FnOnce(&mut [u8], usize, usize) -> usize,
) -> usize {
    let changed = std::str::from_utf8(&data[..size]).ok().filter(|_| seed % 16 != 0).map(|text| mutated(text, seed));
    match changed.filter(|text| text.len() <= most.min(data.len())) {
        Some(text) => {
            data[..text.len()].copy_from_slice(text.as_bytes());
            text.len()
        }
        None => bytewise(data, size, most),
    }
}

/// The positions and values of a text's numbers that may be coordinates, in quotes or not.
fn numbers(text: &str) -> Vec<(usize, usize, f64)> {
    let bytes = text.as_bytes();
    let is_part = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'+' | b'-' | b'_');
    let mut found = Vec::new();
    let mut at = 0;
    let mut in_array = 0_usize;
    while at < bytes.len() {
        match bytes[at] {
            b'[' => in_array += 1,
            b']' => in_array = in_array.saturating_sub(1),
            b'#' => {
                at += text[at..].find('\n').unwrap_or(text.len() - at);
                continue;
            }
            byte if is_part(byte) => {
                let end = at + bytes[at..].iter().position(|&byte| !is_part(byte)).unwrap_or(bytes.len() - at);
                let word = &text[at..end];
                let value =
                    hexfloat::parse(word).ok().or_else(|| word.parse().ok()).filter(|value: &f64| value.is_finite());
                if let Some(value) = value.filter(|_| in_array > 0) {
                    found.push((at, end, value));
                }
                at = end;
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    found
}

/// Replaces one number: by another of the text, a neighbour, one in between, a small one, a negated or a scaled one.
fn number(text: &str, stream: &mut Stream) -> String {
    let numbers = numbers(text);
    if numbers.is_empty() {
        return text.to_owned();
    }
    let (start, end, old) = numbers[stream.below(numbers.len())];
    let any = |stream: &mut Stream| numbers[stream.below(numbers.len())].2;
    let new = match stream.below(9) {
        0 | 1 => any(stream),
        2 => (0..=stream.below(3)).fold(old, |x, _| x.next_up()),
        3 => (0..=stream.below(3)).fold(old, |x, _| x.next_down()),
        4 => f64::from(u8::try_from(stream.below(9)).unwrap_or(0)) - 4.0,
        5 => -old,
        6 => {
            let (p, q) = (any(stream), any(stream));
            p + (q - p) * [0.5, 2.0, -1.0, 1.0 / 3.0][stream.below(4)]
        }
        7 => old * 2.0_f64.powi(i32::try_from(stream.below(200)).unwrap_or(0) - 100),
        _ => old + [1.0, -1.0, 0.5, 1e-9][stream.below(4)],
    };
    if !new.is_finite() {
        return text.to_owned();
    }
    let in_quotes = text[..start].ends_with('"') && text[end..].starts_with('"');
    #[allow(clippy::float_cmp)]
    let is_small = new.trunc() == new && new.abs() < 1e6;
    let word = match (in_quotes, is_small) {
        (true, _) => hexfloat::format(new),
        (false, true) => format!("{new:.0}"),
        // An index or a count stays one.
        (false, false) if old.trunc() == old => format!("{:.0}", new.clamp(-9.0, 99.0)),
        (false, false) => format!("\"{}\"", hexfloat::format(new)),
    };
    format!("{}{word}{}", &text[..start], &text[end..])
}

/// Deletes, repeats or swaps rows of an array, each with the comma behind it.
fn row(text: &str, stream: &mut Stream) -> String {
    let rows = rows(text);
    if rows.is_empty() {
        return text.to_owned();
    }
    let (start, end) = rows[stream.below(rows.len())];
    let (before, row, after) = (&text[..start], &text[start..end], &text[end..]);
    match stream.below(4) {
        0 => format!("{before}{}", after.strip_prefix(',').unwrap_or(after)),
        1 => format!("{before}{row}, {row}{after}"),
        _ => {
            let (other, until) = rows[stream.below(rows.len())];
            if other < end && start < until {
                return text.to_owned();
            }
            let [(a, b), (c, d)] =
                if start < other { [(start, end), (other, until)] } else { [(other, until), (start, end)] };
            format!("{}{}{}{}{}", &text[..a], &text[c..d], &text[b..c], &text[a..b], &text[d..])
        }
    }
}

/// The positions of brackets within brackets: the rows of arrays, at any depth.
fn rows(text: &str) -> Vec<(usize, usize)> {
    let (mut open, mut found, mut in_quotes) = (Vec::new(), Vec::new(), false);
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'"' => in_quotes = !in_quotes,
            b'[' if !in_quotes => open.push(at),
            b']' if !in_quotes => {
                if let Some(start) = open.pop().filter(|_| !open.is_empty()) {
                    found.push((start, at + 1));
                }
            }
            _ => {}
        }
    }
    // `[[scene]]` is not a row.
    found.retain(|&(start, end)| {
        text[start..end].contains([',', '"']) || text[start..end].bytes().any(|byte| byte.is_ascii_digit())
    });
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::of_text;

    #[test]
    fn numbers_and_rows_are_found() {
        let text = "n = 3\npoints = [[1, \"0x1p-1\"], [2.5, -4]] # 7\n";
        assert_eq!(numbers(text).iter().map(|&(_, _, x)| x).collect::<Vec<_>>(), [1.0, 0.5, 2.5, -4.0]);
        assert_eq!(rows(text).iter().map(|&(a, b)| &text[a..b]).collect::<Vec<_>>(), ["[1, \"0x1p-1\"]", "[2.5, -4]"]);
    }

    /// Most changes of an embedded scene leave a scene, and a different one.
    #[test]
    fn what_is_changed_stays_a_suite_more_often_than_not() {
        let (mut all, mut scenes, mut other) = (0, 0, 0);
        for (_, text) in crate::seeds::scenes().into_iter().filter(|(_, text)| text.len() < 4000) {
            for seed in 0..8 {
                let changed = mutated(&text, seed);
                all += 1;
                scenes += usize::from(!of_text(&changed).is_empty());
                other += usize::from(changed != text);
            }
        }
        assert!(scenes * 2 > all && other * 4 > all * 3, "{scenes} scenes, {other} others of {all}");
    }
}
