//! Folders that were edited or made maliciously: each is refused with a one-line error.

use predicament_records::RunDir;
use tempfile::tempdir;

use crate::once::copy;

#[test]
fn counts_that_no_run_can_have_are_refused() {
    let most = "18446744073709551615";
    for (file, from, to, said) in [
        (
            "summary.csv",
            ",exact,100000,",
            &*format!(",exact,{most},"),
            "summary.csv:2: the count 18446744073709551615 is larger",
        ),
        ("stages.csv", ",filter,61000", &format!(",filter,{most}"), "stages.csv:2: the count 18446744073709551615"),
        ("plan.json", "\"queries\": ", "\"queries\": 99999999999", "plan.json: "),
    ] {
        let folder = tempdir().unwrap();
        let error = RunDir::open(copy(&folder, "run", &[(file, from, to)])).unwrap_err().to_string();
        assert!(error.contains(said) && error.ends_with("larger than any run can reach; restore the file"), "{error}");
    }
}

#[test]
fn tables_outside_of_the_folder_are_not_read() {
    let folder = tempdir().unwrap();
    let change = ("state.json", "\"committed\": {}", "\"committed\": { \"../other.csv\": 3 }");
    let run = copy(&folder, "run", &[change]);
    std::fs::write(folder.path().join("other.csv"), "a,b\n").unwrap();
    let error = RunDir::open(run).unwrap_err().to_string();
    assert!(error.ends_with("state.json names `../other.csv`, which is not a table of the folder"), "{error}");
}

#[test]
#[cfg(unix)]
fn pipes_are_not_waited_for() {
    for name in ["extra.csv", "plan.json", "maps"] {
        let folder = tempdir().unwrap();
        let run = copy(&folder, "run", &[]);
        let place = if name == "maps" { run.join("maps/map.png") } else { run.join(name) };
        if name == "maps" {
            std::fs::create_dir(run.join("maps")).unwrap();
        }
        let _ = std::fs::remove_file(&place);
        assert!(std::process::Command::new("mkfifo").arg(&place).status().unwrap().success());
        let error = RunDir::open(run).unwrap_err();
        assert_eq!((error.path, &*error.message), (place, "it is not a regular file (a folder, a pipe or a device)"));
    }
}
