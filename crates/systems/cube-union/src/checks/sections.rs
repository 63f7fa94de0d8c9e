//! Volume, area and edge length of a union of cubes from its sections.
//!
//! Along one axis the faces cut space into slabs; within a slab, all sections of the union are equal. Along a second
//! axis, the faces cut the slab's section in the same way. The sections of the section are unions of intervals. With
//! widths du, dv, dw:
//! * The volume is the sum of du dv dw over the intervals.
//! * A boundary with direction w shows as ends of intervals: the sum of du dv over the ends is its area.
//! * An edge along u shows as a corner of the section: a line between two strips on which exactly one strip has an end.
//!   The sum of du over the corners is the edges' length.
//!
//! Each axis takes the role of u, and that of w. Faces are in the order of their coordinates. Faces with equal
//! coordinates are in the order of their cubes, from the last to the first ([`Ties`] has other orders). This is as if
//! the cubes were moved by infinitesimals that are larger for earlier cubes. Widths do not include the infinitesimals:
//! the result is the limit for perturbations that go to zero.
//!
//! For closed cubes ([`Ties::Merged`]) the lines between strips with equal coordinates are one line. An interval that
//! ends where another one starts continues. A point of the line is a corner if the strips on its two sides differ
//! there: one has an end and the other has not, or one ends and the other starts.

use std::collections::BTreeSet;

/// Mass properties of a union.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Measures {
    /// The volume.
    pub volume: i128,
    /// The area of the boundary.
    pub area: i128,
    /// The length of the boundary's edges.
    pub edge_length: i128,
}

/// The order of faces with equal coordinates.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ties {
    /// The coordinate of the earlier cube is larger by an infinitesimal.
    Earlier,
    /// All cubes are larger by an infinitesimal: those that touch overlap, as closed cubes do.
    Closed,
    /// All cubes are smaller by an infinitesimal: those that touch have a wall between them, as open cubes do.
    Open,
    /// Cubes are closed sets and not moved: those that touch overlap, and a seam between two faces in one plane is
    /// not an edge.
    Merged,
}

/// The faces along one axis by rank.
struct Faces {
    /// The rank of each cube's lower and upper face.
    ranks: Vec<[usize; 2]>,
    /// The coordinate at each rank.
    values: Vec<i64>,
    /// The cube of the face at each rank, and true if it is the upper face.
    owners: Vec<(usize, bool)>,
}

impl Faces {
    fn new(lowers: &[[i64; 3]], edge: i64, axis: usize, ties: Ties) -> Faces {
        let sides = |(cube, lower): (usize, &[i64; 3])| [(lower[axis], cube, false), (lower[axis] + edge, cube, true)];
        let mut all: Vec<(i64, usize, bool)> = lowers.iter().enumerate().flat_map(sides).collect();
        all.sort_by(|a, b| match ties {
            Ties::Earlier => (a.0, b.1).cmp(&(b.0, a.1)),
            Ties::Closed | Ties::Merged => (a.0, a.2).cmp(&(b.0, b.2)),
            Ties::Open => (a.0, b.2).cmp(&(b.0, a.2)),
        });
        let mut ranks = vec![[0; 2]; lowers.len()];
        for (rank, &(_, cube, upper)) in all.iter().enumerate() {
            ranks[cube][usize::from(upper)] = rank;
        }
        Faces {
            ranks,
            values: all.iter().map(|face| face.0).collect(),
            owners: all.iter().map(|face| (face.1, face.2)).collect(),
        }
    }

    /// The width from one rank to another.
    fn width(&self, from: usize, to: usize) -> i128 {
        i128::from(self.values[to]) - i128::from(self.values[from])
    }
}

/// Inserts `item` in an ascending list, or removes it if it is there.
fn toggle(list: &mut Vec<usize>, item: usize) {
    match list.binary_search(&item) {
        Ok(at) => {
            list.remove(at);
        }
        Err(at) => list.insert(at, item),
    }
}

/// The sums of one section: area, ends times widths, corners.
#[derive(Default)]
struct Section {
    area: i128,
    ends: i128,
    corners: i128,
}

/// The section of the cubes whose faces along v are at these ranks.
fn section(v: &Faces, w: &Faces, active: &[usize], ties: Ties) -> Section {
    let mut section = Section::default();
    let (mut lowers, mut before, mut now) = (Vec::new(), Vec::new(), Vec::new());
    for (at, &rank) in active.iter().enumerate() {
        let (cube, _) = v.owners[rank];
        toggle(&mut lowers, w.ranks[cube][0]);
        // The union of the intervals: its ends, ascending.
        now.clear();
        for &lower in &lowers {
            let upper = w.ranks[w.owners[lower].0][1];
            match now.last_mut() {
                Some(end) if *end > lower => *end = upper.max(*end),
                _ => now.extend([lower, upper]),
            }
        }
        if let Some(&next) = active.get(at + 1) {
            let width = v.width(rank, next);
            let lengths: i128 = now.chunks(2).map(|ends| w.width(ends[0], ends[1])).sum();
            section.area += width * lengths;
            section.ends += width * now.len() as i128;
        }
        if ties == Ties::Merged {
            if active.get(at + 1).is_some_and(|&next| v.values[next] == v.values[rank]) {
                continue;
            }
            section.corners += differing_points(w, &before, &now);
        } else {
            section.corners += differing(&before, &now);
        }
        std::mem::swap(&mut before, &mut now);
    }
    section
}

/// The number of items that are in exactly one of two ascending lists.
fn differing(a: &[usize], b: &[usize]) -> i128 {
    let (mut i, mut j, mut common) = (0, 0, 0);
    while i < a.len() && j < b.len() {
        match a[i].cmp(&b[j]) {
            std::cmp::Ordering::Less => i += 1,
            std::cmp::Ordering::Greater => j += 1,
            std::cmp::Ordering::Equal => (i, j, common) = (i + 1, j + 1, common + 1),
        }
    }
    (a.len() + b.len() - 2 * common) as i128
}

/// The number of points at which two unions of intervals differ, by the ranks of their ends.
fn differing_points(w: &Faces, a: &[usize], b: &[usize]) -> i128 {
    let ends = |ranks: &[usize]| -> BTreeSet<(i64, usize)> {
        ranks.iter().enumerate().map(|(place, &rank)| (w.values[rank], place % 2)).collect()
    };
    let points: BTreeSet<i64> = ends(a).symmetric_difference(&ends(b)).map(|end| end.0).collect();
    points.len() as i128
}

/// The mass properties of the union of cubes, by their lower corners and the length of their edges.
///
/// If two coordinates are equal, the coordinate of the earlier cube is larger by an infinitesimal; the result is the
/// limit.
///
/// For up to some ten thousand cubes: time grows with about N^2 for N cubes
/// that are spread evenly.
///
/// # Panics
/// If the edge length is not positive, or the volumes found along the three
/// axes differ.
#[must_use]
pub fn measured(lowers: &[[i64; 3]], edge: i64) -> Measures {
    measured_by(lowers, edge, Ties::Earlier)
}

/// The mass properties as by [`measured`], with another order of faces with equal coordinates.
///
/// The length of edges depends on that order in more ways than these three.
///
/// # Panics
/// As [`measured`].
#[must_use]
pub fn measured_by(lowers: &[[i64; 3]], edge: i64, ties: Ties) -> Measures {
    assert!(edge > 0, "cubes have a positive edge length, not {edge}");
    let axes = [0, 1, 2].map(|axis| Faces::new(lowers, edge, axis, ties));
    let mut volumes = [0; 3];
    let mut all = Measures::default();
    for (axis, volume) in volumes.iter_mut().enumerate() {
        let [u, v, w] = [axis, (axis + 1) % 3, (axis + 2) % 3].map(|axis| &axes[axis]);
        let mut active = Vec::new();
        for (rank, &(cube, _)) in u.owners.iter().enumerate() {
            v.ranks[cube].into_iter().for_each(|rank| toggle(&mut active, rank));
            let width = if rank + 1 < u.owners.len() { u.width(rank, rank + 1) } else { 0 };
            if width > 0 {
                let section = section(v, w, &active, ties);
                *volume += width * section.area;
                all.area += width * section.ends;
                all.edge_length += width * section.corners;
            }
        }
    }
    assert!(volumes.iter().all(|&volume| volume == volumes[0]), "one volume by three ways: {volumes:?}");
    all.volume = volumes[0];
    all
}
