//! The mutation score of the algorithms by the quick run and the gate alone, and the coverage of their comparisons.
//!
//! A build a mutant would take hours. So one build of a copied tree has all changes of all algorithms, each behind a
//! switch ([`sites`]), and the variable `PREDICAMENT_SWITCH` turns one on. The same build notes the outcomes of each
//! comparison and condition; outcomes that no suite has are counted by cause ([`causes`]).
//!
//! A mutant that no run notices is hunted for: if a hunt finds a scene on which an answer is wrong, the quick run has
//! missed it. Otherwise no answer was seen to change: the score leaves the mutant out, and its row says how many there
//! are, and how many of them are at places that the quick run does not reach.

#![forbid(unsafe_code)]

mod causes;
mod render;
mod runs;
mod sites;
mod tree;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::process::ExitCode;

use causes::Causes;
use runs::{Notice, Suite, Tool};
use tree::System;

/// The command's arguments.
struct Asked {
    root: PathBuf,
    target: PathBuf,
    out: PathBuf,
    sample: usize,
    seed: u64,
    evaluations: u32,
    only: Option<String>,
}

impl Asked {
    fn parse() -> Result<Asked, String> {
        let mut words = std::env::args().skip(1);
        let mut folder =
            || words.next().map(PathBuf::from).ok_or("switches: name a tree, a target folder and a folder of results");
        let mut asked = Asked {
            root: folder()?,
            target: folder()?,
            out: folder()?,
            sample: 60,
            seed: 1,
            evaluations: 600,
            only: None,
        };
        while let Some(word) = words.next() {
            let value = words.next().ok_or_else(|| format!("switches: write a value after {word}"))?;
            let number = || value.parse::<u32>().map_err(|why| format!("switches: {word} {value}: {why}"));
            match word.as_str() {
                "--sample" => asked.sample = number()? as usize,
                "--seed" => asked.seed = number()?.into(),
                "--evaluations" => asked.evaluations = number()?,
                "--only" => asked.only = Some(value),
                _ => return Err(format!("switches: `{word}` is no option")),
            }
        }
        Ok(asked)
    }
}

/// The next of a stream of random numbers: SplitMix64.
fn mixed(state: u64) -> u64 {
    let mut z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The tasks of each system, from the table in docs/ARCHITECTURE.md.
fn tasks(page: &str) -> BTreeMap<String, Vec<String>> {
    let rows = page.lines().map(|line| line.split('|').map(str::trim).collect::<Vec<_>>());
    let quoted = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    rows.filter(|row| row.len() == 5).map(|row| (quoted(row[1]).concat(), quoted(row[2]))).collect()
}

/// Numbers of one system's mutants: sampled, and by what noticed them.
#[derive(Default)]
struct Row {
    sampled: usize,
    by: BTreeMap<Notice, usize>,
}

impl Row {
    fn of(&self, notice: Notice) -> usize {
        self.by.get(&notice).copied().unwrap_or(0)
    }

    fn told(&self, name: &str) -> String {
        let all = [Notice::Unreached, Notice::Nothing, Notice::Run, Notice::Gate, Notice::Endless, Notice::Hunt];
        let [unreached, nothing, run, gate, endless, hunt] = all.map(|notice| self.of(notice));
        let [caught, changing] = [run + gate + endless, run + gate + endless + hunt];
        let counts = format!("{} | {unreached} | {nothing} | {run} | {gate} | {endless} | {hunt}", self.sampled);
        format!("| {name} | {counts} | {caught} of {changing} |")
    }
}

/// Prints how many outcomes no suite has, by system and by cause; the list is written to a file.
fn coverage(asked: &Asked, systems: &[System], suites: &[Suite]) -> Result<(), String> {
    let reached: BTreeSet<&(String, usize, u8)> = suites.iter().flat_map(|suite| &suite.reached).collect();
    let (mut list, mut causes) = (String::new(), Causes::read()?);
    println!("\n| crate | comparisons and conditions | outcomes | seen | never reached |");
    println!("|---|---:|---:|---:|---:|");
    for system in systems {
        let (mut all, mut seen, mut never) = (0, 0, 0);
        for (number, (_, switch)) in system.switches.iter().enumerate() {
            if !switch.has_outcomes || system.dropped.contains(&number) {
                continue;
            }
            let has = |bit: u8| reached.contains(&(system.name.clone(), number, bit));
            let [no, yes] = [has(1), has(2)];
            all += 1;
            seen += usize::from(no) + usize::from(yes);
            never += usize::from(!no && !yes);
            let what = match [no, yes] {
                [true, true] => continue,
                [true, false] => "never true",
                [false, true] => "never false",
                [false, false] => "never reached",
            };
            let (path, unseen) = (system.path(number), 2 - usize::from(no) - usize::from(yes));
            let cause = causes.count(&system.name, &path, &switch.text, unseen);
            list += &format!("{what}: {}: {} ({cause})\n", system.told(number), switch.text);
        }
        println!("| `{}` | {all} | {} | {seen} | {never} |", system.name, 2 * all);
    }
    print!("{}", causes.told());
    let path = asked.out.join("outcomes-not-seen.txt");
    std::fs::write(&path, list).map_err(|why| format!("{}: {why}", path.display()))
}

fn run(asked: &Asked) -> Result<(), String> {
    std::fs::create_dir_all(&asked.out).map_err(|why| format!("{}: {why}", asked.out.display()))?;
    let page = std::fs::read_to_string(asked.root.join("docs/ARCHITECTURE.md")).map_err(|why| why.to_string())?;
    let tasks = tasks(&page);
    let mut systems = tree::systems(&asked.root)?;
    let total: usize = systems.iter().map(|system| system.switches.len()).sum();
    println!("{total} changes of {} systems", systems.len());
    tree::build(&asked.root, &asked.target, &mut systems)?;
    let program = asked.target.join("ci/predicament").with_extension(std::env::consts::EXE_EXTENSION);
    let tool = Tool { program, out: asked.out.clone(), evaluations: asked.evaluations };
    let mut suites = Vec::new();
    for suite in tool.suites()? {
        suites.push(tool.reach(&suite)?);
    }
    suites.sort_by_key(|suite| suite.took);
    coverage(asked, &systems, &suites)?;
    let mut chosen: Vec<(u64, &System, usize)> = Vec::new();
    for system in systems.iter().filter(|system| asked.only.as_ref().is_none_or(|only| *only == system.name)) {
        let salt = system.name.bytes().fold(asked.seed, |state, byte| mixed(state ^ u64::from(byte)));
        chosen.extend((0..system.switches.len()).map(|number| (mixed(salt ^ number as u64), system, number)));
    }
    chosen.sort_by_key(|(key, ..)| *key);
    let mut rows: BTreeMap<&str, Row> = BTreeMap::new();
    let mut not_compiled = 0;
    let mut hunted: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut taken = 0;
    for (_, system, number) in chosen {
        if taken == asked.sample {
            break;
        }
        if system.dropped.contains(&number) {
            not_compiled += 1;
            continue;
        }
        taken += 1;
        let reaches = |suite: &&Suite| suite.reached.iter().any(|(name, at, _)| *name == system.name && *at == number);
        let reaching: Vec<&Suite> = suites.iter().filter(reaches).collect();
        let change = format!("{}:{number}", system.name);
        let mut notice = tool.notices(&change, &reaching)?;
        let mut found = String::new();
        for task in tasks.get(&system.name).into_iter().flatten().filter(|_| notice == Notice::Nothing) {
            let without = match hunted.get(task) {
                Some(known) => known,
                None => hunted.entry(task.clone()).or_insert(tool.hunted("", task)?),
            };
            let with = tool.hunted(&change, task)?;
            if let Some(new) = with.difference(without).next() {
                found = format!(" ({task}: {new})");
                notice = Notice::Hunt;
                break;
            }
        }
        if notice == Notice::Nothing && reaching.is_empty() {
            notice = Notice::Unreached;
        }
        println!("{notice:?}{found}, {} suites reach it: {change}, {}", reaching.len(), system.told(number));
        let row = rows.entry(&system.name).or_default();
        row.sampled += 1;
        *row.by.entry(notice).or_default() += 1;
    }
    println!("\nSampled: {taken} of {total} changes, seed {}; {not_compiled} more do not compile.", asked.seed);
    println!(
        "| crate | sampled | not reached | reached, no answer changed | run | gate | never end | missed, found by `hunt` \
         | score |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|---:|---:|");
    let mut all = Row::default();
    for (name, row) in &rows {
        println!("{}", row.told(&format!("`{name}`")));
        all.sampled += row.sampled;
        row.by.iter().for_each(|(notice, count)| *all.by.entry(*notice).or_default() += count);
    }
    println!("{}", all.told("all"));
    Ok(())
}

fn main() -> ExitCode {
    match Asked::parse().and_then(|asked| run(&asked)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}
