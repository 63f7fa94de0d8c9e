//! Meshes with truths in closed form.
//!
//! All coordinates are integers times a power of two, so integers decide the location of a point. In a lattice of
//! tetrahedra: by floor and the order of the fractions. Between the planes of boxes: by binary search. In nested cubes:
//! by the largest coordinate. A point of a rotated scene is rotated back, which gives its position times 625.

use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::Vertex;

/// A point in units of 2^-UNIT.
pub type Point = [i64; 3];

/// The exponent of the unit. With the largest scene, rotated coordinates and the halves of edges stay within the 53
/// bits of a double.
const UNIT: u32 = 38;
const ONE: i64 = 1 << UNIT;

/// The coordinates as doubles, times 2^-[`UNIT`]: all of the integer's bits fit.
pub fn coordinates(p: Point) -> [f64; 3] {
    p.map(|x| {
        assert!(x.unsigned_abs() <= 1 << 53, "{x}");
        let [high, low] =
            [f64::from(i32::try_from(x >> 32).unwrap()), f64::from(u32::try_from(x & 0xffff_ffff).unwrap())];
        (high * 4_294_967_296.0 + low) / 274_877_906_944.0
    })
}

/// The true locations of points.
pub trait Truth {
    /// The region that contains a point; `None` if it is on a triangle.
    fn region(&self, p: Point) -> Option<u32>;
    /// True if a point is in a region or on its border.
    fn touches(&self, region: u32, p: Point) -> bool;
}

fn number(i: i64) -> u32 {
    u32::try_from(i).expect("few regions")
}

/// A lattice of cubes with a given edge and count along each axis; six tetrahedra make each cube.
struct Lattice {
    side: i64,
    edge: i64,
}

/// The orders of axes from a corner to the opposite one, and true for an even permutation.
const ORDERS: [([usize; 3], bool); 6] = [
    ([0, 1, 2], true),
    ([1, 2, 0], true),
    ([2, 0, 1], true),
    ([1, 0, 2], false),
    ([0, 2, 1], false),
    ([2, 1, 0], false),
];

impl Truth for Lattice {
    fn region(&self, p: Point) -> Option<u32> {
        if p.iter().any(|&x| x < 0 || x > self.side * self.edge) {
            return Some(OUTSIDE);
        }
        let [x, y, z] = p.map(|x| x.div_euclid(self.edge));
        let fraction = p.map(|x| x.rem_euclid(self.edge));
        let order =
            ORDERS.iter().position(|([i, j, k], _)| fraction[*i] > fraction[*j] && fraction[*j] > fraction[*k])?;
        let cube = (x * self.side + y) * self.side + z;
        (!fraction.contains(&0)).then(|| number(6 * cube + 1) + u32::try_from(order).unwrap())
    }

    fn touches(&self, region: u32, p: Point) -> bool {
        let Some(at) = region.checked_sub(1) else {
            return !p.iter().all(|&x| 0 < x && x < self.side * self.edge);
        };
        let cube = i64::from(at / 6);
        let cell = [cube / self.side / self.side, cube / self.side % self.side, cube % self.side];
        let [first, second, third] = ORDERS[at as usize % 6].0.map(|axis| p[axis] - cell[axis] * self.edge);
        self.edge >= first && first >= second && second >= third && third >= 0
    }
}

/// Boxes between planes.
struct Boxes([Vec<i64>; 3]);

impl Boxes {
    /// The position of a cell along the three axes, and the number of cells along each.
    fn cell(&self, at: usize) -> [usize; 3] {
        let [_, ny, nz] = self.0.each_ref().map(|planes| planes.len() - 1);
        [at / nz / ny, at / nz % ny, at % nz]
    }
}

impl Truth for Boxes {
    fn region(&self, p: Point) -> Option<u32> {
        if (0..3).any(|axis| p[axis] < self.0[axis][0] || p[axis] > *self.0[axis].last().unwrap()) {
            return Some(OUTSIDE);
        }
        let mut cube = 0;
        for (planes, x) in self.0.iter().zip(p) {
            let above = planes.binary_search(&x).err()?;
            cube = cube * (planes.len() - 1) + above - 1;
        }
        Some(u32::try_from(cube + 1).unwrap())
    }

    fn touches(&self, region: u32, p: Point) -> bool {
        let Some(at) = region.checked_sub(1) else {
            return (0..3).any(|axis| p[axis] <= self.0[axis][0] || p[axis] >= *self.0[axis].last().unwrap());
        };
        let cell = self.cell(at as usize);
        (0..3).all(|axis| (self.0[axis][cell[axis]]..=self.0[axis][cell[axis] + 1]).contains(&p[axis]))
    }
}

/// Cubes around the origin, by half their edges, ascending: region 1 is between the last cube and the one before.
struct Nested(Vec<i64>);

impl Nested {
    fn out(p: Point) -> i64 {
        p.map(i64::abs).into_iter().max().expect("three coordinates")
    }
}

impl Truth for Nested {
    fn region(&self, p: Point) -> Option<u32> {
        let smaller = self.0.binary_search(&Nested::out(p)).err()?;
        Some(u32::try_from(self.0.len() - smaller).unwrap())
    }

    fn touches(&self, region: u32, p: Point) -> bool {
        let within = self.0.len() - region as usize;
        let out = Nested::out(p);
        self.0.get(within).is_none_or(|&half| out <= half) && (within == 0 || self.0[within - 1] <= out)
    }
}

/// A scene whose points are all rotated by the matrix of the generators.
struct Turned<T>(T);

const TURN: [Point; 3] = [[15, 20, 0], [-12, 9, 20], [16, -12, 15]];

fn turned([x, y, z]: Point) -> Point {
    TURN.map(|[a, b, c]| a * x + b * y + c * z)
}

/// 625 times the original of a rotated point: the matrix is a rotation times 25.
fn turned_back(p: Point) -> Point {
    [0, 1, 2].map(|axis| (0..3).map(|row| TURN[row][axis] * p[row]).sum())
}

impl<T: Truth> Truth for Turned<T> {
    fn region(&self, p: Point) -> Option<u32> {
        self.0.region(turned_back(p))
    }
    fn touches(&self, region: u32, p: Point) -> bool {
        self.0.touches(region, turned_back(p))
    }
}

/// A mesh over points, with the truth about it.
pub struct Case {
    pub points: Vec<Point>,
    pub mesh: MaterialMesh,
    pub truth: Box<dyn Truth>,
}

/// The corners of a lattice and the number of each.
fn corners(planes: &[Vec<i64>; 3]) -> (Vec<Point>, impl Fn([usize; 3]) -> Vertex + use<>) {
    let [_, ny, nz] = planes.each_ref().map(Vec::len);
    let mut points = Vec::new();
    for &x in &planes[0] {
        for &y in &planes[1] {
            points.extend(planes[2].iter().map(|&z| [x, y, z]));
        }
    }
    (points, move |[x, y, z]| Vertex::input((x * ny + y) * nz + z))
}

pub fn lattice(side: i64, turn: bool) -> Case {
    let planes = [(); 3].map(|()| (0..=side).map(|i| i * ONE).collect());
    let (mut points, at) = corners(&planes);
    let count = usize::try_from(side).unwrap();
    let mut tetrahedra = Vec::new();
    for cube in 0..count.pow(3) {
        for (order, is_even) in ORDERS {
            let mut corner = [cube / count / count, cube / count % count, cube % count];
            let mut tetrahedron = [at(corner); 4];
            for (axis, next) in order.into_iter().zip(&mut tetrahedron[1..]) {
                corner[axis] += 1;
                *next = at(corner);
            }
            if is_even {
                tetrahedron.swap(0, 1);
            }
            tetrahedra.push(tetrahedron);
        }
    }
    let mesh = MaterialMesh::of_tetrahedra(points.len(), &tetrahedra).unwrap();
    let truth: Box<dyn Truth> = if turn {
        points = points.into_iter().map(turned).collect();
        Box::new(Turned(Lattice { side, edge: 625 * ONE }))
    } else {
        Box::new(Lattice { side, edge: ONE })
    };
    Case { points, mesh, truth }
}

pub fn boxes(side: i64, turn: bool) -> Case {
    let mut random = Random(2);
    let planes = [side, side - 1, side + 2].map(|count| {
        let mut planes = vec![0];
        (0..count).for_each(|at| planes.push(planes[usize::try_from(at).unwrap()] + ONE * (1 + random.below(16))));
        planes
    });
    let (mut points, at) = corners(&planes);
    let cells = planes.each_ref().map(|planes| planes.len() - 1);
    let (mut triangles, mut sides) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
        let mut counts = cells;
        counts[axis] += 1;
        for place in 0..counts.iter().product() {
            let low = [place / counts[2] / counts[1], place / counts[2] % counts[1], place % counts[2]];
            let moved = |along: &[usize]| {
                let mut corner = low;
                along.iter().for_each(|&axis| corner[axis] += 1);
                at(corner)
            };
            let region =
                |cell: [usize; 3]| u32::try_from((cell[0] * cells[1] + cell[1]) * cells[2] + cell[2] + 1).unwrap();
            // The cell further along the axis is in front.
            let front = if low[axis] == cells[axis] { OUTSIDE } else { region(low) };
            let mut below = low;
            let back = low[axis].checked_sub(1).map_or(OUTSIDE, |under| {
                below[axis] = under;
                region(below)
            });
            let [a, b, c, d] = [moved(&[]), moved(&[next]), moved(&[next, last]), moved(&[last])];
            triangles.extend([[a, b, c], [a, c, d]]);
            sides.extend([[front, back]; 2]);
        }
    }
    let mesh = MaterialMesh::new(points.len(), triangles, sides).unwrap();
    let truth: Box<dyn Truth> = if turn {
        points = points.into_iter().map(turned).collect();
        Box::new(Turned(Boxes(planes.map(|planes| planes.into_iter().map(|x| 625 * x).collect()))))
    } else {
        Box::new(Boxes(planes))
    };
    Case { points, mesh, truth }
}

/// Nested cubes: half of them at equal distances, half of them four units apart.
pub fn nested(count: i64) -> Case {
    let halves: Vec<i64> = (1..=count).map(|i| i * ONE).chain((1..=count).map(|i| (count + 1) * ONE + 4 * i)).collect();
    let (mut points, mut triangles, mut sides) = (Vec::new(), Vec::new(), Vec::new());
    for (region, half) in (0..).zip(halves.iter().rev()) {
        let first = points.len();
        points.extend((0..8).map(|at| [0, 1, 2].map(|axis: usize| if at >> axis & 1 == 0 { -half } else { *half })));
        for [a, b, c, d] in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            triangles
                .extend([[a, b, c], [a, c, d]].map(|corners: [usize; 3]| corners.map(|v| Vertex::input(first + v))));
            sides.extend([[region, region + 1]; 2]);
        }
    }
    let mesh = MaterialMesh::new(points.len(), triangles, sides).unwrap();
    Case { points, mesh, truth: Box::new(Nested(halves)) }
}

/// The random number generator SplitMix64.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, end: i64) -> i64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        i64::try_from((z ^ (z >> 31)) % u64::try_from(end).unwrap()).unwrap()
    }

    pub fn of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[usize::try_from(self.below(i64::try_from(all.len()).unwrap())).unwrap()]
    }
}
