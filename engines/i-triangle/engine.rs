//! The crate `i_triangle`, on its default grid. It wants an outer ring counterclockwise and then holes clockwise: the outer
//! ring's bounding box has all others in it. Other nests of rings, such as islands in holes, are declined.

use i_triangle::float::unchecked::UncheckedTriangulatable;
use predicament_engine::rings::outer_first;
use predicament_engine::{Engine, Task, locked, serve};

#[derive(Default)]
struct Sweep;

impl Engine for Sweep {
    const NAME: &'static str = "i-triangle";
    const TASKS: &'static [Task] = &[Task::Triangulate];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "i_triangle")
    }

    fn triangulate(&self, points: &[[f64; 2]], rings: &[Vec<u32>]) -> Result<Vec<[u32; 3]>, String> {
        let at = |&v: &u32| points[v as usize];
        let mut rings = outer_first(points, rings).ok_or("the rings are not an outer ring with holes")?;
        for (place, ring) in rings.iter_mut().enumerate() {
            let sides = ring.iter().zip(ring.iter().cycle().skip(1));
            let area: f64 = sides.map(|(a, b)| at(a)[0] * at(b)[1] - at(a)[1] * at(b)[0]).sum();
            if (area > 0.0) != (place == 0) {
                ring.reverse();
            }
        }
        let shape: Vec<Vec<[f64; 2]>> = rings.iter().map(|ring| ring.iter().map(at).collect()).collect();
        let corners = rings.concat();
        let found = shape.unchecked_triangulate().to_triangulation::<u32>();
        // The points come back in another order, on the crate's grid.
        let off = |v: u32, p: [f64; 2]| (at(&v)[0] - p[0]).hypot(at(&v)[1] - p[1]);
        let nearest = |p: &[f64; 2]| corners.iter().copied().min_by(|&v, &w| off(v, *p).total_cmp(&off(w, *p)));
        let ids: Vec<u32> = found.points.iter().filter_map(nearest).collect();
        Ok(found.indices.as_chunks().0.iter().map(|triangle| triangle.map(|at| ids[at as usize])).collect())
    }
}

fn main() -> std::process::ExitCode {
    serve::<Sweep>()
}
