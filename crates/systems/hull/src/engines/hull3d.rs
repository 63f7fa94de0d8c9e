
    // REPLACE. The triangles of the hull's surface, as three indices of points. Every triangle is tried.
    fn hull3d(&self, points: &[[f64; 3]]) -> Result<Vec<[u32; 3]>, String> {
        if points.len() > 24 {
            return Err("too many points for this example".to_owned());
        }
        let all = 0..points.len() as u32;
        let is_face = |row: &[u32; 3]| {
            let [a, b, c] = row.map(|v| points[v as usize]);
            (0..).zip(points).all(|(at, &p)| row.contains(&at) || volume(a, b, c, p) > 0.0)
        };
        let rows = all.clone().flat_map(|a| all.clone().flat_map(move |b| (a + 1..b).map(move |c| [a, b, c])));
        // Each triangle begins with its least point, and is tried in both directions.
        Ok(rows.flat_map(|[a, b, c]| [[a, b, c], [a, c, b]]).filter(is_face).collect())
    }
}

fn volume(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> f64 {
    let [p, q, r] = [a, b, c].map(|point| [point[0] - d[0], point[1] - d[1], point[2] - d[2]]);
    p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
}
