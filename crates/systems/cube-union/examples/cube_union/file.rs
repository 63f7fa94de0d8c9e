//! Cubes in a file: the first line is `# edge 5`, the second the names `x,y,z`; each further line is the lower corner
//! of a cube, as integers.

use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::path::Path;

const NAMES: &str = "x,y,z";

/// Writes cubes to a file.
pub fn write(path: &Path, lowers: &[[i32; 3]], edge: i32) -> Result<(), String> {
    let all = || -> std::io::Result<()> {
        let mut file = BufWriter::new(File::create(path)?);
        writeln!(file, "# edge {edge}\n{NAMES}")?;
        lowers.iter().try_for_each(|[x, y, z]| writeln!(file, "{x},{y},{z}"))?;
        file.flush()
    };
    all().map_err(|error| format!("{}: {error}", path.display()))
}

/// Reads cubes: their lower corners and the length of their edges. Empty lines are skipped.
pub fn read(path: &Path) -> Result<(Vec<[i64; 3]>, i64), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", path.display());
    let mut lines = (1_u64..).zip(BufReader::new(File::open(path).map_err(failed)?).lines());
    let mut next = || lines.next().map(|(number, line)| line.map(|line| (number, line)).map_err(failed)).transpose();
    let at = |number: u64, what: &str| format!("{}:{number}: {what}", path.display());

    let first = next()?.map_or(String::new(), |(_, line)| line);
    let edge = first.trim().strip_prefix("# edge ").and_then(|edge| edge.trim().parse::<i64>().ok());
    let edge = edge.ok_or_else(|| at(1, "the first line must be `# edge N`, N the integer length of all edges"))?;
    if edge <= 0 {
        return Err(at(1, &format!("the edge length is {edge}; it must be positive")));
    }
    if next()?.is_none_or(|(_, line)| line.trim() != NAMES) {
        return Err(at(2, "the second line must be `x,y,z`"));
    }
    let mut lowers = Vec::new();
    while let Some((number, line)) = next()? {
        if line.trim().is_empty() {
            continue;
        }
        let values: Vec<&str> = line.split(',').map(str::trim).collect();
        let &[x, y, z] = &values[..] else {
            return Err(at(number, &format!("{} values; a lower corner has three", values.len())));
        };
        let mut lower = [0; 3];
        for ((coordinate, value), name) in lower.iter_mut().zip([x, y, z]).zip(NAMES.split(',')) {
            *coordinate = value.parse().map_err(|_| {
                let why = "is no integer of 64 bits; give coordinates in a common unit";
                at(number, &format!("{name} `{value}` {why}"))
            })?;
        }
        lowers.push(lower);
    }
    Ok((lowers, edge))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_text(text: &str) -> Result<(Vec<[i64; 3]>, i64), String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cubes.csv");
        std::fs::write(&path, text).unwrap();
        read(&path)
    }

    #[test]
    fn what_is_written_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cubes.csv");
        let lowers = [[1, -2, 3], [i32::MAX, i32::MIN, 0]];
        write(&path, &lowers, 7).unwrap();
        assert_eq!(read(&path), Ok((lowers.map(|lower| lower.map(i64::from)).into(), 7)));
        write(&path, &[], 1).unwrap();
        assert_eq!(read(&path), Ok((vec![], 1)));
        assert_eq!(read_text("# edge 2\r\nx,y,z\r\n 1, 2,3\r\n"), Ok((vec![[1, 2, 3]], 2)));
    }

    #[test]
    fn a_bad_line_is_named() {
        let bad = [
            ("", 1, "must be `# edge N`"),
            ("x,y,z\n1,2,3\n", 1, "must be `# edge N`"),
            ("# edge 0.5\nx,y,z\n", 1, "must be `# edge N`"),
            ("# edge -3\nx,y,z\n", 1, "-3; it must be positive"),
            ("# edge 3\n", 2, "must be `x,y,z`"),
            ("# edge 3\n1,2,3\n", 2, "must be `x,y,z`"),
            ("# edge 3\nx,y,z\n1,2,3\n1,2\n", 4, "2 values"),
            ("# edge 3\nx,y,z\n1,2,3,4\n", 3, "4 values"),
            ("# edge 3\nx,y,z\n1,2,3\n1,0.5,3\n", 4, "y `0.5`"),
            ("# edge 3\nx,y,z\n\n1,2,9223372036854775808\n", 4, "z `9223372036854775808`"),
        ];
        for (text, line, why) in bad {
            let error = read_text(text).unwrap_err();
            assert!(error.contains(&format!("cubes.csv:{line}: ")) && error.contains(why), "{text:?}: {error}");
        }
        let error = read(Path::new("/nowhere/cubes.csv")).unwrap_err();
        assert!(error.starts_with("/nowhere/cubes.csv: "), "{error}");
    }
}
