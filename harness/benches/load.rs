//! Loading an FMU, making an instance and freeing both, for every built FMU: from a folder it was unpacked to, and from
//! its archive.
//!
//! Run `swayless build` first. `SWAYLESS_FMUS` names another folder than `target/fmus`.

mod built;

use std::path::Path;

use built::{Built, built};
use divan::Bencher;
use swayless::Fmu;
use swayless::slave::Model;

fn main() {
    divan::main();
}

/// What an importer does before it initializes, and at the end.
fn life(path: &Path) {
    let fmu = Fmu::open(path).expect("an FMU of ours opens");
    drop(fmu.instantiate("bench", false).expect("an FMU of ours has an instance"));
}

#[divan::bench(args = built())]
fn unpacked(bencher: Bencher, built: &Built) {
    // It has no instance, so that it holds the folder but no library.
    let fmu = Fmu::open(&built.0).expect("an FMU of ours opens");
    bencher.bench_local(|| life(fmu.folder()));
}

#[divan::bench(args = built())]
fn archive(bencher: Bencher, built: &Built) {
    bencher.bench_local(|| life(&built.0));
}
