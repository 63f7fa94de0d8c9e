
    // REPLACE. For each ray the triangles that it hits, in their order along it. Each triangle is tried.
    fn mesh_rays(&self, mesh: &Mesh, rays: &[Ray], extent: &str) -> Result<Vec<Vec<u32>>, String> {
        let counts = |place: f64| (extent == "line" || place >= 0.0) && (extent != "segment" || place <= 1.0);
        let hits = |&ray: &Ray| {
            let mut along: Vec<(f64, u32)> = Vec::new();
            for (face, triangle) in (0..).zip(&mesh.triangles) {
                let place = ray_hit(triangle.map(|v| mesh.vertices[v as usize]), ray);
                along.extend(place.filter(|place| counts(*place)).map(|place| (place, face)));
            }
            along.sort_by(|p, q| p.0.total_cmp(&q.0));
            along.into_iter().map(|(_, face)| face).collect()
        };
        Ok(rays.iter().map(hits).collect())
    }
}

/// The place of the hit on the ray, if there is one: from 0 at its first point to 1 at its second.
fn ray_hit([a, b, c]: [[f64; 3]; 3], [p, q]: Ray) -> Option<f64> {
    let [along, u, v, from_a] = [minus(q, p), minus(b, a), minus(c, a), minus(p, a)];
    let across = cross(along, v);
    let volume = dot(u, across);
    let second = dot(from_a, across) / volume;
    let other = cross(from_a, u);
    let third = dot(along, other) / volume;
    (second >= 0.0 && third >= 0.0 && second + third <= 1.0).then(|| dot(v, other) / volume)
}

fn minus(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn dot(p: [f64; 3], q: [f64; 3]) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

fn cross(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}
