//! Power cuts: the state of a run's folder on the disk after a power cut, and whether the run can be resumed from it.
//!
//! A killed process loses nothing that the kernel has; a power cut loses everything that was not synced. `strace`
//! records what a run does to its folder. For one moment of the record, folders are made from everything that was
//! certainly synced and from more or less of the rest. Each folder is resumed, and the result has to be byte-identical
//! to an undisturbed run. (This is the method of ALICE: Pillai et al., All File Systems Are Not Created Equal, OSDI
//! 2014.)

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use predicament_corpus::Random;

use super::driver::{PARTS, Shape, differing, files, with_out, words_of};
use super::syscalls::can_trace;
use crate::common::told;

/// The effect of a system call. Files are numbered, because their names change later.
#[derive(Clone, Debug)]
enum Event {
    Folder(PathBuf),
    New(PathBuf, usize),
    Rename(PathBuf, PathBuf),
    Remove(PathBuf),
    Append(usize, Vec<u8>),
    Cut(usize, usize),
    Sync(usize),
    SyncFolder(PathBuf),
}

/// The part of the unsynced changes that reaches the disk.
#[derive(Clone, Copy, Debug)]
enum Rest {
    Nothing,
    /// All names and no bytes, so files are shorter than they were.
    Names,
    All,
    /// The first of the names, and a part of the bytes of each file.
    Some,
}

/// The changes that a run makes to its folder.
fn events(words: &[String], out: &Path) -> Vec<Event> {
    const CALLS: &str =
        "openat,write,ftruncate,rename,renameat,renameat2,unlink,unlinkat,mkdir,mkdirat,fsync,fdatasync,fcntl,close";
    let log = tempfile::NamedTempFile::new().unwrap();
    let tool = words_of(words);
    let mut command = Command::new("strace");
    command.args(["-f", "-q", "-xx", "-s", "100000000", "-e", &format!("trace={CALLS}"), "-o"]).arg(log.path());
    command.arg(tool.get_program()).args(tool.get_args()).env_remove("PREDICAMENT_CACHE").stdin(Stdio::null());
    let ended = command.output().unwrap();
    let code = ended.status.code();
    assert!(code == Some(0) || code == Some(100), "{words:?}: {code:?}: {}", String::from_utf8_lossy(&ended.stderr));
    let text = std::fs::read_to_string(log.path()).unwrap();
    // Open files and folders, by descriptor.
    let (mut open, mut folders) = (BTreeMap::new(), BTreeMap::new());
    let (mut numbers, mut events) = (BTreeMap::new(), Vec::new());
    for line in whole_lines(&text) {
        let Some((call, rest)) = line.split_once('(') else { continue };
        let Some((arguments, result)) = rest.rsplit_once(" = ") else { continue };
        let arguments = arguments.trim_end().trim_end_matches(')');
        let Ok(result) = result.split_whitespace().next().unwrap_or_default().parse::<i64>() else { continue };
        if result < 0 {
            continue;
        }
        let texts = texts(arguments);
        let paths: Vec<PathBuf> =
            texts.iter().map(|text| PathBuf::from(String::from_utf8_lossy(text).into_owned())).collect();
        let descriptor =
            || arguments.split(',').next().and_then(|first| first.trim().parse::<i64>().ok()).unwrap_or(-1);
        match call {
            "openat" if paths[0].starts_with(out) => {
                let path = paths[0].clone();
                if arguments.contains("O_CREAT") || numbers.contains_key(&path) {
                    let next = numbers.len() + events.len();
                    let is_new = !numbers.contains_key(&path);
                    let number = *numbers.entry(path.clone()).or_insert(next);
                    if is_new {
                        events.push(Event::New(path, number));
                    } else if arguments.contains("O_TRUNC") {
                        events.push(Event::Cut(number, 0));
                    }
                    open.insert(result, number);
                } else {
                    folders.insert(result, path);
                }
            }
            "fcntl" if arguments.contains("F_DUPFD") => {
                let same = open.get(&descriptor()).copied();
                open.extend(same.map(|number| (result, number)));
            }
            "close" => {
                open.remove(&descriptor());
                folders.remove(&descriptor());
            }
            "write" => {
                let Some(&number) = open.get(&descriptor()) else { continue };
                events.push(Event::Append(number, texts[0][..usize::try_from(result).unwrap()].to_vec()));
            }
            "ftruncate" => {
                let Some(&number) = open.get(&descriptor()) else { continue };
                let length = arguments.rsplit(',').next().and_then(|length| length.trim().parse().ok()).unwrap();
                events.push(Event::Cut(number, length));
            }
            "fsync" | "fdatasync" => {
                events.extend(open.get(&descriptor()).map(|&number| Event::Sync(number)));
                events.extend(folders.get(&descriptor()).map(|folder| Event::SyncFolder(folder.clone())));
            }
            "rename" | "renameat" | "renameat2" if paths[0].starts_with(out) => {
                renamed(&mut numbers, &paths[0], &paths[1]);
                events.push(Event::Rename(paths[0].clone(), paths[1].clone()));
            }
            "unlink" | "unlinkat" if paths[0].starts_with(out) => {
                numbers.remove(&paths[0]);
                events.push(Event::Remove(paths[0].clone()));
            }
            "mkdir" | "mkdirat" if paths[0].starts_with(out) => events.push(Event::Folder(paths[0].clone())),
            _ => {}
        }
    }
    events
}

/// Renames a file, or all files of a folder.
fn renamed(places: &mut BTreeMap<PathBuf, usize>, from: &Path, to: &Path) {
    let below = |path: &Path| match path.strip_prefix(from).ok()? {
        rest if rest.as_os_str().is_empty() => Some(to.to_owned()),
        rest => Some(to.join(rest)),
    };
    places.remove(to);
    *places = std::mem::take(places).into_iter().map(|(path, number)| (below(&path).unwrap_or(path), number)).collect();
}

/// The calls of a log, with calls that another thread interrupted joined again.
fn whole_lines(log: &str) -> Vec<String> {
    let (mut begun, mut lines) = (BTreeMap::new(), Vec::new());
    for line in log.lines() {
        let (process, call) = line.split_once(' ').unwrap_or((line, ""));
        let call = call.trim_start();
        if let Some(first) = call.strip_suffix(" <unfinished ...>") {
            begun.insert(process.to_owned(), first.to_owned());
        } else if let Some((_, second)) = call.strip_prefix("<... ").and_then(|rest| rest.split_once(" resumed>")) {
            lines.push(begun.remove(process).unwrap_or_default() + second);
        } else {
            lines.push(call.to_owned());
        }
    }
    lines
}

/// The quoted texts among the arguments of a call.
fn texts(arguments: &str) -> Vec<Vec<u8>> {
    let (mut texts, mut rest) = (Vec::new(), arguments.bytes());
    while rest.any(|byte| byte == b'"') {
        let mut text = Vec::new();
        loop {
            match rest.next().expect("the text has an end") {
                b'"' => break,
                // All bytes are hex escapes.
                byte => {
                    assert_eq!([Some(byte), rest.next()], [b'\\', b'x'].map(Some));
                    text.push(16 * digit(rest.next().unwrap()) + digit(rest.next().unwrap()));
                }
            }
        }
        texts.push(text);
    }
    texts
}

/// The value of a hex digit.
fn digit(byte: u8) -> u8 {
    match byte {
        b'0'..=b'9' => byte - b'0',
        b'a'..=b'f' => byte - b'a' + 10,
        _ => panic!("{byte} is no digit"),
    }
}

/// The folders and files on the disk after these events and a power cut.
fn after_power(events: &[Event], rest: Rest, random: &mut Random) -> (Vec<PathBuf>, BTreeMap<PathBuf, Vec<u8>>) {
    let synced_to = |of: &dyn Fn(&Event) -> bool| events.iter().rposition(of).map_or(0, |at| at + 1);
    let folder_of = |path: &Path| path.parent().unwrap().to_owned();
    // Names before the last sync of their folder are certain; names reach the disk in order.
    let names: Vec<(usize, &Event)> = events
        .iter()
        .enumerate()
        .filter(|(_, event)| matches!(event, Event::Folder(_) | Event::New(..) | Event::Rename(..) | Event::Remove(_)))
        .collect();
    let is_sure = |(at, event): &(usize, &Event)| {
        let (Event::Folder(path) | Event::New(path, _) | Event::Rename(_, path) | Event::Remove(path)) = event else {
            return false;
        };
        let folder = folder_of(path);
        *at < synced_to(&|event| matches!(event, Event::SyncFolder(synced) if *synced == folder))
    };
    let sure = names.iter().rposition(is_sure).map_or(0, |at| at + 1);
    let many = |random: &mut Random, least: usize, most: usize| {
        usize::try_from(random.integer(i64::try_from(least).unwrap(), i64::try_from(most).unwrap())).unwrap()
    };
    let count = match rest {
        Rest::Nothing => sure,
        Rest::Names | Rest::All => names.len(),
        Rest::Some => many(random, sure, names.len()),
    };
    let (mut folders, mut places) = (Vec::new(), BTreeMap::new());
    for (_, event) in &names[..count] {
        match event {
            Event::Folder(path) => folders.push(path.clone()),
            Event::New(path, number) => drop(places.insert(path.clone(), *number)),
            Event::Rename(from, to) => renamed(&mut places, from, to),
            Event::Remove(path) => drop(places.remove(path)),
            _ => {}
        }
    }
    let bytes = |number: usize, random: &mut Random| {
        let own = |event: &&Event| matches!(event, Event::Append(of, _) | Event::Cut(of, _) if *of == number);
        let content = |events: &[Event]| {
            let mut bytes = Vec::new();
            for event in events.iter().filter(own) {
                match event {
                    Event::Append(_, more) => bytes.extend(more),
                    Event::Cut(_, length) => bytes.truncate(*length),
                    _ => {}
                }
            }
            bytes
        };
        let synced = content(&events[..synced_to(&|event| matches!(event, Event::Sync(of) if *of == number))]);
        let all = content(events);
        match rest {
            Rest::Nothing | Rest::Names => synced,
            Rest::All => all,
            Rest::Some if all.starts_with(&synced) => all[..many(random, synced.len(), all.len())].to_vec(),
            Rest::Some => all,
        }
    };
    let places = places.into_iter().map(|(path, number)| (path, bytes(number, random))).collect();
    (folders, places)
}

/// The output of a successful command is on the disk, with its name.
#[test]
fn what_was_said_to_be_written_is_on_the_disk() {
    if !can_trace() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    let at = |name: &str| folder.join(name).display().to_string();
    for k in 1..=PARTS {
        let words = with_out(Shape::Part(k).words(), Path::new(&at(&format!("part{k}"))));
        assert!([0, 100].contains(&told(words_of(&words).output().unwrap()).code));
    }
    let (merged, new) = (at("merged"), at("new"));
    for (words, is_last) in [
        (vec!["shard", "merge", "--out", "OUT/merged", "PARTS"], false),
        (vec!["shard", "plan", "ties", "-b", "exact", "--shards", "2", "--out", "OUT/plan.json"], false),
        (vec!["gate", "MERGED", "--junit", "OUT/junit.xml", "--suggest", "OUT/more.toml"], false),
        (vec!["report", "MERGED", "--out", "OUT/pages"], false),
        (vec!["data", "export", "MERGED", "--out", "OUT/deep/tables"], false),
        (vec!["corpus", "expect", "update", "MERGED", "--expected", "OUT/expected.toml", "--reason", "seen"], true),
    ] {
        std::fs::create_dir(&new).unwrap();
        if is_last {
            std::fs::write(folder.join("new/expected.toml"), "# nothing yet\n").unwrap();
        }
        let mut call: Vec<String> = Vec::new();
        for word in &words {
            match *word {
                "PARTS" => call.extend((1..=PARTS).map(|k| at(&format!("part{k}")))),
                word => call.push(word.replace("MERGED", &merged).replace("OUT", &new)),
            }
        }
        let events = events(&call, Path::new(&new));
        let (_, mut kept) = after_power(&events, Rest::Nothing, &mut Random::new("kills", "said", 0));
        let is_lock = |path: &Path| path.extension().is_some_and(|ending| ending == "lock");
        kept.retain(|path, _| !is_lock(path));
        let there = files(Path::new(&new));
        for (name, bytes) in there.iter().filter(|(name, _)| !is_lock(Path::new(name))) {
            assert!(kept.get(&Path::new(&new).join(name)) == Some(bytes), "{words:?}: {name} is not on the disk");
        }
        assert!(!kept.is_empty(), "{words:?}");
        if words[1] == "merge" {
            std::fs::rename(folder.join("new/merged"), &merged).unwrap();
        }
        std::fs::remove_dir_all(&new).unwrap();
    }
}

#[test]
fn what_a_power_cut_leaves_is_gone_on_with() {
    if !can_trace() {
        return;
    }
    let (bench, seed) = (tempfile::tempdir().unwrap(), super::random::seed());
    let out = bench.path().canonicalize().unwrap().join("run");
    let words = with_out(Shape::Plain.words(), &out);
    let words: Vec<String> = words.into_iter().chain(["--threads".to_owned(), "1".to_owned()]).collect();
    let events = events(&words, &out);
    let whole = files(&out);
    let mut random = Random::new("kills", "power", seed);
    let all = i64::try_from(events.len()).unwrap();
    let tries = if predicament_effort::whole() { 50 } else { 2 };
    let cuts: Vec<i64> = (0..tries).map(|_| random.integer(0, all)).collect();
    let (mut begun, mut resumed) = (0, 0);
    for (case, cut) in cuts.iter().enumerate() {
        let so_far = &events[..usize::try_from(*cut).unwrap()];
        for rest in [Rest::Nothing, Rest::Names, Rest::All, Rest::Some] {
            let about =
                format!("seed {seed}, case {case}: {rest:?} of what was not synced after {cut} of {all} events");
            let _ = std::fs::remove_dir_all(&out);
            let (folders, places) = after_power(so_far, rest, &mut random);
            folders.iter().for_each(|folder| std::fs::create_dir_all(folder).unwrap());
            for (path, bytes) in &places {
                std::fs::write(path, bytes).unwrap();
            }
            let is_begun = out.join("plan.json").exists();
            let call = if is_begun {
                ["run", "--quiet", "--resume", &out.display().to_string()].map(str::to_owned).into()
            } else {
                words.clone()
            };
            let told = told(words_of(&call).output().unwrap());
            let is_complete = told.stderr.contains("nothing to resume");
            assert!([0, 100].contains(&told.code) || is_complete, "{about}: {}: {}", told.code, told.stderr);
            let differ = differing(&files(&out), &whole);
            assert!(differ.is_empty(), "{about}: these files differ: {differ:?}");
            if is_begun { resumed += 1 } else { begun += 1 }
        }
    }
    println!("{} states: {resumed} gone on with, {begun} cleanly unbegun, of {all} events", 4 * cuts.len());
}
