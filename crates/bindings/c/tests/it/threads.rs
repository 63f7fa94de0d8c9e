//! Many threads ask one scene at the same time.

use predicament_predicates::Plane;

use super::*;
use predicament::ffi::predicament_backend::{PREDICAMENT_EXACT, PREDICAMENT_SOS};

/// A pointer that threads share, as a C program shares it.
struct Shared<'a>(&'a Owned);

// SAFETY: this is the promise of the header: threads may query one scene.
unsafe impl Sync for Shared<'_> {}

impl Shared<'_> {
    /// A checksum of queries, half of them one by one and half in batches.
    fn answers(&self, seed: u64) -> Vec<i8> {
        let (mut random, mut signs) = (Random(seed), Vec::new());
        for _ in 0..40 {
            let ids: Vec<u32> = (0..96).map(|_| random.below(32)).collect();
            let turn = Question::Orient2d(Plane::Xy);
            signs.extend(ask_many(self.0, turn, &ids).expect("signs"));
            signs.extend(ids.chunks_exact(4).map(|query| ask(self.0, Question::Incircle, query).expect("a sign")));
        }
        signs
    }
}

/// Plans, rows and memos of a session are made by the first query that needs them: all threads ask a fresh scene.
#[test]
fn threads_get_the_answers_of_one_thread() {
    let mut random = Random(4);
    for backend in [PREDICAMENT_EXACT, PREDICAMENT_SOS] {
        // A fine grid: ties, and queries that no filter decides.
        let coordinates: Vec<f64> = (0..64).map(|_| f64::from(random.below(4)) + 2_f64.powi(-52)).collect();
        let alone = scene(2, &coordinates, backend);
        let expected: Vec<Vec<i8>> = (0..8).map(|seed| Shared(&alone).answers(seed)).collect();
        let together = scene(2, &coordinates, backend);
        let shared = Shared(&together);
        let said: Vec<Vec<i8>> = std::thread::scope(|scope| {
            let threads =
                (0..8).map(|seed| (seed, &shared)).map(|(seed, shared)| scope.spawn(move || shared.answers(seed)));
            threads.collect::<Vec<_>>().into_iter().map(|thread| thread.join().expect("no panic")).collect()
        });
        assert_eq!(said, expected);
    }
}
