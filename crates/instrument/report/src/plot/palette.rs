//! The colours of backends: one for each name, the same on every page and plot.

use plotters::prelude::RGBColor;

/// The colours of the tool's own backends. The hues are those of Okabe and Ito, which every kind of colour vision
/// distinguishes. Variants of a backend have its hue with another lightness.
const OWN: [(&str, RGBColor); 12] = [
    ("exact", RGBColor(46, 134, 204)),
    ("exact:rational", RGBColor(20, 70, 130)),
    ("sos", RGBColor(0, 158, 115)),
    ("sos:edelsbrunner-mucke", RGBColor(112, 196, 160)),
    ("sos:per-mesh", RGBColor(0, 116, 84)),
    ("tolerance", RGBColor(230, 159, 0)),
    ("tolerance:f32", RGBColor(184, 132, 40)),
    ("naive", RGBColor(213, 94, 0)),
    ("naive:first", RGBColor(240, 140, 80)),
    ("naive:nalgebra", RGBColor(164, 76, 20)),
    ("epsilon", RGBColor(204, 121, 167)),
    ("shewchuk", RGBColor(140, 140, 140)),
];

/// The colours of all other names.
const OTHER: [RGBColor; 8] = [
    RGBColor(86, 180, 233),
    RGBColor(150, 130, 60),
    RGBColor(120, 94, 190),
    RGBColor(200, 80, 80),
    RGBColor(90, 150, 150),
    RGBColor(170, 110, 60),
    RGBColor(110, 120, 140),
    RGBColor(130, 160, 40),
];

/// The colour of a backend or of another name, independent of other names on the page.
///
/// It is the colour of the longest prefix of the name, up to a colon, that has one; otherwise a colour by the hash of
/// the name.
#[must_use]
pub fn colour_of(name: &str) -> RGBColor {
    own(name).unwrap_or_else(|| OTHER[place(name)])
}

/// The colours of names on one picture: [`colour_of`] for each or, if another name has it, the next free colour.
pub(crate) fn colours<'n>(names: impl IntoIterator<Item = &'n str>) -> Vec<RGBColor> {
    let mut taken: Vec<RGBColor> = Vec::new();
    for name in names {
        let first = colour_of(name);
        let mut next = OTHER.iter().cycle().skip(place(name)).take(OTHER.len());
        let is_free = |colour: &RGBColor| !taken.contains(colour);
        let colour =
            if is_free(&first) { first } else { next.find(|colour| is_free(colour)).copied().unwrap_or(first) };
        taken.push(colour);
    }
    taken
}

/// The colour of one of the tool's own backends.
fn own(name: &str) -> Option<RGBColor> {
    let beginnings = std::iter::successors(Some(name), |name| name.rsplit_once(':').map(|(before, _)| before));
    beginnings.into_iter().find_map(|name| OWN.iter().find(|(own, _)| *own == name)).map(|(_, colour)| *colour)
}

/// The index by the hash FNV-1a, equal on every machine.
fn place(name: &str) -> usize {
    let hash = name
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
    usize::try_from(hash % 8).unwrap_or(0)
}

/// The colour in the notation of HTML.
#[must_use]
pub fn hex(RGBColor(r, g, b): RGBColor) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_one_colour() {
        assert_eq!(colour_of("exact"), OWN[0].1);
        assert_eq!(colour_of("epsilon:1e-10"), colour_of("epsilon"));
        assert_ne!(colour_of("sos:per-mesh"), colour_of("sos"));
        assert_eq!(colour_of("engine:cgal"), colour_of("engine:cgal"));
        assert!(OTHER.contains(&colour_of("engine:cgal")));
        assert_eq!(hex(colour_of("shewchuk")), "#8c8c8c");
        let lines = colours(["exact", "epsilon:1e-8", "epsilon:1e-9", "one", "two", "three"]);
        assert_eq!((lines[0], lines[1]), (colour_of("exact"), colour_of("epsilon")));
        assert!((0..lines.len()).all(|at| !lines[..at].contains(&lines[at])), "{lines:?}");
        let mut all: Vec<String> = OWN.iter().map(|(_, colour)| hex(*colour)).collect();
        all.extend(OTHER.map(hex));
        all.sort();
        all.dedup();
        assert_eq!(all.len(), OWN.len() + OTHER.len(), "no two are alike");
    }
}
