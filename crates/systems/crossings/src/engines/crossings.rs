
    // REPLACE. For each segment the numbers of those that cross it, in their order along it. Each pair is tried.
    fn crossings(&self, segments: &[Segment]) -> Result<Vec<Vec<u32>>, String> {
        let crossed = |&[a, b]: &Segment| {
            let mut along: Vec<(f64, u32)> = Vec::new();
            for (other, &[c, d]) in (0..).zip(segments) {
                let [from, to] = [turn(c, d, a), turn(c, d, b)];
                if from * to < 0.0 && turn(a, b, c) * turn(a, b, d) < 0.0 {
                    along.push((from / (from - to), other));
                }
            }
            along.sort_by(|p, q| p.0.total_cmp(&q.0));
            along.into_iter().map(|(_, other)| other).collect()
        };
        Ok(segments.iter().map(crossed).collect())
    }
}

fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
