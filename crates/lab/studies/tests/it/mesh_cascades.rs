//! Cascades of meshes: promises hold, and rows are reproducible.

use predicament_effort::some_or_all;
use predicament_exact::Exact;
use predicament_sos::PerMesh;
use predicament_studies::mesh_cascades::{Cascade, MeshCascades, Rounding};

use predicament_studies::{Common, Study};

use predicament_tasks::Contestant;

use crate::quiet;

fn study(cascades: &[Cascade], steps: u32) -> MeshCascades {
    MeshCascades {
        cascades: cascades.to_vec(),
        backends: vec!["sos:per-mesh".to_owned()],
        steps,
        samples: 5,
        probes: 16,
        rounding: Rounding::Resolved,
        common: Common { seed: 1, ..Common::default() },
    }
}

#[test]
fn lattices_are_what_is_counted_and_spheres_have_their_points() {
    let backends: [Box<dyn Contestant>; 2] =
        [Box::new(predicament_bundle::entry(PerMesh)), Box::new(predicament_bundle::entry(Exact))];
    let backends = backends.each_ref().map(|backend| &**backend);
    let study = study(&[Cascade::Cubes, Cascade::Shuffled], 15);
    let measured = study.survey(&backends, &quiet()).unwrap();
    assert!(study.holds(&measured), "{}", study.page(&measured));
    for one in &measured.followed {
        assert_eq!((one.samples.len(), one.samples[4].triangles, &one.ended), (5, 0, &None));
        assert!(one.samples.iter().all(|sample| sample.truth.is_some()));
    }
    // A sample with a wrong value breaks the promise.
    let mut doctored = measured.clone();
    doctored.followed[0].samples[2].open = 1;
    assert!(!study.holds(&doctored));
    let mut doctored = measured;
    doctored.followed[1].ended = Some((3, "for no reason".to_owned()));
    assert!(!study.holds(&doctored));
}

#[test]
fn a_sphere_is_shaved_twice_in_the_same_way() {
    let backends: [Box<dyn Contestant>; 2] =
        [Box::new(predicament_bundle::entry(PerMesh)), Box::new(predicament_bundle::entry(Exact))];
    let backends = backends.each_ref().map(|backend| &**backend);
    let study = study(&[Cascade::Shave], some_or_all(3, 5));
    let [first, second] = [(); 2].map(|()| study.survey(&backends, &quiet()).unwrap());
    assert!(study.holds(&first), "{}", study.page(&first));
    assert!(first.followed[0].done.moved > 0);
    let rows = |measured| study.rows(measured).unwrap()[0].text().to_owned();
    assert_eq!(rows(&first), rows(&second));
}

#[test]
fn what_rounding_leaves_is_resolved() {
    let backends: [Box<dyn Contestant>; 2] =
        [Box::new(predicament_bundle::entry(PerMesh)), Box::new(predicament_bundle::entry(Exact))];
    let backends = backends.each_ref().map(|backend| &**backend);
    let resolved = MeshCascades { samples: 1, probes: 4, ..study(&[Cascade::Copies], 5) };
    let measured = resolved.survey(&backends, &quiet()).unwrap();
    assert!(resolved.holds(&measured), "{}", resolved.page(&measured));
    let done = measured.followed[0].done;
    assert!(done.left == 0 && done.resolved > 0 && done.cut > 0, "{done:?}");
    assert!(measured.followed[0].samples.iter().all(|sample| sample.is_clean()));
    let counted = MeshCascades { rounding: Rounding::Counted, ..resolved };
    let measured = counted.survey(&backends, &quiet()).unwrap();
    assert!(measured.followed[0].done.left > 0);
}
