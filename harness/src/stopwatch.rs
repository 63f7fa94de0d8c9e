//! Costs: the wall time, and the processor time of all threads of the process.

use std::time::{Duration, Instant};

use cpu_time::ProcessTime;
use predicament_records::{CostRow, PlannedScene};

/// A stopwatch that runs from its creation.
pub struct Stopwatch {
    wall: Instant,
    cpu: Option<ProcessTime>,
}

/// A cost in microseconds.
#[derive(Clone, Copy, Default)]
pub struct Cost {
    pub wall_us: u64,
    pub cpu_us: u64,
}

impl Stopwatch {
    pub fn start() -> Stopwatch {
        Stopwatch { wall: Instant::now(), cpu: ProcessTime::try_now().ok() }
    }

    pub fn read(&self) -> Cost {
        let cpu = self.cpu.as_ref().and_then(|start| start.try_elapsed().ok());
        Cost { wall_us: micros(self.wall.elapsed()), cpu_us: micros(cpu.unwrap_or_default()) }
    }
}

impl Cost {
    /// The cost as the row of a scene on a backend.
    pub fn row(self, scene: &PlannedScene, backend: &str) -> CostRow {
        CostRow::new(scene, backend, self.wall_us, self.cpu_us)
    }

    /// The cost of work that another process did, for which only the wall time is known.
    pub fn of_another(self) -> Cost {
        Cost { cpu_us: self.cpu_us.max(self.wall_us), ..self }
    }

    /// The sum of two costs.
    pub fn plus(self, other: Cost) -> Cost {
        Cost { wall_us: self.wall_us + other.wall_us, cpu_us: self.cpu_us + other.cpu_us }
    }

    /// The share of a common cost for a task that took `part` of the `whole` time.
    pub fn share(self, part: Duration, whole: Duration) -> Cost {
        let share = |cost: u64| {
            let share = u128::from(cost) * part.as_nanos() / whole.as_nanos().max(1);
            u64::try_from(share).unwrap_or(u64::MAX)
        };
        Cost { wall_us: share(self.wall_us), cpu_us: share(self.cpu_us) }
    }
}

fn micros(time: Duration) -> u64 {
    u64::try_from(time.as_micros()).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_add_up_to_what_was_spent_together() {
        let spent = Cost { wall_us: 900, cpu_us: 1800 };
        let [one, two] = [200, 400].map(Duration::from_millis);
        let whole = one + two;
        let shares = [one, two].map(|part| spent.share(part, whole));
        assert_eq!(shares.map(|cost| cost.wall_us), [300, 600]);
        assert_eq!(shares.map(|cost| cost.cpu_us), [600, 1200]);
        assert_eq!(spent.share(Duration::ZERO, Duration::ZERO).cpu_us, 0);
    }
}
