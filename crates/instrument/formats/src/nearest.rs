//! Suggestions for misspelled names.

/// The most similar known name, if it differs only by a typing error: a letter or two, or an ending.
pub fn nearest<'k>(name: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    let most = name.chars().count().div_ceil(4).min(3);
    let far = |known: &str| {
        if name.len() >= 3 && known.starts_with(name) { 1 } else { strsim::damerau_levenshtein(name, known) }
    };
    let known = known.into_iter().map(|known| (far(known), known));
    known.filter(|(far, _)| *far <= most).min_by_key(|(far, _)| *far).map(|(_, known)| known)
}

/// The cure for an unknown name: the most similar known name, and all known names.
#[must_use]
pub fn use_one_of(name: &str, known: &[&str]) -> String {
    let all = format!("use one of {}", known.join(", "));
    match nearest(name, known.iter().copied()) {
        Some(near) => format!("did you mean `{near}`? {all}"),
        None => all,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_of_the_hand_are_seen() {
        let known = ["exact", "sos", "naive", "shewchuk", "kettner-a1"];
        for (name, meant) in [
            ("exat", Some("exact")),
            ("naïve", Some("naive")),
            ("shewchuck", Some("shewchuk")),
            ("kettner", Some("kettner-a1")),
            ("cgal", None),
            ("", None),
        ] {
            assert_eq!(nearest(name, known), meant, "{name}");
        }
        assert_eq!(use_one_of("ssos", &["sos", "exact"]), "did you mean `sos`? use one of sos, exact");
    }
}
