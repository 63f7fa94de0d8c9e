//! Removal of the parts of a scene that a finding does not need.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Items, Spelled};
use predicament_predicates::Vertex;

use super::{End, Search};
use crate::edit::{drop_constructions, drop_points, drop_unnamed, merge};

/// The maximum number of points of a scene for which merging of all neighbours is tried.
const MOST_MERGED: usize = 200;

/// Tries the vertices that the finding names alone, then with the items around them, then with the items around those.
pub(super) fn focus(search: &mut Search<'_>, named: &[Vertex]) -> Result<(), End> {
    if named.is_empty() {
        return Ok(());
    }
    let start = search.best.clone();
    let mut centre: BTreeSet<Vertex> = named.iter().copied().collect();
    for v in named.iter().filter_map(|v| v.construction()) {
        centre.extend(start.constructions.get(v).into_iter().flat_map(|one| one.flats().flatten().copied()));
    }
    for _ in 0..4 {
        for only_within in [true, false] {
            let around = around(&start, &centre, only_within);
            if search.try_one(around)? {
                return Ok(());
            }
        }
        // All vertices next to the current ones.
        let mut wider = centre.clone();
        for list in &start.lists {
            for corners in (0..list.items.len()).map(|at| list.items.vertices(at)) {
                if corners.iter().any(|v| centre.contains(v)) {
                    wider.extend(corners);
                }
            }
        }
        if wider.len() == centre.len() || 2 * wider.len() > start.points.len() {
            return Ok(());
        }
        centre = wider;
    }
    Ok(())
}

/// The items that name these vertices (all of their corners, or some), and the points that these items name. Lists
/// without vertices stay.
fn around(start: &Spelled, centre: &BTreeSet<Vertex>, only_within: bool) -> Spelled {
    let mut left = start.clone();
    let mut stay: Vec<bool> = (0..left.points.len()).map(|at| centre.contains(&Vertex::input(at))).collect();
    for list in &mut left.lists {
        if matches!(list.items, Items::Rows(_) | Items::Polygons(_)) {
            continue;
        }
        let keep: Vec<bool> = (0..list.items.len())
            .map(|at| {
                let corners = list.items.vertices(at);
                let mut within = corners.iter().map(|v| centre.contains(v));
                if only_within { within.all(|is| is) } else { within.any(|is| is) }
            })
            .collect();
        list.items.keep(|at| keep[at]);
    }
    for (stay, named) in stay.iter_mut().zip(left.named()) {
        *stay |= named;
    }
    let constructions: Vec<bool> =
        (0..left.constructions.len()).map(|at| centre.contains(&Vertex::constructed(at))).collect();
    let mut stay_for_constructions = stay.clone();
    for one in left.constructions.iter().zip(&constructions).filter(|(_, is)| **is).map(|(one, _)| one) {
        for v in one.flats().flatten().filter(|v| !v.is_constructed()) {
            stay_for_constructions[v.index()] = true;
        }
    }
    drop_points(&drop_constructions(&left, &constructions), &stay_for_constructions)
}

/// Removes items, points with all items that name them, constructions, and corners.
pub(super) fn drop_all(search: &mut Search<'_>) -> Result<(), End> {
    search.try_one(drop_unnamed(&search.best))?;
    drop_components(search)?;
    for list in 0..search.best.lists.len() {
        let count = move |spelled: &Spelled| spelled.lists[list].items.len();
        let without = move |spelled: &Spelled, keep: &[bool]| {
            let mut left = spelled.clone();
            left.lists[list].items.keep(|at| keep[at]);
            left
        };
        // With the points that only these items name, or without them.
        let with_points = move |spelled: &Spelled, keep: &[bool]| drop_unnamed(&without(spelled, keep));
        let names = !matches!(search.best.lists[list].items, Items::Rows(_) | Items::Polygons(_));
        if names {
            search.leave_out(count(&search.best), &with_points, &count)?;
        }
        search.leave_out(count(&search.best), &without, &count)?;
    }
    search.leave_out(search.best.points.len(), &drop_points, &|spelled| spelled.points.len())?;
    search.leave_out(search.best.constructions.len(), &drop_constructions, &|spelled| spelled.constructions.len())?;
    search.try_one(drop_unnamed(&search.best))?;
    drop_corners(search)
}

/// Removes connected items together: no single triangle of a closed mesh can be removed, but a component can.
fn drop_components(search: &mut Search<'_>) -> Result<(), End> {
    for list in 0..search.best.lists.len() {
        let count = move |spelled: &Spelled| components(&spelled.lists[list].items).1;
        let without = move |spelled: &Spelled, keep: &[bool]| {
            let (component, _) = components(&spelled.lists[list].items);
            let mut left = spelled.clone();
            left.lists[list].items.keep(|at| keep.get(component[at]).copied().unwrap_or(true));
            drop_unnamed(&left)
        };
        let parts = count(&search.best);
        if parts > 1 && parts < search.best.lists[list].items.len() {
            search.leave_out(parts, &without, &count)?;
        }
    }
    Ok(())
}

/// For each item the number of its component, in the order of their first items, and the number of components. Items
/// with a common vertex are connected.
fn components(items: &Items) -> (Vec<usize>, usize) {
    let mut parent: Vec<usize> = (0..items.len()).collect();
    fn root(parent: &mut [usize], mut at: usize) -> usize {
        while parent[at] != at {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        at
    }
    let mut first: BTreeMap<Vertex, usize> = BTreeMap::new();
    for at in 0..items.len() {
        for &v in items.vertices(at) {
            let other = *first.entry(v).or_insert(at);
            let (one, other) = (root(&mut parent, at), root(&mut parent, other));
            parent[one.max(other)] = one.min(other);
        }
    }
    let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
    let component = (0..items.len()).map(|at| {
        let next = numbers.len();
        *numbers.entry(root(&mut parent, at)).or_insert(next)
    });
    let component: Vec<usize> = component.collect();
    (component, numbers.len())
}

/// Removes single corners of loops, rings, and points of rings.
fn drop_corners(search: &mut Search<'_>) -> Result<(), End> {
    for list in 0..search.best.lists.len() {
        let mut at = (0, 0, 0);
        while let Some((left, next)) = without_corner(&search.best, list, at) {
            let went = left.map_or(Ok(false), |left| search.try_one(left))?;
            // After a removal, the next corner has this index.
            at = if went { at } else { next };
        }
    }
    Ok(())
}

/// The position of a corner in a list: item, ring, corner.
type Place = (usize, usize, usize);

/// The scene without the corner at a position, if there is one, and the next position; `None` after the last.
fn without_corner(spelled: &Spelled, list: usize, (item, ring, corner): Place) -> Option<(Option<Spelled>, Place)> {
    let mut left = spelled.clone();
    let next_item = (item + 1, 0, 0);
    match &mut left.lists[list].items {
        Items::Loops(loops) => {
            let one = loops.get_mut(item)?;
            if corner >= one.len() || one.len() <= 3 {
                return Some((None, next_item));
            }
            one.remove(corner);
            Some((Some(drop_unnamed(&left)), (item, 0, corner + 1)))
        }
        // Loops with labels; if these are triangles, no corner can be removed.
        Items::Labelled { tuples, .. } => {
            let one = tuples.get_mut(item)?;
            if corner >= one.len() || one.len() <= 3 {
                return Some((None, next_item));
            }
            one.remove(corner);
            Some((Some(drop_unnamed(&left)), (item, 0, corner + 1)))
        }
        Items::Polygons(polygons) => {
            let rings = polygons.get_mut(item)?;
            let Some(points) = rings.get_mut(ring) else { return Some((None, next_item)) };
            // The whole ring first, then each of its points.
            if corner == 0 {
                let next = (item, ring, 1);
                if rings.len() < 2 {
                    return Some((None, next));
                }
                rings.remove(ring);
                return Some((Some(left), next));
            }
            if corner > points.len() || points.len() <= 3 {
                return Some((None, (item, ring + 1, 0)));
            }
            points.remove(corner - 1);
            Some((Some(left), (item, ring, corner + 1)))
        }
        _ => None,
    }
}

/// Merges vertices with neighbours: an edge of a closed mesh can be removed where none of its triangles can.
pub(super) fn merge_all(search: &mut Search<'_>) -> Result<(), End> {
    if search.best.points.len() > MOST_MERGED {
        return Ok(());
    }
    let mut from = search.best.points.len();
    while from > 0 {
        from -= 1;
        let merged = neighbours(&search.best, from);
        for into in merged {
            if search.try_one(drop_unnamed(&merge(&search.best, from, into)))? {
                from = from.min(search.best.points.len());
                break;
            }
        }
    }
    Ok(())
}

/// The points that share an item or construction with this one.
fn neighbours(spelled: &Spelled, point: usize) -> BTreeSet<usize> {
    let this = Vertex::input(point);
    let items = spelled.lists.iter().flat_map(|list| (0..list.items.len()).map(|at| list.items.vertices(at)));
    let together = items.filter(|corners| corners.contains(&this)).flatten();
    together.filter(|v| **v != this && !v.is_constructed()).map(|v| v.index()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_with_a_vertex_in_common_hang_together() {
        let tuple = |corners: [usize; 3]| corners.map(Vertex::input).to_vec();
        let items = Items::Tuples(vec![tuple([0, 1, 2]), tuple([5, 6, 7]), tuple([2, 3, 4]), tuple([7, 8, 4])]);
        assert_eq!(components(&items), (vec![0, 0, 0, 0], 1));
        let items = Items::Tuples(vec![tuple([0, 1, 2]), tuple([5, 6, 7]), tuple([2, 3, 4]), tuple([7, 8, 9])]);
        assert_eq!(components(&items), (vec![0, 1, 0, 1], 2));
        assert_eq!(components(&Items::Rows(vec![vec![0.0], vec![1.0]])), (vec![0, 1], 2));
    }
}
