//! The behaviour of every study, which a new study gets from the trait.

use std::cell::RefCell;
use std::sync::atomic::AtomicBool;

use predicament_exact::Exact;
use predicament_predicates::{Backend, Contract, Declined, PredicateKind, Scene, Tally};
use predicament_studies::{Entry, Error, File, Host, Ready, Report, Study};
use predicament_tasks::{AnyTask, Contestant, Stop, Watch};

use predicament_bundle::STUDIES;

use crate::{backend, quiet};

/// A study with these arguments.
fn ready(line: &str) -> Box<dyn Ready> {
    let name = line.split(' ').next().unwrap();
    let entry = STUDIES.iter().find(|entry| entry.name == name).expect("it is in the list");
    entry.parse(&entry.command().get_matches_from(line.split(' '))).unwrap()
}

fn report(study: &dyn Ready, host: &dyn Host) -> Result<Report, Error> {
    let backends: Vec<_> = study.backends().iter().flat_map(|names| names.split(',')).map(backend).collect();
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    study.report(&backends, host)
}

/// Each study with a small amount of work, and its files.
const SMALL: [(&str, &[&str]); 17] = [
    ("bounds", &["bounds.csv", "bounds.md"]),
    (
        "compare -b exact,tolerance -t orient2d --scenes 1 --samples 1 --out x",
        &["compare.csv", "promises.csv", "compare.md", "error-time-answers.svg", "error-time-answers.pdf"],
    ),
    (
        "stress -b exact,naive -t orient2d -k noise,scale --scenes 1 --samples 1 --tuples 10 --out x",
        &[
            "stress.csv",
            "breaks.csv",
            "stress-laws.csv",
            "stress.md",
            "stress-noise.svg",
            "stress-noise.pdf",
            "stress-noise-time.svg",
            "stress-noise-time.pdf",
            "stress-scale-time.svg",
            "stress-scale-time.pdf",
        ],
    ),
    (
        "resolution --trials 2 --out x",
        &[
            "resolution.csv",
            "location.csv",
            "resolution.md",
            "resolution.svg",
            "resolution.pdf",
            "location.svg",
            "location.pdf",
        ],
    ),
    ("parity --pairs 20 --shrink 1 --out x", &["parity.csv", "parity.md", "smallest.toml"]),
    ("cut --cubes 4 -b exact", &["cut.csv", "cut-times.csv", "cut.md"]),
    ("audit --decisions 200", &["audit.csv", "reads.csv", "hierarchy.csv", "constants.csv", "audit.md"]),
    ("worst --steps 20 --climbs 1", &["errors.csv", "guards.csv", "worst.md"]),
    ("laws -b exact,naive --tuples 2000", &["laws.csv", "laws.md"]),
    (
        "cascades -c rotate --steps 7 --samples 2 --probes 9",
        &[
            "cascades.csv",
            "times.csv",
            "cascades.md",
            "rotate-area.svg",
            "rotate-area.pdf",
            "rotate-wrong.svg",
            "rotate-wrong.pdf",
            "rotate-bits.svg",
            "rotate-bits.pdf",
            "rotate-time.svg",
            "rotate-time.pdf",
            "rotate.wkt",
        ],
    ),
    (
        "mesh-cascades -c shave -b exact --steps 3 --samples 2 --probes 9",
        &[
            "mesh-cascades.csv",
            "mesh-cascade-times.csv",
            "mesh-cascades.md",
            "mesh-shave-triangles.svg",
            "mesh-shave-triangles.pdf",
            "mesh-shave-time.svg",
            "mesh-shave-time.pdf",
        ],
    ),
    (
        "touching -p general,faces --side 2 --levels 1 --rounds 1",
        &["touching.csv", "touching-times.csv", "touching.md", "touching-pairs.toml"],
    ),
    (
        "decimals -b exact --digits 1 --queries 5 --samples 0 --out x",
        &[
            "decimals.csv",
            "decimals.md",
            "decimals-metres.svg",
            "decimals-metres.pdf",
            "decimals-degrees.svg",
            "decimals-degrees.pdf",
            "decimals-survey.svg",
            "decimals-survey.pdf",
            "decimals-inches.svg",
            "decimals-inches.pdf",
        ],
    ),
    ("repeat -b exact --task orient2d --size 10 --out x", &["repeat.csv", "repeat.md"]),
    ("border -b naive --family near --queries 20 --out x", &["border.csv", "border.md", "border.toml"]),
    (
        "ablation -b exact:without=static -t orient2d --samples 1 --size 10",
        &["ablation.csv", "ablation.md", "ablation.svg", "ablation.pdf"],
    ),
    (
        "scale -t crossings --min 10 --max 100 --out x",
        &["scale.csv", "scale.md", "scale-time.svg", "scale-time.pdf", "scale-memory.svg", "scale-memory.pdf"],
    ),
];

#[test]
fn every_study_is_tried_here() {
    assert_eq!(
        STUDIES.iter().map(|entry| entry.name).collect::<Vec<_>>(),
        SMALL.map(|(line, _)| line.split(' ').next().unwrap())
    );
}

#[test]
fn every_study_makes_its_files_and_a_page() {
    for (line, files) in SMALL {
        let one = report(ready(line).as_ref(), &quiet()).unwrap();
        assert_eq!(one.files.iter().map(|file| file.name.as_str()).collect::<Vec<_>>(), files, "{line}");
        assert!(one.files.iter().all(|file| !file.bytes.is_empty()), "{line}");
        assert_eq!(one.holds, !line.starts_with("laws"), "{line}");
        let page = one.files.iter().find(|file| file.name.ends_with(".md")).unwrap();
        assert_eq!(one.printed, page.text(), "{line}");
    }
}

#[test]
fn rows_are_printed_where_the_arguments_ask_for_them() {
    let rows = report(ready("laws -b exact --tuples 0 --format csv").as_ref(), &quiet()).unwrap();
    assert_eq!(rows.printed, rows.files[0].text());
    assert!(rows.printed.starts_with("backend,law,predicates,tuples,violations,panics,first\n"), "{}", rows.printed);
}

/// Counts the reported work, and stops the study at the first chunk.
struct Impatient<'a> {
    watch: Watch<'a>,
    told: RefCell<Vec<String>>,
}

impl Host for Impatient<'_> {
    fn watch(&self) -> &Watch<'_> {
        &self.watch
    }

    fn tasks(&self) -> &[&'static dyn AnyTask] {
        predicament_bundle::tasks()
    }

    fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, Error> {
        predicament_bundle::backend(name).map_err(Error::unfit)
    }

    fn begin(&self, total: u64, unit: &str) {
        assert!(total > 0);
        self.told.borrow_mut().push(unit.to_owned());
    }
}

#[test]
fn every_study_says_what_it_begins_and_stops_where_it_is_told() {
    let units = [
        "derivations",
        "answers",
        "answers",
        "features",
        "pairs",
        "cuts",
        "decisions",
        "bounds",
        "tuples",
        "steps",
        "steps",
    ];
    for ((line, _), unit) in SMALL.into_iter().zip(units) {
        let (cancel, quiet) = (AtomicBool::new(true), |_: u64| {});
        let host = Impatient { watch: Watch::new(&cancel, None, &quiet), told: RefCell::default() };
        assert_eq!(report(ready(line).as_ref(), &host), Err(Error::Stopped(Stop::Interrupted)), "{line}");
        assert_eq!(host.told.into_inner(), [unit], "{line}");
    }
}

/// A backend that declines every scene.
struct Never;

impl Backend for Never {
    type Session<'s, T: Tally + 's> = <Exact as Backend>::Session<'s, T>;

    fn name(&self) -> String {
        "never".to_owned()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Exact.contract(kind)
    }

    fn stages(&self) -> &'static [&'static str] {
        Exact.stages()
    }

    fn prepare<'s, T: Tally + 's>(&'s self, _: &'s Scene, _: T) -> Result<Self::Session<'s, T>, Declined> {
        Err(Declined::scene("not today"))
    }
}

#[test]
fn a_backend_that_declines_is_named() {
    let never = predicament_bundle::entry(Never);
    let never: [&dyn Contestant; 1] = [&never];
    let refused = ready("resolution --trials 1 --out x").report(&never, &quiet());
    assert_eq!(refused.err(), Some(Error::unfit("never on `vertices apart`: scene declined: not today")));
    let laws = ready("laws --tuples 0 --format csv").report(&never, &quiet()).unwrap();
    assert!(laws.holds && laws.printed.lines().skip(1).all(|row| row.ends_with(",0,0,0,")), "{}", laws.printed);
}

#[test]
fn reports_are_written_file_by_file() {
    let folder = std::env::temp_dir().join(format!("predicament-studies-{}", std::process::id()));
    let report = Report {
        printed: String::new(),
        files: vec![File::csv("a.csv", [("x", 1), ("y", 2)]).unwrap(), File::new("b.md", "b\n")],
        holds: true,
    };
    assert!(report.write(&folder).unwrap_err().to_string().contains("a.csv"), "the folder is missing");
    std::fs::create_dir_all(&folder).unwrap();
    report.write(&folder).unwrap();
    let read = ["a.csv", "b.md"].map(|name| std::fs::read_to_string(folder.join(name)).unwrap());
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(read, ["x,1\ny,2\n", "b\n"]);
}

/// The smallest study: it counts its backends.
#[derive(clap::Args)]
struct Census {
    #[arg(long)]
    fails: bool,
}

impl Study for Census {
    const NAME: &'static str = "census";
    const ASKS: &'static str = "Count backends";
    const HELP: &'static str = "Examples: none";
    type Measured = usize;

    fn survey(&self, backends: &[&dyn Contestant], _: &dyn Host) -> Result<usize, Error> {
        if self.fails { Err(Error::unfit("as asked")) } else { Ok(backends.len()) }
    }

    fn rows(&self, measured: &usize) -> Result<Vec<File>, Error> {
        Ok(vec![File::csv("census.csv", [(measured,)])?])
    }

    fn page(&self, measured: &usize) -> String {
        format!("{measured} backends\n")
    }
}

#[test]
fn a_study_of_ones_own_needs_four_methods() {
    let entry = Entry::of::<Census>();
    let help = entry.command().render_long_help().to_string();
    assert!(help.starts_with("Count backends\n") && help.ends_with("Examples: none\n"), "{help}");
    let study = |line: &str| entry.parse(&entry.command().get_matches_from(line.split(' '))).unwrap();
    let plain = study("census");
    assert_eq!((plain.backends(), plain.threads(), plain.out()), (Vec::new(), None, None));
    let told = plain.report(&[backend("exact").as_ref()], &quiet()).unwrap();
    assert_eq!((told.printed.as_str(), told.files.len(), told.holds), ("1 backends\n", 2, true));
    assert_eq!(study("census --fails").report(&[], &quiet()), Err(Error::unfit("as asked")));
}
