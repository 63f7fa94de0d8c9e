//! The checks of hulls that are reported.

use crate::algorithm::Contradiction;
use predicament_tasks::Check;

pub(super) const IN_PLANE: &[Check] = &[
    Check::topology("vertices", "the vertices are vertices of the scene, each once"),
    Check::topology("span", "the number of vertices fits the dimension that the points span"),
    Check::topology("start", "the first vertex is the leftmost"),
    Check::topology("convex", "the polygon does not turn to the right"),
    Check::topology("extreme", "vertices are not in the middle of an edge"),
    Check::topology("wound once", "the polygon goes around once"),
    Check::topology("inside", "points are not outside"),
    Check::topology("smallest index", "the smallest index stands for all points at one place"),
    Check::topology("extreme vertices", "the vertices are the extreme points by definition (few points only)"),
    Check::invariants("the chains meet only in their ends", &[&[Contradiction::Chains.rule()]]),
];

/// The invariants that the algorithms in space check themselves.
const RULES: &[&str] = Contradiction::RULES;

pub(super) const IN_SPACE: &[Check] = &[
    Check::topology("vertices", "the vertices are vertices of the scene, each once, and are the vertices of the faces"),
    Check::topology("span", "the numbers of vertices and faces fit the dimension that the points span"),
    Check::topology("two faces", "a flat hull has two faces; a segment or a point has no face"),
    Check::topology("faces", "a face has at least three different vertices"),
    Check::topology("closed", "each edge of a face is an edge of another face, in the opposite direction"),
    Check::topology("euler", "V − E + F = 2"),
    Check::topology("manifold", "the faces at a vertex make a ring"),
    Check::topology("connected", "the faces make one surface"),
    Check::topology("planar", "the vertices of a face are in its plane"),
    Check::topology("face convex", "a face is convex"),
    Check::topology("extreme", "vertices are not in the middle of an edge of a face"),
    Check::topology("convex", "the vertices of a neighbour are not in front of a face"),
    Check::topology("coplanar faces", "neighbouring faces are not in one plane"),
    Check::topology("wound once", "a ray from inside meets one face"),
    Check::topology("inside", "points are not in front of a face"),
    Check::topology("smallest index", "the smallest index stands for all points at one place"),
    Check::topology("extreme vertices", "the vertices are the extreme points by definition (few points only)"),
    Check::invariants("adding points, or joining hulls, does not contradict itself", &[RULES]),
];
