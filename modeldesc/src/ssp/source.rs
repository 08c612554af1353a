//! From the URI of a source to a path.

use std::error::Error;
use std::fmt;

/// Why a source is no path.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum SourceError {
    /// There is no path in it.
    Empty,
    /// It is not a file: `http:`, ….
    Scheme(String),
    /// A `%` without two hexadecimal digits, or percent-encoded bytes that are not UTF-8 or hold a NUL.
    Encoding,
}

impl fmt::Display for SourceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("the source is empty; name a file"),
            Self::Scheme(scheme) => {
                write!(f, "a source with `{scheme}:` cannot be opened; name a file beside the system description")
            }
            Self::Encoding => f.write_str("the source is not a valid URI; write `%25` for `%`"),
        }
    }
}

impl Error for SourceError {}

/// The path that a `source` means, with forward slashes; the URI's percent-encoding, fragment and `file:` are taken
/// off. It may be relative, lead out of its folder, or be absolute: whoever opens it decides what is allowed.
///
/// # Errors
///
/// [`SourceError`] if the source is empty, has a scheme other than `file:`, or is encoded wrongly.
pub fn source_path(source: &str) -> Result<String, SourceError> {
    let source = source.split('#').next().unwrap_or_default();
    let mut path = source;
    if let Some((scheme, rest)) = source.split_once(':') {
        let mut characters = scheme.chars();
        // A single letter is a drive of Windows, which careless writers put here as it is.
        let is_scheme = scheme.len() > 1
            && characters.next().is_some_and(|c| c.is_ascii_alphabetic())
            && characters.all(|c| c.is_ascii_alphanumeric() || "+-.".contains(c));
        if is_scheme {
            if !scheme.eq_ignore_ascii_case("file") {
                return Err(SourceError::Scheme(scheme.to_owned()));
            }
            path = rest.strip_prefix("//localhost").or_else(|| rest.strip_prefix("//")).unwrap_or(rest);
        }
    }
    let decoded = percent_decode(path)?;
    if decoded.is_empty() { Err(SourceError::Empty) } else { Ok(decoded) }
}

fn percent_decode(text: &str) -> Result<String, SourceError> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let mut digit = || rest.next().and_then(|b| char::from(b).to_digit(16)).and_then(|d| u8::try_from(d).ok());
        let (Some(high), Some(low)) = (digit(), digit()) else { return Err(SourceError::Encoding) };
        bytes.push(high << 4 | low);
    }
    if bytes.contains(&0) {
        return Err(SourceError::Encoding);
    }
    String::from_utf8(bytes).map_err(|_| SourceError::Encoding)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_become_paths() {
        for (source, path) in [
            ("resources/BoomCrane.fmu", "resources/BoomCrane.fmu"),
            ("../a%20b/%C3%A4.fmu#x", "../a b/ä.fmu"),
            ("file:///a/b.fmu", "/a/b.fmu"),
            ("file:/a/b.fmu", "/a/b.fmu"),
            ("file:a.fmu", "a.fmu"),
            ("C:/a.fmu", "C:/a.fmu"),
        ] {
            assert_eq!(source_path(source), Ok(path.to_owned()), "{source}");
        }
    }

    #[test]
    fn what_is_no_path_is_refused() {
        assert_eq!(source_path("#x"), Err(SourceError::Empty));
        assert_eq!(source_path("https://x/y.fmu"), Err(SourceError::Scheme("https".to_owned())));
        for source in ["a%2", "a%zz", "%ff", "a%00b", "%+1"] {
            assert_eq!(source_path(source), Err(SourceError::Encoding), "{source}");
        }
    }
}
