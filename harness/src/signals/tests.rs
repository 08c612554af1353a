//! Input files, good and bad.

use proptest::prelude::*;

use super::*;

fn errors(text: &str) -> Vec<String> {
    let error = InputSignals::read("in.csv", text.as_bytes()).unwrap_err();
    error.problems().iter().map(ToString::to_string).collect()
}

#[test]
fn files_are_read_with_blanks_and_booleans() {
    let signals =
        InputSignals::read("in.csv", "\u{feff}Time, a.u ,on\r\n0, 1e-3,true\n1,-2,false\n".as_bytes()).unwrap();
    assert_eq!(signals.names, ["a.u", "on"]);
    assert_eq!(signals.times, [0.0, 1.0]);
    assert_eq!(signals.columns, [[1e-3, -2.0], [1.0, 0.0]]);
}

#[test]
fn all_errors_come_at_once_with_their_lines() {
    assert_eq!(
        errors("time,a\n0,x\n1,2,3\n\n2,inf\n1,1\n0.5,1\n"),
        [
            "in.csv:2: `a`: `x` is not a finite number, true or false",
            "in.csv:3: 3 fields where the header has 2",
            "in.csv:5: `a`: `inf` is not a finite number, true or false",
            "in.csv:7: the time 0.5 lies before 1",
        ]
    );
    assert_eq!(
        errors("t,a,a,\n0,1,1,1\n"),
        [
            "in.csv:1: the first column must be `time`, not `t`",
            "in.csv:1: the column `a` occurs twice",
            "in.csv:1: column 4 has no name",
        ]
    );
    assert_eq!(errors("time,a\n"), ["in.csv:1: there are no values"]);
    assert_eq!(errors("").len(), 1);
}

#[test]
fn values_are_interpolated_or_held() {
    let (times, column) = ([0.0, 1.0, 1.0, 3.0], [0.0, 2.0, 10.0, 20.0]);
    let mut cursor = Cursor::default();
    for (time, interpolated, held) in [
        (-1.0, 0.0, 0.0),
        (0.0, 0.0, 0.0),
        (0.5, 1.0, 0.0),
        (1.0, 10.0, 10.0),
        (2.0, 15.0, 10.0),
        (3.0, 20.0, 20.0),
        (9.0, 20.0, 20.0),
    ] {
        cursor.advance(&times, time);
        assert_eq!((cursor.interpolate(&column), cursor.hold(&column)), (interpolated, held), "{time}");
    }
}

proptest! {
    #[test]
    fn nothing_panics(text in "[time,a0-9.\\-\n\" eE+]{0,80}") {
        let _ = InputSignals::read("in.csv", text.as_bytes());
        let _ = InputSignals::read("in.csv", format!("time,a\n{text}").as_bytes());
    }

    #[test]
    fn what_is_written_is_read(rows in prop::collection::vec((0.0..10.0f64, -1e9..1e9f64), 1..20)) {
        let mut rows = rows;
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let text: String = rows.iter().map(|(time, value)| format!("{time},{value}\n")).collect();
        let signals = InputSignals::read("in.csv", format!("time,u\n{text}").as_bytes()).unwrap();
        prop_assert_eq!(signals.times.len(), rows.len());
        prop_assert!(rows.iter().zip(&signals.columns[0]).all(|(row, value)| row.1 == *value));
        let mut cursor = Cursor::default();
        let (low, high) = (-1e9, 1e9);
        for step in 0..100 {
            cursor.advance(&signals.times, f64::from(step) * 0.1);
            prop_assert!((low..=high).contains(&cursor.interpolate(&signals.columns[0])));
        }
    }
}
