//! The audit of contacts: their guarantee, checked by exact distances.
//!
//! # The guarantee
//! Wang, Jiang, Schroeder and Teran query a pair only if no sub-pair of it (a face of the one with a face of the other)
//! is registered. Under that condition:
//!
//! * A pair that registers a degeneracy (vertex-vertex, edge-vertex, and in space edge-edge and triangle-vertex) is
//!   registered if its exact distance is at most T₋, and only if it is at most T₊ (1). The distance is that of the two
//!   feet of the shortest connection between the line, plane or point of each, and both feet have to be strictly
//!   inside. That is the distance of the closed simplices. Proof: if a foot is not inside, the closed simplices are
//!   nearest at a face. The distance of that face is beyond its own T₋, which is larger than the T₊ in question
//!   (τ₊ < σ₋, γ₊ < τ₋, δ₊ < τ₋). A foot on the simplex' boundary can't be within T₊ for the same reason.
//! * A pair of full dimension is registered if and only if it crosses, without a tolerance. The values of its signs
//!   have been bounded away from zero.
//! * Those bounds themselves ("guarded quantities": κ₊, λ₊, φ₊, ν₊, ζ₊, μ₊, ξ₊, ρ₊, and √(σ₋² − τ₊²) of an edge's foot)
//!   hold for every pair that is within T₊ or crosses. They are checked for registered pairs.
//! * A weight is in [0, 1]. The paper promises no bound on its error; the largest error is reported.
//!
//! For a session without bands T₋ = T₊ = 0. The guarantee then says that the registered pairs are those that meet, by
//! the carriers of lowest dimension: the audit of exact signs. (Sessions that break ties have another guarantee.)
//!
//! In addition, every test of an algorithm is checked by its own tolerance, for any sub-pairs ([`Readings`]). For this,
//! the session is also queried about pairs that have ended: pairs that the hierarchy never queries reveal a wrong
//! tolerance.
//!
//! All promises are taken from the paper ([`Published`]), never from the session.
//!
//! * [`Bands::judge`]: one answer.
//! * [`audit`]: all contacts of two complexes.

mod judge;
mod pair;
mod quantity;
mod reading;
mod sweep;

use std::collections::{HashMap, HashSet};

use crate::answer::{Contact, Contacts, ask, levels};
use predicament_mesh::{Complex, Faces, Simplex};
use predicament_predicates::{Dimension, Predicates, Scene, Vertex};
use rayon::prelude::*;

pub use judge::{Bands, Judgement, Verdict};
pub use pair::{Feet, Pair, PairKind};
pub use predicament_laws::published::{Published, Symbol};
pub use quantity::Quantity;
pub use reading::{Hit, Readings};

/// A pair whose answer broke the guarantee.
#[derive(Clone, PartialEq, Debug)]
pub struct Finding {
    /// The simplex of the first complex.
    pub a: Simplex,
    /// The simplex of the second complex.
    pub b: Simplex,
    /// The kind of the pair.
    pub kind: PairKind,
    /// The violation of the guarantee.
    pub verdict: Verdict,
    /// True if the pair was registered.
    pub registered: bool,
    /// The distance of the two closed simplices, in scene units: the rounded square root of the exact square.
    pub distance: f64,
}

/// The results of an audit.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Audit {
    counts: [[u64; Verdict::ALL.len()]; PairKind::ALL.len()],
    /// The number of near pairs that must not be queried, because a sub-pair is registered.
    pub ended: u64,
    /// The number of ended pairs that the audit queried all the same.
    pub read: u64,
    /// The largest error of a weight, by [`PairKind`].
    pub weight_errors: [f64; PairKind::ALL.len()],
    /// All answers that break the guarantee, in the order of levels and simplices.
    pub findings: Vec<Finding>,
    /// Registered pairs that had to be queried.
    asked: Vec<[Simplex; 2]>,
}

type Registered<'a> = HashMap<[Simplex; 2], &'a Contact>;

impl Audit {
    /// The number of answers about this kind of pair with this verdict.
    #[must_use]
    pub fn count(&self, kind: PairKind, verdict: Verdict) -> u64 {
        self.counts[kind as usize][verdict as usize]
    }

    /// The number of judged answers.
    #[must_use]
    pub fn judged(&self) -> u64 {
        self.counts.iter().flatten().sum()
    }

    fn add(&mut self, later: Audit) {
        for (count, more) in self.counts.as_flattened_mut().iter_mut().zip(later.counts.as_flattened()) {
            *count += more;
        }
        self.ended += later.ended;
        self.read += later.read;
        for (error, other) in self.weight_errors.iter_mut().zip(later.weight_errors) {
            *error = error.max(other);
        }
        self.findings.extend(later.findings);
        self.asked.extend(later.asked);
    }

    /// Queries a pair that has ended, and checks the answer by the tests alone.
    fn reread<S: Predicates + ?Sized>(
        &mut self,
        session: &S,
        [a, b]: [&Complex; 2],
        [s, t]: [Simplex; 2],
        bands: &Bands,
    ) {
        let pair = pair(session.scene(), a.vertices_of(s), b.vertices_of(t));
        let registered = ask(session, [a, b], [s, t]).is_some();
        if bands.misreads(&pair, registered) {
            self.counts[pair.kind() as usize][Verdict::Misread as usize] += 1;
            self.findings.push(finding([s, t], &pair, Verdict::Misread, registered));
        }
    }

    fn note(&mut self, kind: PairKind, judgement: Judgement) {
        self.counts[kind as usize][judgement.verdict as usize] += 1;
        if let Some(error) = judgement.weight_error {
            let largest = &mut self.weight_errors[kind as usize];
            *largest = largest.max(error);
        }
    }
}

/// Judges every registered pair, and every pair that is near enough to be registered and has not ended. Of the ended
/// pairs, a sample is queried separately and checked by the tests of its algorithm.
///
/// # Panics
/// If the complexes do not belong to the session's scene.
#[must_use]
pub fn audit<S: Predicates + ?Sized>(session: &S, a: &Complex, b: &Complex, contacts: &Contacts) -> Audit {
    let scene = session.scene();
    let bands = Bands::of(session);
    let registered: Registered = contacts.registered.iter().map(|contact| ([contact.a, contact.b], contact)).collect();
    let faces = [a, b].map(Faces::new);
    let judge =
        |pairs: &[[Simplex; 2]], step: u64| {
            let mut audit = Audit::default();
            for &[s, t] in pairs {
                let contact = registered.get(&[s, t]).copied();
                if has_registered_faces(&registered, &faces, [s, t]) {
                    audit.ended += u64::from(contact.is_none());
                    if contact.is_none() && (audit.ended - 1).is_multiple_of(step) && bands.has_readings() {
                        audit.read += 1;
                        audit.reread(session, [a, b], [s, t], &bands);
                    }
                    continue;
                }
                audit.asked.extend(contact.map(|_| [s, t]));
                let pair = pair(scene, a.vertices_of(s), b.vertices_of(t));
                let got = contact.map(|contact| {
                    if s.rank >= t.rank { [contact.on_a, contact.on_b] } else { [contact.on_b, contact.on_a] }
                });
                let judgement = bands.judge(&pair, got.as_ref());
                audit.note(pair.kind(), judgement);
                if !judgement.verdict.is_legal() {
                    audit.findings.push(finding([s, t], &pair, judgement.verdict, contact.is_some()));
                }
            }
            audit
        };
    let mut audit = Audit::default();
    let reach = session.reach().max(bands.reach());
    for &ranks in levels(scene.dimension()).iter().copied().flatten() {
        let near = sweep::near(scene, [a, b], ranks, reach);
        let step = (near.len() / READ).max(1) as u64;
        let pieces: Vec<Audit> = near.par_chunks(PIECE).map(|pairs| judge(pairs, step)).collect();
        pieces.into_iter().for_each(|piece| audit.add(piece));
    }
    let asked: HashSet<[Simplex; 2]> = std::mem::take(&mut audit.asked).into_iter().collect();
    for contact in contacts.registered.iter().filter(|contact| !asked.contains(&[contact.a, contact.b])) {
        let [s, t] = [contact.a, contact.b];
        let pair = pair(scene, a.vertices_of(s), b.vertices_of(t));
        audit.note(pair.kind(), Judgement::unasked());
        audit.findings.push(finding([s, t], &pair, Verdict::Unasked, true));
    }
    audit
}

/// The number of pairs that one thread judges at a time.
const PIECE: usize = 1 << 10;

/// The approximate number of ended pairs of two ranks that are queried all the same, at even steps.
const READ: usize = 1 << 13;

fn finding([a, b]: [Simplex; 2], pair: &Pair, verdict: Verdict, registered: bool) -> Finding {
    let distance = pair.distance_squared().to_f64().sqrt();
    Finding { a, b, kind: pair.kind(), verdict, registered, distance }
}

fn pair(scene: &Scene, s: &[Vertex], t: &[Vertex]) -> Pair {
    fn points<const D: usize>(scene: &Scene, simplex: &[Vertex]) -> Vec<[f64; D]> {
        simplex.iter().map(|&v| std::array::from_fn(|i| scene.point(v)[i])).collect()
    }
    match scene.dimension() {
        Dimension::Two => Pair::new::<2>(&points(scene, s), &points(scene, t)),
        Dimension::Three => Pair::new::<3>(&points(scene, s), &points(scene, t)),
    }
}

/// True if a face of the one and a face of the other, not both the whole simplices, are registered.
fn has_registered_faces(registered: &Registered, [of_a, of_b]: &[Faces; 2], [s, t]: [Simplex; 2]) -> bool {
    let mut pairs = of_a.of(s).flat_map(|face| of_b.of(t).map(move |other| [face, other]));
    pairs.any(|pair| pair != [s, t] && registered.contains_key(&pair))
}
