
    // REPLACE. For each probe the number of its cell, -1 outside of all, -2 at an end. A cell has two ends.
    fn interval(&self, cells: &[[f64; 2]], probes: &[f64]) -> Result<Vec<i64>, String> {
        let label = |probe: &f64| match cells.iter().position(|[left, right]| left < probe && probe < right) {
            _ if cells.iter().any(|ends| ends.contains(probe)) => -2,
            Some(cell) => cell as i64,
            None => -1,
        };
        Ok(probes.iter().map(label).collect())
    }
}
