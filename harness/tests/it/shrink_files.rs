//! `shrink FILE… -- COMMAND {}`, with commands in awk and sh.

use std::fmt::Write as _;
use std::fs;
use std::time::Duration;

use tempfile::{TempDir, tempdir};

use crate::common::{Told, at, expect, read, tool, write};

/// Ends with code 3 if two faces of an OFF file have the same three corners.
const TWICE: &str = "FNR==2 { v=$1 } FNR>2+v { a=$2<$3?$2:$3; a=a<$4?a:$4; c=$2>$3?$2:$3; c=c>$4?c:$4;\n\
    if (seen[FILENAME a\",\"c\",\"($2+$3+$4)]++) bad=3 } END { exit bad }\n";

/// Ends with code 1 if a loop of a WKT file has two edges that cross.
const CROSSES: &str = "function side(a,b,c) { return (x[b]-x[a])*(y[c]-y[a]) - (y[b]-y[a])*(x[c]-x[a]) }\n\
    { n=split($0,rings,\"(\"); for (r=1;r<=n;r++) { m=split(rings[r],p,\",\"); k=0; for (i=1;i<=m;i++) {\n\
    sub(/^ +/,\"\",p[i]); if (split(p[i],q,/[ )]+/)>=2 && p[i]!~/^[A-Z]/) { x[++k]=q[1]+0; y[k]=q[2]+0 } }\n\
    for (i=1;i<k;i++) for (j=i+2;j<k;j++) if (side(i,i+1,j)*side(i,i+1,j+1)<0 && side(j,j+1,i)*side(j,j+1,i+1)<0) bad=1 } }\n\
    END { exit bad }\n";

/// Prints a line if four rows of `id,x,y` are on a circle and not on a line.
const CIRCLE: &str = "BEGIN { FS=\",\" } FNR>1 { x[++n]=$2; y[n]=$3 }\n\
    function turn(a,b,c) { return (x[b]-x[a])*(y[c]-y[a]) - (y[b]-y[a])*(x[c]-x[a]) }\n\
    function lift(a,d) { return (x[a]-x[d])^2+(y[a]-y[d])^2 }\n\
    END { for (a=1;a<=n;a++) for (b=a+1;b<=n;b++) for (c=b+1;c<=n;c++) if (turn(a,b,c)!=0) for (d=c+1;d<=n;d++) {\n\
    v=lift(a,d)*turn(b,c,d)-lift(b,d)*turn(a,c,d)+lift(c,d)*turn(a,b,d);\n\
    if (v==0) { print \"four on a circle\"; exit 0 } } }\n";

/// A strip of triangles in OFF, with a second copy of one of them, its corners in another order.
fn strip(triangles: usize, copied: usize) -> String {
    let mut text = format!("OFF\n{} {} 0\n", triangles + 2, triangles + 1);
    for at in 0..triangles + 2 {
        let _ = writeln!(text, "{}.125 {}.0625 0.37{at}", at / 2, at % 2);
    }
    for at in (0..triangles).chain([copied]) {
        let _ = writeln!(text, "3 {} {} {}", at, at + 1, at + 2);
    }
    text.replace(
        &format!("\n3 {copied} {} {}\n", copied + 1, copied + 2),
        &format!("\n3 {} {copied} {}\n", copied + 2, copied + 1),
    )
}

/// Shrinks files into the folder `out` of a temporary folder; the command is awk with a program.
fn shrunk(folder: &TempDir, code: i32, files: &[&str], out: &str, options: &[&str], program: &str) -> Told {
    let script = write(folder, "check.awk", program);
    let out = at(folder, out);
    let tail = ["--out", &out, "-q", "--", "awk", "-f", &script, "{}"];
    expect(code, &[&["shrink"], files, options, &tail].concat())
}

/// Red if points that no face names are kept.
#[test]
fn two_triangles_with_three_common_corners_are_left_of_hundreds() {
    let folder = tempdir().unwrap();
    let file = write(&folder, "a.off", &strip(300, 97));
    let told = shrunk(&folder, 0, &[&file], "out", &["--when", "code=3"], TWICE);
    let smallest = "OFF\n3 2 0\n0 0 0\n0 0 0\n0 0 0\n3 0 2 1\n3 0 2 1\n";
    let left = read(&at(&folder, "out"), "a.off");
    let corners = |text: &str| text.lines().skip(5).map(|line| line.split(' ').count()).collect::<Vec<_>>();
    assert_eq!((left.len(), corners(&left)), (smallest.len(), vec![4, 4]), "{left}");
    assert!(told.stdout.contains("301 to 2 items, 302 to 3 points,"), "{}", told.stdout);
    // The result does not depend on the number of threads.
    for threads in ["1", "3"] {
        shrunk(&folder, 0, &[&file], threads, &["--threads", threads], TWICE);
        assert_eq!(read(&at(&folder, threads), "a.off"), left, "{threads} threads");
    }
}

#[test]
fn two_files_are_shrunk_together() {
    let folder = tempdir().unwrap();
    let [a, b] = ["a.off", "b.off"].map(|name| write(&folder, name, &strip(40, 7)));
    shrunk(&folder, 0, &[&a, &b], "out", &[], TWICE);
    let sizes = ["a.off", "b.off"].map(|name| read(&at(&folder, "out"), name).lines().nth(1).unwrap().to_owned());
    // One file keeps the failure, the other one a face.
    assert!(sizes.contains(&"3 2 0".to_owned()) && sizes.contains(&"3 1 0".to_owned()), "{sizes:?}");
}

#[test]
fn a_polygon_that_crosses_itself_keeps_four_corners() {
    let folder = tempdir().unwrap();
    let comb: String = (0..40).map(|at| format!("{}.25 {}.5, ", at, 3 * (at % 2))).collect();
    let text = format!(
        "POLYGON ((0 0, 90 0, 90 90, 0 90, 0 0), (5 5, 6 5, 6 6, 5 5))\n\
         MULTIPOLYGON (((0 -9, 9 -9, 9 -8, 0 -9)), (({comb}40 9, 3.5 1.125, -1 9, 0.25 0.5), (50 50, 51 50, 51 51, 50 50)))\n\
         POINT (1 2)\n"
    );
    let file = write(&folder, "map.wkt", &text);
    shrunk(&folder, 0, &[&file], "out", &[], CROSSES);
    let left = read(&at(&folder, "out"), "map.wkt");
    assert!(left.starts_with("POLYGON ((") && left.lines().count() == 1, "{left}");
    assert_eq!((left.matches(',').count(), left.matches('(').count()), (4, 2), "{left}");
    assert!(
        left.split(['(', ')', ',', ' '])
            .filter(|word| word.starts_with(|c: char| c.is_ascii_digit()))
            .all(|word| word.len() == 1),
        "{left}"
    );
}

#[test]
fn four_rows_on_a_circle_are_left_with_their_header_and_order() {
    let folder = tempdir().unwrap();
    let points = [(0, 0), (7, 1), (25, 0), (3, 11), (0, 25), (13, 29), (-7, 24), (2, 17), (-20, -15), (31, 5)];
    let rows: String = points.iter().enumerate().map(|(at, (x, y))| format!("p{at},{x},{y}\n")).collect();
    let file = write(&folder, "p.csv", &format!("id,x,y\n{rows}"));
    shrunk(&folder, 0, &[&file], "out", &["--when", "prints=on a circle"], CIRCLE);
    let left = read(&at(&folder, "out"), "p.csv");
    let ids: Vec<&str> = left.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert!(left.starts_with("id,x,y\n") && ids.len() == 4 && ids.is_sorted(), "{left}");
}

/// Red if the journal is not read (more runs), or if a candidate is taken twice in another order (other bytes).
#[test]
#[cfg(unix)]
fn a_killed_search_goes_on_and_ends_as_if_it_had_not_been_killed() {
    let folder = tempdir().unwrap();
    let file = write(&folder, "a.off", &strip(24, 9));
    let script = write(&folder, "slow.awk", TWICE);
    let slow = format!("sleep 0.02; awk -f {script} \"$0\"");
    let command = ["--", "sh", "-c", &slow, "{}"];
    let [whole, cut] = ["whole", "cut"].map(|name| at(&folder, name));
    let lines = |out: &str| fs::read_to_string(format!("{out}/journal.csv")).unwrap_or_default().lines().count();
    expect(0, &[&["shrink", &file, "--threads", "1", "-q", "--out", &whole], &command[..]].concat());
    let all = lines(&whole);
    let mut child = tool(&[&["shrink", &file, "--threads", "1", "-q", "--out", &cut], &command[..]].concat());
    let mut child = child.spawn().unwrap();
    while lines(&cut) < all / 3 {
        assert_eq!(child.try_wait().unwrap(), None, "it ended before it was killed");
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(lines(&cut) < all);
    let journal = fs::read_to_string(format!("{cut}/journal.csv")).unwrap() + "0123";
    fs::write(format!("{cut}/journal.csv"), journal).unwrap();
    let refused = expect(2, &["shrink", "--resume", &cut]).stderr;
    assert!(refused.contains("write the command again after `--`"), "{refused}");
    let refused = expect(2, &["shrink", "--resume", &cut, "--", "false", "{}"]).stderr;
    assert!(refused.contains("is not the same") && refused.contains("--resume"), "{refused}");
    // A folder of a stranger does not write elsewhere.
    let state = read(&cut, "files.json");
    fs::write(format!("{cut}/files.json"), state.replace("\"a.off\"", "\"../a.off\"")).unwrap();
    let refused = expect(2, &[&["shrink", "--resume", &cut], &command[..]].concat()).stderr;
    assert!(refused.contains("`../a.off` is not a name of a file"), "{refused}");
    fs::write(format!("{cut}/files.json"), state).unwrap();
    let told = expect(0, &[&["shrink", "--resume", &cut, "--threads", "1", "-q"], &command[..]].concat());
    assert_eq!((read(&cut, "a.off"), lines(&cut)), (read(&whole, "a.off"), all), "{}", told.stdout);
    assert!(told.stdout.contains(&format!("{all} runs of the command")), "{}", told.stdout);
}

#[test]
#[cfg(unix)]
fn time_limits_signals_and_placeholders() {
    let folder = tempdir().unwrap();
    let file = write(&folder, "p.csv", "1,2\n3,4\n");
    let pids = at(&folder, "pids");
    // The command leaves a process behind, which ends with it.
    let hang = format!("sleep 60 & echo $! >> {pids}; grep -q ^1 {{1}} || exit 0; wait");
    let hang = ["--", "sh", "-c", &hang];
    let out = at(&folder, "timeout");
    expect(0, &[&["shrink", &file, "--when", "timeout", "--timeout", "0.2", "-q", "--out", &out], &hang[..]].concat());
    assert_eq!(read(&out, "p.csv"), "1,0\n");
    for pid in fs::read_to_string(&pids).unwrap().lines().filter(|_| cfg!(target_os = "linux")) {
        assert!(!std::path::Path::new(&format!("/proc/{pid}")).exists(), "{pid} still runs");
    }
    let out = at(&folder, "signal");
    let crash = ["--", "sh", "-c", "test -d {dir} && ! grep -q 3 $0 || kill -SEGV $$", "{}"];
    expect(0, &[&["shrink", &file, "--when", "signal", "-q", "--out", &out], &crash[..]].concat());
    assert_eq!(read(&out, "p.csv"), "3,0\n");
}

#[test]
fn bad_input_is_refused_with_its_place_and_cure() {
    let folder = tempdir().unwrap();
    let good = write(&folder, "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    let bad = write(&folder, "b.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n");
    let [none, packed] = [at(&folder, "none.off"), write(&folder, "a.off.gz", "")];
    let full = at(&folder, "");
    for (words, why) in [
        (vec![&*bad, "--", "false", "{}"], "b.off:4: `1` is not one of the 1 vertices"),
        (vec![&none, "--", "false", "{}"], "none.off: the data file can't be read: there is no such file"),
        (vec![&packed, "--", "false", "{}"], "a.off.gz: the file is packed; unpack it"),
        (vec![&good, "--", "no-such-program", "{}"], "`no-such-program` does not start"),
        (vec![&good, "--", "sh", "-c", "no-such-program {}"], "a shell may not have found the command"),
        (vec![&good, "--", "false"], "has no place for a.off; write {} for all files"),
        (vec![&good, &good, "--", "false", "{1}"], "has no place for 2-a.off; write {}"),
        (vec![&good, &good, "--", "false", "--in={}"], "`--in={}`: 2 files do not fit; write {1}"),
        (vec![&good, "--", "true", "{}"], "does not fail on a.off (nonzero): its exit code is 0; check"),
        (vec![&good, "--when", "code=x", "--", "false", "{}"], "`code=x` is not a condition; write nonzero"),
        (vec![&good, "--when", "signal"], "--when"),
        (vec![&good], "files and, after `--`, the command"),
        (vec![&good, "--out", &full, "--", "false", "{}"], "the folder is not empty; continue"),
    ] {
        let told = expect(2, &[&["shrink"], &words[..]].concat());
        assert!(told.stderr.contains(why), "{words:?}: {}", told.stderr);
    }
    // A comment is not kept.
    let noted = write(&folder, "c.off", "OFF # noted\n1 0 0\n0 0 0\n");
    let told = expect(2, &["shrink", &noted, "--", "sh", "-c", "! grep -q noted {}"]);
    assert!(told.stderr.contains("c.off, but not on the points and faces alone"), "{}", told.stderr);
}
