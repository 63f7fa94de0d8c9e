
    // REPLACE. Pairs of simplices that meet, each with the indices of its points. Of triangles, each pair is tried: an
    // edge of one goes through the other.
    fn contacts3d(&self, points: &[[f64; 3]], a: &Simplices, b: &Simplices) -> Result<Vec<[Vec<u32>; 2]>, String> {
        let triangle = |simplex: &Vec<u32>| match simplex[..] {
            [u, v, w] => Ok([u, v, w].map(|corner| points[corner as usize])),
            _ => Err("this example takes triangles".to_owned()),
        };
        let mut pairs = Vec::new();
        for s in a {
            for t in b {
                let [one, other] = [triangle(s)?, triangle(t)?];
                if goes_through(one, other) || goes_through(other, one) {
                    pairs.push([s.clone(), t.clone()]);
                }
            }
        }
        Ok(pairs)
    }
}

fn goes_through([a, b, c]: [[f64; 3]; 3], other: [[f64; 3]; 3]) -> bool {
    [[a, b], [b, c], [c, a]].into_iter().any(|edge| pierces(edge, other))
}

fn pierces([p, q]: [[f64; 3]; 2], [a, b, c]: [[f64; 3]; 3]) -> bool {
    let sides = [volume(a, b, c, p), volume(a, b, c, q)];
    let turns = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    let is_through = sides[0] * sides[1] <= 0.0 && sides != [0.0, 0.0];
    is_through && (turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0))
}

fn volume(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> f64 {
    let [p, q, r] = [a, b, c].map(|point| [point[0] - d[0], point[1] - d[1], point[2] - d[2]]);
    p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
}
