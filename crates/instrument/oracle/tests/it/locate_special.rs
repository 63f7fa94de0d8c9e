//! The suites' synthetic maps, which are full of ties: the paper's own test, the generic code with both exact signs and
//! a perturbation, and the judge of tilings.

use predicament_exact::{Exact, raw};
use predicament_polygon_locate::algorithm::{LocateIndex, locate_all, locate_all_specially};
use predicament_polygon_locate::checks::tiling_report;
use predicament_polygon_locate::task::MapWithProbes;
use predicament_polygon_locate::truth::{Edges, surroundings};
use predicament_predicates::{Backend, Off, ZeroMeaning};
use predicament_sos::Sos;

use crate::common::suite;

#[test]
fn the_papers_test_answers_as_a_perturbed_session_does() {
    let sos = Sos::default();
    let [mut on_boundary, mut silent] = [0, 0];
    for loaded in suite("tilings") {
        let content: &MapWithProbes = loaded.content().unwrap_or_else(|| panic!("{} is no map", loaded.name));
        let (map, probes) = (&content.map, content.vertices());
        let first_of_map = map.edges().flat_map(|(_, ends)| ends).min().unwrap();
        let index = LocateIndex::new(map, &loaded.scene);
        let exact = Exact.prepare(&loaded.scene, Off).unwrap();
        let perturbed = sos.prepare(&loaded.scene, Off).unwrap();

        let special =
            locate_all_specially(&index, &loaded.scene, &|l, r, p| raw::orient2d([l, r, p]), &probes, &|_| true);
        let truth = locate_all(&index, &exact, &probes, &|_| true);
        let answers = locate_all(&index, &perturbed, &probes, &|_| true);
        let report = tiling_report(
            &surroundings(&Edges::new(map, &loaded.scene), &exact, &probes),
            &answers,
            ZeroMeaning::Never,
        );
        assert_eq!(report.violations(), [], "{}", loaded.name);

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
    }
    assert!(on_boundary > 1000 && silent > 200, "{on_boundary} on boundaries, {silent} of them not reported");
}
