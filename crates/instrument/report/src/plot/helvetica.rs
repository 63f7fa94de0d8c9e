//! The fonts that every PDF reader has: the font, the code and the width of a character.
//!
//! A PDF reader provides fourteen fonts, so a file does not embed any. Text that is right-aligned or centred has to be
//! measured. The widths here are those of Adobe's Core 14 AFM files (1997), in thousandths of the size. Latin letters
//! are Helvetica in the encoding WinAnsi. Greek letters and mathematics are Symbol, which has its own encoding. Any
//! other character becomes a question mark.

/// A font.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Face {
    Regular,
    Bold,
    Symbol,
}

impl Face {
    /// The standard name of the font, which every PDF reader knows.
    pub const fn name(self) -> &'static [u8] {
        match self {
            Face::Regular => b"Helvetica",
            Face::Bold => b"Helvetica-Bold",
            Face::Symbol => b"Symbol",
        }
    }

    /// The height of the letter x, as a fraction of the size.
    pub const fn x_height(self) -> f64 {
        match self {
            Face::Bold => 0.532,
            Face::Regular | Face::Symbol => 0.523,
        }
    }
}

/// A run of text in one font.
#[derive(PartialEq, Eq, Debug)]
pub struct Run {
    pub face: Face,
    pub codes: Vec<u8>,
}

/// The text as runs, and its width as a multiple of the size.
pub fn set(text: &str, face: Face) -> (Vec<Run>, f64) {
    let mut runs: Vec<Run> = Vec::new();
    let mut width = 0;
    for letter in text.chars() {
        let (face, code, wide) = glyph(letter, face);
        width += u32::from(wide);
        match runs.last_mut() {
            Some(run) if run.face == face => run.codes.push(code),
            _ => runs.push(Run { face, codes: vec![code] }),
        }
    }
    (runs, f64::from(width) / 1000.0)
}

fn glyph(letter: char, face: Face) -> (Face, u8, u16) {
    let latin = |code: u8| (face, code, widths(face)[usize::from(code - b' ')]);
    win_ansi(letter).map(latin).or_else(|| symbol(letter)).unwrap_or_else(|| latin(b'?'))
}

fn win_ansi(letter: char) -> Option<u8> {
    match letter {
        ' '..='~' | '\u{a0}'..='\u{ff}' => u8::try_from(u32::from(letter)).ok(),
        _ => code_in(0x80, BETWEEN, letter),
    }
}

fn symbol(letter: char) -> Option<(Face, u8, u16)> {
    // Characters that look the same.
    let letter = match letter {
        '∆' => 'Δ',
        'Ω' => 'Ω',
        'ϵ' => 'ε',
        '∑' => 'Σ',
        NONE => return None,
        letter => letter,
    };
    SYMBOL.iter().find_map(|row| {
        let code = code_in(row.from, row.letters, letter)?;
        Some((Face::Symbol, code, row.widths[usize::from(code - row.from)]))
    })
}

/// The code of a letter in a list of letters with consecutive codes.
fn code_in(from: u8, letters: &str, letter: char) -> Option<u8> {
    let place = letters.chars().position(|other| other == letter)?;
    from.checked_add(u8::try_from(place).ok()?)
}

fn widths(face: Face) -> &'static [u16; 224] {
    if face == Face::Bold { &BOLD } else { &REGULAR }
}

/// The mark of a code without a letter, or with one that Helvetica has too.
const NONE: char = '·';

/// WinAnsi from 0x80 on; from 0xa0 on it equals Unicode.
const BETWEEN: &str = "€·‚ƒ„…†‡ˆ‰Š‹Œ·Ž··‘’“”•–—˜™š›œ·žŸ";

/// The widths of Helvetica from 0x20 on.
const REGULAR: [u16; 224] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556, 556,
    556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833,
    722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556,
    556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334,
    260, 334, 584, 350, 556, 350, 222, 556, 333, 1000, 556, 556, 333, 1000, 667, 333, 1000, 350, 611, 350, 350, 222,
    222, 333, 333, 350, 556, 1000, 333, 1000, 500, 333, 944, 350, 500, 667, 278, 333, 556, 556, 556, 556, 260, 556,
    333, 737, 370, 556, 584, 333, 737, 333, 400, 584, 333, 333, 333, 556, 537, 278, 333, 333, 365, 556, 834, 834, 834,
    611, 667, 667, 667, 667, 667, 667, 1000, 722, 667, 667, 667, 667, 278, 278, 278, 278, 722, 722, 778, 778, 778, 778,
    778, 584, 778, 722, 722, 722, 722, 667, 667, 611, 556, 556, 556, 556, 556, 556, 889, 500, 556, 556, 556, 556, 278,
    278, 278, 278, 556, 556, 556, 556, 556, 556, 556, 584, 611, 556, 556, 556, 556, 500, 556, 500,
];

/// The widths of Helvetica-Bold from 0x20 on.
const BOLD: [u16; 224] = [
    278, 333, 474, 556, 556, 889, 722, 238, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556, 556,
    556, 556, 556, 333, 333, 584, 584, 584, 611, 975, 722, 722, 722, 722, 667, 611, 778, 722, 278, 556, 722, 611, 833,
    722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 333, 278, 333, 584, 556, 333, 556, 611, 556, 611,
    556, 333, 611, 611, 278, 278, 556, 278, 889, 611, 611, 611, 611, 389, 556, 333, 611, 556, 778, 556, 556, 500, 389,
    280, 389, 584, 350, 556, 350, 278, 556, 500, 1000, 556, 556, 333, 1000, 667, 333, 1000, 350, 611, 350, 350, 278,
    278, 500, 500, 350, 556, 1000, 333, 1000, 556, 333, 944, 350, 500, 667, 278, 333, 556, 556, 556, 556, 280, 556,
    333, 737, 370, 556, 584, 333, 737, 333, 400, 584, 333, 333, 333, 611, 556, 278, 333, 333, 365, 556, 834, 834, 834,
    611, 722, 722, 722, 722, 722, 722, 1000, 722, 667, 667, 667, 667, 278, 278, 278, 278, 722, 722, 778, 778, 778, 778,
    778, 584, 778, 722, 722, 722, 722, 667, 667, 611, 556, 556, 556, 556, 556, 556, 889, 556, 556, 556, 556, 556, 278,
    278, 278, 278, 611, 611, 611, 611, 611, 611, 611, 584, 611, 611, 611, 611, 611, 556, 611, 556,
];

/// A part of the font Symbol.
struct Row {
    /// The first code.
    from: u8,
    letters: &'static str,
    widths: [u16; 32],
}

/// The supported letters and mathematics of Symbol.
const SYMBOL: [Row; 5] = [
    Row {
        from: 0x20,
        letters: " !∀#∃%&∋()∗+,−./0123456789:;<=>?",
        widths: [
            250, 333, 713, 500, 549, 833, 778, 439, 333, 333, 500, 549, 250, 549, 250, 278, 500, 500, 500, 500, 500,
            500, 500, 500, 500, 500, 278, 278, 549, 549, 549, 444,
        ],
    },
    Row {
        from: 0x40,
        letters: "≅ΑΒΧΔΕΦΓΗΙϑΚΛΜΝΟΠΘΡΣΤΥςΩΞΨΖ[∴]⊥_",
        widths: [
            549, 722, 667, 722, 612, 611, 763, 603, 722, 333, 631, 722, 686, 889, 722, 722, 768, 741, 556, 592, 611,
            690, 439, 768, 645, 795, 611, 333, 863, 333, 658, 500,
        ],
    },
    Row {
        from: 0x60,
        letters: "·αβχδεφγηιϕκλμνοπθρστυϖωξψζ{|}∼·",
        widths: [
            0, 631, 549, 549, 494, 439, 521, 411, 603, 329, 603, 549, 549, 576, 521, 549, 549, 521, 549, 603, 439, 576,
            713, 686, 493, 686, 494, 480, 200, 480, 549, 0,
        ],
    },
    Row {
        from: 0xa0,
        letters: "€ϒ′≤⁄∞ƒ♣♦♥♠↔←↑→↓°±″≥×∝∂•÷≠≡≈…··↵",
        widths: [
            750, 620, 247, 549, 167, 713, 500, 753, 753, 753, 753, 1042, 987, 603, 987, 603, 400, 549, 411, 549, 549,
            713, 494, 460, 549, 549, 549, 549, 1000, 0, 0, 658,
        ],
    },
    Row {
        from: 0xc0,
        letters: "ℵℑℜ℘⊗⊕∅∩∪⊃⊇⊄⊂⊆∈∉∠∇···∏√⋅¬∧∨⇔⇐⇑⇒⇓",
        widths: [
            823, 686, 795, 987, 768, 768, 823, 768, 768, 713, 713, 713, 713, 713, 713, 713, 768, 713, 0, 0, 0, 823,
            549, 250, 713, 603, 603, 1042, 987, 603, 987, 603,
        ],
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_set_font_by_font() {
        let run = |face, codes: &[u8]| Run { face, codes: codes.to_vec() };
        // 500 + 278 + 549 + 278 + 556.
        let expected = vec![run(Face::Regular, b"x "), run(Face::Symbol, b"\xa3"), run(Face::Regular, b" 2")];
        assert_eq!(set("x ≤ 2", Face::Regular), (expected, 2.161));
        // The sum is 333 + 556 + 584: this sign is in WinAnsi; other signs are not.
        assert_eq!(set("-2×", Face::Bold), (vec![run(Face::Bold, b"-2\xd7")], 1.473));
        assert_eq!(set("", Face::Bold), (vec![], 0.0));
    }

    #[test]
    fn signs_that_helvetica_lacks_are_found() {
        let codes = |text: &str| set(text, Face::Regular).0.into_iter().flat_map(|run| run.codes).collect::<Vec<_>>();
        assert_eq!(codes("∞≤≥→√Δ−στγδε"), b"\xa5\xa3\xb3\xae\xd6\x44\x2d\x73\x74\x67\x64\x65");
        assert!(set("∞≤≥→√Δ∆−στγδε", Face::Bold).0.iter().all(|run| run.face == Face::Symbol));
        // These are in Helvetica's encoding, though above Latin-1.
        assert_eq!(codes("–—…€Ÿ·"), b"\x96\x97\x85\x80\x9f\xb7");
        assert_eq!(codes("日\u{81}\u{7f}"), b"???");
    }

    #[test]
    fn every_code_has_a_width() {
        for row in &SYMBOL {
            assert_eq!(row.letters.chars().count(), row.widths.len(), "{}", row.letters);
            let is_none = row.letters.chars().map(|letter| letter == NONE);
            assert!(is_none.zip(row.widths).all(|(none, width)| none == (width == 0)), "{}", row.letters);
        }
        assert_eq!(BETWEEN.chars().count(), 32);
    }
}
