//! The crate `i_overlay`, with its default grid. It knows both rules of the tool and takes all rings of an operand at once.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use predicament_engine::{Engine, Polygon, Results, Task, locked, serve};

#[derive(Default)]
struct Overlay;

impl Engine for Overlay {
    const NAME: &'static str = "i-overlay";
    const TASKS: &'static [Task] = &[Task::Overlay2d];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "i_overlay")
    }

    fn overlay2d(&self, first: &Polygon, second: &Polygon, even_odd: bool) -> Result<Results<Vec<Polygon>>, String> {
        let fill = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let result = |rule| Some(first.overlay(second, rule, fill));
        Ok(Results {
            union: result(OverlayRule::Union),
            intersection: result(OverlayRule::Intersect),
            difference: result(OverlayRule::Difference),
            symmetric_difference: result(OverlayRule::Xor),
        })
    }
}

fn main() -> std::process::ExitCode {
    serve::<Overlay>()
}
