//! Fewer points for long curves, without losing a peak.

/// The points of a curve whose values hold: the first, the last and those where the value changes. None is lost.
pub fn changes(times: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let count = times.len().min(values.len());
    let keep = |i: &usize| *i == 0 || *i + 1 == count || values[*i].to_bits() != values[*i - 1].to_bits();
    (0..count).filter(keep).map(|i| (short(times[i]), short(values[i]))).unzip()
}

/// The points of a curve, at most about `limit` of them: from each stretch its lowest and its highest, in their order.
/// The first and the last point stay. Values that are not finite are gaps and stay too, as far as they are alone.
pub fn thin(times: &[f64], values: &[f64], limit: usize) -> (Vec<f64>, Vec<f64>) {
    let count = times.len().min(values.len());
    let mut keep: Vec<usize> = Vec::new();
    if count <= limit || limit < 4 {
        keep.extend(0..count);
    } else {
        let stretches = (limit - 2) / 2;
        keep.push(0);
        for stretch in 0..stretches {
            let inner = count - 2;
            let (from, to) = (1 + stretch * inner / stretches, 1 + (stretch + 1) * inner / stretches);
            let by_value = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
            let (lowest, highest) = ((from..to).min_by(by_value), (from..to).max_by(by_value));
            let mut both: Vec<usize> = lowest.into_iter().chain(highest).collect();
            both.sort_unstable();
            both.dedup();
            keep.extend(both);
        }
        keep.push(count - 1);
    }
    keep.into_iter().map(|i| (short(times[i]), short(values[i]))).unzip()
}

/// Six significant digits: more than a screen shows, and a third of the bytes.
fn short(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_ends_and_peaks_and_order() {
        let times: Vec<f64> = (0..10_000).map(f64::from).collect();
        let mut values = vec![0.0; 10_000];
        (values[4321], values[4322]) = (5.0, -5.0);
        let (t, v) = thin(&times, &values, 100);
        assert!(t.len() <= 100);
        assert_eq!((t[0], *t.last().unwrap()), (0.0, 9999.0));
        assert!(v.contains(&5.0) && v.contains(&-5.0));
        assert!(t.is_sorted());
    }

    #[test]
    fn keeps_every_change_of_what_holds() {
        let (t, v) = changes(&[0.0, 1.0, 2.0, 3.0, 4.0], &[1.0, 1.0, 2.0, 2.0, 2.0]);
        assert_eq!((t, v), (vec![0.0, 2.0, 4.0], vec![1.0, 2.0, 2.0]));
        assert_eq!(changes(&[], &[]), (vec![], vec![]));
    }

    #[test]
    fn leaves_short_curves_alone() {
        let (t, v) = thin(&[0.0, 1.0], &[1.0 / 3.0, f64::NAN], 100);
        assert_eq!((t, v[0]), (vec![0.0, 1.0], 0.333333));
        assert!(v[1].is_nan());
    }
}
