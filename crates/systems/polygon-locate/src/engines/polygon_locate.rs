
    // REPLACE. For each probe the number of its region, -1 outside of all, -2 on a border. A region is a list of rings
    // of points. This counts crossings.
    fn polygon_locate(&self, regions: &[Polygon], probes: &[[f64; 2]]) -> Result<Vec<i64>, String> {
        let label = |&probe| regions.iter().position(|rings| is_in(rings, probe)).map_or(-1, |at| at as i64);
        Ok(probes.iter().map(label).collect())
    }
}

fn is_in(rings: &Polygon, [x, y]: [f64; 2]) -> bool {
    let edges = rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let crossed =
        edges.filter(|(a, b)| (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    crossed.count() % 2 == 1
}
