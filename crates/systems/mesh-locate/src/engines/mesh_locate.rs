
    // REPLACE. For each probe 1 inside, 0 outside, -2 on the surface. This counts the triangles above a probe.
    fn mesh_locate(&self, mesh: &Mesh, probes: &[[f64; 3]]) -> Result<Vec<i64>, String> {
        let corners = |triangle: &[u32; 3]| triangle.map(|v| mesh.vertices[v as usize]);
        let above = |&probe| mesh.triangles.iter().filter(|triangle| is_above(corners(triangle), probe)).count();
        Ok(probes.iter().map(|probe| above(probe) as i64 % 2).collect())
    }
}

fn is_above([a, b, c]: [[f64; 3]; 3], p: [f64; 3]) -> bool {
    let turns = [turn(b, c, p), turn(c, a, p), turn(a, b, p)];
    let is_over = turns.iter().all(|&t| t > 0.0) || turns.iter().all(|&t| t < 0.0);
    is_over && (turns[0] * a[2] + turns[1] * b[2] + turns[2] * c[2]) / turns.iter().sum::<f64>() > p[2]
}

fn turn(p: [f64; 3], q: [f64; 3], r: [f64; 3]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
