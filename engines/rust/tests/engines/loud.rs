//! An engine whose library prints to stdout; the test checks that this does no harm.

use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, serve};

#[derive(Default)]
struct Loud;

impl Engine for Loud {
    const NAME: &'static str = "loud";
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] = &[Predicate::Compare];

    fn version() -> String {
        "1.0".to_owned()
    }

    fn compare(&self, _: usize, [a, b]: [Vertex<1>; 2]) -> Answer {
        println!("a library that says {} and {}", a.id, b.id);
        assert_ne!(a.id, b.id, "one vertex");
        (a.at[0] - b.at[0]).into()
    }
}

fn main() -> std::process::ExitCode {
    serve::<Loud>()
}
