//! What is printed, drawn and written, and the pages that show it.

use super::{close, json, number, shapers};
use crate::exits;

#[test]
fn impulses_are_printed() {
    let (stdout, _) = exits(&["shaper", "--hertz", "0.5", "--kind", "zvd", "--impulses"], 0);
    for row in [["1", "0.000000", "0.250000"], ["2", "1.000000", "0.500000"], ["3", "2.000000", "0.250000"]] {
        assert!(stdout.lines().any(|line| line.split_whitespace().eq(row)), "{row:?} is not in\n{stdout}");
    }
}

#[test]
fn plots_are_pictures_and_pages() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let draw = |name: &str, mode: &[&str]| {
        let (_, note) = exits(&[&["shaper", "--plot", &path(name)], mode].concat(), 0);
        assert!(note.contains(name), "{note}");
        std::fs::read_to_string(path(name)).unwrap()
    };
    let svg = draw("curves.svg", &["--length", "10", "--range", "8..12"]);
    let tree = resvg::usvg::Tree::from_str(&svg, &resvg::usvg::Options::default()).expect("a picture");
    assert_eq!((tree.size().width(), tree.size().height()), (960.0, 480.0));
    assert!(
        svg.contains("frequency (rad/s)") && svg.contains(">\nrange\n<") && svg.contains(">\nSI\n<"),
        "{svg:.2000}"
    );
    // a curve for each of ZV, ZVD, the choice and what is named beside it, and the limit; the others only on the page
    assert!(!svg.contains("ThreeHumpEI"));
    let page = draw("curves.html", &["--hertz", "1", "--hertz", "3", "--damping", "0", "--damping", "0.1"]);
    for text in ["frequency (Hz)", "ThreeHumpEI", "Shaped steps", "range of mode 2", "at damping ratio 0.1"] {
        assert!(page.contains(text), "{text}");
    }
    // each reason for itself, and what to copy into a system
    assert!(page.contains("<p class=\"note\">UMZVc is made for"), "reasons run into each other");
    assert!(page.contains("<p>InputShaper: kind = "), "no parameters");
}

#[test]
fn a_parameter_set_holds_the_recommended_shaper() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shaper.ssv");
    let file = file.to_str().unwrap();
    let answer = json(&["--length", "10", "--damping", "0.01", "--ssv", file]);
    let (stdout, _) = exits(&["validate", file], 0);
    assert!(stdout.contains("no problems"), "{stdout}");
    let choice = answer["recommendation"]["choice"].as_str().unwrap();
    let (set, _) = swayless_modeldesc::ssp::read_parameters(&std::fs::read_to_string(file).unwrap()).unwrap();
    let parameters = shapers(&answer)[choice]["parameters"].as_object().unwrap().clone();
    assert_eq!(set.parameters.len(), parameters.len());
    for parameter in set.parameters {
        let (written, said) = (parameter.value.to_string(), &parameters[&parameter.name]);
        match said.as_str() {
            Some(said) => assert_eq!(written, said),
            // the JSON is read here to a rounding only
            None => close(written.parse().unwrap(), said.as_f64().unwrap(), 1e-15),
        }
    }
}

/// Durations and widths in the table of `InputShaper`'s page are those of its shapers.
#[test]
fn the_page_of_the_shaper_tells_its_durations_and_widths() {
    let page = std::fs::read_to_string("../fmus/input-shaper/README.md").unwrap();
    let answer = json(&["--hertz", "1"]);
    let mut rows = 0;
    for (kind, shaper) in shapers(&answer) {
        let Some(row) = page.lines().find(|line| line.starts_with(&format!("| `{kind}` ("))) else { continue };
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let (Ok(duration), Ok(width)) = (cells[3].parse::<f64>(), cells[4].parse::<f64>()) else { continue };
        close(number(shaper, "/duration"), duration, 5.1e-4);
        close(number(shaper, "/modes/0/insensitivity"), width, 5.1e-4);
        rows += 1;
    }
    assert_eq!(rows, 10, "{page}");
}

/// The pages show what the command prints, to the letter.
#[test]
fn the_pages_show_true_output() {
    for page in ["../README.md", "../docs/shaper.md"] {
        let text = std::fs::read_to_string(page).unwrap();
        let shown: Vec<&str> =
            text.split("```").skip(1).step_by(2).filter(|block| block.contains("\n$ swayless shaper")).collect();
        assert!(!shown.is_empty(), "{page}");
        for block in shown {
            let (command, output) = block.split_once("$ swayless ").unwrap().1.split_once('\n').unwrap();
            let (stdout, _) = exits(&command.split_whitespace().collect::<Vec<_>>(), 0);
            let plain =
                |text: &str| text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n").trim_end().to_owned();
            assert_eq!(plain(output), plain(&stdout), "{page}: {command}");
        }
    }
}
