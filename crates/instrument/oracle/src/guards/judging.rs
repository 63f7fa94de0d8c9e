//! Guards of the judging of answers, which compare it with handwritten tables.

use std::path::Path;

use predicament_controls::{Naive, Pivot};
use predicament_exact::Exact;
use predicament_predicates::{Axis, Backend, Band, Off, Plane, Predicates, Question, Scene, Sign, Vertex, ZeroMeaning};
use predicament_sos::{Scheme, infinitesimal};
use predicament_tasks::signs::classify;
use predicament_tasks::{Class, ClassCounts, Finding, Status, finding_id};

use super::{Facts, Guard, Guarded, Held};
use crate::expect::Expectations;
use crate::faults::Area;

/// The functions that judge answers: each is the real function, unless a fault replaces it.
pub(super) trait Judging {
    /// The class of an answer to a query with exactly this determinant.
    fn class(&self, zero: ZeroMeaning, band: Option<Band>, answer: Sign, determinant: f64) -> Class {
        classify(zero, band, answer, Sign::of(determinant), |limit| determinant.abs() <= limit)
    }

    /// The status of a row: suite, scene, backend, level.
    fn status(&self, expected: &str, [suite, scene, backend, level]: [&str; 4], found: &[Class]) -> Status {
        let expected = Expectations::parse(Path::new("expected.toml"), expected).unwrap_or_default();
        let mut counts = ClassCounts::default();
        found.iter().for_each(|&class| counts.add(class, 1));
        expected.status(suite, scene, backend, level, &counts)
    }

    /// The id of a finding.
    fn id(&self, scene: &str, backend: &str, finding: &Finding) -> String {
        finding_id(scene, backend, finding)
    }

    /// The exact sign of a query.
    fn truth(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
        predicament_judge::sign(scene, question, args)
    }

    /// The sign of a query in the perturbed scene.
    fn perturbed(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
        infinitesimal::judge(Scheme::PerCoordinate, scene, question, args)
    }
}

/// The real functions, without a fault.
pub(super) struct Real;

impl Judging for Real {}

/// The guards of the judging.
pub const GUARDS: &[Guard] = &[
    guard("class table", "each promise allows its own disagreements, and a band has both of its edges"),
    guard(
        "status table",
        "an expectation matches only its scene, backend, level and class, and fails if the finding \
           does not occur",
    ),
    guard(
        "finding ids",
        "findings that differ in scene, backend, class, check or query have different ids, the same in every version",
    ),
    guard(
        "known signs",
        "orientations, circles and spheres of small integers, and a determinant of 2^-56, have the signs computed by \
         hand",
    ),
    guard("known ties", "the first terms of the perturbation have the signs computed by hand"),
    guard("honest answers", "the proved backend `exact` is right about a scene in space, in each plane"),
];

const fn guard(name: &'static str, means: &'static str) -> Guard {
    Guard { area: Area::Oracle, name, means }
}

/// The result of each guard.
pub(super) fn held(judging: &dyn Judging) -> Vec<Held> {
    let guards: [fn(&dyn Judging, &mut Facts); 6] = [class_table, status_table, ids, signs, ties, honest];
    let held = |(guard, look): (&Guard, fn(&dyn Judging, &mut Facts))| {
        let mut facts = Facts::default();
        look(judging, &mut facts);
        facts.held(guard.name)
    };
    GUARDS.iter().zip(guards).map(held).collect()
}

const BAND: Option<Band> = Some(Band { lower: 1.0, width: 2.0, upper: 3.0 });

fn class_table(judging: &dyn Judging, facts: &mut Facts) {
    use Sign::{Negative, Positive, Zero};
    use ZeroMeaning::{Band as InBand, Exact, Never};
    let table = [
        (Exact, None, Zero, 0.0, Class::Agree),
        (Exact, None, Positive, 0.0, Class::MissedZero),
        (Exact, None, Negative, 0.0, Class::MissedZero),
        (Exact, None, Zero, 1e-300, Class::Overreach),
        (Exact, None, Zero, -1.0, Class::Overreach),
        (Exact, None, Positive, -1.0, Class::SignFlip),
        (Exact, None, Negative, -1.0, Class::Agree),
        (Never, None, Zero, 0.0, Class::Inconsistent),
        (Never, None, Positive, 0.0, Class::TieBroken),
        (Never, None, Negative, 0.0, Class::TieBroken),
        (Never, None, Zero, 1.0, Class::Overreach),
        (Never, None, Negative, 1.0, Class::SignFlip),
        (Never, None, Positive, 1.0, Class::Agree),
        (InBand, BAND, Zero, 0.0, Class::Agree),
        (InBand, BAND, Zero, 3.0, Class::InBand),
        (InBand, BAND, Zero, -3.5, Class::Overreach),
        (InBand, BAND, Positive, 0.0, Class::MissedZero),
        (InBand, BAND, Positive, 1.0, Class::MissedZero),
        (InBand, BAND, Positive, 1.5, Class::Agree),
        (InBand, BAND, Negative, 1.5, Class::SignFlip),
        (InBand, None, Zero, 0.5, Class::Overreach),
    ];
    for (zero, band, answer, determinant, class) in table {
        let got = judging.class(zero, band, answer, determinant);
        facts.hold(got == class, || {
            format!("{answer} of {determinant} where zero means {zero:?} is {got}, not {class}")
        });
    }
}

const EXPECTED: &str = "\
[[expect]]
scene = \"near-*\"
backend = \"naive\"
class = [\"sign_flip\", \"overreach\"]
reason = \"rounding\"

[[expect]]
scene = \"families/far\"
backend = \"naive\"
class = \"nan\"
reason = \"overflow\"
level = \"full\"
";

fn status_table(judging: &dyn Judging, facts: &mut Facts) {
    use Class::{Agree, InBand, Nan, Overreach, SignFlip, TieBroken};
    let table: [([&str; 4], &[Class], Status); 12] = [
        (["families", "near-plane", "naive", "quick"], &[Agree, SignFlip, Overreach], Status::Expected),
        (["families", "near-plane", "naive", "quick"], &[SignFlip], Status::UnexpectedPass),
        (["families", "near-plane", "naive", "quick"], &[Agree], Status::UnexpectedPass),
        (["families", "near-plane", "naive", "quick"], &[SignFlip, Overreach, Nan], Status::Unexpected),
        (["families", "near-plane", "shewchuk", "quick"], &[SignFlip, Overreach], Status::Unexpected),
        (["families", "near-plane", "exact", "quick"], &[Agree, TieBroken, InBand], Status::Ok),
        (["families", "uniform", "naive", "quick"], &[SignFlip, Overreach], Status::Unexpected),
        (["families", "uniform", "naive", "quick"], &[Agree], Status::Ok),
        (["families", "far", "naive", "full"], &[Nan], Status::Expected),
        (["families", "far", "naive", "quick"], &[Nan], Status::Unexpected),
        (["families", "far", "naive", "quick"], &[Agree], Status::Ok),
        (["others", "far", "naive", "full"], &[Nan], Status::Unexpected),
    ];
    for (row, found, status) in table {
        let got = judging.status(EXPECTED, row, found);
        facts.hold(got == status, || format!("{} with {found:?} is {}, not {}", row.join("/"), got, status));
    }
}

fn ids(judging: &dyn Judging, facts: &mut Facts) {
    let query = |text: &str| text.parse().into_iter().collect::<Vec<_>>();
    let finding = |class, check: &str, at: &str| Finding::plain(class, check, query(at), String::new(), String::new());
    let [one, other] = ["orient2d(xy; 0 1 2)", "orient2d(xy; 0 1 3)"];
    let first = finding(Class::SignFlip, "sign", one);
    let all = [
        judging.id("0123456789abcdef", "naive", &first),
        judging.id("0123456789abcdef", "naive", &finding(Class::SignFlip, "sign", other)),
        judging.id("0123456789abcdef", "naive", &finding(Class::SignFlip, "perturbed sign", one)),
        judging.id("0123456789abcdef", "naive", &finding(Class::MissedZero, "sign", one)),
        judging.id("0123456789abcdef", "naive:first", &first),
        judging.id("0123456789abcdee", "naive", &first),
    ];
    facts.hold(all[0] == PINNED, || format!("the id of a known finding is {}", all[0]));
    for (at, id) in all.iter().enumerate() {
        facts.hold(!all[..at].contains(id), || format!("two findings have the id {id}"));
        facts.hold(id.len() == 12, || format!("{id} has not twelve digits"));
    }
    let again = judging.id("0123456789abcdef", "naive", &first);
    facts.hold(again == all[0], || format!("{again} and {} are of one finding", all[0]));
}

/// The id of the first of these findings, fixed since ids were introduced.
const PINNED: &str = "ec9032d92351";

fn scene(points: &[[f64; 3]]) -> Scene {
    Scene::from_points3(points).expect("points that are finite")
}

fn flat(points: &[[f64; 2]]) -> Scene {
    Scene::from_points2(points).expect("points that are finite")
}

fn vertices<const N: usize>(places: [usize; N]) -> [Vertex; N] {
    places.map(Vertex::input)
}

fn signs(judging: &dyn Judging, facts: &mut Facts) {
    use Question::{Compare, Incircle, Insphere, Orient2d, Orient3d};
    use Sign::{Negative, Positive, Zero};
    let mut look = |scene: &Scene, question: Question, args: &[Vertex], sign: Sign| {
        let got = judging.truth(scene, question, args);
        facts.hold(got == sign, || {
            format!("{} of {:?} is {got}, not {sign}", question.query(args), scene.coordinates())
        });
    };
    let corner = flat(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]);
    look(&corner, Compare(Axis::X), &vertices([1, 0]), Positive);
    look(&corner, Compare(Axis::Y), &vertices([1, 0]), Zero);
    look(&corner, Orient2d(Plane::Xy), &vertices([0, 1, 2]), Positive);
    look(&corner, Orient2d(Plane::Xy), &vertices([0, 2, 1]), Negative);
    look(&corner, Orient2d(Plane::Xy), &vertices([0, 3, 4]), Zero);
    look(&corner, Incircle, &vertices([0, 1, 2, 3]), Positive);
    look(&corner, Incircle, &vertices([0, 1, 2, 4]), Zero);
    look(&corner, Incircle, &vertices([0, 1, 2, 5]), Negative);
    // Left of it in the xy plane, right of it in the yz plane, on the line in the zx plane.
    let turned = scene(&[[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 0.0]]);
    look(&turned, Orient2d(Plane::Xy), &vertices([0, 1, 2]), Positive);
    look(&turned, Orient2d(Plane::Yz), &vertices([0, 1, 2]), Negative);
    look(&turned, Orient2d(Plane::Zx), &vertices([0, 1, 2]), Zero);
    let simplex =
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, -2.0], [1.0, 1.0, -1.0], [2.0, 2.0, -2.0]];
    let simplex = scene(&[&simplex[..], &[[3.0, 3.0, -3.0], [1.0, 1.0, 0.0]]].concat());
    look(&simplex, Orient3d, &vertices([0, 1, 2, 3]), Positive);
    look(&simplex, Orient3d, &vertices([1, 0, 2, 3]), Negative);
    look(&simplex, Orient3d, &vertices([0, 1, 2, 7]), Zero);
    look(&simplex, Insphere, &vertices([0, 1, 2, 3, 4]), Positive);
    look(&simplex, Insphere, &vertices([0, 1, 2, 3, 5]), Zero);
    look(&simplex, Insphere, &vertices([0, 1, 2, 3, 6]), Negative);
    // (0.5 + 2^-53) · 12 − 0.5 · 12, times 2: plain doubles lose it.
    let near = flat(&[[0.5, 0.5 + f64::EPSILON / 2.0], [12.0, 12.0], [24.0, 24.0], [0.5 + f64::EPSILON / 2.0, 0.5]]);
    look(&near, Orient2d(Plane::Xy), &vertices([0, 1, 2]), Positive);
    look(&near, Orient2d(Plane::Xy), &vertices([3, 1, 2]), Negative);
}

fn ties(judging: &dyn Judging, facts: &mut Facts) {
    use Question::{Compare, Orient2d};
    use Sign::{Negative, Positive};
    let line = flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
    let mut look = |question: Question, args: &[Vertex], sign: Sign| {
        let got = judging.perturbed(&line, question, args);
        facts.hold(got == sign, || format!("{} is {got} in the perturbed scene, not {sign}", question.query(args)));
    };
    // The y of vertex k moves by ε^(2^(2k + 1)): a smaller index moves more.
    look(Compare(Axis::Y), &vertices([0, 1]), Positive);
    look(Compare(Axis::Y), &vertices([1, 0]), Negative);
    look(Compare(Axis::Y), &vertices([1, 2]), Positive);
    // ∂/∂y of the first vertex is the third's x minus the second's; that in x is zero.
    look(Orient2d(Plane::Xy), &vertices([0, 1, 2]), Positive);
    look(Orient2d(Plane::Xy), &vertices([0, 2, 1]), Negative);
    look(Orient2d(Plane::Xy), &vertices([2, 0, 1]), Positive);
}

fn honest(judging: &dyn Judging, facts: &mut Facts) {
    let points: Vec<[f64; 3]> =
        (0..7_u32).map(|i| [i * i % 5, (3 * i + 1) % 7, i * i * i % 11].map(f64::from)).collect();
    let scene = scene(&points);
    let Ok(session) = Exact.prepare(&scene, Off) else { return };
    for (a, b, c) in (0..7).flat_map(|a| (0..7).flat_map(move |b| (0..7).map(move |c| (a, b, c)))) {
        for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
            let (question, args) = (Question::Orient2d(plane), vertices([a, b, c]));
            let (answer, truth) = (question.ask(&session, &args), judging.truth(&scene, question, &args));
            let class = judging.class(ZeroMeaning::Exact, None, answer, f64::from(truth.as_i8()));
            facts.hold(class == Class::Agree, || format!("{} of exact is {class}", question.query(&args)));
        }
    }
}

macro_rules! faults {
    ($($type:ident, $name:literal, $what:literal, $caught_by:expr, { $($body:item)* })*) => {
        $(
            struct $type;
            impl Judging for $type {
                $($body)*
            }
        )*

        /// The faults in the judging.
        pub const FAULTS: &[Guarded] = &[$(Guarded {
            area: Area::Oracle,
            name: $name,
            what: $what,
            caught_by: $caught_by,
            run: || held(&$type),
        }),*];
    };
}

faults! {
    LegalMissedZero, "missed-zero-legal", "a missed zero is classed as legal", &["class table"], {
        fn class(&self, zero: ZeroMeaning, band: Option<Band>, answer: Sign, determinant: f64) -> Class {
            match Real.class(zero, band, answer, determinant) {
                Class::MissedZero => Class::Agree,
                class => class,
            }
        }
    }
    BandForAll, "band-for-all", "zeros of backends without a band are judged with a band of 10^-9", &["class table"], {
        fn class(&self, zero: ZeroMeaning, band: Option<Band>, answer: Sign, determinant: f64) -> Class {
            match Real.class(zero, band, answer, determinant) {
                Class::Overreach if band.is_none() && determinant.abs() <= 1e-9 => Class::InBand,
                class => class,
            }
        }
    }
    AnyScene, "any-scene", "an expectation matches any scene", &["status table"], {
        fn status(&self, expected: &str, row: [&str; 4], found: &[Class]) -> Status {
            let expected = expected.replace("near-*", "*").replace("families/far", "*");
            Real.status(&expected, row, found)
        }
    }
    AnyClass, "any-class", "an expectation of one class matches findings of all classes", &["status table"], {
        fn status(&self, expected: &str, row: [&str; 4], found: &[Class]) -> Status {
            match Real.status(expected, row, found) {
                Status::Unexpected if Real.status(expected, row, &[]) == Status::UnexpectedPass => Status::Expected,
                status => status,
            }
        }
    }
    AnyLevel, "any-level", "an expectation of one level matches all levels", &["status table"], {
        fn status(&self, expected: &str, row: [&str; 4], found: &[Class]) -> Status {
            Real.status(&expected.replace("level = \"full\"\n", ""), row, found)
        }
    }
    NoPass, "unexpected-pass-ignored", "an expectation that does not occur is not a failure", &["status table"], {
        fn status(&self, expected: &str, row: [&str; 4], found: &[Class]) -> Status {
            match Real.status(expected, row, found) {
                Status::UnexpectedPass => Status::Ok,
                status => status,
            }
        }
    }
    IdWithoutQuery, "id-without-query", "the id of a finding omits the query", &["finding ids"], {
        fn id(&self, scene: &str, backend: &str, finding: &Finding) -> String {
            Real.id(scene, backend, &Finding { queries: Vec::new(), ..finding.clone() })
        }
    }
    IdWithoutBackend, "id-without-backend", "the id of a finding omits the backend", &["finding ids"], {
        fn id(&self, scene: &str, _: &str, finding: &Finding) -> String {
            Real.id(scene, "", finding)
        }
    }
    OtherPlane, "other-plane", "the truth in the plane yz is computed in the plane zx", &["known signs", "honest \
                 answers"], {
        fn truth(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
            let question = match question {
                Question::Orient2d(Plane::Yz) => Question::Orient2d(Plane::Zx),
                other => other,
            };
            Real.truth(scene, question, args)
        }
    }
    InDoubles, "truth-in-doubles", "the truth is the sign of a determinant in plain floating point", &["known signs"], {
        fn truth(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
            let float = Naive { pivot: Pivot::Last };
            let session = float.prepare(scene, Off);
            session.ok().and_then(|session| session.estimate(question, args)).map_or(Sign::Zero, Sign::of)
        }
    }
    TurnedOver, "turned-over", "the truth about orientations in space has the opposite sign", &["known signs"], {
        fn truth(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
            let sign = Real.truth(scene, question, args);
            if question == Question::Orient3d { -sign } else { sign }
        }
    }
    TiesByOrder, "ties-by-order", "the judge calls all ties positive", &["known ties"], {
        fn perturbed(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
            match Real.truth(scene, question, args) {
                Sign::Zero => Sign::Positive,
                sign => sign,
            }
        }
    }
    LargerIndexFirst, "larger-index-first", "the judge moves larger indices by more", &["known ties"], {
        fn perturbed(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
            match Real.truth(scene, question, args) {
                Sign::Zero => -Real.perturbed(scene, question, args),
                sign => sign,
            }
        }
    }
}
