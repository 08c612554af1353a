//! Terminals and icons: written as expected, read as written, and each rule finds what breaks it.

use crate::samples::pendulum_with_arrays;
use proptest::prelude::*;
use swayless_modeldesc::terminals::*;

fn member(variable: &str, name: &str) -> Member {
    Member { variable: variable.to_owned(), name: Some(name.to_owned()), kind: "signal".to_owned(), line: 0 }
}

/// Terminals of the pendulum: a bus that nests a plug, and a sequence with a stream.
fn good() -> TerminalsAndIcons {
    let area = |x1, y1, x2, y2| Area { x1, y1, x2, y2 };
    let inner = Terminal {
        name: "parts".to_owned(),
        matching_rule: "plug".to_owned(),
        members: vec![member("parts", "count")],
        ..Terminal::default()
    };
    let swing = Terminal {
        name: "swing".to_owned(),
        matching_rule: "bus".to_owned(),
        terminal_kind: Some("_maker_swing".to_owned()),
        description: Some("The \"swing\" & what makes it".to_owned()),
        members: vec![member("swing.push", "push"), member("theta", "angle")],
        terminals: vec![inner],
        graphics: Some(TerminalGraphics {
            area: area(100.0, -10.0, 120.0, 10.0),
            icon_base_name: "pictures/swing".to_owned(),
            color: Some(vec![255, 0, 7]),
            stroke_size: Some(0.5),
        }),
        ..Terminal::default()
    };
    let flow = Terminal {
        name: "flow".to_owned(),
        matching_rule: "sequence".to_owned(),
        members: vec![Member { name: None, kind: "outflow".to_owned(), ..member("swing.angle", "") }],
        streams: vec![Stream {
            in_name: "in".to_owned(),
            out_name: "out".to_owned(),
            in_variable: "swing.push".to_owned(),
            out_variable: "swing.angle".to_owned(),
            line: 0,
        }],
        ..Terminal::default()
    };
    TerminalsAndIcons {
        coordinate_system: Some(CoordinateSystem { area: area(-100.0, -100.0, 100.0, 100.0), scale_to_mm: 0.1 }),
        icon: Some(area(-90.0, -90.0, 90.0, 90.0)),
        terminals: vec![swing, flow],
    }
}

const GOLDEN: &str = include_str!("../golden/terminals.xml");

#[test]
fn terminals_are_written_as_expected() {
    let written = write(&good()).expect("good terminals");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/terminals.xml");
        std::fs::write(path, &written).expect("the source folder is writable");
    }
    assert_eq!(written, GOLDEN, "set UPDATE_GOLDEN to accept and then look at the difference");
    let (content, problems) = read_and_check(GOLDEN.as_bytes(), &pendulum_with_arrays()).unwrap();
    assert_eq!(problems, []);
    assert_eq!(without_lines(content), good());
}

fn without_lines(mut content: TerminalsAndIcons) -> TerminalsAndIcons {
    fn forget(terminals: &mut [Terminal]) {
        for terminal in terminals {
            terminal.line = 0;
            terminal.members.iter_mut().for_each(|member| member.line = 0);
            terminal.streams.iter_mut().for_each(|stream| stream.line = 0);
            forget(&mut terminal.terminals);
        }
    }
    forget(&mut content.terminals);
    content
}

/// Wants exactly one problem, with this message, after a change.
#[track_caller]
fn one(change: impl FnOnce(&mut TerminalsAndIcons), message: &str) {
    let mut content = good();
    change(&mut content);
    let problems = check(&content, &pendulum_with_arrays());
    assert_eq!(problems.len(), 1, "{message}: {problems:#?}");
    assert!(problems[0].message.contains(message), "{message}: {}", problems[0]);
}

#[test]
fn members() {
    one(
        |c| c.terminals[0].members[0].variable = "swing.shove".to_owned(),
        "`swing.shove`, which the model does not have",
    );
    one(
        |c| c.terminals[0].terminals[0].members[0].variable = "none".to_owned(),
        "terminal `parts` has the variable `none`",
    );
    one(|c| c.terminals[0].members[0].variable = "indicator".to_owned(), "is local but must be an input");
    one(|c| c.terminals[0].members[0].variable = "time".to_owned(), "is independent but must be");
    one(|c| c.terminals[0].members[1].name = Some("push".to_owned()), "has the member `push` twice");
    one(|c| c.terminals[0].members[1].name = None, "`theta` needs a `memberName`");
    one(|c| c.terminals[0].members[0].kind = "current".to_owned(), "has the kind `current`");
}

#[test]
fn names_and_rules() {
    one(|c| c.terminals[1].name = "swing".to_owned(), "the terminal `swing` is there twice");
    one(|c| c.terminals[1].name.clear(), "a terminal needs a name");
    one(|c| c.terminals[0].matching_rule = "any".to_owned(), "the matching rule `any`");
    // A rule of another standard, and the same name on another level.
    let mut content = good();
    content.terminals[0].matching_rule = "org.example.rule".to_owned();
    content.terminals[0].terminals[0].name = "swing".to_owned();
    assert_eq!(check(&content, &pendulum_with_arrays()), []);
}

#[test]
fn streams() {
    one(|c| c.terminals[1].streams[0].in_variable = "none".to_owned(), "the variable `none`");
    one(|c| c.terminals[1].streams[0].out_variable = "modes".to_owned(), "differ in size");
    one(
        |c| {
            let again = Member { variable: "swing.push".to_owned(), ..c.terminals[1].members[0].clone() };
            c.terminals[1].members.push(again);
        },
        "has streams and 2 flows",
    );
}

#[test]
fn drawings() {
    fn drawn(change: impl Fn(&mut TerminalGraphics)) -> impl Fn(&mut TerminalsAndIcons) {
        move |c| change(c.terminals[0].graphics.as_mut().expect("the sample has one"))
    }
    one(drawn(|g| g.area.x2 = g.area.x1), "the terminal `swing` is drawn in an empty area");
    one(drawn(|g| g.area.y2 = f64::NAN), "the terminal `swing` is drawn in an empty area");
    one(drawn(|g| g.area.x2 = 0.0), "is drawn flipped");
    one(drawn(|g| g.color = Some(vec![0, 256, 0])), "three numbers from 0 to 255");
    one(drawn(|g| g.color = Some(vec![0, 0])), "three numbers from 0 to 255");
    one(drawn(|g| g.stroke_size = Some(0.0)), "the stroke size 0");
    for name in ["", "/swing", "a/../../swing", "https://example.org/swing"] {
        one(drawn(move |g| g.icon_base_name = name.to_owned()), "must name a picture below");
    }
    one(|c| c.icon.iter_mut().for_each(|icon| icon.y1 = icon.y2), "the icon is drawn in an empty area");
    one(
        |c| c.coordinate_system.iter_mut().for_each(|system| system.area.x2 = -200.0),
        "from its lower left to its upper right corner",
    );
    one(
        |c| c.coordinate_system.iter_mut().for_each(|system| system.scale_to_mm = 0.0),
        "`suggestedScalingFactorTo_mm` is 0",
    );
}

#[test]
fn problems_have_the_lines_of_what_they_are_about() {
    for (from, to, message) in [
        ("name=\"swing\" matchingRule=\"bus\"", "matchingRule=\"bus\"", "needs the attribute `name`"),
        ("variableName=\"swing.push\" member", "variableName=\"swing.shove\" member", "`swing.shove`, which the model"),
        ("<Icon x1=\"-90.0\"", "<Icon x1=\"90.0\"", "the icon is drawn in an empty area"),
        ("defaultConnectionColor=\"255 0 7\"", "defaultConnectionColor=\"red\"", "must be a whole number"),
        ("suggestedScalingFactorTo_mm=\"0.1\"", "", "needs the attribute `suggestedScalingFactorTo_mm`"),
    ] {
        assert!(GOLDEN.contains(from), "{from}");
        let text = GOLDEN.replace(from, to);
        let (_, problems) = read_and_check(text.as_bytes(), &pendulum_with_arrays()).unwrap();
        let problem = problems.iter().find(|p| p.message.contains(message)).unwrap_or_else(|| panic!("{problems:?}"));
        let line = GOLDEN.lines().position(|line| line.contains(from)).unwrap() + 1;
        assert_eq!(problem.line, line, "{problem}");
    }
    let older = GOLDEN.replace("fmiVersion=\"3.0\"", "fmiVersion=\"2.0\"");
    assert!(read(&older).unwrap().1[0].message.contains("must be 3.0"));
    let empty = "<fmiTerminalsAndIcons fmiVersion='3.0'><Terminals/></fmiTerminalsAndIcons>";
    assert!(read(empty).unwrap().1[0].message.contains("needs the element `Terminal`"));
    assert!(read("<Terminals/>").unwrap_err().message.contains("must be `fmiTerminalsAndIcons`"));
}

proptest! {
    #[test]
    fn cut_documents_make_nothing_panic(at in 0..GOLDEN.len(), length in 0..60_usize) {
        let mut bytes = GOLDEN.as_bytes().to_vec();
        bytes.drain(at..(at + length).min(GOLDEN.len()));
        let _ = read_and_check(&bytes, &pendulum_with_arrays());
    }
}
