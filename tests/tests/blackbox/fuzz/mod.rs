//! Fuzz tests: whatever is asked of an FMU, in whatever order, it answers within the rules, and the host lives.
//!
//! Seeds are fixed and times bounded. For a longer run, see `tests/README.md`.

mod call;
mod callbacks;
mod documents;
mod host2;
mod host3;
mod library;
mod memory;
mod player;
mod rules;
mod script;
mod sequences;
mod states;

use std::sync::LazyLock;

use library::Subject;
use proptest::test_runner::{Config, RngSeed};

use crate::packaged;

/// A number from the environment.
fn setting(name: &str) -> Option<u64> {
    std::env::var(name).ok().map(|text| text.parse().unwrap_or_else(|_| panic!("{name}={text} is not a number")))
}

/// So many cases, of always the same seed; more of them, or others, if the environment says so.
fn config(cases: u32) -> Config {
    let times = setting("SWAYLESS_FUZZ_TIMES").unwrap_or(1);
    Config {
        cases: cases.saturating_mul(u32::try_from(times).unwrap_or(u32::MAX)),
        rng_seed: RngSeed::Fixed(setting("SWAYLESS_FUZZ_SEED").unwrap_or(1)),
        failure_persistence: None,
        max_shrink_iters: 20_000,
        max_shrink_time: 60_000,
        ..Config::default()
    }
}

/// Every FMU with its library loaded.
fn subjects() -> &'static [Subject] {
    static SUBJECTS: LazyLock<Vec<Subject>> = LazyLock::new(|| {
        let given = std::env::var_os(memory::ARCHIVES).map(|paths| std::env::split_paths(&paths).collect());
        given.unwrap_or_else(packaged::paths).iter().map(|path| Subject::load(path)).collect()
    });
    &SUBJECTS
}
