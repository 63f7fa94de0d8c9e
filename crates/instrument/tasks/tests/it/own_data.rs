//! Tests of user data: every format for points, segments, maps and complexes, and the notes about it.

use std::path::Path;

use predicament_contacts::task::Complexes;
use predicament_corpus::{Heading, Level, LoadedScene, Suite};
use predicament_crossings::task::Segments;
use predicament_formats::{Cache, CorpusError, ImportNotes, Manifest};
use predicament_overlay::task::overlay::{Layered, Layers};
use predicament_polygon_locate::task::MapWithProbes;
use predicament_tasks::signs::SignQueries;
use tempfile::TempDir;

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// The scene of a suite, with keys of the suite before it.
fn suite(folder: &Path, head: &str, scene: &str) -> Result<LoadedScene, CorpusError> {
    let text = format!("title = \"t\"\n{head}\n[[scene]]\nname = \"x\"\n{scene}\n");
    let suite = Suite::parse(predicament_bundle::vocabulary(), "s.toml", &text, Some(folder), &Manifest::default())?;
    suite.scenes[0].load(Level::Quick, &Cache::new("nowhere"))
}

fn load(folder: &TempDir, scene: &str) -> LoadedScene {
    suite(folder.path(), "", scene).unwrap()
}

fn refused(folder: &TempDir, scene: &str) -> String {
    let error = suite(folder.path(), "", scene).map(drop).unwrap_err().to_string();
    error.replace(&format!("{}/", folder.path().display()), "")
}

#[test]
fn the_same_points_from_every_format_are_the_same_scene() {
    let folder = folder(&[
        ("p.csv", "\u{feff}x;y;z\r\n0;0;0\r\n1;0;0\r\n0;1;0\r\n0;0;0.5\r\n"),
        ("p.txt", "0 0 0\n1 0 0\n\n# three\n0 1 0\n0 0 0.5\n"),
        ("p.geojson", r#"{"type": "MultiPoint", "coordinates": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0.5]]}"#),
        ("p.wkt", "POLYGON Z ((0 0 0, 1 0 0, 0 1 0, 0 0 0))\nPOINT (0 0 0.5)"),
        ("p.off", "OFF 4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n3 0 1 2\n"),
        ("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0.5\n"),
        (
            "p.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n\
             0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n",
        ),
        (
            "p.stl",
            "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
             facet\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 0 0 0.5\nendloop\nendfacet\nendsolid\n",
        ),
    ]);
    let written = load(&folder, "task = \"orient3d\"\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0.5]]");
    for extension in ["csv", "txt", "geojson", "wkt", "off", "obj", "ply", "stl"] {
        let loaded = load(&folder, &format!("task = \"orient3d\"\npoints = {{ path = \"p.{extension}\" }}"));
        assert_eq!(loaded.id, written.id, "{extension}");
        assert!(loaded.notes.is_clean(), "{extension}");
    }
    let cells = "axis = \"x\"\ncells = [[0, 1]]";
    let interval = load(&folder, &format!("task = \"interval\"\npoints = {{ path = \"p.csv\" }}\n{cells}"));
    assert_eq!(interval.count(), 2);
    assert_eq!(
        refused(&folder, "task = \"interval\"\npoints = { path = \"p.csv\" }\ncells = [[1, 0]]"),
        "s.toml:7: with p.csv: the cell from 1 at 1 to 0 at 0 goes to the left, or has no length; write the left end first; if both ends are at one place, the end with the larger index, because symbolic perturbation moves it less"
    );
    assert_eq!(
        refused(&folder, "task = \"crossings\"\npoints = { path = \"p.csv\" }"),
        "s.toml:6: with p.csv: crossings takes points with 2 coordinates, not 3; give every point 2 coordinates"
    );
    assert_eq!(
        refused(&folder, "task = \"orient3d\"\npoints = { path = \"p.dat\" }"),
        "s.toml:6: p.dat: the data file can't be read: there is no such file; put the file there or correct `path`"
    );
}

#[test]
fn roads_are_segments() {
    let folder = folder(&[
        (
            "roads.geojson",
            r#"{"type": "Feature", "geometry": {"type": "MultiLineString", "coordinates":
                [[[0, 0], [2, 2], [2, 2]], [[0, 2], [1, 1], [2, 0]], [[2, 2], [5, 5]]]}}"#,
        ),
        ("roads.wkt", "LINESTRING (0 0, 2 2)\nLINESTRING(0 2, 1 1, 2 0)\nLINESTRING (2 2, 5 5)"),
        ("points.wkt", "POINT (0 0)"),
        ("empty.wkt", "LINESTRING EMPTY"),
    ]);
    let [json, text] = ["geojson", "wkt"].map(|extension| {
        load(&folder, &format!("task = \"crossings\"\nsegments = {{ path = \"roads.{extension}\" }}"))
    });
    assert_eq!(json.id, text.id);
    assert_eq!((json.scene.len(), json.content::<Segments>().unwrap().0.len()), (6, 4));
    assert_eq!((json.notes.repeated_points, text.notes.repeated_points), (1, 0));
    for (file, expected) in [
        ("points.wkt", "points.wkt:1: a point is not a line; give lines only: LineString or MultiLineString"),
        ("empty.wkt", "empty.wkt: the file has no segments; give it a line of two points or more"),
    ] {
        assert_eq!(refused(&folder, &format!("task = \"crossings\"\nsegments = {{ path = \"{file}\" }}")), expected);
    }
}

#[test]
fn a_map_is_the_same_in_every_format() {
    let folder = folder(&[
        (
            "m.geojson",
            r#"{"type": "FeatureCollection", "features": [
                {"type": "Feature", "geometry": {"type": "Polygon", "coordinates":
                    [[[0, 0, 9], [4, 0, 9], [4, 4, 9], [0, 4, 9], [0, 0, 9]], [[1, 1], [1, 2], [2, 2], [1, 1]]]}},
                {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[4, 0], [8, 0], [4, 4], [4, 0]]]}}]}"#,
        ),
        ("m.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1))\nPOLYGON ((4 0, 8 0, 4 4, 4 0))"),
        (
            "m.json",
            r#"{"type": "Topology", "objects": {"o": {"type": "GeometryCollection", "geometries": [
                {"type": "Polygon", "arcs": [[0], [1]]}, {"type": "Polygon", "arcs": [[2]]}]}}, "arcs": [
                [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 2], [2, 2], [1, 1]], [[4, 0], [8, 0], [4, 4], [4, 0]]]}"#,
        ),
    ]);
    let inline = "polygons = [
        [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [1, 2], [2, 2], [1, 1]]],
        [[[4, 0], [8, 0], [4, 4], [4, 0]]]]";
    let places = [inline, "path = \"m.geojson\"", "path = \"m.wkt\"", "topojson = \"m.json\", object = \"o\""];
    let maps =
        places.map(|place| load(&folder, &format!("task = \"polygon-locate\"\nmap = {{ {place} }}\nrandom = 5")));
    assert_eq!(maps[0].content::<MapWithProbes>().unwrap().map.regions().len(), 2);
    assert!(maps.iter().all(|map| map.id == maps[0].id));
    assert_eq!(maps[1].notes, ImportNotes { extra_coordinates: 4, ..ImportNotes::default() });
    let borders = places.map(|place| {
        load(&folder, &format!("task = \"contacts2d\"\npoints = [[9, 9]]\na = {{ vertices = [0] }}\nb = {{ {place} }}"))
    });
    assert_eq!(borders[0].content::<Complexes>().unwrap().b.edges().len(), 9, "the shared border is there once");
    assert!(borders.iter().all(|map| map.id == borders[0].id));
    for (map, expected) in [
        ("polygons = []", "s.toml:6: polygons without a ring of three points; write a ring of at least three points"),
        (
            "polygons = [[[[0, 0], [1, 0]]]]",
            "s.toml:6: polygons without a ring of three points; write a ring of at least three points",
        ),
        ("polygons = [[[[0, 0], [1, 0], [0, 1, 2]]]]", "s.toml:6: a point of 3 coordinates; write two"),
        (
            "polygons = [[[0, 0]]]",
            "s.toml:6: `map` is of type integer; write a ring: an array of points of two coordinates",
        ),
        (
            "path = \"m.json\"",
            "m.json:1: the file is TopoJSON; for a map write `topojson = \"…\"` and `object = \"…\"`; else convert it to GeoJSON",
        ),
        (
            "path = \"m.wkt\", polygons = []",
            "s.toml:6: a map with more than one source; keep one of `path`, `topojson`, `fetch` and `polygons`",
        ),
    ] {
        let got = refused(&folder, &format!("task = \"polygon-locate\"\nmap = {{ {map} }}"));
        assert_eq!(got.replace("`polygons` is", "`map` is"), expected);
    }
}

#[test]
fn some_regions_of_a_file_are_a_map() {
    let square = |x: i32| format!("[[[{x}, 0], [{0}, 0], [{0}, 4], [{x}, 4], [{x}, 0]]]", x + 4);
    let feature = |id: &str, x: i32| {
        format!(
            r#"{{"type": "Feature", "id": "{id}", "geometry": {{"type": "Polygon", "coordinates": {}}}}}"#,
            square(x)
        )
    };
    let features = [feature("061", 0), feature("062", 4), feature("10", 8)].join(",\n");
    let collection = format!("{{\"type\": \"FeatureCollection\", \"features\": [{features}]}}");
    let members = format!("{{\"subject\": {}, \"clip\": {}}}", square(0), square(4));
    let wkt = [0, 4, 8].map(|x| format!("POLYGON (({x} 0, {0} 0, {0} 4, {x} 4, {x} 0))", x + 4)).join("\n");
    let folder = folder(&[("m.geojson", &collection), ("m.json", &members), ("m.wkt", &wkt)]);
    let overlay = |first: &str, second: &str| {
        format!("task = \"overlay2d\"\nfirst = {{ {first} }}\nsecond = {{ {second} }}\nrule = \"non-zero\"")
    };
    let pairs = [
        ("path = \"m.geojson\", ids = \"061\"", "path = \"m.geojson\", ids = \"062\""),
        ("path = \"m.geojson\", regions = [0]", "path = \"m.wkt\", regions = [1]"),
        ("path = \"m.json\", member = \"subject\"", "path = \"m.json\", member = \"clip\""),
    ];
    let loaded = pairs.map(|(first, second)| load(&folder, &overlay(first, second)));
    assert!(loaded.iter().all(|scene| scene.id == loaded[0].id && scene.scene.len() == 6));
    let both = load(&folder, &overlay("path = \"m.geojson\", ids = \"06\"", "path = \"m.wkt\", regions = [0, 2]"));
    let Layers::Polygons(operands, _) = &both.content::<Layered>().unwrap().layers else { panic!("polygons") };
    assert_eq!(operands.each_ref().map(Vec::len), [2, 2]);
    for (map, expected) in [
        (
            "path = \"m.geojson\", ids = \"07\"",
            "s.toml:6: with m.geojson: no id of the 3 regions begins with `07`; correct `ids`",
        ),
        (
            "path = \"m.wkt\", regions = [1, 3]",
            "s.toml:6: with m.wkt: there is no region 3: the file has 3; numbers count from 0",
        ),
        ("path = \"m.wkt\", regions = [1, 1]", "s.toml:6: regions out of order; write each once, the smallest first"),
        (
            "path = \"m.wkt\", regions = []",
            "s.toml:6: `regions` is empty; write an array of the numbers of regions, from 0 in the file's order",
        ),
        ("path = \"m.wkt\", ids = \"\"", "s.toml:6: `ids` is empty; write how ids begin, or leave `ids` out"),
        (
            "path = \"m.wkt\", ids = \"0\", regions = [0]",
            "s.toml:6: regions by ids and by numbers; keep one of the two",
        ),
        ("path = \"m.wkt\", member = \"clip\"", "m.wkt: only JSON has members; leave out `member`"),
        (
            "polygons = [[[[0, 0], [4, 0], [4, 4]]]], regions = [0]",
            "s.toml:6: `ids` and `regions` select from files, not from `polygons`; remove the key, and write only \
             the polygons that you want",
        ),
    ] {
        assert_eq!(refused(&folder, &format!("task = \"overlay2d\"\nfirst = {{ {map} }}")), expected);
    }
}

#[test]
fn complexes_come_from_shapes_and_surfaces() {
    let folder = folder(&[
        ("s.wkt", "POINT (0 0)\nLINESTRING (0 0, 1 1)\nPOLYGON ((0 0, 2 0, 0 2, 0 0))"),
        (
            "s.stl",
            "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
             facet\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
        ),
    ]);
    let loaded = load(&folder, "task = \"contacts2d\"\na = { path = \"s.wkt\" }\nb = { shifted = 2 }");
    let complexes: &Complexes = loaded.content().unwrap();
    assert_eq!((complexes.a.vertices().len(), complexes.a.edges().len(), loaded.scene.len()), (4, 4, 8));
    let loaded = load(&folder, "task = \"contacts3d\"\na = { path = \"s.stl\" }\nb = { shifted = 2 }");
    assert_eq!(loaded.content::<Complexes>().unwrap().a.triangles().len(), 1);
    assert_eq!(loaded.notes.degenerate_faces, 1);
    let flat = "task = \"contacts3d\"\na = { polygons = [[[[0, 0], [1, 0], [0, 1]]]] }\nb = { shifted = 2 }";
    assert_eq!(refused(&folder, flat), "s.toml:6: a map has points of two coordinates; use maps for contacts2d");
}

#[test]
fn rounding_is_asked_for_and_counted() {
    let folder = folder(&[
        ("p.csv", "0.1000000000000000001,0.5\n0.2000000000000000001,1\n3,4\n"),
        ("p.wkt", "LINESTRING (0.1000000000000000001 0.5, 0.2000000000000000001 1, 3 4)"),
        ("c.csv", "0.1000000000000000001,0,0,1\n"),
    ]);
    let orient = |points: &str| format!("task = \"orient2d\"\npoints = {points}");
    let [inline, csv, wkt] = [
        "[[0.1000000000000000001, 0.5], [0.2000000000000000001, 1], [3, 4]]",
        "{ path = \"p.csv\" }",
        "{ path = \"p.wkt\" }",
    ]
    .map(orient);
    for (scene, place) in [(&inline, "s.toml:6"), (&csv, "p.csv:1"), (&wkt, "p.wkt:1")] {
        let error = refused(&folder, scene);
        assert!(
            error.starts_with(&format!("{place}: decimal 0.1000000000000000001 has digits that no double holds; ")),
            "{error}"
        );
        assert!(error.contains("write `round = true` in the scene"), "{error}");
        let rounded = load(&folder, &format!("round = true\n{scene}"));
        assert_eq!(rounded.notes, ImportNotes { rounded: 2, ..ImportNotes::default() });
        assert_eq!(rounded.scene.coordinates(), [0.1, 0.5, 0.2, 1.0, 3.0, 4.0]);
        // The suite's setting applies to its scenes, unless they have their own.
        let by_suite = |scene: &str| suite(folder.path(), "round = true", scene);
        assert_eq!(by_suite(scene).unwrap().id, rounded.id);
        assert!(by_suite(&format!("round = false\n{scene}")).is_err());
    }
    let mixed = "round = true\ntask = \"contacts2d\"\npoints = [[0.3000000000000000001, 0]]\na = { path = \"p.wkt\" }\nb = { vertices = [0] }";
    assert_eq!(load(&folder, mixed).notes.rounded, 3, "decimals of the suite and of its files");
    let polygons = "round = true\ntask = \"polygon-locate\"\nmap = { polygons = [[[[0.1000000000000000001, 0], [1, 0], [0, 1]]]] }";
    assert_eq!(load(&folder, polygons).notes.rounded, 1);
    // 0.1 + 1 is not a double: rounding fixes a decimal and nothing else.
    let cubes = refused(&folder, "round = true\ntask = \"cube-union\"\ncubes = { path = \"c.csv\" }");
    assert!(cubes.starts_with("c.csv:1: cube 0: 0.1 + 1.0 along axis 0 is not a double"), "{cubes}");
    assert_eq!(
        refused(&folder, &format!("round = 1\n{inline}")),
        "s.toml:5: `round` is of type integer; write true or false"
    );
}

/// An ordinary table: other columns, another order, another sign for decimals.
#[test]
fn columns_of_a_table_are_the_same_points() {
    let folder = folder(&[
        ("p.csv", "7.5,47.25\n8,46.5\n7,46.25\n"),
        ("towns.csv", "id,lat,lon,name\r\n1,47.25,7.5,\"Bern, BE\"\r\n\r\n2,46.5,8,Thun\r\n3,46.25,7,Sion\r\n"),
        ("commas.csv", "name;lat;lon\nSt. A;47,25;7,5\nSt. B;46,5;8\nSt. C;46,25;7\n"),
        ("probes.csv", "id,x,y\n1,0.5,0.5\n"),
        ("m.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0))"),
    ]);
    let orient = |points: &str| format!("task = \"orient2d\"\npoints = {{ {points} }}");
    let plain = load(&folder, &orient("path = \"p.csv\""));
    for points in [
        "path = \"towns.csv\", columns = [\"lon\", \"lat\"]",
        "path = \"towns.csv\", columns = [3, \"lat\"]",
        "path = \"commas.csv\", columns = [\"lon\", \"lat\"]",
    ] {
        let loaded = load(&folder, &orient(points));
        assert_eq!((loaded.id, loaded.notes.is_clean()), (plain.id.clone(), true), "{points}");
    }
    let turned = load(&folder, &orient("path = \"towns.csv\", columns = [\"lat\", \"lon\"]"));
    assert_ne!(turned.id, plain.id, "the first column is x");
    let probes = "task = \"polygon-locate\"\nmap = { path = \"m.wkt\" }\nquick_stride = 0\nprobes = { path = \"probes.csv\", columns = [2, 3] }";
    assert_eq!(load(&folder, probes).count(), 1);
}

#[test]
fn random_queries_are_queries_as_if_written() {
    let folder = folder(&[("p.csv", "0,0\n1,0\n0,1\n1,1\n3,5\n")]);
    let orient = |queries: &str| format!("task = \"orient2d\"\npoints = {{ path = \"p.csv\" }}\nqueries = {queries}");
    let loaded = load(&folder, &orient("{ random = 20, seed = 3 }"));
    assert_eq!((loaded.count(), loaded.remarks.len()), (20, 0));
    let written = loaded.spelled().unwrap().suite("t", Heading { name: "x", ..Heading::default() });
    let written = written.split_once("points").unwrap().1;
    let again = load(&folder, &format!("task = \"orient2d\"\npoints{written}"));
    assert_eq!(again.id, loaded.id, "an id is of the queries, not of how they are chosen");
    assert_ne!(load(&folder, &orient("{ random = 20, seed = 4 }")).id, loaded.id);
    assert_eq!(load(&folder, &orient("{ random = 20 }")).id, load(&folder, &orient("{ random = 20, seed = 0 }")).id);
    // Constructed vertices are drawn as well.
    let constructed = "task = \"orient2d\"\npoints = [[0, 0], [3, 3], [0, 1], [0.5, 0]]\n\
                       constructed = [{ ssi = [[0, 1], [2, 3]] }]\nqueries = { random = 50, seed = 1 }";
    let queries = &load(&folder, constructed).content::<SignQueries>().unwrap().queries.clone();
    assert!(queries.flat().iter().any(|vertex| vertex.is_constructed()) && queries.len() == 50);
}

#[test]
fn points_that_tuples_leave_over_are_remarked() {
    let rows = |n: i32| (0..n).map(|k| format!("{k},{}\n", k * k)).collect::<String>();
    let folder = folder(&[("a.csv", &rows(500)), ("b.csv", &rows(4)), ("c.csv", &rows(6))]);
    for (file, queries, remarks) in [
        (
            "a.csv",
            166,
            &["2 of 500 points are not in a query, at the end: orient2d takes 3 points; `queries` selects \
          others"][..],
        ),
        (
            "b.csv",
            1,
            &["1 of 4 points is not in a query, at the end: orient2d takes 3 points; `queries` selects \
          others"],
        ),
        ("c.csv", 2, &[]),
    ] {
        let loaded = load(&folder, &format!("task = \"orient2d\"\npoints = {{ path = \"{file}\" }}"));
        assert_eq!(
            (loaded.count(), loaded.remarks.as_slice()),
            (queries, remarks.iter().map(|r| (*r).to_owned()).collect::<Vec<_>>().as_slice())
        );
    }
}
