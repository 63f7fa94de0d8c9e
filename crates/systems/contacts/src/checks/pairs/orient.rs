//! Closed curves and surfaces, and coherent orientations of them.
//!
//! A complex keeps its simplices sorted, without their orientations. A closed curve or surface has only two coherent
//! orientations per component, and signed counts are compared with zero, so either is fine.

use std::collections::BTreeMap;

use crate::answer::Side;
use predicament_mesh::Complex;
use predicament_predicates::{Sign, Vertex};

/// The reason why a complex is not a closed curve or surface, or can't be oriented.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum NotOriented {
    /// A curve is not closed: a vertex has a wrong number of edges.
    Open {
        /// The complex of the vertex.
        side: Side,
        /// The vertex.
        vertex: Vertex,
        /// The number of its edges.
        degree: usize,
    },
    /// A surface is not closed: an edge has a wrong number of triangles.
    Border {
        /// The complex of the edge.
        side: Side,
        /// The edge.
        edge: [Vertex; 2],
        /// The number of its triangles.
        degree: usize,
    },
    /// A surface has only one side, like a Klein bottle.
    OneSided {
        /// The complex of the surface.
        side: Side,
    },
}

impl std::fmt::Display for NotOriented {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NotOriented::Open { side, vertex, degree } => {
                write!(f, "complex {side} is not a closed curve: vertex {vertex} has {degree} edges")
            }
            NotOriented::Border { side, edge: [a, b], degree } => {
                write!(f, "complex {side} is not a closed surface: edge [{a}, {b}] has {degree} triangles")
            }
            NotOriented::OneSided { side } => write!(f, "complex {side} is a one-sided surface"),
        }
    }
}

impl std::error::Error for NotOriented {}

/// The number of edges of each vertex.
pub(super) fn degrees(complex: &Complex) -> BTreeMap<Vertex, usize> {
    let mut degrees: BTreeMap<Vertex, usize> = complex.vertices().iter().map(|&vertex| (vertex, 0)).collect();
    for vertex in complex.edges().as_flattened() {
        *degrees.entry(*vertex).or_default() += 1;
    }
    degrees
}

/// The number of triangles of each edge.
pub(super) fn triangle_degrees(complex: &Complex) -> BTreeMap<[Vertex; 2], usize> {
    let mut degrees: BTreeMap<[Vertex; 2], usize> = complex.edges().iter().map(|&edge| (edge, 0)).collect();
    for &[a, b, c] in complex.triangles() {
        for edge in [[a, b], [a, c], [b, c]] {
            *degrees.entry(edge).or_default() += 1;
        }
    }
    degrees
}

/// Coherently oriented simplices: the component of each, and `Positive` if it keeps its ascending order, `Negative` if
/// it is reversed.
pub type Oriented = Vec<(usize, Sign)>;

/// Orients the edges of a closed curve; components are numbered in the order of their first edges.
///
/// # Errors
/// [`NotOriented::Open`] if a vertex does not have exactly two edges.
pub fn oriented_curve(complex: &Complex, side: Side) -> Result<Oriented, NotOriented> {
    if let Some((vertex, degree)) = degrees(complex).into_iter().find(|&(_, degree)| degree != 2) {
        return Err(NotOriented::Open { side, vertex, degree });
    }
    // An edge ends positively at its second vertex, negatively at its first.
    let facets = complex.edges().iter().map(|&[a, b]| vec![(a, Sign::Negative), (b, Sign::Positive)]);
    Ok(spread(&facets.collect::<Vec<_>>()).expect("a closed curve has two directions"))
}

/// Orients the triangles of a closed surface; components are numbered in the order of their first triangles.
///
/// # Errors
/// [`NotOriented::Border`] if an edge does not have exactly two triangles, [`NotOriented::OneSided`] if there is no
/// coherent orientation.
pub fn oriented_surface(complex: &Complex, side: Side) -> Result<Oriented, NotOriented> {
    if let Some((edge, degree)) = triangle_degrees(complex).into_iter().find(|&(_, degree)| degree != 2) {
        return Err(NotOriented::Border { side, edge, degree });
    }
    let facets = complex.triangles().iter().map(|&[a, b, c]| {
        // The boundary a → b → c → a runs against the ascending order on [a, c] only.
        vec![([a, b], Sign::Positive), ([a, c], Sign::Negative), ([b, c], Sign::Positive)]
    });
    spread(&facets.collect::<Vec<_>>()).ok_or(NotOriented::OneSided { side })
}

/// Assigns signs to simplices such that each facet, which two simplices share, gets opposite signs from both.
fn spread<F: Ord + Copy>(simplices: &[Vec<(F, Sign)>]) -> Option<Oriented> {
    let mut of_facet: BTreeMap<F, Vec<(usize, Sign)>> = BTreeMap::new();
    for (at, facets) in simplices.iter().enumerate() {
        for &(facet, sign) in facets {
            of_facet.entry(facet).or_default().push((at, sign));
        }
    }
    let mut oriented: Vec<Option<(usize, Sign)>> = vec![None; simplices.len()];
    let mut components = 0;
    for start in 0..simplices.len() {
        if oriented[start].is_some() {
            continue;
        }
        oriented[start] = Some((components, Sign::Positive));
        let mut waiting = vec![start];
        while let Some(at) = waiting.pop() {
            let (_, own) = oriented[at]?;
            for &(facet, sign) in &simplices[at] {
                for &(other, other_sign) in of_facet[&facet].iter().filter(|&&(other, _)| other != at) {
                    // own · sign + theirs · other_sign = 0
                    let theirs = -(own * sign * other_sign);
                    match oriented[other] {
                        None => {
                            oriented[other] = Some((components, theirs));
                            waiting.push(other);
                        }
                        Some((_, found)) if found == theirs => {}
                        Some(_) => return None,
                    }
                }
            }
        }
        components += 1;
    }
    oriented.into_iter().collect()
}
