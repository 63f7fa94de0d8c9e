//! The measurements of the study of cascades, against independent computations.

use std::str::FromStr;

use predicament_judge::rational;
use predicament_overlay::algorithm::overlay::Operation;
use predicament_overlay::checks::overlay::Operands;
use predicament_studies::cascades::{Cascade, Cascades, Contradiction, Keep, Measured, Method};
use predicament_studies::{Common, Study};
use predicament_tasks::Contestant;
use rug::Rational;

use crate::{backend, quiet};

pub(crate) type Exact = [Rational; 2];

pub(crate) fn cascades(cascade: Cascade, methods: &[&str], steps: u32) -> Cascades {
    Cascades {
        cascades: vec![cascade],
        methods: methods.iter().map(|name| name.parse().unwrap()).collect(),
        steps,
        samples: steps,
        probes: 16,
        common: Common { seed: 1, ..Common::default() },
    }
}

pub(crate) fn measured(study: &Cascades) -> Measured {
    let backends: Vec<_> = study.backends().iter().map(|name| backend(name)).collect();
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    study.survey(&backends, &quiet()).unwrap()
}

pub(crate) fn exactly(corners: &[[f64; 2]]) -> Vec<Exact> {
    corners.iter().map(|corner| corner.map(rational)).collect()
}

/// A convex polygon without the part to the left of a line.
fn cut(polygon: &[Exact], [a, b]: [&Exact; 2]) -> Vec<Exact> {
    let side = |p: &Exact| {
        let minus = |p: &Exact, i: usize| Rational::from(&p[i] - &a[i]);
        minus(b, 0) * minus(p, 1) - minus(b, 1) * minus(p, 0)
    };
    let mut kept = Vec::new();
    for (p, q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let [from, to] = [side(p), side(q)];
        if from <= 0 {
            kept.push(p.clone());
        }
        if from.cmp0() as i8 * to.cmp0() as i8 == -1 {
            let part = &from / Rational::from(&from - &to);
            kept.push([0, 1].map(|i: usize| Rational::from(&q[i] - &p[i]) * &part + &p[i]));
        }
    }
    kept
}

fn twice_the_area(polygon: &[Exact]) -> Rational {
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    edges.fold(Rational::new(), |sum, (p, q)| sum + Rational::from(&p[0] * &q[1]) - Rational::from(&p[1] * &q[0]))
}

#[test]
fn areas_of_unions_are_those_of_all_operands_strip_by_strip() {
    for (cascade, steps) in [(Cascade::Rotate, 11), (Cascade::Stars, 4), (Cascade::Generalise, 3)] {
        let measured = measured(&cascades(cascade, &["exact"], steps));
        let (start, operands) = cascade.steps(steps as usize, 1);
        let mut loops = vec![exactly(&start)];
        for (operand, sample) in operands.iter().zip(&measured.exact[0].samples) {
            assert_eq!(operand.operation, Operation::Union);
            loops.push(exactly(&operand.corners));
            let all = Operands { loops: [loops.clone(), Vec::new()], rules: [|winding| winding != 0; 2] };
            assert_eq!(Some(&sample.area), all.area(0).as_ref(), "{cascade:?} after step {}", sample.step);
            assert_eq!(sample.lost, 0);
        }
        assert_eq!(measured.exact[0].samples.len(), steps as usize);
    }
}

#[test]
fn areas_of_what_is_shaved_are_those_of_a_convex_polygon_cut_by_lines() {
    let measured = measured(&cascades(Cascade::Shave, &["exact"], 24));
    let (start, operands) = Cascade::Shave.steps(24, 1);
    let mut polygon = exactly(&start);
    for (operand, sample) in operands.iter().zip(&measured.exact[0].samples) {
        assert_eq!(operand.operation, Operation::Difference);
        let corners = exactly(&operand.corners);
        // Counterclockwise boxes, whose side between the last and the first corner is the cut.
        polygon = cut(&polygon, [&corners[3], &corners[0]]);
        assert_eq!(sample.area, twice_the_area(&polygon), "after step {}", sample.step);
        assert_eq!((sample.edges, sample.lost), (polygon.len(), 0));
    }
}

#[test]
fn exact_methods_hold_and_rounded_ones_are_found_out() {
    let methods = [
        "exact",
        "sos",
        "exact+snap",
        "exact+snap:20",
        "exact+round",
        "naive",
        "naive+round",
        "thick",
        "tolerance+contacts",
    ];
    let study = cascades(Cascade::Rotate, &methods, 20);
    let measured = measured(&study);
    assert!(study.holds(&measured));
    let of = |name: &str| measured.followed.iter().find(|one| one.method.to_string() == name).unwrap();
    let [exact, sos] = ["exact", "sos"].map(|name| of(name).samples.last().unwrap());
    assert_eq!((&exact.area, exact.lost, exact.defects.crossings), (&sos.area, 0, 0));
    assert!(exact.bits > 106 && of("exact+snap").samples.iter().all(|sample| sample.bits <= 42), "doubles on a grid");
    assert!(of("exact+round").samples.iter().all(|sample| sample.bits <= 53));
    // A square turned by a tiny angle: rounded signs lose the whole polygon.
    let naive = of("naive+round");
    assert!(naive.broken.is_some() && naive.samples.iter().any(|sample| sample.lost > 0));
    let error = |name: &str| {
        let last = of(name).samples.last().unwrap();
        (last.step, measured.area_error(Cascade::Rotate, last).unwrap())
    };
    for (name, most) in
        [("exact", 0.0), ("exact+snap", 1e-11), ("exact+snap:20", 1e-5), ("exact+round", 1e-15), ("thick:1e-9", 1e-8)]
    {
        let (step, error) = error(name);
        assert!(step == 20 && error <= most, "{name}: {error:e} after {step}");
    }
    assert!(error("exact+snap:20") > error("exact+snap"), "coarser pixels cost more area");
}

#[test]
fn what_thickness_swallows_is_seen() {
    let measured = measured(&cascades(Cascade::Stars, &["thick:0.0001", "thick:0.001"], 40));
    let [thin, thick] = [0, 1].map(|at| &measured.followed[at]);
    let grown = thin.samples.last().unwrap();
    // If edges or vertices became thin again after each step, it would be 0.0003 or 0.0006.
    assert!(grown.step == 40 && grown.thickness > 8e-4, "radii grow from step to step: {}", grown.thickness);
    let errors: Vec<f64> =
        thin.samples.iter().map(|sample| measured.area_error(Cascade::Stars, sample).unwrap()).collect();
    assert!(errors.iter().all(|error| *error < 1e-4) && errors[39] > errors[0], "{errors:?}");
    assert!(thick.samples.iter().any(|sample| sample.lost > 0), "features are no larger than the radius");
    assert!(thick.ended.as_ref().is_some_and(|(step, why)| *step < 40 && why.contains("result is empty")));
    // The step with an empty result is measured, and the next one fails.
    let gone = thick.samples.last().unwrap();
    assert_eq!((gone.regions, thick.ended.as_ref().map(|(step, _)| *step)), (0, Some(gone.step + 1)));
}

#[test]
fn measurements_are_the_same_whenever_they_are_made() {
    let study = cascades(Cascade::Stars, &["exact", "exact+snap", "naive+round", "thick", "tolerance+contacts"], 9);
    let [one, other] = [(); 2].map(|()| study.rows(&measured(&study)).unwrap());
    assert_eq!(one[0], other[0]);
    assert_eq!(one[0].name, "cascades.csv");
}

#[test]
fn a_broken_promise_is_told() {
    let study = cascades(Cascade::Stars, &["exact", "exact+snap"], 3);
    let found = measured(&study);
    assert!(study.holds(&found));
    for plant in [
        |found: &mut Measured| found.followed[0].samples[1].lost = 1,
        |found: &mut Measured| found.followed[0].samples[1].defects.crossings = 1,
        |found: &mut Measured| found.followed[0].broken = Some((1, Contradiction::Unsettled)),
        |found: &mut Measured| found.followed[1].samples[2].defects.inverted = 1,
        |found: &mut Measured| found.followed[1].ended = Some((3, "no".to_owned())),
        |found: &mut Measured| found.exact[0].samples[0].lost = 1,
    ] {
        let mut planted = found.clone();
        plant(&mut planted);
        assert!(!study.holds(&planted));
    }
}

#[test]
fn methods_are_read_as_they_are_written() {
    for name in [
        "exact",
        "epsilon:1e-9",
        "naive:first+round",
        "exact+snap",
        "exact+snap:20",
        "tolerance:f32+contacts",
        "thick:1e-6",
    ] {
        assert_eq!(Method::from_str(name).unwrap().to_string(), name);
    }
    assert_eq!(Method::from_str("thick").unwrap().keep, Keep::Thick(1e-9));
    for (name, why) in [
        ("exact+snapped", "`+snapped` is unknown; use +round"),
        ("exact+snap:0", "from 1 to 50"),
        ("exact+snap:51", "from 1 to 50"),
        ("thick:-1", "between 0 and 0.5"),
        ("thick:nan", "between 0 and 0.5"),
        ("", "a method needs a name"),
    ] {
        let error = Method::from_str(name).unwrap_err();
        assert!(error.to_string().contains(why), "{name}: {error}");
    }
}

#[test]
fn two_names_of_one_backend_are_refused() {
    let study = cascades(Cascade::Stars, &["exact"], 1);
    let exact = backend("exact");
    let refused = study.survey(&[exact.as_ref()], &quiet());
    assert!(refused.unwrap_err().to_string().contains("two of exact, naive are the same backend"));
}
