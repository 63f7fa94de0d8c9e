//! Edits of a scene that is written out: vertices are removed, merged and renumbered.
//!
//! The remaining vertices keep their order, because Simulation of Simplicity perturbs them by it.

use predicament_corpus::{Items, Spelled};
use predicament_predicates::{Construction, Vertex};

/// Removes points, with all constructions, items and corners that name them.
///
/// `keep` has an entry for each point.
#[must_use]
pub fn drop_points(spelled: &Spelled, keep: &[bool]) -> Spelled {
    let is_kept = |v: Vertex| v.is_constructed() || keep.get(v.index()).copied().unwrap_or(false);
    let constructions: Vec<bool> =
        spelled.constructions.iter().map(|one| one.flats().flatten().all(|&v| is_kept(v))).collect();
    restrict(spelled, keep, &constructions)
}

/// Removes constructions, with all items that name them.
///
/// `keep` has an entry for each construction.
#[must_use]
pub fn drop_constructions(spelled: &Spelled, keep: &[bool]) -> Spelled {
    restrict(spelled, &vec![true; spelled.points.len()], keep)
}

/// Removes the points that nothing names.
#[must_use]
pub fn drop_unnamed(spelled: &Spelled) -> Spelled {
    drop_points(spelled, &spelled.named())
}

/// Keeps only the selected items of the list with this index.
#[must_use]
pub fn keep_items(spelled: &Spelled, list: usize, keep: impl FnMut(usize) -> bool) -> Spelled {
    let mut left = spelled.clone();
    left.lists[list].items.keep(keep);
    left
}

/// Replaces one point by another: each item and construction that names `from` names `into`. Items that then name a
/// vertex twice are removed, loops lose the corner, and `from` is removed.
#[must_use]
pub fn merge(spelled: &Spelled, from: usize, into: usize) -> Spelled {
    let mut merged = spelled.clone();
    let (old, new) = (Vertex::input(from), Vertex::input(into));
    let exchange = |v: &mut Vertex| {
        if *v == old {
            *v = new;
        }
    };
    let named: Vec<Vec<bool>> = merged
        .lists
        .iter()
        .map(|list| (0..list.items.len()).map(|at| list.items.vertices(at).contains(&old)).collect())
        .collect();
    for (list, named) in merged.lists.iter_mut().zip(&named) {
        list.items.vertices_mut().for_each(exchange);
        if let Items::Loops(loops) = &mut list.items {
            for (one, _) in loops.iter_mut().zip(named).filter(|(_, named)| **named) {
                one.dedup();
                if one.len() > 1 && one.first() == one.last() {
                    one.pop();
                }
            }
        }
        let keep: Vec<bool> = (0..list.items.len())
            .map(|at| {
                let corners = list.items.vertices(at);
                let short = matches!(list.items, Items::Loops(_)) && corners.len() < 3;
                !(named[at] && (short || has_twice(corners)))
            })
            .collect();
        list.items.keep(|at| keep[at]);
    }
    for one in &mut merged.constructions {
        *one = renamed(one, &|v| if v == old { new } else { v });
    }
    let mut keep = vec![true; merged.points.len()];
    keep[from] = false;
    drop_points(&merged, &keep)
}

fn has_twice(corners: &[Vertex]) -> bool {
    corners.iter().enumerate().any(|(at, v)| corners[..at].contains(v))
}

/// The scene restricted to these points and constructions.
fn restrict(spelled: &Spelled, points: &[bool], constructions: &[bool]) -> Spelled {
    let [point_numbers, construction_numbers] = [numbers(points), numbers(constructions)];
    let number = |v: Vertex| match v.construction() {
        None => point_numbers.get(v.index()).copied().flatten().map(Vertex::input),
        Some(index) => construction_numbers.get(index).copied().flatten().map(Vertex::constructed),
    };
    let mut left = spelled.clone();
    left.points = kept(&spelled.points, points);
    left.constructions = kept(&spelled.constructions, constructions);
    for one in &mut left.constructions {
        *one = renamed(one, &|v| number(v).expect("constructions that stay name points that stay"));
    }
    for list in &mut left.lists {
        if let Items::Loops(loops) = &mut list.items {
            loops.iter_mut().for_each(|one| one.retain(|&v| number(v).is_some()));
        }
        let keep: Vec<bool> = (0..list.items.len())
            .map(|at| {
                let corners = list.items.vertices(at);
                let least = if matches!(list.items, Items::Loops(_)) { 3 } else { 0 };
                corners.len() >= least && corners.iter().all(|&v| number(v).is_some())
            })
            .collect();
        list.items.keep(|at| keep[at]);
        list.items.vertices_mut().for_each(|v| *v = number(*v).expect("items that stay name vertices that stay"));
    }
    left
}

/// For each index, its new number among the kept ones.
fn numbers(keep: &[bool]) -> Vec<Option<usize>> {
    let mut next = 0;
    keep.iter().map(|&is_kept| is_kept.then(|| (next, next += 1).0)).collect()
}

fn kept<T: Clone>(all: &[T], keep: &[bool]) -> Vec<T> {
    all.iter().zip(keep).filter(|(_, keep)| **keep).map(|(one, _)| one.clone()).collect()
}

fn renamed(construction: &Construction, name: &dyn Fn(Vertex) -> Vertex) -> Construction {
    match construction {
        Construction::Ssi(lines) => Construction::Ssi(lines.map(|line| line.map(name))),
        Construction::Lpi { line, plane } => Construction::Lpi { line: line.map(name), plane: plane.map(name) },
        Construction::Tpi(planes) => Construction::Tpi(planes.map(|plane| plane.map(name))),
        Construction::Ratio { ends, share } => Construction::Ratio { ends: ends.map(name), share: *share },
    }
}
