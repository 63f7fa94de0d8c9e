//! A study whose type is hidden, as a list of them has it.

use std::path::Path;

use clap::{ArgMatches, Command};
use predicament_tasks::Contestant;

use crate::{Error, Host, Report, Study};

/// A study as a command line needs it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The name of its command.
    pub name: &'static str,
    /// What it asks, in one line.
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

    /// Its command, with arguments and help.
    #[must_use]
    pub fn command(&self) -> Command {
        (self.command)()
    }

    /// The study with the arguments that its [command](Entry::command) matched.
    ///
    /// # Errors
    /// Those of clap, for arguments that do not fit.
    pub fn parse(&self, matches: &ArgMatches) -> Result<Box<dyn Ready>, clap::Error> {
        (self.parse)(matches)
    }
}

fn command<S: Study>() -> Command {
    // Arguments come with the first line of their type's documentation, which is for readers of the code.
    let command = S::augment_args(Command::new(S::NAME)).about(S::ASKS).long_about(None).after_help(S::HELP);
    if S::NEEDS_FOLDER { command.mut_arg("out", |out| out.required(true)) } else { command }
}

fn parse<S: Study + 'static>(matches: &ArgMatches) -> Result<Box<dyn Ready>, clap::Error> {
    Ok(Box::new(S::from_arg_matches(matches)?))
}

/// A study with its arguments, ready to be started. Every [`Study`] is one.
pub trait Ready {
    /// As [`Study::backends`].
    fn backends(&self) -> Vec<String>;

    /// As [`Study::threads`].
    fn threads(&self) -> Option<usize>;

    /// As [`Study::out`].
    fn out(&self) -> Option<&Path>;

    /// As [`Study::report`].
    ///
    /// # Errors
    /// Those of [`Study::report`].
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
