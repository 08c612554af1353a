//! Any value, type and attribute that a description can have.

use proptest::prelude::*;
use proptest::sample::select;
use swayless_modeldesc::types::*;

/// Any text that XML can hold, with its special characters more often than by chance.
pub fn text() -> impl Strategy<Value = String> {
    let character = prop_oneof![
        4 => select(vec!['a', 'ß', '😀', '<', '>', '&', '"', '\'', '\n', '\t', '\r', ' ', ';', ']']),
        1 => any::<char>().prop_filter("legal in XML", |c| {
            !matches!(*c, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}')
        }),
    ];
    prop::collection::vec(character, 0..8).prop_map(String::from_iter)
}

pub fn maybe_text() -> impl Strategy<Value = Option<String>> {
    prop::option::of(text())
}

/// Any number; what is not a number is not equal to itself.
pub fn number() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("comparable", |value| !value.is_nan())
}

/// A whole number that a float holds exactly, in the range of a type.
fn whole(data_type: DataType, version: FmiVersion) -> impl Strategy<Value = i64> {
    const EXACT: i128 = 1 << 53;
    let (least, greatest) = data_type.integer_range(version).unwrap_or((0, 0));
    let clamp = |value: i128| i64::try_from(value.clamp(-EXACT, EXACT)).unwrap_or_default();
    clamp(least)..=clamp(greatest)
}

pub fn data_type(version: FmiVersion) -> impl Strategy<Value = DataType> {
    use DataType::*;
    select(match version {
        FmiVersion::V2 => vec![Float64, Int32, Boolean, String, Enumeration],
        FmiVersion::V3 => vec![
            Float32,
            Float64,
            Int8,
            UInt8,
            Int16,
            UInt16,
            Int32,
            UInt32,
            Int64,
            UInt64,
            Boolean,
            String,
            Binary,
            Enumeration,
            Clock,
        ],
    })
}

/// Attributes that a type has.
pub fn attributes(data_type: DataType, version: FmiVersion) -> BoxedStrategy<Attributes> {
    if data_type.is_float() {
        let option = || prop::option::of(number());
        (maybe_text(), maybe_text(), maybe_text(), any::<bool>(), any::<bool>(), option(), option(), option())
            .prop_map(|(quantity, unit, display_unit, relative_quantity, unbounded, min, max, nominal)| Attributes {
                quantity,
                unit,
                display_unit,
                relative_quantity,
                unbounded,
                min,
                max,
                nominal,
            })
            .boxed()
    } else if data_type.integer_range(version).is_some() {
        let bound = || prop::option::of(whole(data_type, version).prop_map(|value| value as f64));
        (maybe_text(), bound(), bound())
            .prop_map(|(quantity, min, max)| Attributes { quantity, min, max, ..Attributes::default() })
            .boxed()
    } else {
        Just(Attributes::default()).boxed()
    }
}

/// Start values, as many as the version allows.
pub fn start(data_type: DataType, version: FmiVersion) -> BoxedStrategy<Option<Start>> {
    let size = if version == FmiVersion::V2 { 1..2 } else { 1..4 };
    fn some<T: std::fmt::Debug + Clone + 'static>(
        value: impl Strategy<Value = T> + 'static,
        size: std::ops::Range<usize>,
        start: fn(Vec<T>) -> Start,
    ) -> BoxedStrategy<Option<Start>> {
        prop::option::of(prop::collection::vec(value, size).prop_map(start)).boxed()
    }
    match data_type {
        _ if data_type.is_float() => some(number(), size, Start::Float),
        DataType::Boolean => some(any::<bool>(), size, Start::Boolean),
        DataType::String => some(text(), size, Start::String),
        DataType::Binary => some(any::<Vec<u8>>(), size, Start::Binary),
        DataType::Clock => Just(None).boxed(),
        _ => {
            let (least, greatest) = data_type.integer_range(version).unwrap_or((0, 0));
            some(least..=greatest, size, Start::Integer)
        }
    }
}

/// What a clock may say of its ticks.
pub fn ticks() -> impl Strategy<Value = Clock> {
    use IntervalVariability as I;
    let decimal = || prop::option::of(number());
    let counter = || prop::option::of(any::<u64>());
    (
        select(vec![I::Constant, I::Fixed, I::Tunable, I::Changing, I::Countdown, I::Triggered]),
        any::<[bool; 2]>(),
        prop::option::of(any::<u32>()),
        (decimal(), decimal(), counter(), counter(), counter()),
    )
        .prop_map(|(interval_variability, flags, priority, times)| Clock {
            interval_variability,
            can_be_deactivated: flags[0],
            priority,
            interval_decimal: times.0,
            shift_decimal: times.1,
            supports_fraction: flags[1],
            resolution: times.2,
            interval_counter: times.3,
            shift_counter: times.4,
        })
}
