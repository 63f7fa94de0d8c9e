//! Long lists in JSON files, written one item after the other.

use serde::{Serialize, Serializer};

/// A list of items that are made while they are written: the list is never in memory.
pub struct Each<F>(
    /// Makes the items, from the first one on.
    pub F,
);

impl<F, I> Serialize for Each<F>
where
    F: Fn() -> I,
    I: Iterator<Item: Serialize>,
{
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_written_as_if_it_were_in_memory() {
        for items in [&[][..], &[1], &[1, 2, 3]] {
            let each = Each(|| items.iter().map(|item| 2 * item));
            let list: Vec<i32> = items.iter().map(|item| 2 * item).collect();
            assert_eq!(serde_json::to_string(&each).unwrap(), serde_json::to_string(&list).unwrap());
        }
    }
}
