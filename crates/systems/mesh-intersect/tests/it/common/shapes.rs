//! Closed and multi-material meshes with small integer coordinates.

use std::collections::{BTreeMap, BTreeSet};

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Question, Scene, Sign, Vertex};

use super::volumes::Surface;

/// A mesh with its own points.
#[derive(Clone, Default, Debug)]
pub struct Shape {
    pub points: Vec<[f64; 3]>,
    pub triangles: Vec<[usize; 3]>,
    /// The regions in front of each triangle and behind it.
    pub sides: Vec<[u32; 2]>,
}

/// A small generator for reproducible samples (splitmix64).
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (x ^ (x >> 31)) % bound
    }

    /// An integer from −`most` to `most`.
    pub fn whole(&mut self, most: u32) -> f64 {
        f64::from(u32::try_from(self.below(2 * u64::from(most) + 1)).unwrap()) - f64::from(most)
    }

    pub fn point(&mut self, most: u32) -> [f64; 3] {
        [(); 3].map(|()| self.whole(most))
    }
}

impl Shape {
    pub fn solid(points: Vec<[f64; 3]>, triangles: Vec<[usize; 3]>) -> Shape {
        let sides = vec![[0, 1]; triangles.len()];
        Shape { points, triangles, sides }
    }

    /// A mesh with a region for each tetrahedron that is not flat.
    pub fn tetrahedra(points: Vec<[f64; 3]>, tetrahedra: &[[usize; 4]]) -> Shape {
        let scene = Scene::from_points3(&points).unwrap();
        let turned = |corners: &[usize; 4]| {
            let [a, b, c, d] = corners.map(Vertex::input);
            match predicament_judge::sign(&scene, Question::Orient3d, &[a, b, c, d]) {
                Sign::Positive => Some([a, b, c, d]),
                Sign::Negative => Some([b, a, c, d]),
                Sign::Zero => None,
            }
        };
        let tetrahedra: Vec<[Vertex; 4]> = tetrahedra.iter().filter_map(turned).collect();
        if tetrahedra.is_empty() {
            return Shape::default();
        }
        let mesh = MaterialMesh::of_tetrahedra(points.len(), &tetrahedra).unwrap();
        let triangles = mesh.triangles().iter().map(|triangle| triangle.map(Vertex::index)).collect();
        Shape { points, triangles, sides: mesh.sides().to_vec() }
    }

    /// A lattice of unit cubes with the given number along each axis, six tetrahedra in each.
    pub fn lattice([nx, ny, nz]: [usize; 3]) -> Shape {
        let at = |[x, y, z]: [usize; 3]| (x * (ny + 1) + y) * (nz + 1) + z;
        let (mut points, mut tetrahedra) = (Vec::new(), Vec::new());
        for cell in 0..(nx + 1) * (ny + 1) * (nz + 1) {
            let [x, y, z] = [cell / (nz + 1) / (ny + 1), cell / (nz + 1) % (ny + 1), cell % (nz + 1)];
            points.push([x, y, z].map(|i| f64::from(u32::try_from(i).unwrap())));
            if x == nx || y == ny || z == nz {
                continue;
            }
            for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]] {
                let mut corner = [x, y, z];
                let mut corners = vec![at(corner)];
                for axis in order {
                    corner[axis] += 1;
                    corners.push(at(corner));
                }
                tetrahedra.push(corners.try_into().unwrap());
            }
        }
        Shape::tetrahedra(points, &tetrahedra)
    }

    /// Tetrahedra between neighbours of a closed or open fan of points, around the edge between two other points.
    pub fn fan([top, bottom]: [[f64; 3]; 2], around: &[[f64; 3]], is_closed: bool) -> Shape {
        let points = [&[top, bottom], around].concat();
        let count = around.len();
        let pairs = (0..if is_closed { count } else { count - 1 }).map(|i| [0, 1, 2 + i, 2 + (i + 1) % count]);
        Shape::tetrahedra(points, &pairs.collect::<Vec<_>>())
    }

    pub fn tetrahedron(points: [[f64; 3]; 4]) -> Shape {
        Shape::tetrahedra(points.to_vec(), &[[0, 1, 2, 3]])
    }

    /// The union of unit cubes.
    pub fn cubes(cells: &[[i32; 3]]) -> Shape {
        let cells: BTreeSet<[i32; 3]> = cells.iter().copied().collect();
        let mut shape = Shape::default();
        let mut places: BTreeMap<[i32; 3], usize> = BTreeMap::new();
        for cell in &cells {
            for (axis, step) in [(0, -1), (0, 1), (1, -1), (1, 1), (2, -1), (2, 1)] {
                let mut beside = *cell;
                beside[axis] += step;
                if cells.contains(&beside) {
                    continue;
                }
                let mut place = |by: [i32; 2]| {
                    let mut corner = *cell;
                    corner[axis] += i32::from(step > 0);
                    corner[(axis + 1) % 3] += by[0];
                    corner[(axis + 2) % 3] += by[1];
                    *places.entry(corner).or_insert_with(|| {
                        shape.points.push(corner.map(f64::from));
                        shape.points.len() - 1
                    })
                };
                let [a, b, c, d] = [[0, 0], [1, 0], [1, 1], [0, 1]].map(&mut place);
                let face = if step > 0 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
                shape.triangles.extend(face);
                shape.sides.extend([[0, 1]; 2]);
            }
        }
        shape
    }

    /// A box with two triangles on each side.
    pub fn cuboid(low: [f64; 3], high: [f64; 3]) -> Shape {
        Shape::cubes(&[[0; 3]]).mapped(|p| [0, 1, 2].map(|i: usize| if p[i] == 0.0 { low[i] } else { high[i] }))
    }

    /// An octahedron, with each face subdivided into four `levels` times, rounded to integer coordinates on a sphere.
    pub fn sphere(radius: f64, levels: usize) -> Shape {
        let mut points: Vec<[f64; 3]> =
            [[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]].to_vec();
        let mut triangles: Vec<[usize; 3]> =
            vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
        for _ in 0..levels {
            let mut middles: BTreeMap<[usize; 2], usize> = BTreeMap::new();
            let mut middle = |a: usize, b: usize| {
                *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    points.push([0, 1, 2].map(|i: usize| f64::midpoint(points[a][i], points[b][i])));
                    points.len() - 1
                })
            };
            triangles = triangles
                .into_iter()
                .flat_map(|[a, b, c]| {
                    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
                })
                .collect();
        }
        let on_sphere = |p: [f64; 3]| {
            let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            p.map(|x| (x / length * radius).round())
        };
        Shape::solid(points, triangles).mapped(on_sphere)
    }

    /// A torus around the z axis, a grid of n × m quadrangles, rounded to integer coordinates.
    pub fn torus([radius, pipe]: [f64; 2], [n, m]: [u32; 2]) -> Shape {
        let turn = |i: u32, n: u32| std::f64::consts::TAU * f64::from(i) / f64::from(n);
        let mut points = Vec::new();
        for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
            let (u, v) = (turn(i, n), turn(j, m));
            let out = radius + pipe * v.cos();
            points.push([out * u.cos(), out * u.sin(), pipe * v.sin()].map(f64::round));
        }
        let at = |i: u32, j: u32| ((i % n) * m + j % m) as usize;
        let quadrangle = |(i, j): (u32, u32)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        };
        let triangles = (0..n).flat_map(|i| (0..m).map(move |j| (i, j))).flat_map(quadrangle).collect();
        Shape::solid(points, triangles)
    }

    pub fn mapped(mut self, to: impl Fn([f64; 3]) -> [f64; 3]) -> Shape {
        self.points.iter_mut().for_each(|p| *p = to(*p));
        self
    }

    pub fn moved(self, by: [f64; 3]) -> Shape {
        self.mapped(|p| [0, 1, 2].map(|i: usize| p[i] + by[i]))
    }

    /// The shape transformed by a matrix with a positive determinant.
    pub fn sheared(self, rows: [[f64; 3]; 3]) -> Shape {
        self.mapped(|p| rows.map(|row| (0..3).map(|i| row[i] * p[i]).sum()))
    }

    /// The shape with inside and outside exchanged: the surface of a cavity.
    pub fn inverted(mut self) -> Shape {
        self.triangles.iter_mut().for_each(|triangle| triangle.reverse());
        self
    }

    /// Both shapes as one, apart from each other.
    pub fn and(mut self, other: &Shape) -> Shape {
        let first = self.points.len();
        self.points.extend(&other.points);
        self.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|at| at + first)));
        self.sides.extend(&other.sides);
        self
    }

    /// A mesh over all points of a scene; the points from `first` on belong to this shape.
    pub fn mesh(&self, first: usize, all: usize) -> MaterialMesh {
        let triangles = self.triangles.iter().map(|triangle| triangle.map(|at| Vertex::input(first + at))).collect();
        MaterialMesh::new(all, triangles, self.sides.clone()).unwrap()
    }

    /// The boundary of a region.
    pub fn boundary(&self, region: u32) -> Surface {
        let exactly = |triangle: [usize; 3]| triangle.map(|at| self.points[at].map(predicament_judge::rational));
        let turned = |(&[a, b, c], &[front, behind]): (&[usize; 3], &[u32; 2])| match [front, behind] {
            [front, behind] if front == behind => None,
            [_, behind] if behind == region => Some(exactly([a, b, c])),
            [front, _] if front == region => Some(exactly([a, c, b])),
            _ => None,
        };
        self.triangles.iter().zip(&self.sides).filter_map(turned).collect()
    }

    /// The regions except the outside.
    pub fn regions(&self) -> std::ops::RangeInclusive<u32> {
        1..=self.sides.as_flattened().iter().copied().max().unwrap_or(0)
    }
}
