//! Solids that touch: volumes and contacts are the counted ones, and rows are reproducible.

use predicament_exact::Exact;
use predicament_sos::PerMesh;
use predicament_studies::touching::{Made, Touching};
use predicament_studies::{Common, Study};
use predicament_tasks::Contestant;

use crate::quiet;

fn study() -> Touching {
    Touching {
        pairs: Vec::new(),
        backends: vec!["exact".to_owned(), "sos:per-mesh".to_owned()],
        side: 2,
        levels: 2,
        rounds: 1,
        common: Common::default(),
    }
}

#[test]
fn each_way_returns_the_counted_union() {
    let backends: [Box<dyn Contestant>; 2] =
        [Box::new(predicament_bundle::entry(Exact)), Box::new(predicament_bundle::entry(PerMesh))];
    let backends = backends.each_ref().map(|backend| &**backend);
    let study = study();
    let measured = study.survey(&backends, &quiet()).unwrap();
    assert!(study.holds(&measured), "{}", study.page(&measured));
    let again = study.survey(&backends, &quiet()).unwrap();
    let rows = |measured| study.rows(measured).unwrap()[0].text().to_owned();
    assert_eq!(rows(&measured), rows(&again));
    // Any wrong value breaks the promise.
    let change = |at: usize, change: &dyn Fn(&mut Made)| {
        let mut doctored = measured.clone();
        change(doctored.rows[at].made.as_mut().unwrap());
        assert!(!study.holds(&doctored), "{} by {}", doctored.rows[at].pair.name(), doctored.rows[at].backend);
    };
    // The pairs in order, by exact and by sos:per-mesh.
    let [general, shifted, parts, edges, corners] = [0, 4, 8, 12, 14];
    for by in [general, general + 1, shifted, shifted + 1] {
        change(by, &|made| made.volume.as_mut().unwrap().intersection += 1);
    }
    change(shifted + 1, &|made| {
        let volume = made.volume.as_mut().unwrap();
        volume.union += 1;
        volume.intersection -= 1;
    });
    change(general + 1, &|made| made.volume = None);
    change(parts, &|made| made.touched.as_mut().unwrap().area += 0.01);
    change(edges, &|made| made.touched.as_mut().unwrap().length += 1.0);
    change(corners, &|made| made.touched.as_mut().unwrap().points -= 1);
    change(corners, &|made| made.touched = None);
    change(parts, &|made| made.triangles += 1);
    change(parts, &|made| made.limit = Some(Err("for no reason".to_owned())));
    let mut doctored = measured.clone();
    doctored.rows[1].made = Err("for no reason".to_owned());
    assert!(!study.holds(&doctored));
}
