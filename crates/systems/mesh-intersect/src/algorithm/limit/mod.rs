//! The limit of a perturbed result as the perturbation goes to zero: the regularised Boolean operation of the
//! unperturbed meshes.
//!
//! [`mod@crate::algorithm::overlay`] overlays meshes one of which has moved by an infinitesimal. So its results can
//! have triangles without area, different vertices at one position, and sheets without volume: the union of two boxes
//! that share a face keeps that face twice, if the move opens a gap. The volume of the result is continuous in the
//! move, and so is its surface as a chain of oriented triangles. An exact session finds that chain for the zero move:
//! vertices at one position are merged, triangles without area are removed, and triangles that face each other in one
//! plane cancel. The limit does not depend on the move: it is the closure of the interior of the result (Requicha's
//! *regularised* operation).
//!
//! # Steps
//! 1. Only triangles whose boxes may meet those of the other mesh are processed.
//! 2. Vertices at one position are found: by the nearest doubles, and if these are equal and not exact, by `compare`
//!    (`places.rs`).
//! 3. Triangles with a vertex twice are removed, and pairs of opposite ones; step 5 would do that too, and takes
//!    longer.
//! 4. Triangles without area are removed: one `orient2d` each, in a plane where the triangle that contains them has
//!    area.
//! 5. Other triangles that face each other are cut in their plane (`sheets.rs`).
//! 6. If steps 4 and 5 leave edges open, triangles are divided at the vertices on their edges (`joints.rs`).
//!
//! # What is taken
//! Results of sessions that move a mesh as a whole: a line that is parallel to a plane stays parallel, and each
//! constructed vertex is a point in the limit. If each vertex moves separately that may fail; then the limit is
//! refused.

pub(crate) mod chain;
pub(crate) mod joints;
mod nearest;
pub(crate) mod places;
pub(crate) mod plane;
pub(crate) mod sheets;

use predicament_grid::{Bounds, shared};
use predicament_predicates::{Predicates, Vertex};

pub use places::Places;

use self::chain::Chain;
use self::joints::Joints;
use self::places::Same;
use self::sheets::{Gone, Label, Left, Part};
use crate::algorithm::overlay::number;
use crate::algorithm::overlay::{MeshOverlay, Solid, SurfaceContradiction, Undone};

/// The limit of a result.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Limit {
    /// The surface: closed, counterclockwise as seen from outside, each triangle with an area. Triangles meet in
    /// vertices and edges only, unless those of the operands meet elsewhere.
    pub solid: Solid,
    /// The doubles nearest to its vertices.
    pub places: Places,
    /// Statistics of the limit.
    pub counts: Counts,
}

/// The numbers of elements of a result without extent.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Counts {
    /// Vertices replaced by another one at the same position.
    pub merged: usize,
    /// Triangles without area.
    pub flat: usize,
    /// Triangles cancelled by an opposite one.
    pub cancelled: usize,
    /// Triangles replaced by the part that a facing one does not cover.
    pub covered: usize,
    /// Triangles divided at vertices on their edges.
    pub divided: usize,
}

/// Computes the limit of a result of an overlay, in a session with exact zeros that knows the overlay's constructions.
///
/// # Errors
/// [`Undone::Broken`] if a constructed vertex is not a point without the move, or signs break an invariant;
/// [`Undone::Refused`] if the session does not construct a point.
pub fn limit(session: &mut dyn Predicates, overlay: &MeshOverlay, solid: Solid) -> Result<Limit, Undone> {
    let places = Places::new(session.scene())?;
    let mut work = Work { places, ..Work::default() };
    work.merge(session, &solid);
    work.cancel();
    work.flatten(session, overlay)?;
    work.uncover(session, overlay)?;
    work.divide(session);
    work.finish(solid)
}

/// A result during the computation of its limit.
#[derive(Default)]
struct Work {
    places: Places,
    /// The processed triangles of either mesh, in order.
    parts: [Vec<Part>; 2],
    /// The indices of removed triangles.
    gone: Vec<u32>,
    /// Removed triangles that leave edges open.
    removed: Vec<[Vertex; 3]>,
    /// Removed triangles that others may border on.
    dead: Gone,
    added: Vec<([Vertex; 3], Label)>,
    counts: Counts,
}

impl Work {
    /// Takes the triangles near the other mesh, and replaces vertices at one position by one of them.
    fn merge(&mut self, session: &dyn Predicates, solid: &Solid) {
        let near = near(session, &self.places, solid);
        let vertices = near.iter().flatten().flat_map(|&place| solid.triangles[place as usize]).collect();
        let same = Same::of(session, &self.places, vertices);
        self.counts.merged = same.count();
        for (parts, near) in self.parts.iter_mut().zip(near) {
            for place in near {
                let named = solid.triangles[place as usize];
                let triangle = named.map(|v| same.stand(v));
                let [a, b, c] = triangle;
                let (source, is_turned) = (solid.sources[place as usize], solid.turned[place as usize]);
                let part = Part { place, triangle, named, label: Label { source, is_turned } };
                if a == b || b == c || c == a {
                    self.gone.push(place);
                    self.dead.flat.push(part);
                } else {
                    parts.push(part);
                }
            }
        }
        self.counts.flat = self.gone.len();
    }

    /// Removes pairs of opposite triangles.
    fn cancel(&mut self) {
        // The triangle with ascending vertices, and true if that keeps its orientation.
        let sorted = |part: &Part| {
            let [a, b, c] = part.triangle;
            let mut all = [a, b, c];
            all.sort_unstable();
            (all, [[a, b, c], [b, c, a], [c, a, b]].contains(&all), part.place, *part)
        };
        let mut all: Vec<_> = self.parts.iter().flatten().map(sorted).collect();
        all.sort_unstable_by_key(|&(triangle, is_even, place, _)| (triangle, is_even, place));
        let mut cancelled: Vec<u32> = Vec::new();
        for same in all.chunk_by(|a, b| a.0 == b.0) {
            let (odd, even) = same.split_at(same.partition_point(|(_, is_even, ..)| !is_even));
            for (&(.., first), &(.., second)) in odd.iter().zip(even) {
                cancelled.extend([first.place, second.place]);
                let is_first = first.label.source.mesh <= second.label.source.mesh;
                self.dead.cancelled.push(if is_first { [first, second] } else { [second, first] });
            }
        }
        cancelled.sort_unstable();
        self.counts.cancelled = cancelled.len();
        self.keep(|part| cancelled.binary_search(&part.place).is_err());
        self.gone.extend(cancelled);
    }

    fn keep(&mut self, keep: impl Fn(&Part) -> bool) {
        self.parts.iter_mut().for_each(|parts| parts.retain(&keep));
    }

    /// Removes triangles without area.
    fn flatten(&mut self, session: &dyn Predicates, overlay: &MeshOverlay) -> Result<(), Undone> {
        let is_flat = |part: &Part| -> Result<bool, Undone> {
            if part.named.iter().all(|v| !v.is_constructed()) {
                return Ok(false);
            }
            let mesh = &overlay.meshes()[usize::from(part.label.source.mesh)];
            let whole = mesh.triangles()[part.label.source.triangle as usize];
            let (plane, _) = sheets::view(session, &self.places, whole)?;
            let [a, b, c] = part.triangle;
            Ok(session.orient2d(plane, a, b, c).is_zero())
        };
        let mut flat = Vec::new();
        for part in self.parts.iter().flatten() {
            if is_flat(part)? {
                flat.push(*part);
            }
        }
        flat.sort_unstable_by_key(|part| part.place);
        self.counts.flat += flat.len();
        self.keep(|part| flat.binary_search_by_key(&part.place, |flat| flat.place).is_err());
        self.removed.extend(flat.iter().map(|part| part.triangle));
        self.gone.extend(flat.iter().map(|part| part.place));
        self.dead.flat.extend(flat);
        Ok(())
    }

    /// Replaces triangles that face a triangle of the other mesh by their uncovered parts.
    fn uncover(&mut self, session: &mut dyn Predicates, overlay: &MeshOverlay) -> Result<(), Undone> {
        let meshes = overlay.meshes().each_ref().map(|mesh| &**mesh);
        let parts = self.parts.each_ref().map(|parts| &parts[..]);
        let Left { mut gone, instead } = sheets::left(session, &self.places, meshes, parts, &self.dead)?;
        if gone.is_empty() {
            return Ok(());
        }
        self.places.extend(session.scene())?;
        gone.sort_unstable();
        self.counts.covered = gone.len();
        let is_covered = |part: &&Part| gone.binary_search(&part.place).is_ok();
        self.removed.extend(self.parts.iter().flatten().filter(is_covered).map(|part| part.triangle));
        self.keep(|part| gone.binary_search(&part.place).is_err());
        self.gone.extend(gone);
        // One point may have been constructed twice; the older vertex replaces the newer.
        let new = instead.iter().flat_map(|(triangle, _)| *triangle);
        let old = self.parts.iter().flatten().flat_map(|part| part.triangle);
        let same = Same::of(session, &self.places, new.chain(old).collect());
        let named = |(triangle, label): ([Vertex; 3], Label)| (triangle.map(|v| same.stand(v)), label);
        self.added = instead.into_iter().map(named).collect();
        Ok(())
    }

    /// The open edges: removed and added triangles do not balance there.
    fn open(&self) -> Vec<[Vertex; 2]> {
        let mut chain = Chain::default();
        self.removed.iter().for_each(|&triangle| chain.add(triangle, 1));
        self.added.iter().for_each(|&(triangle, _)| chain.add(triangle, -1));
        chain.open()
    }

    /// Divides triangles at vertices on their edges.
    fn divide(&mut self, session: &dyn Predicates) {
        let open = self.open();
        let joints = Joints::of(session, &self.places, &open);
        if joints.is_empty() {
            return;
        }
        let mut added = Vec::new();
        for (triangle, label) in std::mem::take(&mut self.added) {
            match joints.divided(triangle) {
                Some(pieces) => {
                    self.counts.divided += 1;
                    added.extend(pieces.into_iter().map(|piece| (piece, label)));
                }
                None => added.push((triangle, label)),
            }
        }
        for parts in &mut self.parts {
            parts.retain(|part| {
                let Some(pieces) = joints.divided(part.triangle) else { return true };
                self.counts.divided += 1;
                self.gone.push(part.place);
                self.removed.push(part.triangle);
                added.extend(pieces.into_iter().map(|piece| (piece, part.label)));
                false
            });
        }
        self.added = added;
    }

    /// Applies all changes to the result.
    fn finish(mut self, mut solid: Solid) -> Result<Limit, Undone> {
        if !self.open().is_empty() {
            return Err(Undone::Broken(SurfaceContradiction::LimitClosed.into()));
        }
        for part in self.parts.iter().flatten() {
            solid.triangles[part.place as usize] = part.triangle;
        }
        self.gone.sort_unstable();
        let mut gone = self.gone.into_iter().peekable();
        let stays: Vec<bool> = (0_u32..).take(solid.triangles.len()).map(|at| gone.next_if_eq(&at).is_none()).collect();
        let mut stay = stays.iter();
        solid.triangles.retain(|_| stay.next() == Some(&true));
        let mut stay = stays.iter();
        solid.sources.retain(|_| stay.next() == Some(&true));
        let mut stay = stays.iter();
        solid.turned.retain(|_| stay.next() == Some(&true));
        for (triangle, Label { source, is_turned }) in self.added {
            solid.triangles.push(triangle);
            solid.sources.push(source);
            solid.turned.push(is_turned);
        }
        Ok(Limit { solid, places: self.places, counts: self.counts })
    }
}

/// The triangles whose boxes may meet the box of a triangle from the other mesh, with all other pieces of the same
/// triangle.
fn near(session: &dyn Predicates, places: &Places, solid: &Solid) -> [Vec<u32>; 2] {
    let scene = session.scene();
    let of = |mesh: u8| -> Vec<u32> {
        let all = (0_u32..).zip(&solid.sources);
        all.filter(|(_, source)| source.mesh == mesh).map(|(place, _)| place).collect()
    };
    let all = [of(0), of(1)];
    let box_of = all
        .each_ref()
        .map(|all| move |at: usize| Bounds::of(solid.triangles[all[at] as usize].map(|v| places.nearest(scene, v))));
    let (near, _) = shared(all.each_ref().map(Vec::len), [&box_of[0], &box_of[1]]);
    // Pieces of one triangle are consecutive.
    let pieces = |place: u32| {
        let source = solid.sources[place as usize];
        let before = solid.sources[..place as usize].iter().rev().take_while(|&&other| other == source).count();
        let after = solid.sources[place as usize..].iter().take_while(|&&other| other == source).count();
        (place as usize - before..place as usize + after).zip(place - number(before)..).map(|(_, place)| place)
    };
    [0, 1].map(|mesh: usize| {
        let mut places: Vec<u32> = Vec::with_capacity(near[mesh].len());
        for &at in &near[mesh] {
            let place = all[mesh][at as usize];
            if places.last().is_none_or(|&last| last < place) {
                places.extend(pieces(place));
            }
        }
        places
    })
}
