//! The predicates from formulas that the project ships.
//!
//! To add a predicate, add an entry here, a suite in `corpora/`, and a line to the table of `docs/FORMULAS.md`.

use crate::Definition;

/// A shipped predicate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Entry {
    /// The name, for suites and the command line.
    pub name: &'static str,
    /// The meaning of the sign, in one line.
    pub about: &'static str,
    /// The names of the points, in the order of arguments.
    pub points: &'static [&'static str],
    /// The number of coordinates of a point, without weights.
    pub dimension: usize,
    /// The formula.
    pub text: &'static str,
}

impl Entry {
    /// The entry as a definition.
    #[must_use]
    pub fn definition(&self) -> Definition {
        Definition {
            name: self.name.to_owned(),
            about: self.about.to_owned(),
            text: self.text.to_owned(),
            points: self.points.iter().map(|&point| point.to_owned()).collect(),
            dimension: Some(self.dimension),
        }
    }
}

/// The shipped predicates, by dimension and degree.
pub const CATALOGUE: &[Entry] = &[
    Entry {
        name: "compare_distance2d",
        about: "which of two vertices is nearer to a third one, in the plane: positive if the second is",
        points: &["p", "a", "b"],
        dimension: 2,
        text: "sq(a - p) - sq(b - p)",
    },
    Entry {
        name: "side_of_bisector",
        about: "the side of the bisector of two vertices on which a third one lies: positive on the second's side",
        points: &["a", "b", "p"],
        dimension: 2,
        text: "dot(b - a, (p - a) + (p - b))",
    },
    Entry {
        name: "compare_slope",
        about: "the order of the slopes of two segments a b and c d, neither of them vertical",
        points: &["a", "b", "c", "d"],
        dimension: 2,
        text: "u = b - a; v = d - c; cross(v, u) * (u.x * v.x)",
    },
    Entry {
        name: "compare_angle",
        about: "the order of two angles a o b and c q d, counterclockwise and less than half a turn apart",
        points: &["a", "o", "b", "c", "q", "d"],
        dimension: 2,
        text: "u = a - o; v = b - o; s = c - q; t = d - q; cross(u, v) * dot(s, t) - dot(u, v) * cross(s, t)",
    },
    Entry {
        name: "side_of_power_circle",
        about: "the power test of regular triangulations in the plane: positive if d conflicts with a, b, c",
        points: &["a", "b", "c", "d"],
        dimension: 2,
        text: "u = a - d; v = b - d; s = c - d; \
               det([u, sq(u) - (a.w - d.w)], [v, sq(v) - (b.w - d.w)], [s, sq(s) - (c.w - d.w)])",
    },
    Entry {
        name: "circumcentre_side",
        about: "the side of the line p q on which the centre of the circle through a, b, c lies",
        points: &["p", "q", "a", "b", "c"],
        dimension: 2,
        text: "u = b - a; v = c - a; twice = 2 * cross(u, v); \
               centre = [v.y * sq(u) - u.y * sq(v), u.x * sq(v) - v.x * sq(u)]; \
               cross(q - p, twice * (a - p) + centre) * twice",
    },
    Entry {
        name: "compare_distance3d",
        about: "which of two vertices is nearer to a third one, in space: positive if the second is",
        points: &["p", "a", "b"],
        dimension: 3,
        text: "sq(a - p) - sq(b - p)",
    },
    Entry {
        name: "orient_on_sphere",
        about: "the turn of three directions from the origin, points of a sphere: positive if counterclockwise from outside",
        points: &["a", "b", "c"],
        dimension: 3,
        text: "det(a, b, c)",
    },
    Entry {
        name: "same_facing",
        about: "whether two triangles b c u and b c v face the same way: positive if their normals make an acute angle",
        points: &["u", "v", "b", "c"],
        dimension: 3,
        text: "q = b - c; dot(cross(u - c, q), cross(v - c, q))",
    },
    Entry {
        name: "side_of_power_sphere",
        about: "the power test of regular triangulations in space: positive if e conflicts with a, b, c, d",
        points: &["a", "b", "c", "d", "e"],
        dimension: 3,
        text: "u = a - e; v = b - e; s = c - e; t = d - e; \
               det([u, sq(u) - (a.w - e.w)], [v, sq(v) - (b.w - e.w)], \
               [s, sq(s) - (c.w - e.w)], [t, sq(t) - (d.w - e.w)])",
    },
    Entry {
        name: "orient4d",
        about: "the side of the hyperplane of four points of four coordinates on which a fifth one lies; w is the fourth",
        points: &["a", "b", "c", "d", "e"],
        dimension: 3,
        text: "det([a - e, a.w - e.w], [b - e, b.w - e.w], [c - e, c.w - e.w], [d - e, d.w - e.w])",
    },
];
