//! Versions and requirements in cargo's order: the part of semantic versioning that advisories use.

use std::cmp::Ordering;

/// A version: three numbers, and a pre-release tag if there is one.
///
/// Build metadata is dropped, since it does not affect the order.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Version {
    numbers: [u64; 3],
    tag: String,
}

impl Version {
    /// Parses the version of a lock file; `None` if the text is not a version.
    pub fn parse(text: &str) -> Option<Version> {
        let (version, given) = partial(text)?;
        (given == 3).then_some(version)
    }

    /// The first version that `^self` excludes: the leftmost nonzero number is incremented.
    fn after_caret(&self, given: usize) -> Version {
        let leftmost = self.numbers.iter().take(given).position(|&number| number > 0).unwrap_or(given - 1);
        self.next(leftmost)
    }

    /// The version with this number incremented and zeros after it.
    fn next(&self, at: usize) -> Version {
        let mut numbers = [0; 3];
        numbers[..=at].copy_from_slice(&self.numbers[..=at]);
        numbers[at] += 1;
        // Below every pre-release of it: `^1.2` excludes 2.0.0-alpha.
        Version { numbers, tag: "0".to_owned() }
    }
}

impl Ord for Version {
    fn cmp(&self, other: &Version) -> Ordering {
        let tags = || match (self.tag.is_empty(), other.tag.is_empty()) {
            (true, true) => Ordering::Equal,
            (true, false) => Ordering::Greater,
            (false, true) => Ordering::Less,
            (false, false) => {
                let parts = |tag: &str| tag.split('.').map(Part::of).collect::<Vec<_>>();
                parts(&self.tag).cmp(&parts(&other.tag))
            }
        };
        self.numbers.cmp(&other.numbers).then_with(tags)
    }
}

impl PartialOrd for Version {
    fn partial_cmp(&self, other: &Version) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A part of a pre-release tag; numbers sort before words.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    Number(u64),
    Word(String),
}

impl Part {
    fn of(text: &str) -> Part {
        text.parse().map_or_else(|_| Part::Word(text.to_owned()), Part::Number)
    }
}

/// A version that may lack its last numbers, and its count of numbers.
fn partial(text: &str) -> Option<(Version, usize)> {
    let text = text.split('+').next().unwrap_or_default();
    let (numbers, tag) = text.split_once('-').unwrap_or((text, ""));
    let given: Vec<u64> = numbers.split('.').map(str::parse).collect::<Result<_, _>>().ok()?;
    if given.is_empty() || given.len() > 3 || text.ends_with('-') {
        return None;
    }
    let mut numbers = [0; 3];
    numbers[..given.len()].copy_from_slice(&given);
    Some((Version { numbers, tag: tag.to_owned() }, given.len()))
}

/// Returns true if a version meets a requirement such as `>= 1.2.3, < 2` or `^0.4.1`.
///
/// `None` if the requirement can't be read. Unlike in cargo, pre-releases within its range meet a requirement without a
/// pre-release tag: whether a version is affected does not depend on what cargo would choose.
pub fn meets(version: &Version, requirement: &str) -> Option<bool> {
    let each = requirement.split(',').map(|comparison| holds(version, comparison.trim()));
    each.collect::<Option<Vec<bool>>>().map(|all| all.into_iter().all(|it| it))
}

fn holds(version: &Version, comparison: &str) -> Option<bool> {
    let split = comparison.find(|c: char| !"<>=^~".contains(c))?;
    let (operator, rest) = comparison.split_at(split);
    let (bound, given) = partial(rest.trim())?;
    // `> 1.2` excludes all of 1.2, and `<= 1.2` includes all of it.
    let is_past = || if given == 3 { *version > bound } else { *version >= bound.next(given - 1) };
    let is_within = |end: Version| *version >= bound && *version < end;
    Some(match operator {
        ">=" => *version >= bound,
        "<" => *version < bound,
        ">" => is_past(),
        "<=" => !is_past(),
        "=" if given == 3 => *version == bound,
        "=" => is_within(bound.next(given - 1)),
        "~" => is_within(bound.next(given.min(2) - 1)),
        "" | "^" => is_within(bound.after_caret(given)),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn version(text: &str) -> Version {
        Version::parse(text).unwrap_or_else(|| panic!("{text}"))
    }

    #[test]
    fn versions_are_in_the_order_of_semantic_versioning() {
        let ordered = [
            "0.9.9",
            "1.0.0-alpha",
            "1.0.0-alpha.1",
            "1.0.0-alpha.beta",
            "1.0.0-beta",
            "1.0.0-beta.2",
            "1.0.0-beta.11",
            "1.0.0-rc.1",
            "1.0.0",
            "1.0.1",
            "1.10.0",
        ];
        for pair in ordered.windows(2) {
            assert!(version(pair[0]) < version(pair[1]), "{pair:?}");
        }
        assert_eq!(version("1.2.3+spec-1.1.0"), version("1.2.3"));
        for text in ["", "1", "1.2", "1.2.x", "1.2.3.4", "v1.2.3", "1.2.3-"] {
            assert_eq!(Version::parse(text), None, "{text}");
        }
    }

    #[test]
    fn requirements_are_met_up_to_their_ends() {
        for (requirement, inside, outside) in [
            (">= 1.2.3", "1.2.3", "1.2.2"),
            (">=1.2.3", "2.0.0", "1.2.3-rc.1"),
            ("> 0.32.1", "0.32.2", "0.32.1"),
            ("> 1", "2.0.0", "1.9.9"),
            ("< 1.2.3", "1.2.2", "1.2.3"),
            ("< 0.5.0-alpha.3", "0.5.0-alpha.2", "0.5.0-alpha.3"),
            ("<= 1.2", "1.2.9", "1.3.0"),
            ("= 1.2.3", "1.2.3", "1.2.4"),
            ("=1.2", "1.2.7", "1.3.0"),
            ("~1.2.3", "1.2.9", "1.3.0"),
            ("~1", "1.9.0", "2.0.0"),
            ("^1.2.3", "1.9.0", "2.0.0"),
            ("^ 0.4.10", "0.4.11", "0.5.0"),
            ("^0.0.3", "0.0.3", "0.0.4"),
            ("^0.0", "0.0.9", "0.1.0"),
            ("^0", "0.9.0", "1.0.0"),
            ("1.2.3", "1.2.4", "2.0.0-alpha"),
            (">= 0.5.0, < 0.6.1", "0.6.0", "0.6.1"),
        ] {
            assert_eq!(meets(&version(inside), requirement), Some(true), "{inside} {requirement}");
            assert_eq!(meets(&version(outside), requirement), Some(false), "{outside} {requirement}");
        }
        for requirement in ["", "*", "1.x", "=> 1.0.0", ">= 1.0.0,", "newest"] {
            assert_eq!(meets(&version("1.0.0"), requirement), None, "{requirement}");
        }
    }
}
