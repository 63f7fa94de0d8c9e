//! The two pages of a report: HTML for browsers and printers, Markdown for terminals and forges.

use std::borrow::Cow;
use std::io::Write as _;
use std::path::Path;

use minijinja::syntax::SyntaxConfig;
use minijinja::{AutoEscape, Environment, UndefinedBehavior, Value, context};

use crate::sections::{FIRST, UNFOLDED, headlines, sections};
use crate::table::{Block, Headline, Section};
use crate::{Detail, Error, RunDir, figures, latex, licences, web};
use predicament_records::{Beside, Hold, make_folder};

const HTML: &str = "page.html";
const MORE: &str = "more.html";
const PLAIN: &str = "plain.html";
const MARKDOWN: &str = "page.md";
const MARKDOWN_SECTION: &str = "section.md";

/// The report as one self-contained HTML page: style, pictures, scripts and the rows of its tables are inside.
///
/// Without scripts it shows the same, except the search in the findings. `of_tasks` are the sections of single tasks,
/// `details` the details of single findings.
///
/// # Errors
/// If the plot can't be drawn or the page can't be filled in.
pub fn html(runs: &[RunDir], of_tasks: &[Section], details: &[Detail]) -> Result<String, Error> {
    render(HTML, runs, of_tasks, details)
}

/// The report as one page of Markdown. Plots are files beside it; pixel maps and the later rows of long tables are left
/// out.
///
/// # Errors
/// If the plot can't be drawn or the page can't be filled in.
pub fn markdown(runs: &[RunDir], of_tasks: &[Section]) -> Result<String, Error> {
    render(MARKDOWN, runs, of_tasks, &[])
}

/// Writes `report.html`, `report.md`, `figures.csv`, `tables.tex` and the plots into a folder, which is made if
/// necessary.
///
/// A plot is written as SVG and PDF (`overall.svg`, `overall.pdf`), if it has data. All files are written beside their
/// place first and then renamed: if writing fails, the files of an earlier report stay as they were.
///
/// # Errors
/// If a page can't be made or written.
pub fn write_pages(
    runs: &[RunDir],
    of_tasks: &[Section],
    details: &[Detail],
    folder: impl AsRef<Path>,
) -> Result<(), Error> {
    let folder = folder.as_ref();
    make_folder(folder)?;
    let mut files: Vec<(Cow<'static, str>, Vec<u8>)> = vec![
        ("report.html".into(), html(runs, of_tasks, details)?.into()),
        ("report.md".into(), markdown(runs, of_tasks)?.into()),
        (figures::FILE.into(), figures::csv(runs)?.into()),
        (latex::FILE.into(), latex::latex(runs, of_tasks)?.into()),
    ];
    let blocks = sections(runs, of_tasks)?.into_iter().flat_map(|section| section.blocks);
    for block in blocks {
        if let Block::Plot { picture, file, .. } = block {
            let pdf = Path::new(&*file).with_extension("pdf").to_string_lossy().into_owned();
            files.extend(picture.pdf.map(|bytes| (pdf.into(), bytes)));
            files.push((file, picture.svg.into()));
        }
    }
    // The files of two reports that are written at once are not mixed.
    let _hold = Hold::take(&folder.join("report.html"), "report")?;
    let mut written = Vec::new();
    for (name, bytes) in &files {
        let path = folder.join(&**name);
        let beside = Beside::new(&path)?;
        beside.file().write_all(bytes).map_err(Error::io(&path))?;
        written.push(beside);
    }
    Beside::keep(written)
}

fn render(template: &str, runs: &[RunDir], of_tasks: &[Section], details: &[Detail]) -> Result<String, Error> {
    let whole = sections(runs, of_tasks)?;
    let mut rest = Vec::new();
    let sections: Vec<Value> = whole.iter().map(|section| section.value(Some(&mut rest))).collect();
    let headlines: Vec<Value> = headlines(runs).iter().map(Headline::value).collect();
    let mut page = context! { headlines => headlines, sections => sections, first => FIRST, unfolded => UNFOLDED };
    if template == HTML {
        let rest = rest.into_iter().map(|rows| fill(MORE, context! { rows => rows }));
        let rest = rest.collect::<Result<Vec<_>, _>>()?;
        let rows = Value::from_safe_string(web::rows(runs, &whole, details, &rest)?);
        let libraries = Value::from_safe_string(web::libraries()?);
        let [style, scripts] =
            [web::STYLE, &web::SCRIPTS.concat()].map(|text| Value::from_safe_string(text.to_owned()));
        let licences = Value::from_safe_string(licences::comment());
        page = context! {
            rows => rows, libraries => libraries, licences => licences, style => style, scripts => scripts, ..page
        };
    }
    fill(template, page)
}

/// A page made from one of the templates.
pub(crate) fn fill(template: &str, context: Value) -> Result<String, Error> {
    let filled = environment().and_then(|env| env.get_template(template)?.render(context));
    filled.map_err(|error| Error::new(template.as_ref(), error.to_string()))
}

/// A section without its heading, in Markdown, with all rows of its tables.
///
/// # Errors
/// If the template can't be filled in.
pub fn section_markdown(section: &Section) -> Result<String, Error> {
    fill(MARKDOWN_SECTION, context! { section => section.value(None) })
}

/// An HTML page without scripts, in the style of reports: its title, links to other pages by text and address, and
/// sections with all rows of their tables.
///
/// # Errors
/// If the template can't be filled in.
pub fn plain_html(title: &str, links: &[[String; 2]], sections: &[Section]) -> Result<String, Error> {
    let links: Vec<Value> = links.iter().map(|[text, to]| context! { text => text, to => to }).collect();
    let sections: Vec<Value> = sections.iter().map(|section| section.value(None)).collect();
    let style = Value::from_safe_string(web::STYLE.to_owned());
    fill(PLAIN, context! { title => title, style => style, links => links, sections => sections })
}

fn environment() -> Result<Environment<'static>, minijinja::Error> {
    let mut env = Environment::new();
    env.set_undefined_behavior(UndefinedBehavior::Strict);
    env.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    env.set_auto_escape_callback(|name| if name.ends_with(".html") { AutoEscape::Html } else { AutoEscape::None });
    env.add_filter("plain", plain);
    env.add_filter("code", code);
    env.add_filter("breakable", breakable);
    env.add_template("head.html", include_str!("../templates/head.html"))?;
    env.add_template(HTML, include_str!("../templates/page.html"))?;
    env.add_template("body.html", include_str!("../templates/body.html"))?;
    env.add_template(PLAIN, include_str!("../templates/plain.html"))?;
    env.add_template("rows.html", include_str!("../templates/rows.html"))?;
    env.add_template(MORE, include_str!("../templates/more.html"))?;
    env.add_template("view.html", include_str!("../templates/view.html"))?;
    env.add_template(MARKDOWN, include_str!("../templates/page.md"))?;
    env.add_template("body.md", include_str!("../templates/body.md"))?;
    env.add_template(MARKDOWN_SECTION, include_str!("../templates/section.md"))?;
    Ok(env)
}

/// A name that a narrow column may break after underscores; a zero-width space needs no escaping.
fn breakable(text: String) -> String {
    text.replace('_', "_\u{200b}")
}

/// The text escaped for Markdown, also within a table.
fn plain(text: String) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' | '\r' => escaped.push(' '),
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' => escaped.extend(['\\', c]),
            _ => escaped.push(c),
        }
    }
    escaped
}

/// Text as Markdown code, also within a table.
fn code(text: String) -> String {
    if text.is_empty() {
        return text;
    }
    let text = text.replace(['\n', '\r'], " ").replace('|', "\\|");
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    let pad = if longest > 0 { " " } else { "" };
    format!("{fence}{pad}{text}{pad}{fence}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markdown_can_t_be_broken_by_names() {
        assert_eq!(plain("a|b_c\n<d>".to_owned()), "a\\|b\\_c \\<d\\>");
        assert_eq!(code("a|b".to_owned()), "`a\\|b`");
        assert_eq!(code("a`b".to_owned()), "`` a`b ``");
        assert_eq!(code(String::new()), "");
    }

    #[test]
    fn no_runs_make_a_page_too() {
        for page in [html(&[], &[], &[]).unwrap(), markdown(&[], &[]).unwrap()] {
            assert!(page.contains("No scene was checked."));
        }
    }
}
