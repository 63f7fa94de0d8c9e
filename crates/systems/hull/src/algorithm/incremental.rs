//! Convex hulls in space by insertion in random order.

use predicament_predicates::{Predicates, Vertex};

use super::first::{Span, span};
use super::plane::{PlaneMethod, flat};
use super::scratch::Scratch;
use super::surface::Surface;
use super::{Contradiction, Hull3, faces};

/// The minimum number of vertices for inserting extreme vertices first.
const FEW: usize = 64;
/// The number of directions whose extreme vertices are inserted first: −1, 0 or 1 along each axis, except (0, 0, 0).
const DIRECTIONS: usize = 26;

/// The hull of these vertices. Faces are unsorted, and may begin at any vertex.
pub(super) fn hull(session: &dyn Predicates, scratch: &mut Scratch, vertices: &[Vertex]) -> Hull3 {
    let first = match span(session, vertices) {
        Span::Nothing => return Hull3::default(),
        Span::Point(v) => return Hull3 { vertices: vec![v], ..Hull3::default() },
        Span::Line(ends) => return Hull3 { vertices: ends.to_vec(), ..Hull3::default() },
        Span::Flat(plane) => {
            let flat = flat(session, plane, PlaneMethod::Chain, vertices);
            let back = flat.vertices.iter().rev().copied().collect();
            // If signs contradict each other, fewer than three vertices may remain.
            let faces = if flat.vertices.len() < 3 { Vec::new() } else { vec![flat.vertices.clone(), back] };
            return Hull3 { vertices: flat.vertices, faces, broken: flat.broken };
        }
        Span::Space(first) => first,
    };
    let mut surface = Surface::tetrahedron(session, scratch, first, vertices);
    let broken = insert_all(session, &mut surface, vertices).err();
    let (triangles, near) = surface.triangles();
    scratch.clear(vertices);
    let mut hull = faces::merged(session, &triangles, &near);
    hull.broken = broken.or(hull.broken);
    hull
}

fn insert_all(session: &dyn Predicates, surface: &mut Surface<'_>, vertices: &[Vertex]) -> Result<(), Contradiction> {
    if vertices.len() >= FEW {
        for v in extreme(session, vertices) {
            surface.insert(v)?;
        }
    }
    let mut order: Vec<Vertex> = vertices.iter().copied().filter(|&v| surface.is_outside(v)).collect();
    shuffle(&mut order);
    order.into_iter().try_for_each(|v| surface.insert(v))
}

/// The extreme vertices in all directions with components −1, 0 or 1, by rounded coordinates. Once they are inserted,
/// most other vertices are inside.
fn extreme(session: &dyn Predicates, vertices: &[Vertex]) -> [Vertex; DIRECTIONS] {
    let scene = session.scene();
    let mut most = [f64::NEG_INFINITY; DIRECTIONS];
    let mut found = [vertices[0]; DIRECTIONS];
    for &v in vertices {
        let [x, y, z] = scene.point3(v);
        let mut place = 0;
        for of_x in [-x, 0.0, x] {
            for of_y in [of_x - y, of_x, of_x + y] {
                for value in [of_y - z, of_y, of_y + z] {
                    // The middle index stands for the zero vector.
                    if place < DIRECTIONS && value > most[place] {
                        most[place] = value;
                        found[place] = v;
                    }
                    place += 1;
                }
            }
        }
    }
    found
}

/// Shuffles by a fixed sequence of random numbers, from `SplitMix64`.
fn shuffle(items: &mut [Vertex]) {
    let mut state = 0_u64;
    for end in (1..items.len()).rev() {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        // The deviation from uniform is less than 2^-32. Any order is correct.
        let place = (u128::from(bits) * (end as u128 + 1)) >> 64;
        items.swap(end, usize::try_from(place).unwrap_or(0));
    }
}
