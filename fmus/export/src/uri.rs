//! The folder that an importer names as resources, as it comes: a path, or a URI in one of its many spellings.

use std::path::PathBuf;

/// The folder of `file:/x`, `file:///x`, `file:////x`, `file://localhost/x`, percent-encoded, or a plain path; with or
/// without a separator at its end.
pub fn folder(location: &str) -> Option<PathBuf> {
    let location = location.trim();
    if location.is_empty() {
        return None;
    }
    let Some(rest) = location.strip_prefix("file:") else {
        return Some(PathBuf::from(location));
    };
    let rest = rest.strip_prefix("//localhost/").unwrap_or(rest);
    let decoded = decode(rest.trim_start_matches('/'))?;
    let drive = decoded.as_bytes().get(1) == Some(&b':');
    Some(PathBuf::from(if drive { decoded } else { format!("/{decoded}") }))
}

fn decode(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'%' => {
                let digit = |byte: Option<u8>| char::from(byte?).to_digit(16);
                let (high, low) = (digit(rest.next())?, digit(rest.next())?);
                u8::try_from(high * 16 + low).ok()?
            }
            other => other,
        });
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_names_the_same_folder() {
        for spelling in [
            "file:/a%20b/%C3%BC",
            "file:///a%20b/%C3%BC",
            "file:////a%20b/ü",
            "file://localhost/a b/ü",
            "/a b/ü",
            "file:///a%20b/%C3%BC/",
        ] {
            assert_eq!(folder(spelling), Some(PathBuf::from("/a b/ü")), "{spelling}");
        }
        assert_eq!(folder("file:///C:/a"), Some(PathBuf::from("C:/a")));
        assert_eq!(folder("file:///a%zz"), None);
        assert_eq!(folder(""), None);
    }
}
