//! Segments with a common point are in one cell together, for all places and lengths.

use predicament_grid::Raster;

/// A sequence of pseudorandom numbers.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, n: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(self.0 >> 33).unwrap() % n
    }
}

type Ends = [[i64; 2]; 2];

fn turn([ax, ay]: [i64; 2], [bx, by]: [i64; 2], [px, py]: [i64; 2]) -> i64 {
    ((bx - ax) * (py - ay) - (by - ay) * (px - ax)).signum()
}

/// True if two closed segments have a common point, in integers.
fn meet([a, b]: Ends, [c, d]: Ends) -> bool {
    let boxes = (0..2).all(|i| a[i].min(b[i]) <= c[i].max(d[i]) && c[i].min(d[i]) <= a[i].max(b[i]));
    boxes && turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0
}

fn cells_of(raster: &Raster, count: usize) -> Vec<Vec<usize>> {
    let mut cells = vec![Vec::new(); count];
    for cell in 0..raster.count() {
        assert!(raster.cell(cell).is_sorted());
        raster.cell(cell).iter().for_each(|&segment| cells[segment as usize].push(cell));
    }
    cells
}

/// Integers as coordinates at a scale, exactly.
#[allow(clippy::cast_precision_loss)] // below 2^20
fn scaled(segments: &[Ends], scale: f64) -> Vec<[[f64; 2]; 2]> {
    segments.iter().map(|ends| ends.map(|end| end.map(|x| x as f64 * scale))).collect()
}

#[test]
fn segments_that_meet_share_a_cell() {
    let mut numbers = Numbers(1);
    let mut met = 0;
    for round in 0..60 {
        let side = [4, 40, 1_000, 100_000][round % 4];
        let reach = [side, side / 4 + 1, 3][round % 3];
        let segments: Vec<Ends> = (0..120)
            .map(|_| {
                let a = [numbers.below(side), numbers.below(side)];
                [a, a.map(|x| x + numbers.below(2 * reach + 1) - reach)]
            })
            .collect();
        // The largest and the smallest scales at which halves and products neither overflow nor lose a bit.
        for scale in [1.0, 2.0_f64.powi(1000), 2.0_f64.powi(-900), f64::from_bits(1)] {
            let raster = Raster::new(&scaled(&segments, scale));
            let cells = cells_of(&raster, segments.len());
            assert!(cells.iter().all(|cells| !cells.is_empty()));
            for i in 0..segments.len() {
                for j in (0..i).filter(|&j| meet(segments[i], segments[j])) {
                    met += 1;
                    assert!(cells[i].iter().any(|cell| cells[j].contains(cell)), "round {round}: {i} and {j}");
                }
            }
        }
    }
    assert!(met > 10_000, "{met}");
}

#[test]
fn a_diagonal_is_in_the_cells_that_it_passes() {
    let mut segments: Vec<Ends> = (0..2_000).map(|i| [[i, 0], [i, 1]]).collect();
    segments.extend((0..2_000).map(|i| [[0, i], [1, i]]));
    segments.push([[0, 0], [2_000, 2_000]]);
    let raster = Raster::new(&scaled(&segments, 1.0));
    assert!(raster.count() > 1_000);
    let side = raster.count().isqrt();
    let passed = cells_of(&raster, segments.len()).pop().unwrap().len();
    assert!(passed <= 3 * side, "{passed} of {} cells", raster.count());
    assert!(raster.entries() < 8 * segments.len());
}

#[test]
fn rays_upward_find_what_is_above() {
    let segments: Vec<Ends> = (0..400).map(|i| [[i % 20, i / 20], [i % 20 + 1, i / 20]]).collect();
    let raster = Raster::new(&scaled(&segments, 1.0));
    let mut found = Vec::new();
    let mut all = 0;
    raster.upward([7.5, 7.5], 4.5, |segments, _| {
        found.extend_from_slice(segments);
        all += 1;
        false
    });
    for row in 5..20 {
        assert!(found.contains(&(20 * row + 7)), "row {row}");
    }
    let mut rows = 0;
    raster.upward([7.5, 7.5], 4.5, |_, row| {
        rows += 1;
        row >= raster.last_row(6.0)
    });
    assert!(2 * rows < all, "{rows} of {all}");
}
