//! The seeds of fuzzing: the embedded suites, as bytes of each target.

use std::path::Path;

use predicament_corpus::{Level, SceneDef, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{Dimension, PredicateKind};

/// The maximum size of a seed in bytes: small seeds are tried more often.
const MOST: usize = 6000;
/// The maximum number of points of a seed, if they are encoded as bytes.
const MOST_POINTS: usize = 8;

/// The folder of the embedded suites.
const CORPORA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../corpora");

/// The files of the folder of suites, with their names, sorted.
fn files() -> Vec<(String, String)> {
    let mut files: Vec<(String, String)> = std::fs::read_dir(CORPORA)
        .expect("the suites are beside the fuzz targets")
        .filter_map(|entry| {
            let path = entry.ok()?.path();
            let name = path.file_stem()?.to_str()?.to_owned();
            (path.extension()? == "toml").then(|| Some((name, std::fs::read_to_string(&path).ok()?)))?
        })
        .collect();
    files.sort();
    files
}

/// The scenes that are written in the suites, each as a separate suite, with its name; sorted.
#[must_use]
pub fn scenes() -> Vec<(String, String)> {
    let mut scenes = Vec::new();
    for (suite, text) in files() {
        for (number, table) in tables(&text).into_iter().enumerate() {
            let alone = format!("title = \"{suite}\"\n\n{table}");
            let parsed =
                Suite::parse(predicament_bundle::vocabulary(), "seed.toml", &alone, None, &Manifest::default());
            if table.starts_with("[[scene]]")
                && alone.len() <= MOST
                && parsed.is_ok_and(|suite| !suite.scenes.is_empty())
            {
                scenes.push((format!("{suite}-{number:03}"), alone));
            }
        }
    }
    scenes
}

/// The tables of a suite, as their text.
fn tables(text: &str) -> Vec<String> {
    let mut tables: Vec<String> = Vec::new();
    for line in text.lines() {
        if line.starts_with("[[") {
            tables.push(String::new());
        }
        if let Some(table) = tables.last_mut().filter(|_| !line.trim().is_empty()) {
            table.push_str(line);
            table.push('\n');
        }
    }
    tables
}

/// Suites, expectations and the manifest, in pieces, with the byte for their kind.
#[must_use]
pub fn suites() -> Vec<(String, Vec<u8>)> {
    let mut seeds = Vec::new();
    for (name, text) in files() {
        let kind = match name.as_str() {
            "expected" => 1,
            "fetch" => 2,
            _ => 0,
        };
        for (number, table) in tables(&text).into_iter().enumerate().filter(|(_, table)| table.len() <= MOST) {
            let text = if kind == 0 { format!("title = \"{name}\"\n{table}") } else { table };
            seeds.push((format!("{name}-{number:03}"), [&[kind], text.as_bytes()].concat()));
        }
    }
    seeds
}

/// Points as the bytes of a target, after the target's first bytes.
fn of_points(first: &[u8], dimension: usize, coordinates: &[f64]) -> Vec<u8> {
    let mut bytes = first.to_vec();
    for point in coordinates.chunks_exact(dimension).take(MOST_POINTS) {
        // A point from its own coordinates, any doubles: see `points`.
        bytes.push(0);
        for coordinate in point {
            bytes.push(3);
            bytes.extend(coordinate.to_bits().to_le_bytes());
        }
    }
    bytes
}

/// The first points of the scenes of signs, as bytes for the targets of this predicate, and for the target of broken
/// ties.
#[must_use]
pub fn points(kind: PredicateKind, with_scheme: Option<u8>) -> Vec<(String, Vec<u8>)> {
    let mut seeds = Vec::new();
    for (name, text) in scenes() {
        for def in crate::scenes::of_text(&text).into_iter().filter(|def: &SceneDef| def.task == kind.name()) {
            let Ok(loaded) = def.load(Level::Quick, &Cache::new("/nowhere")) else { continue };
            let (is_space, dimension) = match loaded.scene.dimension() {
                Dimension::Two => (0, 2),
                Dimension::Three => (1, 3),
            };
            let first: Vec<u8> = with_scheme.into_iter().chain([is_space]).collect();
            seeds.push((name.clone(), of_points(&first, dimension, loaded.scene.coordinates())));
        }
    }
    seeds
}

/// All seeds, by target.
#[must_use]
pub fn all() -> Vec<(&'static str, Vec<(String, Vec<u8>)>)> {
    let of = |tasks: &[&str]| -> Vec<(String, Vec<u8>)> {
        let is_one =
            |text: &str| tasks.is_empty() || crate::scenes::of_text(text).iter().any(|def| tasks.contains(&def.task));
        scenes().into_iter().filter(|(_, text)| is_one(text)).map(|(name, text)| (name, text.into_bytes())).collect()
    };
    let mut all: Vec<(&'static str, Vec<(String, Vec<u8>)>)> = vec![("suites", suites()), ("scenes", of(&[]))];
    all.extend(crate::OF_TASKS.map(|(target, tasks)| (target, of(tasks))));
    let folder = (0..u8::try_from(crate::run_folder::FILES.len()).expect("a few files"))
        .map(|file| (format!("file-{file}"), [&[file], crate::run_folder::text_of(file).as_slice()].concat()));
    all.push(("run_folder", folder.collect()));
    for kind in PredicateKind::ALL {
        all.push((kind.name(), points(kind, None)));
    }
    let ties = (0..=u8::MAX).filter_map(|head| {
        let (kind, _) = crate::ties::chosen(head);
        (usize::from(head) < 2 * PredicateKind::ALL.len())
            .then(|| points(kind, Some(head)).into_iter().map(move |(name, bytes)| (format!("{name}-{head}"), bytes)))
    });
    all.push(("ties", ties.flatten().collect()));
    all
}

/// Writes all seeds into `corpus/TARGET` of the fuzz crate's folder; returns their number per target.
///
/// # Errors
/// The error of the file system.
pub fn write(folder: &Path) -> std::io::Result<Vec<(&'static str, usize)>> {
    let mut written = Vec::new();
    for (target, seeds) in all() {
        let folder = folder.join(target);
        std::fs::create_dir_all(&folder)?;
        for (name, bytes) in &seeds {
            std::fs::write(folder.join(format!("seed-{name}")), bytes)?;
        }
        written.push((target, seeds.len()));
    }
    Ok(written)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_target_has_seeds_and_they_are_cases() {
        for (target, seeds) in all() {
            assert!(seeds.len() > 2, "{target}: {} seeds", seeds.len());
        }
        // Points are read back as written.
        let bytes = of_points(&[], 2, &[0.5, 12.0, -0.25, 1e300]);
        assert_eq!(crate::points::from_bytes::<2>(&bytes, 2), [[0.5, 12.0], [-0.25, 1e300]]);
    }
}
