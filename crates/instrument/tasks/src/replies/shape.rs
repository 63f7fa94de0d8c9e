//! Polygons and meshes of an answer, read from its arrays.

use std::collections::BTreeMap;

use predicament_predicates::{Scene, Vertex};

use super::{Arrays, Malformed};

/// Polygons in coordinates: for each polygon its rings, the outer one first. A ring does not repeat its first point.
pub type Rings = Vec<Vec<Vec<[f64; 2]>>>;

/// A mesh in coordinates.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Mesh {
    /// The vertices.
    pub points: Vec<[f64; 3]>,
    /// The triangles, each with three indices of vertices.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A mesh of some of the triangles, with the vertices that they use.
    #[must_use]
    pub fn only(&self, triangles: &[[u32; 3]]) -> Mesh {
        let mut places: BTreeMap<u32, u32> = triangles.as_flattened().iter().map(|&v| (v, 0)).collect();
        (0..).zip(places.values_mut()).for_each(|(at, place)| *place = at);
        Mesh {
            points: places.keys().map(|&v| self.points[v as usize]).collect(),
            triangles: triangles.iter().map(|triangle| triangle.map(|v| places[&v])).collect(),
        }
    }

    /// The corners of each triangle.
    #[must_use]
    pub fn corners(&self) -> Vec<[[f64; 3]; 3]> {
        self.triangles.iter().map(|triangle| triangle.map(|v| self.points[v as usize])).collect()
    }
}

impl Arrays {
    /// The polygons with this name. Without `NAME.starts` there is one ring; without `NAME.polygons`, all rings are one
    /// polygon.
    ///
    /// # Errors
    /// [`Malformed`] if an array is missing or has a wrong form.
    pub fn polygons(&self, name: &str) -> Result<Rings, Malformed> {
        let points = self.points::<2>(name)?;
        let starts = format!("{name}.starts");
        let rings: Vec<Vec<[f64; 2]>> = match self.get(&starts) {
            None if points.is_empty() => Vec::new(),
            None => vec![ring(points)],
            Some(_) => self.ranges(&starts, points.len())?.into_iter().map(|range| ring(&points[range])).collect(),
        };
        let polygons = format!("{name}.polygons");
        if self.get(&polygons).is_none() {
            return Ok(if rings.is_empty() { Vec::new() } else { vec![rings] });
        }
        Ok(self.ranges(&polygons, rings.len())?.into_iter().map(|range| rings[range].to_vec()).collect())
    }

    /// The mesh with this name.
    ///
    /// # Errors
    /// [`Malformed`] if an array is missing or has a wrong form, or a triangle has a vertex that does not exist.
    pub fn mesh(&self, name: &str) -> Result<Mesh, Malformed> {
        let points = self.points::<3>(&format!("{name}.vertices"))?.to_vec();
        let key = format!("{name}.triangles");
        let triangles = self.tuples::<3>(&key, points.len())?;
        let number = |v: Vertex| u32::try_from(v.index()).expect("an index of 32 bits");
        Ok(Mesh { points, triangles: triangles.into_iter().map(|triangle| triangle.map(number)).collect() })
    }

    /// The meshes with this name. Without `NAME.starts` there is one.
    ///
    /// # Errors
    /// As [`Arrays::mesh`]; also if an array of places is wrong.
    pub fn meshes(&self, name: &str) -> Result<Vec<Mesh>, Malformed> {
        let all = self.mesh(name)?;
        let starts = format!("{name}.starts");
        if self.get(&starts).is_none() {
            return Ok(if all.triangles.is_empty() { Vec::new() } else { vec![all] });
        }
        let ranges = self.ranges(&starts, all.triangles.len())?.into_iter();
        Ok(ranges.map(|range| all.only(&all.triangles[range])).collect())
    }

    /// The polylines with this name.
    ///
    /// # Errors
    /// As [`Arrays::points`] and [`Arrays::ranges`].
    pub fn lines(&self, name: &str) -> Result<Vec<&[[f64; 2]]>, Malformed> {
        let points = self.points::<2>(name)?;
        Ok(self.ranges(&format!("{name}.starts"), points.len())?.into_iter().map(|range| &points[range]).collect())
    }

    /// A label for each of `probes` probes.
    ///
    /// # Errors
    /// As [`Arrays::ids`]; also if the number of labels is another one.
    pub fn labels(&self, name: &str, probes: usize) -> Result<&[u32], Malformed> {
        let labels = self.ids(name)?;
        if labels.len() == probes {
            return Ok(labels);
        }
        Err(Malformed(format!("`{name}` has {} labels for {probes} probes", labels.len())))
    }

    /// Adds polygons under a name.
    ///
    /// # Panics
    /// If there are 2^32 points.
    pub fn add_polygons(&mut self, name: &str, polygons: &Rings) {
        let number = |count: usize| u32::try_from(count).expect("fewer than 2^32 points");
        let (mut numbers, mut starts, mut firsts) = (Vec::new(), vec![0], vec![0]);
        for rings in polygons {
            for ring in rings {
                numbers.extend_from_slice(ring.as_flattened());
                starts.push(number(numbers.len() / 2));
            }
            firsts.push(number(starts.len() - 1));
        }
        self.add(name, super::Array::Numbers(numbers));
        self.add(format!("{name}.starts"), super::Array::Ids(starts));
        self.add(format!("{name}.polygons"), super::Array::Ids(firsts));
    }

    /// Adds lists of whole numbers under a name.
    ///
    /// # Panics
    /// If there are 2^32 numbers.
    pub fn add_lists<L: AsRef<[u32]>>(&mut self, name: &str, lists: &[L]) {
        self.add(name, super::Array::Ids(lists.iter().flat_map(|list| list.as_ref()).copied().collect()));
        self.add_starts(name, lists.iter().map(|list| list.as_ref().len()));
    }

    /// Adds polylines under a name.
    ///
    /// # Panics
    /// If there are 2^32 points.
    pub fn add_lines(&mut self, name: &str, lines: &[Vec<[f64; 2]>]) {
        self.add(name, super::Array::Numbers(lines.iter().flatten().flatten().copied().collect()));
        self.add_starts(name, lines.iter().map(Vec::len));
    }

    /// Adds meshes under a name.
    ///
    /// # Panics
    /// If there are 2^32 vertices or triangles.
    pub fn add_meshes(&mut self, name: &str, meshes: &[Mesh]) {
        let mut all = Mesh::default();
        for mesh in meshes {
            let before = u32::try_from(all.points.len()).expect("fewer than 2^32 vertices");
            all.points.extend(&mesh.points);
            all.triangles.extend(mesh.triangles.iter().map(|triangle| triangle.map(|v| v + before)));
        }
        self.add_mesh(name, &all);
        self.add_starts(name, meshes.iter().map(|mesh| mesh.triangles.len()));
    }

    /// Adds the places of lists in an array, by their lengths.
    fn add_starts(&mut self, name: &str, lengths: impl Iterator<Item = usize>) {
        let mut starts = vec![0];
        let mut total = 0;
        starts.extend(lengths.map(|length| {
            total += length;
            u32::try_from(total).expect("fewer than 2^32 items")
        }));
        self.add(format!("{name}.starts"), super::Array::Ids(starts));
    }

    /// Adds a mesh under a name.
    pub fn add_mesh(&mut self, name: &str, mesh: &Mesh) {
        self.add(format!("{name}.vertices"), super::Array::Numbers(mesh.points.as_flattened().to_vec()));
        self.add(format!("{name}.triangles"), super::Array::Ids(mesh.triangles.as_flattened().to_vec()));
    }

    /// Adds tuples of input vertices under a name.
    ///
    /// # Panics
    /// If there are 2^32 vertices.
    pub fn add_vertices<'v>(&mut self, name: &str, vertices: impl IntoIterator<Item = &'v Vertex>) {
        let number = |v: &Vertex| u32::try_from(v.index()).expect("fewer than 2^32 vertices");
        self.add(name, super::Array::Ids(vertices.into_iter().map(number).collect()));
    }
}

/// A ring without its first point at the end.
fn ring(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    match points {
        [first, between @ .., last] if first == last => [std::slice::from_ref(first), between].concat(),
        points => points.to_vec(),
    }
}

/// A scene of points that are in no other scene, for drawings and files.
///
/// # Errors
/// If a coordinate is not finite.
pub(super) fn scene_of<const D: usize>(points: &[[f64; D]]) -> std::io::Result<Scene> {
    let dimension =
        if D == 2 { predicament_predicates::Dimension::Two } else { predicament_predicates::Dimension::Three };
    Scene::new(dimension, points.as_flattened().to_vec()).map_err(std::io::Error::other)
}
