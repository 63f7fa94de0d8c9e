//! The derived error bounds and the decided constraints of the tolerance scheme, as a page and as a table.

mod page;
mod table;

use clap::ValueEnum;
use predicament_tasks::Contestant;

use crate::{Error, File, Host, Study};

/// The error bounds and constraints of the tolerance scheme.
#[derive(clap::Args)]
pub struct Bounds {
    /// Markdown, or one CSV table
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,
}

/// The printed format.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Format {
    /// A CSV table.
    Csv,
    /// A Markdown page.
    Md,
}

impl Study for Bounds {
    const NAME: &'static str = "bounds";
    const ASKS: &'static str = "Derive every error bound and decide every constraint of the tolerance scheme";
    const HELP: &'static str = "\
The quantities of sections 4 and 5 of \"Robust Intersections under Floating Point\" run on numbers that carry their error bound. The \
results stand beside the published figures. Constraints are decided in rational arithmetic.

Examples:
  predicament study bounds                              the page docs/BOUNDS.md
  predicament study bounds --format csv > bounds.csv    one row per bound, and per constraint and epsilon";

    type Measured = ();

    fn survey(&self, _: &[&dyn Contestant], host: &dyn Host) -> Result<(), Error> {
        host.begin(1, "derivations");
        Ok(host.watch().done(1)?)
    }

    fn rows(&self, (): &()) -> Result<Vec<File>, Error> {
        Ok(vec![File::new("bounds.csv", table::csv().map_err(Error::format)?)])
    }

    fn page(&self, (): &()) -> String {
        page::page()
    }

    fn prints_rows(&self) -> bool {
        self.format == Format::Csv
    }
}
