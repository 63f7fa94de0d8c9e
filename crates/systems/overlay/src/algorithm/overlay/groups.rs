//! Counting sort.

/// Items by group, in the order given: the place of each group's first item, the number of items; and all items.
pub(super) fn grouped<T: Copy>(
    groups: usize,
    blank: T,
    items: impl Iterator<Item = (u32, T)> + Clone,
) -> (Vec<u32>, Vec<T>) {
    // The starts of groups, two places later; filling a group makes its start that of the next one.
    let mut first = vec![0_u32; groups + 2];
    let mut count = 0;
    items.clone().for_each(|(group, _)| {
        first[group as usize + 2] += 1;
        count += 1;
    });
    for group in 2..first.len() {
        first[group] += first[group - 1];
    }
    let mut sorted = vec![blank; count];
    items.for_each(|(group, item)| {
        let place = &mut first[group as usize + 1];
        sorted[*place as usize] = item;
        *place += 1;
    });
    first.pop();
    (first, sorted)
}
