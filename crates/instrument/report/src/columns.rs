//! The columns of a page's data, as JSON.

use std::collections::BTreeMap;

use serde_json::{Value, json};

/// A list of distinct words, and each word as an index in it.
pub(crate) fn dictionary(words: impl Iterator<Item = String>) -> Value {
    let (mut places, mut list): (BTreeMap<String, usize>, Vec<String>) = (BTreeMap::new(), Vec::new());
    let at: Vec<usize> = words
        .map(|word| {
            *places.entry(word).or_insert_with_key(|word| {
                list.push(word.clone());
                list.len() - 1
            })
        })
        .collect();
    json!({ "words": list, "at": at })
}

/// Numbers, with `null` for missing ones. Numbers that JSON does not have are text: `-inf`, `inf` and `NaN`.
pub(crate) fn numbers(values: impl Iterator<Item = Option<f64>>) -> Value {
    let value = |x: Option<f64>| match x {
        None => Value::Null,
        Some(x) if x.is_finite() => json!(x),
        Some(x) => json!(x.to_string()),
    };
    json!({ "numbers": values.map(value).collect::<Vec<_>>() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_kept_once_and_numbers_without_a_name_in_json_are_text() {
        let of = dictionary(["b", "a", "b"].into_iter().map(str::to_owned));
        assert_eq!(of, json!({ "words": ["b", "a"], "at": [0, 1, 0] }));
        let of = numbers([Some(-1.5), None, Some(f64::NEG_INFINITY), Some(f64::NAN)].into_iter());
        assert_eq!(of, json!({ "numbers": [-1.5, null, "-inf", "NaN"] }));
    }
}
