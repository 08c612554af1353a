//! The icon as pixels, for importers that draw no SVG.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use swayless_abi::describe;

use super::Error;

/// The longer side of the picture, in pixels.
const SIZE: u16 = 256;

/// Draws the icon of the FMU of this name. Icons hold no text, so no fonts are needed.
pub fn png(svg: &str, name: &str) -> Result<Vec<u8>, Error> {
    let bad = |problem: String| Error::bad_answer(name.as_ref(), describe::ICON, problem);
    let tree = Tree::from_str(svg, &Options::default()).map_err(|e| bad(format!("is not an SVG: {e}")))?;
    let size = tree.size();
    let scale = f32::from(SIZE) / size.width().max(size.height());
    let scaled = size.to_int_size().scale_by(scale).ok_or_else(|| bad("has no size".to_owned()))?;
    let mut pixels = Pixmap::new(scaled.width(), scaled.height()).ok_or_else(|| bad("has no size".to_owned()))?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(|e| bad(format!("cannot be drawn: {e}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_a_png_with_the_longer_side_at_full_size() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10"><path d="M0 0h20v10z"/></svg>"#;
        let png = png(svg, "Sample").unwrap();
        assert_eq!(&png[1..4], b"PNG");
        let side = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!((side(16), side(20)), (256, 128));
    }

    #[test]
    fn names_the_fmu_whose_icon_is_broken() {
        let error = png("<svg", "Sample").unwrap_err().to_string();
        assert!(error.contains("Sample") && error.contains("icon.svg"), "{error}");
    }
}
