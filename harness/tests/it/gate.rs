//! `gate`: unexpected findings, unexpected passes, planted faults, and comparison with a baseline.

use tempfile::tempdir;

use crate::common::{SUITE, at, column, expect, read, rewrite, run, unsealed, write};

#[test]
fn expectations_turn_the_gate_both_ways() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let out = at(&folder, "run");
    let empty = write(&folder, "empty.toml", "");
    let found = expect(100, &["run", &suite, "--expected", &empty, "-b", "naive,exact", "--out", &out]);
    assert!(found.stdout.contains("unexpected: mine/wrong-once on naive: 1 overreach"), "{}", found.stdout);

    let expectation = |class: &str, scene: &str| {
        let text = format!(
            "[[expect]]\nscene = \"{scene}\"\nbackend = \"naive\"\nclass = \"{class}\"\nreason = \"rounding\"\n"
        );
        write(&folder, &format!("{class}-{}.toml", scene.len()), &text)
    };
    expect(100, &["gate", &out, "--expected", &empty]);
    expect(0, &["gate", &out, "--expected", &expectation("overreach", "wrong-*")]);
    expect(100, &["gate", &out, "--expected", &expectation("sign_flip", "wrong-*")]);
    expect(101, &["gate", &out, "--expected", &expectation("overreach", "*")]);

    // `run` reports the same.
    let known = expectation("overreach", "*");
    let passed = ["run", &suite, "--expected", &known, "-b", "naive", "--out", &at(&folder, "passed")];
    let told = expect(101, &passed);
    assert!(told.stdout.contains("unexpected_pass: mine/plain on naive"), "{}", told.stdout);

    // Suggestions are TOML, which is refused until the reasons are filled in.
    let suggested = at(&folder, "suggested.toml");
    expect(100, &["gate", &out, "--expected", &empty, "--suggest", &suggested]);
    let refused = expect(104, &["gate", &out, "--expected", &suggested]);
    assert!(refused.stderr.contains("suggested.toml:8: the reason is empty; say why"), "{}", refused.stderr);
    let text = std::fs::read_to_string(&suggested).unwrap();
    assert!(text.contains("level = \"quick\""), "{text}");
    let filled = write(&folder, "filled.toml", &text.replace("reason = \"\"", "reason = \"rounding\""));
    expect(0, &["gate", &out, "--expected", &filled]);
    let there = expect(2, &["gate", &out, "--expected", &empty, "--suggest", &suggested]);
    assert!(there.stderr.contains("the file is there"), "{}", there.stderr);
    let printed = expect(100, &["gate", &out, "--expected", &empty, "--suggest"]).stdout;
    assert!(printed.contains(&text), "{printed}");
}

#[test]
fn an_expectation_that_nothing_can_meet_is_red_and_one_that_was_left_out_is_listed() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let out = at(&folder, "run");
    let empty = write(&folder, "empty.toml", "");
    expect(100, &["run", &suite, "--expected", &empty, "-b", "naive,exact", "--out", &out]);
    let gate = |code: i32, more: &str| {
        let text = format!(
            "[[expect]]\nscene = \"wrong-*\"\nbackend = \"naive\"\nclass = \"overreach\"\nreason = \"rounding\"\n{more}"
        );
        expect(code, &["gate", &out, "--expected", &write(&folder, "more.toml", &text)]).stdout
    };
    let more = |scene: &str, backend: &str, level: &str| {
        format!("[[expect]]\nscene = \"{scene}\"\nbackend = \"{backend}\"\nclass = \"nan\"\nreason = \"no\"\n{level}")
    };
    gate(0, "");
    let told = gate(101, &more("mine/rong-*", "naive", ""));
    assert!(told.contains("more.toml:6: no scene is called `mine/rong-*`; correct or drop it"), "{told}");
    assert!(told.contains(" 1 never true, "), "{told}");
    let told = gate(101, &more("plain", "nave", ""));
    assert!(told.contains("never true: ") && told.contains("no backend is called `nave`"), "{told}");
    // Expectations outside the selected scenes, backends and level; an engine and a suite may be elsewhere.
    let left_out = [
        more("plain", "engine:no-such-engine", ""),
        more("theirs/plain", "naive", ""),
        more("families/near-*", "naive", ""),
        more("plain", "shewchuk", ""),
        more("plain", "naive", "level = \"full\""),
    ];
    let told = gate(0, &left_out.concat());
    assert!(told.contains("5 expectations do not apply to this run's scenes, backends and level"), "{told}");
    let level = expect(
        104,
        &["gate", &out, "--expected", &write(&folder, "class.toml", &more("plain", "naive", "").replace("nan", "nam"))],
    );
    assert!(level.stderr.contains("class.toml:4: no class is called `nam`; "), "{}", level.stderr);
}

#[test]
fn a_baseline_without_a_scene_in_common_is_an_error() {
    let folder = tempdir().unwrap();
    let (one, other) = (at(&folder, "one"), at(&folder, "other"));
    run(&["run", "classics", "-f", "kettner-a1$", "-b", "exact", "--out", &one]);
    run(&["run", "classics", "-f", "kettner-b1$", "-b", "exact", "--out", &other]);
    expect(0, &["gate", &one, "--baseline", &one]);
    let told = expect(2, &["gate", &one, "--baseline", &other]);
    assert!(told.stderr.contains("the baseline has no scene of this run"), "{}", told.stderr);
}

#[test]
fn planted_faults_turn_the_gate_red_and_honest_backends_leave_it_green() {
    let folder = tempdir().unwrap();
    // Faults, with the scenes that show them. All faults of a group run on all scenes of the group.
    let groups: [&[(&str, &str)]; 4] = [
        &[
            ("sos-swapped-term", "ties/grid"),
            ("sos-batch-flipped", "grid-4x4-orient2d"),
            ("sos-late-swapped-term", "kettner-pixels-a"),
            ("sos-dropped-parity", "kettner-pixels-a"),
            ("sos-place-as-identity", "kettner-pixels-a"),
            ("compare-greater-on-ties", "grid-compare"),
        ],
        &[
            ("exact-halved-filter", "filters"),
            ("exact-one-limb", "near-insphere"),
            ("exact-unguarded", "wide-scaled-orient3d"),
            ("exact-flushed", "wide-scaled-orient2d"),
        ],
        &[("tolerance-narrow", "bands"), ("tolerance-wide", "bands")],
        &[("contacts-endless-edge", "contacts/polygons-degen"), ("contacts-one-sided", "contacts/polygons-uniform")],
    ];
    for (at_group, faults) in groups.iter().enumerate() {
        let faulty = at(&folder, &format!("faulty{at_group}"));
        let scenes: Vec<&str> = faults.iter().map(|(_, scenes)| *scenes).collect();
        let names: Vec<String> = faults.iter().map(|(fault, _)| format!("fault:{fault}")).collect();
        run(&["run", "-f", &scenes.join("|"), "-b", &names.join(","), "--out", &faulty]);
        expect(100, &["gate", &faulty]);
        let summary = read(&faulty, "summary.csv");
        let [suites, scenes_run, backends, statuses] =
            ["suite", "scene", "backend", "status"].map(|name| column(&summary, name));
        for ((_, scenes), name) in faults.iter().zip(&names) {
            let caught = (0..statuses.len()).any(|row| {
                backends[row] == *name
                    && statuses[row] == "unexpected"
                    && format!("{}/{}", suites[row], scenes_run[row]).contains(scenes)
            });
            assert!(caught, "{name} on {scenes}: {summary}");
        }
    }
    let (scenes, honest) =
        (groups.concat().iter().map(|(_, scenes)| *scenes).collect::<Vec<_>>(), at(&folder, "honest"));
    run(&["run", "-f", &scenes.join("|"), "-b", "exact,sos,tolerance", "--out", &honest]);
    expect(0, &["gate", &honest]);
}

#[test]
fn a_baseline_catches_what_expectations_forgive() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let (good, bad) = (at(&folder, "good"), at(&folder, "bad"));
    let forgiving = "[[expect]]\nscene = \"wrong-once\"\nbackend = \"naive\"\nclass = \"overreach\"\nreason = \"r\"\n";
    let forgiving = write(&folder, "forgiving.toml", forgiving);
    expect(0, &["run", &suite, "--expected", &forgiving, "-b", "naive", "--out", &bad]);
    expect(0, &["run", &suite, "--expected", &forgiving, "-b", "naive", "--out", &good]);
    // Change the baseline so that its one overreach agrees.
    let summary =
        read(&good, "summary.csv").replace(",1,0,0,0,1,0,0,0,0,0,0,0,0,0,0,", ",1,1,0,0,0,0,0,0,0,0,0,0,0,0,0,");
    assert_ne!(summary, read(&good, "summary.csv"), "the row was found");
    rewrite(&at(&folder, "good"), "summary.csv", &summary);
    expect(0, &["gate", &bad, "--expected", &forgiving, "--baseline", &bad]);
    let worse = expect(100, &["gate", &bad, "--expected", &forgiving, "--baseline", &good]);
    assert!(worse.stdout.contains("worse than the baseline: mine/wrong-once on naive: 1 overreach, was 0"));
}

#[test]
fn a_baseline_catches_what_has_become_slower() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let [slow, fast] = ["slow", "fast"].map(|name| at(&folder, name));
    // The times are made up.
    for (out, nanoseconds) in [(&slow, "1.2"), (&fast, "1.0")] {
        expect(0, &["bench", &suite, "-b", "exact", "--samples", "1", "--out", out]);
        let times = read(out, "throughput.csv");
        let made_up = times.lines().skip(1).map(|row| format!("{},{nanoseconds}\n", row.rsplit_once(',').unwrap().0));
        let made_up: String = std::iter::once(times.lines().next().unwrap().to_owned() + "\n").chain(made_up).collect();
        assert!(made_up.lines().count() > 1 && times.lines().next().unwrap().ends_with("ns_per_query"), "{times}");
        rewrite(out, "throughput.csv", &made_up);
    }
    let told = expect(102, &["gate", &slow, "--baseline", &fast, "--time"]);
    assert!(told.stdout.contains("on exact (single): 1.20 ns/query, was 1.00 (1.20 times)"), "{}", told.stdout);
    expect(0, &["gate", &fast, "--baseline", &slow, "--time"]);
    expect(0, &["gate", &slow, "--baseline", &slow, "--time"]);
    // A time within the threshold is no error, and without --time no time is.
    expect(0, &["gate", &slow, "--baseline", &fast, "--time", "25"]);
    let told = expect(0, &["gate", &slow, "--baseline", &fast]).stdout;
    assert!(told.contains("times were not judged: not requested: add `--time`"), "{told}");
    expect(2, &["gate", &slow, "--time"]);
    expect(2, &["gate", &slow, "--baseline", &fast, "--time", "-3"]);
    // Times of another machine are no error.
    let env = unsealed(&fast, "env.json");
    let other = env.replace(&format!("\"os\": \"{} ", std::env::consts::OS), "\"os\": \"other ");
    assert_ne!(env, other);
    std::fs::write(std::path::Path::new(&fast).join("env.json"), &other).unwrap();
    let told = expect(0, &["gate", &slow, "--baseline", &fast, "--time"]).stdout;
    assert!(
        told.contains("times were not judged: the machine or the build differs") && told.contains("system: `"),
        "{told}"
    );
}
