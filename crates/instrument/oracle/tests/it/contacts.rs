//! Contacts: pairs that meet by definition, honest backends, and faulty backends.

use std::collections::{BTreeMap, BTreeSet};

use predicament_contacts::task::{Complexes, Contacts};
use predicament_corpus::LoadedScene;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Query, Scene, Vertex};
use predicament_tasks::{Class, Outcome};
use rug::Rational;

use crate::common::{judged_by_name, load, suite, task};

fn complexes(loaded: &LoadedScene) -> &Complexes {
    loaded.content().unwrap_or_else(|| panic!("{} asks for no contacts", loaded.name))
}

fn run(name: &str, backend: &str) -> Outcome {
    judged_by_name(&load(name), backend)
}

/// A linear form: coefficients, and the constant last.
type Form = Vec<Rational>;

fn plus(a: &Form, by: &Rational, b: &Form) -> Form {
    a.iter().zip(b).map(|(a, b)| a + Rational::from(by * b)).collect()
}

/// True if some point is strictly inside both simplices: positive weights that add up to one on each side and give the
/// same point. Equations by Gaussian elimination, then inequalities by Fourier and Motzkin.
fn insides_meet(scene: &Scene, s: &[Vertex], t: &[Vertex]) -> bool {
    let (n, dimension) = (s.len() + t.len(), scene.dimension().count());
    let mut equations: Vec<Form> = vec![vec![Rational::new(); n + 1]; dimension + 2];
    for (at, &v) in s.iter().chain(t).enumerate() {
        let first = at < s.len();
        for (axis, &x) in scene.point(v).iter().enumerate() {
            let x = Rational::from_f64(x).unwrap();
            equations[axis][at] = if first { x } else { -x };
        }
        let sum = dimension + usize::from(!first);
        equations[sum][at] += 1;
        equations[sum][n] = Rational::from(-1);
    }
    // Every weight as a form in the weights that stay free.
    let mut weights: Vec<Form> =
        (0..n).map(|at| (0..=n).map(|other| Rational::from(u8::from(other == at))).collect()).collect();
    while let Some(equation) = equations.pop() {
        let Some(pivot) = (0..n).find(|&at| !equation[at].is_zero()) else {
            if !equation[n].is_zero() {
                return false;
            }
            continue;
        };
        let scale = Rational::from(-1) / &equation[pivot];
        for form in equations.iter_mut().chain(&mut weights) {
            let by = Rational::from(&form[pivot] * &scale);
            *form = plus(form, &by, &equation);
        }
    }
    for at in 0..n {
        let (mut kept, mut up, mut down) = (Vec::new(), Vec::new(), Vec::new());
        for form in weights {
            match form[at].cmp0() {
                std::cmp::Ordering::Equal => kept.push(form),
                std::cmp::Ordering::Greater => up.push(form),
                std::cmp::Ordering::Less => down.push(form),
            }
        }
        for up in &up {
            kept.extend(down.iter().map(|down| plus(down, &-Rational::from(&down[at] / &up[at]), up)));
        }
        weights = kept;
    }
    weights.iter().all(|form| form[n].cmp0().is_gt())
}

fn simplices(complex: &Complex) -> Vec<Simplex> {
    let counts =
        [complex.vertices().len(), complex.edges().len(), complex.triangles().len(), complex.tetrahedra().len()];
    let of_rank =
        |rank: u8| (0..counts[rank as usize]).map(move |at| Simplex { rank, index: u32::try_from(at).unwrap() });
    (0..4).flat_map(of_rank).collect()
}

fn is_face(part: &[Vertex], of: &[Vertex]) -> bool {
    part.iter().all(|v| of.contains(v))
}

/// The pairs that meet, by definition: common points of two interiors, the most degenerate pairs first, and no pair
/// above a found one.
fn by_carriers(scene: &Scene, [a, b]: [&Complex; 2]) -> BTreeSet<[Simplex; 2]> {
    let bounds = |simplex: &[Vertex]| -> Vec<[f64; 2]> {
        let along = |axis| simplex.iter().map(move |&v| scene.point(v)[axis]);
        let (low, high) = (f64::INFINITY, f64::NEG_INFINITY);
        (0..scene.dimension().count()).map(|i| [along(i).fold(low, f64::min), along(i).fold(high, f64::max)]).collect()
    };
    let boxed = |complex: &Complex| -> Vec<_> {
        simplices(complex).into_iter().map(|s| (s, bounds(complex.vertices_of(s)))).collect()
    };
    let (of_a, of_b) = (boxed(a), boxed(b));
    let mut pairs = Vec::new();
    for (s, box_s) in &of_a {
        for (t, box_t) in &of_b {
            let near = box_s.iter().zip(box_t).all(|([l, h], [low, high])| l <= high && low <= h);
            if near && usize::from(s.rank + t.rank) <= scene.dimension().count() {
                pairs.push([*s, *t]);
            }
        }
    }
    pairs.sort_by_key(|[s, t]| s.rank + t.rank);
    let mut found: Vec<[Simplex; 2]> = Vec::new();
    for [s, t] in pairs {
        let (of_s, of_t) = (a.vertices_of(s), b.vertices_of(t));
        let ended = found.iter().any(|&[p, q]| is_face(a.vertices_of(p), of_s) && is_face(b.vertices_of(q), of_t));
        if !ended && insides_meet(scene, of_s, of_t) {
            found.push([s, t]);
        }
    }
    found.into_iter().collect()
}

#[test]
fn what_meets_by_definition_is_registered() {
    let mut kinds = BTreeSet::new();
    let exact = predicament_bundle::backend("exact").unwrap();
    for loaded in suite("contacts") {
        let content = complexes(&loaded);
        let task = if loaded.task == "contacts2d" { Contacts::IN_PLANE } else { Contacts::IN_SPACE };
        let found = exact.answer(&task, &loaded.scene, content).unwrap();
        let found: BTreeSet<_> = found.registered.iter().map(|contact| [contact.a, contact.b]).collect();
        assert_eq!(found, by_carriers(&loaded.scene, content.both()), "{}", loaded.name);
        kinds.extend(found.iter().map(|[s, t]| (loaded.task, s.rank.max(t.rank), s.rank.min(t.rank))));
    }
    // At least one pair of every kind meets.
    assert_eq!(kinds.len(), 4 + 6, "{kinds:?}");
}

#[test]
fn honest_backends_have_no_findings() {
    for loaded in suite("contacts") {
        for backend in ["exact", "sos", "sos:edelsbrunner-mucke", "sos:per-mesh", "tolerance"] {
            let mut outcome = judged_by_name(&loaded, backend);
            // These contacts keep their promise and make curves cross an odd number of times.
            if backend == "tolerance" && (loaded.name == "kettner-zigzag" || loaded.name.starts_with("odd-")) {
                let of_class = outcome.counts.get(Class::Topology);
                outcome.findings.retain(|finding| finding.check != "crossing parity");
                assert_eq!(of_class > 0, loaded.name != "odd-everywhere-f32", "{}", loaded.name);
            }
            // These contacts make curves of intersection fork.
            if backend == "tolerance" && (loaded.name == "surfaces-near" || loaded.name.starts_with("broken-curve")) {
                let of_class = outcome.counts.get(Class::Topology);
                outcome.findings.retain(|finding| finding.check != "loose ends");
                assert_eq!(of_class > 0, loaded.name != "broken-curve-f32", "{}", loaded.name);
            }
            assert_eq!(outcome.findings, [], "{backend} on {}", loaded.name);
            assert_eq!(outcome.queries, loaded.count() as u64);
        }
    }
}

#[test]
fn ties_are_broken_and_bands_are_used() {
    for (name, backend, class) in [
        ("touching-squares", "sos", Class::TieBroken),
        ("polygons-degen", "sos:edelsbrunner-mucke", Class::TieBroken),
        ("surfaces-degen", "sos", Class::TieBroken),
        ("copy-shifted-0.5", "tolerance", Class::InBand),
        ("surfaces-shifted-0.5", "tolerance", Class::InBand),
        ("polygons-uniform", "tolerance", Class::Agree),
        ("polygons-degen", "tolerance", Class::Agree),
        ("surfaces-degen", "exact", Class::Agree),
    ] {
        assert!(run(name, backend).counts.get(class) > 0, "{class} of {backend} on {name}");
    }
}

#[test]
fn faults_are_caught_for_what_they_are() {
    let mut outcomes = BTreeMap::new();
    for (fault, name, class, check) in [
        ("fault:contacts-endless-edge", "polygons-degen", Class::Overreach, "contact"),
        ("fault:contacts-one-sided", "polygons-uniform", Class::SignFlip, "contact"),
        ("fault:contacts-one-sided", "polygons-uniform", Class::Topology, "crossing parity"),
        ("fault:contacts-one-sided", "surfaces-near", Class::Topology, "loose ends"),
        ("fault:sos-dropped-parity", "polygons-degen", Class::Inconsistent, "argument order"),
        ("fault:sos-place-as-identity", "polygons-degen", Class::SignFlip, "perturbed contact"),
        ("fault:sos-first-order-only", "polygons-degen", Class::Inconsistent, "never degenerate"),
        ("fault:sos-swapped-term", "surfaces-degen", Class::Topology, "loose ends"),
        ("fault:tolerance-as-printed", "polygons-near", Class::Topology, "crossing parity"),
        ("fault:tolerance-as-printed", "polygons-near", Class::MissedZero, "band"),
        ("fault:tolerance-as-printed", "polygons-near", Class::Overreach, "band"),
        ("fault:tolerance-narrow-contacts", "polygons-near", Class::MissedZero, "band"),
        ("fault:tolerance-wide-contacts", "polygons-near", Class::Overreach, "band"),
        ("fault:tolerance-mirrored-weight", "polygons-near", Class::Inconsistent, "weights"),
        ("epsilon:1e-10", "copy-shifted-2", Class::Overreach, "ended early"),
        ("epsilon:1e-10", "polygons-near", Class::SignFlip, "contact"),
        ("naive", "kettner-zigzag", Class::Topology, "crossing parity"),
    ] {
        let outcome = outcomes.entry((name, fault)).or_insert_with(|| run(name, fault));
        let caught = outcome.findings.iter().any(|finding| finding.class == class && finding.check == check);
        let all: BTreeSet<_> = outcome.findings.iter().map(|finding| (finding.class, &finding.check)).collect();
        assert!(caught, "{fault} on {name}: {class} ({check}) is not among {all:?}");
    }
}

#[test]
fn a_pair_alone_is_what_it_is_among_all_others() {
    for (name, backend, task_of) in [
        ("polygons-near", "tolerance", Contacts::IN_PLANE),
        ("surfaces-degen", "exact", Contacts::IN_SPACE),
        ("touching-squares", "sos", Contacts::IN_PLANE),
    ] {
        let (loaded, contestant) = (load(name), predicament_bundle::backend(backend).unwrap());
        let content = complexes(&loaded);
        let all = contestant.answer(&task_of, &loaded.scene, content).unwrap();
        assert!(!all.registered.is_empty());
        for contact in &all.registered {
            let args = [content.a.vertices_of(contact.a), content.b.vertices_of(contact.b)];
            let query =
                Query { what: loaded.task.to_owned(), detail: None, args: args.map(<[Vertex]>::to_vec).to_vec() };
            let told = task(&loaded).explain_query(&loaded, &query, &[contestant.as_ref()]).unwrap();
            let told = &told.rows[0].1[0];
            assert!(told.starts_with("registered at ") && !told.contains(", "), "{backend} on {name}: {told}");
        }
    }
}
