//! The pages of a scoreboard in HTML, with the tables of reports: the same figures as in Markdown.

use std::collections::BTreeSet;

use predicament_report::{Block, Cell, Section, Table, Tone, plain_html};

use super::figures::{Board, Grade};
use super::page::{KEY, LEAD, brief, count, figures, reference};
use super::smallest::Shown;
use crate::exit::Failure;

/// The index: a table of all libraries and tasks.
pub fn index(board: &Board) -> Result<String, Failure> {
    let names: BTreeSet<&String> = board.tasks.values().flat_map(|task| task.keys()).collect();
    let tasks: Vec<&String> = board.tasks.keys().collect();
    let mut table = Table::new("Right scenes of those that were answered").words(["library"]).numbers(tasks.clone());
    for name in names {
        let cells = tasks.iter().map(|task| Cell::from(board.tasks[*task].get(name).map_or_else(String::new, count)));
        table.push([Cell::code(name.as_str())].into_iter().chain(cells).collect());
    }
    let section = section("tasks", "All tasks", LEAD, vec![Block::Table(table)]);
    let links: Vec<[String; 2]> = tasks.iter().map(|task| [(*task).clone(), format!("{task}.html")]).collect();
    plain_html("Scoreboard", &links, &[section]).map_err(Failure::usage)
}

/// The page of one task; `shown` are the smallest scenes of its cells.
pub fn page(board: &Board, task: &str, shown: &[Shown]) -> Result<String, Failure> {
    let Some(rows) = board.tasks.get(task) else { return Ok(String::new()) };
    let reference = reference(board, task);
    let of = reference.as_ref().and_then(|name| rows.get(name));
    let (heads, lines) = figures(rows, reference.as_deref(), of);
    let mut libraries = Table::new("Scenes of each library").words(["library"]).numbers(heads);
    for (name, cells) in lines {
        libraries.push([Cell::code(name)].into_iter().chain(cells.into_iter().map(Cell::from)).collect());
    }
    let suites: BTreeSet<&String> = rows.values().flat_map(|row| row.suites.keys()).collect();
    let mut by_suite = Table::new("Right scenes of all, then what else there is")
        .words(["library"].into_iter().map(str::to_owned).chain(suites.iter().map(|suite| (*suite).clone())));
    for (name, row) in rows {
        let cells = suites.iter().map(|suite| {
            let Some(cell) = row.suites.get(*suite) else { return Cell::default() };
            let is_right = cell.count(Grade::Right) == cell.total();
            Cell::from(brief(cell)).tone(if is_right { Tone::Good } else { Tone::Plain })
        });
        by_suite.push([Cell::code(name.as_str())].into_iter().chain(cells).collect());
    }
    let mut sections = vec![
        section("libraries", "Libraries", KEY, vec![Block::Table(libraries)]),
        section("suites", "By suite", "", vec![Block::Table(by_suite)]),
    ];
    let mut smallest = Vec::new();
    for Shown { library, grade, scene, got, suite, picture, command } in shown {
        smallest.push(Block::Note(format!("{library}: {}, {scene}. {got}", grade.name()), Tone::Plain));
        smallest.extend(picture.iter().map(|path| Block::Image { name: scene.clone(), uri: path.clone() }));
        smallest.extend(suite.iter().map(|path| Block::Note(format!("The scene as a suite: {path}"), Tone::Muted)));
        smallest.push(Block::Command(command.clone()));
    }
    if !smallest.is_empty() {
        sections.push(section("smallest", "The smallest scene of each kind", "", smallest));
    }
    let links = [["all tasks".to_owned(), "index.html".to_owned()]];
    plain_html(task, &links, &sections).map_err(Failure::usage)
}

fn section(id: &'static str, title: &'static str, lead: &str, blocks: Vec<Block>) -> Section {
    Section { id, title, lead: lead.to_owned(), blocks }
}
