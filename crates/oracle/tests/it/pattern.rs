//! A name is what globset takes it for.

use globset::Glob;
use predicament_oracle::pattern::Pattern;
use proptest::prelude::*;

proptest! {
    #[test]
    fn a_name_is_what_globset_takes_it_for(text in "[ab/*?\\-]{0,5}", suite in "[ab]{1,2}", scene in "[ab/\\-]{0,4}") {
        let pattern = Pattern::new(&text).expect("a glob");
        let glob = Glob::new(&text).expect("a glob").compile_matcher();
        let truth = glob.is_match(&scene) || glob.is_match(format!("{suite}/{scene}"));
        prop_assert_eq!(pattern.names(&suite, &scene), truth);
    }

    #[test]
    fn a_name_is_itself_and_nothing_else(text in "\\PC{1,6}", other in "\\PC{1,6}") {
        if let Ok(pattern) = Pattern::new(&text) && let Some(name) = pattern.name() {
            let glob = Glob::new(name).expect("a glob").compile_matcher();
            prop_assert!(glob.is_match(&text) && pattern.names("s", &text));
            prop_assert_eq!(glob.is_match(&other), text == other);
        }
    }
}

#[test]
fn what_is_no_glob_is_refused() {
    assert!(Pattern::new("a[").is_err_and(|why| why.contains("a[")));
    assert!(Pattern::new("{a,b}").is_ok_and(|pattern| pattern.name().is_none() && pattern.names("s", "b")));
}
