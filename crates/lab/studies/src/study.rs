//! The shape of a study: arguments, a survey, and ways to show what it found.
//!
//! The type of a study *is* its arguments, so its help, its defaults and its
//! survey stand in one place. Measuring and showing are apart: rows, page,
//! plots and suites are made of the same measurements and cannot disagree.

use std::path::Path;

use predicament_tasks::Contestant;

use crate::{Common, Error, File, Host, Report};

/// A question that is answered by measuring backends.
pub trait Study: clap::Args {
    /// The name of the command, and of the page.
    const NAME: &'static str;

    /// What it asks, in one line: the first line of the help.
    const ASKS: &'static str;

    /// What it does, what it writes, its exit codes and examples: the end of the help.
    const HELP: &'static str;

    /// Whether it is refused without a folder: what it finds is in its files.
    const NEEDS_FOLDER: bool = false;

    /// What was measured.
    type Measured;

    /// The backends that it is given, by name; none if it asks none.
    fn backends(&self) -> Vec<String> {
        Vec::new()
    }

    /// Seed, threads and folder, where it has those that studies have in common.
    fn common(&self) -> Option<&Common> {
        None
    }

    /// Threads to measure on; all cores if `None`.
    fn threads(&self) -> Option<usize> {
        self.common().and_then(|common| common.threads)
    }

    /// The folder that its files go to; nothing is written if `None`.
    fn out(&self) -> Option<&Path> {
        self.common().and_then(|common| common.out.as_deref())
    }

    /// Measures. The result must not depend on the number of threads.
    ///
    /// `backends` are those of [`Study::backends`], in that order, each once.
    ///
    /// # Errors
    /// [`Error::Stopped`] where the host's watch says so, [`Error::Unfit`]
    /// where a backend cannot be measured.
    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Self::Measured, Error>;

    /// The rows, as CSV files.
    ///
    /// # Errors
    /// [`Error::Format`].
    fn rows(&self, measured: &Self::Measured) -> Result<Vec<File>, Error>;

    /// The tables, as Markdown.
    fn page(&self, measured: &Self::Measured) -> String;

    /// Plots, as SVG and PDF.
    ///
    /// # Errors
    /// [`Error::Format`].
    fn plots(&self, measured: &Self::Measured) -> Result<Vec<File>, Error> {
        let _ = measured;
        Ok(Vec::new())
    }

    /// Scenes worth keeping, as suites that `predicament run` reads.
    ///
    /// # Errors
    /// [`Error::Format`].
    fn suites(&self, measured: &Self::Measured) -> Result<Vec<File>, Error> {
        let _ = measured;
        Ok(Vec::new())
    }

    /// Whether every promise held that the study is about.
    fn holds(&self, measured: &Self::Measured) -> bool {
        let _ = measured;
        true
    }

    /// Whether rows are printed in place of the page.
    fn prints_rows(&self) -> bool {
        false
    }

    /// Measures and shows everything.
    ///
    /// # Errors
    /// Those of [`Study::survey`], and [`Error::Format`].
    fn report(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Report, Error> {
        let measured = self.survey(backends, host)?;
        let (rows, page) = (self.rows(&measured)?, self.page(&measured));
        let printed = if self.prints_rows() { rows.iter().map(File::text).collect() } else { page.clone() };
        let page = File::new(format!("{}.md", Self::NAME), page);
        let (plots, suites) = (self.plots(&measured)?, self.suites(&measured)?);
        let files = rows.into_iter().chain([page]).chain(plots).chain(suites).collect();
        Ok(Report { printed, files, holds: self.holds(&measured) })
    }
}
