//! What the example of the luffing rig shows: shapers in the order of the thesis, and a boom that is too heavy when low.

use swayless::{CsvWriter, Options, System, simulate};
use swayless_modeldesc::types::FmiVersion;

use crate::packaged::{self, repository};

fn rig() -> System {
    let path = repository().join("examples/luffing-rig/SystemStructure.ssd");
    System::open_with_fmus(path, &packaged::all().folder(FmiVersion::V3)).unwrap_or_else(|error| panic!("{error}"))
}

/// The last values of some variables, with these start values.
fn ends<const N: usize>(rig: &System, starts: &[(&str, &str)], variables: [&str; N]) -> [f64; N] {
    let mut rig = rig.clone();
    starts.iter().for_each(|(name, value)| rig.set_start_value(*name, *value));
    let mut csv = CsvWriter::new("memory", Vec::new());
    let options = Options {
        step_size: Some(0.005),
        output_interval: Some(1.0),
        output_variables: variables.map(str::to_owned).to_vec(),
        ..Options::default()
    };
    simulate(&rig, &options, &mut csv).unwrap_or_else(|error| panic!("{error}"));
    let text = String::from_utf8(csv.into_inner().expect("memory")).expect("text");
    let mut rows = text.lines();
    let names: Vec<&str> = rows.next().expect("a header").split(',').collect();
    let last: Vec<&str> = rows.next_back().expect("rows").split(',').collect();
    variables.map(|variable| {
        let column = names.iter().position(|name| *name == variable).expect("a column");
        last[column].parse().unwrap_or_else(|_| f64::from(u8::from(last[column] == "true")))
    })
}

/// The order of fig. 2.15, as far as its shapers are there: over seven moves from the lower end of the range, ZV leaves
/// most, ZVD less and EI least, and all of them less than no shaper. An independent computation of the same rig with moves
/// at a constant luff rate, which here the line's speed is, finds at most 4.9, 1.8, 0.47 and 0.27 cm.
#[test]
fn shapers_leave_the_luffing_rig_with_swing_in_the_order_of_the_thesis() {
    let rig = rig();
    // 15°/s on average: moves of about 18°, 25°, … 62°.
    let durations = ["1.0", "1.5", "2.0", "2.5", "3.0", "3.5", "4.0"];
    let worst = ["None", "ZV", "ZVD", "EI"].map(|kind| {
        let left = durations.map(|duration| {
            let starts = [("luff_shaper.kind", kind), ("luff_command.duration", duration)];
            let [amplitude, length, angle, at_limit] = ends(
                &rig,
                &starts,
                ["crane.swing.amplitude", "crane.hoist.length", "crane.luff.angle", "crane.at_limit"],
            );
            assert_eq!(at_limit, 0.0, "{duration} s ends at {angle} rad");
            100.0 * amplitude * length
        });
        println!("{kind}: {left:.3?} cm");
        left.into_iter().fold(0.0, f64::max)
    });
    let [none, zv, zvd, ei] = worst;
    assert!(none > 2.0 * zv && zv > 2.0 * zvd && zvd > ei, "{worst:?} cm");
    assert!((2.5..10.0).contains(&none) && zv < 2.0 && zvd < 1.0 && ei < 0.5, "{worst:?} cm");
}

/// Thesis 4.1.2: a weak motor cannot raise the boom from where it is low, but can from where it is high, since the luff
/// line's force falls with the angle.
#[test]
fn a_boom_that_is_too_heavy_when_low_luffs_from_above() {
    let rig = rig();
    let force = |angle: &str| {
        let starts = [("crane.luff.angle", angle), ("luff_command.amplitude", "0")];
        ends(&rig, &starts, ["rigging.luff.line_force_static"])[0]
    };
    let [low, high] = ["0.2", "0.8"].map(force);
    assert!(low > 1.2 * high, "{low} N at 11°, {high} N at 46°");
    let limit = (0.5 * (low + high)).to_string();
    let [stands, luffs] = [("0.2", "crane.luff.angle"), ("0.8", "crane.luff.angle")].map(|(start, angle)| {
        let starts = [("luff_drive.force_limit", limit.as_str()), ("crane.luff.angle", start)];
        let [end, overloaded] = ends(&rig, &starts, [angle, "luff_drive.overloaded"]);
        (end - start.parse::<f64>().expect("a number"), overloaded)
    });
    println!("with {limit} N: from 11° by {:.4} rad, from 46° by {:.4} rad", stands.0, luffs.0);
    assert_eq!(stands, (0.0, 1.0));
    assert!(luffs.0 > 0.5 && luffs.1 == 0.0, "{luffs:?}");
}
