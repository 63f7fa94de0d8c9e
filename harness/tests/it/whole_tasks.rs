//! Whole tasks through the helper of each language. The engine gives one fixed answer to each task, which is right for
//! some scenes and wrong for others, and it takes no constraints. Each test needs the language's program.

use std::path::Path;

use crate::common::{at, column, read, told, tool, write};
use tempfile::tempdir;

/// A scene for each task that the engine answers rightly, and the scenes `lost` and `constrained`.
const SUITE: &str = r#"title = "Tasks"

[[scene]]
name = "triangle"
task = "delaunay2d"
points = [[0, 0], [4, 0], [0, 4]]

[[scene]]
name = "lost"
task = "delaunay2d"
points = [[0, 0], [4, 0], [0, 4], [1, 1]]

[[scene]]
name = "constrained"
task = "delaunay2d"
points = [[0, 0], [4, 0], [0, 4]]
constraints = [[0, 1]]

[[scene]]
name = "corners"
task = "hull2d"
points = [[0, 0], [4, 0], [0, 4]]

[[scene]]
name = "tetrahedron"
task = "hull3d"
points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]

[[scene]]
name = "two-polygons"
task = "triangulate"
points = [[0, 0], [4, 0], [0, 4], [8, 0], [9, 0], [8, 2]]
loops = [[0, 1, 2], [3, 4, 5]]
regions = [0, 1]

[[scene]]
name = "twice"
task = "overlay2d"
points = [[0, 0], [4, 0], [0, 4], [0, 0], [4, 0], [0, 4]]
first = [[0, 1, 2]]
second = [[3, 4, 5]]

[[scene]]
name = "probes"
task = "polygon-locate"
points = [[0, 0], [4, 0], [0, 4]]
loops = [[0, 1, 2]]
regions = [0]
probes = [[1, 1], [1, 2]]
quick_stride = 0

[[scene]]
name = "corners-of-a-solid"
task = "mesh-locate"
points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
probes = [[0, 0, 0], [4, 0, 0]]
quick_stride = 0

[[scene]]
name = "to-a-face"
task = "mesh-rays"
points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
rays = [[2, 1, -1, 2, 1, 0]]
extent = "segment"

[[scene]]
name = "side-by-side"
task = "distance"
points = [[0, 0], [4, 0], [0, 4], [7, 0], [9, 0], [7, 4]]
from = [[0, 1, 2]]
to = [[3, 4, 5]]

[[scene]]
name = "one-in-the-other"
task = "mesh-intersect"
points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [-1, -1, -1], [9, -1, -1], [-1, 9, -1], [-1, -1, 9]]
first = [[4, 6, 5], [4, 5, 7], [5, 6, 7], [4, 7, 6]]
second = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]

[[scene]]
name = "edges"
task = "contacts2d"
points = [[0, 0], [4, 4], [0, 4], [4, 0]]
a = { edges = [[0, 1]] }
b = { edges = [[2, 3]] }

[[scene]]
name = "edge-through-triangle"
task = "contacts3d"
points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, -1], [1, 1, 1]]
a = { triangles = [[0, 1, 2]] }
b = { edges = [[3, 4]] }

[[scene]]
name = "cross"
task = "crossings"
points = [[0, 0], [4, 4], [0, 4], [4, 0]]
segments = [[0, 1], [2, 3]]

[[scene]]
name = "ends"
task = "interval"
axis = "y"
points = [[0, 0], [0, 4], [0, 8], [7, 4]]
cells = [[0, 1], [1, 2]]

[[scene]]
name = "one-cube"
task = "cube-union"
cubes = [[0.25, -1, 3, 0.5]]

[[scene]]
name = "two-planes"
task = "slice"
points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
planes = [[[9, 0, 0], [9, 1, 0], [9, 0, 1]], [[0, 0, -1], [1, 0, -1], [0, 1, -1]]]

[[scene]]
name = "halves"
task = "snap2d"
points = [[0, 0.5], [3, 4]]
segments = [[0, 1]]
pixel = 1
"#;

/// Writes a new engine of a language with this source, builds it, and compares the judge's findings with the expected
/// ones: one wrong answer and one scene that is declined.
fn is_judged(language: &str, file: &str, source: &str) {
    let folder = tempdir().unwrap();
    let call = |args: &[&str]| {
        let went = told(tool(args).current_dir(&folder).env_remove("PREDICAMENT_ENGINES").output().unwrap());
        (went.code, went.stdout + &went.stderr)
    };
    let (code, said) = call(&["engines", "new", "mine", "--language", language]);
    assert_eq!(code, 0, "{said}");
    std::fs::write(Path::new(&at(&folder, "engines/mine")).join(file), source).unwrap();
    let (code, said) = call(&["engines", "build", "mine"]);
    assert_eq!(code, 0, "{said}");
    let all = "tasks delaunay2d, hull2d, hull3d, triangulate, overlay2d, polygon-locate, mesh-locate, mesh-rays, distance, mesh-intersect, \
               contacts2d, contacts3d, crossings, interval, cube-union, slice, snap2d";
    let (code, said) = call(&["engines", "check", "mine"]);
    assert!(code == 0 && said.contains(all), "{said}");
    write(&folder, "suite.toml", SUITE);
    let (code, said) = call(&["run", "suite.toml", "-b", "engine:mine", "--out", "run"]);
    assert_eq!(code, 100, "{said}");
    let summary = read(&at(&folder, "run"), "summary.csv");
    let scenes = column(&summary, "scene");
    let with = |name: &str| -> Vec<&str> {
        let counts = column(&summary, name);
        scenes.iter().zip(counts).filter(|(_, count)| count != "0").map(|(scene, _)| scene.as_str()).collect()
    };
    assert_eq!(with("topology"), ["lost"], "{summary}");
    assert_eq!(with("declined"), ["constrained"], "{summary}");
    assert_eq!((with("rounded"), with("panic")), (vec![], vec![]), "{summary}");
    assert_eq!(with("agree").len(), scenes.len() - 2, "{summary}");
}

#[test]
#[ignore = "needs Python"]
fn tasks_in_python_are_judged() {
    is_judged(
        "python",
        "engine.py",
        r#"
import predicament_engine

engine = predicament_engine.Engine("mine", "1.0")
faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
engine.task("delaunay2d", lambda points: [[0, 1, 2]])
engine.task("hull2d", lambda points: [0, 1, 2])
engine.task("hull3d", lambda points: faces)
engine.task("triangulate", lambda points, rings: [rings[0]])
engine.task("overlay2d", lambda first, second: {"union": [first], "intersection": [second], "difference": []})
engine.task("polygon-locate", lambda regions, probes: [0] * len(probes))
engine.task("mesh-locate", lambda vertices, triangles, probes: [-2] * len(probes))
engine.task("mesh-rays", lambda vertices, triangles, rays, extent: [[0]] if rays[0][1][0] == 2 and extent == "segment" else [])
engine.task("distance", lambda points, a, b: points[b[0][0]][0] - points[a[0][1]][0])
engine.task("mesh-intersect", lambda first, second: {"union": first, "intersection": second})
engine.task("contacts2d", lambda points, a, b: [(a[0], b[0])])
engine.task("contacts3d", lambda points, a, b: [(a[0], b[0])])
engine.task("crossings", lambda segments: [[1], [0]])
engine.task("interval", lambda cells, probes: [-2 if probe in cells[0] else -1 for probe in probes])
engine.task("cube-union", lambda cubes: {"volume": cubes[0][3] ** 3, "area": 1.5, "edge_length": 6})
engine.task("slice", lambda vertices, triangles, planes: [(vertices, triangles)] if len(planes + vertices) == 6 else [])
engine.task("snap2d", lambda segments, side: segments if side == 0.5 else [])
predicament_engine.serve(engine)
"#,
    );
}

#[test]
#[ignore = "needs Node"]
fn tasks_in_node_are_judged() {
    is_judged(
        "node",
        "engine.mjs",
        r#"
import { serve } from "./predicament_engine.mjs";

const tasks = {
    delaunay2d: ({ points }) => [[0, 1, 2]],
    hull2d: () => [0, 1, 2],
    hull3d: () => [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
    triangulate: ({ rings }) => rings[0],
    overlay2d: ({ first, second }) => ({ union: [first], intersection: [second], difference: [] }),
    "polygon-locate": ({ probes }) => probes.map(() => 0),
    "mesh-locate": ({ probes }) => probes.map(() => -2),
    "mesh-rays": ({ rays, extent }) => (rays[0][1][0] === 2 && extent === "segment" ? [[0]] : []),
    distance: ({ points, a, b }) => points[b[0][0]][0] - points[a[0][1]][0],
    "mesh-intersect": ({ first, second }) => ({ union: first, intersection: second }),
    contacts2d: ({ a, b }) => [[a[0], b[0]]],
    contacts3d: ({ a, b }) => [[a[0], b[0]]],
    crossings: () => [[1], [0]],
    interval: ({ cells, probes }) => probes.map((probe) => (cells[0].includes(probe) ? -2 : -1)),
    "cube-union": ({ cubes }) => ({ volume: cubes[0][3] ** 3, area: 1.5, edge_length: 6 }),
    slice: ({ vertices, triangles, planes }) => (planes.length + vertices.length === 6 ? [{ vertices, triangles }] : []),
    snap2d: ({ segments, side }) => (side === 0.5 ? segments : []),
};
serve({ name: "mine", version: "1.0", tasks });
"#,
    );
}

#[test]
#[ignore = "needs a C++ compiler"]
fn tasks_in_cpp_are_judged() {
    is_judged(
        "cpp",
        "engine.cpp",
        r#"
#include "predicament_engine.hpp"

using namespace predicament;

struct Mine {
    static constexpr const char* name = "mine";
    static std::string version() { return "1.0"; }
    static Triangles delaunay2d(const Points2&) { return {{0, 1, 2}}; }
    static Ids hull2d(const Points2&) { return {0, 1, 2}; }
    static Triangles hull3d(const Points3&) { return {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}; }
    static Triangles triangulate(const Points2&, const Rings& rings) { return {{rings[0][0], rings[0][1], rings[0][2]}}; }
    static Results<Polygons> overlay2d(const Polygon& first, const Polygon& second, bool) {
        return {Polygons{first}, Polygons{second}, Polygons{}, {}};
    }
    static Labels polygon_locate(const Polygons&, const Points2& probes) { return Labels(probes.size(), 0); }
    static Labels mesh_locate(const Mesh&, const Points3& probes) { return Labels(probes.size(), -2); }
    static std::vector<Ids> mesh_rays(const Mesh&, const Rays& rays, const std::string& extent) {
        return rays[0][1][0] == 2 && extent == "segment" ? std::vector<Ids>{{0}} : std::vector<Ids>{};
    }
    static double distance(const Points3& points, const Simplices& a, const Simplices& b, int dimension) {
        return dimension == 2 ? points[b[0][0]][0] - points[a[0][1]][0] : 0;
    }
    static Results<Mesh> mesh_intersect(const Mesh& first, const Mesh& second) { return {first, second, {}, {}}; }
    static Pairs contacts2d(const Points2&, const Simplices& a, const Simplices& b) { return {{a.at(0), b.at(0)}}; }
    static Pairs contacts3d(const Points3&, const Simplices& a, const Simplices& b) { return {{a.at(0), b.at(0)}}; }
    static std::vector<Ids> crossings(const Segments&) { return {{1}, {0}}; }
    static Labels interval(const Cells& cells, const std::vector<double>& probes) {
        Labels labels;
        for (const double probe : probes) labels.push_back(probe == cells[0][0] || probe == cells[0][1] ? -2 : -1);
        return labels;
    }
    static Measures cube_union(const Cubes& cubes) { return {cubes[0][3] * cubes[0][3] * cubes[0][3], 1.5, 6.0}; }
    static std::vector<Mesh> slice(const Mesh& mesh, const Planes& planes) {
        return planes.size() + mesh.vertices.size() == 6 ? std::vector<Mesh>{mesh} : std::vector<Mesh>{};
    }
    static Chains snap2d(const Segments& segments, double side) {
        return side == 0.5 ? Chains{{segments[0][0], segments[0][1]}} : Chains{};
    }
};

int main(int argc, char** argv) { return serve<Mine>(argc, argv); }
"#,
    );
}

#[test]
#[ignore = "needs cargo, and no registry"]
fn tasks_in_rust_are_judged() {
    is_judged(
        "rust",
        "engine.rs",
        r#"
#[allow(dead_code)]
mod predicament_engine;

use predicament_engine::{Engine, Measures, Mesh, Polygon, Ray, Results, Segment, Simplices, Task, serve};

#[derive(Default)]
struct Mine;

impl Engine for Mine {
    const NAME: &'static str = "mine";
    const TASKS: &'static [Task] = &[
        Task::Delaunay2d,
        Task::Hull2d,
        Task::Hull3d,
        Task::Triangulate,
        Task::Overlay2d,
        Task::PolygonLocate,
        Task::MeshLocate,
        Task::MeshRays,
        Task::Distance,
        Task::MeshIntersect,
        Task::Contacts2d,
        Task::Contacts3d,
        Task::Crossings,
        Task::Interval,
        Task::CubeUnion,
        Task::Slice,
        Task::Snap2d,
    ];

    fn version() -> String {
        "1.0".to_owned()
    }

    fn delaunay2d(&self, _: &[[f64; 2]], constraints: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, String> {
        if constraints.is_empty() { Ok(vec![[0, 1, 2]]) } else { Err("constraints".to_owned()) }
    }

    fn hull2d(&self, _: &[[f64; 2]]) -> Result<Vec<u32>, String> {
        Ok(vec![0, 1, 2])
    }

    fn hull3d(&self, _: &[[f64; 3]]) -> Result<Vec<[u32; 3]>, String> {
        Ok(vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    }

    fn triangulate(&self, _: &[[f64; 2]], rings: &[Vec<u32>]) -> Result<Vec<[u32; 3]>, String> {
        Ok(vec![[rings[0][0], rings[0][1], rings[0][2]]])
    }

    fn overlay2d(&self, first: &Polygon, second: &Polygon, _: bool) -> Result<Results<Vec<Polygon>>, String> {
        let [union, intersection] = [first, second].map(|polygon| Some(vec![polygon.clone()]));
        Ok(Results { union, intersection, difference: Some(Vec::new()), symmetric_difference: None })
    }

    fn polygon_locate(&self, _: &[Polygon], probes: &[[f64; 2]]) -> Result<Vec<i64>, String> {
        Ok(vec![0; probes.len()])
    }

    fn mesh_locate(&self, _: &Mesh, probes: &[[f64; 3]]) -> Result<Vec<i64>, String> {
        Ok(vec![-2; probes.len()])
    }

    fn mesh_rays(&self, _: &Mesh, rays: &[Ray], extent: &str) -> Result<Vec<Vec<u32>>, String> {
        Ok(if rays[0][1][0] == 2.0 && extent == "segment" { vec![vec![0]] } else { vec![] })
    }
    fn distance(&self, points: &[[f64; 3]], a: &Simplices, b: &Simplices, _: usize) -> Result<f64, String> {
        Ok(points[b[0][0] as usize][0] - points[a[0][1] as usize][0])
    }

    fn mesh_intersect(&self, first: &Mesh, second: &Mesh) -> Result<Results<Mesh>, String> {
        let [union, intersection] = [first, second].map(|mesh| Some(mesh.clone()));
        Ok(Results { union, intersection, difference: None, symmetric_difference: None })
    }

    fn contacts2d(&self, _: &[[f64; 2]], a: &Simplices, b: &Simplices) -> Result<Vec<[Vec<u32>; 2]>, String> {
        Ok(vec![[a[0].clone(), b[0].clone()]])
    }

    fn contacts3d(&self, _: &[[f64; 3]], a: &Simplices, b: &Simplices) -> Result<Vec<[Vec<u32>; 2]>, String> {
        Ok(vec![[a[0].clone(), b[0].clone()]])
    }

    fn crossings(&self, _: &[Segment]) -> Result<Vec<Vec<u32>>, String> {
        Ok(vec![vec![1], vec![0]])
    }

    fn interval(&self, cells: &[[f64; 2]], probes: &[f64]) -> Result<Vec<i64>, String> {
        Ok(probes.iter().map(|probe| if cells[0].contains(probe) { -2 } else { -1 }).collect())
    }

    fn cube_union(&self, cubes: &[[f64; 4]]) -> Result<Measures, String> {
        Ok(Measures { volume: cubes[0][3].powi(3), area: 1.5, edge_length: Some(6.0) })
    }

    fn slice(&self, mesh: &Mesh, planes: &[[[f64; 3]; 3]]) -> Result<Vec<Mesh>, String> {
        Ok(if planes.len() + mesh.vertices.len() == 6 { vec![mesh.clone()] } else { vec![] })
    }

    fn snap2d(&self, segments: &[Segment], side: f64) -> Result<Vec<Vec<[f64; 2]>>, String> {
        Ok(if side == 0.5 { vec![segments[0].to_vec()] } else { vec![] })
    }
}

fn main() -> std::process::ExitCode {
    serve::<Mine>()
}
"#,
    );
}
