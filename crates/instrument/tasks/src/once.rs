//! Verdicts about one scene, found once: backends with equal answers and promises share them.
//!
//! Most backends give the same answer to most scenes, and exact judging of a whole answer takes longer than the answer.
//! A verdict follows from the scene and its key alone, so it does not matter which backend has found it.

use std::any::Any;
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::{Asked, Budget, Case, Stop, Task};

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
        key: impl FnOnce() -> K,
        find: impl FnOnce() -> Result<V, Stop>,
    ) -> Result<V, Stop> {
        if budget.thorough {
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
        let verdict = find()?;
        self.all().push(Box::new((key, budget, verdict.clone())));
        Ok(verdict)
    }
}

impl<T: Task> Case<'_, T> {
    /// Finds a verdict, or returns the verdict that was found for an equal key.
    ///
    /// `find` must read nothing but the case, the key and the [`Budget`]: no backend, no session. So the key holds the
    /// answer, with [`bits`] for coordinates, and the promises that the rules depend on. With plenty of time each
    /// verdict is found anew: such answers are large, and the keys would fill the memory.
    ///
    /// # Errors
    /// The error of `find`; it is not kept.
    pub fn once<K: PartialEq + Send + 'static, V: Clone + Send + 'static>(
        &self,
        asked: &Asked<'_>,
        key: impl FnOnce() -> K,
        find: impl FnOnce() -> Result<V, Stop>,
    ) -> Result<V, Stop> {
        self.verdicts.once(asked.budget, key, find)
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

    use super::*;

    #[test]
    fn a_verdict_is_found_once_for_each_key_and_budget() {
        let (verdicts, found) = (Verdicts::default(), Cell::new(0));
        let verdict = |budget, key: (bool, Vec<u64>)| {
            let find = || {
                found.set(found.get() + 1);
                Ok(format!("{key:?}"))
            };
            let told = verdicts.once(budget, || key.clone(), find).unwrap();
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
        let verdicts = Verdicts::default();
        assert_eq!(verdicts.once(Budget::QUICK, || 1, || Err::<u8, Stop>(Stop::Timeout)), Err(Stop::Timeout));
        assert_eq!(verdicts.once(Budget::QUICK, || 1, || Ok(2_u8)), Ok(2));
        assert_eq!(verdicts.once(Budget::QUICK, || 1, || Ok("of another type")), Ok("of another type"));
    }
}
