
    // REPLACE. Pairs of simplices that meet, each with the indices of its points. Of edges, each pair is tried.
    fn contacts2d(&self, points: &[[f64; 2]], a: &Simplices, b: &Simplices) -> Result<Vec<[Vec<u32>; 2]>, String> {
        let edge = |simplex: &Vec<u32>| match simplex[..] {
            [v, w] => Ok([points[v as usize], points[w as usize]]),
            _ => Err("this example takes edges".to_owned()),
        };
        let mut pairs = Vec::new();
        for s in a {
            for t in b {
                if meet(edge(s)?, edge(t)?) {
                    pairs.push([s.clone(), t.clone()]);
                }
            }
        }
        Ok(pairs)
    }
}

fn meet([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let is_apart = (0..2).any(|axis| {
        let [a, b, c, d] = [a, b, c, d].map(|point| point[axis]);
        a.max(b) < c.min(d) || c.max(d) < a.min(b)
    });
    !is_apart && turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0
}

fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
