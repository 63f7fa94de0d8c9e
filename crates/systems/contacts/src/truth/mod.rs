//! The pairs of simplices that meet: by linear equations in rationals, pair by pair; with broken ties, by signs of the
//! perturbed scene.
//!
//! Some of the pairs are computed twice, the second time by the session's queries on the judge's signs.

mod perturbed;
mod proper;

use std::collections::BTreeSet;

use predicament_judge::{Judged, Sample, contacts as judge};
use predicament_mesh::{Complex, Faces, Simplex};
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::{Stop, Watch};

use crate::answer::ask;
use crate::task::content::Complexes;

pub(crate) use perturbed::perturbed;
pub(crate) use proper::is_proper;

/// A simplex of each complex.
pub(crate) type Pair = [Simplex; 2];

/// One of this many registered pairs is computed again, by another method.
const TWICE: usize = 16;

/// The pairs that meet, exactly.
pub struct Truth {
    /// The pairs with the sampled simplices of the first complex.
    pub(crate) registered: BTreeSet<Pair>,
    /// The sample of simplices of the first complex, by their indices in [`simplices`].
    sample: Sample,
    /// The sampled simplices.
    pub(crate) sampled: BTreeSet<Simplex>,
    pub(crate) faces: [Faces; 2],
}

/// All simplices of a complex by rank, with their vertices.
fn simplices(complex: &Complex) -> Vec<(Simplex, &[Vertex])> {
    let counts =
        [complex.vertices().len(), complex.edges().len(), complex.triangles().len(), complex.tetrahedra().len()];
    let of_rank = |(rank, count): (u8, usize)| {
        let count = u32::try_from(count).expect("a complex has fewer than 2^32 simplices");
        (0..count).map(move |index| Simplex { rank, index })
    };
    let all = (0..4).zip(counts).flat_map(of_rank);
    all.map(|simplex| (simplex, complex.vertices_of(simplex))).collect()
}

impl Truth {
    /// Computes the truth.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    ///
    /// # Panics
    /// If the judge contradicts itself.
    pub fn new(scene: &Scene, content: &Complexes, watch: &Watch) -> Result<Truth, Stop> {
        let [a, b] = content.both().map(simplices);
        let [of_a, of_b]: [Vec<&[Vertex]>; 2] = [&a, &b].map(|all| all.iter().map(|&(_, vertices)| vertices).collect());
        let sample = judge::sample(scene.dimension(), [a.len(), b.len()]);
        let found = judge::contacts_of(scene, &of_a, &of_b, sample);
        let registered: BTreeSet<Pair> =
            found.iter().map(|contact| [a[contact.pair[0]].0, b[contact.pair[1]].0]).collect();
        watch.done((a.len() + b.len()) as u64)?;
        let (again, faces) = (Judged::again(scene), content.both().map(Faces::new));
        for &pair in registered.iter().step_by(TWICE) {
            let [s, t] = vertices_of(content, pair);
            assert!(is_registered(&again, content, &faces, pair), "the judge contradicts itself about {s:?} and {t:?}");
        }
        watch.done(0)?;
        let sampled = sample.places().map(|place| a[place].0).collect();
        Ok(Truth { registered, sample, sampled, faces })
    }

    /// The number of sampled simplices of the first complex, in words, if it is not all.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        (!self.sample.is_all())
            .then(|| format!("simplices of the first complex: {}; and all registered pairs", self.sample))
    }
}

/// True if a session registers a pair but does not register any pair of its faces; each pair is queried separately.
fn is_registered(session: &Judged<'_>, content: &Complexes, [of_a, of_b]: &[Faces; 2], [s, t]: Pair) -> bool {
    let mut pairs = of_a.of(s).flat_map(|face| of_b.of(t).map(move |other| [face, other]));
    pairs.all(|pair| ask(session, content.both(), pair).is_some() == (pair == [s, t]))
}

fn vertices_of(content: &Complexes, [s, t]: Pair) -> [&[Vertex]; 2] {
    [content.a.vertices_of(s), content.b.vertices_of(t)]
}
