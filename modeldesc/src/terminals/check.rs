//! Checking terminals: against themselves, and against the variables they connect.

use super::{Member, Stream, Terminal, TerminalsAndIcons, graphics, read};
use crate::problem::{Problem, ReadError, Report};
use crate::types::{Causality, ModelDescription, Variable};
use crate::xml_in;
use std::collections::{HashMap, HashSet};

/// All problems of terminals and icons that belong to a model, in the order of their lines as far as they know them.
pub fn check(content: &TerminalsAndIcons, description: &ModelDescription) -> Vec<Problem> {
    let mut report = Report::default();
    check_with(content, description, &graphics::Lines::default(), &mut report);
    report.into_problems()
}

/// Reads terminals and icons from the bytes of their file and checks them: the problems of form and of meaning together,
/// in the order of the lines.
///
/// # Errors
///
/// As of [`read`](super::read), and if the bytes are not UTF-8.
pub fn read_and_check(
    bytes: &[u8],
    description: &ModelDescription,
) -> Result<(TerminalsAndIcons, Vec<Problem>), ReadError> {
    let (content, root, mut report) = read::with_root(&xml_in::decode(bytes)?)?;
    check_with(&content, description, &graphics::Lines::of(&root), &mut report);
    Ok((content, report.into_problems()))
}

fn check_with(
    content: &TerminalsAndIcons,
    description: &ModelDescription,
    lines: &graphics::Lines,
    report: &mut Report,
) {
    graphics::check(content, lines, report);
    let mut variables = HashMap::with_capacity(description.variables.len());
    for variable in &description.variables {
        variables.entry(variable.name.as_str()).or_insert(variable);
        for alias in &variable.aliases {
            variables.entry(alias.name.as_str()).or_insert(variable);
        }
    }
    siblings(&content.terminals, report);
    for terminal in content.all_terminals() {
        siblings(&terminal.terminals, report);
        matching(terminal, report);
        for member in &terminal.members {
            self::member(&variables, terminal, member, report);
        }
        streams(&variables, terminal, report);
        if let Some(graphics) = &terminal.graphics {
            graphics::terminal(graphics, &terminal.name, terminal.line, report);
        }
    }
}

/// Names are unique on each level.
fn siblings(terminals: &[Terminal], report: &mut Report) {
    let mut seen = HashSet::new();
    for terminal in terminals {
        if terminal.name.is_empty() {
            report.error(terminal.line, "a terminal needs a name");
        } else if !seen.insert(&terminal.name) {
            report.error(terminal.line, format!("the terminal `{}` is there twice; rename one of them", terminal.name));
        }
    }
}

/// The rule by which members find each other, and the names it needs.
fn matching(terminal: &Terminal, report: &mut Report) {
    let line = terminal.line;
    let (name, rule) = (&terminal.name, terminal.matching_rule.as_str());
    if !matches!(rule, "plug" | "bus" | "sequence") && !rule.contains('.') {
        report.error(
            line,
            format!(
                "the terminal `{name}` has the matching rule `{rule}`; it must be plug, bus, sequence or the rule of \
                 another standard, such as org.example.rule"
            ),
        );
    }
    let by_name = matches!(rule, "plug" | "bus");
    let mut seen = HashSet::new();
    let streams = terminal.streams.iter().flat_map(|s| [(&s.in_name, s.line), (&s.out_name, s.line)]);
    let members = terminal.members.iter().filter_map(|m| Some((m.name.as_ref()?, m.line)));
    for (member, line) in members.chain(streams) {
        if by_name && !seen.insert(member) {
            report.error(line, format!("the terminal `{name}` has the member `{member}` twice; rename one of them"));
        }
    }
    for member in terminal.members.iter().filter(|member| by_name && member.name.is_none()) {
        report.error(
            member.line,
            format!("`{}` needs a `memberName` in the terminal `{name}`, whose members match by name", member.variable),
        );
    }
}

type Variables<'a> = HashMap<&'a str, &'a Variable>;

/// A variable of a terminal; of what does not exist or cannot be connected, it says so.
fn connectable<'a>(
    variables: &Variables<'a>,
    terminal: &Terminal,
    name: &str,
    line: usize,
    report: &mut Report,
) -> Option<&'a Variable> {
    let Some(variable) = variables.get(name).copied() else {
        report.error(
            line,
            format!("the terminal `{}` has the variable `{name}`, which the model does not have", terminal.name),
        );
        return None;
    };
    let fits = matches!(
        variable.causality,
        Causality::Input | Causality::Output | Causality::Parameter | Causality::CalculatedParameter
    );
    if !fits {
        report.error(
            line,
            format!(
                "`{name}` in the terminal `{}` is {} but must be an input, an output or a parameter",
                terminal.name,
                variable.causality.as_str()
            ),
        );
    }
    Some(variable)
}

fn member(variables: &Variables<'_>, terminal: &Terminal, member: &Member, report: &mut Report) {
    match member.kind.as_str() {
        "signal" | "inflow" | "outflow" => {
            connectable(variables, terminal, &member.variable, member.line, report);
        }
        other => {
            if !variables.contains_key(member.variable.as_str()) {
                connectable(variables, terminal, &member.variable, member.line, report);
            }
            report.warning(
                member.line,
                format!(
                    "`{}` in the terminal `{}` has the kind `{other}`; the standard knows signal, inflow and outflow",
                    member.variable, terminal.name
                ),
            );
        }
    }
}

fn streams(variables: &Variables<'_>, terminal: &Terminal, report: &mut Report) {
    for Stream { in_variable, out_variable, line, .. } in &terminal.streams {
        let sides = [in_variable, out_variable].map(|name| connectable(variables, terminal, name, *line, report));
        if let [Some(inside), Some(outside)] = sides
            && inside.dimensions != outside.dimensions
        {
            report.error(
                *line,
                format!("the streams `{in_variable}` and `{out_variable}` of `{}` differ in size", terminal.name),
            );
        }
    }
    let flows = terminal.members.iter().filter(|member| matches!(member.kind.as_str(), "inflow" | "outflow")).count();
    if !terminal.streams.is_empty() && flows > 1 {
        report.error(
            terminal.line,
            format!("the terminal `{}` has streams and {flows} flows; leave it one flow", terminal.name),
        );
    }
}
