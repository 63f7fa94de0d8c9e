//! The sign of a predicate over a raster, one pixel for each query.
//!
//! Kettner, Mehlhorn, Pion, Schirra and Yap made these pictures famous. One point of an orientation query moves over
//! neighbouring doubles, and the line between two half planes turns into a coastline. Red for negative, yellow for zero
//! and blue for positive are their colours, in shades that every kind of colour vision can distinguish. Wrong answers
//! are darker, so that they are visible even in grey.

use std::fmt;

/// The palette: the gap between maps; negative, zero and positive, first right, then wrong; then equal, legally
/// different, and wrong answers.
const PALETTE: [[u8; 3]; 10] = [
    [255, 255, 255],
    [230, 120, 90],
    [250, 225, 110],
    [110, 165, 225],
    [120, 20, 10],
    [130, 95, 0],
    [10, 40, 110],
    [235, 237, 240],
    [150, 190, 170],
    [90, 10, 60],
];
const GAP: u8 = 0;
/// The first colour of differences.
const SAME: u8 = 7;

/// The maximum number of pixels: browsers can show such a picture, and memory can hold it.
const MAX_PIXELS: usize = 1 << 28;

/// Signs over a raster, rows from top to bottom.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PixelMap {
    width: usize,
    height: usize,
    /// The pixels as palette indices.
    pixels: Vec<u8>,
}

/// The relation of an answer to the truth.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Standing {
    /// The exact sign.
    Same,
    /// Another sign, which the backend's promise allows.
    Legal,
    /// A sign that the promise does not allow.
    Wrong,
}

/// An error in making a picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PixelMapError {
    /// The number of signs or marks is not width × height.
    WrongLength,
    /// The value is not a sign: -1, 0 or 1.
    NotASign(i8),
    /// There are no pixels, no zoom, no maps, or more than 2^28 pixels.
    BadSize,
}

impl fmt::Display for PixelMapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PixelMapError::WrongLength => f.write_str("the signs don't fill the pixel map"),
            PixelMapError::NotASign(value) => write!(f, "{value} is not a sign"),
            PixelMapError::BadSize => f.write_str("a pixel map can't have this size"),
        }
    }
}

impl std::error::Error for PixelMapError {}

impl PixelMap {
    /// A map from `width` × `height` signs (-1, 0 or 1), row by row from the top. `wrong` marks the signs that the
    /// backend's promise does not allow.
    ///
    /// # Errors
    /// If the lengths don't fit or a value is not a sign.
    pub fn new(width: usize, height: usize, signs: &[i8], wrong: &[bool]) -> Result<PixelMap, PixelMapError> {
        let size = width.checked_mul(height).filter(|&size| size > 0).ok_or(PixelMapError::BadSize)?;
        if signs.len() != size || wrong.len() != size {
            return Err(PixelMapError::WrongLength);
        }
        let colour = |(&sign, &wrong): (&i8, &bool)| match sign {
            -1 => Ok(if wrong { 4 } else { 1 }),
            0 => Ok(if wrong { 5 } else { 2 }),
            1 => Ok(if wrong { 6 } else { 3 }),
            other => Err(PixelMapError::NotASign(other)),
        };
        let pixels = signs.iter().zip(wrong).map(colour).collect::<Result<_, _>>()?;
        Ok(PixelMap { width, height, pixels })
    }

    /// A map of the differences between answers and truth, row by row from the top.
    ///
    /// # Errors
    /// If the length doesn't fit.
    pub fn difference(width: usize, height: usize, standings: &[Standing]) -> Result<PixelMap, PixelMapError> {
        let size = width.checked_mul(height).filter(|&size| size > 0).ok_or(PixelMapError::BadSize)?;
        if standings.len() != size {
            return Err(PixelMapError::WrongLength);
        }
        let colour = |standing: &Standing| match standing {
            Standing::Same => SAME,
            Standing::Legal => SAME + 1,
            Standing::Wrong => SAME + 2,
        };
        Ok(PixelMap { width, height, pixels: standings.iter().map(colour).collect() })
    }

    /// The width and the height, in queries.
    pub(crate) fn extent(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// The map as an indexed PNG, each query a square of `zoom` × `zoom` pixels.
    ///
    /// # Errors
    /// If the zoom is zero or the picture too large.
    pub fn to_png(&self, zoom: usize) -> Result<Vec<u8>, PixelMapError> {
        side_by_side(std::slice::from_ref(self), zoom, 0)
    }
}

/// Several maps in a row, top-aligned, as one PNG; `gap` is in pixels of the picture.
///
/// # Errors
/// If there is no map, the zoom is zero, or the picture is too large.
pub fn side_by_side(maps: &[PixelMap], zoom: usize, gap: usize) -> Result<Vec<u8>, PixelMapError> {
    let size = |n: usize| n.checked_mul(zoom).filter(|&n| n > 0).ok_or(PixelMapError::BadSize);
    let gaps = maps.len().saturating_sub(1).checked_mul(gap).ok_or(PixelMapError::BadSize)?;
    let columns = maps.iter().try_fold(0_usize, |sum, map| sum.checked_add(map.width)).ok_or(PixelMapError::BadSize)?;
    let width = size(columns)?.checked_add(gaps).ok_or(PixelMapError::BadSize)?;
    let height = size(maps.iter().map(|map| map.height).max().unwrap_or(0))?;
    if width.checked_mul(height).is_none_or(|pixels| pixels > MAX_PIXELS) {
        return Err(PixelMapError::BadSize);
    }
    let (Ok(png_width), Ok(png_height)) = (u32::try_from(width), u32::try_from(height)) else {
        return Err(PixelMapError::BadSize);
    };

    // A palette index takes four bits: two pixels share a byte.
    let mut packed = Vec::with_capacity(width.div_ceil(2) * height);
    for y in 0..height {
        let mut row = Vec::with_capacity(width + 1);
        for (i, map) in maps.iter().enumerate() {
            if i > 0 {
                row.extend(std::iter::repeat_n(GAP, gap));
            }
            let line = (y / zoom) * map.width;
            match map.pixels.get(line..line + map.width) {
                Some(line) => row.extend(line.iter().flat_map(|&pixel| std::iter::repeat_n(pixel, zoom))),
                None => row.extend(std::iter::repeat_n(GAP, map.width * zoom)),
            }
        }
        packed.extend(row.chunks(2).map(|pair| (pair[0] << 4) | pair.get(1).copied().unwrap_or(GAP)));
    }

    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, png_width, png_height);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Four);
    // Only possible colours are listed: the bytes of a map do not depend on the colours of other kinds of map.
    let colours = maps.iter().flat_map(|map| &map.pixels).any(|&pixel| pixel >= SAME);
    encoder.set_palette(PALETTE[..if colours { PALETTE.len() } else { usize::from(SAME) }].as_flattened());
    let written = encoder.write_header().and_then(|mut png| {
        png.write_image_data(&packed)?;
        png.finish()
    });
    // Writing to memory fails only if the format can't represent the picture.
    written.map_err(|_| PixelMapError::BadSize)?;
    Ok(bytes)
}

/// A PNG as a data URI, for embedding in a page.
#[must_use]
pub fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", base64(png))
}

/// The base 64 of bytes: RFC 4648, section 4, with padding.
pub(crate) fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |i| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for place in 0..4 {
            let digit = (bits >> (18 - 6 * place)) & 63;
            // n bytes fill n + 1 digits.
            let used = place <= chunk.len();
            text.push(if used { char::from(DIGITS[digit as usize]) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The colours of a PNG, row by row.
    fn decode(png: &[u8]) -> (usize, Vec<[u8; 3]>) {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        assert_eq!(info.color_type, png::ColorType::Rgb);
        (info.width as usize, bytes[..info.buffer_size()].as_chunks().0.to_vec())
    }

    fn colour(sign: i8, wrong: bool) -> [u8; 3] {
        PALETTE[usize::try_from(sign + 2).unwrap() + if wrong { 3 } else { 0 }]
    }

    /// The colours that README, `map --help` and the report's section describe.
    #[test]
    fn red_is_negative_yellow_zero_and_blue_positive_and_wrong_is_dark() {
        let map = PixelMap::new(3, 2, &[-1, 0, 1, -1, 0, 1], &[false, false, false, true, true, true]).unwrap();
        let (_, pixels) = decode(&map.to_png(1).unwrap());
        let [red, yellow, blue] = [[230, 120, 90], [250, 225, 110], [110, 165, 225]];
        let [dark_red, dark_yellow, dark_blue] = [[120, 20, 10], [130, 95, 0], [10, 40, 110]];
        assert_eq!(pixels, [red, yellow, blue, dark_red, dark_yellow, dark_blue]);
    }

    #[test]
    fn differences_have_colours_of_their_own() {
        let map = PixelMap::difference(3, 1, &[Standing::Same, Standing::Legal, Standing::Wrong]).unwrap();
        assert_eq!(decode(&map.to_png(1).unwrap()).1, PALETTE[7..]);
        assert_eq!(PixelMap::difference(2, 1, &[Standing::Same]), Err(PixelMapError::WrongLength));
    }

    #[test]
    fn decodes_back_to_the_same_pixels() {
        let signs: Vec<i8> = (0_i8..35).map(|i| i % 3 - 1).collect();
        let wrong: Vec<bool> = (0..35).map(|i| i % 4 == 1).collect();
        let map = PixelMap::new(7, 5, &signs, &wrong).unwrap();
        for zoom in [1, 2, 3] {
            let (width, pixels) = decode(&map.to_png(zoom).unwrap());
            assert_eq!((width, pixels.len()), (7 * zoom, 35 * zoom * zoom));
            for (at, &pixel) in pixels.iter().enumerate() {
                let query = (at / width / zoom) * 7 + (at % width) / zoom;
                assert_eq!(pixel, colour(signs[query], wrong[query]), "zoom {zoom}, pixel {at}");
            }
        }
    }

    #[test]
    fn maps_stand_side_by_side() {
        let tall = PixelMap::new(1, 2, &[-1, 1], &[false, false]).unwrap();
        let flat = PixelMap::new(2, 1, &[0, 1], &[true, false]).unwrap();
        let (width, pixels) = decode(&side_by_side(&[tall, flat], 1, 2).unwrap());
        let gap = PALETTE[0];
        assert_eq!(width, 5);
        assert_eq!(pixels[..5], [colour(-1, false), gap, gap, colour(0, true), colour(1, false)]);
        assert_eq!(pixels[5..], [colour(1, false), gap, gap, gap, gap]);
    }

    #[test]
    fn bad_maps_are_refused() {
        assert_eq!(PixelMap::new(2, 2, &[0; 3], &[false; 3]), Err(PixelMapError::WrongLength));
        assert_eq!(PixelMap::new(1, 1, &[2], &[false]), Err(PixelMapError::NotASign(2)));
        assert_eq!(PixelMap::new(0, 2, &[], &[]), Err(PixelMapError::BadSize));
        assert_eq!(side_by_side(&[], 1, 1), Err(PixelMapError::BadSize));
        let map = PixelMap::new(1, 1, &[1], &[false]).unwrap();
        assert_eq!(map.to_png(0), Err(PixelMapError::BadSize));
        assert_eq!(map.to_png(usize::MAX), Err(PixelMapError::BadSize));
    }

    #[test]
    fn right_and_wrong_differ_in_grey() {
        let luma = |[r, g, b]: [u8; 3]| 0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b);
        let darkest_right = PALETTE[1..4].iter().chain(&PALETTE[7..9]).map(|&c| luma(c)).fold(f64::INFINITY, f64::min);
        let lightest_wrong = PALETTE[4..7].iter().chain(&PALETTE[9..]).map(|&c| luma(c)).fold(0.0, f64::max);
        assert!(darkest_right - lightest_wrong > 30.0, "{darkest_right} and {lightest_wrong}");
    }

    #[test]
    fn base64_as_in_the_rfc() {
        let cases =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (plain, encoded) in cases {
            assert_eq!(base64(plain.as_bytes()), encoded);
        }
    }
}
