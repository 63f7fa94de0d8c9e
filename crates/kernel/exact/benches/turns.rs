//! Engines that answer the same queries, timed in turns: whatever else the machine does is shared by all.

use std::time::{Duration, Instant};

use predicament_predicates::Sign;

/// A name, and a way to answer a pass of queries, from this one on.
pub type Engine<'a> = (&'a str, &'a dyn Fn(usize, &mut [Sign]));

/// How engines take turns.
pub struct Turns {
    /// Queries that there are.
    pub queries: usize,
    /// Queries that an engine answers before the next one's turn.
    pub pass: usize,
    /// How often all queries are answered and timed.
    pub rounds: usize,
    /// How often all queries are answered before that, without being timed: memory is new to the processor then.
    pub warm_up: usize,
}

impl Turns {
    /// Each engine's median time for a pass, in seconds. `check` sees the signs of all engines after each pass.
    pub fn medians<const N: usize>(&self, engines: &[Engine; N], mut check: impl FnMut(&[Vec<Sign>; N])) -> [f64; N] {
        let mut times = [const { Vec::new() }; N];
        let mut signs = [(); N].map(|()| vec![Sign::Zero; self.pass]);
        let passes = self.queries / self.pass;
        for pass in 0..(self.warm_up + self.rounds) * passes {
            for turn in 0..N {
                let at = (pass + turn) % N;
                let start = Instant::now();
                engines[at].1(pass * self.pass % self.queries, &mut signs[at]);
                if pass >= self.warm_up * passes {
                    times[at].push(start.elapsed());
                }
            }
            check(&signs);
        }
        times.map(median)
    }
}

/// The middle of some times, in seconds.
pub fn median(mut times: Vec<Duration>) -> f64 {
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64()
}
