//! The synthetic maps of the suites, where ties are everywhere: the paper's own
//! test, the generic code under both exact signs and a perturbation, and the
//! judge of tilings.

use predicament_algorithms::polygon_locate::{LocateIndex, locate_all, locate_all_specially};
use predicament_checks::tiling::{surroundings, tiling_report};
use predicament_corpus::{Cache, Level, Library, Work};
use predicament_exact::{Exact, raw};
use predicament_predicates::{Backend, Off, Vertex, ZeroMeaning};
use predicament_sos::Sos;

#[test]
fn the_papers_test_answers_as_a_perturbed_session_does() {
    let suite = Library::embedded().unwrap().suite("tilings").unwrap();
    let cache = Cache::new("no data is needed");
    let sos = Sos::default();
    for scene in &suite.scenes {
        let loaded = scene.load(Level::Quick, &cache).unwrap();
        let Work::Locate { map, probes } = &loaded.work else { panic!("{} is no map", loaded.name) };
        let probes: Vec<Vertex> = probes.iter().map(|probe| probe.vertex).collect();
        let first_of_map = map.edges().flat_map(|(_, ends)| ends).min().unwrap();
        let index = LocateIndex::new(map, &loaded.scene);
        let exact = Exact.prepare(&loaded.scene, Off).unwrap();
        let perturbed = sos.prepare(&loaded.scene, Off).unwrap();

        let special =
            locate_all_specially(&index, &loaded.scene, &|l, r, p| raw::orient2d([l, r, p]), &probes, &|_| true);
        let truth = locate_all(&index, &exact, &probes, &|_| true);
        let answers = locate_all(&index, &perturbed, &probes, &|_| true);
        let report = tiling_report(&surroundings(&index, &exact, &probes), &answers, ZeroMeaning::Never);
        assert_eq!(report.violations(), [], "{}", loaded.name);

        let [mut on_boundary, mut silent] = [0, 0];
        for (at, &probe) in probes.iter().enumerate() {
            let off = |regions: &[u32], on: &[u32]| -> Vec<u32> {
                regions.iter().copied().filter(|region| !on.contains(region)).collect()
            };
            let (crossed, reported) = (special.inside(at), special.boundary(at));
            assert_eq!(off(crossed, truth.boundary(at)), truth.inside(at), "{} at {probe}", loaded.name);
            assert!(reported.iter().all(|region| truth.boundary(at).contains(region)), "{} at {probe}", loaded.name);
            if probe < first_of_map {
                assert_eq!(crossed, off(answers.inside(at), reported), "{} at {probe}", loaded.name);
            }
            on_boundary += usize::from(!truth.boundary(at).is_empty());
            silent += usize::from(reported.len() < truth.boundary(at).len());
        }
        assert!(
            on_boundary > 500 && silent > 100,
            "{}: {on_boundary} on boundaries, {silent} of them not reported",
            loaded.name
        );
    }
}
