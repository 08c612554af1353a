//! The names of variables: unique, and of the grammar that the description promises.

use super::Scope;
use crate::problem::Report;
use crate::types::*;
use std::collections::HashMap;

pub(super) fn check(scope: &Scope<'_>, report: &mut Report) {
    let convention = scope.description.variable_naming_convention;
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for variable in &scope.description.variables {
        let aliases = variable.aliases.iter().map(|alias| alias.name.as_str());
        for name in std::iter::once(variable.name.as_str()).chain(aliases) {
            if let Some(first) = seen.insert(name, variable.line) {
                let place = if first > 0 { format!(", first in line {first}") } else { String::new() };
                report.error(variable.line, format!("the name `{name}` is there twice{place}; rename one of them"));
            }
            if name.is_empty() {
                report.error(variable.line, "a variable needs a name");
                continue;
            }
            match convention {
                NamingConvention::Flat if name.contains(['\r', '\n', '\t']) => {
                    report.error(variable.line, format!("the name {name:?} contains a line break or a tab"));
                }
                NamingConvention::Structured if !is_structured(name) => report.error(
                    variable.line,
                    format!(
                        "`{name}` is not a structured name such as `a.b[1].c` or `der(x)`; put other characters into \
                         '…', or set variableNamingConvention to flat"
                    ),
                ),
                _ => {}
            }
        }
    }
}

/// The grammar of structured names (FMI 2.0.5 section 2.2.9, FMI 3.0.2 section 2.4.7.5.1).
pub(super) fn is_structured(name: &str) -> bool {
    match name.strip_prefix("der(") {
        // `der` may also be the whole or the begin of a plain name, but a parenthesis may not be in one.
        Some(rest) => rest.strip_suffix(')').is_some_and(|inside| {
            identifier(inside) == Some("") || {
                let order = inside.rsplit_once(',');
                order.is_some_and(|(inside, order)| identifier(inside) == Some("") && is_number(order))
            }
        }),
        None => identifier(name) == Some(""),
    }
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// Takes an identifier from the front; what is left.
fn identifier(mut rest: &str) -> Option<&str> {
    loop {
        rest = part(rest)?;
        if let Some(indices) = rest.strip_prefix('[') {
            let (inside, after) = indices.split_once(']')?;
            if !inside.split(',').all(is_number) {
                return None;
            }
            rest = after;
        }
        match rest.strip_prefix('.') {
            Some(after) => rest = after,
            None => return Some(rest),
        }
    }
}

/// Takes one name between dots from the front; what is left.
fn part(text: &str) -> Option<&str> {
    if let Some(quoted) = text.strip_prefix('\'') {
        let mut characters = quoted.char_indices();
        while let Some((at, c)) = characters.next() {
            match c {
                '\'' if at > 0 => return Some(&quoted[at + 1..]),
                '\\' => {
                    let (_, escaped) = characters.next()?;
                    if !"'\"?\\abfnrtv".contains(escaped) {
                        return None;
                    }
                }
                c if c.is_ascii_alphanumeric() || "_!#$%&()*+,-./:;<>=?@[]^{}|~ ".contains(c) => {}
                _ => return None,
            }
        }
        return None;
    }
    let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(text.len());
    let starts = text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    starts.then(|| &text[end..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn structured_names_follow_the_grammar() {
        for good in [
            "vehicle.engine.speed",
            "resistor12.u",
            "v_min",
            "robot.axis.'motor #234'",
            "der(pipe[3,4].T[14],2)",
            "der(x)",
            "der",
            "derived.x",
            "a[1]",
            "_",
            r"'\''",
            "der('a,b')",
        ] {
            assert!(is_structured(good), "{good}");
        }
        for bad in [
            "",
            "1a",
            "a.",
            ".a",
            "a..b",
            "a b",
            "a[]",
            "a[1",
            "a[1,]",
            "a[x]",
            "a[1][2]",
            "der(x",
            "der()",
            "der(x,)",
            "der(der(x))",
            "'",
            "''",
            "'a",
            r"'\z'",
            "ä",
            "'ä'",
            "a'b'",
            "a-b",
            "der(x).y",
        ] {
            assert!(!is_structured(bad), "{bad}");
        }
    }
}
