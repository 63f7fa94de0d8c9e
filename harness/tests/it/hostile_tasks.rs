//! An engine that goes wrong on whole tasks in every way, one scene each: each scene has its own row and reason, and
//! the scenes after it are answered. It needs Python.

use crate::common::{at, column, read, run, write};
use tempfile::tempdir;

/// Speaks the protocol without the helper. The number of points of a scene says what goes wrong on it.
const ENGINE: &str = r#"
import os, struct, subprocess, sys, time

def receive():
    head = os.read(0, 4)
    if len(head) < 4:
        sys.exit(0)
    (length,) = struct.unpack("<I", head)
    body = b""
    while len(body) < length:
        body += os.read(0, length - len(body))
    entries, place = {}, 0
    while place < length:
        size = body[place]
        key = body[place + 1 : place + 1 + size].decode()
        place += 1 + size
        (size,) = struct.unpack_from("<I", body, place)
        entries[key] = body[place + 4 : place + 4 + size]
        place += 4 + size
    return entries

def encoded(entries):
    body = b""
    for key, value in entries.items():
        body += bytes([len(key)]) + key.encode() + struct.pack("<I", len(value)) + value
    return struct.pack("<I", len(body)) + body

def send(raw):
    while raw:
        raw = raw[os.write(1, raw):]

while True:
    asked = receive()
    if asked["type"] == b"hello":
        send(encoded({"type": b"hello", "protocol": b"1", "name": b"hostile", "version": b"1", "predicates": b"",
                      "tasks": b"hull2d overlay2d", "zero": b"exact", "precision": b"f64", "id": asked["id"]}))
        continue
    count = len(asked["numbers:points"]) // 16
    answer = {"type": b"answer", "ns": b"1", "id": asked["id"]}
    hull = list(range(count))
    if asked["task"] == b"overlay2d":
        answer["numbers:union"] = struct.pack("<8d", 0, 0, 1, 0, 1, float("nan"), 0, 1)
        send(encoded(answer))
        continue
    if count == 4:
        hull[-1] = 10 ** 6
    elif count == 5:
        hull = hull[: count // 2]
    elif count == 6:
        os._exit(7)
    elif count == 7:
        time.sleep(60)
    elif count == 8:
        answer["ids:hull"] = struct.pack(f"<{count}I", *hull)
        raw = encoded(answer)
        send(raw[: len(raw) // 2])
        os._exit(0)
    elif count == 9:
        subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"], stdin=subprocess.DEVNULL)
        os._exit(0)
    elif count == 10:
        # Eighty million triangles: the length comes first.
        send(struct.pack("<I", 4 * 3 * 8 * 10 ** 7) + b"\x04type\x06\x00\x00\x00answer\x08ids:hull")
        try:
            while True:
                send(b"\0" * 65536)
        except OSError:
            os._exit(0)
    elif count == 11:
        answer["ids:hull"] = b"\0" * 7
        send(encoded(answer))
        continue
    elif count == 12:
        os.kill(os.getpid(), 11)
    answer["ids:hull"] = struct.pack(f"<{len(hull)}I", *hull)
    send(encoded(answer))
"#;

#[test]
#[ignore = "needs Python"]
fn each_fault_in_python_has_its_row_and_the_scenes_after_it_are_answered() {
    let folder = tempdir().unwrap();
    // Points on a parabola, in their order around the hull; the last scene is answered rightly.
    let scene = |count: i32, name: &str| {
        let points: Vec<String> = (0..count).map(|x| format!("[{x}, {}]", x * x)).collect();
        format!("[[scene]]\nname = \"{name}\"\ntask = \"hull2d\"\npoints = [{}]\n", points.join(", "))
    };
    let expected: [(&str, i32, &str, &str, &str); 10] = [
        ("a-point-that-is-none", 4, "topology", "form of an answer", "the index 1000000, but the scene has 4 points"),
        ("half-a-hull", 5, "topology", "span", "2 vertices of a hull of 2 dimensions"),
        ("ends", 6, "panic", "crashed", "the process ended with code 7"),
        ("silent", 7, "timeout", "silence", "no answer to `task` within 2s"),
        ("half-an-answer", 8, "panic", "protocol", "a message that ends after"),
        ("keeps-the-pipe", 9, "panic", "crashed", "the process ended with code 0"),
        ("eighty-million-triangles", 10, "panic", "protocol", "an answer of 960000000 bytes; at most"),
        ("half-a-number", 11, "panic", "protocol", "ids:hull"),
        ("crash", 12, "panic", "crashed", "the process was ended by signal 11"),
        ("right", 3, "", "", ""),
    ];
    let mut suite = "title = \"Hostile\"\n".to_owned();
    suite.extend(expected.iter().map(|(name, count, ..)| scene(*count, name)));
    suite += "[[scene]]\nname = \"nan\"\ntask = \"overlay2d\"\npoints = [[0, 0], [4, 0], [0, 4], [0, 0], [4, 0], [0, 4]]\n\
              first = [[0, 1, 2]]\nsecond = [[3, 4, 5]]\n";
    suite += &scene(13, "right-at-the-end");
    let suite = write(&folder, "suite.toml", &suite);
    write(&folder, "engine.py", ENGINE);
    let config = "name = \"hostile\"\nrun = [\"python3\", \"engine.py\"]\ntimeout = 2\n";
    let engine = write(&folder, "engine.toml", config);
    let out = at(&folder, "run");
    let ran = run(&["run", &suite, "-b", &format!("engine:{engine}"), "--out", &out]);
    assert_eq!(ran.code, 103, "silence leaves the run incomplete: {}{}", ran.stdout, ran.stderr);
    let summary = read(&out, "summary.csv");
    let scenes = column(&summary, "scene");
    assert_eq!(scenes.len(), expected.len() + 2, "a row for each scene: {summary}");
    let findings = read(&out, "findings.csv");
    for (name, _, class, check, said) in expected.iter().chain(&[("nan", 0, "topology", "form of an answer", "NaN")]) {
        let rows: Vec<&str> = findings.lines().filter(|row| row.contains(&format!("suite,{name},"))).collect();
        assert_eq!(rows.is_empty(), class.is_empty(), "{name}: {findings}");
        let is_told = |row: &&str| row.contains(&format!(",{class},{check},")) && row.contains(said);
        assert!(class.is_empty() || rows.iter().any(is_told), "{name}: {findings}");
    }
    let ok = column(&summary, "status").into_iter().zip(&scenes).filter(|(status, _)| status == "ok");
    assert_eq!(ok.map(|(_, scene)| scene.as_str()).collect::<Vec<_>>(), ["right", "right-at-the-end"], "{summary}");
}

/// Reports an error for quadrangles whose third corner has a certain x, and answers all others.
const RIGHT_AND_WRONG: &str = r#"
import sys
import predicament_engine

def triangulate(points, rings):
    refuses = any(len(points) == 4 and [points[v] for v in ring][2][0] == REFUSED for ring in rings)
    if refuses:
        raise ValueError("not a polygon")
    ring = rings[0]
    return [[ring[0], ring[at], ring[at + 1]] for at in range(1, len(ring) - 1)]

engine = predicament_engine.Engine("mine", "1.0")
engine.task("triangulate", triangulate)
predicament_engine.serve(engine)
"#;

/// The third corner of the bow tie has the x 4, and that of the other quadrangle 5.
const QUADRANGLES: &str = r#"title = "Quadrangles"
[[scene]]
name = "bow-tie"
task = "triangulate"
invalid = true
points = [[0, 0], [3, 3], [4, 0], [0, 4]]
[[scene]]
name = "square"
task = "triangulate"
points = [[0, 0], [4, 0], [5, 4], [0, 4]]
"#;

#[test]
#[ignore = "needs Python"]
fn an_error_in_python_is_right_for_invalid_input_alone() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "suite.toml", QUADRANGLES);
    let helper = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines/python/predicament_engine.py");
    std::fs::copy(helper, at(&folder, "predicament_engine.py")).unwrap();
    let engine = write(&folder, "engine.toml", "name = \"mine\"\nrun = [\"python3\", \"engine.py\"]\n");
    // The corner whose quadrangle the engine refuses, and the findings.
    for (refused, code, findings) in [
        ("4", 0, vec![]),
        ("5", 100, vec![("bow-tie", "accepted,accepted invalid input"), ("square", "refused,refused valid input")]),
        ("9", 100, vec![("bow-tie", "accepted,accepted invalid input")]),
    ] {
        write(&folder, "engine.py", &RIGHT_AND_WRONG.replace("REFUSED", refused));
        let out = at(&folder, &format!("run-{refused}"));
        let ran = run(&["run", &suite, "-b", &format!("engine:{engine}"), "--out", &out]);
        assert_eq!(ran.code, code, "{refused}: {}{}", ran.stdout, ran.stderr);
        let told = read(&out, "findings.csv");
        assert_eq!(told.lines().count(), findings.len() + 1, "{refused}: {told}");
        for (scene, finding) in &findings {
            assert!(told.lines().any(|row| row.contains(scene) && row.contains(finding)), "{refused}: {told}");
        }
        let summary = read(&out, "summary.csv");
        let of = |class: &str| column(&summary, class).iter().filter(|count| *count != "0").count();
        let accepted = findings.iter().filter(|(scene, _)| *scene == "bow-tie").count();
        assert_eq!((of("accepted"), of("refused")), (accepted, findings.len() - accepted), "{refused}: {summary}");
    }
    // The gate tells both from wrong answers, and the scoreboard counts them.
    let out = at(&folder, "run-5");
    for (fail_on, code) in [("broken,not_done,rounded", 0), ("accepted", 100), ("refused", 100)] {
        assert_eq!(run(&["gate", &out, "--fail-on", fail_on]).code, code, "{fail_on}");
    }
    let board = at(&folder, "board");
    assert_eq!(run(&["scoreboard", &out, "--out", &board]).code, 0);
    let csv = read(&board, "scoreboard.csv");
    assert!(csv.contains("triangulate,engine:mine,suite,2,0,0,0,0,1,1,0\n"), "{csv}");
}

/// Starts its triangles with another corner from the fifth answer on.
const MOODY: &str = r#"
import predicament_engine

answers = 0

def triangulate(points, rings):
    global answers
    answers += 1
    ring = rings[0][1:] + rings[0][:1] if answers > 4 else rings[0]
    return [[ring[0], ring[at], ring[at + 1]] for at in range(1, len(ring) - 1)]

engine = predicament_engine.Engine("mine", "1.0")
engine.task("triangulate", triangulate)
predicament_engine.serve(engine)
"#;

#[test]
#[ignore = "needs Python"]
fn answers_in_python_that_change_do_not_stop_a_bench() {
    let folder = tempdir().unwrap();
    let scene = |name: &str, x: u32| {
        format!("[[scene]]\nname = \"{name}\"\ntask = \"triangulate\"\npoints = [[0, 0], [4, 0], [{x}, 4], [0, 4]]\n")
    };
    let scenes = scene("first", 4) + &scene("second", 5);
    let suite = write(&folder, "suite.toml", &format!("title = \"Quadrangles\"\n{scenes}"));
    let helper = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines/python/predicament_engine.py");
    std::fs::copy(helper, at(&folder, "predicament_engine.py")).unwrap();
    write(&folder, "engine.py", MOODY);
    let engine = write(&folder, "engine.toml", "name = \"mine\"\nrun = [\"python3\", \"engine.py\"]\n");
    let (out, bench) = (at(&folder, "run"), at(&folder, "bench"));
    let backends = format!("engine:{engine},exact");
    assert_eq!(run(&["run", &suite, "-b", &backends, "--out", &out]).code, 0);
    let rest = ["--samples", "9", "--sample-ms", "0", "-b", &backends, "--out", &bench];
    let ran = run(&[&["bench", "--judged", &out][..], &rest].concat());
    assert_eq!(ran.code, 0, "{}{}", ran.stdout, ran.stderr);
    assert_eq!(ran.stdout.matches("times only: suite/").count(), 1, "{}", ran.stdout);
    assert!(ran.stdout.contains("answers changed while timed"), "{}", ran.stdout);
    let of_exact = column(&read(&bench, "throughput.csv"), "backend").iter().filter(|name| *name == "exact").count();
    assert!(of_exact >= 12, "{of_exact} samples of two scenes");
}
