//! The crate `i_triangle`, on its default grid. It wants an outer ring counterclockwise and then holes clockwise: the outer
//! ring's bounding box has all others in it. Other nests of rings, such as islands in holes, are declined.

use i_triangle::float::unchecked::UncheckedTriangulatable;
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
        // The low corner of the bounding box, then the high one with its sign changed.
        let extent = |ring: &Vec<u32>| {
            let low = |of: &dyn Fn([f64; 2]) -> f64| ring.iter().map(|v| of(at(v))).fold(f64::INFINITY, f64::min);
            [low(&|p| p[0]), low(&|p| p[1]), low(&|p| -p[0]), low(&|p| -p[1])]
        };
        let mut rings: Vec<_> = rings.iter().map(|ring| (extent(ring), ring.clone())).collect();
        rings.sort_by(|(one, _), (other, _)| one.partial_cmp(other).expect("finite points"));
        let holds = |i: usize, j: usize| i != j && (0..4).all(|k| rings[i].0[k] <= rings[j].0[k]);
        let all = 0..rings.len();
        if !all.clone().skip(1).all(|j| holds(0, j)) || all.clone().skip(1).any(|i| all.clone().any(|j| holds(i, j))) {
            return Err("the rings are not an outer ring with holes".to_owned());
        }
        let mut rings: Vec<Vec<u32>> = rings.into_iter().map(|(_, ring)| ring).collect();
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
