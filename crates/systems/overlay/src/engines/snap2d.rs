
    // REPLACE. For each segment a list of points with coordinates that are multiples of `side`. This rounds ends and
    // crossings, one by one.
    fn snap2d(&self, segments: &[Segment], side: f64) -> Result<Vec<Vec<[f64; 2]>>, String> {
        let chain = |&[a, b]: &Segment| {
            let mut parts = vec![0.0, 1.0];
            for &[c, d] in segments {
                let [from, to] = [turn(c, d, a), turn(c, d, b)];
                if from * to < 0.0 && turn(a, b, c) * turn(a, b, d) < 0.0 {
                    parts.push(from / (from - to));
                }
            }
            parts.sort_by(f64::total_cmp);
            let at = |part: f64| [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
            parts.into_iter().map(|part| at(part).map(|x| (x / side).round() * side)).collect()
        };
        Ok(segments.iter().map(chain).collect())
    }
}

fn turn(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
}
