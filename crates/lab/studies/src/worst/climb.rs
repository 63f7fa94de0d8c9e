//! Hill climbing: one change at a time, kept if the value is not lower.

use predicament_corpus::Random;

/// The largest value found, by `climbs` climbs of `steps` steps, and its place.
///
/// `start` makes a start, `change` one change; `value` is `None` for a forbidden place.
pub(super) fn climb<P: Clone>(
    random: &mut Random,
    [climbs, steps]: [u64; 2],
    start: impl Fn(&mut Random) -> P,
    change: impl Fn(&mut Random, &P) -> P,
    value: impl Fn(&P) -> Option<f64>,
) -> Option<(f64, P)> {
    let mut best: Option<(f64, P)> = None;
    for _ in 0..climbs {
        let mut place = start(random);
        let Some(mut height) = value(&place) else { continue };
        for _ in 0..steps {
            let other = change(random, &place);
            if let Some(reached) = value(&other).filter(|reached| *reached >= height) {
                (place, height) = (other, reached);
            }
        }
        if best.as_ref().is_none_or(|(largest, _)| height > *largest) {
            best = Some((height, place));
        }
    }
    best
}
