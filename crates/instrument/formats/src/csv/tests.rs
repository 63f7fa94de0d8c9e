use proptest::prelude::*;

use super::*;
use crate::hexfloat;
use crate::rows::POINT;

fn points(text: &str) -> Result<(usize, Vec<f64>), CorpusError> {
    read("p.csv", text, &POINT, Wanted::Points, &Decimals::new(false)).map(|rows| (rows.width, rows.numbers))
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
            "p.csv:4: decimal 0.1000000000000000001 has digits that no double holds; run `predicament corpus fmt p.csv` and use the file that it writes, or write `round = true` in the scene",
        ),
        ("1,2\r\r3,x\r", "p.csv:3: `x` is not a number; write"),
        ("1,2\n3\n", "p.csv:2: point 1 has 1 coordinates, but earlier points have 2; give all"),
        ("1,2,\n", "p.csv:1: `` is not a number; write"),
        ("1\n", "p.csv:1: point 0 has 1 coordinates; give all"),
        ("1,2,3,4\n", "p.csv:1: point 0 has 4 coordinates; give all"),
        ("x,y\n1,2,3\n", "p.csv:2: point 0 has 3 coordinates, but there are 2 columns; give all"),
        (
            "x,y,z,d\n1,2,3,4\n",
            "p.csv:1: the columns are x, y, z, d; name the columns of x and y: `columns = [\"x\", \"y\", \"z\"]` \
             beside `path`, or \
             `--columns x,y,z` on the command line",
        ),
        (
            "id,x,y\n1,2,3\n",
            "p.csv:1: the columns are id, x, y; name the columns of x and y: `columns = [\"x\", \"y\"]` beside",
        ),
        ("y,x\n1,2\n", "p.csv:1: the columns are y, x; name the columns of x and y: `columns = [\"x\", \"y\"]` beside"),
        ("x,y,id\n1,2,7\n", "p.csv:1: the columns are x, y, id; name"),
        (
            "lat,lon\n1,2\n",
            "p.csv:1: the columns are lat, lon; name the columns of x and y: `columns = [\"lon\", \"lat\"]` beside",
        ),
        ("Northing,Easting\n1,2\n", "p.csv:1: the columns are Northing, Easting; name"),
        ("lon,lat,FID\n1,2,7\n", "p.csv:1: the columns are lon, lat, FID; name"),
        (",x,y\n0,1,2\n", "p.csv:1: the columns are ``, x, y; name"),
        (
            "id,name\n1,2\n",
            "p.csv:1: the columns are id, name; name the columns of x and y, or give their numbers from 1: `columns \
             = [\"…\", \"…\"]`",
        ),
        (
            "id,lon,lat,x,y\n1,2,3,4,5\n",
            "p.csv:1: the columns are id, lon, lat, x, y; name the columns of x and y, or give their numbers",
        ),
        ("nan,1\n", "p.csv:1: coordinate `nan` is not finite; remove"),
        ("1,2\nx,y\n", "p.csv:2: `x` is not a number; write"),
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

/// Columns as a command line has them.
fn columns(text: &str) -> Columns {
    Columns::parse(text).unwrap()
}

fn of_columns(text: &str, named: &str) -> Result<(usize, Vec<f64>), CorpusError> {
    let columns = columns(named);
    read("p.csv", text, &POINT, Wanted::Some(&columns), &Decimals::new(false)).map(|rows| (rows.width, rows.numbers))
}

#[test]
fn some_columns_are_read_in_the_order_in_which_they_are_named() {
    let expected = Ok((2, vec![7.5, 47.25, 8.0, 46.5]));
    for (text, named) in [
        ("id,lon,lat,name\n1,7.5,47.25,Bern\n2,8,46.5,Thun\n", "lon,lat"),
        ("id,lon,lat,name\n1,7.5,47.25,Bern\n2,8,46.5,Thun\n", "2,lat"),
        ("lat,lon\n47.25,7.5\n46.5,8\n", "lon,lat"),
        ("lat,lon\n47.25,7.5\n46.5,8\n", "2,1"),
        ("1,7.5,47.25\n2,8,46.5\n", "2,3"),
        ("lat;lon\r\n\r\n# a town\r\n47.25;7.5\r\n46.5;8\r\n", "lon, lat"),
        ("\"name\",\"lon\",\"lat\"\n\"Bern, BE\", 7.5 ,\"47.25\"\n\"Thun\",8,46.5\n", "lon,lat"),
        // pandas leaves the name of its index empty.
        (",lon,lat\n0,7.5,47.25\n1,8,46.5\n", "lon,lat"),
        ("2020,lon,lat\n0,7.5,47.25\n1,8,46.5\n", "lon,lat"),
        ("name\tlat\tlon\nBern BE\t47.25\t7.5\nThun\t46.5\t8\n", "lon,lat"),
        ("lat lon\n47.25   7.5\n46.5 8\n", "lon,lat"),
        // Large numbers elsewhere are not looked at.
        ("id,lon,lat\n123456789012345678901,7.5,47.25\nx,8,46.5\n", "lon,lat"),
    ] {
        assert_eq!(of_columns(text, named), expected, "{text:?}");
    }
    assert_eq!(of_columns("z,y,x,id\n3,2,1,9\n", "x,y,z"), Ok((3, vec![1.0, 2.0, 3.0])));
}

#[test]
fn errors_about_columns_name_the_column_and_the_cure() {
    const HEAD: &str = "id,lon,lat,name\n";
    for (rows, named, expected) in [
        (
            "1,7,47,a\n",
            "lom,lat",
            "p.csv:1: there is no column `lom`: the columns are id, lon, lat, name; did you mean `lon`? name",
        ),
        (
            "1,7,47,a\n",
            "east,north",
            "p.csv:1: there is no column `east`: the columns are id, lon, lat, name; name columns of the",
        ),
        ("1,7,47,a\n", "2,5", "p.csv:1: there is no column 5: the first row has 4 cells; choose numbers from 1 to 4"),
        ("1,7,47,a\n", "lon,2", "p.csv:1: `2` names a column that is already named; name each column once"),
        (
            "1,7,47,a\n2,8\n",
            "lon,lat",
            "p.csv:3: the row has 2 cells, the header has 4: column `lat` is missing; give every row 4 cells; put a \
             cell that",
        ),
        ("1,7,47\n", "lon,lat", "p.csv:2: the row has 3 cells, the header has 4; give every row 4 cells"),
        ("1,7,47,Bern, BE\n", "lon,lat", "p.csv:2: the row has 5 cells, the header has 4; give every row 4 cells"),
        ("1,7,47,a\n2,x,46,b\n", "lon,lat", "p.csv:3: column `lon`: `x` is not a number; write a decimal"),
        ("1,7,47,a\n2,,46,b\n", "2,3", "p.csv:3: column 2: `` is not a number; write a decimal"),
        ("1,7,nan,a\n", "lon,lat", "p.csv:2: column `lat`: coordinate `nan` is not finite; remove the point"),
        ("1,7,a,47\n", "lat,lon", "p.csv:2: column `lat`: `a` is not a number; write"),
        (
            "1,7,0.1000000000000000001,a\n",
            "lon,lat",
            "p.csv:2: column `lat`: decimal 0.1000000000000000001 has digits that no double holds; run `predicament corpus fmt p.csv \
             --columns lon,lat` and use the file that it writes, or write `round = true` in the scene",
        ),
        ("", "lon,lat", "p.csv: the file has no points; write one point a line"),
    ] {
        let error = of_columns(&format!("{HEAD}{rows}"), named).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{rows:?}\n  got      {error}\n  expected {expected}");
    }
    for (text, named, expected) in [
        (
            "1,7,47\n",
            "lon,lat",
            "p.csv:1: there is no column `lon`: the first row is not a header: 1, 7, 47; name the columns by their",
        ),
        ("a,a,b\n1,2,3\n", "a,b", "p.csv:1: two columns are called `a`; name the column by its number, from 1"),
        ("1,7\n2\n", "1,2", "p.csv:2: the row has 1 cells, the first row has 2: column 2 is missing; give"),
        // Names are as the header spells them.
        (
            "Lon,Lat\n1,2\n",
            "lon,Lat",
            "p.csv:1: there is no column `lon`: the columns are Lon, Lat; did you mean `Lon`?",
        ),
    ] {
        let error = of_columns(text, named).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{text:?}\n  got      {error}\n  expected {expected}");
    }
    for (named, expected) in [
        ("lon", "1 column for the coordinates of a point"),
        ("a,b,c,d", "4 columns for the coordinates of a point"),
        ("a,a", "the column `a` twice"),
        ("2,2", "the column `2` twice"),
        ("a,", "a column without a name"),
        ("0,1", "columns are numbered from 1"),
    ] {
        assert_eq!(Columns::parse(named), Err(expected.to_owned()), "{named}");
    }
}

#[test]
fn a_header_names_its_coordinates_or_leaves_a_doubt() {
    for (header, named, others) in [
        ("id,lon,lat,name", "lon,lat", "id name"),
        ("lat,lon", "lon,lat", ""),
        ("Latitude,Longitude,City", "Longitude,Latitude", "City"),
        ("name,northing,easting", "easting,northing", "name"),
        ("id,x,y", "x,y", "id"),
        ("id,z,y,x", "x,y,z", "id"),
        ("x,y,z,intensity", "x,y,z", "intensity"),
        (",x,y", "x,y", ""),
        ("lon,lat,height", "lon,lat", "height"),
    ] {
        let found = recognised(&format!("\n# c\n{header}\n1,2,3\n")).unwrap_or_else(|| panic!("{header}"));
        assert_eq!((found.columns.to_string(), found.others.join(" ").trim()), (named.to_owned(), others), "{header}");
    }
    for header in [
        // Read as they are.
        "x,y",
        "x,y,z",
        "lon,lat",
        "a,b",
        "1,2",
        // A doubt.
        "id,lon,lat,x,y",
        "id,lon,lat,z",
        "id,lon,latitude",
        "id,x,x,y",
        "id,x",
        "id,name,height",
        "lat,northing",
        "",
    ] {
        assert_eq!(recognised(&format!("{header}\n1,2,3\n")), None, "{header}");
    }
    let found = recognised("id,lat,lon,name\n").unwrap().to_string();
    assert_eq!(found, "x is the column `lon`, y is the column `lat`; the columns id, name are not read");
    assert_eq!(recognised("lat,lon\n").unwrap().to_string(), "x is the column `lon`, y is the column `lat`");
}

#[test]
fn decimal_commas_are_read_where_they_cannot_be_anything_else() {
    assert_eq!(points("0,5;1,5\n-2;3,25e1\n"), Ok((2, vec![0.5, 1.5, -2.0, 32.5])));
    assert_eq!(points("x;y\n\"0,5\";0x1.8p+0\n,5;+5,\n"), Ok((2, vec![0.5, 1.5, 0.5, 5.0])));
    // Points in other columns do not count.
    assert_eq!(of_columns("name;lat;lon\nSt. Imier;47,25;7,5\n", "lon,lat"), Ok((2, vec![7.5, 47.25])));
    const WHY: &str = ": a comma may be a decimal comma or a thousands separator; write all decimals with points, or \
                       all with commas";
    for (text, expected) in [
        ("0,5;1,5\n2.5;3\n", format!("p.csv:2: `2.5` has a point, and `0,5` in line 1 has a comma{WHY}")),
        ("x;y\n1.5;1\n1,5;1\n", format!("p.csv:3: `1,5` has a comma, and `1.5` in line 2 has a point{WHY}")),
        ("1.234,5;2\n", "p.csv:1: `1.234,5` has a comma and a point; remove thousands separators".to_owned()),
        ("1,234,567;2\n", "p.csv:1: `1,234,567` is not a number; write".to_owned()),
        (
            "0,1000000000000000001;2\n",
            "p.csv:1: decimal 0,1000000000000000001 has digits that no double holds; run".to_owned(),
        ),
        ("0x1,8p0;2\n", "p.csv:1: `0x1,8p0` is not a number; write".to_owned()),
        (
            "\"0,5\",\"1,5\"\n",
            "p.csv:1: `0,5` is not a number; decimal commas are supported only if `;` \
          separates"
                .to_owned(),
        ),
        (
            "0,5\t1,5\n",
            "p.csv:1: `5\\t1` is not a number; decimal commas are supported only if `;` \
          separates"
                .to_owned(),
        ),
        ("0,5 1,5\n", "p.csv:1: `5 1` is not a number; decimal commas are supported only if `;` separates".to_owned()),
    ] {
        let error = points(text).unwrap_err().to_string();
        assert!(error.starts_with(&expected), "{text:?}\n  got      {error}\n  expected {expected}");
    }
}

#[test]
fn rounding_is_counted() {
    let decimals = Decimals::new(true);
    let rows = read(
        "p.csv",
        "0.1000000000000000001,0.5\n0.2000000000000000001,0.3000000000000000001\n",
        &POINT,
        Wanted::Points,
        &decimals,
    )
    .unwrap();
    assert_eq!((rows.numbers.as_slice(), decimals.rounded()), ([0.1, 0.5, 0.2, 0.3].as_slice(), 3));
}

#[test]
fn only_inexact_decimals_are_rewritten() {
    let text = "\u{feff}# points\r\nx;y\r\n\r\n 0.1000000000000000001 ;\"0.2000000000000000001\"\r\n0.5;0x1p+0\r\n7;0.1\r\n7;1.0000000000000000001e-1";
    let expected = "\u{feff}# points\r\nx;y\r\n\r\n# 0.1000000000000000001, 0.2000000000000000001\r\n 0x1.999999999999ap-4 ;\"0x1.999999999999ap-3\"\r\n\
                    0.5;0x1p+0\r\n7;0.1\r\n# 1.0000000000000000001e-1\r\n7;0x1.999999999999ap-4";
    let once = fmt_csv("p.csv", text, None).unwrap();
    assert_eq!(once, expected);
    assert_eq!(fmt_csv("p.csv", &once, None).unwrap(), once);
    assert_eq!(
        fmt_csv("p.csv", "0.1000000000000000001 2\r", None).unwrap(),
        "# 0.1000000000000000001\r0x1.999999999999ap-4 2\r"
    );
    for (bad, message) in [
        ("1,inf\n", "not finite"),
        ("1,2\n1e400,1\n", "beyond"),
        ("1,x\n", "not a number"),
        ("1,2\n\"3,4\n", "not closed"),
    ] {
        let error = fmt_csv("p.csv", bad, None).unwrap_err().to_string();
        assert!(error.starts_with(&format!("p.csv:{}: ", bad.lines().count())) && error.contains(message), "{error}");
    }
}

#[test]
fn only_coordinates_are_rewritten() {
    const LONG: &str = "0.1000000000000000001";
    let hex = "0x1.999999999999ap-4";
    // The number of a row is no coordinate, though no double holds it.
    let text = format!("id,lat,lon\n12345678901234567890,{LONG},2\n");
    let tidy = format!("id,lat,lon\n# {LONG}\n12345678901234567890,{hex},2\n");
    assert_eq!(fmt_csv("p.csv", &text, None), Ok(tidy.clone()));
    assert_eq!(fmt_csv("p.csv", &tidy, None), Ok(tidy.clone()));
    assert_eq!(fmt_csv("p.csv", &text, Some(&columns("lon,lat"))), Ok(tidy));
    let both = fmt_csv("p.csv", &format!("a;b;c\nz;{LONG};0,1000000000000000001\n"), Some(&columns("3,b")));
    assert!(both.unwrap_err().to_string().starts_with("p.csv:2: `0.1000000000000000001` has a point, and"));
    let commas =
        fmt_csv("p.csv", "a;b;c\nz;0,1000000000000000001;0,2000000000000000001\ny;0,5;1\n", Some(&columns("c,b")))
            .unwrap();
    assert_eq!(
        commas,
        "a;b;c\n# 0,2000000000000000001; 0,1000000000000000001\nz;0x1.999999999999ap-4;0x1.999999999999ap-3\ny;0,5;1\n"
    );
    assert_eq!(of_columns(&commas, "b,c"), Ok((2, vec![0.1, 0.2, 0.5, 1.0])), "hex floats are beside decimal commas");
    // All columns of cubes are numbers.
    let cubes = fmt_csv("c.csv", &format!("x,y,z,edge\n0,0,0,{LONG}\n"), None).unwrap();
    assert_eq!(cubes, format!("x,y,z,edge\n# {LONG}\n0,0,0,{hex}\n"));
    for (text, named, expected) in [
        ("a,b\n1,x\n", None, "p.csv:2: `x` is not a number"),
        ("a,b\n1,x\n", Some(columns("b,a")), "p.csv:2: column `b`: `x` is not a number"),
        ("a,b\n1,2\n", Some(columns("c,a")), "p.csv:1: there is no column `c`"),
        ("a,b\n1\n", Some(columns("b,a")), "p.csv:2: the row has 1 cells"),
    ] {
        let error = fmt_csv("p.csv", text, named.as_ref()).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{error}");
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
        prop_assert_eq!(fmt_csv("p.csv", &text, None).unwrap(), text);
    }
}

proptest! {
    #[test]
    fn what_is_rewritten_reads_as_the_nearest(rows in prop::collection::vec([-1e9..1e9_f64, -1.0..1.0_f64], 1..20)) {
        let text: String = rows.iter().map(|[x, y]| format!("{x:?}, {y:?}\n")).collect();
        let tidy = fmt_csv("p.csv", &text, None).unwrap();
        prop_assert_eq!(&fmt_csv("p.csv", &tidy, None).unwrap(), &tidy);
        prop_assert_eq!(points(&tidy).unwrap().1, rows.as_flattened());
    }

    #[test]
    fn no_text_panics(
        text in "[0-9xy.,;#\"\r\n\t -]{0,60}|\\PC{0,30}|([0-9]{1,2}[.,]?[0-9]{0,20};){1,3}[0-9]\n([0-9]{1,2}[.,]?[0-9]{0,20};){1,3}[0-9]",
        named in prop::sample::select(&["", "1,2", "y,x", "3,1,2"][..]),
    ) {
        let named = Columns::parse(named).ok();
        let _ = (points(&text), recognised(&text));
        let wanted = named.as_ref().map_or(Wanted::Points, Wanted::Some);
        let bits = |text: &str, round| {
            let rows = read("p.csv", text, &POINT, wanted, &Decimals::new(round));
            rows.map(|rows| rows.numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>()).ok()
        };
        if let Ok(tidy) = fmt_csv("p.csv", &text, named.as_ref()) {
            prop_assert_eq!(&fmt_csv("p.csv", &tidy, named.as_ref()).unwrap(), &tidy);
            prop_assert_eq!(bits(&tidy, false), bits(&text, true), "rewritten is rounded");
        }
    }
}
