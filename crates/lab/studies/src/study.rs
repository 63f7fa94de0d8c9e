//! The structure of a study: arguments, a survey, and ways to show its results.
//!
//! The type of a study *is* its arguments, so its help, its defaults and its survey are in one place. Measuring and
//! showing are separate: rows, page, plots and suites are made from the same measurements and cannot disagree.

use std::path::Path;

use predicament_tasks::Contestant;

use crate::{Common, Error, File, Host, Report};

/// A question that is answered by measuring backends.
pub trait Study: clap::Args {
    /// The name of the command, and of the page.
    const NAME: &'static str;

    /// The study's question, in one line: the first line of the help.
    const ASKS: &'static str;

    /// A description of the method, the output, exit codes and examples: the end of the help.
    const HELP: &'static str;

    /// True if the study is refused without a folder, because its results are in its files.
    const NEEDS_FOLDER: bool = false;

    /// The type of the measurements.
    type Measured;

    /// The backends to measure, by name; empty if it needs none.
    fn backends(&self) -> Vec<String> {
        Vec::new()
    }

    /// The common arguments seed, threads and folder, if the study has them.
    fn common(&self) -> Option<&Common> {
        None
    }

    /// The number of threads to measure on; all cores if `None`.
    fn threads(&self) -> Option<usize> {
        self.common().and_then(|common| common.threads)
    }

    /// The folder for the study's files; nothing is written if `None`.
    fn out(&self) -> Option<&Path> {
        self.common().and_then(|common| common.out.as_deref())
    }

    /// Measures the backends; the result must not depend on the number of threads.
    ///
    /// `backends` has the backends that [`Study::backends`] names, in that order, each once.
    ///
    /// # Errors
    /// [`Error::Stopped`] if the host's watch says so, [`Error::Unfit`] if a backend cannot be measured.
    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Self::Measured, Error>;

    /// The rows, as CSV files.
    ///
    /// # Errors
    /// [`Error::Format`] if the rows cannot be written as CSV.
    fn rows(&self, measured: &Self::Measured) -> Result<Vec<File>, Error>;

    /// The tables, as Markdown.
    fn page(&self, measured: &Self::Measured) -> String;

    /// The plots, as SVG and PDF.
    ///
    /// # Errors
    /// [`Error::Format`] if a plot cannot be drawn.
    fn plots(&self, measured: &Self::Measured) -> Result<Vec<File>, Error> {
        let _ = measured;
        Ok(Vec::new())
    }

    /// The scenes worth keeping, as suites that `predicament run` reads.
    ///
    /// # Errors
    /// [`Error::Format`] if a suite cannot be written.
    fn suites(&self, measured: &Self::Measured) -> Result<Vec<File>, Error> {
        let _ = measured;
        Ok(Vec::new())
    }

    /// Returns true if every promise that the study tests held.
    fn holds(&self, measured: &Self::Measured) -> bool {
        let _ = measured;
        true
    }

    /// Returns true if rows are printed instead of the page.
    fn prints_rows(&self) -> bool {
        false
    }

    /// Measures the backends and makes all output.
    ///
    /// # Errors
    /// The errors of [`Study::survey`], and [`Error::Format`].
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
