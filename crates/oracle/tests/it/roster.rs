//! Backends by name.

use predicament_oracle::roster::{DEFAULT, backend};

#[test]
fn every_backend_has_the_name_it_is_picked_by() {
    for name in DEFAULT.iter().copied().chain(["sos:per-mesh", "tolerance:f32", "fault:tolerance-as-printed"]) {
        assert_eq!(backend(name).unwrap().name(), name);
    }
}

#[test]
fn mistakes_are_answered_with_what_there_is() {
    let error = |name| backend(name).err().unwrap();
    assert!(error("exat").contains("sos:edelsbrunner-mucke"));
    assert!(error("epsilon:tiny").contains("`tiny` is no number"));
    assert!(error("epsilon:-1").contains("epsilon:-1"));
    assert!(error("epsilon:nan").contains("epsilon:nan"));
    assert!(error("fault:none").contains("selftest --list"));
}
