//! Tests of backends by name.

use predicament_oracle::roster::{DEFAULT, HELP, MORE, backend};
use predicament_predicates::{Construction, Dimension, Plane, Question, Scene, Sign, Vertex};

#[test]
fn every_backend_has_the_name_it_is_picked_by() {
    for name in DEFAULT.iter().copied().chain(MORE.iter().copied()).chain([
        "exact:stages=3",
        "exact:without=semi-static",
        "fault:tolerance-as-printed",
    ]) {
        assert_eq!(backend(name, &()).unwrap().name(), name);
    }
}

#[test]
fn mistakes_are_answered_with_what_there_is() {
    let error = |name: &str| backend(name, &()).err().unwrap().to_string();
    assert!(error("exat").contains("sos:edelsbrunner-mucke"));
    assert!(error("epsilon:tiny").contains("`tiny` is not a number"));
    assert!(error("epsilon:-1").contains("epsilon:-1"));
    assert!(error("epsilon:nan").contains("epsilon:nan"));
    for stages in ["0", "7", "x"] {
        let name = format!("exact:stages={stages}");
        assert!(error(&name).contains("from 1 to 6"), "{}", error(&name));
    }
    assert!(error("exact:without=statics").contains("did you mean `static`?"));
    assert!(error("fault:none").contains("selftest --list"));
}

/// Every parameterless backend in the help runs by default or is listed as not doing so.
#[test]
fn every_backend_of_the_help_runs_by_default_or_is_left_out_by_name() {
    let names = HELP
        .lines()
        .filter(|line| !line.starts_with(' '))
        .flat_map(|line| line.split("  ").next().unwrap().split(", "));
    let plain: Vec<&str> = names.filter(|name| !name.contains(char::is_uppercase)).collect();
    assert!(plain.len() > 8, "{plain:?}");
    for name in &plain {
        let name = backend(name, &()).unwrap().name();
        assert!(DEFAULT.contains(&&*name) != MORE.contains(&&*name), "{name}");
    }
    assert!(MORE.iter().all(|name| plain.contains(name)));
}

/// `sos:per-mesh` is one of the backends behind a pointer: it counts, refuses and constructs as without the pointer.
#[test]
fn a_backend_behind_a_pointer_is_the_backend() {
    let per_mesh = backend("sos:per-mesh", &()).unwrap();
    let scene = Scene::new(Dimension::Two, vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0]).unwrap();
    let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
    assert!(per_mesh.ask(&scene, Question::Orient2d(Plane::Xy), &[a, b, c]).is_err(), "one mesh");
    let scene = scene.with_second_mesh([c, d]);
    let (sign, stage) = per_mesh.ask(&scene, Question::Orient2d(Plane::Xy), &[a, b, c]).unwrap();
    assert_eq!((sign, stage), (Sign::Positive, Some("semi-static filter")));
    let mut constructed = None;
    let crossing = Construction::Ssi([[a, d], [b, c]]);
    per_mesh.with_session(&scene, &mut |session| constructed = Some(session.construct(&[crossing]).unwrap())).unwrap();
    assert!(constructed.unwrap()[0].is_constructed());
}
