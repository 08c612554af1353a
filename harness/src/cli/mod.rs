//! The command line: results go to stdout, everything else to stderr.

mod build;
mod console;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Cranes as FMUs: build them, look into them, wire them together and run them.
#[derive(Debug, Parser)]
#[command(
    name = "swayless",
    version,
    max_term_width = 100,
    arg_required_else_help = true,
    after_help = "Exit codes: 0 all well, 1 a build or run failed, 2 wrong usage, 3 validation found problems.\n\
                  Results go to stdout, progress and messages to stderr."
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Build(build::Arguments),
}

/// How a command ended that did not fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Done,
}

/// What ends a command early: any error of the library.
type Failure = Box<dyn std::error::Error>;

/// Runs what the arguments ask for. Clap itself ends the process with code 2 when they are wrong.
pub fn main() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::Build(arguments) => build::run(&arguments),
    };
    match outcome {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Err(failure) => {
            console::error(failure.as_ref());
            ExitCode::from(1)
        }
    }
}
