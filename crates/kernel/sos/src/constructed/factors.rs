//! Ties whose determinant is a product of simpler ones.
//!
//! A slice asks about points of lines on one cutting plane, and lines of a mesh share vertices. The determinant of such
//! a question has factors, each with fewer constructed vertices. The sign of a product is the product of the signs, and
//! its deciding monomial is the product of theirs, so each factor is decided alone. A search through the whole
//! determinant took up to half a second.
//!
//! Let f be the side of a point on a plane P with normal n, D the volume of four points, and X the point of a line p, q
//! on P: X = p + s·(q − p) with s = −f(p)/w and w = n·(q − p).
//!
//! - *A vertex of its own line.* D(p, b, c, X) is s·D(p, b, c, q), and a turn of p, b and X is s times that of p, b, q.
//! - *Points of one line.* Let Y be on the line p, q too. The turn of X, Y, c is that of p, q, c times the difference
//!   of their shares, which is f(Y)/w.
//! - *Points of one plane.* The turn of X, Y, Z of P in a coordinate plane is μ times the component of n that the
//!   coordinate plane drops, with one μ for all coordinate planes. D(p, q, Y, Z) is μ·w, as X is on the line p, q.
//! - *Two of them on another plane.* Let X be the point of the planes P, Q and R with sides f, g and h, W the
//!   determinant of their normals, and Y on P and Q. Then Y = X + t·(normal of P × normal of Q) with t = h(Y)/W, and
//!   μ = −t·g(Z).

pub(super) mod inputs;

use predicament_predicates::{Construction, Question, Scene, Sign, Vertex};
use smallvec::SmallVec;

use super::decide_from;
use super::place::Place;
use super::row::Rows;

/// The side of a tie and the degree of the deciding monomial, if the determinant has factors.
///
/// The inner `None`: zero wherever the input vertices are. The outer `None`: no factors are known.
pub(super) fn decide(scene: &Scene, rows: &Rows, question: Question, args: &[Vertex]) -> Option<Value> {
    let factors = Factors { scene, rows };
    let args: SmallVec<[Vertex; 4]> = args.iter().map(|&v| factors.simplest(v)).collect();
    match (question, &args[..]) {
        (Question::Orient2d(_), &[a, b, c]) => factors
            .by_own_line(question, &args)
            .or_else(|| factors.by_one_line(question, [a, b, c]))
            .or_else(|| factors.by_two_planes(question, [a, b, c]))
            .or_else(|| factors.by_one_plane(question, [a, b, c])),
        (Question::Orient3d, _) => factors.by_own_line(question, &args),
        _ => None,
    }
}

/// The sign of a nonzero polynomial and the degree of its deciding monomial; `None` for an identity.
type Value = Option<(Sign, usize)>;

struct Factors<'q> {
    scene: &'q Scene,
    rows: &'q Rows,
}

impl Factors<'_> {
    fn place(&self, v: Vertex) -> Place {
        Place::simple(self.scene, v)
    }

    /// The input vertex that a vertex is by definition, or else itself.
    fn simplest(&self, v: Vertex) -> Vertex {
        match self.place(v) {
            Place::Input(v) => v,
            Place::Meet(_) => v,
        }
    }

    /// The line and the plane of a point.
    fn meet(&self, v: Vertex) -> Option<([Vertex; 2], [Vertex; 3])> {
        match self.place(v) {
            Place::Meet(Construction::Lpi { line, plane }) => Some((line, plane)),
            _ => None,
        }
    }

    /// A point, and an end of its line among the other vertices.
    fn by_own_line(&self, question: Question, args: &[Vertex]) -> Option<Value> {
        args.iter().enumerate().find_map(|(at, &x)| {
            let (line, [a, b, c]) = self.meet(x)?;
            let end = line.iter().position(|p| args.contains(p))?;
            let mut simpler: SmallVec<[Vertex; 4]> = SmallVec::from_slice(args);
            simpler[at] = line[1 - end];
            let weight = if end == 0 { self.weight(x) } else { -self.weight(x) };
            // A side is that of −f.
            let share = self.value(Question::Orient3d, &[a, b, c, line[end]]);
            Some(product(share, self.value(question, &simpler), weight))
        })
    }

    /// Two of three points on one line.
    fn by_one_line(&self, question: Question, args: [Vertex; 3]) -> Option<Value> {
        (0..3).find_map(|at| {
            let [x, y, z] = [args[at], args[(at + 1) % 3], args[(at + 2) % 3]];
            let (line, _) = self.meet(y)?;
            // The turn of y and the one before it, or of y and the one after it.
            let (other, third, sign) = if self.meet(x)?.0 == line {
                (x, z, Sign::Positive)
            } else if self.meet(z)?.0 == line {
                (z, x, Sign::Negative)
            } else {
                return None;
            };
            let (_, [a, b, c]) = self.meet(other)?;
            let order = self.value(Question::Orient3d, &[a, b, c, y]);
            let turn = self.value(question, &[line[0], line[1], third]);
            Some(product(order, turn, -(sign * self.weight(other))))
        })
    }

    /// Three points of one plane, two of them on another plane, one of which three planes define.
    fn by_two_planes(&self, question: Question, args: [Vertex; 3]) -> Option<Value> {
        let places = args.map(|v| self.place(v));
        for (at, place) in places.iter().enumerate() {
            let Place::Meet(Construction::Tpi(planes)) = place else { continue };
            for (p, q) in [(0, 1), (1, 0), (0, 2), (2, 0), (1, 2), (2, 1)] {
                for step in [1, 2] {
                    let [y, z] = [(at + step) % 3, (at + 3 - step) % 3];
                    let is_on = |v: usize, plane: usize| places[v].on_plane(&planes[plane]);
                    if is_on(y, p) && is_on(y, q) && is_on(z, p) {
                        let side = |plane: usize, v: usize| {
                            let [a, b, c] = planes[plane];
                            self.value(Question::Orient3d, &[a, b, c, args[v]])
                        };
                        let r = 3 - p - q;
                        let of_plane = self.value(question, &planes[p]);
                        let along = product(side(r, y), side(q, z), self.weight(args[at]));
                        // The determinant of the normals in the order of p, q, r; the turn in the order of x, y, z.
                        let is_even = (p + 1) % 3 == q;
                        let sign = if is_even == (step == 1) { Sign::Negative } else { Sign::Positive };
                        return Some(product(of_plane, along, sign));
                    }
                }
            }
        }
        None
    }

    /// Three points of one plane, one of them of a line that is named.
    fn by_one_plane(&self, question: Question, args: [Vertex; 3]) -> Option<Value> {
        let places = args.map(|v| self.place(v));
        let with = |at: usize| {
            let ([p, q], plane) = self.meet(args[at])?;
            let others = [args[(at + 1) % 3], args[(at + 2) % 3]];
            places.iter().all(|place| place.on_plane(&plane)).then_some(([p, q], plane, others))
        };
        // The side has a factor again if another line has a vertex of this line.
        let has_factor = |at: &usize| {
            with(*at).is_some_and(|(line, _, others)| {
                others.iter().any(|&v| self.meet(v).is_some_and(|(other, _)| other.iter().any(|v| line.contains(v))))
            })
        };
        let at = (0..3).find(has_factor).or_else(|| (0..3).find(|&at| with(at).is_some()))?;
        let ([p, q], plane, [y, z]) = with(at)?;
        let turn = self.value(question, &plane);
        let side = self.value(Question::Orient3d, &[p, q, y, z]);
        Some(product(turn, side, -self.weight(args[at])))
    }

    /// The sign of a determinant that may not be a tie.
    fn value(&self, question: Question, args: &[Vertex]) -> Value {
        let are_inputs = args.iter().all(|v| !v.is_constructed());
        match *args {
            [a, b, c] if are_inputs => inputs::decide(self.scene, question, [a, b, c]),
            [a, b, c, d] if are_inputs => inputs::decide(self.scene, question, [a, b, c, d]),
            [a, b, c] => decide_from(self.scene, self.rows, question, [a, b, c], 0),
            [a, b, c, d] => decide_from(self.scene, self.rows, question, [a, b, c, d], 0),
            _ => unreachable!("turns and sides"),
        }
    }

    /// The sign of the weight of a constructed point, which does not move.
    fn weight(&self, v: Vertex) -> Sign {
        self.rows.of(self.scene, v.construction().expect("a constructed vertex")).weight
    }
}

/// The product of two values and a sign.
fn product(a: Value, b: Value, sign: Sign) -> Value {
    a.zip(b).map(|(a, b)| (a.0 * b.0 * sign, a.1 + b.1))
}

#[cfg(test)]
mod tests;
