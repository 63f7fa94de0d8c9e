
    // REPLACE. Triangles of the Delaunay triangulation, as three indices of points. Every triangle is tried.
    fn delaunay2d(&self, points: &[[f64; 2]], constraints: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, String> {
        if points.len() > 24 || !constraints.is_empty() {
            return Err("this example takes at most 24 points, and no constraints".to_owned());
        }
        let all = 0..points.len() as u32;
        let is_empty = |row: &[u32; 3]| is_empty(points, row.map(|v| points[v as usize]));
        let rows = all.clone().flat_map(|a| all.clone().flat_map(move |b| (a + 1..b).map(move |c| [a, b, c])));
        // Each triangle begins with its least point, and is tried in both directions.
        Ok(rows.flat_map(|[a, b, c]| [[a, b, c], [a, c, b]]).filter(is_empty).collect())
    }
}

fn is_empty(points: &[[f64; 2]], [p, q, r]: [[f64; 2]; 3]) -> bool {
    turn(p, q, r) > 0.0 && points.iter().all(|&s| [p, q, r].contains(&s) || in_circle(p, q, r, s) <= 0.0)
}

fn in_circle(p: [f64; 2], q: [f64; 2], r: [f64; 2], s: [f64; 2]) -> f64 {
    let row = |[x, y]: [f64; 2]| [x - s[0], y - s[1], (x - s[0]).powi(2) + (y - s[1]).powi(2)];
    let [[a, b, e], [c, d, f], [g, h, i]] = [p, q, r].map(row);
    a * (d * i - f * h) - b * (c * i - f * g) + e * (c * h - d * g)
}

fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
