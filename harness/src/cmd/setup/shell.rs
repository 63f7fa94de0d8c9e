//! `completions` and `man`: for shells and for `man`, made from the command line itself.

use std::path::PathBuf;

use clap::Command;
use clap_complete::Shell;
use predicament_records::replace;

use crate::exit::{self, Failure};
use crate::layout::of_pages;
use crate::names::page;

const EXAMPLES: &str = "\
Examples:
  predicament setup completions bash > ~/.local/share/bash-completion/completions/predicament
  predicament setup completions zsh > ~/.zfunc/_predicament
  predicament setup completions fish > ~/.config/fish/completions/predicament.fish";

const MAN_EXAMPLES: &str = "\
Examples:
  predicament setup man --out ~/.local/share/man/man1 && man predicament-run
  predicament setup man --format md    the page docs/COMMANDS.md";

/// Print completions for a shell
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Completions {
    /// The shell
    pub shell: Shell,
}

/// Write manual pages, one for each command
#[derive(clap::Args)]
#[command(after_help = MAN_EXAMPLES)]
pub struct Man {
    /// The folder for manual pages, which is made if it does not exist
    #[arg(long, value_name = "DIR", required_unless_present = "format")]
    pub out: Option<PathBuf>,

    /// Print one page with the help of every command
    #[arg(long, value_enum, conflicts_with = "out")]
    pub format: Option<Format>,
}

/// The format of the page that is printed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Format {
    /// Markdown.
    Md,
}

/// Prints completions.
pub fn completions(args: &Completions, mut command: Command) -> exit::Outcome {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut command, crate::out::program(), &mut text);
    say_text!("{}", String::from_utf8_lossy(&text));
    Ok(exit::OK)
}

/// Writes manual pages, or prints the page of all commands.
pub fn man(args: &Man, mut command: Command) -> exit::Outcome {
    let Some(folder) = &args.out else {
        let mut command = of_pages(command);
        command.build();
        say_text!("{}", page(&command));
        return Ok(exit::OK);
    };
    command.build();
    let failed = |error| Failure::io(folder)(error);
    std::fs::create_dir_all(folder).map_err(failed)?;
    let mut left = vec![(crate::out::program(), command)];
    while let Some((name, command)) = left.pop() {
        let of_parts = command.get_subcommands().filter(|part| part.get_name() != "help");
        left.extend(of_parts.map(|part| (format!("{name}-{}", part.get_name()), part.clone())));
        let mut page = Vec::new();
        // Names of commands live as long as the program, which ends after this.
        let title: &'static str = Box::leak(name.clone().into_boxed_str());
        clap_mangen::Man::new(command.name(title)).render(&mut page).map_err(failed)?;
        let path = folder.join(format!("{name}.1"));
        replace(&path, &page).map_err(Failure::usage)?;
        say!("{}", path.display());
    }
    Ok(exit::OK)
}
