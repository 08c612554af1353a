//! Noise: normal, of independent numbers, and the same from the same seed.

use swayless_sensing::Noise;

const DRAWS: usize = 200_000;
/// How many standard deviations a statistic may be off: with these seeds they are within 3, and one in 15 000 would not be
/// within 4 by chance.
const FAR: f64 = 4.0;

fn draws(seed: u64) -> Vec<f64> {
    let mut noise = Noise::new(seed);
    (0..DRAWS).map(|_| noise.draw()).collect()
}

/// The mean of products: 0 for independent numbers, with a standard deviation of 1/√n.
#[track_caller]
fn uncorrelated(pairs: impl Iterator<Item = (f64, f64)>, what: &str) {
    let (mut sum, mut count) = (0.0, 0.0_f64);
    pairs.for_each(|(a, b)| (sum, count) = (sum + a * b, count + 1.0));
    assert!((sum / count).abs() * count.sqrt() < FAR, "{what}: {} of {count}", sum / count);
}

#[test]
fn mean_deviation_and_higher_moments_are_those_of_the_normal_distribution() {
    for seed in [0, 1, 2, u64::MAX] {
        let draws = draws(seed);
        let n = DRAWS as f64;
        let moment = |power| draws.iter().map(|z| z.powi(power)).sum::<f64>() / n;
        // E z^k, and the variance of z^k, E z^2k − (E z^k)².
        for (power, wanted, variance) in [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)] {
            let off = (moment(power) - wanted) / (variance / n).sqrt();
            assert!(off.abs() < FAR, "seed {seed}, moment {power}: {off} standard deviations off");
        }
        // As many as there should be within 1, 2 and 3 standard deviations.
        for (within, share) in [(1.0, 0.682_689_492), (2.0, 0.954_499_736), (3.0, 0.997_300_204)] {
            let found = draws.iter().filter(|z| z.abs() <= within).count() as f64 / n;
            assert!(
                (found - share).abs() < FAR * (share * (1.0 - share) / n).sqrt(),
                "seed {seed}: {found} in {within}"
            );
        }
    }
}

/// A camera draws two numbers for each image.
#[test]
fn axes_samples_and_seeds_are_independent() {
    let (one, two) = (draws(1), draws(2));
    uncorrelated(one.chunks(2).map(|pair| (pair[0], pair[1])), "axes");
    for lag in 1..=8 {
        uncorrelated(one.iter().zip(&one[lag..]).map(|(a, b)| (*a, *b)), "samples");
    }
    uncorrelated(one.iter().zip(&two).map(|(a, b)| (*a, *b)), "seeds");
    // Nor do large numbers come together.
    uncorrelated(
        one.chunks(2).map(|pair| ((pair[0].powi(2) - 1.0) / 2.0_f64.sqrt(), (pair[1].powi(2) - 1.0) / 2.0_f64.sqrt())),
        "squares",
    );
}

#[test]
fn the_same_seed_gives_the_same_noise_and_another_seed_another() {
    assert_eq!(draws(7), draws(7));
    let (a, b) = (draws(7), draws(8));
    assert!(a.iter().zip(&b).filter(|(a, b)| a == b).count() < 3);
    // What users have recorded with a seed stays what it was.
    assert_eq!(a[..3], [-0.2005072035939801, -2.37663654534448, 2.764670237067689]);
}

#[test]
fn a_saved_source_goes_on_with_the_same_noise() {
    let mut noise = Noise::new(3);
    for _ in 0..17 {
        noise.draw();
    }
    let bytes = postcard::to_allocvec(&noise).unwrap();
    let mut restored: Noise = postcard::from_bytes(&bytes).unwrap();
    assert!((0..1000).all(|_| noise.draw().to_bits() == restored.draw().to_bits()));
}

#[test]
fn no_state_of_the_generator_is_one_that_it_cannot_leave() {
    for state in [0_u64, 1, u64::MAX, 0x61C8_8646_80B5_83EB] {
        let mut noise: Noise = postcard::from_bytes(&postcard::to_allocvec(&state).unwrap()).unwrap();
        let draws: Vec<f64> = (0..1000).map(|_| noise.draw()).collect();
        assert!(
            draws.iter().all(|z| z.abs() < 6.0) && draws.iter().any(|z| *z > 1.0) && draws.iter().any(|z| *z < -1.0)
        );
    }
}
