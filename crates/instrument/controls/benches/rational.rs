//! The cost of exactness without a ladder: `exact:rational` over `exact`, query by query.
//!
//! Each line is a predicate on one kind of points; both backends answer the same queries, taking turns. The medians are
//! of single queries about 2,048 vertices, which stay in the cache. Constructed vertices are made before the clock
//! starts, and so are rational coordinates, whose time is a line of its own.

use std::hint::black_box;
use std::time::Instant;

use predicament_controls::ExactRational;
use predicament_exact::Exact;
use predicament_predicates::{
    Backend, Construction, Dimension, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex,
};

const POINTS: usize = 2048;
const ROUNDS: usize = 9;

/// The random number generator xorshift64 (Marsaglia 2003).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, n: usize) -> usize {
        usize::try_from((self.next() >> 20) % n as u64).expect("small")
    }

    /// A multiple of 2^-53 from 0 to 1.
    #[allow(clippy::cast_precision_loss)] // 53 bits
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / 9_007_199_254_740_992.0
    }
}

/// A kind of coordinates, by name.
type Input = (&'static str, fn(&mut Random) -> f64);

const INPUTS: [Input; 3] = [
    ("uniform", Random::unit),
    ("lattice", |random| f64::from(u32::try_from(random.below(16)).expect("small"))),
    ("wide", |random| random.unit() * 2f64.powi(i32::try_from(random.below(81)).expect("small") - 40)),
];

fn scene(dimension: Dimension, (_, coordinate): Input) -> Scene {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let coordinates = (0..POINTS * dimension.count()).map(|_| coordinate(&mut random)).collect();
    Scene::new(dimension, coordinates).expect("finite")
}

/// Constructed vertices of one kind, in the number of the points of the scene.
fn constructed(scene: &Scene, kind: &str) -> Scene {
    let mut scene = scene.clone();
    let mut random = Random(0xbf58_476d_1ce4_e5b9);
    let mut v = || Vertex::input(random.below(POINTS));
    while scene.constructions().len() < POINTS {
        let definition = match kind {
            "ssi" => Construction::Ssi([[v(), v()], [v(), v()]]),
            "lpi" => Construction::Lpi { line: [v(), v()], plane: [v(), v(), v()] },
            _ => Construction::Tpi([[v(), v(), v()], [v(), v(), v()], [v(), v(), v()]]),
        };
        // (A line or plane that names a vertex twice is refused.)
        let _ = scene.construct(definition);
    }
    scene
}

/// Nanoseconds a query, and the signs.
fn once(session: &dyn Predicates, question: Question, args: &[Vertex]) -> (f64, Vec<Sign>) {
    let queries = args.chunks_exact(question.kind().arity());
    let mut signs = Vec::with_capacity(queries.len());
    let start = Instant::now();
    for query in queries {
        signs.push(black_box(question.ask(session, black_box(query))));
    }
    (start.elapsed().as_secs_f64() * 1e9 / f64::from(u32::try_from(signs.len()).expect("few")), signs)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

fn line(what: &str, scene: &Scene, question: Question, queries: usize) {
    let (exact, rational) =
        (Exact.prepare(scene, Off).expect("points"), ExactRational.prepare(scene, Off).expect("points"));
    let constructed = scene.constructions().len();
    let mut random = Random(0x94d0_49bb_1331_11eb);
    let mut vertex = || match constructed {
        0 => Vertex::input(random.below(POINTS)),
        count => Vertex::constructed(random.below(count)),
    };
    let args: Vec<Vertex> = (0..queries * question.kind().arity()).map(|_| vertex()).collect();
    let (mut fast, mut slow) = (Vec::new(), Vec::new());
    // The first round warms up: it also makes the rows of constructed vertices.
    for round in 0..=ROUNDS {
        let ((a, signs), (b, same)) = (once(&exact, question, &args), once(&rational, question, &args));
        assert!(signs == same, "{what}: the backends differ");
        if round > 0 {
            fast.push(a);
            slow.push(b);
        }
    }
    let (fast, slow) = (median(fast), median(slow));
    println!("| {what} | {} | {fast:.1} | {slow:.0} | {:.0} |", question.kind(), slow / fast);
}

fn main() {
    println!("| points | predicate | exact, ns | exact:rational, ns | ratio |\n|---|---|---:|---:|---:|");
    for input in INPUTS {
        for kind in PredicateKind::ALL {
            let dimension = kind.dimension().unwrap_or(Dimension::Two);
            line(input.0, &scene(dimension, input), kind.first_question(), 20_000);
        }
    }
    let turn = Question::Orient2d(Plane::Xy);
    let flat = scene(Dimension::Two, INPUTS[0]);
    line("ssi", &constructed(&flat, "ssi"), turn, 5_000);
    let solid = scene(Dimension::Three, INPUTS[0]);
    line("lpi", &constructed(&solid, "lpi"), Question::Orient3d, 5_000);
    line("tpi", &constructed(&solid, "tpi"), Question::Orient3d, 5_000);
    let start = Instant::now();
    black_box(ExactRational.prepare(&solid, Off).expect("points"));
    let count = f64::from(u32::try_from(solid.coordinates().len()).expect("few"));
    println!("\nA rational for each coordinate: {:.0} ns", start.elapsed().as_secs_f64() * 1e9 / count);
}
