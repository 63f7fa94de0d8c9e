//! Right answers with planted faults: they test the checks that no backend's fault reaches.

use super::{Chains, Contradiction, Snap2d};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<Snap2d>> {
    vec![
        Spoiled::new(
            "snap-ends-early",
            "the last pixel of each chain is lost",
            "exact",
            &[(Class::Topology, "ends")],
            |_, _, answer: &mut Chains| {
                for chain in answer.snapped.chains.iter_mut().filter(|chain| chain.len() > 1) {
                    chain.pop();
                }
            },
        ),
        Spoiled::new(
            "snap-moves-a-pixel",
            "the first hot pixel is far away",
            "exact",
            &[(Class::Topology, "hot pixels only")],
            |_, _, answer: &mut Chains| {
                if let Some([x, _]) = answer.snapped.pixels.first_mut() {
                    *x -= 1_000_000;
                }
            },
        ),
        Spoiled::new(
            "snap-makes-a-detour",
            "each chain passes the last hot pixel",
            "exact",
            &[(Class::Topology, "own hot pixels only")],
            |_, _, answer: &mut Chains| {
                let last = u32::try_from(answer.snapped.pixels.len().saturating_sub(1)).unwrap_or(0);
                for chain in answer.snapped.chains.iter_mut().filter(|chain| !chain.contains(&last)) {
                    chain.insert(1.min(chain.len()), last);
                }
            },
        ),
        Spoiled::new(
            "snap-goes-back",
            "each chain goes from its first pixel to its last, back, and to the last again",
            "exact",
            &[(Class::Topology, "one way")],
            |_, _, answer: &mut Chains| {
                for chain in answer.snapped.chains.iter_mut().filter(|chain| chain.len() > 1) {
                    let (first, last) = (chain[0], chain[chain.len() - 1]);
                    chain.extend([first, last]);
                }
            },
        ),
        Spoiled::new(
            "snap-gives-up",
            "segments that cross are reported to have no point in common",
            "exact",
            &[(Class::Topology, "segments that cross have a point in common")],
            |_, _, answer: &mut Chains| answer.broken = Some(Contradiction::NoPoint),
        ),
        Spoiled::new(
            "snap-goes-straight",
            "each chain goes from its first pixel straight to its last",
            "exact",
            &[
                (Class::Topology, "all hot pixels"),
                (Class::Topology, "no vertex near an edge"),
                (Class::Topology, "no new crossing"),
            ],
            |_, _, answer: &mut Chains| {
                for chain in answer.snapped.chains.iter_mut().filter(|chain| chain.len() > 2) {
                    chain.drain(1..chain.len() - 1);
                }
            },
        ),
    ]
}
