//! The cost of a tie about constructed vertices: the search for the deciding monomial, compared with the exact backend
//! that finds the tie.
//!
//! It uses families of the corpus in which half or all of the queries are ties. Both backends alternate over the same
//! queries. It prints one line per family: nanoseconds per query, and the extra cost per tie.

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_exact::Exact;
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{Backend, Off, Predicates, QuerySet, Sign};
use predicament_sos::Sos;
use predicament_tasks::signs::SignQueries;

const QUERIES: usize = 2000;
const ROUNDS: usize = 5;

fn load(family: &str, task: &str) -> LoadedScene {
    let text = format!(
        "title = \"ties\"\n[[generate]]\nfamily = \"{family}\"\ntask = \"{task}\"\nn = {QUERIES}\nseed = 5\n\
         source = \"generated\"\nanalysis = \"What ties cost.\"\n"
    );
    let suite = Suite::parse(predicament_bundle::vocabulary(), "ties.toml", &text, None, &Manifest::default())
        .expect("a suite");
    suite.scenes[0].load(Level::Quick, &Cache::new("")).expect("generated")
}

fn pass(session: &impl Predicates, queries: &QuerySet, out: &mut [Sign]) -> Duration {
    let start = Instant::now();
    for (query, out) in out.iter_mut().enumerate() {
        *out = queries.question().ask(session, black_box(queries).args(query));
    }
    start.elapsed()
}

fn median(mut times: Vec<Duration>) -> f64 {
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64() * 1e9
}

fn ties(criterion: &mut Criterion) {
    for (family, task) in [
        ("ssi-degen", "compare"),
        ("ssi-degen", "orient2d"),
        ("lpi-degen", "compare"),
        ("lpi-degen", "orient3d"),
        ("tpi-degen", "compare"),
        ("tpi-degen", "orient3d"),
    ] {
        let loaded = load(family, task);
        let queries = &loaded.content::<SignQueries>().expect("a family of signs").queries;
        let sos = Sos::default();
        let exact = Exact.prepare(&loaded.scene, Off).expect("prepared");
        let session = sos.prepare(&loaded.scene, Off).expect("prepared");
        let mut out = vec![Sign::Zero; queries.len()];
        pass(&exact, queries, &mut out);
        let broken = out.iter().filter(|sign| sign.is_zero()).count();
        let (mut plain, mut perturbed) = (Vec::new(), Vec::new());
        for _ in 0..ROUNDS {
            plain.push(pass(&exact, queries, &mut out));
            perturbed.push(pass(&session, queries, &mut out));
        }
        let [plain, perturbed] = [plain, perturbed].map(median);
        #[allow(clippy::cast_precision_loss)] // some thousands
        let [all, broken] = [queries.len() as f64, broken as f64];
        println!(
            "{family} {task}: exact {:.0} ns, sos {:.0} ns, {:.1} µs more for each of {broken} ties in {all}",
            plain / all,
            perturbed / all,
            (perturbed - plain) / broken / 1e3,
        );
        criterion.bench_function(&format!("{family} {task}"), |bencher| {
            bencher.iter(|| pass(&session, queries, &mut out));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = ties
}
criterion_main!(benches);
