//! Location is judged with a query for every edge, and compared with the shortcut that users run.

use std::sync::Arc;

use predicament_corpus::LoadedScene;
use predicament_formats::ImportNotes;
use predicament_mesh::PolygonMap;
use predicament_polygon_locate::task::{MapWithProbes, Probe, ProbeKind};
use predicament_predicates::{
    Backend, Contract, Declined, Off, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
    forward_to,
};
use predicament_sos::{Scheme, Sos};
use predicament_tasks::{Class, Outcome};

use crate::common;

/// SoS with one wrong turn for every probe: the turn of the square's top edge, which lies above all probes.
struct WrongAboutTheTop {
    proved: bool,
}

struct Session<'s>(predicament_sos::Session<'s, Off>);

/// The probes come first: the middles of the left and of the right side, and the middle of the square; then its
/// corners.
const POINTS: [[f64; 2]; 7] = [[0., 1.], [2., 1.], [1., 1.], [0., 0.], [2., 0.], [2., 2.], [0., 2.]];
const TOP: [usize; 2] = [5, 6];

impl Backend for WrongAboutTheTop {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        "wrong about the top".to_owned()
    }
    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Never, proved: self.proved }
    }
    fn stages(&self) -> &'static [&'static str] {
        &[]
    }
    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        const SOS: Sos = Sos { scheme: Scheme::PerCoordinate };
        Ok(Session(SOS.prepare(scene, Off)?))
    }
}

impl Predicates for Session<'_> {
    forward_to!(0: scene, compare, orient3d, incircle, insphere);

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let sign = self.0.orient2d(plane, a, b, c);
        let is_top = TOP.iter().all(|&v| [a, b, c].contains(&Vertex::input(v)));
        if is_top { -sign } else { sign }
    }
}

fn judged(backend: impl Backend + 'static, probes: usize) -> Outcome {
    let mut map = PolygonMap::new();
    map.push("square", vec![(3..7).map(Vertex::input).collect()]).unwrap();
    let probe = |at| Probe { vertex: Vertex::input(at), kind: ProbeKind::Random };
    let loaded = LoadedScene {
        suite: "mine".to_owned(),
        name: "square".to_owned(),
        id: String::new(),
        task: "polygon-locate",
        family: "square".to_owned(),
        tags: Vec::new(),
        source: String::new(),
        analysis: String::new(),
        is_invalid: false,
        scene: Scene::from_points2(&POINTS).unwrap(),
        content: Arc::new(MapWithProbes::new(map, (0..probes).map(probe).collect())),
        notes: ImportNotes::default(),
        remarks: Vec::new(),
        written: None,
        similar: None,
    };
    common::judged(&loaded, &predicament_bundle::entry(backend))
}

#[test]
fn a_wrong_sign_that_raw_coordinates_would_hide_is_found() {
    assert!(judged(Sos::default(), 3).findings.is_empty());
    let outcome = judged(WrongAboutTheTop { proved: false }, 3);
    let checks: Vec<&str> = outcome.findings.iter().map(|finding| finding.check.as_str()).collect();
    assert_eq!((outcome.counts.get(Class::Topology), checks), (1, vec!["gap"]));
}

#[test]
fn proved_signs_have_to_give_the_same_by_the_shortcut() {
    // On the coast "outside" is as legal as "inside": only the shortcut, which does not query the top edge, shows the
    // fault. One side is perturbed into the square.
    let outcome = judged(WrongAboutTheTop { proved: true }, 2);
    let checks: Vec<&str> = outcome.findings.iter().map(|finding| finding.check.as_str()).collect();
    assert_eq!((outcome.counts.get(Class::Topology), checks), (1, vec!["shortcut"]));
    assert!(judged(WrongAboutTheTop { proved: false }, 2).findings.is_empty(), "no promise, no check");
}
