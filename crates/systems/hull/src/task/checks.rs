//! The checks of hulls that are reported.

use crate::algorithm::Contradiction;
use predicament_tasks::Check;

pub(super) const IN_PLANE: &[Check] = &[
    Check::topology("vertices", "vertices are some of the scene's, each once"),
    Check::topology("span", "there are as many vertices as what the points span takes"),
    Check::topology("start", "the first vertex is the leftmost"),
    Check::topology("convex", "no turn is to the right"),
    Check::topology("extreme", "no vertex is in the middle of an edge"),
    Check::topology("wound once", "the polygon goes around once"),
    Check::topology("inside", "no point is outside"),
    Check::topology("smallest index", "of several points in one place the first stands for all"),
    Check::topology("extreme vertices", "the vertices are those of the definition, where the points are few"),
    Check::invariants("chains meet in their ends", &[&[Contradiction::Chains.rule()]]),
];

/// The invariants that the algorithms in space check themselves.
const RULES: &[&str] = Contradiction::RULES;

pub(super) const IN_SPACE: &[Check] = &[
    Check::topology("vertices", "vertices are some of the scene's, each once, and those of the faces"),
    Check::topology("span", "there are as many vertices and faces as what the points span takes"),
    Check::topology("two faces", "what is flat has two faces, what is a segment or a point none"),
    Check::topology("faces", "a face has three different vertices or more"),
    Check::topology("closed", "each edge of a face is one of another face, in the other direction"),
    Check::topology("euler", "V − E + F = 2"),
    Check::topology("manifold", "the faces at a vertex make a ring"),
    Check::topology("connected", "the faces are one surface"),
    Check::topology("planar", "the vertices of a face are in its plane"),
    Check::topology("face convex", "a face turns to one side only"),
    Check::topology("extreme", "no vertex is in the middle of an edge of a face"),
    Check::topology("convex", "no face has a vertex of its neighbour outside"),
    Check::topology("coplanar faces", "no two neighbours are in one plane"),
    Check::topology("wound once", "a ray from inside meets one face"),
    Check::topology("inside", "no point is outside of a face"),
    Check::topology("smallest index", "of several points in one place the first stands for all"),
    Check::topology("extreme vertices", "the vertices are those of the definition, where the points are few"),
    Check::invariants("adding points, or joining hulls, does not contradict itself", &[RULES]),
];
