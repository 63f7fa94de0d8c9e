//! Removals: items, components of a mesh, loops, points; and points that take the place of their neighbours.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use super::sketch::{Form, Shape, Sketch};

/// Counts the pieces of files that a removal can take.
pub(super) type Count = fn(&[Sketch]) -> usize;
/// The files without a range of these pieces.
pub(super) type Without = fn(&[Sketch], &Range<usize>) -> Vec<Sketch>;

/// Keeps the items for which `keep` returns true; it takes the file and the item.
fn items_where(files: &[Sketch], mut keep: impl FnMut(usize, usize) -> bool) -> Vec<Sketch> {
    let kept = |(file, sketch): (usize, &Sketch)| {
        let items = sketch.items.iter().enumerate().filter(|(at, _)| keep(file, *at)).map(|(_, item)| item.clone());
        Sketch { items: items.collect(), form: sketch.form.clone(), points: sketch.points.clone() }
    };
    files.iter().enumerate().map(kept).collect()
}

pub(super) fn items(files: &[Sketch]) -> usize {
    files.iter().map(|sketch| sketch.items.len()).sum()
}

pub(super) fn without_items(files: &[Sketch], range: &Range<usize>) -> Vec<Sketch> {
    let mut at = 0;
    items_where(files, |_, _| (!range.contains(&at), at += 1).0)
}

/// The number of the component of each item, by file, and the number of components. Items with a common point are
/// connected.
fn components(files: &[Sketch]) -> (Vec<Vec<usize>>, usize) {
    fn root(parent: &mut [usize], mut at: usize) -> usize {
        while parent[at] != at {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        at
    }
    let mut before = 0;
    let mut all = Vec::new();
    for sketch in files {
        let corners = |item: &Arc<Vec<Shape>>| item.iter().flat_map(|s| s.loops.clone()).flatten().collect::<Vec<_>>();
        let mut parent: Vec<usize> = (0..sketch.points.len()).collect();
        for item in &sketch.items {
            for pair in corners(item).windows(2) {
                let (one, other) = (root(&mut parent, pair[0]), root(&mut parent, pair[1]));
                parent[one.max(other)] = one.min(other);
            }
        }
        let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
        let number = |item: &Arc<Vec<Shape>>| {
            let next = before + numbers.len();
            let first = corners(item).first().map_or(usize::MAX, |&corner| root(&mut parent, corner));
            *numbers.entry(first).or_insert(next)
        };
        all.push(sketch.items.iter().map(number).collect());
        before += numbers.len();
    }
    (all, before)
}

/// The number of components, or 0 if each is one item.
pub(super) fn parts(files: &[Sketch]) -> usize {
    let parts = components(files).1;
    if parts < items(files) { parts } else { 0 }
}

pub(super) fn without_parts(files: &[Sketch], range: &Range<usize>) -> Vec<Sketch> {
    let (component, _) = components(files);
    items_where(files, |file, item| !range.contains(&component[file][item]))
}

/// Changes the loops of all items by a function that takes the number of the file and the loop. Changed loops with too
/// few corners go, and so do shapes without loops and items without shapes.
fn changed(files: &[Sketch], mut with: impl FnMut(usize, &[usize]) -> Option<Vec<usize>>) -> Vec<Sketch> {
    let mut files = files.to_vec();
    for (number, file) in files.iter_mut().enumerate() {
        file.items.retain_mut(|item| {
            let mut shapes: Vec<Shape> = Vec::new();
            for shape in item.iter() {
                let loops = shape.loops.iter().filter_map(|one| {
                    let after = with(number, one)?;
                    (after == *one || after.len() >= shape.kind.least()).then_some(after)
                });
                shapes.push(Shape { kind: shape.kind, loops: loops.collect() });
            }
            if *shapes != **item {
                shapes.retain(|shape| !shape.loops.is_empty());
                *item = Arc::new(shapes);
            }
            !item.is_empty()
        });
    }
    files
}

/// The number of loops, or 0 if each item has one.
pub(super) fn loops(files: &[Sketch]) -> usize {
    let shapes = files.iter().flat_map(|sketch| sketch.items.iter().flat_map(|item| item.iter()));
    let loops = shapes.map(|shape| shape.loops.len()).sum();
    if loops > items(files) { loops } else { 0 }
}

pub(super) fn without_loops(files: &[Sketch], range: &Range<usize>) -> Vec<Sketch> {
    let mut at = 0;
    changed(files, |_, one| (!range.contains(&at), at += 1).0.then(|| one.to_vec()))
}

pub(super) fn points(files: &[Sketch]) -> usize {
    files.iter().map(|sketch| sketch.places().len()).sum()
}

/// For each file, a flag for each point: true if it is one of the range.
fn chosen(files: &[Sketch], range: &Range<usize>) -> Vec<Vec<bool>> {
    let mut number = 0;
    let mut flags = |sketch: &Sketch| {
        let mut flags = sketch.used();
        for flag in flags.iter_mut().filter(|used| **used) {
            (*flag, number) = (range.contains(&number), number + 1);
        }
        flags
    };
    files.iter().map(&mut flags).collect()
}

pub(super) fn without_points(files: &[Sketch], range: &Range<usize>) -> Vec<Sketch> {
    let gone = chosen(files, range);
    changed(files, |file, one| Some(one.iter().copied().filter(|&corner| !gone[file][corner]).collect()))
}

/// The number of points of meshes: a mesh stays closed if a point takes the place of its neighbour.
pub(super) fn mergeable(files: &[Sketch]) -> usize {
    let is_mesh = |sketch: &Sketch| !matches!(sketch.form, Form::GeoJson(_) | Form::Wkt | Form::Csv(..));
    if files.iter().all(is_mesh) { points(files) } else { 0 }
}

/// Puts each point of the range at a neighbour: the first, the last or the middle one by their indices.
fn merged(files: &[Sketch], range: &Range<usize>, which: fn(usize) -> usize) -> Vec<Sketch> {
    let gone = chosen(files, range);
    let mut into: Vec<BTreeMap<usize, BTreeSet<usize>>> = vec![BTreeMap::new(); files.len()];
    for (file, sketch) in files.iter().enumerate() {
        for corners in sketch.items.iter().flat_map(|item| item.iter()).flat_map(|shape| &shape.loops) {
            for &corner in corners.iter().filter(|&&corner| gone[file][corner]) {
                let others = corners.iter().copied().filter(|&other| !gone[file][other]);
                into[file].entry(corner).or_default().extend(others);
            }
        }
    }
    let into = |file: usize, corner: usize| {
        let all = into[file].get(&corner)?;
        all.iter().nth(which(all.len())).copied()
    };
    changed(files, |file, one| {
        let mut after: Vec<usize> = one.iter().map(|&corner| into(file, corner).unwrap_or(corner)).collect();
        if after == one {
            return Some(after);
        }
        after.dedup();
        while after.len() > 1 && after.first() == after.last() {
            after.pop();
        }
        let distinct: BTreeSet<usize> = after.iter().copied().collect();
        (distinct.len() == after.len()).then_some(after)
    })
}

pub(super) const MERGED: [Without; 3] = [
    |files, range| merged(files, range, |_| 0),
    |files, range| merged(files, range, |n| n.saturating_sub(1)),
    |files, range| merged(files, range, |n| n / 2),
];
