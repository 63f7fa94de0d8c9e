//! Links and headings of a Markdown page, as far as this project's pages need them.

#[cfg(test)]
use std::collections::BTreeMap;
use std::ops::Range;

/// An inline link or image of a page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Link {
    /// The bytes of the whole link, from `[` or `![` to `)`.
    pub whole: Range<usize>,
    /// The bytes between the square brackets.
    pub text: Range<usize>,
    /// The bytes of the target, without a title.
    pub target: Range<usize>,
    /// True for an image.
    pub is_image: bool,
}

#[cfg(test)]
impl Link {
    /// The line of the page on which the link begins, from 1.
    pub fn line(&self, page: &str) -> usize {
        page[..self.whole.start].matches('\n').count() + 1
    }
}

/// True for a target on another host, which these chores leave alone.
pub fn is_external(target: &str) -> bool {
    target.contains("://") || target.starts_with("mailto:")
}

/// The inline links of a page, in the order in which they end. Code has no links.
pub fn links(page: &str) -> Vec<Link> {
    let mut links = Vec::new();
    for block in prose(page) {
        links_of_block(page, block, &mut links);
    }
    links
}

/// The blocks of a page between blank lines, without fenced code.
fn prose(page: &str) -> Vec<Range<usize>> {
    let (mut blocks, mut open, mut fence): (Vec<Range<usize>>, bool, Option<&str>) = (Vec::new(), false, None);
    let mut at = 0;
    for line in page.split_inclusive('\n') {
        let range = at..at + line.len();
        at = range.end;
        let text = line.trim();
        match fence {
            Some(mark) if text.starts_with(mark) && text.trim_start_matches(&mark[..1]).is_empty() => fence = None,
            Some(_) => {}
            None => {
                fence = fence_of(text);
                match blocks.last_mut() {
                    _ if fence.is_some() || text.is_empty() => open = false,
                    Some(block) if open => block.end = range.end,
                    _ => {
                        blocks.push(range);
                        open = true;
                    }
                }
            }
        }
    }
    blocks
}

/// The mark that opens a block of code on this line.
fn fence_of(line: &str) -> Option<&str> {
    let first = line.chars().next().filter(|c| *c == '`' || *c == '~')?;
    let length = line.len() - line.trim_start_matches(first).len();
    (length >= 3 && !line[length..].contains('`')).then(|| &line[..length])
}

fn links_of_block(page: &str, block: Range<usize>, links: &mut Vec<Link>) {
    let bytes = page.as_bytes();
    let (mut at, end, mut opened) = (block.start, block.end, Vec::new());
    while at < end {
        match bytes[at] {
            b'\\' => at += 1,
            b'`' => at = after_code(&bytes[..end], at) - 1,
            b'[' => opened.push(at),
            b']' => {
                if let Some(open) = opened.pop()
                    && let Some((target, close)) = target(&bytes[..end], at + 1)
                {
                    let is_image = open > block.start && bytes[open - 1] == b'!';
                    links.push(Link {
                        whole: open - usize::from(is_image)..close + 1,
                        text: open + 1..at,
                        target,
                        is_image,
                    });
                    at = close;
                }
            }
            _ => {}
        }
        at += 1;
    }
}

/// The place after a span of code that begins here, or after its opening backticks if the span has no end.
fn after_code(bytes: &[u8], start: usize) -> usize {
    let run = |at: usize| bytes[at..].iter().take_while(|byte| **byte == b'`').count();
    let length = run(start);
    let mut at = start + length;
    while at < bytes.len() {
        match run(at) {
            0 => at += 1,
            same if same == length => return at + same,
            other => at += other,
        }
    }
    start + length
}

/// The target in the round brackets that open here, and the place of the closing bracket.
fn target(bytes: &[u8], open: usize) -> Option<(Range<usize>, usize)> {
    if bytes.get(open) != Some(&b'(') {
        return None;
    }
    let mut depth = 0;
    let close = (open..bytes.len()).find(|&at| {
        depth += i32::from(bytes[at] == b'(') - i32::from(bytes[at] == b')');
        depth == 0
    })?;
    let end = (open + 1..close).find(|&at| bytes[at].is_ascii_whitespace()).unwrap_or(close);
    Some((open + 1..end, close))
}

/// The anchors of a page by GitHub's rule: lower case, hyphens for spaces, without punctuation. A repeated anchor has a
/// number.
#[cfg(test)]
pub fn anchors(page: &str) -> Vec<String> {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut anchors = Vec::new();
    for block in prose(page) {
        for heading in page[block].lines().filter_map(heading) {
            let slug = slug(&heading);
            let count = seen.entry(slug.clone()).or_default();
            anchors.push(if *count == 0 { slug } else { format!("{slug}-{count}") });
            *count += 1;
        }
    }
    anchors
}

/// The first heading of a page, as text.
pub fn title(page: &str) -> Option<String> {
    prose(page).into_iter().find_map(|block| page[block].lines().find_map(heading))
}

/// The text of a heading, without marks of code and with links as their text; `None` for another line.
fn heading(line: &str) -> Option<String> {
    let text = line.trim_start_matches('#');
    let level = line.len() - text.len();
    if !(1..=6).contains(&level) || !text.starts_with(' ') {
        return None;
    }
    let text = text.trim().trim_end_matches('#').trim_end();
    let mut plain = String::new();
    let mut at = 0;
    for link in links(text).iter().filter(|link| !link.is_image) {
        plain += &text[at..link.whole.start];
        plain += &text[link.text.clone()];
        at = link.whole.end;
    }
    plain += &text[at..];
    Some(plain.replace(['`', '*'], ""))
}

#[cfg(test)]
fn slug(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect::<String>().to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn targets(page: &str) -> Vec<(&str, usize)> {
        links(page).into_iter().map(|link| (&page[link.target.clone()], link.line(page))).collect()
    }

    #[test]
    fn links_are_found_outside_of_code() {
        let page = "See [A](a.md#b) and\n[two\nlines](c(1).md \"title\").\n\n```text\n[no](no.md)\n```\n\
                    `[no](no.md)` ``a ` [no](no.md)`` [`code`](d.rs) ![pic](e.svg) \\[no](no.md) [x] (no.md)\n\
                    [![in](f.png)](g.md)\n";
        let expected = [("a.md#b", 1), ("c(1).md", 2), ("d.rs", 8), ("e.svg", 8), ("f.png", 9), ("g.md", 9)];
        assert_eq!(targets(page), expected);
        let images: Vec<bool> = links(page).iter().map(|link| link.is_image).collect();
        assert_eq!(images, [false, false, false, true, true, false]);
        let first = &links(page)[0];
        assert_eq!((&page[first.whole.clone()], &page[first.text.clone()]), ("[A](a.md#b)", "A"));
        // A lone backtick opens no code beyond its paragraph, and a fence ends with its own mark.
        assert_eq!(targets("a ` b\n\n[c](d) `\n\n~~~~\n```\n[no](no)\n~~~~\n[e](f)\n"), [("d", 3), ("f", 9)]);
    }

    #[test]
    fn anchors_are_those_of_github() {
        let page = "# The `tool`: a & b\n\n## [Links](x.md) don't *count*\n## Same\ntext\n### Same\n\
                    ```sh\n# no heading\n```\n#none\n## Über_uns, 2.5×\n";
        let expected = ["the-tool-a--b", "links-dont-count", "same", "same-1", "über_uns-25"];
        assert_eq!(anchors(page), expected);
        assert_eq!(title(page).as_deref(), Some("The tool: a & b"));
    }
}
