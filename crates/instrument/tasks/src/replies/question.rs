//! A scene as arrays, for other programs.

use predicament_corpus::{Items, List, Spelled};
use predicament_predicates::Declined;

use super::{Array, Arrays};

/// The keys that select a method, a sample or the checks of this project: other programs do not get them.
const OUR_OWN: &[&str] = &["method", "quick_stride", "check"];

/// The scene in written form as arrays.
///
/// # Errors
/// [`Declined`] if the scene has constructed vertices: programs get points with coordinates in doubles.
pub fn question(spelled: &Spelled) -> Result<Arrays, Declined> {
    if !spelled.constructions.is_empty() {
        return Err(Declined::scene("programs are not asked about constructed vertices"));
    }
    let mut arrays = Arrays::default();
    arrays.add("points", Array::Numbers(spelled.points.concat()));
    for (key, value) in spelled.words.iter().filter(|(key, _)| !OUR_OWN.contains(key)) {
        // The value is TOML. A word is a basic string without escapes; an empty table is an empty operand.
        if value != "{}" {
            arrays.add(*key, Array::Word(value.trim_matches('"').to_owned()));
        }
    }
    // A scene does not have what it may leave out.
    for list in spelled.lists.iter().filter(|list| list.least > 0 || !list.items.is_empty()) {
        add(&mut arrays, list);
    }
    Ok(arrays)
}

fn add(arrays: &mut Arrays, List { key, items, .. }: &List) {
    let number = |count: usize| u32::try_from(count).expect("a scene has fewer than 2^32 items");
    let starts = |lengths: &mut dyn Iterator<Item = usize>| {
        let mut total = 0;
        let mut starts = vec![0];
        starts.extend(lengths.map(|length| {
            total += length;
            number(total)
        }));
        Array::Ids(starts)
    };
    match items {
        Items::Vertices(all) => arrays.add(*key, Array::Ids(all.iter().map(|v| number(v.index())).collect())),
        Items::Tuples(all) | Items::Loops(all) | Items::Labelled { tuples: all, .. } => {
            arrays.add(*key, Array::Ids(all.iter().flatten().map(|v| number(v.index())).collect()));
            arrays.add(format!("{key}.starts"), starts(&mut all.iter().map(Vec::len)));
            if let Items::Labelled { key, rows, .. } = items {
                arrays.add(*key, Array::Ids(rows.concat()));
                arrays.add(format!("{key}.starts"), starts(&mut rows.iter().map(Vec::len)));
            }
        }
        Items::Rows(all) => {
            arrays.add(*key, Array::Numbers(all.concat()));
            arrays.add(format!("{key}.starts"), starts(&mut all.iter().map(Vec::len)));
        }
        Items::Polygons(all) => {
            arrays.add(*key, Array::Numbers(all.iter().flatten().flatten().flatten().copied().collect()));
            arrays.add(format!("{key}.starts"), starts(&mut all.iter().flatten().map(Vec::len)));
            arrays.add(format!("{key}.polygons"), starts(&mut all.iter().map(Vec::len)));
        }
    }
}
