//! The backends at a glance: what each got right and wrong over everything, and what it costs. README shows this table.

use std::collections::BTreeMap;

use super::rank;
use crate::figures::{FILE, Price, Prices, all_prices};
use crate::groups::{REFERENCE, backends};
use crate::plot::overall;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, Error, Origin, RunDir};
use predicament_records::format::{counted, factor, length, thousands};

pub fn section(runs: &[RunDir]) -> Result<Section, Error> {
    let rows = || runs.iter().flat_map(|run| &run.summary);
    let occurred: Vec<Class> = Class::ALL.into_iter().filter(|&class| rows().any(|row| row.count(class) > 0)).collect();
    let order = backends(runs);
    let mut counts: BTreeMap<usize, BTreeMap<Class, u64>> = BTreeMap::new();
    for row in rows() {
        let of = counts.entry(rank(&order, &row.backend)).or_default();
        for &class in &occurred {
            *of.entry(class).or_default() += row.count(class);
        }
    }
    let prices = all_prices(runs);
    let mut table = Table::new("")
        .words(["backend"])
        .of(Origin::of("summary.csv").keys(["backend"]))
        .numbers(occurred.iter().map(|class| class.name()));
    if prices.is_some() {
        let origin = Origin::of(FILE).keys(["backend"]).only("panel", "all");
        table = table.of(origin).numbers([format!("time / {REFERENCE}")]);
    }
    for (backend, of) in counts {
        let backend = order.get(backend).copied().unwrap_or_default();
        let classes = occurred.iter().map(|class| match of.get(class) {
            None | Some(0) => Cell::default(),
            Some(&count) => {
                Cell::from(thousands(count)).tone(if class.is_legal() { Tone::Plain } else { Tone::Notable })
            }
        });
        let time = prices.iter().map(|prices| time(prices, backend));
        table.push([Cell::code(backend)].into_iter().chain(classes).chain(time).collect());
    }
    let mut blocks = Vec::new();
    if let Some(picture) = overall(runs)? {
        let alt = "Times over the reference's against wrong answers per million, over all tasks";
        blocks.push(Block::Plot { picture, file: "overall.svg".into(), alt: alt.into() });
    }
    blocks.push(Block::table_or(table, "No scene was checked."));
    Ok(Section { id: "glance", title: "Backends at a glance", lead: lead(prices.as_ref()), blocks })
}

fn time(prices: &Prices, backend: &str) -> Cell {
    match prices.prices.iter().find(|price| price.backend == backend) {
        None => Cell::from("—").tone(Tone::Muted),
        Some(Price { ratio, is_partial: false, .. }) => factor(*ratio).into(),
        Some(Price { ratio, pairs, .. }) => {
            Cell::from(factor(*ratio)).tone(Tone::Muted).detail(format!("partial: {}", counted(length(*pairs), "pair")))
        }
    }
}

fn lead(prices: Option<&Prices>) -> String {
    let mut lead = "Answers and failed checks by class over all suites; each scene on each backend counts once. \
                    tie_broken and in_band are what a symbolic perturbation and a tolerance promise: a tie given a \
                    consistent side, and a value too small to tell."
        .to_owned();
    if let Some(Prices { pairs, of, prices }) = prices {
        let compared = prices.iter().filter(|price| !price.is_partial).count();
        lead += &format!(
            " The time is that of a query over {REFERENCE}'s in the same run: the geometric mean over the {} of task and \
             family that all {} were checked and timed on, of {} that {REFERENCE} was.",
            counted(length(*pairs), "pair"),
            counted(length(compared), "compared backend"),
            thousands(length(*of)),
        );
        if compared > 1 {
            lead += " The plot has the compared backends, with Wilson's interval at 95 % of what is wrong; those that were never wrong are at \
                     the bottom, up to what may be. What is above and to the right of the dashed line is beaten.";
        }
        if compared < prices.len() {
            lead += " A backend that did too few of them is partial: its mean is over its own pairs, and not to be compared \
                     with the others.";
        }
    }
    lead
}
