//! The rings of a polygon, sorted for libraries that want one outer ring and then holes.

/// The rings of a polygon, the outer one first; `None` if they are not one outer ring with holes in it. The outer ring
/// is the ring whose bounding box has all others in it; a ring in a hole's bounding box is not allowed.
#[must_use]
pub fn outer_first(points: &[[f64; 2]], rings: &[Vec<u32>]) -> Option<Vec<Vec<u32>>> {
    // The low corner of the bounding box, then the high one with its sign changed.
    let extent = |ring: &Vec<u32>| {
        let low =
            |of: &dyn Fn([f64; 2]) -> f64| ring.iter().map(|&v| of(points[v as usize])).fold(f64::INFINITY, f64::min);
        [low(&|p| p[0]), low(&|p| p[1]), low(&|p| -p[0]), low(&|p| -p[1])]
    };
    let mut rings: Vec<_> = rings.iter().map(|ring| (extent(ring), ring.clone())).collect();
    rings.sort_by(|(one, _), (other, _)| one.partial_cmp(other).expect("finite points"));
    let holds = |i: usize, j: usize| i != j && (0..4).all(|k| rings[i].0[k] <= rings[j].0[k]);
    let all = 0..rings.len();
    let is_nest = all.clone().skip(1).all(|j| holds(0, j));
    let is_flat = !all.clone().skip(1).any(|i| all.clone().any(|j| holds(i, j)));
    (is_nest && is_flat).then(|| rings.into_iter().map(|(_, ring)| ring).collect())
}

#[test]
fn islands_in_holes_are_refused() {
    let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
    let points = [square(2.0, 3.0), square(0.0, 9.0), square(4.0, 8.0), square(5.0, 6.0)].concat();
    let ring = |at: u32| (4 * at..4 * at + 4).collect::<Vec<u32>>();
    assert_eq!(outer_first(&points, &[ring(0), ring(1), ring(2)]), Some(vec![ring(1), ring(0), ring(2)]));
    assert_eq!(outer_first(&points, &[ring(1), ring(2), ring(3)]), None);
    assert_eq!(outer_first(&points, &[ring(0), ring(2)]), None);
}
