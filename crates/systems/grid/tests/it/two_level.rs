//! The grid of two levels, compared with every box, with every cell, and for any number of threads.

use std::collections::{BTreeMap, BTreeSet};

use predicament_grid::Bounds;
use predicament_grid::two_level::{MOST_ENTRIES, Ray, Sizes, TwoLevel};
use proptest::prelude::*;

type Box3 = Bounds<3>;

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0_f64,
        2 => (-4..4_i32).prop_map(f64::from),
        1 => prop::sample::select(vec![0.0, -0.0, 5e-324, -1e-310, f64::MAX, f64::MIN, 1e308, 1e-290]),
    ]
}

fn small() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 0.0..0.3_f64, 1 => Just(0.0), 1 => 0.0..4.0_f64]
}

fn boxes() -> impl Strategy<Value = Vec<Box3>> {
    let one = (prop::array::uniform3(coordinate()), prop::array::uniform3(small())).prop_map(|(low, size)| {
        let high = [0, 1, 2].map(|axis: usize| (low[axis] + size[axis]).min(f64::MAX));
        Bounds { low, high }
    });
    prop::collection::vec(one, 0..60)
}

fn sizes() -> impl Strategy<Value = Sizes> {
    (prop::array::uniform3(1..6_u32), 1..5_u32, 0..6_u32).prop_map(|(coarse, fine, full)| Sizes { coarse, fine, full })
}

/// Corners and a few points of a box.
fn points(one: &Box3) -> Vec<[f64; 3]> {
    let mut points = Vec::new();
    for corner in 0..8 {
        points.push([0, 1, 2].map(|axis: usize| if corner >> axis & 1 == 0 { one.low[axis] } else { one.high[axis] }));
    }
    for part in [0.25, 0.5, 0.9] {
        points.push([0, 1, 2].map(|axis: usize| {
            let x = one.low[axis] / 2.0 * (1.0 - part) * 2.0 + one.high[axis] * part;
            x.clamp(one.low[axis], one.high[axis])
        }));
    }
    points
}

/// True if a ray from a point meets a box.
fn meets(one: &Box3, p: [f64; 3], ray: Ray) -> bool {
    let is_over =
        (0..3).filter(|&axis| axis != ray.axis).all(|axis| one.low[axis] <= p[axis] && p[axis] <= one.high[axis]);
    is_over && if ray.is_up { one.high[ray.axis] >= p[ray.axis] } else { one.low[ray.axis] <= p[ray.axis] }
}

proptest! {
    #[test]
    fn a_point_of_a_box_is_in_a_cell_that_lists_the_box(boxes in boxes(), sizes in sizes()) {
        for sizes in [sizes, Sizes::of(&boxes)] {
            let grid = TwoLevel::new(&boxes, sizes);
            for (at, one) in (0..).zip(&boxes) {
                for p in points(one) {
                    let entries = grid.entries(grid.at(p));
                    prop_assert!(entries.contains(&at), "{p:?} of {one:?}, {sizes:?}");
                    prop_assert!(entries.is_sorted());
                }
            }
        }
    }

    #[test]
    fn rays_pass_every_box_in_their_way(boxes in boxes(), sizes in sizes(), p in prop::array::uniform3(coordinate())) {
        let grid = TwoLevel::new(&boxes, sizes);
        for ray in Ray::ALL {
            let (mut seen, mut slots, mut before) = (BTreeSet::new(), BTreeSet::new(), None);
            grid.along(p, ray, |slot, entries, last| {
                assert!(slots.insert(slot), "each once");
                seen.extend(entries.iter().copied());
                assert!(before.is_none_or(|before| if ray.is_up { before < last } else { before > last }));
                before = Some(last);
                // Boxes that were not visited are beyond the last step.
                for (at, one) in (0..).zip(&boxes).filter(|(_, one)| meets(one, p, ray)) {
                    let [low, high] = [one.low, one.high].map(|corner| grid.step(ray.axis, corner[ray.axis]));
                    assert!(seen.contains(&at) || if ray.is_up { low > last } else { high < last });
                }
                false
            });
            for (at, one) in (0..).zip(&boxes) {
                prop_assert!(!meets(one, p, ray) || seen.contains(&at), "{one:?} from {p:?} by {ray:?}");
            }
            let mut visited = 0;
            grid.along(p, ray, |_, _, _| {
                visited += 1;
                true
            });
            prop_assert_eq!(visited, 1, "it ends where it is told");
        }
    }

    #[test]
    fn the_middle_of_a_cell_is_in_the_cell(boxes in boxes(), sizes in sizes()) {
        let grid = TwoLevel::new(&boxes, sizes);
        let mut slots = BTreeSet::new();
        for p in boxes.iter().flat_map(points) {
            // A cell that contains a double has a middle.
            let slot = grid.at(p);
            slots.insert(slot);
            let middle = grid.middle(slot).expect("it holds a point");
            prop_assert_eq!(grid.at(middle), slot, "{:?}", middle);
        }
        prop_assert!(boxes.is_empty() || !slots.is_empty());
    }

    #[test]
    fn the_grid_is_the_same_on_any_number_of_threads(boxes in boxes(), sizes in sizes()) {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let grid = TwoLevel::new(&boxes, sizes);
                let regions = grid.empty_regions();
                (grid, regions)
            })
        };
        prop_assert_eq!(on(1), on(3));
    }
}

/// Pseudorandom numbers.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from((self.0 >> 33) % u64::from(n)).unwrap()
    }
}

/// Asserts that the regions of empty cells are those of a flood fill through all fine steps of a lattice, each of unit
/// size. The first and the last step are solid.
fn flood_agrees(sides: [u32; 3], solid: &BTreeSet<[u32; 3]>, sizes: Sizes) {
    let what = format!("{sizes:?} over {solid:?}");
    // Points in the middle of their cells, so that each is in one cell; two corners span the whole grid.
    let mut boxes: Vec<Box3> = solid
        .iter()
        .map(|at| Bounds { low: at.map(|x| f64::from(x) + 0.25), high: at.map(|x| f64::from(x) + 0.75) })
        .collect();
    boxes.push(Bounds { low: [0.0; 3], high: [0.5; 3] });
    boxes.push(Bounds { low: sides.map(|side| f64::from(side) - 0.5), high: sides.map(f64::from) });
    let grid = TwoLevel::new(&boxes, sizes);
    let regions = grid.empty_regions();
    let mut flood: BTreeMap<[u32; 3], usize> = BTreeMap::new();
    let mut count = 0;
    let [_, ny, nz] = sides;
    for start in (0..sides.iter().product()).map(|n: u32| [n / nz / ny, n / nz % ny, n % nz]) {
        if solid.contains(&start) || flood.contains_key(&start) {
            continue;
        }
        let mut open = vec![start];
        flood.insert(start, count);
        while let Some(at) = open.pop() {
            for axis in 0..3 {
                for step in [at[axis].checked_sub(1), Some(at[axis] + 1).filter(|&x| x < sides[axis])] {
                    let Some(x) = step else { continue };
                    let mut next = at;
                    next[axis] = x;
                    if !solid.contains(&next) && flood.insert(next, count).is_none() {
                        open.push(next);
                    }
                }
            }
        }
        count += 1;
    }
    // A coarse cell with a box in it is refined, so every empty step is an empty cell or in one.
    let mut of_flood: BTreeMap<usize, usize> = BTreeMap::new();
    for (at, flooded) in &flood {
        let found = regions.of(grid.at(at.map(|x| f64::from(x) + 0.5)));
        let found = found.unwrap_or_else(|| panic!("{at:?} is empty: {what}"));
        assert_eq!(*of_flood.entry(*flooded).or_insert(found), found, "{what}");
    }
    assert_eq!(of_flood.values().collect::<BTreeSet<_>>().len(), count, "{what}");
    assert_eq!(regions.len(), count, "{what}");
    let is_at_border = |at: &[u32; 3]| (0..3).any(|axis| at[axis] == 0 || at[axis] == sides[axis] - 1);
    let open: BTreeSet<usize> = flood.keys().filter(|at| is_at_border(at)).map(|at| of_flood[&flood[at]]).collect();
    assert!((0..count).all(|region| regions.is_open(region) == open.contains(&region)), "{what}");
    let named: Vec<_> = regions.first().iter().map(|&slot| regions.of(slot)).collect();
    assert_eq!(named, (0..count).map(Some).collect::<Vec<_>>(), "a cell of each");
    assert!(regions.first().is_sorted());
    assert!(solid.iter().all(|at| regions.of(grid.at(at.map(|x| f64::from(x) + 0.5))).is_none()));
}

#[test]
fn empty_regions_are_those_that_a_flood_finds() {
    // 12 × 12 × 12 fine cells of unit size; walls of unit boxes with gaps.
    let mut random = Random(1);
    for _ in 0..60 {
        let side = 12;
        let mut solid: BTreeSet<[u32; 3]> = [[0; 3], [side - 1; 3]].into();
        let axis = random.below(3) as usize;
        let wall = random.below(10) + 1;
        let holes = random.below(3);
        for i in 0..side {
            for j in 0..side {
                if random.below(144) >= holes {
                    let mut at = [i; 3];
                    at[axis] = wall;
                    at[(axis + 1) % 3] = i;
                    at[(axis + 2) % 3] = j;
                    solid.insert(at);
                }
            }
        }
        for _ in 0..random.below(200) {
            solid.insert([(); 3].map(|()| random.below(12)));
        }
        // The same number of fine cells, in coarse cells of several sizes.
        for (coarse, fine) in [([6; 3], 2), ([12; 3], 1), ([3; 3], 4), ([3; 3], 3)] {
            flood_agrees([side; 3], &solid, Sizes { coarse, fine, full: 0 });
        }
    }
}

/// Slabs of eight coarse cells are joined separately, then with each other: across one seam or several, between coarse
/// cells, between fine cells, and between a coarse and a fine cell.
#[test]
fn empty_regions_lead_across_the_seams_of_slabs() {
    let mut random = Random(2);
    for round in 0..30 {
        let sides = [34, 6, 6];
        let mut solid: BTreeSet<[u32; 3]> = [[0; 3], [33, 5, 5]].into();
        // From long passages to many pockets, some of which are at one border only.
        for _ in 0..[100, 500, 1000][round % 3] {
            solid.insert(sides.map(|side| random.below(side)));
        }
        // Of 17 coarse cells, the last is a separate slab.
        for (coarse, fine) in [([17, 3, 3], 2), ([34, 6, 6], 1)] {
            flood_agrees(sides, &solid, Sizes { coarse, fine, full: 0 });
        }
    }
}

#[test]
fn what_has_no_extent_along_an_axis_has_one_cell_there() {
    // A wall in the plane x = 1, across the way, without a way around it.
    let square = |y: f64, z: f64| Bounds { low: [1.0, y, z], high: [1.0, y + 0.5, z + 0.5] };
    let mut boxes: Vec<Box3> = (0..8).map(|y| square(f64::from(y), 3.0)).collect();
    boxes.extend([square(0.0, 0.0), square(7.5, 7.5)]);
    let grid = TwoLevel::new(&boxes, Sizes { coarse: [2, 4, 4], fine: 4, full: 0 });
    let regions = grid.empty_regions();
    let [above, below] = [[1.0, 3.0, 6.0], [1.0, 3.0, 1.5]].map(|p| regions.of(grid.at(p)).unwrap());
    assert_ne!(above, below);
    assert_eq!(regions.of(grid.at([50.0, 3.0, 6.0])), Some(above), "what is off the plane goes to the nearest cell");
    let nothing = TwoLevel::new(&[], Sizes::of(&[]));
    assert_eq!((nothing.slots(), nothing.all_entries(), nothing.empty_regions().len()), (1, 0, 1));
}

#[test]
fn boxes_of_a_plane_or_a_line_are_listed_where_they_are() {
    // 24 unit boxes along axes with an extent; refined cells have one layer along the other axes.
    for flat in [vec![0], vec![1], vec![2], vec![0, 1], vec![1, 2], vec![0, 2]] {
        let count = if flat.len() == 1 { 24 } else { 1 };
        let place = |i: u32, j: u32| {
            let mut at = [i, j].into_iter();
            [0, 1, 2].map(|axis: usize| if flat.contains(&axis) { 7.0 } else { f64::from(at.next().unwrap_or(0)) })
        };
        let boxes: Vec<Box3> = (0..24)
            .flat_map(|i| (0..count).map(move |j| (i, j)))
            .map(|(i, j)| {
                let low = place(i, j);
                let width = |axis: usize| if flat.contains(&axis) { 0.0 } else { 0.5 };
                Bounds { low, high: [0, 1, 2].map(|axis| low[axis] + width(axis)) }
            })
            .collect();
        let grid = TwoLevel::new(&boxes, Sizes { coarse: [3; 3], fine: 8, full: 0 });
        assert_eq!(grid.slots(), boxes.len(), "24 steps along each other axis than {flat:?}");
        for (at, one) in (0..).zip(&boxes) {
            assert_eq!(grid.entries(grid.at(one.low)), [at], "without {flat:?}");
        }
    }
}

#[test]
fn a_cell_is_refined_if_it_has_more_boxes_than_fill_it() {
    let boxes: Vec<Box3> =
        (0..5).map(|at| Bounds { low: [f64::from(at); 3], high: [f64::from(at) + 0.5; 3] }).collect();
    let refined = |full: u32| TwoLevel::new(&boxes, Sizes { coarse: [1; 3], fine: 2, full }).refined();
    assert_eq!([refined(4), refined(5)], [1, 0]);
}

#[test]
fn no_sizes_have_more_entries_than_are_allowed() {
    let mut bound = 0;
    for size in 1..40_u32 {
        // Cubes that overlap more and more.
        let boxes: Vec<Box3> = (0..1_000_u32)
            .map(|at| {
                let low = [at % 10, at / 10 % 10, at / 100].map(f64::from);
                Bounds { low, high: low.map(|x| x + f64::from(size) / 8.0) }
            })
            .collect();
        let sizes = Sizes { fine: 1, ..Sizes::of(&boxes) };
        let most = MOST_ENTRIES * boxes.len() as u64;
        let entries = |sizes: Sizes| TwoLevel::new(&boxes, sizes).all_entries() as u64;
        assert!(entries(sizes) <= most, "{} of cubes of {size}/8", entries(sizes));
        // A grid twice as fine would be a little too fine.
        let finer = entries(Sizes { coarse: sizes.coarse.map(|coarse| 2 * coarse + 1), ..sizes });
        bound += usize::from(finer > most && finer <= 2 * most);
    }
    assert!(bound > 3, "{bound}");
}
#[test]
fn entries_are_bounded_whatever_the_boxes() {
    // Needles as long as the whole extent, and small boxes.
    let mut boxes: Vec<Box3> = (0..2_000)
        .map(|at| {
            let [y, z] = [at % 40, at / 40].map(f64::from);
            Bounds { low: [0.0, y, z], high: [50.0, y + 0.5, z + 0.5] }
        })
        .collect();
    boxes.extend((0..20).map(|at| Bounds { low: [0.0; 3], high: [50.0, 40.0, f64::from(at)] }));
    let sizes = Sizes::of(&boxes);
    let coarse = TwoLevel::new(&boxes, Sizes { fine: 1, ..sizes });
    assert!(coarse.all_entries() as u64 <= MOST_ENTRIES * boxes.len() as u64);
    assert_eq!(coarse.refined(), 0);
    let grid = TwoLevel::new(&boxes, sizes);
    assert!(grid.refined() > 0 && grid.slots() > coarse.slots());
    // Lists are sorted part by part, in parallel.
    assert!(grid.slots() > 8_192, "{}", grid.slots());
    for one in &boxes {
        assert!([one.low, one.high].iter().all(|&p| grid.entries(grid.at(p)).is_sorted()));
    }
    assert_eq!(grid.bytes(), 4 * (grid.slots() + 1 + grid.all_entries() + coarse.slots() + 1));
}
