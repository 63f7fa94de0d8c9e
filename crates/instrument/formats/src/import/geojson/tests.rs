use predicament_predicates::{Dimension, Vertex};
use proptest::prelude::*;

use super::*;

fn of(text: &str) -> Result<Geometry, CorpusError> {
    read("m.geojson", text, &Decimals::new(false), &mut |_, _| true)
}

/// Two squares that share a border, one with a hole that is the other; then a feature without a geometry.
const SQUARES: &str = r#"{"type": "FeatureCollection", "crs": {"type": "name"}, "features": [
    {"type": "Feature", "properties": {"name": "west", "more": [[[]]]}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 2], [2, 2], [1, 1]]]}},
    {"type": "Feature", "id": 7, "properties": null, "geometry": {"type": "MultiPolygon", "coordinates": [
        [[[4, 0], [8, 0], [8, 4], [4, 4], [4, 0]]],
        [[[1, 1], [1, 2], [2, 2], [2, 2], [1, 1]]],
        [[[9, 9], [9.5, 9], [9, 9]]]]}},
    {"type": "Feature", "properties": {}, "geometry": null}
]}"#;

#[test]
fn each_feature_is_a_region() {
    let imported = of(SQUARES).unwrap().map().unwrap();
    let regions = imported.map.regions();
    assert_eq!(
        regions.iter().map(|region| (region.name.as_str(), region.rings.len())).collect::<Vec<_>>(),
        [("west", 2), ("7", 2)]
    );
    assert_eq!(imported.points.len(), 11, "shared corners are one vertex, and two are of the ring that is dropped");
    assert_eq!(regions[0].rings[1].vertices(), regions[1].rings[1].vertices());
    let shared = |a: &[Vertex], b: &[Vertex]| a.iter().filter(|v| b.contains(v)).count();
    assert_eq!(shared(regions[0].rings[0].vertices(), regions[1].rings[0].vertices()), 2);
    let expected = ImportNotes { repeated_points: 1, degenerate_rings: 1, empty_regions: 1, ..ImportNotes::default() };
    assert_eq!(imported.notes, expected);
}

#[test]
fn bare_rings_are_one_polygon() {
    let imported = of("[[[0, 0], [4, 0], [4, 4]],\n [[1, 1], [2, 1], [2, 2], [1, 1]]]").unwrap().map().unwrap();
    let [region] = imported.map.regions() else { panic!("one polygon") };
    assert_eq!(region.rings.iter().map(|ring| ring.vertices().len()).collect::<Vec<_>>(), [3, 3], "closed or not");
}

#[test]
fn some_features_are_read_and_nothing_is_counted_of_the_others() {
    // The second has a decimal that is not a double.
    let text = SQUARES.replace("9.5", "9.1000000000000000001");
    let some = |decimals: &Decimals, wanted: &dyn Fn(usize, Option<&str>) -> bool| {
        let mut seen = Vec::new();
        let mut keeps = |number: usize, id: Option<&str>| {
            seen.push((number, id.map(str::to_owned)));
            wanted(number, id)
        };
        let read = read("m.geojson", &text, decimals, &mut keeps);
        (read.and_then(Geometry::map), seen)
    };
    let strict = Decimals::new(false);
    let (west, seen) = some(&strict, &|number, _| number == 0);
    assert_eq!(seen, [(0, None), (1, Some("7".to_owned())), (2, None)]);
    let west = west.unwrap();
    assert_eq!((west.map.regions().len(), west.points.len(), west.notes), (1, 7, ImportNotes::default()));
    let of_id = |_: usize, id: Option<&str>| id == Some("7");
    assert!(
        some(&strict, &of_id)
            .0
            .unwrap_err()
            .to_string()
            .contains("9.1000000000000000001 has digits that no double holds")
    );
    let rounding = Decimals::new(true);
    assert_eq!(some(&rounding, &of_id).0.unwrap().map.regions()[0].name, "7");
    assert_eq!(rounding.rounded(), 1);
}

#[test]
fn a_member_is_an_array_of_rings() {
    let text = "{\"rule\": 1,\n \"first\": [[[0, 0], [4, 0], [4, 4]]],\n \"second\": [[[1, 1], [2, 1], [2, 0.1000000000000000001]]]}";
    let member = |text: &str, name: &str| read_member("m.json", text, name, &Decimals::new(false), &mut |_, _| true);
    let first = member(text, "first").unwrap().map().unwrap();
    assert_eq!((first.points.as_slice(), first.map.regions().len()), ([[0., 0.], [4., 0.], [4., 4.]].as_slice(), 1));
    for (text, name, expected) in [
        (text, "second", "m.json:3: second[0][2]: decimal 0.1000000000000000001 has digits that no double holds"),
        (text, "third", "m.json:1: the object has no member `third`; use one of `first`, `rule`, `second`"),
        (text, "rule", "m.json:1: rule: not an array; give an array"),
        ("[[[0, 0], [4, 0], [4, 4]]]", "first", "m.json:1: not an object; leave out `member`"),
    ] {
        let error = member(text, name).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{error}");
    }
}

#[test]
fn positions_are_points_in_their_order() {
    let (dimension, coordinates) = of(SQUARES).unwrap().points().unwrap();
    assert_eq!((dimension, coordinates.len()), (Dimension::Two, 2 * 17));
    assert_eq!(coordinates[..10], [0., 0., 4., 0., 4., 4., 0., 4., 1., 1.]);
    let solid = of(r#"{"type": "MultiPoint", "coordinates": [[1, 2, 3], [4, 5, 6, 7]]}"#).unwrap();
    assert_eq!(solid.points().unwrap(), (Dimension::Three, vec![1., 2., 3., 4., 5., 6.]));
    assert_eq!(solid.notes.extra_coordinates, 1);
    let mixed = of("{\"type\": \"MultiPoint\", \"coordinates\": [[1, 2, 3],\n [4, 5]]}").unwrap();
    let error = mixed.points().unwrap_err().to_string();
    assert_eq!(
        error,
        "m.geojson:2: a position of 2 coordinates, but earlier positions have 3; give every position a height, or \
         remove all heights"
    );
}

#[test]
fn lines_are_edges() {
    let text = r#"{"type": "GeometryCollection", "geometries": [
        {"type": "LineString", "coordinates": [[0, 0, 5], [1, 1, 6], [1, 1, 6], [2, 0, 7]]},
        {"type": "MultiLineString", "coordinates": [[[1, 1], [0, -0.0]], []]}]}"#;
    let found = of(text).unwrap().segments().unwrap();
    assert_eq!(found.points, [[0., 0.], [1., 1.], [2., 0.]]);
    assert_eq!(found.edges, [[0, 1], [1, 2], [1, 0]].map(|edge| edge.map(Vertex::input)));
    assert_eq!((found.notes.repeated_points, found.notes.extra_coordinates), (1, 4));
    let error = of(SQUARES).unwrap().segments().unwrap_err().to_string();
    assert_eq!(error, "m.geojson:2: a polygon is not a line; give lines only: LineString or MultiLineString");
    let all = of(SQUARES).unwrap().edges();
    assert_eq!((all.vertices.len(), all.edges.len()), (0, 14));
    let points = of(r#"{"type": "MultiPoint", "coordinates": [[1, 2], [1, 2]]}"#).unwrap().edges();
    assert_eq!((points.points.len(), points.vertices.len()), (1, 2));
}

#[test]
fn errors_stay_short() {
    let deep = r#"{"type": "GeometryCollection", "geometries": ["#.repeat(32);
    let long = "x".repeat(1 << 20);
    for (text, said) in [
        (
            format!("{deep}{{\"type\": \"Point\", \"coordinates\": [0.1000000000000000001, 0]}}{}", "]}".repeat(32)),
            "geometries[0].geometries[0]",
        ),
        (format!("{{\"type\": \"{long}\"}}"), "no geometry is of type `xxx"),
        (format!("{{\"type\": \"Point\", \"coordinates\": \"{long}\"}}"), "coordinates: not an array; give an array"),
        (format!("{{\"type\": \"Point\", \"coordinates\": [0, 0], \"properties\": \"{long}\"}}"), "not GeoJSON: "),
    ] {
        let error = of(&text).map(drop).unwrap_err().to_string();
        assert!(error.starts_with(&format!("m.geojson:1: {said}")), "{error}");
        assert!(error.len() < 700, "{error}");
    }
}

#[test]
fn errors_say_where() {
    let changed = |from: &str, to: &str| {
        assert!(SQUARES.contains(from), "{from}");
        of(&SQUARES.replacen(from, to, 1)).and_then(Geometry::map).map(drop).unwrap_err().to_string()
    };
    for (got, expected) in [
        (
            changed("[9.5, 9]", "[9.3000000000000000001, 9]"),
            "m.geojson:7: features[1].geometry.coordinates[2][0][1]: decimal 9.3000000000000000001 has digits that no double holds; \
             write `round = true` in the scene to read the nearest double",
        ),
        (
            changed("[9.5, 9]", "[\"9\", 9]"),
            "m.geojson:7: features[1].geometry.coordinates[2][0][1]: `\"9\"` is not a number; write",
        ),
        (
            changed("[9.5, 9]", "[1e400, 9]"),
            "m.geojson:7: features[1].geometry.coordinates[2][0][1]: coordinate `1e400` is beyond",
        ),
        (
            changed("[9.5, 9]", "[9.5]"),
            "m.geojson:7: features[1].geometry.coordinates[2][0][1]: a position of 1 numbers; write at least two",
        ),
        (
            changed("[8, 4], [4, 4], [4, 0]", "[8, 4], [4, 4]"),
            "m.geojson:5: features[1].geometry.coordinates[0][0]: the ring is not closed; repeat",
        ),
        (
            changed("\"Polygon\", \"coordinates\"", "\"Polygon\", \"arcs\""),
            "m.geojson:3: features[0].geometry: a Polygon without coordinates; give",
        ),
        (
            changed("\"MultiPolygon\"", "\"Multipolygon\""),
            "m.geojson:4: features[1].geometry: no geometry is of type `Multipolygon`; use one of Point,",
        ),
        (changed("\"MultiPolygon\"", "\"MultiLineString\""), "m.geojson:5: "),
        (
            changed("\"type\": \"Feature\", \"id\"", "\"id\""),
            "m.geojson:4: features[1]: not a Feature; list features only",
        ),
        (
            changed("\"FeatureCollection\"", "\"Topology\""),
            "m.geojson:1: the file is TopoJSON; for a map write `topojson",
        ),
        (changed("\"features\"", "\"feature\""), "m.geojson:1: a FeatureCollection without features; give"),
        (changed("\"type\": \"FeatureCollection\", ", ""), "m.geojson:1: an object without a type; use one of"),
        (changed("null}\n]}", "null"), "m.geojson:8: not GeoJSON: EOF"),
        (changed("null}\n]}", "null}\n]} x"), "m.geojson:9: not GeoJSON: trailing"),
        (
            changed("[[[4, 0]", "[[7, [4, 0]"),
            "m.geojson:5: features[1].geometry.coordinates[0][0][0]: not an array; \
                  give",
        ),
        (of("").unwrap_err().to_string(), "m.geojson:1: not GeoJSON: EOF while parsing a value; the file ends early"),
        (of("[\"Point\", null, null, null, [1, 2]]").unwrap_err().to_string(), "m.geojson:1: [0]: not an array; give"),
        (of("[\n[[1, 2], [3, \"4\"]]]").unwrap_err().to_string(), "m.geojson:2: [0][1]: "),
        (of("\u{0}").unwrap_err().to_string(), "m.geojson:1: not GeoJSON: expected value; give"),
        (
            of(r#"{"type": "Point", "coordinates": [1, 2]}"#).and_then(Geometry::map).unwrap_err().to_string(),
            "m.geojson:1: a point bounds no region; give polygons only",
        ),
        (
            of(r#"{"type": "FeatureCollection", "features": []}"#).and_then(Geometry::map).unwrap_err().to_string(),
            "m.geojson: the file has no region; give",
        ),
        (
            of(r#"{"type": "Point", "coordinates": []}"#).and_then(|all| all.points()).unwrap_err().to_string(),
            "m.geojson: the file has no points; give",
        ),
    ] {
        assert!(got.starts_with(expected), "{got}\n  expected {expected}");
    }
}

#[test]
fn rounding_is_counted() {
    let decimals = Decimals::new(true);
    let read =
        read("m.json", r#"{"type": "LineString", "coordinates": [[0.1000000000000000001, 0.5], [0.2000000000000000001, 0.3000000000000000001]]}"#, &decimals, &mut |_, _| {
            true
        })
        .unwrap();
    assert_eq!(read.points().unwrap().1, [0.1, 0.5, 0.2, 0.3]);
    assert_eq!(decimals.rounded(), 3);
}

#[test]
fn depth_is_bounded() {
    let nested = |depth: usize| {
        let head = r#"{"type": "GeometryCollection", "geometries": ["#.repeat(depth);
        of(&format!("{head}{}", "]}".repeat(depth)))
    };
    assert!(nested(DEEPEST).is_ok());
    let error = nested(DEEPEST + 1).unwrap_err().to_string();
    assert!(error.contains("more than 32 nested collections; list"), "{error}");
    for deep in ["[".repeat(100_000), "{\"a\":".repeat(100_000), nested_arrays(100_000)] {
        let error = of(&deep).unwrap_err().to_string();
        assert!(error.starts_with("m.geojson:1: ") && error.len() < 300, "{error}");
    }
}

fn nested_arrays(depth: usize) -> String {
    format!(r#"{{"type": "Polygon", "coordinates": {}{}}}"#, "[".repeat(depth), "]".repeat(depth))
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(64, 256)))]

    #[test]
    fn every_bit_comes_back(points in prop::collection::vec(prop::array::uniform3(finite()), 1..9)) {
        let position = |point: &[f64; 3]| format!("[{}]", point.map(|x| format!("{x:.1074}")).join(", "));
        let all: Vec<String> = points.iter().map(position).collect();
        let text = format!("{{\"type\": \"LineString\", \"coordinates\": [{}]}}", all.join(", "));
        let (dimension, read) = of(&text).unwrap().points().unwrap();
        prop_assert_eq!(dimension, Dimension::Three);
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&read), bits(points.as_flattened()));
    }
}

proptest! {
    #[test]
    fn no_text_panics(text in "\\PC{0,30}", at in 0..SQUARES.len(), length in 0..20_usize) {
        let _ = of(&text);
        let end = SQUARES.len().min(at + length);
        let mut changed = SQUARES.to_owned();
        changed.replace_range(at..end, &text);
        if let Ok(geometry) = of(&changed) {
            let _ = (geometry.points(), geometry.segments(), geometry.edges(), geometry.map());
        }
    }
}
