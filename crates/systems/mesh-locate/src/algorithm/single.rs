//! Location of one point.

use predicament_grid::Bounds;
use predicament_grid::two_level::Ray;
use predicament_mesh::OUTSIDE;
use predicament_predicates::{Axis, Predicates, Scene, Sign, Vertex};

use super::at_corner::Spokes;
use super::nearer::is_nearer;
use super::stab::{Direction, Stab, Way, stab, stab_in_band};
use super::{Labels, Location, MeshIndex};

/// Reusable working memory for locating points.
#[derive(Clone, Default, Debug)]
pub struct Scratch {
    listed: Vec<u32>,
    /// Triangles in the way, and the positions of their boxes along the ray.
    triangles: Vec<(u32, Way)>,
    /// Regions, and the number of times the ray enters each, less the times it leaves.
    sums: Vec<(u32, i64)>,
}

impl Scratch {
    /// Empty working memory.
    #[must_use]
    pub fn new() -> Scratch {
        Scratch::default()
    }
}

/// The nearest triangle found so far.
#[derive(Clone, Copy)]
struct Nearest {
    triangle: u32,
    /// The region in front of it.
    region: u32,
    /// The last step along the ray that its box reaches.
    end: u32,
}

impl MeshIndex {
    /// Locates the vertex `q`: by the label of its cell, otherwise by the nearest triangle above it. For a session with
    /// a band, the first ray that decides gives the answer.
    ///
    /// # Panics
    /// If the session's scene lacks `q` or a vertex of the mesh.
    #[inline]
    pub fn locate<P: Predicates + ?Sized>(
        &self,
        session: &P,
        labels: &Labels,
        q: Vertex,
        scratch: &mut Scratch,
    ) -> Location {
        if session.reach() != 0.0 {
            return self.question_any(session, q, &Ray::ALL, scratch);
        }
        match labels.of(self.grid().at(session.scene().point3(q))) {
            Some(region) => Location::In(region),
            None => self.walk(session, labels, q, scratch),
        }
    }

    /// Locates like [`MeshIndex::locate`], without the label of the point's own cell.
    pub(super) fn by_ray<P: Predicates + ?Sized>(
        &self,
        session: &P,
        labels: &Labels,
        q: Vertex,
        scratch: &mut Scratch,
    ) -> Location {
        match session.reach() {
            0.0 => self.walk(session, labels, q, scratch),
            _ => self.question_any(session, q, &Ray::ALL, scratch),
        }
    }

    /// Follows the ray up from cell to cell, to the nearest triangle or a cell whose region is known.
    fn walk<P: Predicates + ?Sized>(&self, session: &P, labels: &Labels, q: Vertex, scratch: &mut Scratch) -> Location {
        let (scene, direction) = (session.scene(), Direction::of(Ray::UP));
        let points: &[[f64; 3]] = scene.coordinates().as_chunks().0;
        let (p, triangles, shadows) = (points[q.index()], self.mesh().triangles(), self.shadows());
        let mut nearest: Option<Nearest> = None;
        let (mut is_asked, mut found, mut coincide) = (false, None, false);
        let mut spokes = Spokes::default();
        // The last step of the previous cells.
        let mut before = None;
        self.grid().along(p, Ray::UP, |slot, entries, last| {
            // Every cell up to the end of the nearest triangle lists it.
            if entries.is_empty() {
                found = labels.get(slot).map(Location::In);
                before = Some(last);
                return found.is_some();
            }
            for &triangle in entries {
                if !shadows[triangle as usize].has(p[0], p[1]) {
                    continue;
                }
                let corners = triangles[triangle as usize];
                let Some(low) = may_meet(points, corners, p) else { continue };
                if before.is_some_and(|before| self.grid().step(2, low) <= before) {
                    // The previous cell listed it: its box holds the point as seen from above, and extends down there.
                    continue;
                }
                if !is_asked && let Some(&corner) = corners.iter().find(|v| points[v.index()] == p) {
                    if session.compare(Axis::X, q, corner) == Sign::Zero {
                        // The session moves neither from the other.
                        found = Some(Location::On(triangle));
                        return true;
                    }
                    is_asked = true;
                    found = self.at_corner(session, q, corner, entries);
                    if found.is_some() {
                        return true;
                    }
                }
                let turn = |u: Vertex, v: Vertex| {
                    let ask = || session.orient2d(direction.plane, u, v, q);
                    // Several triangles share an edge over or under the point, and ties are slow: such turns are
                    // cached.
                    let is_at = |v: Vertex| points[v.index()][0] == p[0] && points[v.index()][1] == p[1];
                    if is_at(u) || is_at(v) { spokes.turn([u, v], ask) } else { ask() }
                };
                match stab(session, direction, corners, q, low <= p[2], turn) {
                    Stab::Missed => {}
                    Stab::Unsure => unreachable!("no zero here comes from a tolerance band"),
                    Stab::On => {
                        // Entries are ascending, and the point's own cell lists all triangles that contain it.
                        found = Some(Location::On(triangle));
                        return true;
                    }
                    Stab::Passed { from_behind } => {
                        let other = nearest.map(|nearest| triangles[nearest.triangle as usize]);
                        let is_nearer = other.map_or(Some(true), |other| is_nearer(session, direction, corners, other));
                        let Some(is_nearer) = is_nearer else {
                            coincide = true;
                            return true;
                        };
                        if is_nearer {
                            let region = self.mesh().sides()[triangle as usize][usize::from(from_behind)];
                            let [a, b, c] = corners;
                            let high = points[a.index()][2].max(points[b.index()][2]).max(points[c.index()][2]);
                            nearest = Some(Nearest { triangle, region, end: self.grid().step(2, high) });
                        }
                    }
                }
            }
            before = Some(last);
            // Triangles that were not listed so far are completely above this cell.
            nearest.is_some_and(|nearest| nearest.end <= last)
        });
        if coincide {
            // Neither of two triangles is nearer: sums decide the region before both.
            return self.question(session, q, Ray::UP, scratch);
        }
        found.unwrap_or(Location::In(nearest.map_or(OUTSIDE, |nearest| nearest.region)))
    }

    /// Locates the vertex `q` by the first ray that decides. Without a band, every ray decides.
    ///
    /// # Panics
    /// As [`MeshIndex::locate`], and if there are no rays.
    pub fn question_any<P: Predicates + ?Sized>(
        &self,
        session: &P,
        q: Vertex,
        rays: &[Ray],
        scratch: &mut Scratch,
    ) -> Location {
        assert!(!rays.is_empty(), "a point is located by a ray");
        let decide = |&ray: &Ray| Some(self.question(session, q, ray, scratch)).filter(|at| *at != Location::Undecided);
        rays.iter().find_map(decide).unwrap_or(Location::Undecided)
    }

    /// Locates the vertex `q` with a query about every triangle along the ray, to its end, even if raw coordinates or
    /// labels would decide.
    ///
    /// The answer equals [`locate`](MeshIndex::locate) for exact and perturbed signs and a mesh that does not cross
    /// itself. This method is slower: it serves to judge sessions, not to use them. With a band the answer is
    /// [`Location::Undecided`] if this ray does not decide.
    ///
    /// # Panics
    /// As [`MeshIndex::locate`].
    pub fn question<P: Predicates + ?Sized>(
        &self,
        session: &P,
        q: Vertex,
        ray: Ray,
        scratch: &mut Scratch,
    ) -> Location {
        let (direction, reach) = (Direction::of(ray), session.reach());
        self.in_the_way(session.scene(), q, ray, reach, scratch);
        scratch.sums.clear();
        scratch.sums.push((OUTSIDE, 1));
        let mut add = |region: u32, by: i64| match scratch.sums.iter_mut().find(|(known, _)| *known == region) {
            Some((_, sum)) => *sum += by,
            None => scratch.sums.push((region, by)),
        };
        let mut is_unsure = false;
        for &(triangle, way) in &scratch.triangles {
            let corners = self.mesh().triangles()[triangle as usize];
            let turn = |u, v| session.orient2d(direction.plane, u, v, q);
            let met = match reach {
                0.0 => stab(session, direction, corners, q, way.is_near, turn),
                _ => stab_in_band(session, direction, corners, q, way),
            };
            match met {
                Stab::Missed => {}
                // The point may still be on another triangle.
                Stab::Unsure => is_unsure = true,
                Stab::On => return Location::On(triangle),
                Stab::Passed { from_behind } => {
                    let [front, back] = self.mesh().sides()[triangle as usize];
                    let [before, behind] = if from_behind { [back, front] } else { [front, back] };
                    add(before, 1);
                    add(behind, -1);
                }
            }
        }
        if is_unsure {
            return Location::Undecided;
        }
        let mut left = scratch.sums.iter().filter(|(_, sum)| *sum != 0);
        match (left.next(), left.next()) {
            (Some(&(region, 1)), None) => Location::In(region),
            _ => Location::Contradiction,
        }
    }

    /// Finds the triangles whose boxes the ray passes within a reach, ascending, each once.
    fn in_the_way(&self, scene: &Scene, q: Vertex, ray: Ray, reach: f64, scratch: &mut Scratch) {
        let p = scene.point3(q);
        // Outward by more than the rounding error of the sum.
        let around = match reach {
            0.0 => Bounds { low: p, high: p },
            _ => Bounds {
                low: p.map(|x| (x - reach).next_down().max(f64::MIN)),
                high: p.map(|x| (x + reach).next_up().min(f64::MAX)),
            },
        };
        let mut way = around;
        if ray.is_up {
            way.high[ray.axis] = f64::MAX;
        } else {
            way.low[ray.axis] = f64::MIN;
        }
        let Scratch { listed, triangles, .. } = scratch;
        listed.clear();
        self.grid().within(&way, |_, entries| listed.extend_from_slice(entries));
        listed.sort_unstable();
        listed.dedup();
        triangles.clear();
        triangles.extend(listed.iter().filter_map(|&triangle| {
            let corners = self.mesh().triangles()[triangle as usize].map(|v| scene.point3(v));
            let bounds = Bounds::of(corners);
            let [before, behind] = [bounds.high[ray.axis] < p[ray.axis], bounds.low[ray.axis] > p[ray.axis]];
            let ahead = (before != behind).then_some(behind == ray.is_up);
            bounds.is_near(&way, 0.0).then(|| (triangle, Way { is_near: bounds.is_near(&around, 0.0), ahead }))
        }));
    }
}

/// The lowest coordinate of a triangle, if its box holds p as seen from above and is not completely below p.
#[inline(always)]
fn may_meet(points: &[[f64; 3]], [a, b, c]: [Vertex; 3], p: [f64; 3]) -> Option<f64> {
    let (a, b, c) = (&points[a.index()], &points[b.index()], &points[c.index()]);
    // Without branches, which would be unpredictable; without `min` and `max`, which test for NaN.
    let is_beside = |axis: usize| {
        let x = p[axis];
        ((a[axis] < x) & (b[axis] < x) & (c[axis] < x)) | ((a[axis] > x) & (b[axis] > x) & (c[axis] > x))
    };
    let is_below = (a[2] < p[2]) & (b[2] < p[2]) & (c[2] < p[2]);
    let over = !(is_beside(0) | is_beside(1) | is_below);
    over.then(|| a[2].min(b[2]).min(c[2]))
}
