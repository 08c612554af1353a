//! Colours that stay apart for colour-blind readers too: those of Okabe and Ito, without the yellow that nobody sees on
//! white, led by a near-black for what all else is compared with.

/// Red, green and blue.
pub type Rgb = [u8; 3];

/// How many colours there are.
pub const COLORS: usize = PALETTE.len();

const PALETTE: [Rgb; 7] =
    [[42, 46, 52], [213, 94, 0], [0, 114, 178], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233]];

/// The colour at a place; beyond the last they begin again.
pub fn color(place: usize) -> Rgb {
    PALETTE[place % COLORS]
}

/// The colour at a place, as CSS writes it.
pub fn css(place: usize) -> String {
    let [r, g, b] = color(place);
    format!("#{r:02x}{g:02x}{b:02x}")
}
