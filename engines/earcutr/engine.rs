//! The crate `earcutr`. It wants an outer ring and then holes: the outer ring's bounding box has all others in it. Other
//! nests of rings, such as islands in holes, are declined.

use predicament_engine::rings::outer_first;
use predicament_engine::{Engine, Task, locked, serve};

#[derive(Default)]
struct Ears;

impl Engine for Ears {
    const NAME: &'static str = "earcutr";
    const TASKS: &'static [Task] = &[Task::Triangulate];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "earcutr")
    }

    fn triangulate(&self, points: &[[f64; 2]], rings: &[Vec<u32>]) -> Result<Vec<[u32; 3]>, String> {
        let rings = outer_first(points, rings).ok_or("the rings are not an outer ring with holes")?;
        let lengths = rings[..rings.len() - 1].iter().map(Vec::len);
        let holes: Vec<usize> = lengths
            .scan(0, |end, length| {
                *end += length;
                Some(*end)
            })
            .collect();
        let corners = rings.concat();
        let flat: Vec<f64> = corners.iter().flat_map(|&v| points[v as usize]).collect();
        let found = earcutr::earcut(&flat, &holes, 2).map_err(|error| format!("earcutr: {error}"))?;
        Ok(found.as_chunks().0.iter().map(|triangle| triangle.map(|at| corners[at])).collect())
    }
}

fn main() -> std::process::ExitCode {
    serve::<Ears>()
}
