//! What a design costs, and a step of the shaper with a few and with many live impulses.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use swayless_shaping::{
    Band, CompensatedForm, Design, Kind, Mode, Ramp, Trains, compensated, convolve, design, insensitivity, limited,
    limited_insensitivity, minimum_impulse, minimum_impulse_solution, specified_insensitivity,
    specified_insensitivity_of,
};

// shows that nothing is allocated
#[global_allocator]
static ALLOCATIONS: divan::AllocProfiler = divan::AllocProfiler::system();

fn main() {
    divan::main();
}

fn mode(damping_ratio: f64) -> Mode {
    // the values are in range
    Mode::new(1.0, damping_ratio).expect("a mode")
}

#[divan::bench(args = Kind::OF_A_MODE)]
fn undamped(kind: &Kind) {
    let _ = black_box(design(black_box(*kind), black_box(mode(0.0)), black_box(0.05)));
}

#[divan::bench(args = Kind::OF_A_MODE)]
fn damped(kind: &Kind) {
    let _ = black_box(design(black_box(*kind), black_box(mode(0.1)), black_box(0.05)));
}

#[divan::bench(args = Kind::OF_A_MODE)]
fn width(bencher: Bencher<'_, '_>, kind: &Kind) {
    let shaper = design(*kind, mode(0.0), 0.05).expect("undamped designs exist");
    bencher.bench_local(|| insensitivity(black_box(&shaper), mode(0.0), black_box(0.05)));
}

fn modes(ratio: f64, damping_ratio: f64) -> [Mode; 2] {
    [1.0, ratio].map(|frequency| Mode::new(frequency, damping_ratio).expect("a mode"))
}

/// The shortest minimum-impulse shaper, and the fifth.
#[divan::bench(args = [(1, 0.0), (1, 0.01), (1, 0.1), (5, 0.0), (5, 0.01), (5, 0.1)])]
fn solution((index, damping_ratio): (usize, f64)) {
    let _ = black_box(minimum_impulse_solution(black_box(modes(3.7, damping_ratio)), black_box(index)));
}

#[divan::bench(args = [0.0, 0.01, 0.1])]
fn solutions(damping_ratio: f64) {
    let _ = black_box(minimum_impulse(black_box(modes(3.7, damping_ratio))));
}

#[divan::bench]
fn series(bencher: Bencher<'_, '_>) {
    let shapers = modes(3.7, 0.01).map(|mode| design(Kind::ZVD, mode, 0.0).expect("ZVD always exists"));
    bencher.bench_local(|| convolve(black_box(&shapers[0]), black_box(&shapers[1])));
}

/// SI for 5 % over a range of the given width, in thousandths; this one allocates.
#[divan::bench(args = [(300, 0.0), (500, 0.0), (700, 0.0), (300, 0.1), (500, 0.1), (700, 0.1)])]
fn specified((width, damping_ratio): (u32, f64)) {
    let range = Band::around(1.0, f64::from(width) * 1e-3).expect("an insensitivity in range");
    let _ = black_box(specified_insensitivity(black_box(range), black_box(damping_ratio), black_box(0.05)));
}

/// UMZVc for a drive that accelerates with the first and brakes with the second time constant, in periods.
#[divan::bench(args = [(0.05, 0.035), (0.16, 0.035), (0.035, 0.16), (1.0, 0.1)])]
fn unequal_ramps((acceleration, braking): (f64, f64)) {
    let [a, b] = [acceleration, braking].map(|share| share * mode(0.0).period());
    let _ = black_box(compensated(black_box(mode(0.0)), black_box(a), black_box(b), CompensatedForm::ExactRamp));
}

/// ALZVD and, with a vibration limit, ALEI for a bare ramp of so many periods.
#[divan::bench(args = [(0.1, 0.0, 0.0), (0.5, 0.0, 0.0), (0.8, 0.0, 0.0), (2.0, 0.0, 0.0), (0.1, 0.0, 0.05), (0.8, 0.0, 0.05), (0.8, 0.1, 0.0), (0.8, 0.1, 0.05)])]
fn acceleration_limited((periods, damping_ratio, limit): (f64, f64, f64)) {
    let mode = mode(damping_ratio);
    let ramp = Ramp::new(periods * mode.period(), 1.0).expect("a ramp");
    let _ = black_box(limited(black_box(mode), black_box(ramp), black_box(limit)));
}

/// SI for 5 % over ±20 % around two frequencies with the given ratio; allocates, too.
#[divan::bench(args = [(4, 0.0), (20, 0.0), (4, 0.01), (20, 0.01)], sample_count = 10, sample_size = 1)]
fn ranges((ratio, damping_ratio): (u32, f64)) {
    let range = |frequency| (Band::around(frequency, 0.4).expect("an insensitivity in range"), damping_ratio);
    let _ = black_box(specified_insensitivity_of(black_box(&[range(1.0), range(f64::from(ratio))]), black_box(0.05)));
}

/// ALSI for 5 % over a range of the given width, in thousandths, for a bare ramp of so many periods; this one allocates.
#[divan::bench(args = [(300, 0.3, 0.0), (300, 0.8, 0.0), (500, 0.3, 0.0), (500, 0.8, 0.0), (300, 0.8, 0.02)], sample_count = 10)]
fn limited_range((width, periods, damping_ratio): (u32, f64, f64)) {
    let range = Band::around(1.0, f64::from(width) * 1e-3).expect("an insensitivity in range");
    let ramp = Ramp::new(periods * mode(0.0).period(), 1.0).expect("a ramp");
    let _ =
        black_box(limited_insensitivity(black_box(range), black_box(damping_ratio), black_box(ramp), black_box(0.05)));
}

/// A ramp sampled every step, so that each step spawns a train and as many impulses are due; per step.
#[divan::bench(args = [1, 10, 100, 1000, 10_000])]
fn ramp(bencher: Bencher<'_, '_>, live: u32) {
    const STEPS: u32 = 100;
    let zv = Design::from(design(Kind::ZV, mode(0.0), 0.05).expect("undamped designs exist"));
    let step = zv.duration() / f64::from(live);
    let mut trains = Trains::new(0.0, live as usize + 8);
    let mut n = 0;
    let mut ramp = move || {
        for _ in 0..STEPS {
            n += 1;
            let time = f64::from(n) * step;
            trains.set_command(time, black_box(time), &zv);
        }
        trains.value()
    };
    for _ in 0..=live / STEPS {
        ramp();
    }
    bencher.counter(ItemsCount::new(STEPS)).bench_local(ramp);
}

/// A step during which nothing happens, with a train pending.
#[divan::bench]
fn idle(bencher: Bencher<'_, '_>) {
    let zv = design(Kind::ZV, mode(0.0), 0.05).expect("undamped designs exist");
    let mut trains = Trains::new(0.0, 8);
    trains.set_command(0.0, 1.0, &zv.into());
    bencher.bench_local(|| black_box(&mut trains).advance(black_box(1.0)));
}
