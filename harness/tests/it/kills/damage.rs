//! Files of a run folder that are truncated, extended by garbage, or have a flipped bit.

use std::path::Path;
use std::time::Duration;

use predicament_corpus::Random;

use super::driver::{Bench, Files, OF_THE_MACHINE, Shape, differing, files, left, signal, start, with_out};
use crate::common::{Told, run};

/// The damage to a file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Damage {
    Cut,
    Grown,
    Flipped,
    Gone,
}

/// The number of damages tried: three times all files with each damage, or a few.
fn tries(pairs: usize) -> usize {
    if predicament_effort::whole() { 3 * pairs } else { 3 }
}

const DAMAGES: [Damage; 4] = [Damage::Cut, Damage::Grown, Damage::Flipped, Damage::Gone];

/// The bytes of a file after the damage, or `Some(None)` if the file is gone; `None` if it can't be damaged in this
/// way.
fn damaged(bytes: &[u8], damage: Damage, random: &mut Random) -> Option<Option<Vec<u8>>> {
    let mut below = |n: usize| usize::try_from(random.integer(0, i64::try_from(n).unwrap() - 1)).unwrap();
    Some(match damage {
        Damage::Gone => None,
        Damage::Grown => {
            let garbage: Vec<u8> = (0..=below(40)).map(|_| u8::try_from(below(256)).unwrap()).collect();
            Some([bytes, &garbage].concat())
        }
        _ if bytes.is_empty() => return None,
        Damage::Cut => Some(bytes[..below(bytes.len())].to_vec()),
        Damage::Flipped => {
            let mut bytes = bytes.to_vec();
            let place = below(bytes.len());
            bytes[place] ^= 1 << below(8);
            Some(bytes)
        }
    })
}

/// Writes files into a folder.
fn lay(folder: &Path, files: &Files) {
    for (name, bytes) in files {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
}

/// True if a refusal names the file and a cure.
fn is_clear(told: &Told, file: &str) -> bool {
    const CURES: [&str; 4] = ["restore", "start a new run", "run --resume", "name another"];
    told.code == 2 && told.stderr.contains(file) && CURES.iter().any(|cure| told.stderr.contains(cure))
}

/// All files of a folder, including the one that depends on the machine.
fn all_files(folder: &Path) -> Files {
    let mut all = files(folder);
    all.insert(OF_THE_MACHINE.to_owned(), std::fs::read(folder.join(OF_THE_MACHINE)).unwrap());
    all
}

#[test]
#[cfg(unix)]
fn damaged_files_of_an_unfinished_run_are_refused_or_gone_on_with() {
    let (bench, seed) = (Bench::new(&[Shape::Plain]), super::random::seed());
    let out = bench.place("unfinished");
    let mut child = start(&with_out(Shape::Plain.words(), &out));
    let rows = || std::fs::read_to_string(out.join("summary.csv")).map_or(0, |text| text.lines().count());
    while rows() < 8 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_micros(200));
    }
    signal("KILL", i64::from(child.id()));
    child.wait().unwrap();
    assert_eq!(left(&out), "unfinished");
    let before = all_files(&out);
    let (mut refused, mut same) = (0, 0);
    let mut random = Random::new("kills", "damage", seed);
    let pairs: Vec<(&String, Damage)> = before.keys().flat_map(|name| DAMAGES.map(|damage| (name, damage))).collect();
    let tries = tries(pairs.len());
    for case in 0..tries {
        // All pairs in turn, or a few at random.
        let pick = if predicament_effort::whole() {
            case % pairs.len()
        } else {
            usize::try_from(random.integer(0, i64::try_from(pairs.len()).unwrap() - 1)).unwrap()
        };
        let (name, damage) = pairs[pick];
        let Some(bytes) = damaged(&before[name], damage, &mut random) else { continue };
        let out = bench.place("damaged");
        lay(&out, &before);
        match bytes {
            Some(bytes) => std::fs::write(out.join(name), bytes).unwrap(),
            None => std::fs::remove_file(out.join(name)).unwrap(),
        }
        let told = bench.run(&Shape::Plain.resume(&out.display().to_string()));
        let about = format!("case {case} of seed {seed}: {name} {damage:?}");
        if [0, 100].contains(&told.code) {
            let differ = differing(&files(&out), bench.whole(Shape::Plain));
            assert!(differ.is_empty(), "{about}: resumed, and these files differ: {differ:?}");
            same += 1;
        } else {
            assert!(is_clear(&told, name), "{about}: code {}: {}", told.code, told.stderr);
            refused += 1;
        }
        std::fs::remove_dir_all(&out).unwrap();
    }
    println!("seed {seed}: of {tries} damages {refused} refused, {same} gone on with");
    assert!(refused > 0, "nothing was refused");
}

#[test]
fn damaged_files_of_a_complete_run_are_refused() {
    let (bench, seed) = (Bench::new(&[Shape::Part(1)]), super::random::seed());
    let whole = bench.place(&format!("whole {:?}", Shape::Part(1)));
    let before = all_files(&whole);
    let mut random = Random::new("kills", "damage of a complete run", seed);
    let pairs: Vec<(&String, Damage)> = before.keys().flat_map(|name| DAMAGES.map(|damage| (name, damage))).collect();
    let gate = |out: &Path| run(&["gate", &out.display().to_string()]);
    let undisturbed = gate(&whole);
    let (mut refused, mut same) = (0, 0);
    for case in 0..tries(pairs.len()) {
        let pick = if predicament_effort::whole() {
            case % pairs.len()
        } else {
            usize::try_from(random.integer(0, i64::try_from(pairs.len()).unwrap() - 1)).unwrap()
        };
        let (name, damage) = pairs[pick];
        let Some(bytes) = damaged(&before[name], damage, &mut random) else { continue };
        let out = bench.place("damaged");
        lay(&out, &before);
        match bytes {
            Some(bytes) => std::fs::write(out.join(name), bytes).unwrap(),
            None => std::fs::remove_file(out.join(name)).unwrap(),
        }
        let told = gate(&out);
        let about = format!("case {case} of seed {seed}: {name} {damage:?}");
        if is_clear(&told, name) {
            refused += 1;
        } else {
            // Damage may go unnoticed only in files that hold no answers.
            let is_beside = [OF_THE_MACHINE, "run.lock", "state.json"].contains(&name.as_str());
            assert!(is_beside, "{about}: code {}: {}{}", told.code, told.stdout, told.stderr);
            let place = |told: &Told| told.stdout.replace("damaged", "whole Part(1)");
            assert_eq!(
                (told.code, place(&told)),
                (undisturbed.code, undisturbed.stdout.clone()),
                "{about}: {}",
                told.stderr
            );
            same += 1;
        }
        std::fs::remove_dir_all(&out).unwrap();
    }
    println!("seed {seed}: {refused} refused, {same} of no account");
    assert!(refused > 0, "nothing was refused");
}
