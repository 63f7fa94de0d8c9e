
    // REPLACE. The triangles of one polygon. `rings` are its rings, as indices of points. This cuts ears.
    fn triangulate(&self, points: &[[f64; 2]], rings: &[Vec<u32>]) -> Result<Vec<[u32; 3]>, String> {
        let [ring] = rings else { return Err("this example takes polygons without holes".to_owned()) };
        let (mut ring, at) = (ring.clone(), |v: u32| points[v as usize]);
        if ring.windows(2).map(|edge| turn(at(ring[0]), at(edge[0]), at(edge[1]))).sum::<f64>() < 0.0 {
            ring.reverse();
        }
        let mut triangles = Vec::new();
        while ring.len() > 3 {
            let ear = (0..ring.len()).find(|&ear| is_ear(points, &ring, corner(&ring, ear))).unwrap_or(0);
            triangles.push(corner(&ring, ear));
            ring.remove(ear);
        }
        triangles.push(corner(&ring, 1));
        Ok(triangles)
    }
}

fn corner(ring: &[u32], at: usize) -> [u32; 3] {
    [ring[(at + ring.len() - 1) % ring.len()], ring[at], ring[(at + 1) % ring.len()]]
}

fn is_ear(points: &[[f64; 2]], ring: &[u32], corner: [u32; 3]) -> bool {
    let [a, b, c] = corner.map(|v| points[v as usize]);
    let is_in = |p| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
    let others = ring.iter().map(|&v| points[v as usize]).filter(|p| ![a, b, c].contains(p));
    turn(a, b, c) > 0.0 && !others.into_iter().any(is_in)
}

fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
