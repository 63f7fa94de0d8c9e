//! The section of pixel maps.

use crate::table::{Block, Section};
use crate::{RunDir, data_uri};

/// The section, or `None` if there are no pictures.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let mut maps: Vec<(String, &[u8])> =
        runs.iter().flat_map(|run| run.maps.iter().map(|(name, png)| (run.map_title(name), png.as_slice()))).collect();
    maps.sort_unstable();
    let blocks: Vec<Block> = maps.into_iter().map(|(name, png)| Block::Image { name, uri: data_uri(png) }).collect();
    (!blocks.is_empty()).then(|| Section {
        id: "maps",
        title: "Pixel maps",
        lead: "The sign at each point of a raster: red negative, yellow zero, blue positive. Dark pixels are wrong: \
               the backend's promise does not allow them."
            .to_owned(),
        blocks,
    })
}
