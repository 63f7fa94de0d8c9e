//! The section of pixel maps.

use crate::table::{Block, Section};
use crate::{RunDir, data_uri};

/// None where there are no pictures.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let maps = runs.iter().flat_map(|run| &run.maps);
    let blocks: Vec<Block> = maps.map(|(name, png)| Block::Image { name: name.clone(), uri: data_uri(png) }).collect();
    (!blocks.is_empty()).then(|| Section {
        id: "maps",
        title: "Pixel maps",
        lead: "The sign at each point of a raster: red negative, yellow zero, blue positive; dark where it is wrong, \
               that is, not what the backend's promise allows."
            .to_owned(),
        blocks,
    })
}
