//! The quantities that the algorithms of each section compute and compare, by name.
//!
//! One list serves all number types: the calculus derives the bounds from it, floats and rationals test the bounds.

use predicament_error_calculus::Root;
use predicament_error_calculus::vector::minus;

use crate::circles;
use crate::quantities::{
    along, area, distance_squared, edge, edge_edge_weights, height, line_distance, line_distance_squared, normal,
    triangle_vertex_weights, unit, volume,
};

/// The points of a section: A, B, C, D, P and Q.
pub type Points<N, const D: usize> = [[N; D]; 6];

/// A quantity with its section and symbol.
#[derive(Clone, Debug)]
pub struct Named<N> {
    /// The section, such as `4.3`; `ours` for quantities that the paper does not have.
    pub section: &'static str,
    /// The symbol in the paper, such as `â`.
    pub symbol: &'static str,
    /// The value of the quantity.
    pub value: N,
}

/// The formula of an edge's unit vector.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Normalization {
    /// The product û · (1/m), which reproduces the published bounds.
    Reciprocal,
    /// The quotient û/m, with each coordinate divided.
    Division,
}

impl Normalization {
    fn apply<N: Root, const D: usize>(self, u_hat: &[N; D], m: &N) -> [N; D] {
        match self {
            Normalization::Reciprocal => unit(u_hat, m),
            Normalization::Division => std::array::from_fn(|i| u_hat[i].clone() / m.clone()),
        }
    }
}

/// Names the quantities of a section.
fn section<N, const K: usize>(all: &mut Vec<Named<N>>, section: &'static str, named: [(&'static str, N); K]) {
    all.extend(named.into_iter().map(|(symbol, value)| Named { section, symbol, value }));
}

/// The sections of [`plane`].
pub const PLANE: [&str; 5] = ["4.2", "4.3", "4.4", "4.5", "ours"];

/// The sections of [`space`].
pub const SPACE: [&str; 7] = ["5.2", "5.3", "5.4", "5.5", "5.6", "5.7", "ours"];

/// The quantities of section 4, and the determinants of circles.
#[must_use]
pub fn plane<N: Root>(points: &Points<N, 2>, normalization: Normalization) -> Vec<Named<N>> {
    PLANE.into_iter().flat_map(|section| plane_section(section, points, normalization)).collect()
}

/// The quantities of section 5, and the determinants of spheres.
#[must_use]
pub fn space<N: Root>(points: &Points<N, 3>, normalization: Normalization) -> Vec<Named<N>> {
    SPACE.into_iter().flat_map(|section| space_section(section, points, normalization)).collect()
}

/// The quantities of one section of [`plane`]; empty if there is no such section.
#[must_use]
pub fn plane_section<N: Root>(
    of: &str,
    [a, b, c, d, p, q]: &Points<N, 2>,
    normalization: Normalization,
) -> Vec<Named<N>> {
    let mut all = Vec::new();
    match of {
        "4.2" => section(&mut all, "4.2", [("d²", distance_squared(a, b))]),
        "4.3" => {
            let (u_hat, m) = edge(a, b);
            let u = normalization.apply(&u_hat, &m);
            let w = minus(p, a);
            let [a_hat, a_bar] = along(&u, &w, &m);
            section(&mut all, "4.3", [("m", m), ("d", line_distance(&u, &w)), ("â", a_hat), ("ā", a_bar)]);
        }
        "4.4" => {
            let areas =
                [("a_P", area(a, p, b)), ("a_Q", area(a, q, b)), ("a_A", area(p, a, q)), ("a_B", area(p, b, q))];
            section(&mut all, "4.4", areas);
        }
        "4.5" => section(&mut all, "4.5", [("a_A", area(p, b, c)), ("a_B", area(a, p, c)), ("a_C", area(a, b, p))]),
        "ours" => {
            let four = [a, b, c, d].map(Clone::clone);
            section(&mut all, "ours", circles::in_plane(&four));
        }
        _ => {}
    }
    all
}

/// The quantities of one section of [`space`]; empty if there is no such section.
#[must_use]
pub fn space_section<N: Root>(
    of: &str,
    [a, b, c, d, p, q]: &Points<N, 3>,
    normalization: Normalization,
) -> Vec<Named<N>> {
    let mut all = Vec::new();
    match of {
        "5.2" => section(&mut all, "5.2", [("d²", distance_squared(a, b))]),
        "5.3" => {
            let (u_hat, m) = edge(a, b);
            let u = normalization.apply(&u_hat, &m);
            let w = minus(p, a);
            let [a_hat, a_bar] = along(&u, &w, &m);
            section(&mut all, "5.3", [("m", m), ("d²", line_distance_squared(&u, &w)), ("â", a_hat), ("ā", a_bar)]);
        }
        "5.4" => {
            let (u, v, w) = (minus(b, a), minus(q, p), minus(p, a));
            let (r, m_squared) = normal(&u, &v);
            let d_hat = height(&r, &w);
            let [a_hat, b_hat, a_bar, b_bar] = edge_edge_weights(&r, &w, &u, &v, &m_squared);
            let d_hat_squared = d_hat.clone().square();
            section(&mut all, "5.4", [("m²", m_squared), ("d̂", d_hat), ("d̂²", d_hat_squared)]);
            section(&mut all, "5.4", [("â", a_hat), ("b̂", b_hat), ("ā", a_bar), ("b̄", b_bar)]);
        }
        "5.5" => {
            let (u, v, w) = (minus(b, a), minus(c, a), minus(p, a));
            let (r, m_squared) = normal(&u, &v);
            let d_hat = height(&r, &w);
            let [a_hat, b_hat, c_hat] = triangle_vertex_weights(&r, &w, &u, &v, &m_squared);
            section(&mut all, "5.5", [("m²", m_squared), ("d̂", d_hat), ("â", a_hat), ("b̂", b_hat), ("ĉ", c_hat)]);
        }
        "5.6" => {
            let around = [("v_A", volume(b, c, p, q)), ("v_B", volume(c, a, p, q)), ("v_C", volume(a, b, p, q))];
            section(&mut all, "5.6", around);
            section(&mut all, "5.6", [("v_P", volume(a, b, c, p)), ("v_Q", volume(a, b, c, q))]);
        }
        "5.7" => {
            section(&mut all, "5.7", [("v_A", volume(b, c, d, p)), ("v_B", volume(p, c, d, a))]);
            section(&mut all, "5.7", [("v_C", volume(b, p, d, a)), ("v_D", volume(b, c, p, a))]);
        }
        "ours" => {
            let five = [a, b, c, d, p].map(Clone::clone);
            section(&mut all, "ours", circles::in_space(&five));
        }
        _ => {}
    }
    all
}
