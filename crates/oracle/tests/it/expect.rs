//! Expectations: what they match, and what is wrong with a file of them.

use std::path::Path;

use predicament_oracle::expect::Expectations;
use predicament_tasks::{Class, ClassCounts, Status};

fn parse(text: &str) -> Result<Expectations, String> {
    Expectations::parse(Path::new("expected.toml"), text)
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
        ("reason = \"rounding\"", "reason = \" \"", "expected.toml:2: the reason is empty"),
        ("sign_flip", "sign_flop", "expected.toml:2: no class is called `sign_flop`"),
        ("overreach", "in_band", "expected.toml:2: `in_band` is legal"),
        ("backend", "bakend", "expected.toml:4: unknown field `bakend`"),
        ("near-*", "near-[", "expected.toml:2: error parsing glob 'near-['"),
        ("reason =", "level = \"slow\"\nreason =", "expected.toml:2: no level is called `slow`"),
    ] {
        let error = parse(&TEXT.replacen(wrong, right, 1)).unwrap_err();
        assert!(error.starts_with(needle), "{error}");
        assert!(!error.contains('\n'), "{error}");
    }
}
