//! Explanations as lines of text: points, the truth, and the answer of each backend.

use predicament_corpus::LoadedScene;
use predicament_formats::hexfloat;
use predicament_predicates::{Sign, Vertex};
use predicament_tasks::{AnswerError, Explanation, Refusal};

/// The truth and the answers, in columns.
pub fn lines(told: &Explanation) -> Vec<String> {
    let mut lines: Vec<String> = told.truth.iter().map(|line| format!("{:<24} {line}", "truth")).collect();
    let heads = (!told.heads.is_empty()).then(|| ("backend".to_owned(), told.heads.clone()));
    let rows: Vec<(String, Vec<String>)> = heads.into_iter().chain(told.rows.iter().cloned()).collect();
    let width = |column: usize| {
        let cells = rows.iter().filter(|(_, cells)| cells.len() > 1).filter_map(|(_, cells)| cells.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    for (name, cells) in &rows {
        let cells: Vec<String> = cells.iter().enumerate().map(|(at, cell)| format!("{cell:<0$}", width(at))).collect();
        lines.push(format!("{name:<24} {}", cells.join("  ")).trim_end().to_owned());
    }
    if told.permutations.iter().any(|(_, of)| of.iter().any(|sign| *sign != of[0])) {
        lines.push("for all orders of the vertices, negated for odd orders:".to_owned());
        // Group the orders that begin with the same vertex.
        let grouped = |of: &[Sign]| of.chunks(group(of.len())).map(signs).collect::<Vec<_>>().join(" ");
        lines.extend(told.permutations.iter().map(|(name, of)| format!("{name:<24} {}", grouped(of))));
    }
    lines
}

/// The signs as a word of `-`, `0` and `+`.
pub fn signs(of: &[Sign]) -> String {
    of.iter().map(|sign| ["-", "0", "+"][usize::from(sign.as_i8() >= 0) + usize::from(sign.as_i8() > 0)]).collect()
}

/// The coordinates of vertices; for constructed vertices, those of their defining vertices.
pub fn point_lines(loaded: &LoadedScene, ids: &[Vertex]) -> Vec<String> {
    let mut lines = Vec::new();
    for &id in ids {
        if let Some(construction) = loaded.scene.construction(id) {
            lines.push(format!("vertex {:>8}  {construction}", id.to_string()));
            let defining: Vec<Vertex> = construction.flats().flatten().copied().collect();
            lines.extend(point_lines(loaded, &defining));
            continue;
        }
        let point = loaded.scene.point(id);
        let decimal: Vec<String> = point.iter().map(|x| format!("{x:?}")).collect();
        let hex: Vec<String> = point.iter().map(|&x| hexfloat::format(x)).collect();
        lines.push(format!("vertex {:>8}  ({})  = ({})", id.to_string(), decimal.join(", "), hex.join(", ")));
    }
    lines
}

/// The number of orders that begin with one given vertex, if there are n! orders of n vertices.
fn group(orders: usize) -> usize {
    (1..=5)
        .map(|n| (n, (1..=n).product::<usize>()))
        .find(|(_, all)| *all == orders)
        .map_or(orders.max(1), |(n, all)| all / n)
}

/// The advice to add to a refusal if another kind of backend would answer.
pub fn cure(why: &AnswerError) -> &'static str {
    match why {
        AnswerError::Refused(Refusal { check: "touch", .. }) => {
            "; add -b sos:per-mesh, which moves the second mesh by an infinitesimal, or -b sos, which moves every vertex"
        }
        _ => "",
    }
}
