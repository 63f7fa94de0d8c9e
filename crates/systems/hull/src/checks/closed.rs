//! Checks that faces close to a connected surface, by their vertices alone.

use std::collections::HashMap;

use predicament_predicates::Vertex;

use super::tally::Tally;

/// The face of each directed edge.
pub(super) type Edges = HashMap<[Vertex; 2], usize>;

/// The edges of a face, each from its start to its end.
pub(super) fn edges_of(face: &[Vertex]) -> impl Iterator<Item = [Vertex; 2]> + '_ {
    face.iter().zip(face.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// Checks the closed surface of these faces, and returns its edges.
///
/// `faces`: each has three or more different vertices. `closed`: each edge is in two faces, once in each direction.
/// `manifold`: the faces at a vertex make one ring. `connected`: there is one surface. `euler`: V − E + F = 2.
pub(super) fn closed(tally: &mut Tally<'_>, vertices: &[Vertex], faces: &[Vec<Vertex>]) -> Edges {
    let mut edges = Edges::new();
    for (at, face) in faces.iter().enumerate() {
        let mut corners = face.clone();
        corners.sort_unstable();
        corners.dedup();
        if corners.len() < face.len() || face.len() < 3 {
            tally.flaw("faces", face, || {
                format!("face {at} has {} different vertices of {}", corners.len(), face.len())
            });
            return edges;
        }
        for edge in edges_of(face) {
            if edges.insert(edge, at).is_some() {
                tally.flaw("closed", &edge, || format!("two faces have the edge {} → {}", edge[0], edge[1]));
            }
        }
    }
    for [a, b] in faces.iter().flat_map(|face| edges_of(face)) {
        if !edges.contains_key(&[b, a]) {
            tally
                .flaw("closed", &[a, b], || format!("one face has the edge {a} → {b}; no face has the edge {b} → {a}"));
        }
    }
    let mut corners: Vec<Vertex> = faces.iter().flatten().copied().collect();
    let uses = corners.len();
    corners.sort_unstable();
    corners.dedup();
    if corners != vertices {
        tally.flaw("vertices", &[], || format!("{} vertices, {} of faces", vertices.len(), corners.len()));
    }
    if tally.is_clean() {
        rings(tally, &corners, faces);
        connected(tally, faces, &edges);
        let euler = (corners.len() + faces.len()).cast_signed() - (uses / 2).cast_signed();
        if euler != 2 {
            tally.flaw("euler", &[], || format!("V − E + F = {euler}"));
        }
    }
    edges
}

/// Checks for each vertex that the faces around it make one ring.
fn rings(tally: &mut Tally<'_>, corners: &[Vertex], faces: &[Vec<Vertex>]) {
    // The vertex before a corner in its face, keyed by the edge that starts at the corner.
    let mut before: HashMap<[Vertex; 2], Vertex> = HashMap::new();
    let mut degree: HashMap<Vertex, usize> = HashMap::new();
    let mut first: HashMap<Vertex, Vertex> = HashMap::new();
    for face in faces {
        let n = face.len();
        for at in 0..n {
            let [last, here, next] = [face[(at + n - 1) % n], face[at], face[(at + 1) % n]];
            before.insert([here, next], last);
            *degree.entry(here).or_default() += 1;
            first.insert(here, next);
        }
    }
    for &v in corners {
        let (wanted, start) = (degree[&v], first[&v]);
        let mut next = start;
        let mut around = 0;
        while around < wanted {
            around += 1;
            // The face on the other side of the edge continues at the vertex before.
            next = before[&[v, next]];
            if next == start {
                break;
            }
        }
        if around != wanted {
            tally.flaw("manifold", &[v], || format!("{around} of {wanted} faces at {v} make a ring"));
        }
    }
}

fn connected(tally: &mut Tally<'_>, faces: &[Vec<Vertex>], edges: &Edges) {
    let mut seen = vec![false; faces.len()];
    let mut found = vec![0];
    let mut count = 0;
    while let Some(at) = found.pop() {
        if std::mem::replace(&mut seen[at], true) {
            continue;
        }
        count += 1;
        found.extend(edges_of(&faces[at]).map(|[a, b]| edges[&[b, a]]));
    }
    if count != faces.len() {
        tally.flaw("connected", &[], || format!("{count} of {} faces are one surface", faces.len()));
    }
}
