//! The decision tree that recommends a backend, as data, as text and as a picture.

use std::fmt::Write as _;

use predicament_report::{Block, Picture, Section};

/// A question with its answers, or advice.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Node {
    /// The answer that leads here; empty at the root.
    pub answer: &'static str,
    /// The question; for a leaf, the advice.
    pub text: &'static str,
    /// The nodes of the answers.
    pub next: Vec<Node>,
}

impl Node {
    fn of(answer: &'static str, text: &'static str, next: Vec<Node>) -> Node {
        Node { answer, text, next }
    }
}

/// The tree from its root.
#[must_use]
pub fn decision_tree() -> Node {
    let advice = |answer, text| Node::of(answer, text, Vec::new());
    Node::of(
        "",
        "Must answers be consistent with each other, as in a triangulation, an overlay or a Boolean operation?",
        vec![
            advice(
                "no, some wrong answers are fine",
                "naive: plain doubles. Subtract coordinates first, above all far from the origin.",
            ),
            Node::of(
                "yes",
                "Does it matter whether two things touch: a shared wall, a point on a border?",
                vec![
                    advice(
                        "yes, exactly",
                        "exact: zero means exactly zero. Your algorithm must handle every special case.",
                    ),
                    advice(
                        "yes, within a known distance",
                        "tolerance: for contacts of features larger than its tolerances. Do not rely on the parity of the crossings of closed curves.",
                    ),
                    Node::of(
                        "no, any consistent decision is fine",
                        "May results have parts of zero length, area or volume?",
                        vec![
                            advice("yes", "sos; for two meshes sos:per-mesh."),
                            advice("no", "sos:per-mesh, then the limit (mesh_limit), then rounding (mesh_rounding)."),
                        ],
                    ),
                ],
            ),
        ],
    )
}

/// The tree as lines of text: a question, and under it each answer with its subtree.
pub(super) fn text() -> String {
    fn write(node: &Node, indent: &str, page: &mut String) {
        for (at, next) in node.next.iter().enumerate() {
            let is_last = at + 1 == node.next.len();
            let (branch, under) = if is_last { ("└─ ", "   ") } else { ("├─ ", "│  ") };
            // Writing to a String cannot fail.
            let _ = writeln!(page, "{indent}{branch}{}: {}", next.answer, next.text);
            write(next, &format!("{indent}{under}"), page);
        }
    }
    let root = decision_tree();
    let mut page = format!("{}\n", root.text);
    write(&root, "", &mut page);
    page
}

/// The section of a report with the tree, for its first screen.
#[must_use]
pub fn decision() -> Section {
    let lead = "Answer the questions from the top; each path ends at a backend.".to_owned();
    Section { id: "which", title: "Which backend to take", lead, blocks: vec![block()] }
}

/// The picture as a block of a page.
fn block() -> Block {
    let picture = Picture { svg: svg(), pdf: None };
    Block::Plot { picture, file: "which.svg".into(), alt: "Which backend for what: a decision tree".into() }
}

/// The width of the picture, narrow enough for a telephone.
const WIDTH: usize = 400;
const INDENT: usize = 18;
const LETTER: usize = 7;
const LINE: usize = 16;
const PAD: usize = 7;
const GAP: usize = 8;

/// The tree as boxes, one below the other, indented by depth; all in the colour of the surrounding text.
pub(super) fn svg() -> String {
    let mut drawn = String::new();
    let mut y = 2;
    draw(&decision_tree(), 0, &mut y, &mut drawn);
    let height = y - GAP + 2;
    format!(
        "<svg id=\"which-tree\" class=\"which\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" \
         aria-label=\"Which backend for what: a decision tree\" font-family=\"sans-serif\" font-size=\"12\" fill=\"currentColor\" stroke=\"none\" \
         style=\"max-width:100%;height:auto\">\n{drawn}</svg>\n"
    )
}

/// Draws a node and its subtree; returns the middle of its box. `y` is the top of the next box.
fn draw(node: &Node, depth: usize, y: &mut usize, drawn: &mut String) -> usize {
    let x = 1 + depth * INDENT;
    let width = WIDTH - 1 - x;
    let letters = (width - 2 * PAD) / LETTER;
    let answers = if node.answer.is_empty() { Vec::new() } else { wrapped(&format!("{}:", node.answer), letters) };
    let lines = wrapped(node.text, letters);
    let (top, height) = (*y, (answers.len() + lines.len()) * LINE + 2 * PAD - 2);
    // Advice stands in a thick frame.
    let stroke = if node.next.is_empty() { "1.8" } else { "0.8" };
    let _ = writeln!(
        drawn,
        "<rect x=\"{x}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" rx=\"4\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"{stroke}\"/>"
    );
    for (at, line) in answers.iter().chain(&lines).enumerate() {
        let style = if at < answers.len() { " font-style=\"italic\"" } else { "" };
        let _ = writeln!(
            drawn,
            "<text x=\"{}\" y=\"{}\"{style}>{}</text>",
            x + PAD,
            top + PAD + at * LINE + 11,
            escaped(line)
        );
    }
    *y = top + height + GAP;
    let rail = x + INDENT / 2;
    let middles: Vec<usize> = node.next.iter().map(|next| draw(next, depth + 1, y, drawn)).collect();
    for middle in &middles {
        let _ = writeln!(
            drawn,
            "<path d=\"M{rail} {}V{middle}H{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.8\"/>",
            top + height,
            x + INDENT
        );
    }
    top + height / 2
}

/// The words in lines of at most `letters` letters.
fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= letters => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_has_all_words_within_its_width() {
        fn words(node: &Node) -> Vec<String> {
            let own = format!("{} {}", node.answer, node.text);
            let own: Vec<String> = own.split_whitespace().map(escaped).collect();
            own.into_iter().chain(node.next.iter().flat_map(words)).collect()
        }
        let svg = svg();
        for word in words(&decision_tree()) {
            assert!(svg.contains(&word), "{word}");
        }
        assert!(!svg.contains('#') && svg.contains("currentColor"), "the picture must not set a colour");
        let lines = svg.lines().filter(|line| line.starts_with("<text"));
        for line in lines {
            let x: usize = line.split('"').nth(1).unwrap().parse().unwrap();
            let text = line.split(['>', '<']).nth(2).unwrap();
            // Letters are 6.6 wide on average at most.
            assert!(x + text.chars().count() * 66 / 10 <= WIDTH, "{line}");
        }
    }

    #[test]
    fn the_text_has_a_line_for_each_answer() {
        let text = text();
        assert_eq!(text.lines().count(), 8, "{text}");
        assert!(text.lines().skip(1).all(|line| line.contains("─ ")), "{text}");
    }
}
