
    // REPLACE. The parts of a closed mesh that is cut by planes. A plane is three points. This gives the mesh as it is
    // if every plane misses it.
    fn slice(&self, mesh: &Mesh, planes: &[[[f64; 3]; 3]]) -> Result<Vec<Mesh>, String> {
        for &[a, b, c] in planes {
            let side = |&v: &u32| volume(a, b, c, mesh.vertices[v as usize]);
            let sides: Vec<f64> = mesh.triangles.as_flattened().iter().map(side).collect();
            if sides.iter().any(|&side| side < 0.0) && sides.iter().any(|&side| side > 0.0) {
                return Err("this example takes planes that miss the mesh".to_owned());
            }
        }
        Ok(vec![mesh.clone()])
    }
}

fn volume(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> f64 {
    let [p, q, r] = [a, b, c].map(|point| [point[0] - d[0], point[1] - d[1], point[2] - d[2]]);
    p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
}
