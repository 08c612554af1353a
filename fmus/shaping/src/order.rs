//! Order for short lists in little code: the general sort is 5 kB for each type, and all this is in FMUs.

/// Puts a list in ascending order; what is equal keeps its order.
pub(crate) fn order_by<T>(list: &mut [T], key: impl Fn(&T) -> f64) {
    for end in 1..list.len() {
        let mut place = end;
        while place > 0 && key(&list[place]).total_cmp(&key(&list[place - 1])).is_lt() {
            list.swap(place, place - 1);
            place -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_a_stable_sort() {
        let mut list: Vec<(f64, u32)> = (0..60).map(|n| (f64::from(n * 37 % 11) - 5.0, n)).collect();
        let mut wanted = list.clone();
        wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
        order_by(&mut list, |item| item.0);
        assert_eq!(list, wanted);
    }
}
