//! The command line: results go to stdout, everything else to stderr.

mod build;
mod console;
mod demo;
mod files;
mod info;
mod interrupt;
mod run;
mod shaper;
mod statistics;
mod validate;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Cranes as FMUs: build them, look into them, wire them together and run them.
#[derive(Debug, Parser)]
#[command(
    name = "swayless",
    version,
    max_term_width = 100,
    arg_required_else_help = true,
    after_help = "Exit codes: 0 all well, 1 a build or run failed, 2 wrong usage, 3 validation found problems,\n\
                  130 interrupted.\n\
                  Results go to stdout, progress and messages to stderr."
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Build(build::Arguments),
    Info(info::Arguments),
    Validate(validate::Arguments),
    Run(Box<run::Arguments>),
    Shaper(Box<shaper::Arguments>),
    Demo(demo::Arguments),
}

/// How a command ended that did not fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Done,
    FoundProblems,
}

/// What ends a command early: any error of the library.
type Failure = Box<dyn std::error::Error>;

const FAILED: u8 = 1;
const WRONG_USAGE: u8 = 2;
const FOUND_PROBLEMS: u8 = 3;

/// Runs what the arguments ask for. Clap itself ends the process with code 2 when they are wrong.
pub fn main() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::Build(arguments) => build::run(&arguments),
        Command::Info(arguments) => info::run(&arguments),
        Command::Validate(arguments) => validate::run(&arguments),
        Command::Run(arguments) => run::run(&arguments),
        Command::Shaper(arguments) => shaper::run(&arguments),
        Command::Demo(arguments) => demo::run(&arguments),
    };
    match outcome {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::FoundProblems) => FOUND_PROBLEMS.into(),
        // Whoever reads our output, such as `head`, has seen enough.
        Err(failure) if console::is_closed_pipe(failure.as_ref()) => ExitCode::SUCCESS,
        Err(failure) => {
            console::error(failure.as_ref());
            code(failure.as_ref()).into()
        }
    }
}

/// The exit code for a failure.
fn code(failure: &(dyn std::error::Error + 'static)) -> u8 {
    match (failure.downcast_ref::<swayless::Error>(), failure.downcast_ref()) {
        (Some(swayless::Error::Interrupted { .. }), _) => interrupt::INTERRUPTED,
        (Some(error), _) if error.is_usage() => WRONG_USAGE,
        (_, Some(swayless::package::Error::UnknownFmu { .. })) => WRONG_USAGE,
        _ => FAILED,
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        super::Cli::command().debug_assert();
    }
}
