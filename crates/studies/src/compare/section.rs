//! The comparison in a report.

use std::path::Path;

use predicament_report::{Block, Cell, Origin, Section, Table, Tone};

use super::Measure;
use super::measure::read;
use super::table::{WRONG, short};
use crate::folder::plots_in;

/// The file that a folder of this study has.
const FILE: &str = "compare.csv";

const ID: &str = "compare";
const TITLE: &str = "Which backend for what";

/// The section of a report without a comparison: how to make one in this folder.
#[must_use]
pub fn missing(folder: &Path) -> Section {
    let lead = "No comparison of backends is in the folders of these runs. This command makes one, and then every report has its table:";
    let command = format!("predicament compare --out {}", folder.display());
    Section { id: ID, title: TITLE, lead: lead.to_owned(), blocks: vec![Block::Command(command)] }
}

/// The section of a report from a folder that the study has written; none where the folder has no such file.
///
/// # Errors
/// One line with the file, and the line that is wrong.
pub fn section(folder: &Path) -> Result<Option<Section>, String> {
    let path = folder.join(FILE);
    if !path.exists() {
        return Ok(None);
    }
    let measures = read(&path)?;
    let origin = Origin::at(&path).keys(["task", "backend"]).key("input", "kind").under("input", "family");
    let measures_of = [("topology in 1000 scenes", "topology"), ("declined", "declined"), ("bits", "bits")];
    let origin = origin.named(
        "measure",
        measures_of.into_iter().chain([("location, 99 %, L", "location: 99 %"), ("ns", "time"), ("KiB", "memory")]),
    );
    let mut table =
        Table::new("Backends on scenes of each kind").words(["task", "input", "backend"]).of(origin).numbers([
            "wrong answers in 10^6",
            "topology in 1000 scenes",
            "declined",
            "bits",
            "location, 99 %, L",
            "ns",
            "KiB",
        ]);
    let mut seen: Vec<[&str; 4]> = Vec::new();
    for row in &measures {
        let key = [row.task.as_str(), row.kind.as_str(), row.family.as_str(), row.backend.as_str()];
        if row.task == "resolution" || seen.contains(&key) {
            continue;
        }
        seen.push(key);
        let own: Vec<&Measure> = measures
            .iter()
            .filter(|other| [other.task.as_str(), &other.kind, &other.family, &other.backend] == key)
            .collect();
        let of = |measure: &str, unit: &str| {
            own.iter().find(|row| row.measure == measure && (unit.is_empty() || row.unit == unit)).map(|row| row.value)
        };
        let signs: Vec<f64> = WRONG.iter().filter_map(|class| of(class, "")).collect();
        let signs = (!signs.is_empty()).then(|| signs.iter().sum::<f64>());
        let topology = of("topology", "");
        let tone = |value: Option<f64>| if value.is_some_and(|x| x > 0.0) { Tone::Bad } else { Tone::Muted };
        table.push(vec![
            Cell::from(row.task.as_str()),
            Cell::from(row.kind.as_str()).detail(&*row.family),
            Cell::from(row.backend.as_str()),
            Cell::from(short(signs).as_str()).tone(tone(signs)),
            Cell::from(short(topology).as_str()).tone(tone(topology)),
            Cell::from(of("declined", "").map_or_else(|| "–".to_owned(), |x| format!("{:.0} %", 100.0 * x)).as_str()),
            Cell::from(short(of("bits", "")).as_str()),
            Cell::from(short(of("location: 99 %", "L")).as_str()),
            Cell::from(short(of("time", "")).as_str()),
            Cell::from(short(of("memory", "").map(|bytes| bytes / 1024.0)).as_str()),
        ]);
    }
    let mut blocks = plots_in(folder, "error-time", "Scenes that are wrong against time, over all inputs")?;
    blocks.push(Block::Table(table));
    blocks.extend(plots_in(
        folder,
        "conditioning",
        "Wrong answers in a million by how degenerate queries are; shaded: zeros within a band, which are promised",
    )?);
    Ok(Some(Section {
        id: ID,
        title: TITLE,
        lead: format!(
            "Backends of all philosophies on the same scenes. Each number is the value of a row of {}, which has its interval and what it is of. The plots are what backends get wrong against what they cost, with curves where a backend has a parameter, and against how degenerate a query is, with each backend's band.",
            path.display()
        ),
        blocks,
    }))
}
