//! `swayless validate`.

use std::path::PathBuf;

use serde_json::json;
use swayless::validate::{Finding, validate};
use swayless_modeldesc::problem::Severity;

use super::{Failure, Outcome, console};

/// Check FMUs and SSP documents against their standards, without running them.
///
/// Prints all problems, each with its place. Exits with 3 when a file has errors; warnings alone do not count. A
/// system that is right by itself is checked against its FMUs, too: names, kinds, types and units.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// The .fmu, .ssd, .ssv, .ssm or .ssp files to check
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut outcome = Outcome::Done;
    let mut results = Vec::new();
    // A file that cannot be read does not keep the others from being checked.
    let mut unreadable = None;
    for path in &arguments.files {
        let findings = match validate(path) {
            Ok(findings) => findings,
            Err(error) => {
                if arguments.json {
                    results.push(json!({ "file": path, "error": error.to_string() }));
                }
                if let Some(earlier) = unreadable.replace(error) {
                    console::error(&earlier);
                }
                continue;
            }
        };
        if findings.iter().any(|f| f.problem.severity == Severity::Error) {
            outcome = Outcome::FoundProblems;
        }
        if arguments.json {
            let problems: Vec<_> = findings.iter().map(json).collect();
            results.push(json!({ "file": path, "problems": problems }));
        } else if findings.is_empty() {
            console::print(format_args!("{}: no problems", path.display()))?;
        }
        for finding in findings.iter().filter(|_| !arguments.json) {
            console::print(format_args!("{}: {finding}", path.display()))?;
        }
    }
    if arguments.json {
        console::print(format_args!("{:#}", json!(results)))?;
    }
    match (unreadable, outcome) {
        (Some(error), Outcome::Done) => Err(error.into()),
        (Some(error), outcome) => {
            console::error(&error);
            Ok(outcome)
        }
        (None, outcome) => Ok(outcome),
    }
}

fn json(finding: &Finding) -> serde_json::Value {
    let problem = &finding.problem;
    let line = (problem.line > 0).then_some(problem.line);
    json!({
        "document": finding.document, "line": line, "severity": problem.severity.to_string(), "message": problem.message,
    })
}
