//! Merging coplanar triangles to polygons.

use predicament_predicates::{Predicates, Sign, Vertex};

use super::scratch::NONE;
use super::{Contradiction, Hull3};

/// The number of edges in a batch of queries.
const CHUNK: usize = 4096;

/// The hull with these triangles, after merging coplanar ones.
///
/// Each triangle comes with its neighbours across the edges that begin at its corners. Coplanar triangles become one
/// face, and its corners are the vertices of three faces or more.
pub(super) fn merged(session: &dyn Predicates, triangles: &[[Vertex; 3]], near: &[[u32; 3]]) -> Hull3 {
    let mut groups: Vec<u32> = (0..).take(triangles.len()).collect();
    let mut broken = None;
    let mut is_flat = false;
    let edges = (0_u32..).zip(near).flat_map(|(at, near)| near.iter().map(move |&other| [at, other]));
    let edges: Vec<[u32; 2]> = edges.filter(|[at, other]| at < other).collect();
    let mut signs = vec![Sign::Zero; edges.len().min(CHUNK)];
    let mut queries = Vec::with_capacity(signs.len());
    for edges in edges.chunks(CHUNK) {
        queries.clear();
        queries.extend(edges.iter().map(|&[at, other]| {
            let corners = triangles[at as usize];
            let opposite = triangles[other as usize].into_iter().find(|corner| !corners.contains(corner));
            // Two triangles with the same corners would be a flat tetrahedron, which is never made.
            [corners[0], corners[1], corners[2], opposite.unwrap_or(corners[0])]
        }));
        let signs = &mut signs[..edges.len()];
        session.orient3d_batch(&queries, signs);
        for (&[at, other], sign) in edges.iter().zip(signs) {
            match sign {
                Sign::Positive => {}
                Sign::Negative => broken = Some(Contradiction::Convex),
                Sign::Zero => {
                    is_flat = true;
                    let [a, b] = [find(&mut groups, at), find(&mut groups, other)];
                    groups[a.max(b) as usize] = a.min(b);
                }
            }
        }
    }
    if is_flat {
        match polygons(triangles, near, &mut groups) {
            Ok(faces) => return Hull3 { vertices: corners(&faces), faces, broken },
            Err(why) => broken = Some(why),
        }
    }
    // Put in their final order here, while they are arrays.
    let mut triangles = triangles.to_vec();
    for corners in &mut triangles {
        let smallest = (0..3).min_by_key(|&at| corners[at]).unwrap_or(0);
        corners.rotate_left(smallest);
    }
    triangles.sort_unstable();
    let faces: Vec<Vec<Vertex>> = triangles.iter().map(|corners| corners.to_vec()).collect();
    Hull3 { vertices: corners(&faces), faces, broken }
}

/// The corners of all faces, ascending.
pub(super) fn corners(faces: &[Vec<Vertex>]) -> Vec<Vertex> {
    let all = || faces.iter().flatten();
    let (Some(first), Some(last)) = (all().min(), all().max()) else { return Vec::new() };
    let uses: usize = faces.iter().map(Vec::len).sum();
    if last.index() - first.index() > 64 * uses {
        let mut few: Vec<Vertex> = all().copied().collect();
        few.sort_unstable();
        few.dedup();
        return few;
    }
    let mut is_corner = vec![false; last.index() - first.index() + 1];
    all().for_each(|v| is_corner[v.index() - first.index()] = true);
    let places = is_corner.iter().enumerate().filter(|&(_, &is_corner)| is_corner);
    places.map(|(at, _)| Vertex::input(first.index() + at)).collect()
}

/// The representative triangle of a group.
fn find(groups: &mut [u32], of: u32) -> u32 {
    let mut root = of;
    while groups[root as usize] != root {
        let above = groups[groups[root as usize] as usize];
        groups[root as usize] = above;
        root = above;
    }
    root
}

/// The boundary of each group of triangles, without the vertices of fewer than three groups.
fn polygons(
    triangles: &[[Vertex; 3]],
    near: &[[u32; 3]],
    groups: &mut [u32],
) -> Result<Vec<Vec<Vertex>>, Contradiction> {
    let of: Vec<u32> = (0..).take(triangles.len()).map(|at| find(groups, at)).collect();
    let mut boundary: Vec<(u32, Vertex, Vertex)> = Vec::new();
    for ((corners, near), &group) in triangles.iter().zip(near).zip(&of) {
        for (edge, &other) in near.iter().enumerate() {
            if of[other as usize] != group {
                boundary.push((group, corners[edge], corners[(edge + 1) % 3]));
            }
        }
    }
    boundary.sort_unstable();
    let most = boundary.iter().map(|edge| edge.1.index() + 1).max().unwrap_or(0);
    let mut faces_at = vec![0_u32; most];
    boundary.iter().for_each(|edge| faces_at[edge.1.index()] += 1);
    let mut next = vec![NONE; most];
    let mut polygons = Vec::new();
    for edges in boundary.chunk_by(|a, b| a.0 == b.0) {
        for (edge, at) in edges.iter().zip(0..) {
            next[edge.1.index()] = at;
        }
        let mut polygon = Vec::new();
        let mut at = 0;
        let mut is_loop = edges.windows(2).all(|pair| pair[0].1 != pair[1].1);
        for step in 1..=edges.len() {
            let (_, from, to) = edges[at];
            if faces_at[from.index()] > 2 {
                polygon.push(from);
            }
            at = next.get(to.index()).map_or(usize::MAX, |&at| at as usize);
            is_loop &= at < edges.len() && (at == 0) == (step == edges.len());
            if !is_loop {
                break;
            }
        }
        edges.iter().for_each(|edge| next[edge.1.index()] = NONE);
        if !is_loop {
            return Err(Contradiction::Loop);
        }
        if polygon.len() < 3 {
            return Err(Contradiction::Face);
        }
        polygons.push(polygon);
    }
    Ok(polygons)
}
