//! The user's own points: `ask`, `new`, `run --answers`, and suites by path in every command.

use std::io::Write as _;
use std::process::Stdio;

use crate::common::{SUITE, at, column, expect, read, run, told, tool, write};
use tempfile::tempdir;

#[test]
fn typed_points_are_answered_by_every_backend() {
    // The point is right of the line through (1, 0) and (2, 0) by less than the rounding error of doubles.
    let args = ["ask", "orient2d", "0.5,0x1.0000000000001p-1", "12,12", "24,24", "-b", "exact,naive,sos", "--format"];
    let told = expect(100, &[&args[..], &["csv"]].concat());
    let lines: Vec<&str> = told.stdout.lines().collect();
    assert_eq!(
        lines[0],
        "query,args,exact,value,exact_value,exact answer,exact class,exact stage,\
         naive answer,naive class,naive stage,sos answer,sos class,sos stage",
        "no name is there twice"
    );
    // (a - c) × (b - c) = (-23.5)(-12) - (-23.5 + 2^-53)(-12) = 12 · 2^-53
    let row = "orient2d(xy; 0 1 2),0 1 2,+,1.3322676295501878e-15,3/2251799813685248,+,agree,";
    assert!(lines[1].starts_with(row), "{}", lines[1]);
    assert!(lines[1].contains(",0,overreach,float,+,agree,"), "{}", lines[1]);
    let text = expect(100, &[&args[..], &["text"]].concat()).stdout;
    assert!(
        text.starts_with("orient2d(xy; 0 1 2)\n") && text.contains("naive        0  overreach   by float\n"),
        "{text}"
    );
    assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    assert!(text.contains("vertex        0  (0.5, 0.5000000000000001)"), "{text}");
    let json = expect(100, &[&args[..], &["json"]].concat()).stdout;
    let row: serde_json::Value = serde_json::from_str(json.trim()).unwrap();
    assert_eq!(row["answers"]["naive"]["class"], "overreach");
    assert_eq!(row["exact_value"], "3/2251799813685248");
    expect(0, &["ask", "orient2d", "-1,0", "0,-0.5", "1,0", "-b", "exact"]);
}

#[test]
fn points_come_from_stdin_and_files() {
    let folder = tempdir().unwrap();
    let csv: String = (0..30).map(|k| format!("{},{}\n", k * k % 17, k % 5)).collect();
    let file = write(&folder, "points.csv", &csv);
    let by_file = expect(0, &["ask", "orient2d", "--points", &file, "-b", "exact,sos", "--format", "csv"]).stdout;
    assert_eq!(by_file.lines().count(), 1 + 10);
    let mut child = tool(&["ask", "orient2d", "--points", "-", "-b", "exact,sos", "--format", "csv"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(csv.as_bytes()).unwrap();
    let by_stdin = told(child.wait_with_output().unwrap());
    assert_eq!((by_stdin.code, by_stdin.stdout), (0, by_file));
    let all = expect(0, &["ask", "compare", "1,0", "2,0", "3,0", "--queries", "all", "-b", "exact", "--format", "csv"]);
    assert_eq!(column(&all.stdout, "args"), ["0 1", "0 2", "1 2"]);
    let some = expect(0, &["ask", "compare", "1,0", "2,0", "--queries", "1,0 0,1", "-b", "exact", "--format", "csv"]);
    assert_eq!(column(&some.stdout, "exact"), ["+", "-"]);
}

#[test]
fn a_backend_that_breaks_is_not_a_success() {
    let asked = expect(100, &["ask", "orient2d", "0,0", "1,0", "0,1", "-b", "exact,fault:panics"]);
    assert!(asked.stderr.contains("1 backends gave no answer and did not decline"), "{}", asked.stderr);
    // Declining is not a failure.
    expect(0, &["ask", "incircle", "0x1p1000,0", "1,0", "0,1", "0,0", "-b", "exact,tolerance"]);
}

#[test]
fn what_cannot_be_asked_is_said_in_a_line() {
    for (args, said) in [
        (&["orient2d"][..], "no points; write some, or name a file with --points"),
        (
            &["orient2d", "0.1000000000000000001,0", "1,0", "0,1"],
            "point 0: decimal 0.1000000000000000001 has digits that no double holds; add --round",
        ),
        (&["orient2d", "0,0", "1,0", "x,1"], "point 2: `x` is not a number"),
        (&["orient2d", "0,0", "1,0", "1"], "point 2: 1 coordinates in `1`; write two or three"),
        (
            &["compare", "0,0", "1,0", "--queries", "a"],
            "--queries: `a` is not a query; write `tuples`, `all`, `random:N` or ids",
        ),
        (
            &["compare", "0,0", "1,0", "--queries", "random:a"],
            "--queries: `random:a` is not valid; write random:N or random:N:SEED",
        ),
    ] {
        let refused = expect(2, &[&["ask"], args].concat());
        assert!(refused.stderr.contains(said), "{}", refused.stderr);
    }
    for (args, said) in [
        (&["orient2d", "0,0", "1,0"][..], "predicament: 2 points are too few: orient2d takes 3; add points"),
        (&["orient3d", "0,0,0", "1,0,0", "0,1,0", "0,0,1", "--axis", "x"], "--axis is for compare, not for orient3d"),
        (&["incircle", "0,0,0", "1,0,0", "0,1,0", "0,0,1"], "incircle takes points of 2, not of 3 coordinates"),
    ] {
        let refused = expect(2, &[&["ask"], args].concat());
        assert!(refused.stderr.contains(said), "{}", refused.stderr);
        assert!(!refused.stderr.contains("ask:"), "{}", refused.stderr);
    }
    let declined = expect(0, &["ask", "orient2d", "0,0", "1,0", "0,0x1.0000000000001p-1", "-b", "exact,tolerance:f32"]);
    assert!(declined.stderr.contains("tolerance:f32: declined: "), "{}", declined.stderr);
    assert!(expect(0, &["ask", "orient2d", "--round", "0.1,0", "1,0", "0,1", "-b", "exact"]).stdout.contains("  +  "));
}

/// A message about points of a file names the file, because the scene itself is in no file.
#[test]
fn what_is_wrong_with_points_of_a_file_names_the_file() {
    let folder = tempdir().unwrap();
    let file = write(&folder, "odd.csv", "0,0\n1,0\n");
    let out = at(&folder, "out");
    for args in [
        &["ask", "orient2d", "--points", &file][..],
        &["ask", "orient2d", "--points", &file, "--queries", "0,1,2"],
        &["ask", "orient3d", "--points", &file],
        &["solve", "orient2d", &file, "--out", &out],
        &["solve", "delaunay2d", &file, "--set", "constraints=[[0, 2]]", "--out", &out],
    ] {
        let refused = expect(2, args);
        assert_eq!(refused.stderr.lines().count(), 1, "{args:?}: {}", refused.stderr);
        assert!(refused.stderr.contains(&format!("with {file}: ")), "{args:?}: {}", refused.stderr);
    }
    let mut child = tool(&["ask", "orient2d", "--points", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(b"0,0\n1,0\n").unwrap();
    let refused = told(child.wait_with_output().unwrap());
    assert_eq!(refused.code, 2, "{}", refused.stderr);
    assert!(refused.stderr.starts_with("predicament: with stdin: 2 points are too few"), "{}", refused.stderr);
}

#[test]
fn a_new_suite_runs_as_it_is() {
    let folder = tempdir().unwrap();
    let unknown = expect(2, &["corpus", "new", &at(&folder, "x.toml"), "--task", "orient5d"]).stderr;
    assert_eq!(unknown.lines().count(), 1, "{unknown}");
    let tasks = unknown.trim().split_once("use one of ").expect("their names").1.split(", ");
    let tasks: Vec<&str> = tasks.collect();
    assert!(tasks.len() >= 11 && tasks.contains(&"insphere") && tasks.contains(&"contacts3d"), "{unknown}");
    for task in tasks {
        let file = at(&folder, &format!("{task}.toml"));
        let told = expect(0, &["corpus", "new", &file, "--task", task]);
        assert!(told.stdout.contains(&format!("run {file} -b exact,sos,naive --answers")), "{}", told.stdout);
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(!text.contains("{t") && !text.contains("{data}") && !text.contains("@"), "{text}");
        let out = at(&folder, task);
        let ran = expect(0, &["run", &file, "-b", "exact,sos", "--out", &out]);
        assert!(ran.stdout.contains(" rows: 2 ok, 0 expected, 0 unexpected"), "{task}: {}", ran.stdout);
        assert_eq!(column(&read(&out, "summary.csv"), "task"), [task, task]);
        // The generator in the comments works too.
        let made: Vec<&str> = text.lines().skip_while(|line| *line != "# [[generate]]").collect();
        let made: Vec<&str> = made.iter().map_while(|line| line.strip_prefix("# ")).collect();
        let generated = write(&folder, &format!("{task}-made.toml"), &format!("title = \"t\"\n{}\n", made.join("\n")));
        assert!(made.len() >= 5 && run(&["corpus", "verify", &generated]).code == 0, "{task}: {made:?}");
        assert!(expect(2, &["corpus", "new", &file]).stderr.contains("the file is there"));
    }
    write(&folder, "land.geojson", r#"{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}"#);
    write(&folder, "cubes.csv", "0,0,0,1\n");
    write(&folder, "line.wkt", "LINESTRING (0 0, 1 1, 2 0)");
    write(&folder, "ends.csv", "0,0\n1,0\n2,0\n1,0\n");
    write(&folder, "mesh.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
    write(&folder, "closed.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    for (task, data) in [
        ("polygon-locate", "land.geojson"),
        ("cube-union", "cubes.csv"),
        ("crossings", "line.wkt"),
        ("contacts2d", "land.geojson"),
        ("contacts3d", "mesh.off"),
        ("interval", "ends.csv"),
        ("triangulate", "land.geojson"),
        ("hull3d", "mesh.off"),
        ("slice", "closed.off"),
        ("overlay2d", "land.geojson"),
    ] {
        let file = at(&folder, &format!("{task}-of-file.toml"));
        expect(0, &["corpus", "new", &file, "--task", task, "--points", data]);
        expect(0, &["corpus", "verify", &file]);
    }
    write(&folder, "points.csv", "0,0\n1,0\n0,1\n");
    let file = at(&folder, "mine.toml");
    expect(0, &["corpus", "new", &file, "--points", "points.csv"]);
    expect(0, &["run", &file, "-b", "exact", "--out", &at(&folder, "run")]);
    assert!(expect(2, &["corpus", "new", &at(&folder, "mine.txt")]).stderr.contains("a suite's name ends with .toml"));
}

#[test]
fn every_answer_of_a_run_is_written_where_it_was_asked_for() {
    let folder = tempdir().unwrap();
    let [plain, full, apart] = ["plain", "full", "apart"].map(|name| at(&folder, name));
    let filter = "kettner-a1$|three-cells|tilings/bricks$|cubes/twins";
    // Contradictions between answers would change their class in the summary.
    let scenes = ["run", "-f", filter, "--permutations", "0", "-b", "exact,sos,naive", "--out"];
    run(&[&scenes[..], &[&plain]].concat());
    let told = run(&[&scenes[..], &[&full, "--answers"]].concat());
    assert!(told.stderr.contains("answers.csv has no lines for 1 scenes of cube-union"), "{}", told.stderr);
    run(&[&scenes[..], &[&apart, "--answers", "--isolate"]].concat());
    assert!(!folder.path().join("plain/answers.csv").exists());
    let answers = read(&full, "answers.csv");
    assert_eq!(answers, read(&apart, "answers.csv"), "in a process of its own");
    assert_eq!(read(&plain, "summary.csv"), read(&full, "summary.csv"), "to write them changes no row");
    // There are as many answers as queries, and as many of each class as the summary counts.
    let summary = read(&full, "summary.csv");
    let of_signs = |csv: &str| {
        let head = csv.lines().next().unwrap().to_owned();
        let rows = csv.lines().skip(1).filter(|row| !row.contains("cube-union"));
        std::iter::once(head).chain(rows.map(str::to_owned)).collect::<Vec<_>>().join("\n")
    };
    let asked: usize = column(&of_signs(&summary), "queries").iter().map(|n| n.parse::<usize>().unwrap()).sum();
    assert_eq!(answers.lines().count() - 1, asked);
    // Answers contain commas.
    let mut rows = csv::Reader::from_reader(answers.as_bytes());
    let classes: Vec<String> = rows.records().map(|row| row.unwrap()[9].to_owned()).collect();
    let classes = |name: &str| classes.iter().filter(|class| *class == name).count();
    for class in ["agree", "tie_broken", "overreach", "sign_flip"] {
        let counted: usize = column(&of_signs(&summary), class).iter().map(|n| n.parse::<usize>().unwrap()).sum();
        assert_eq!(classes(class), counted, "{class}");
    }
    assert!(column(&answers, "stage").iter().any(|stage| stage == "float"), "{answers}");
}

/// A row has the query, the answer, the truth and the class, in the order of the queries.
#[test]
fn each_answer_is_the_answer_to_its_query() {
    let folder = tempdir().unwrap();
    let suite = "title = \"Mine\"\n[[scene]]\nname = \"turns\"\ntask = \"orient2d\"\n\
                 points = [[\"0x1.0000000000001p-1\", 0.5], [12, 12], [24, 24], [36, 36], [0, 1]]\n\
                 queries = [[0, 1, 2], [1, 2, 3], [1, 2, 4]]\n";
    let (suite, out) = (write(&folder, "mine.toml", suite), at(&folder, "run"));
    run(&["run", &suite, "-b", "exact,sos,naive", "--answers", "--out", &out]);
    let answers = read(&out, "answers.csv");
    let columns = ["backend", "query", "args", "answer", "exact", "class"].map(|name| column(&answers, name));
    let rows: Vec<String> =
        (0..columns[0].len()).map(|row| columns.each_ref().map(|cells| cells[row].as_str()).join(",")).collect();
    let broken = rows[4].replace("sos,1,1 2 3,+,", "sos,1,1 2 3,-,");
    let expected = [
        "exact,0,0 1 2,-,-,agree",
        "exact,1,1 2 3,0,0,agree",
        "exact,2,1 2 4,+,+,agree",
        "sos,0,0 1 2,-,-,agree",
        // The judge decides the side of the broken tie.
        rows[4].as_str(),
        "sos,2,1 2 4,+,+,agree",
        "naive,0,0 1 2,0,-,overreach",
        "naive,1,1 2 3,0,0,agree",
        "naive,2,1 2 4,+,+,agree",
    ];
    assert_eq!(
        (rows.as_slice(), broken.as_str()),
        (expected.map(str::to_owned).as_slice(), "sos,1,1 2 3,-,0,tie_broken")
    );
}

#[test]
fn a_suite_by_path_can_be_drawn_and_a_changed_one_is_named() {
    let folder = tempdir().unwrap();
    let pixels = "title = \"Mine\"\n[[generate]]\nfamily = \"pixel-map\"\nname = \"neighbours\"\ntask = \"orient2d\"\n\
                  p = [0.5, 0.5]\nq = [12, 12]\nr = [24, 24]\nside = 8\n";
    let suite = write(&folder, "mine.toml", pixels);
    let png = at(&folder, "map.png");
    expect(0, &["draw", "map", "neighbours", "--suite", &suite, "-b", "naive,exact", "--out", &png]);
    assert!(std::fs::read(&png).unwrap().starts_with(b"\x89PNG"));

    let suite = write(&folder, "mine.toml", SUITE);
    let out = at(&folder, "run");
    run(&["run", &suite, "-b", "naive", "--out", &out]);
    let id = column(&read(&out, "findings.csv"), "finding_id")[0].clone();
    assert!(expect(0, &["replay", &id, "--run", &out]).stdout.contains("naive"));
    assert!(read(&out, "plan.json").contains("\"hashes\""));
    write(&folder, "mine.toml", &SUITE.replace("\"0x1.0000000000001p-1\"", "0.5"));
    let refused = expect(2, &["replay", &id, "--run", &out]);
    assert!(refused.stderr.contains(&format!("as has {suite}; run it again")), "{}", refused.stderr);
}

#[test]
fn a_finding_about_a_whole_scene_is_replayed() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let out = at(&folder, "run");
    let crashes = ["run", &suite, "-f", "plain", "-b", "fault:aborts", "--isolate", "--out", &out];
    expect(100, &crashes);
    let id = column(&read(&out, "findings.csv"), "finding_id")[0].clone();
    let told = expect(0, &["replay", &id, "--run", &out, "-b", "exact"]);
    for said in ["fault:aborts             1 panic", "crashed: abort (signal 6)", "exact                    1 agree"] {
        assert!(told.stdout.contains(said), "{}", told.stdout);
    }
    assert!(told.stdout.ends_with("The finding is there again.\n"), "{}", told.stdout);
}
