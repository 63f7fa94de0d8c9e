//! Moves of queries, and of points from one scene to another.
//!
//! Simulation of Simplicity depends on the order of the vertices, and a query's answer may depend on the order of its
//! arguments.

use predicament_corpus::{Items, Spelled};
use predicament_predicates::Vertex;

use super::Draft;
use crate::{drop_points, drop_unnamed};

/// The maximum number of points and rows of a scene: more cost time and show little.
pub(in crate::hunt) const MOST_ROWS: usize = 40;
/// The maximum number of items in a list to which a move may add.
const MOST_ITEMS: usize = 12;

/// A random list of tuples and a random tuple in it, as indices.
fn tuple(draft: &mut Draft<'_>) -> Option<(usize, usize)> {
    let lists: Vec<usize> = (0..draft.spelled.lists.len())
        .filter(|&list| {
            let items = &draft.spelled.lists[list].items;
            matches!(items, Items::Tuples(_) | Items::Labelled { .. } | Items::Loops(_)) && !items.is_empty()
        })
        .collect();
    if lists.is_empty() {
        return None;
    }
    let list = lists[draft.below(lists.len())];
    let items = draft.spelled.lists[list].items.len();
    Some((list, draft.below(items)))
}

fn vertices(spelled: &mut Spelled, list: usize, item: usize) -> Option<&mut Vec<Vertex>> {
    match &mut spelled.lists[list].items {
        Items::Tuples(all) | Items::Loops(all) | Items::Labelled { tuples: all, .. } => all.get_mut(item),
        _ => None,
    }
}

/// Exchanges two vertices of an item.
pub(super) fn arguments_exchanged(draft: &mut Draft<'_>) -> bool {
    let Some((list, item)) = tuple(draft) else { return false };
    let length = draft.spelled.lists[list].items.vertices(item).len();
    let [a, b] = [draft.below(length), draft.below(length)];
    let Some(one) = vertices(&mut draft.spelled, list, item).filter(|_| a != b) else { return false };
    one.swap(a, b);
    true
}

/// Exchanges the coordinates of two points, so that their order changes.
pub(super) fn points_exchanged(draft: &mut Draft<'_>) -> bool {
    let count = draft.spelled.points.len();
    if count < 2 {
        return false;
    }
    let a = draft.below(count);
    let b = (a + 1 + draft.below(count - 1)) % count;
    draft.spelled.points.swap(a, b);
    // Items that name the points are renamed too, so that only the order changes.
    if draft.random.one_in(2) {
        let exchange = |v: &mut Vertex| {
            if *v == Vertex::input(a) {
                *v = Vertex::input(b);
            } else if *v == Vertex::input(b) {
                *v = Vertex::input(a);
            }
        };
        draft.spelled.lists.iter_mut().for_each(|list| list.items.vertices_mut().for_each(exchange));
    }
    true
}

/// Replaces a vertex in an item by another.
pub(super) fn other_vertex(draft: &mut Draft<'_>) -> bool {
    let count = draft.spelled.points.len();
    let Some((list, item)) = tuple(draft).filter(|_| count > 0) else { return false };
    let length = draft.spelled.lists[list].items.vertices(item).len();
    let (at, new) = (draft.below(length), Vertex::input(draft.below(count)));
    let Some(one) = vertices(&mut draft.spelled, list, item) else { return false };
    if one.contains(&new) {
        return false;
    }
    one[at] = new;
    true
}

/// Adds a point at the position of another; some item names it instead.
pub(super) fn point_twice(draft: &mut Draft<'_>) -> bool {
    let count = draft.spelled.points.len();
    if count == 0 || draft.rows() >= MOST_ROWS {
        return false;
    }
    let at = draft.below(count);
    let (point, new) = (draft.spelled.points[at].clone(), Vertex::input(count));
    draft.spelled.points.push(point);
    let Some((list, item)) = tuple(draft) else { return true };
    let length = draft.spelled.lists[list].items.vertices(item).len();
    let place = draft.below(length);
    if let Some(one) = vertices(&mut draft.spelled, list, item) {
        one[place] = new;
    }
    true
}

/// Adds a copy of an item, with two vertices exchanged.
pub(super) fn item_twice(draft: &mut Draft<'_>) -> bool {
    let Some((list, item)) = tuple(draft) else { return false };
    let Items::Tuples(all) = &mut draft.spelled.lists[list].items else { return false };
    if all.len() >= MOST_ITEMS {
        return false;
    }
    let mut copy = all[item].clone();
    let length = copy.len();
    let [a, b] = [draft.below(length), draft.below(length)];
    copy.swap(a, b);
    let Items::Tuples(all) = &mut draft.spelled.lists[list].items else { return false };
    all.push(copy);
    true
}

/// Removes a point, with all items that name it, unless a list becomes empty.
pub(super) fn point_less(draft: &mut Draft<'_>) -> bool {
    let count = draft.spelled.points.len();
    if count < 2 {
        return false;
    }
    let without = draft.below(count);
    let keep: Vec<bool> = (0..count).map(|at| at != without).collect();
    let left = drop_unnamed(&drop_points(&draft.spelled, &keep));
    if left.lists.iter().all(|list| list.items.is_empty()) {
        return false;
    }
    draft.spelled = left;
    true
}

/// Replaces some rows by rows of the other scene.
pub(super) fn points_of_mate(draft: &mut Draft<'_>) -> bool {
    let Some(mate) = draft.mate else { return false };
    let theirs: Vec<Vec<f64>> = mate.rows().into_iter().cloned().collect();
    let mut changed = false;
    for (at, row) in theirs.iter().enumerate().take(draft.rows()) {
        if draft.row(at).len() == row.len() && draft.random.one_in(2) {
            changed |= draft.put(at, row);
        }
    }
    changed
}

/// Replaces one axis by that of the other scene's points.
pub(super) fn axis_of_mate(draft: &mut Draft<'_>) -> bool {
    let Some(mate) = draft.mate else { return false };
    let axis = draft.below(3);
    let theirs: Vec<Vec<f64>> = mate.rows().into_iter().cloned().collect();
    let mut changed = false;
    for (at, row) in theirs.iter().enumerate().take(draft.rows()) {
        let mut own = draft.row(at);
        if let (Some(x), Some(&new)) = (own.get_mut(axis), row.get(axis)) {
            *x = new;
            changed |= draft.put(at, &own);
        }
    }
    changed
}

/// Combines both scenes in one, if they have the same keys and are small.
pub(super) fn beside_mate(draft: &mut Draft<'_>) -> bool {
    let Some(mate) = draft.mate else { return false };
    let own = &mut draft.spelled;
    let fits = own.points.len() + mate.points.len() <= MOST_ROWS / 2
        && own.words == mate.words
        && own.constructions.is_empty()
        && mate.constructions.is_empty()
        && own.lists.iter().map(|list| list.key).eq(mate.lists.iter().map(|list| list.key))
        && own.points.first().map(Vec::len) == mate.points.first().map(Vec::len);
    if !fits || mate.points.is_empty() {
        return false;
    }
    let offset = own.points.len();
    let renamed = |one: &Vec<Vertex>| one.iter().map(|v| Vertex::input(v.index() + offset)).collect::<Vec<_>>();
    for (list, theirs) in own.lists.iter_mut().zip(&mate.lists) {
        match (&mut list.items, &theirs.items) {
            (Items::Tuples(own), Items::Tuples(theirs)) | (Items::Loops(own), Items::Loops(theirs)) => {
                own.extend(theirs.iter().map(renamed));
            }
            (Items::Vertices(own), Items::Vertices(theirs)) => own.extend(renamed(theirs)),
            _ => return false,
        }
    }
    own.points.extend(mate.points.iter().cloned());
    true
}
