use proptest::prelude::*;

use super::*;
use crate::rows::POINT;

fn points(text: &str) -> Result<(usize, Vec<f64>), CorpusError> {
    read("p.csv", text, &POINT, &Decimals::new(false)).map(|rows| (rows.width, rows.numbers))
}

#[test]
fn the_same_points_however_they_are_written() {
    let expected = Ok((2, vec![1.0, -0.5, 2.0, 3.0]));
    for text in [
        "1,-0.5\n2,3\n",
        "1,-0.5\n2,3",
        "x,y\n1,-0.5\n2,3\n",
        "X , Y\n 1 , -0.5 \n2,3\n",
        "# from somewhere\n\nlon,lat\n# first\n1,-.5\n\n  # second, \"quoted\n2,3\n",
        "1,-0.5\r\n2,3\r\n",
        "\"x\",\"y\"\r\n\"1\",\"-0.5\"\r\n\"2\",\"3\"\r\n",
        "\"x, east\";\"y, north\"\n1;-0.5\n2;3\n",
        "1\t-0.5\n2\t3\n",
        "x y\n1   -0.5\n 2 3 \n",
        "1,-0.5\r2,3\r",
        "0x1p+0,-0x1p-1\n\"0x1p1\",3e0\n",
    ] {
        assert_eq!(points(text), expected, "{text:?}");
    }
    assert_eq!(points("x,y,z\n1,2,3\n"), Ok((3, vec![1.0, 2.0, 3.0])));
}

#[test]
fn errors_name_file_line_and_cure() {
    for (text, expected) in [
        (
            "1,2\n\n# c\n3,0.1000000000000000001\n",
            "p.csv:4: decimal 0.1000000000000000001 has digits that no double holds; run `predicament corpus fmt p.csv`, or write `round = true` in the scene",
        ),
        ("1,2\r\r3,x\r", "p.csv:3: `x` is not a number; write"),
        ("1,2\n3\n", "p.csv:2: point 1 has 1 coordinates, the points before it 2; give all"),
        ("1,2,\n", "p.csv:1: `` is not a number; write"),
        ("1\n", "p.csv:1: point 0 has 1 coordinates; give all"),
        ("1,2,3,4\n", "p.csv:1: point 0 has 4 coordinates; give all"),
        ("x,y\n1,2,3\n", "p.csv:2: point 0 has 3 coordinates, the columns are 2; give all"),
        ("x,y,z,d\n1,2,3,4\n", "p.csv:1: the header has 4 columns; give all"),
        ("id,x,y\n1,2,3\n", "p.csv:1: the columns are id, x, y; write the columns x, y and z in this order"),
        ("y,x\n1,2\n", "p.csv:1: the columns are y, x; write"),
        ("x,y,id\n1,2,7\n", "p.csv:1: the columns are x, y, id; write"),
        ("lat,lon\n1,2\n", "p.csv:1: the columns are lat, lon; write the columns x, y and z in this order"),
        ("Northing,Easting\n1,2\n", "p.csv:1: the columns are Northing, Easting; write"),
        ("lon,lat,FID\n1,2,7\n", "p.csv:1: the columns are lon, lat, FID; write"),
        (",x,y\n0,1,2\n", "p.csv:1: `` is not a number; write"),
        ("nan,1\n", "p.csv:1: coordinate `nan` is not finite; remove"),
        ("1,2\nx,y\n", "p.csv:2: `x` is not a number; write"),
        ("0,5;1,5\n", "p.csv:1: `0,5` is not a number; write"),
        ("1,\"2\n3\",4\n", "p.csv:1: a quote that is not closed; close it in its line: a row is one line, and"),
        ("\"x\neast\",y\n1,2\n", "p.csv:1: a quote that is not closed; close"),
        ("# \"\n1,2\r\n3,\"4\r\n5,6\r\n", "p.csv:3: a quote that is not closed; close"),
        ("1,2\n\"3\"\",4\n", "p.csv:2: a quote that is not closed; close"),
        ("1,2\0\n", "p.csv:1: `2\\u{0}` is not a number; write"),
        ("x,y\n", "p.csv: the file has no points; write one point a line"),
        ("", "p.csv: the file has no points; write one point a line"),
    ] {
        let error = points(text).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{text:?}\n  got      {error}\n  expected {expected}");
    }
}

#[test]
fn rounding_is_counted() {
    let decimals = Decimals::new(true);
    let rows =
        read("p.csv", "0.1000000000000000001,0.5\n0.2000000000000000001,0.3000000000000000001\n", &POINT, &decimals)
            .unwrap();
    assert_eq!((rows.numbers.as_slice(), decimals.rounded()), ([0.1, 0.5, 0.2, 0.3].as_slice(), 3));
}

#[test]
fn only_inexact_decimals_are_rewritten() {
    let text = "\u{feff}# points\r\nx;y\r\n\r\n 0.1000000000000000001 ;\"0.2000000000000000001\"\r\n0.5;0x1p+0\r\n7;0.1\r\n7;1.0000000000000000001e-1";
    let expected = "\u{feff}# points\r\nx;y\r\n\r\n# 0.1000000000000000001, 0.2000000000000000001\r\n 0x1.999999999999ap-4 ;\"0x1.999999999999ap-3\"\r\n\
                    0.5;0x1p+0\r\n7;0.1\r\n# 1.0000000000000000001e-1\r\n7;0x1.999999999999ap-4";
    let once = fmt_csv("p.csv", text).unwrap();
    assert_eq!(once, expected);
    assert_eq!(fmt_csv("p.csv", &once).unwrap(), once);
    assert_eq!(
        fmt_csv("p.csv", "0.1000000000000000001 2\r").unwrap(),
        "# 0.1000000000000000001\r0x1.999999999999ap-4 2\r"
    );
    for (bad, message) in [
        ("1,inf\n", "not finite"),
        ("1,2\n1e400,1\n", "beyond"),
        ("1,x\n", "not a number"),
        ("1,2\n\"3,4\n", "not closed"),
    ] {
        let error = fmt_csv("p.csv", bad).unwrap_err().to_string();
        assert!(error.starts_with(&format!("p.csv:{}: ", bad.lines().count())) && error.contains(message), "{error}");
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

/// The text of a double: in hex, or with all its digits.
fn written(x: f64, hex: bool) -> String {
    if hex { hexfloat::format(x) } else { format!("{x:.1074}") }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(64, 256)))]

    #[test]
    fn every_bit_comes_back(
        rows in prop::collection::vec([finite(), finite(), finite()], 1..20),
        hex: bool,
        separator in prop::sample::select(&[",", ";", "\t", " ", " , "][..]),
        end in prop::sample::select(&["\n", "\r\n", "\r"][..]),
        header: bool,
    ) {
        let mut text = if header { format!("x{separator}y{separator}z{end}") } else { String::new() };
        for row in &rows {
            text += &(row.map(|x| written(x, hex)).join(separator) + end);
        }
        let (width, numbers) = points(&text).unwrap();
        prop_assert_eq!(width, 3);
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&numbers), bits(rows.as_flattened()));
        prop_assert_eq!(fmt_csv("p.csv", &text).unwrap(), text);
    }
}

proptest! {
    #[test]
    fn what_is_rewritten_reads_as_the_nearest(rows in prop::collection::vec([-1e9..1e9_f64, -1.0..1.0_f64], 1..20)) {
        let text: String = rows.iter().map(|[x, y]| format!("{x:?}, {y:?}\n")).collect();
        let tidy = fmt_csv("p.csv", &text).unwrap();
        prop_assert_eq!(&fmt_csv("p.csv", &tidy).unwrap(), &tidy);
        prop_assert_eq!(points(&tidy).unwrap().1, rows.as_flattened());
    }

    #[test]
    fn no_text_panics(text in "[0-9xy.,;#\"\r\n\t -]{0,60}|\\PC{0,30}") {
        let _ = points(&text);
        if let Ok(tidy) = fmt_csv("p.csv", &text) {
            prop_assert_eq!(&fmt_csv("p.csv", &tidy).unwrap(), &tidy);
        }
    }
}
