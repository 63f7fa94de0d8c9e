//! Whole tasks: a scene's arrays become arguments, and results become arrays.

use std::collections::BTreeMap;
use std::time::Instant;

use super::message::{Message, Reply};
use super::server::{Refused, caught};
use super::{Engine, Measures, Mesh, Polygon, Ray, Results, Simplices, Task};

/// The arrays of a task's scene.
struct Asked<'m>(&'m Message);

impl Asked<'_> {
    /// True if the scene has such an array, and it is not empty.
    fn has(&self, name: &str) -> bool {
        self.0.bytes(&format!("ids:{name}")).is_some_and(|bytes| !bytes.is_empty())
    }

    fn ids(&self, name: &str) -> Vec<u32> {
        let bytes = self.0.bytes(&format!("ids:{name}")).unwrap_or_default();
        bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect()
    }

    fn points<const D: usize>(&self, name: &str) -> Vec<[f64; D]> {
        let bytes = self.0.bytes(&format!("numbers:{name}")).unwrap_or_default();
        let numbers: Vec<f64> = bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        numbers.as_chunks().0.to_vec()
    }

    fn tuples<const N: usize>(&self, name: &str) -> Vec<[u32; N]> {
        self.ids(name).as_chunks().0.to_vec()
    }

    fn rings(&self, name: &str) -> Vec<Vec<u32>> {
        let (ids, starts) = (self.ids(name), self.ids(&format!("{name}.starts")));
        starts.windows(2).map(|pair| ids[pair[0] as usize..pair[1] as usize].to_vec()).collect()
    }

    /// The rings of each polygon. Without `regions`, all loops are one polygon of `triangulate`, else one region each.
    fn polygons(&self, is_one: bool) -> Vec<Vec<Vec<u32>>> {
        let (loops, labels) = (self.rings("loops"), self.ids("regions"));
        let mut polygons = Vec::new();
        for (at, ring) in loops.into_iter().enumerate() {
            let label = if self.has("regions") { labels[at] as usize } else { at * usize::from(!is_one) };
            polygons.resize(polygons.len().max(label + 1), Vec::new());
            polygons[label].push(ring);
        }
        polygons
    }

    /// Rings of indices as rings of points.
    fn placed(&self, rings: &[Vec<u32>]) -> Polygon {
        let points = self.points::<2>("points");
        rings.iter().map(|ring| ring.iter().map(|&id| points[id as usize]).collect()).collect()
    }

    /// A mesh with its own vertices.
    fn mesh(&self, name: &str) -> Mesh {
        let (points, mut triangles) = (self.points::<3>("points"), self.tuples::<3>(name));
        let mut own: BTreeMap<u32, u32> = triangles.as_flattened().iter().map(|&id| (id, 0)).collect();
        (0..).zip(own.values_mut()).for_each(|(place, own)| *own = place);
        triangles.as_flattened_mut().iter_mut().for_each(|id| *id = own[id]);
        Mesh { vertices: own.keys().map(|&id| points[id as usize]).collect(), triangles }
    }

    /// The largest simplices of a complex.
    fn complex(&self, name: &str) -> Simplices {
        let vertices = self.ids(&format!("{name}.vertices")).into_iter().map(|vertex| vec![vertex]);
        let kinds = ["edges", "triangles", "tetrahedra"].into_iter();
        vertices.chain(kinds.flat_map(|kind| self.rings(&format!("{name}.{kind}")))).collect()
    }

    /// The points of tuples of indices.
    fn corners<const N: usize, const D: usize>(&self, name: &str) -> Vec<[[f64; D]; N]> {
        let points = self.points::<D>("points");
        self.tuples::<N>(name).into_iter().map(|tuple| tuple.map(|id| points[id as usize])).collect()
    }

    /// The coordinates of all points along the axis of `interval`.
    fn along(&self) -> Result<Vec<f64>, Refused> {
        let dimension = if self.0.need("dimension")? == b"3" { 3 } else { 2 };
        let axis = match self.0.bytes("word:axis") {
            Some(b"z") => 2,
            Some(b"y") => 1,
            _ => 0,
        };
        Ok(self.points::<1>("points").chunks(dimension).map(|point| point[axis.min(dimension - 1)][0]).collect())
    }
}

/// Arrays of an answer.
trait Shape {
    fn add(self, to: Reply, name: &str) -> Reply;
}

impl Shape for Vec<Polygon> {
    fn add(self, to: Reply, name: &str) -> Reply {
        let starts = |lengths: &mut dyn Iterator<Item = usize>| -> Vec<u32> {
            let total = |total: &mut usize, length| {
                *total += length;
                Some(*total as u32)
            };
            std::iter::once(0).chain(lengths.scan(0, total)).collect()
        };
        let points: Vec<f64> = self.iter().flatten().flatten().flatten().copied().collect();
        let to = numbers(to, name, &points);
        let to = ids(to, &format!("{name}.starts"), &starts(&mut self.iter().flatten().map(Vec::len)));
        ids(to, &format!("{name}.polygons"), &starts(&mut self.iter().map(Vec::len)))
    }
}

impl Shape for Mesh {
    fn add(self, to: Reply, name: &str) -> Reply {
        let to = numbers(to, &format!("{name}.vertices"), self.vertices.as_flattened());
        ids(to, &format!("{name}.triangles"), self.triangles.as_flattened())
    }
}

fn ids(to: Reply, name: &str, ids: &[u32]) -> Reply {
    to.with(&format!("ids:{name}"), ids.iter().flat_map(|id| id.to_le_bytes()).collect::<Vec<u8>>())
}

fn numbers(to: Reply, name: &str, numbers: &[f64]) -> Reply {
    to.with(&format!("numbers:{name}"), numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>())
}

fn results<T: Shape>(mut to: Reply, all: Results<T>) -> Reply {
    let named = [
        ("union", all.union),
        ("intersection", all.intersection),
        ("difference", all.difference),
        ("symmetric-difference", all.symmetric_difference),
    ];
    for (name, result) in named {
        to = match result {
            Some(result) => result.add(to, name),
            None => to,
        };
    }
    to
}

/// Lists of different lengths, with their places.
fn lists(to: Reply, name: &str, lists: &[Vec<u32>]) -> Reply {
    starts(ids(to, name, &lists.concat()), name, lists.iter().map(Vec::len))
}

/// The place of each list's first item, and the number of items.
fn starts(to: Reply, name: &str, lengths: impl Iterator<Item = usize>) -> Reply {
    let mut all = vec![0];
    for length in lengths {
        all.push(all[all.len() - 1] + length as u32);
    }
    ids(to, &format!("{name}.starts"), &all)
}

fn pairs(to: Reply, pairs: Vec<[Vec<u32>; 2]>) -> Reply {
    lists(to, "pairs", &pairs.iter().map(|pair| pair.concat()).collect::<Vec<_>>())
}

fn measures(to: Reply, found: Measures) -> Reply {
    let to = numbers(numbers(to, "volume", &[found.volume]), "area", &[found.area]);
    match found.edge_length {
        Some(length) => numbers(to, "edge_length", &[length]),
        None => to,
    }
}

fn parts(to: Reply, parts: Vec<Mesh>) -> Reply {
    let mut all = Mesh::default();
    for part in &parts {
        let before = all.vertices.len() as u32;
        all.vertices.extend(&part.vertices);
        all.triangles.extend(part.triangles.iter().map(|triangle| triangle.map(|v| v + before)));
    }
    starts(all.add(to, "parts"), "parts", parts.iter().map(|part| part.triangles.len()))
}

fn labels(to: Reply, labels: Vec<i64>) -> Reply {
    // −1 and −2 are the two largest numbers of 32 bits.
    ids(to, "labels", &labels.into_iter().map(|label| label as u32).collect::<Vec<u32>>())
}

/// Calls the library, and adds its result to the answer. Only the call is timed.
fn timed<R>(call: impl FnOnce() -> Result<R, String>, add: impl FnOnce(Reply, R) -> Reply) -> Result<Reply, Refused> {
    let start = Instant::now();
    let result = caught(call);
    let ns = start.elapsed().as_nanos().to_string();
    let result = result.map_err(|panic| Refused::Failed(format!("the library panicked: {panic}")))?;
    Ok(add(Reply::new("answer").with("ns", ns), result.map_err(Refused::Declined)?))
}

/// The answer to a message `task`.
pub(super) fn answer<E: Engine>(engine: &E, message: &Message) -> Result<Reply, Refused> {
    let name = String::from_utf8_lossy(message.need("task")?).into_owned();
    let task = E::TASKS.iter().copied().find(|task| task.name() == name);
    let task = task.ok_or_else(|| Refused::Declined(format!("this engine has no `{name}`")))?;
    let asked = Asked(message);
    for several in ["regions", "tetrahedra", "first_regions", "second_regions"] {
        if asked.has(several) && matches!(task, Task::MeshLocate | Task::MeshIntersect) {
            let what = format!("the scene has {several}, and the engine does not take them");
            return Err(Refused::Declined(what));
        }
    }
    let triangles = |to, found: Vec<[u32; 3]>| ids(to, "triangles", found.as_flattened());
    let operand = |name| asked.placed(&asked.rings(name));
    match task {
        Task::Delaunay2d => {
            let (points, constraints) = (asked.points("points"), asked.tuples("constraints"));
            timed(|| engine.delaunay2d(&points, &constraints), triangles)
        }
        Task::Hull2d => {
            let points = asked.points("points");
            timed(|| engine.hull2d(&points), |to, hull| ids(to, "hull", &hull))
        }
        Task::Hull3d => {
            let points = asked.points("points");
            timed(|| engine.hull3d(&points), triangles)
        }
        Task::Triangulate => {
            let (points, polygons) = (asked.points("points"), asked.polygons(true));
            let all = || polygons.iter().map(|rings| engine.triangulate(&points, rings)).collect::<Result<Vec<_>, _>>();
            timed(all, |to, found| {
                let of = (0..).zip(&found).flat_map(|(at, found)| std::iter::repeat_n(at, found.len()));
                ids(triangles(to, found.concat()), "polygons", &of.collect::<Vec<u32>>())
            })
        }
        Task::Overlay2d => {
            let (first, second) = (operand("first"), operand("second"));
            let even_odd = message.bytes("word:rule") != Some(b"non-zero");
            timed(|| engine.overlay2d(&first, &second, even_odd), results)
        }
        Task::PolygonLocate => {
            let regions: Vec<Polygon> = asked.polygons(false).iter().map(|rings| asked.placed(rings)).collect();
            let probes = asked.points("probes");
            timed(|| engine.polygon_locate(&regions, &probes), labels)
        }
        Task::MeshLocate => {
            let (mesh, probes) = (asked.mesh("triangles"), asked.points("probes"));
            timed(|| engine.mesh_locate(&mesh, &probes), labels)
        }
        Task::MeshRays => {
            let rays: Vec<Ray> =
                asked.points::<6>("rays").into_iter().map(|[a, b, c, d, e, f]| [[a, b, c], [d, e, f]]).collect();
            let extent = message.bytes("word:extent").and_then(|word| std::str::from_utf8(word).ok()).unwrap_or("ray");
            let mesh = asked.mesh("triangles");
            timed(|| engine.mesh_rays(&mesh, &rays, extent), |to, found| lists(to, "hits", &found))
        }
        Task::Distance => {
            let is_plane = message.need("dimension")? == b"2";
            let flat = || asked.points::<2>("points").into_iter().map(|[x, y]| [x, y, 0.0]).collect();
            let points = if is_plane { flat() } else { asked.points("points") };
            let (a, b, dimension) = (asked.rings("from"), asked.rings("to"), if is_plane { 2 } else { 3 });
            timed(|| engine.distance(&points, &a, &b, dimension), |to, found| numbers(to, "distance", &[found]))
        }
        Task::MeshIntersect => {
            let (first, second) = (asked.mesh("first"), asked.mesh("second"));
            timed(|| engine.mesh_intersect(&first, &second), results)
        }
        Task::Contacts2d => {
            let (points, a, b) = (asked.points("points"), asked.complex("a"), asked.complex("b"));
            timed(|| engine.contacts2d(&points, &a, &b), pairs)
        }
        Task::Contacts3d => {
            let (points, a, b) = (asked.points("points"), asked.complex("a"), asked.complex("b"));
            timed(|| engine.contacts3d(&points, &a, &b), pairs)
        }
        Task::Crossings => {
            let segments = asked.corners("segments");
            timed(|| engine.crossings(&segments), |to, found| lists(to, "crossings", &found))
        }
        Task::Interval => {
            let along = asked.along()?;
            let place = |id: u32| along[id as usize];
            let cells: Vec<[f64; 2]> = asked.tuples("cells").into_iter().map(|cell| cell.map(place)).collect();
            let probes: Vec<f64> = asked.ids("probes").into_iter().map(place).collect();
            timed(|| engine.interval(&cells, &probes), labels)
        }
        Task::CubeUnion => {
            let cubes = asked.points("cubes");
            timed(|| engine.cube_union(&cubes), measures)
        }
        Task::Slice => {
            let (mesh, planes) = (asked.mesh("triangles"), asked.corners("planes"));
            timed(|| engine.slice(&mesh, &planes), parts)
        }
        Task::Snap2d => {
            let segments = asked.corners("segments");
            let pixel = message.bytes("word:pixel").and_then(|word| std::str::from_utf8(word).ok()?.parse().ok());
            let side = 2.0_f64.powi(-pixel.unwrap_or(0));
            timed(
                || engine.snap2d(&segments, side),
                |to, found| {
                    let to = numbers(to, "chains", found.concat().as_flattened());
                    starts(to, "chains", found.iter().map(Vec::len))
                },
            )
        }
    }
}
