//! The simple types of XML Schema.

/// A value that is read from an attribute.
pub(crate) trait Parse: Sized {
    /// What is expected, for messages.
    const EXPECTED: &'static str;

    /// The value, if the text is one.
    fn parse(text: &str) -> Option<Self>;
}

impl Parse for f64 {
    const EXPECTED: &'static str = "a number";

    /// `xs:double`. A number too large for it is not one: it must not become infinite without anybody saying so.
    fn parse(text: &str) -> Option<Self> {
        match text.trim_ascii() {
            "INF" => Some(Self::INFINITY),
            "-INF" => Some(Self::NEG_INFINITY),
            "NaN" => Some(Self::NAN),
            text => {
                // Rust also reads `inf` and `nan` in any case, which XML Schema does not know.
                let numeric = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E'));
                text.parse().ok().filter(|value: &Self| numeric && value.is_finite())
            }
        }
    }
}

impl Parse for bool {
    const EXPECTED: &'static str = "true or false";

    fn parse(text: &str) -> Option<Self> {
        match text.trim_ascii() {
            "true" | "1" => Some(true),
            "false" | "0" => Some(false),
            _ => None,
        }
    }
}

macro_rules! integers {
    ($($type:ty => $expected:literal),* $(,)?) => {$(
        impl Parse for $type {
            const EXPECTED: &'static str = $expected;

            fn parse(text: &str) -> Option<Self> {
                text.trim_ascii().parse().ok()
            }
        }
    )*};
}

integers! {
    u32 => "a whole number from 0 to 4294967295",
    u64 => "a whole number from 0 to 18446744073709551615",
    i32 => "a whole number from -2147483648 to 2147483647",
    i64 => "a whole number of 64 bits",
    i128 => "a whole number",
}

/// The items of an `xs:list`; an error is the first item that is not a value.
pub(crate) fn parse_list<T: Parse>(text: &str) -> Result<Vec<T>, String> {
    text.split_ascii_whitespace().map(|item| T::parse(item).ok_or_else(|| item.to_owned())).collect()
}

/// `xs:hexBinary`.
pub(crate) fn hex_bytes(text: &str) -> Option<Vec<u8>> {
    let digits: Vec<u8> =
        text.trim_ascii().chars().map(|c| c.to_digit(16).and_then(|d| u8::try_from(d).ok())).collect::<Option<_>>()?;
    if !digits.len().is_multiple_of(2) {
        return None;
    }
    Some(digits.chunks_exact(2).map(|pair| pair[0] << 4 | pair[1]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_are_those_of_xml_schema() {
        for (text, value) in [("1", 1.0), (" -1.5e3 ", -1500.0), ("+.5", 0.5), ("INF", f64::INFINITY), ("-0", 0.0)] {
            assert_eq!(f64::parse(text), Some(value), "{text}");
        }
        assert!(f64::parse("NaN").is_some_and(f64::is_nan));
        for text in ["", "inf", "nan", "Infinity", "1e999", "1,5", "0x10", "1 2", "e", "."] {
            assert_eq!(f64::parse(text), None, "{text}");
        }
    }

    #[test]
    fn lists_say_which_item_is_wrong() {
        assert_eq!(parse_list::<u32>(" 1\n2 "), Ok(vec![1, 2]));
        assert_eq!(parse_list::<u32>(""), Ok(vec![]));
        assert_eq!(parse_list::<u32>("1 -2 x"), Err("-2".to_owned()));
    }

    #[test]
    fn hex_has_pairs_of_digits() {
        assert_eq!(hex_bytes("00fF"), Some(vec![0, 255]));
        assert_eq!(hex_bytes(""), Some(vec![]));
        assert_eq!(hex_bytes("0"), None);
        assert_eq!(hex_bytes("äb"), None);
    }
}
