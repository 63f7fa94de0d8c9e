//! The truth about points in meshes, by two computations of the judge that share no sign.

use predicament_corpus::{Level, Library};
use predicament_formats::Cache;
use predicament_judge::solids::{Materials, Place};
use predicament_mesh_locate::task::ProbedMesh;

#[test]
fn winding_numbers_are_the_same_in_another_direction() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let suite = library.suites().unwrap().iter().find(|suite| suite.name == "mesh-points").unwrap();
    for definition in &suite.scenes {
        let loaded = definition.load(Level::Quick, &Cache::new("/nonexistent/predicament-cache")).unwrap();
        let content: &ProbedMesh = loaded.content().unwrap();
        let judge = Materials::new(&loaded.scene, content.mesh.triangles(), content.mesh.sides());
        let (mut same, step) = (0, content.probes.len() / 30 + 1);
        for probe in content.probes.iter().step_by(step) {
            let along_x = judge.locate(probe.vertex);
            // Not a multiple of the edges' directions, so that few rays touch an edge.
            let Some(along) = judge.winding(probe.vertex, [10_007, -3_001, 7_919]) else { continue };
            // A point can be on a triangle that is parallel to the other ray.
            let is_same = match (&along_x, &along) {
                (Place::On(one), Place::On(other)) => other.iter().all(|triangle| one.contains(triangle)),
                (one, other) => one == other,
            };
            assert!(is_same, "{}: {} is {along_x:?} and {along:?}", loaded.name, probe.vertex);
            same += 1;
        }
        // A triangle without area is parallel to every ray, which is then never in general position.
        let least = if loaded.name == "a-triangle-without-area" { 0 } else { 4 };
        assert!(same >= least, "{}: {same} probes with a ray in general position", loaded.name);
    }
}
