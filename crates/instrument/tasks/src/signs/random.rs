//! `queries = { random = 1000, seed = 1 }`: queries of random vertices.

use predicament_corpus::Random;
use predicament_formats::{CorpusError, Field, MOST_COORDINATES, TableKind};
use predicament_predicates::{PredicateKind, Vertex};

static RANDOM: TableKind = TableKind::new("choice of queries", &["random", "seed"]);

/// The number of random queries, and the seed that selects them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct RandomQueries {
    count: usize,
    seed: u64,
}

impl RandomQueries {
    /// Reads the table.
    pub(super) fn read(field: &Field<'_, '_>, arity: usize) -> Result<RandomQueries, CorpusError> {
        let table = field.fields(&RANDOM)?;
        let most = u64::try_from(MOST_COORDINATES / arity).unwrap_or(u64::MAX);
        let count = table.required("random")?.count(1..=most)?;
        let seed = table.integer_or("seed", 0, 0..=u64::MAX)?;
        table.finish()?;
        Ok(RandomQueries { count, seed })
    }

    /// The vertices of all queries, one query after the other: `arity` different numbers below `vertices` each.
    ///
    /// The same seed gives the same queries on every machine. Each vertex is drawn from all vertices, and drawn again
    /// if the query already has it, so all queries are equally likely.
    ///
    /// # Panics
    /// If there are fewer vertices than a query takes.
    pub(super) fn draw(self, kind: PredicateKind, vertices: usize) -> Vec<usize> {
        let arity = kind.arity();
        assert!(arity <= vertices, "{vertices} vertices for queries of {arity}");
        let mut random = Random::new("queries", kind.name(), self.seed);
        let last = i64::try_from(vertices - 1).unwrap_or(i64::MAX);
        let mut all = Vec::with_capacity(self.count * arity);
        for _ in 0..self.count {
            let start = all.len();
            while all.len() < start + arity {
                let vertex = usize::try_from(random.integer(0, last)).expect("from 0");
                if !all[start..].contains(&vertex) {
                    all.push(vertex);
                }
            }
        }
        all
    }
}

/// The vertex with a number, where the points are numbered before the constructed vertices.
pub(super) fn vertex(number: usize, points: usize) -> Vertex {
    number.checked_sub(points).map_or_else(|| Vertex::input(number), Vertex::constructed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_vertex_is_twice_in_a_query_and_all_are_drawn() {
        for (kind, vertices) in [
            (PredicateKind::Compare, 2),
            (PredicateKind::Orient2d, 3),
            (PredicateKind::Insphere, 5),
            (PredicateKind::Incircle, 40),
        ] {
            let drawn = RandomQueries { count: 500, seed: 1 }.draw(kind, vertices);
            assert_eq!(drawn.len(), 500 * kind.arity());
            for query in drawn.chunks(kind.arity()) {
                let mut sorted = query.to_vec();
                sorted.sort_unstable();
                sorted.dedup();
                assert_eq!(sorted.len(), kind.arity(), "{query:?}");
            }
            let counts = drawn.iter().fold(vec![0; vertices], |mut counts, &vertex| {
                counts[vertex] += 1;
                counts
            });
            assert!(counts.iter().all(|&count| count > 0), "{counts:?}");
        }
    }

    #[test]
    fn the_seed_decides() {
        let draw = |count, seed| RandomQueries { count, seed }.draw(PredicateKind::Orient2d, 1000);
        assert_eq!(draw(20, 7), draw(20, 7));
        assert_ne!(draw(20, 7), draw(20, 8));
        assert_eq!(draw(30, 7)[..60], draw(20, 7), "more queries begin with the same");
        assert_ne!(RandomQueries { count: 20, seed: 7 }.draw(PredicateKind::Incircle, 1000)[..60], draw(20, 7));
    }

    /// Ids of scenes depend on it.
    #[test]
    fn the_draw_is_pinned() {
        let drawn = RandomQueries { count: 3, seed: 1 }.draw(PredicateKind::Orient2d, 1000);
        assert_eq!(drawn, PINNED);
    }

    const PINNED: [usize; 9] = [32, 942, 131, 352, 483, 53, 783, 89, 400];
}
