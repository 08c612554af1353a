//! Quantised values: multiples of the step, and no other is nearer.

use proptest::prelude::*;
use swayless_sensing::quantise;

proptest! {
    #[test]
    fn no_other_multiple_is_nearer(value in -1e6..1e6_f64, exponent in -9.0..6.0_f64) {
        let step = 10.0_f64.powf(exponent);
        let rounded = quantise(value, step);
        // Beyond half a step, only what a number of that size can be off by.
        prop_assert!((rounded - value).abs() <= 0.5 * step + 2.0 * f64::EPSILON * value.abs());
        let steps = rounded / step;
        prop_assert!((steps - steps.round()).abs() <= 2.0 * f64::EPSILON * steps.abs());
        prop_assert!(quantise(value + step, step) >= rounded);
    }

    #[test]
    fn any_finite_value_and_step_give_a_finite_value(
        value in any::<f64>().prop_filter("finite", |value| value.is_finite()),
        step in any::<f64>().prop_filter("a step", |step| step.is_finite()),
    ) {
        let step = step.abs();
        let rounded = quantise(value, step);
        prop_assert!(rounded.is_finite() && (rounded - value).abs() <= 0.5 * step + 2.0 * f64::EPSILON * value.abs());
    }
}

#[test]
fn without_a_step_nothing_is_rounded_and_nothing_has_no_sign() {
    for value in [0.0, 1.25, -3.7e-300, f64::MAX, f64::MIN_POSITIVE] {
        assert_eq!(quantise(value, 0.0), value);
        assert_eq!(quantise(value, 5e-324), value);
    }
    assert!(quantise(-0.2, 1.0).is_sign_positive() && quantise(-0.2, 1.0) == 0.0);
    assert_eq!((quantise(0.5, 1.0), quantise(-0.5, 1.0), quantise(1.4996, 0.001)), (1.0, -1.0, 1.5));
}
