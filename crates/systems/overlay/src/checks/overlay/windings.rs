//! Checks that the winding numbers of faces equal the winding numbers of the overlaid loops.

use std::collections::BTreeMap;

use super::{Check, Flaw, Flaws, Graph};

/// The winding numbers of faces that an overlay claims, and the passes that imply them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Windings {
    /// The passes of each of the graph's segments, for each operand: the number of times that its loops pass from the
    /// first end to the second, less the times back.
    pub passes: Vec<[i64; 2]>,
    /// The winding number of each face, for each operand.
    pub faces: Vec<[i32; 2]>,
    /// True if only the parity is known.
    pub modulo_two: bool,
}

impl Windings {
    /// The edges that the winding numbers contradict. Winding numbers must be zero outside, and change across an edge
    /// by the number of times that loops pass it. That determines them completely.
    #[must_use]
    pub fn flaws(&self, graph: &Graph) -> Vec<Flaw> {
        let mut flaws = Flaws::default();
        let sorted = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let mut passed: BTreeMap<[u32; 2], [i64; 2]> = BTreeMap::new();
        for (chain, times) in graph.chains.iter().zip(&self.passes) {
            for pair in chain.windows(2) {
                let way = if pair[0] < pair[1] { 1 } else { -1 };
                let sum = passed.entry(sorted([pair[0], pair[1]])).or_default();
                *sum = [0, 1].map(|operand| sum[operand] + way * times[operand]);
            }
        }
        let winding = |face: u32, operand: usize| self.faces.get(face as usize).map(|face| i64::from(face[operand]));
        let is_same = |a: i64, b: i64| a == b || self.modulo_two && (a - b) % 2 == 0;
        for operand in 0..2 {
            if winding(0, operand).is_some_and(|outside| outside != 0) {
                flaws.add(Check::Winding, || format!("operand {operand} has a winding number other than 0 outside"));
            }
            for (at, &ends) in graph.edges.iter().enumerate() {
                let times = passed.get(&sorted(ends)).map_or(0, |times| times[operand]);
                let wanted = if ends[0] < ends[1] { times } else { -times };
                let sides =
                    [2 * at, 2 * at + 1].map(|half| graph.face.get(half).and_then(|&face| winding(face, operand)));
                let [Some(left), Some(right)] = sides else {
                    flaws.add(Check::Winding, || format!("edge {at} has a side without a winding number"));
                    continue;
                };
                if !is_same(left - right, wanted) {
                    flaws.add(Check::Winding, || {
                        format!("operand {operand} passes edge {at} {wanted} times, between {left} and {right}")
                    });
                }
            }
        }
        flaws.0
    }

    /// The single nonzero winding number of an operand, so that its area is the area of its loops divided by this
    /// number; `None` if there are several, or none is known.
    #[must_use]
    pub fn only(&self, operand: usize) -> Option<i32> {
        let mut others = self.faces.iter().map(|face| face[operand]).filter(|&winding| winding != 0);
        let first = others.next().unwrap_or(1);
        (!self.modulo_two && others.all(|winding| winding == first)).then_some(first)
    }
}
