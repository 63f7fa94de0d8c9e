//! A study with a hidden type, for lists of studies.

use std::path::Path;

use clap::{ArgMatches, Command};
use predicament_tasks::Contestant;

use crate::{Error, Host, Report, Study};

/// A study in the form that a command line needs.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The name of the study's command.
    pub name: &'static str,
    /// The study's question, in one line.
    pub asks: &'static str,
    command: fn() -> Command,
    parse: fn(&ArgMatches) -> Result<Box<dyn Ready>, clap::Error>,
}

impl Entry {
    /// The entry of this study.
    #[must_use]
    pub const fn of<S: Study + 'static>() -> Entry {
        Entry { name: S::NAME, asks: S::ASKS, command: command::<S>, parse: parse::<S> }
    }

    /// The study's command, with arguments and help.
    #[must_use]
    pub fn command(&self) -> Command {
        (self.command)()
    }

    /// The study with the arguments that its [command](Entry::command) matched.
    ///
    /// # Errors
    /// The errors of clap, for invalid arguments.
    pub fn parse(&self, matches: &ArgMatches) -> Result<Box<dyn Ready>, clap::Error> {
        (self.parse)(matches)
    }
}

fn command<S: Study>() -> Command {
    // Clap takes the first line of the arguments' documentation, which is for readers of the code.
    let command = S::augment_args(Command::new(S::NAME)).about(S::ASKS).long_about(None).after_help(S::HELP);
    if S::NEEDS_FOLDER { command.mut_arg("out", |out| out.required(true)) } else { command }
}

fn parse<S: Study + 'static>(matches: &ArgMatches) -> Result<Box<dyn Ready>, clap::Error> {
    Ok(Box::new(S::from_arg_matches(matches)?))
}

/// A study with its arguments, ready to run; every [`Study`] implements it.
pub trait Ready {
    /// The same as [`Study::backends`].
    fn backends(&self) -> Vec<String>;

    /// The same as [`Study::threads`].
    fn threads(&self) -> Option<usize>;

    /// The same as [`Study::out`].
    fn out(&self) -> Option<&Path>;

    /// The same as [`Study::report`].
    ///
    /// # Errors
    /// The errors of [`Study::report`].
    fn report(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Report, Error>;
}

impl<S: Study> Ready for S {
    fn backends(&self) -> Vec<String> {
        Study::backends(self)
    }

    fn threads(&self) -> Option<usize> {
        Study::threads(self)
    }

    fn out(&self) -> Option<&Path> {
        Study::out(self)
    }

    fn report(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Report, Error> {
        Study::report(self, backends, host)
    }
}
