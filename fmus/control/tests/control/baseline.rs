//! The simulated crane with plain feedback of a swing that is seen at once, against an independent simulation.

use swayless_control::*;
use swayless_shaping::Trains;

use crate::plant::{DAMPING, FREQUENCY, Plant};
use crate::poles::reference;

const STEP: f64 = 0.002;

/// Plain feedback with gain `k`, limited to ±0.2 m/s, on a command. The hook's displacement L θ (m) over time, and the trolley.
fn run(mut plant: Plant, k: f64, until: f64, mut command: impl FnMut(f64) -> f64) -> (Vec<f64>, f64) {
    let mut course = Vec::new();
    for i in 0..(until / STEP) as usize {
        course.push(plant.hoist * plant.swing());
        let feedback = (k * plant.swing()).clamp(-0.2, 0.2);
        plant.step(command(i as f64 * STEP) + feedback, STEP);
    }
    (course, plant.trolley())
}

/// The greatest displacement (mm) in the time from `from` on for `during` (s).
fn greatest(course: &[f64], from: f64, during: f64) -> f64 {
    let index = |time: f64| (time / STEP) as usize;
    1e3 * course[index(from)..index(from + during)].iter().fold(0.0, |most: f64, u| most.max(u.abs()))
}

/// To 2 %: the reference takes the envelope from a window of its own.
#[test]
fn a_push_decays_as_in_the_reference() {
    for k in ["0", "1", "2", "3"] {
        let wanted = &reference()["push"][k];
        let (course, drift) = run(Plant::new(0.1), k.parse().expect("a gain"), 50.0, |_| 0.0);
        let found = [0.0, 10.0, 20.0, 40.0].map(|time| greatest(&course, time, 6.11));
        println!("k = {k}: {found:.1?} mm, {drift:.4} m for {wanted}");
        for (i, found) in found.iter().enumerate() {
            let wanted = wanted["envelope"][i].as_f64().expect("a number");
            assert!((found - wanted).abs() < 0.02 * wanted.max(50.0), "k = {k}: {found} mm for {wanted} mm");
        }
    }
}

/// Commands through no shaper and through the one for the closed loop's poles. To 10 %: from when to when the reference looks
/// for what is left is not known.
#[test]
fn shaped_commands_leave_as_little_as_in_the_reference() {
    let crane = Crane {
        pendulum: Pendulum { gravity: 9.81, hoist: 8.0, rigging: 3.0, mass_ratio: 0.5 },
        drive: Drive { natural_frequency: FREQUENCY, damping_ratio: DAMPING },
    };
    for (name, end) in [("step 0.6 m/s", f64::INFINITY), ("pulse 0.6 m/s 6 s", 6.0), ("pulse 3 s", 3.0)] {
        for (k, shaped, way) in [
            (0.0, false, "no control"),
            (0.0, true, "IS(ZVxZV)"),
            (2.0, false, "feedback only k=2"),
            (2.0, true, "IS(closed loop)+feedback"),
        ] {
            let modes = closed_loop(&crane, Feedback { sway_gain: k, ..Feedback::default() }).expect("poles").modes();
            let shaper = zero_vibration(if shaped { modes.expect("modes") } else { [None; 2] }).into();
            let mut trains = Trains::new(0.0, 64);
            let (course, _) = run(Plant::new(0.0), k, 60.0, |time| {
                trains.set_command(time, if time < end { 0.6 } else { 0.0 }, &shaper)
            });
            let wanted = reference()["commands"][format!("{name} | {way}")]["hook resid [mm]"].as_f64();
            let (found, wanted) = (greatest(&course, 36.0, 9.0), wanted.expect("a number"));
            println!("{name}, {way}: {found:.2} mm for {wanted:.2} mm");
            assert!((found - wanted).abs() < 0.1 * wanted + 0.2, "{name}, {way}: {found} mm for {wanted} mm");
        }
    }
}
