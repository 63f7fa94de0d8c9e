//! Sessions that are exact except for their turns.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Plane, Predicates, Scene, Sign, Vertex, forward_to};

/// A session that is exact, except that a function decides its turns.
pub struct Turns<'s, F> {
    exact: <Exact as Backend>::Session<'s, Off>,
    reach: f64,
    turn: F,
}

/// A planted fault: one triple's turn is reversed.
pub fn one_flip(scene: &Scene, flipped: [Vertex; 3]) -> Turns<'_, impl Fn(Sign, &Scene, Plane, [Vertex; 3]) -> Sign> {
    let turn = move |sign: Sign, _: &Scene, _, mut sorted: [Vertex; 3]| {
        sorted.sort_unstable();
        if sorted == flipped { -sign } else { sign }
    };
    Turns { exact: Exact.prepare(scene, Off).unwrap(), reach: 0.0, turn }
}

/// A session that sees points on an edge if they are at most `reach` above or below it.
pub fn banded(scene: &Scene, reach: f64) -> Turns<'_, impl Fn(Sign, &Scene, Plane, [Vertex; 3]) -> Sign> {
    let turn = move |_, scene: &Scene, plane, args: [Vertex; 3]| {
        let [a, b, c] = args.map(|v| scene.point2(plane, v));
        let area = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
        if area.abs() <= reach * (a[0] - b[0]).abs() { Sign::Zero } else { Sign::of(area) }
    };
    Turns { exact: Exact.prepare(scene, Off).unwrap(), reach, turn }
}

impl<F: Fn(Sign, &Scene, Plane, [Vertex; 3]) -> Sign + Send + Sync> Predicates for Turns<'_, F> {
    forward_to!(exact: scene, compare, orient3d, incircle, insphere);

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        (self.turn)(self.exact.orient2d(plane, a, b, c), self.exact.scene(), plane, [a, b, c])
    }
    fn reach(&self) -> f64 {
        self.reach
    }
}
