//! The term lists as data.
//!
//! The committed lists equal the program's output, and all but a handful of terms are needed.

use crate::common::{self, Random, first, grid_scene, question, scene};
use predicament_effort::{scaled, whole};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Counts, MAX_STAGES, Off, PredicateKind, Scene, Sign};
use predicament_sos::{Scheme, Sos, Term, derive, infinitesimal::judge, ties};

#[test]
fn the_committed_tables_are_the_derived_ones() {
    assert!(
        derive::tables() == include_str!("../../src/tables.rs"),
        "run `cargo run --release -p predicament-sos --features gmp --bin derive_sos_terms > crates/kernel/sos/src/tables.rs`"
    );
}

#[test]
fn only_the_last_term_is_constant() {
    for scheme in Scheme::ALL {
        for kind in PredicateKind::ALL {
            let (last, others) = scheme.terms(kind).split_last().unwrap();
            let constant = |term: &Term| term.columns.is_empty() && term.lift.is_none() && term.gap.is_none();
            assert!(constant(last), "{scheme} {kind}");
            assert!(!others.iter().any(constant), "{scheme} {kind}");
            for term in scheme.terms(kind) {
                assert!(!term.sign.is_zero());
                assert_eq!(term.rows.len(), term.columns.len() + usize::from(term.lift.is_some()) + 1);
            }
        }
    }
}

/// The index of the first term's stage, after the exact backend's stages and those of constructed vertices.
fn first_term() -> usize {
    Sos::default().stages().iter().position(|stage| *stage == "term 1").unwrap()
}

#[test]
fn stages_are_distinct_and_fit() {
    for scheme in Scheme::ALL {
        let stages = Sos { scheme }.stages();
        let terms = PredicateKind::ALL.map(|kind| scheme.terms(kind).len()).into_iter().max().unwrap();
        assert_eq!(stages.len(), first_term() + terms);
        assert!(stages.len() <= MAX_STAGES);
        assert!(stages.starts_with(Exact.stages()));
        let degrees = ["degree 1", "degree 2", "degree 3", "degree 4 or more"].map(str::to_owned);
        let own: Vec<String> = degrees.into_iter().chain((1..=terms).map(|term| format!("term {term}"))).collect();
        assert_eq!(stages[Exact.stages().len()..], own);
    }
}

/// Queries of three kinds of degeneracy: few values per coordinate, few points, and points on few lines through the
/// grid.
fn degenerate(random: &mut Random, dimension: usize, arity: usize) -> Vec<usize> {
    let side = 3_usize;
    let all = side.pow(u32::try_from(dimension).unwrap());
    match random.below(3) {
        0 => random.numbers(all, arity),
        1 => {
            let points = random.numbers(all, 3);
            (0..arity).map(|_| points[random.below(3)]).collect()
        }
        _ => {
            let stride = side.pow(u32::try_from(random.below(dimension)).unwrap());
            let start = random.numbers(all, 2);
            (0..arity).map(|_| (start[random.below(2)] + stride * random.below(side)) % all).collect()
        }
    }
}

/// Each term decides some query, except those known not to.
///
/// The judge detects a swapped sign of each.
#[test]
fn every_term_decides_and_a_swapped_sign_is_seen() {
    for scheme in Scheme::ALL {
        for kind in PredicateKind::ALL {
            let dimension = if matches!(kind, PredicateKind::Orient3d | PredicateKind::Insphere) { 3 } else { 2 };
            let terms = scheme.terms(kind);
            let mut seen = vec![false; terms.len()];
            let mut random = Random(5);
            // Until no other term remains: the full effort shows whether those that never decide would.
            let decisive = terms.len() - undecisive(scheme, kind).len();
            for _ in 0..30_000 {
                if !whole() && seen.iter().filter(|&&seen| seen).count() == decisive {
                    break;
                }
                let scene = grid_scene(dimension, 3, &degenerate(&mut random, dimension, kind.arity()));
                let args = first(kind.arity());
                let exact = Exact.prepare(&scene, Off).unwrap();
                if !question(kind).ask(&exact, &args).is_zero() {
                    continue;
                }
                let (sign, depth) = ties::decide(&exact, question(kind), terms, &args).unwrap();
                if !seen[depth] {
                    seen[depth] = true;
                    let mut swapped = terms.to_vec();
                    swapped[depth].sign = -swapped[depth].sign;
                    let (wrong, _) = ties::decide(&exact, question(kind), &swapped, &args).unwrap();
                    let truth = judge(scheme, &scene, question(kind), &args);
                    assert_eq!(sign, truth, "{scheme} {kind}, term {}", depth + 1);
                    assert_ne!(wrong, truth, "{scheme} {kind}, term {}", depth + 1);
                }
            }
            let unseen: Vec<usize> = (0..seen.len()).filter(|&depth| !seen[depth]).map(|depth| depth + 1).collect();
            assert_eq!(unseen, undecisive(scheme, kind), "{scheme} {kind}");
        }
    }
}

/// Terms that have never decided a tie, counted from 1.
///
/// The derivation drops terms that low powers prove to be implied; these would need higher powers. For `incircle`:
/// terms 1-7 vanish only with y₂ = y₃ and either x₂ = x₃, where term 8 is zero, or x₁ = (x₂ + x₃)/2 and y₁ = y₂, where
/// term 3 is a Vandermonde determinant of three different numbers and not zero. A dead term costs only its line.
fn undecisive(scheme: Scheme, kind: PredicateKind) -> &'static [usize] {
    match (scheme, kind) {
        (Scheme::PerCoordinate, PredicateKind::Incircle) => &[8],
        (Scheme::PerCoordinate, PredicateKind::Insphere) => &[28, 29, 30, 31, 45],
        _ => &[],
    }
}

/// The tally names the deciding term, and the exact stage for a tie without distinct vertices.
#[test]
fn the_tally_counts_the_deciding_term() {
    let scene = grid_scene(2, 3, &[0, 0, 4]);
    let counts = Counts::new();
    let sos = Sos::default();
    let session = sos.prepare(&scene, &counts).unwrap();
    let [a, b, c] = common::ids([0, 1, 2]);
    let kind = PredicateKind::Orient2d;
    let stage = |name: &str| sos.stages().iter().position(|&stage| stage == name).unwrap();
    let exact_stages = || (0..Exact.stages().len()).map(|stage| counts.get(kind, stage)).sum::<u64>();

    assert_ne!(question(kind).ask(&session, &[a, b, c]), Sign::Zero);
    // y differs between rows 1 and 2, so the first term decides.
    assert_eq!(counts.get(kind, stage("term 1")), 1);
    assert_eq!(exact_stages(), 0);
    assert_eq!(question(kind).ask(&session, &[a, a, c]), Sign::Zero);
    assert_eq!(exact_stages(), 1);
}

/// Corners of a box with long coordinates, or points of a line or a plane: ties in which hardly a product is a double.
fn long_ties(random: &mut Random, dimension: usize, arity: usize) -> Scene {
    let scale = 2_f64.powi([0, 40, -300, 300, -900, 900][random.below(6)]);
    box_ties(random, dimension, arity, scale, |random| f64::from_bits((1 << 62) - random.below(1 << 54) as u64))
}

/// Ties of integers near the limit of doubles for each degree, near the origin or far from it.
fn short_ties(random: &mut Random, dimension: usize, arity: usize) -> Scene {
    let scale = 2_f64.powi([0, 40, -190, -260, -1060][random.below(5)]);
    let bound = 1 << [1, 3, 8, 9, 10, 11, 12, 13, 15, 16, 17][random.below(11)];
    let offset = [0.0, 0.0, 2_f64.powi(33), 2_f64.powi(52)][random.below(4)];
    box_ties(random, dimension, arity, scale, |random| offset + f64::from(u32::try_from(random.below(bound)).unwrap()))
}

fn box_ties(
    random: &mut Random,
    dimension: usize,
    arity: usize,
    scale: f64,
    long: impl Fn(&mut Random) -> f64,
) -> Scene {
    let ends: Vec<[f64; 2]> = (0..dimension).map(|_| [long(random), long(random)]).collect();
    let shape = random.below(3);
    let mut coordinates = Vec::new();
    for _ in 0..arity {
        let corner = random.below(1 << dimension);
        let mut point: Vec<f64> = (0..dimension).map(|axis| ends[axis][corner >> axis & 1]).collect();
        if shape == 1 {
            // On x = y, or in the plane x = y.
            point.fill_with(|| long(random));
            point[0] = point[1];
        } else if shape == 2 {
            // On one level.
            let level = point[dimension - 1];
            point.fill_with(|| long(random));
            point[dimension - 1] = level * f64::from(u8::from(corner != 0));
        }
        coordinates.extend(point.iter().map(|x| x * scale));
    }
    scene(dimension, coordinates).unwrap()
}

/// A session takes a shortcut through the list of a tie.
///
/// The same term decides, and the judge agrees. Filters decide some and leave others open.
#[test]
fn a_session_decides_by_the_first_term_of_its_list() {
    let mut random = Random(15);
    let mut terms_seen = [0_u64; 2];
    for case in 0..scaled(60_000) {
        let dimension = 2 + case % 2;
        let scene = match case % 5 {
            0 => grid_scene(dimension, 3, &degenerate(&mut random, dimension, 5)),
            1 | 2 => short_ties(&mut random, dimension, 5),
            _ => long_ties(&mut random, dimension, 5),
        };
        let questions = common::questions(dimension);
        let question = questions[random.below(questions.len())];
        let kind = question.kind();
        // Five vertices in some order; the query takes the first of them.
        let mut args = first(5);
        for last in (1..5).rev() {
            args.swap(last, random.below(last + 1));
        }
        args.truncate(kind.arity());
        let exact = Exact.prepare(&scene, Off).unwrap();
        if !question.ask(&exact, &args).is_zero() {
            continue;
        }
        for scheme in Scheme::ALL {
            let (counts, sos) = (Counts::new(), Sos { scheme });
            let session = sos.prepare(&scene, &counts).unwrap();
            let sign = question.ask(&session, &args);
            // The first tie has made the scene's plan: now doubles that make no error are known.
            assert_eq!(question.ask(&session, &args), sign);
            let mut sorted = args.clone();
            sorted.sort_unstable();
            let inversions = (0..args.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
            let is_odd = inversions.filter(|&(i, j)| args[i] > args[j]).count() % 2 == 1;
            let (listed, place) = ties::decide(&exact, question, scheme.terms(kind), &sorted).unwrap();
            let context = || format!("{scheme} {question:?} of {args:?} in {scene:?}");
            assert_eq!(sign, if is_odd { -listed } else { listed }, "{}", context());
            assert_eq!(counts.get(kind, first_term() + place), 2, "{}", context());
            if case % 8 < 2 {
                assert_eq!(sign, judge(scheme, &scene, question, &args), "{}", context());
            }
            terms_seen[usize::from(scheme.terms(kind)[place].rows[0] != 1)] += 1;
        }
    }
    assert!(terms_seen.iter().all(|&seen| seen > scaled(2000) as u64), "leading and other terms: {terms_seen:?}");
}

/// The planar lists are short enough to expand on paper.
///
/// They are (x₁ − x₂) and (y₁ − y₂) by the moves of row 0, then the first coordinate to move row 1, then the product
/// that ends the list.
#[test]
fn the_planar_lists_by_hand() {
    use Sign::{Negative, Positive};
    assert_eq!(
        Scheme::EdelsbrunnerMucke.terms(PredicateKind::Orient2d),
        [
            Term::minor(Negative, &[1, 2], &[0]),
            Term::minor(Positive, &[1, 2], &[1]),
            Term::minor(Positive, &[0, 2], &[0]),
            Term::minor(Positive, &[2], &[]),
        ]
    );
    assert_eq!(
        Scheme::PerCoordinate.terms(PredicateKind::Orient2d),
        [
            Term::minor(Positive, &[1, 2], &[1]),
            Term::minor(Negative, &[1, 2], &[0]),
            Term::minor(Negative, &[0, 2], &[1]),
            Term::minor(Negative, &[2], &[]),
        ]
    );
}
