//! The crate `earcutr`. It wants an outer ring and then holes: the outer ring's bounding box has all others in it. Other
//! nests of rings, such as islands in holes, are declined.

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
        // The low corner of the bounding box, then the high one with its sign changed.
        let extent = |ring: &Vec<u32>| {
            let low = |of: &dyn Fn([f64; 2]) -> f64| {
                ring.iter().map(|&v| of(points[v as usize])).fold(f64::INFINITY, f64::min)
            };
            [low(&|p| p[0]), low(&|p| p[1]), low(&|p| -p[0]), low(&|p| -p[1])]
        };
        let mut rings: Vec<_> = rings.iter().map(|ring| (extent(ring), ring.clone())).collect();
        rings.sort_by(|(one, _), (other, _)| one.partial_cmp(other).expect("finite points"));
        let holds = |i: usize, j: usize| i != j && (0..4).all(|k| rings[i].0[k] <= rings[j].0[k]);
        let all = 0..rings.len();
        if !all.clone().skip(1).all(|j| holds(0, j)) || all.clone().skip(1).any(|i| all.clone().any(|j| holds(i, j))) {
            return Err("the rings are not an outer ring with holes".to_owned());
        }
        let rings: Vec<Vec<u32>> = rings.into_iter().map(|(_, ring)| ring).collect();
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
