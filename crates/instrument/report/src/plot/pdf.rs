//! A drawing as PDF: one page of its size, vectors and real text, for papers.
//!
//! The format is PDF 1.4, the first with transparency; LaTeX accepts it without a warning. A pixel is a unit. The file
//! does not depend on the time or the machine. Coordinates in the file are those of the drawing, downwards, so tests
//! and editors see the same coordinates as in the SVG.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::{Content, Filter, Finish as _, Name, Pdf, Rect, Ref, Settings, Str};
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, FontStyle, FontTransform};

use super::INK;
use super::helvetica::{Face, set};
use super::recording::{Letters, Mark, Pen, Recording};
use crate::Error;

/// The colour on paper of the text around the picture.
const INK_ON_PAPER: (u8, u8, u8) = (0x22, 0x22, 0x22);
/// The ratio of a letter size in SVG to one in plotters.
const UNIT: f64 = 1.24;
/// The distance of a Bézier curve's handles from its ends for a quarter of a circle, in radii.
const QUARTER: f32 = 0.552_284_8;

/// A drawing as the bytes of a file.
pub fn pdf(drawing: &Recording) -> Result<Vec<u8>, Error> {
    let [width, height] = [drawing.size.0, drawing.size.1].map(|side| pixels(f64::from(side)));
    let mut page =
        Page { content: Content::with_settings(Settings { pretty: false }), opacities: Vec::new(), faces: Vec::new() };
    page.content.transform([1.0, 0.0, 0.0, -1.0, 0.0, height]);
    // The limit of SVG, which cuts off sharper corners.
    page.content.set_miter_limit(4.0);
    for mark in &drawing.marks {
        page.mark(mark);
    }

    let [catalog, pages, only, content] = [1, 2, 3, 4].map(Ref::new);
    let fonts: Vec<(Face, Ref)> = page.faces.iter().copied().zip((5..).map(Ref::new)).collect();
    let mut pdf = Pdf::with_settings(Settings { pretty: false });
    pdf.set_version(1, 4);
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([only]).count(1);
    let mut entry = pdf.page(only);
    entry.parent(pages).media_box(Rect::new(0.0, 0.0, width, height)).contents(content);
    let mut resources = entry.resources();
    resources.fonts().pairs(fonts.iter().map(|&(face, font)| (font_name(face), font)));
    let mut states = resources.ext_g_states();
    for (at, &opacity) in page.opacities.iter().enumerate() {
        let mut state = states.insert(Name(state_name(at).as_bytes())).start::<pdf_writer::writers::ExtGraphicsState>();
        state.stroking_alpha(opacity).non_stroking_alpha(opacity);
    }
    states.finish();
    resources.finish();
    entry.finish();
    for (face, font) in fonts {
        let mut font = pdf.type1_font(font);
        font.base_font(Name(face.name()));
        if face != Face::Symbol {
            font.encoding_predefined(Name(b"WinAnsiEncoding"));
        }
    }
    let mut packed = ZlibEncoder::new(Vec::new(), Compression::best());
    let failed = |why: std::io::Error| Error::new("plot".as_ref(), why.to_string());
    packed.write_all(page.content.finish().as_slice()).map_err(failed)?;
    pdf.stream(content, &packed.finish().map_err(failed)?).filter(Filter::FlateDecode);
    Ok(pdf.finish())
}

const fn font_name(face: Face) -> Name<'static> {
    Name(match face {
        Face::Regular => b"R",
        Face::Bold => b"B",
        Face::Symbol => b"S",
    })
}

fn state_name(at: usize) -> String {
    format!("A{at}")
}

/// A length in single precision, which PDF uses; it holds fractions of pixels.
#[allow(clippy::cast_possible_truncation)]
fn pixels(x: f64) -> f32 {
    x as f32
}

fn corner((x, y): BackendCoord) -> [f32; 2] {
    [x, y].map(|x| pixels(f64::from(x)))
}

/// The page's content, and the opacities and fonts that it needs.
struct Page {
    content: Content,
    opacities: Vec<f32>,
    faces: Vec<Face>,
}

impl Page {
    fn mark(&mut self, mark: &Mark) {
        match mark {
            Mark::Pixel { at, colour } => self.rectangle([*at, (at.0 + 1, at.1 + 1)], &pen(*colour), true),
            Mark::Line { ends, pen } => self.path(ends, pen),
            Mark::Rectangle { corners, pen, is_filled } => self.rectangle(*corners, pen, *is_filled),
            Mark::Path { points, pen } => self.path(points, pen),
            Mark::Polygon { points, pen } => {
                self.ink(pen);
                self.trace(points);
                self.content.close_path().fill_nonzero();
            }
            Mark::Circle { centre, radius, pen, is_filled } => self.circle(*centre, *radius, pen, *is_filled),
            Mark::Text { text, at, letters } => self.text(text, *at, letters),
        }
    }

    /// Sets the colour for the following operations.
    fn ink(&mut self, pen: &Pen) {
        let BackendColor { rgb, alpha } = pen.colour;
        let alpha = pixels(alpha);
        let known = self.opacities.iter().position(|&other| other.to_bits() == alpha.to_bits());
        let state = known.unwrap_or_else(|| {
            self.opacities.push(alpha);
            self.opacities.len() - 1
        });
        let (r, g, b) = if rgb == (INK.0, INK.1, INK.2) { INK_ON_PAPER } else { rgb };
        let [r, g, b] = [r, g, b].map(|part| (f32::from(part) / 0.255).round() / 1000.0);
        self.content.set_parameters(Name(state_name(state).as_bytes()));
        self.content.set_stroke_rgb(r, g, b).set_fill_rgb(r, g, b).set_line_width(pixels(f64::from(pen.width)));
    }

    fn trace(&mut self, points: &[BackendCoord]) {
        for (at, point) in points.iter().enumerate() {
            let [x, y] = corner(*point);
            if at == 0 {
                self.content.move_to(x, y)
            } else {
                self.content.line_to(x, y)
            };
        }
    }

    fn path(&mut self, points: &[BackendCoord], pen: &Pen) {
        self.ink(pen);
        self.trace(points);
        self.content.stroke();
    }

    fn rectangle(&mut self, [a, b]: [BackendCoord; 2], pen: &Pen, is_filled: bool) {
        let ([x, y], [right, bottom]) = (corner(a), corner(b));
        self.ink(pen);
        self.content.rect(x, y, right - x, bottom - y);
        self.paint(is_filled);
    }

    fn circle(&mut self, centre: BackendCoord, radius: u32, pen: &Pen, is_filled: bool) {
        let ([x, y], r) = (corner(centre), pixels(f64::from(radius)));
        let k = QUARTER * r;
        self.ink(pen);
        self.content
            .move_to(x + r, y)
            .cubic_to(x + r, y + k, x + k, y + r, x, y + r)
            .cubic_to(x - k, y + r, x - r, y + k, x - r, y)
            .cubic_to(x - r, y - k, x - k, y - r, x, y - r)
            .cubic_to(x + k, y - r, x + r, y - k, x + r, y)
            .close_path();
        self.paint(is_filled);
    }

    fn paint(&mut self, is_filled: bool) {
        if is_filled {
            self.content.fill_nonzero()
        } else {
            self.content.stroke()
        };
    }

    fn text(&mut self, text: &str, at: BackendCoord, letters: &Letters) {
        let face = if matches!(letters.style, FontStyle::Bold) { Face::Bold } else { Face::Regular };
        let size = letters.size / UNIT;
        let (runs, width) = set(text, face);
        if runs.is_empty() {
            return;
        }
        // From the anchor to the start of the baseline, along it and down from it, as in SVG.
        let along = match letters.anchor.h_pos {
            HPos::Left => 0.0,
            HPos::Center => -width / 2.0,
            HPos::Right => -width,
        };
        let down = match letters.anchor.v_pos {
            VPos::Top => 0.76,
            VPos::Center => face.x_height() / 2.0,
            VPos::Bottom => -face.x_height() / 2.0,
        };
        // The direction of the text; down from it is a quarter turn to the right.
        let (x, y) = match letters.transform {
            FontTransform::None => (1.0, 0.0),
            FontTransform::Rotate90 => (0.0, 1.0),
            FontTransform::Rotate180 => (-1.0, 0.0),
            FontTransform::Rotate270 => (0.0, -1.0),
        };
        let start = [f64::from(at.0) + size * (along * x - down * y), f64::from(at.1) + size * (along * y + down * x)];
        self.ink(&pen(letters.colour));
        self.content.begin_text();
        // Letters stand upwards, against the page's direction.
        self.content.set_text_matrix([x, y, y, -x, start[0], start[1]].map(pixels));
        for run in runs {
            if !self.faces.contains(&run.face) {
                self.faces.push(run.face);
            }
            self.content.set_font(font_name(run.face), pixels(size)).show(Str(&run.codes));
        }
        self.content.end_text();
    }
}

const fn pen(colour: BackendColor) -> Pen {
    Pen { colour, width: 1 }
}
