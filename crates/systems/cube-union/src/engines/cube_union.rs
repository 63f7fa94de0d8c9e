
    // REPLACE. The volume and the area of a union of cubes, and the length of its edges if you like. A cube has x, y
    // and z of its lower corner and the length of its edges. This looks at each cell between the planes of all faces.
    fn cube_union(&self, cubes: &[[f64; 4]]) -> Result<Measures, String> {
        if cubes.len() > 12 {
            return Err("too many cubes for this example".to_owned());
        }
        let planes = [0, 1, 2].map(|axis: usize| {
            let mut all: Vec<f64> = cubes.iter().flat_map(|cube| [cube[axis], cube[axis] + cube[3]]).collect();
            all.sort_by(f64::total_cmp);
            all.dedup();
            all
        });
        // The numbers of a cell are one more than those of its lower planes.
        let is_in = |cell: [usize; 3]| {
            cell.iter().all(|&at| at > 0)
                && cubes.iter().any(|cube| {
                    let spans = |(low, x): (&f64, f64)| *low <= x && x < low + cube[3];
                    cube.iter().zip([0, 1, 2].map(|axis: usize| planes[axis][cell[axis] - 1])).all(spans)
                })
        };
        let mut found = Measures::default();
        for i in 1..planes[0].len() {
            for j in 1..planes[1].len() {
                for k in (1..planes[2].len()).filter(|&k| is_in([i, j, k])) {
                    let side = |axis: usize, at: usize| planes[axis][at] - planes[axis][at - 1];
                    let [a, b, c] = [side(0, i), side(1, j), side(2, k)];
                    found.volume += a * b * c;
                    // Each face on the lower side has one on the upper side.
                    for (before, face) in [([i - 1, j, k], b * c), ([i, j - 1, k], a * c), ([i, j, k - 1], a * b)] {
                        found.area += if is_in(before) { 0.0 } else { 2.0 * face };
                    }
                }
            }
        }
        Ok(found)
    }
}
