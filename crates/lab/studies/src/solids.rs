//! Closed meshes that studies build by coordinates: boxes, and spheres of triangles.

use predicament_mesh_intersect::algorithm::cascade::Closed;

/// The box with these corners; corner `k` is on the upper side of axis `a` if bit `a` of `k` is set.
pub(crate) fn boxed(points: [[f64; 3]; 8]) -> Closed {
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Closed { points: points.to_vec(), triangles }
}

/// An octahedron on the unit sphere, with each edge halved `levels` times: points and triangles.
pub(crate) fn sphere(levels: usize) -> Closed {
    let on_sphere = |p: [f64; 3]| {
        let length = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
        p.map(|x| x / length)
    };
    let mut points = vec![[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]];
    let mut triangles: Vec<[u32; 3]> =
        vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    for _ in 0..levels {
        let mut middles = std::collections::BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let [p, q] = [points[a as usize], points[b as usize]];
                points.push(on_sphere([0, 1, 2].map(|axis: usize| p[axis] + q[axis])));
                u32::try_from(points.len() - 1).expect("few points")
            })
        };
        let divided = triangles.iter().flat_map(|&[a, b, c]| {
            let [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, d, f], [b, e, d], [c, f, e], [d, e, f]]
        });
        triangles = divided.collect();
    }
    Closed { points, triangles }
}
