//! Expectations: their matches, and the errors of a file of expectations.

use std::path::Path;

use predicament_oracle::expect::Expectations;
use predicament_tasks::{Class, ClassCounts, Status};

fn parse(text: &str) -> Result<Expectations, String> {
    Expectations::parse(Path::new("expected.toml"), text).map_err(|error| error.to_string())
}

fn counts(classes: &[Class]) -> ClassCounts {
    let mut counts = ClassCounts::default();
    for &class in classes {
        counts.add(class, 1);
    }
    counts
}

const TEXT: &str = r#"
[[expect]]
scene = "near-*"
backend = "naive"
class = ["sign_flip", "overreach"]
reason = "rounding"
"#;

#[test]
fn each_status_is_reached() {
    let expected = parse(TEXT).unwrap();
    let status =
        |scene, backend, classes: &[Class]| expected.status("families", scene, backend, "quick", &counts(classes));
    let both = [Class::Agree, Class::SignFlip, Class::Overreach];
    assert_eq!(status("near-plane", "naive", &both), Status::Expected);
    assert_eq!(status("near-plane", "naive", &both[..2]), Status::UnexpectedPass);
    assert_eq!(status("near-plane", "naive", &[Class::Agree]), Status::UnexpectedPass);
    assert_eq!(status("near-plane", "exact", &[Class::Agree, Class::TieBroken]), Status::Ok);
    assert_eq!(status("near-plane", "exact", &[Class::SignFlip]), Status::Unexpected);
    assert_eq!(status("uniform", "naive", &[Class::SignFlip]), Status::Unexpected);
    assert_eq!(status("near-plane", "naive", &[Class::SignFlip, Class::Overreach, Class::Nan]), Status::Unexpected);
}

#[test]
fn scenes_are_named_with_or_without_their_suite() {
    let text = TEXT.replace("near-*", "families/near-*");
    let expected = parse(&text).unwrap();
    assert_eq!(expected.matching("families", "near-line", "naive", "full").count(), 2);
    assert_eq!(expected.matching("others", "near-line", "naive", "full").count(), 0);
}

#[test]
fn mistakes_are_one_line_with_a_place() {
    for (wrong, right, needle) in [
        ("reason = \"rounding\"", "reason = \" \"", "expected.toml:6: the reason is empty; say why"),
        ("reason = \"rounding\"", "reason = 7", "expected.toml:6: `reason` is of type integer; write a string"),
        ("reason = \"rounding\"", "", "expected.toml:2: table [[expect]] has no `reason`; add"),
        ("sign_flip", "sign_flop", "expected.toml:5: no class is called `sign_flop`"),
        ("overreach", "in_band", "expected.toml:5: `in_band` is legal and needs no expectation; drop it"),
        ("[\"sign_flip\", \"overreach\"]", "[]", "expected.toml:5: `class` is an empty list; name at least one"),
        ("[\"sign_flip\",", "[\n1,", "expected.toml:6: `class` is of type integer; write a string, or an array of"),
        (
            "\"near-*\"",
            "{ a = 1 }",
            "expected.toml:3: `scene` is of type table; write a string, or an array of strings",
        ),
        ("\"near-*\"", "\"\"", "expected.toml:3: `scene` has an empty name; write a name"),
        (
            "backend",
            "bakend",
            "expected.toml:4: a table [[expect]] has no key `bakend`, and `backend` is missing; correct",
        ),
        ("near-*", "near-[", "expected.toml:2: error parsing glob 'near-['"),
        (
            "reason =",
            "level = \"slow\"\nreason =",
            "expected.toml:6: no level is called `slow`; write `quick` or `full`",
        ),
        ("reason =", "level = 3\nreason =", "expected.toml:6: `level` is of type integer; write a string"),
        ("[[expect]]", "[expect]", "expected.toml:2: `expect` is of type table; write [[expect]] tables"),
        (
            "[[expect]]",
            "[[expects]]",
            "expected.toml:2: a file of expectations has no key `expects`; remove it or use one of expect",
        ),
    ] {
        let error = parse(&TEXT.replacen(wrong, right, 1)).unwrap_err();
        assert!(error.starts_with(needle), "{error}");
        assert!(!error.contains('\n'), "{error}");
    }
}
