use predicament_predicates::Dimension;
use proptest::prelude::*;

use super::*;
use crate::hexfloat;

fn of(text: &str) -> Result<Geometry, CorpusError> {
    read("m.wkt", text, &Decimals::new(false), &mut |_, _| true)
}

#[test]
fn every_kind_of_geometry() {
    let text = "# first\nSRID=4326;POINT (1 2)\npolygon((0 0, 4 0,4 4,0 0), (1 0.5, 2 0.5, 2 1, 1 0.5));\n\
                MULTIPOINT ((5 6), (7 8), EMPTY) MULTIPOINT (5 6, 7 8)\r\nLINESTRING(0 0,1 1,-1e0 +2.5)\n\
                MULTILINESTRING ((0 0, 1 1), EMPTY) # behind\nMULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), EMPTY)\n\
                GEOMETRYCOLLECTION (POINT (9 9), LINESTRING EMPTY)\nPOINT EMPTY";
    let features = of(text).unwrap().features;
    let shapes: Vec<usize> = features.iter().map(|feature| feature.shapes.len()).collect();
    assert_eq!(shapes, [1, 1, 2, 2, 1, 2, 2, 2, 0]);
    assert_eq!(features.iter().map(|feature| feature.line).collect::<Vec<_>>(), [2, 3, 4, 4, 5, 6, 7, 8, 9]);
    let at = |x: f64, y: f64, line| Position { at: [x, y], height: None, line };
    assert_eq!(features[0].shapes, [Shape::Point(at(1.0, 2.0, 2))]);
    assert_eq!(features[2].shapes, features[3].shapes);
    assert_eq!(features[4].shapes, [Shape::Line(vec![at(0.0, 0.0, 5), at(1.0, 1.0, 5), at(-1.0, 2.5, 5)])]);
    let Shape::Polygon(rings) = &features[1].shapes[0] else { panic!("no polygon") };
    assert_eq!(rings.iter().map(Vec::len).collect::<Vec<_>>(), [3, 3]);
    assert_eq!(of("").unwrap().features, []);
}

#[test]
fn heights_are_kept_and_measures_left_out() {
    for (text, height, extra) in [
        ("POINT (1 2)", None, 0),
        ("POINT (1 2 3)", Some(3.0), 0),
        ("POINT Z (1 2 3)", Some(3.0), 0),
        ("POINTZ(1 2 3)", Some(3.0), 0),
        ("POINT M (1 2 9)", None, 1),
        ("pointm (1 2 9)", None, 1),
        ("POINT ZM (1 2 3 9)", Some(3.0), 1),
        ("POINT (1 2 3 9)", Some(3.0), 1),
    ] {
        let read = of(text).unwrap();
        assert_eq!(read.features[0].shapes, [Shape::Point(Position { at: [1.0, 2.0], height, line: 1 })], "{text}");
        assert_eq!(read.notes.extra_coordinates, extra, "{text}");
    }
}

#[test]
fn errors_name_file_line_and_cure() {
    for (text, expected) in [
        (
            "POINT (1 2)\nPOINT (1 0.1000000000000000001)",
            "m.wkt:2: decimal 0.1000000000000000001 has digits that no double holds; write `round = true` in the scene to",
        ),
        ("POINT (1 x)", "m.wkt:1: `x` is not a number; write a decimal"),
        ("POINT (1 nan)", "m.wkt:1: coordinate `nan` is not finite"),
        ("POINT (1)", "m.wkt:1: a position of 1 numbers; write two to four"),
        ("POINT Z (1 2)", "m.wkt:1: a position of 2 numbers; write three"),
        ("POINT ZM (1 2 3)", "m.wkt:1: a position of 3 numbers; write four"),
        ("POINT (1 2 3 4 5 6)", "m.wkt:1: a position of 5 numbers; write two to four"),
        ("POINT (1 2, 3 4)", "m.wkt:1: `,` where `)` should be; write WKT such as"),
        ("POINT ()", "m.wkt:1: `)` where a number should be"),
        ("POINT 1 2", "m.wkt:1: `1` where `(` or EMPTY should be"),
        ("LINESTRING (0 0,\n\n1 1", "m.wkt:3: the end of the file where `,` or `)` should be"),
        ("POLYGON ((0 0, 1 0,\n0 1))", "m.wkt:2: the ring is not closed; repeat its first position at its end"),
        ("POLYGON (0 0, 1 0, 0 0)", "m.wkt:1: `0` where `(` or EMPTY should be"),
        ("CIRCULARSTRING (0 0, 1 0)", "m.wkt:1: no geometry is called `CIRCULARSTRING`; use one of POINT,"),
        ("\n)", "m.wkt:2: `)` where a geometry should be"),
        ("{\"type\":", "m.wkt:1: no geometry is called `{\"type\":`; use"),
        ("\0", "m.wkt:1: no geometry is called `\\u{0}`; use"),
    ] {
        let error = of(text).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{text:?}\n  got      {error}\n  expected {expected}");
    }
}

#[test]
fn depth_is_bounded() {
    let nested =
        |depth: usize| of(&format!("{}POINT (0 0){}", "GEOMETRYCOLLECTION (".repeat(depth), ")".repeat(depth)));
    assert!(nested(DEEPEST).is_ok());
    assert!(nested(DEEPEST + 1).unwrap_err().to_string().contains("more than 32 nested collections; list"));
    assert!(nested(100_000).is_err());
    assert!(of(&format!("POLYGON {}", "(".repeat(100_000))).is_err());
}

#[test]
fn some_geometries_are_read_and_nothing_is_counted_of_the_others() {
    let text = "POLYGON M ((0.1000000000000000001 0 1, 4 0 1, 4 4 1, 0.1000000000000000001 0 1));\nPOLYGON ((1 1, 2 1, 2 2, 1 1))";
    let some = |wanted: usize| {
        let decimals = Decimals::new(true);
        let geometry = read("m.wkt", text, &decimals, &mut |number, _| number == wanted).unwrap();
        (geometry.features.len(), decimals.rounded(), geometry.map().unwrap().notes.extra_coordinates)
    };
    assert_eq!([some(0), some(1)], [(1, 2, 4), (1, 0, 0)]);
    let strict = read("m.wkt", text, &Decimals::new(false), &mut |number, _| number == 1).unwrap();
    assert_eq!(strict.map().unwrap().points, [[1., 1.], [2., 1.], [2., 2.]]);
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

proptest! {
    #[test]
    fn every_bit_comes_back(points in prop::collection::vec(prop::array::uniform3(finite()), 1..9), hex: bool) {
        let number = |x: f64| if hex { hexfloat::format(x) } else { format!("{x:.1074}") };
        let all: Vec<String> = points.iter().map(|point| point.map(number).join(" ")).collect();
        let (dimension, read) = of(&format!("LINESTRING Z ({})", all.join(", "))).unwrap().points().unwrap();
        prop_assert_eq!(dimension, Dimension::Three);
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&read), bits(points.as_flattened()));
    }

    #[test]
    fn no_text_panics(text in "(POINT|POLYGON|LINESTRING|MULTI|EMPTY|Z|M|[(), 0-9#;\n.-]){0,40}|\\PC{0,30}") {
        if let Ok(geometry) = of(&text) {
            let _ = (geometry.points(), geometry.segments(), geometry.edges(), geometry.map());
        }
    }
}
