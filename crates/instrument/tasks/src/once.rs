//! Verdicts about one scene, found once: backends with equal answers and promises share them.
//!
//! Most backends give the same answer to most scenes, and exact judging of a whole answer takes longer than the answer.
//! A verdict follows from the scene and its key alone, so it does not matter which backend has found it.

use std::any::Any;
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::{Asked, Budget, Case, Stop, Task, Watch};

/// The verdicts about a scene, with their keys.
#[derive(Default)]
pub(crate) struct Verdicts(Mutex<Vec<Box<dyn Any + Send>>>);

/// A key, the sample sizes, and the verdict.
type Entry<K, V> = (K, Budget, V);

impl Verdicts {
    // A poisoned list is whole: entries are added, never changed.
    fn all(&self) -> MutexGuard<'_, Vec<Box<dyn Any + Send>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn once<K: PartialEq + Send + 'static, V: Clone + Send + 'static>(
        &self,
        budget: Budget,
        watch: &Watch<'_>,
        key: impl FnOnce() -> K,
        find: impl FnOnce() -> Result<V, Stop>,
    ) -> Result<V, Stop> {
        if budget.thorough || watch.is_limited() {
            return find();
        }
        let key = key();
        let known = self.all().iter().find_map(|entry| {
            let (of, with, verdict) = entry.downcast_ref::<Entry<K, V>>()?;
            (*of == key && *with == budget).then(|| verdict.clone())
        });
        if let Some(verdict) = known {
            return Ok(verdict);
        }
        // Without the lock: a thread that waits for it could be the one that has to find the verdict.
        let verdict = watch.for_all(find)?;
        self.all().push(Box::new((key, budget, verdict.clone())));
        Ok(verdict)
    }
}

impl<T: Task> Case<'_, T> {
    /// Finds a verdict, or returns the verdict that was found for an equal key.
    ///
    /// `find` must read nothing but the case, the key and the [`Budget`]: no backend, no session. So the key holds the
    /// answer, with [`bits`] for coordinates, and the promises that the rules depend on. With plenty of time each
    /// verdict is found anew: such answers are large, and the keys would fill the memory. Under a time limit as well:
    /// otherwise a backend could run out of time because no other backend had found the verdict.
    ///
    /// # Errors
    /// The error of `find`; it is not kept.
    pub fn once<K: PartialEq + Send + 'static, V: Clone + Send + 'static>(
        &self,
        asked: &Asked<'_>,
        key: impl FnOnce() -> K,
        find: impl FnOnce() -> Result<V, Stop>,
    ) -> Result<V, Stop> {
        self.verdicts.once(asked.budget, asked.watch, key, find)
    }
}

/// The bits of coordinates: as numbers, 0 and −0 are equal, but not as text.
#[must_use]
pub fn bits<const N: usize>(points: &[[f64; N]]) -> Vec<u64> {
    points.as_flattened().iter().map(|x| x.to_bits()).collect()
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::sync::atomic::AtomicBool;
    use std::thread::sleep;
    use std::time::Duration;

    use super::*;

    static RUNS_ON: AtomicBool = AtomicBool::new(false);

    fn watch(limit: Option<Duration>) -> Watch<'static> {
        Watch::new(&RUNS_ON, limit, &|_| ())
    }

    #[test]
    fn a_verdict_is_found_once_for_each_key_and_budget() {
        let (verdicts, found) = (Verdicts::default(), Cell::new(0));
        let verdict = |budget, key: (bool, Vec<u64>)| {
            let find = || {
                found.set(found.get() + 1);
                Ok(format!("{key:?}"))
            };
            let told = verdicts.once(budget, &watch(None), || key.clone(), find).unwrap();
            assert_eq!(told, format!("{key:?}"));
            found.get()
        };
        let [one, zero, minus] = [1.0, 0.0, -0.0].map(|x| bits(&[[x, 2.0]]));
        let few = Budget { relations: 1, ..Budget::QUICK };
        assert_eq!(verdict(Budget::QUICK, (true, one.clone())), 1);
        assert_eq!(verdict(Budget::QUICK, (true, one.clone())), 1);
        assert_eq!(verdict(Budget::QUICK, (false, one.clone())), 2, "another promise");
        assert_eq!(verdict(Budget::QUICK, (true, zero)), 3, "another answer");
        assert_eq!(verdict(Budget::QUICK, (true, minus)), 4, "another answer, as text");
        assert_eq!(verdict(few, (true, one.clone())), 5, "another sample");
        assert_eq!(verdict(Budget::FULL, (true, one.clone())), 6);
        assert_eq!(verdict(Budget::FULL, (true, one.clone())), 7, "nothing is kept");
        assert_eq!(verdict(Budget::QUICK, (true, one)), 7);
    }

    #[test]
    fn a_stop_is_not_a_verdict() {
        let (verdicts, watch) = (Verdicts::default(), watch(None));
        assert_eq!(verdicts.once(Budget::QUICK, &watch, || 1, || Err::<u8, Stop>(Stop::Timeout)), Err(Stop::Timeout));
        assert_eq!(verdicts.once(Budget::QUICK, &watch, || 1, || Ok(2_u8)), Ok(2));
        assert_eq!(verdicts.once(Budget::QUICK, &watch, || 1, || Ok("of another type")), Ok("of another type"));
    }

    #[test]
    fn the_time_of_a_verdict_is_not_the_time_of_the_backend_that_finds_it() {
        let nap = Duration::from_millis(2);
        let (verdicts, [first, second]) = (Verdicts::default(), [(); 2].map(|()| watch(None)));
        let inner = || {
            sleep(nap);
            Ok(1)
        };
        let outer = || {
            sleep(nap);
            verdicts.once(Budget::QUICK, &first, || "inner", inner)
        };
        let clock = std::time::Instant::now();
        assert_eq!(verdicts.once(Budget::QUICK, &first, || "outer", outer), Ok(1));
        let all = clock.elapsed();
        assert!(first.shared() >= 2 * nap && first.shared() <= all, "{:?} of {all:?}", first.shared());
        assert_eq!(verdicts.once(Budget::QUICK, &second, || "outer", || Ok(2)), Ok(1));
        assert_eq!(second.shared(), Duration::ZERO);
    }

    #[test]
    fn under_a_time_limit_no_verdict_is_shared() {
        let (verdicts, watch) = (Verdicts::default(), watch(Some(Duration::from_secs(60))));
        assert_eq!([1, 2].map(|k| verdicts.once(Budget::QUICK, &watch, || "key", || Ok(k))), [Ok(1), Ok(2)]);
        assert_eq!(watch.shared(), Duration::ZERO);
    }
}
