//! Patterns that are names match as globset would.

use std::collections::BTreeSet;

use globset::Glob;
use predicament_oracle::known::Scenes;
use predicament_oracle::pattern::{Pattern, escape};
use proptest::prelude::*;

proptest! {
    #[test]
    fn a_name_is_what_globset_takes_it_for(text in "[ab/*?\\-]{0,5}", suite in "[ab]{1,2}", scene in "[ab/\\-]{0,4}") {
        let pattern = Pattern::new(&text).expect("a glob");
        let glob = Glob::new(&text).expect("a glob").compile_matcher();
        let truth = glob.is_match(&scene) || glob.is_match(format!("{suite}/{scene}"));
        prop_assert_eq!(pattern.names(&suite, &scene), truth);
    }

    /// A search by pattern skips names with another prefix, and finds the same scenes as a search over all names.
    #[test]
    fn a_pattern_of_one_of_several_scenes_is_found(
        text in "[ab]{0,2}([/*?,]|\\{a,b\\}|\\[ab\\]|\\\\a){0,2}[ab]{0,2}",
        scenes in prop::collection::vec("[ab]{1,3}", 0..6),
    ) {
        let pattern = Pattern::new(&text).expect("a glob");
        let glob = Glob::new(&text).expect("a glob").compile_matcher();
        let truth = scenes.iter().any(|scene| glob.is_match(scene) || glob.is_match(format!("a/{scene}")));
        let scenes = scenes.into_iter().map(|scene| ("a".to_owned(), scene)).collect();
        prop_assert_eq!(Scenes::new(scenes, BTreeSet::new()).has_any(&pattern), truth);
    }

    #[test]
    fn an_escaped_name_is_itself_and_nothing_else(
        name in "[ab*?!,{}\\\\\\[\\]^-]{1,4}|\\PC{1,6}",
        other in "[ab*\\\\\\[\\]]{1,3}",
    ) {
        let pattern = Pattern::new(&escape(&name)).expect("a glob");
        prop_assert!(pattern.names("s", &name));
        prop_assert_eq!(pattern.names("s", &other), name == other);
        let pattern = Pattern::new(&escape(&format!("s/{name}"))).expect("a glob");
        prop_assert!(pattern.names("s", &name) && !pattern.names("t", &name));
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
    assert!(Pattern::new("a[").is_err_and(|why| why.to_string().contains("a[")));
    assert!(Pattern::new("{a,b}").is_ok_and(|pattern| pattern.name().is_none() && pattern.names("s", "b")));
}

#[test]
fn a_pattern_may_be_about_a_scene_that_is_not_known() {
    let scene = |suite: &str, name: &str| (suite.to_owned(), name.to_owned());
    let all = vec![scene("whole", "a"), scene("open", "b")];
    let scenes = Scenes::new(all, std::iter::once("open".to_owned()).collect());
    let elsewhere = |text: &str| scenes.may_be_elsewhere(&Pattern::new(text).unwrap());
    for text in ["open/c", "open/*", "o*/b", "*/b", "{open/b,x}", "[a-z]*/b", "lost/a", "c", "a", "a*"] {
        assert!(elsewhere(text), "{text}");
    }
    for text in ["whole/a", "whole/c", "whole/*", "w*/a", "open/b", "b"] {
        assert!(!elsewhere(text), "{text}");
    }
    let closed = Scenes::new(vec![scene("whole", "a")], BTreeSet::new());
    let elsewhere = |text: &str| closed.may_be_elsewhere(&Pattern::new(text).unwrap());
    assert!(elsewhere("lost/*") && !elsewhere("c") && !elsewhere("*") && !elsewhere("*/c"));
}
