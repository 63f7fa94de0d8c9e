
    // REPLACE. The polygons of union, intersection, difference and symmetric difference, or of some of them. A polygon
    // is a list of rings, the outer one first. This clips one convex polygon by another (Sutherland and Hodgman 1974).
    fn overlay2d(&self, first: &Polygon, second: &Polygon, _: bool) -> Result<Results<Vec<Polygon>>, String> {
        let ([first], [second]) = (&first[..], &second[..]) else { return Err(TAKEN.to_owned()) };
        if !is_convex(first) || !is_convex(second) {
            return Err(TAKEN.to_owned());
        }
        let (mut ring, mut clip) = (first.clone(), second.clone());
        if turn(clip[0], clip[1], clip[2]) < 0.0 {
            clip.reverse();
        }
        for at in 0..clip.len() {
            ring = clipped(&ring, clip[at], clip[(at + 1) % clip.len()]);
        }
        let intersection = if ring.is_empty() { vec![] } else { vec![vec![ring]] };
        Ok(Results { union: None, intersection: Some(intersection), difference: None, symmetric_difference: None })
    }
}

const TAKEN: &str = "this example takes two convex polygons";

/// The part of a ring on the left of the line from a to b.
fn clipped(ring: &[[f64; 2]], a: [f64; 2], b: [f64; 2]) -> Vec<[f64; 2]> {
    let mut left = Vec::new();
    for (at, &q) in ring.iter().enumerate() {
        let p = ring[(at + ring.len() - 1) % ring.len()];
        let [from_p, from_q] = [turn(a, b, p), turn(a, b, q)];
        if (from_p < 0.0) != (from_q < 0.0) {
            let part = from_p / (from_p - from_q);
            left.push([p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])]);
        }
        if from_q >= 0.0 {
            left.push(q);
        }
    }
    left
}

fn is_convex(ring: &[[f64; 2]]) -> bool {
    let count = ring.len();
    let is_left = |at: usize| turn(ring[at], ring[(at + 1) % count], ring[(at + 2) % count]) > 0.0;
    (1..count).all(|at| is_left(at) == is_left(0))
}

fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
