//! Timing of several engines in turns on the same queries, so that other load on the machine affects all alike.

use std::time::{Duration, Instant};

use predicament_predicates::Sign;

/// A name, and a function that answers a pass of queries from a first query on.
pub type Engine<'a> = (&'a str, &'a dyn Fn(usize, &mut [Sign]));

/// The parameters of alternating timings.
pub struct Turns {
    /// The number of queries.
    pub queries: usize,
    /// The number of queries that an engine answers before the next engine's turn.
    pub pass: usize,
    /// The number of timed rounds over all queries.
    pub rounds: usize,
    /// The number of untimed rounds before, in which memory is still new to the processor.
    pub warm_up: usize,
}

impl Turns {
    /// The median time of each engine for a pass, in seconds.
    ///
    /// In each turn every engine answers another pass: after the same pass, the points that an engine reads would be
    /// in the caches already. After each round, `check` gets the signs of all engines for all queries.
    pub fn medians<const N: usize>(&self, engines: &[Engine; N], mut check: impl FnMut(&[Vec<Sign>; N])) -> [f64; N] {
        let mut times = [const { Vec::new() }; N];
        let mut signs = [(); N].map(|()| vec![Sign::Zero; self.queries]);
        let passes = self.queries / self.pass;
        for round in 0..self.warm_up + self.rounds {
            for pass in 0..passes {
                for turn in 0..N {
                    let at = (pass + turn) % N;
                    let first = (pass + at * passes / N) % passes * self.pass;
                    let out = &mut signs[at][first..first + self.pass];
                    let start = Instant::now();
                    engines[at].1(first, out);
                    if round >= self.warm_up {
                        times[at].push(start.elapsed());
                    }
                }
            }
            check(&signs);
        }
        times.map(median)
    }
}

/// The median of some times, in seconds.
pub fn median(mut times: Vec<Duration>) -> f64 {
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64()
}
