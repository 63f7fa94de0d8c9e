
    // REPLACE. The indices of the hull's corners, one after the other. This is Andrew's monotone chain.
    fn hull2d(&self, points: &[[f64; 2]]) -> Result<Vec<u32>, String> {
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        let [x, y] = [0, 1].map(|axis: usize| move |v: &u32| points[*v as usize][axis]);
        order.sort_by(|a, b| x(a).total_cmp(&x(b)).then(y(a).total_cmp(&y(b))));
        if order.len() < 2 {
            return Ok(order);
        }
        let lower = chain(points, &order);
        order.reverse();
        Ok([lower, chain(points, &order)].concat())
    }
}

/// The corners to the right of all others, without the last one.
fn chain(points: &[[f64; 2]], order: &[u32]) -> Vec<u32> {
    let mut found: Vec<u32> = Vec::new();
    for &at in order {
        while let [.., a, b] = found[..]
            && turn(points[a as usize], points[b as usize], points[at as usize]) <= 0.0
        {
            found.pop();
        }
        found.push(at);
    }
    found.pop();
    found
}

fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
