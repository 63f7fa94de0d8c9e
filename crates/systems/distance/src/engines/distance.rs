
    // REPLACE. The distance of two objects: of polygons, by loops of points, or of meshes, by triangles. Each vertex is
    // measured to each edge of the other object. In the plane, z is 0.
    fn distance(&self, points: &[[f64; 3]], a: &Simplices, b: &Simplices, _dimension: usize) -> Result<f64, String> {
        let to_object = |vertices: &Simplices, parts: &Simplices| {
            let mut least = f64::INFINITY;
            for part in parts {
                for (at, &u) in part.iter().enumerate() {
                    let v = part[(at + 1) % part.len()];
                    for &p in vertices.concat().iter() {
                        least = least.min(to_edge(points[p as usize], points[u as usize], points[v as usize]));
                    }
                }
            }
            least
        };
        Ok(to_object(a, b).min(to_object(b, a)))
    }
}

fn to_edge(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (along, from) = (minus(b, a), minus(p, a));
    let place = (dot(from, along) / dot(along, along)).clamp(0.0, 1.0);
    let off = minus(from, along.map(|x| x * place));
    dot(off, off).sqrt()
}
