//! `resolve`: meshes that cross themselves, and meshes that can't be resolved.

use crate::common::{at, expect, read, write};
use tempfile::tempdir;

/// Two cubes of side 2, one moved by (1, 0.5, 0.25); their intersection is 1 by 1.5 by 1.75.
fn two_cubes() -> String {
    let corner = |from: [f64; 3], at: u8| {
        let [x, y, z] = [0, 1, 2].map(|axis| from[axis] + f64::from(at >> axis & 1) * 2.0);
        format!("{x} {y} {z}\n")
    };
    let faces = [
        [0, 2, 3],
        [0, 3, 1],
        [4, 5, 7],
        [4, 7, 6],
        [0, 1, 5],
        [0, 5, 4],
        [2, 6, 7],
        [2, 7, 3],
        [0, 4, 6],
        [0, 6, 2],
        [1, 3, 7],
        [1, 7, 5],
    ];
    let mut text = "OFF\n16 24 0\n".to_owned();
    text.extend([[0.0; 3], [1.0, 0.5, 0.25]].into_iter().flat_map(|from| (0..8).map(move |at| corner(from, at))));
    let face = |first: usize| faces.map(move |[a, b, c]| format!("3 {} {} {}\n", a + first, b + first, c + first));
    text.extend(face(0).into_iter().chain(face(8)));
    text
}

/// Six times the volume of an OFF file of triangles, computed from its coordinates.
fn volume(off: &str) -> f64 {
    let mut lines = off.lines().skip(1);
    let row = |line: &str| line.split_ascii_whitespace().map(|x| x.parse::<f64>().unwrap()).collect::<Vec<f64>>();
    let counts: Vec<usize> = lines.next().unwrap().split_ascii_whitespace().map(|x| x.parse().unwrap()).collect();
    let points: Vec<Vec<f64>> = lines.by_ref().take(counts[0]).map(row).collect();
    let corners =
        |line: &str| -> Vec<usize> { line.split_ascii_whitespace().skip(1).map(|x| x.parse().unwrap()).collect() };
    let minor = |p: &[f64], q: &[f64], i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
    let six = |line: &str| {
        let [a, b, c] = corners(line)[..] else { panic!("a triangle: {line}") };
        let [a, b, c] = [&points[a], &points[b], &points[c]];
        a[0] * minor(b, c, 1, 2) + a[1] * minor(b, c, 2, 0) + a[2] * minor(b, c, 0, 1)
    };
    lines.take(counts[1]).map(six).sum()
}

#[test]
fn cubes_that_overlap_become_one_mesh() {
    let folder = tempdir().unwrap();
    let mesh = write(&folder, "two.off", &two_cubes());
    let out = at(&folder, "one.off");
    let told = expect(0, &["corpus", "resolve", &mesh, "--out", &out]);
    assert!(told.stdout.contains("triangles cut") && told.stdout.contains("does not cross itself"), "{}", told.stdout);
    // All coordinates are doubles, so nothing rounds: the result is six times (16 − 2.625).
    let text = std::fs::read_to_string(&out).unwrap();
    assert_eq!(volume(&two_cubes()), 6.0 * 16.0);
    assert_eq!(volume(&text), 6.0 * 13.375);
    // A second time there is nothing to do, and the task that refused the mesh accepts the result.
    let again = expect(0, &["corpus", "resolve", &out, "--out", &at(&folder, "again.stl")]);
    assert!(again.stdout.contains("\n0 pairs crossed; 0 triangles cut"), "{}", again.stdout);
    let pair = ["solve", "mesh-intersect", "-b", "sos:per-mesh"];
    let refused = expect(104, &[&pair[..], &[&mesh, &out, "--out", &at(&folder, "cut")]].concat()).stderr;
    assert!(refused.starts_with(&format!("predicament: {mesh}:")), "{refused}");
    for word in ["pass through each other", "`corpus resolve`", "add --set check=false"] {
        assert!(refused.contains(word), "{refused}");
    }
    expect(0, &[&pair[..], &[&out, &out, "--out", &at(&folder, "cut")]].concat());
    assert_eq!(volume(&read(&at(&folder, "cut"), "intersection.off")), 6.0 * 13.375);
}

/// Two boxes of one mesh that touch in a part of a face, and a box across both.
#[test]
fn parts_that_lie_on_each_other_are_refused_with_the_cure() {
    let folder = tempdir().unwrap();
    let corner =
        |low: [f64; 3], size: f64, at: usize| [0, 1, 2].map(|axis| low[axis] + f64::from(at >> axis & 1 != 0) * size);
    let faces =
        "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n";
    let off = |boxes: &[([f64; 3], f64)]| {
        let points = boxes.iter().flat_map(|&(low, size)| (0..8).map(move |at| corner(low, size, at)));
        let points: String = points.map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();
        let moved = |by: usize| {
            let line = |line: &str| {
                let corners = line.split(' ').skip(1).map(|at| (at.parse::<usize>().unwrap() + by).to_string());
                format!("3 {}\n", corners.collect::<Vec<_>>().join(" "))
            };
            faces.lines().map(line).collect::<String>()
        };
        let faces: String = (0..boxes.len()).map(|at| moved(8 * at)).collect();
        format!("OFF\n{} {} 0\n{points}{faces}", 8 * boxes.len(), 12 * boxes.len())
    };
    let mesh = write(&folder, "two.off", &off(&[([0.0; 3], 4.0), ([3.0, 3.0, 4.0], 4.0)]));
    let tool = write(&folder, "tool.off", &off(&[([2.0, 2.0, 3.0], 2.0)]));
    let pair = ["solve", "mesh-intersect", "-b", "exact", &mesh, &tool, "--out"];
    let [refused, taken] = [at(&folder, "refused"), at(&folder, "taken")];
    let refused = expect(104, &[&pair[..], &[&refused]].concat()).stderr;
    for word in
        ["triangles 2 (line 21) and 13 (line 32) of the mesh lie on each other;", "unite the parts", "`corpus resolve`"]
    {
        assert!(refused.contains(word), "{word}: {refused}");
    }
    let declined = expect(2, &[&pair[..], &[&taken, "--set", "check=false"]].concat()).stderr;
    for word in ["triangles 2 and 12 of the first mesh", "unite the parts", "`corpus resolve`", "sos:per-mesh"] {
        assert!(declined.contains(word), "{word}: {declined}");
    }
    let out = at(&folder, "one.off");
    expect(0, &["corpus", "resolve", &mesh, "--out", &out]);
    expect(0, &["solve", "mesh-intersect", "-b", "exact", &out, &tool, "--out", &at(&folder, "cut")]);
    assert_eq!(volume(&read(&at(&folder, "cut"), "intersection.off")), 6.0 * 5.0);
}

#[test]
fn what_bounds_nothing_is_named() {
    let folder = tempdir().unwrap();
    let whole = two_cubes();
    let open = whole.replacen("16 24 0", "16 23 0", 1);
    let open = open.trim_end().rsplit_once('\n').unwrap().0.to_owned() + "\n";
    let out = at(&folder, "out.off");
    for (name, text, out, code, wanted) in [
        ("open.off", open.as_str(), out.as_str(), 104, "open at the edge of points 9 (line 12)"),
        ("decimal.off", &whole.replacen("0 0 0\n", "0.1000000000000000001 0 0\n", 1), &out, 104, "--round"),
        ("empty.off", "OFF\n0 0 0\n", &out, 104, "triangles"),
        ("two.off", &whole, "out.txt", 2, "name a .off, .obj, .ply or .stl file"),
    ] {
        let mesh = write(&folder, name, text);
        let told = expect(code, &["corpus", "resolve", &mesh, "--out", out]);
        assert!(told.stderr.contains(wanted), "{name}: {}", told.stderr);
    }
    assert!(!std::path::Path::new(&out).exists());
}
