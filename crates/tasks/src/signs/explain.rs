//! Explains one query: its exact value, and the answer and stage of each backend.

use predicament_judge as judge;
use predicament_predicates::{Query, Scene};

use crate::{Contestant, Explanation};

/// Asks one query alone.
pub(super) fn explain(scene: &Scene, query: &Query, backends: &[&dyn Contestant]) -> Result<Explanation, String> {
    let (question, args) = query.question().ok_or_else(|| format!("`{query}` asks for no sign"))?;
    scene.has_dimension_for(question.kind()).map_err(|why| why.to_string())?;
    let verdict = judge::verdict(scene, question, args);
    let degeneracy = judge::log2_relative(&verdict).map_or_else(|| "exactly zero".to_owned(), |x| format!("2^{x:.2}"));
    let cells = |backend: &dyn Contestant| -> Result<Vec<String>, String> {
        let (sign, stage) = backend.ask(scene, question, args).map_err(|why| why.to_string())?;
        let mut cells = vec![sign.to_string(), stage.unwrap_or_default().to_owned()];
        backend
            .with_session(scene, &mut |session| {
                let band = session.band(question).map(|band| [band.lower, band.width, band.upper]);
                cells.push(session.estimate(question, args).map_or_else(String::new, |x| format!("{x:e}")));
                cells.push(band.map_or_else(String::new, |band| band.map(|x| format!("{x:e}")).join(", ")));
            })
            .map_err(|why| why.to_string())?;
        Ok(cells)
    };
    let row = |&backend: &&dyn Contestant| (backend.name(), cells(backend).unwrap_or_else(|why| vec![why]));
    Ok(Explanation {
        vertices: args.to_vec(),
        truth: vec![format!("exact sign {}, |det| / permanent {degeneracy}", verdict.sign())],
        heads: ["sign", "stage", "estimate", "band (lower, width, upper)"].map(str::to_owned).to_vec(),
        rows: backends.iter().map(row).collect(),
    })
}
