//! What the tests share.

/// Well spread numbers in (−1, 1): the i-th point of an additive recurrence with the square roots of primes.
pub fn spread(i: usize) -> impl FnMut() -> f64 {
    let primes = [
        2.0_f64, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0, 41.0, 43.0, 47.0, 53.0, 59.0, 61.0,
        67.0, 71.0, 73.0, 79.0, 83.0, 89.0, 97.0, 101.0, 103.0, 107.0, 109.0, 113.0, 127.0, 131.0, 137.0, 139.0, 149.0,
        151.0,
    ];
    let mut next = primes.into_iter();
    move || {
        let root = next.next().expect("a number for each that is asked for").sqrt();
        2.0 * (root * (i + 1) as f64).fract() - 1.0
    }
}
