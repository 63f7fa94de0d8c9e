//! Tests of backends by name.

use predicament_oracle::roster::{DEFAULT, HELP, MORE, backend};
use predicament_predicates::{Axis, Construction, Dimension, Plane, Question, Scene, Sign, Vertex};

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

/// A control without a device answers batches about constructed vertices as single queries of the whole.
#[test]
fn batches_about_constructed_vertices_do_not_depend_on_a_device() {
    let scene = Scene::new(Dimension::Two, vec![0.0, 0.0, 4.0, 4.0, 0.0, 4.0, 4.0, 0.0, 2.0, 2.0]).unwrap();
    let [a, b, c, d, centre] = [0, 1, 2, 3, 4].map(Vertex::input);
    let answers = |name: &str, by_batch: bool| {
        let mut answers = Vec::new();
        let mut ask = |session: &mut dyn predicament_predicates::Predicates| {
            let crossing = session.construct(&[Construction::Ssi([[a, b], [c, d]])]).unwrap()[0];
            let (pairs, turns) = ([[a, crossing], [crossing, centre], [b, d]], [[a, crossing, centre], [a, c, d]]);
            let mut out = [Sign::Zero; 5];
            let (first, last) = out.split_at_mut(3);
            if by_batch {
                session.compare_batch(Axis::X, &pairs, first);
                session.orient2d_batch(Plane::Xy, &turns, last);
            } else {
                first.copy_from_slice(&pairs.map(|[a, b]| session.compare(Axis::X, a, b)));
                last.copy_from_slice(&turns.map(|[a, b, c]| session.orient2d(Plane::Xy, a, b, c)));
            }
            answers = out.to_vec();
        };
        backend(name, &()).unwrap().with_session(&scene, &mut ask).unwrap();
        answers
    };
    let controls = [
        ("sos", ["leading", "nothing"].as_slice()),
        ("exact", &["plan", "static", "semi-static", "doubles", "integers", "batch", "near-search", "empty-cells"]),
    ];
    for (base, devices) in controls {
        let whole = answers(base, false);
        assert_eq!(whole.contains(&Sign::Zero), base == "exact", "{whole:?}");
        for device in devices {
            let name = format!("{base}:without={device}");
            assert_eq!([answers(&name, true), answers(&name, false)], [whole.clone(), whole.clone()], "{name}");
        }
    }
}
