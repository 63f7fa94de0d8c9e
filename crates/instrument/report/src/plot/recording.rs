//! A drawing as data, so that one plot becomes several kinds of file.
//!
//! Plots draw into a backend of plotters that only records. [`Recording::svg`] replays the marks to the SVG backend of
//! plotters, with the same result as direct drawing; the module `pdf` reads the marks itself.

use std::convert::Infallible;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters_backend::text_anchor::Pos;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind, FontFamily, FontStyle, FontTransform,
};

use super::{failed, page};
use crate::Error;

/// The recorded marks of a drawing, in order.
#[derive(Default)]
pub struct Recording {
    pub size: (u32, u32),
    pub marks: Vec<Mark>,
}

/// A recorded mark.
pub enum Mark {
    Pixel { at: BackendCoord, colour: BackendColor },
    Line { ends: [BackendCoord; 2], pen: Pen },
    Rectangle { corners: [BackendCoord; 2], pen: Pen, is_filled: bool },
    Path { points: Vec<BackendCoord>, pen: Pen },
    Polygon { points: Vec<BackendCoord>, pen: Pen },
    Circle { centre: BackendCoord, radius: u32, pen: Pen, is_filled: bool },
    Text { text: String, at: BackendCoord, letters: Letters },
}

/// The style of a line or of a filled shape.
#[derive(Clone, Copy)]
pub struct Pen {
    pub colour: BackendColor,
    pub width: u32,
}

/// The style of text.
pub struct Letters {
    family: String,
    /// The size in the unit of plotters, which is 1.24 pixels.
    pub size: f64,
    pub colour: BackendColor,
    pub style: FontStyle,
    pub transform: FontTransform,
    pub anchor: Pos,
}

impl Recording {
    /// An area to draw on, which records its marks here.
    pub fn area(&mut self, size: (u32, u32)) -> DrawingArea<Recorder<'_>, Shift> {
        self.size = size;
        Recorder(self).into_drawing_area()
    }

    /// The drawing as SVG, with the colour of the text around it.
    pub fn svg(&self) -> Result<String, Error> {
        let mut svg = String::new();
        {
            let mut backend = SVGBackend::with_string(&mut svg, self.size);
            let drawn = self.marks.iter().try_for_each(|mark| mark.draw(&mut backend));
            drawn.and_then(|()| backend.present()).map_err(failed)?;
        }
        Ok(page(&svg))
    }
}

impl Mark {
    fn colour(&self) -> BackendColor {
        match self {
            Mark::Pixel { colour, .. } => *colour,
            Mark::Line { pen, .. }
            | Mark::Rectangle { pen, .. }
            | Mark::Path { pen, .. }
            | Mark::Polygon { pen, .. }
            | Mark::Circle { pen, .. } => pen.colour,
            Mark::Text { letters, .. } => letters.colour,
        }
    }

    fn draw<B: DrawingBackend>(&self, on: &mut B) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        match self {
            Mark::Pixel { at, colour } => on.draw_pixel(*at, *colour),
            Mark::Line { ends: [from, to], pen } => on.draw_line(*from, *to, pen),
            Mark::Rectangle { corners: [a, b], pen, is_filled } => on.draw_rect(*a, *b, pen, *is_filled),
            Mark::Path { points, pen } => on.draw_path(points.iter().copied(), pen),
            Mark::Polygon { points, pen } => on.fill_polygon(points.iter().copied(), pen),
            Mark::Circle { centre, radius, pen, is_filled } => on.draw_circle(*centre, *radius, pen, *is_filled),
            Mark::Text { text, at, letters } => on.draw_text(text, letters, *at),
        }
    }
}

impl Pen {
    fn of(style: &impl BackendStyle) -> Pen {
        Pen { colour: style.color(), width: style.stroke_width() }
    }
}

impl BackendStyle for Pen {
    fn color(&self) -> BackendColor {
        self.colour
    }

    fn stroke_width(&self) -> u32 {
        self.width
    }
}

/// For backends with their own fonts: this type does not measure or draw letters.
impl BackendTextStyle for Letters {
    type FontError = Infallible;

    fn color(&self) -> BackendColor {
        self.colour
    }

    fn size(&self) -> f64 {
        self.size
    }

    fn transform(&self) -> FontTransform {
        self.transform.clone()
    }

    fn style(&self) -> FontStyle {
        self.style
    }

    fn anchor(&self) -> Pos {
        self.anchor
    }

    fn family(&self) -> FontFamily<'_> {
        FontFamily::from(self.family.as_str())
    }

    fn layout_box(&self, _: &str) -> Result<((i32, i32), (i32, i32)), Infallible> {
        Ok(((0, 0), (0, 0)))
    }

    fn draw<E, Draw: FnMut(i32, i32, BackendColor) -> Result<(), E>>(
        &self,
        _: &str,
        _: BackendCoord,
        _: Draw,
    ) -> Result<Result<(), E>, Infallible> {
        Ok(Ok(()))
    }
}

type Noted = Result<(), DrawingErrorKind<Infallible>>;

/// The backend that records. It estimates sizes of text as plotters does for SVG.
pub struct Recorder<'d>(&'d mut Recording);

impl Recorder<'_> {
    #[allow(clippy::unnecessary_wraps)] // what plotters asks for
    fn note(&mut self, mark: Mark) -> Noted {
        // Invisible marks are not recorded.
        if mark.colour().alpha > 0.0 {
            self.0.marks.push(mark);
        }
        Ok(())
    }
}

impl DrawingBackend for Recorder<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.0.size
    }

    fn ensure_prepared(&mut self) -> Noted {
        Ok(())
    }

    fn present(&mut self) -> Noted {
        Ok(())
    }

    fn draw_pixel(&mut self, at: BackendCoord, colour: BackendColor) -> Noted {
        self.note(Mark::Pixel { at, colour })
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Noted {
        self.note(Mark::Line { ends: [from, to], pen: Pen::of(style) })
    }

    fn draw_rect<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, style: &S, is_filled: bool) -> Noted {
        self.note(Mark::Rectangle { corners: [a, b], pen: Pen::of(style), is_filled })
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Noted {
        self.note(Mark::Path { points: path.into_iter().collect(), pen: Pen::of(style) })
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Noted {
        self.note(Mark::Polygon { points: path.into_iter().collect(), pen: Pen::of(style) })
    }

    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, radius: u32, style: &S, is_filled: bool) -> Noted {
        self.note(Mark::Circle { centre, radius, pen: Pen::of(style), is_filled })
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Noted {
        let letters = Letters {
            family: style.family().as_str().to_owned(),
            size: style.size(),
            colour: style.color(),
            style: style.style(),
            transform: style.transform(),
            anchor: style.anchor(),
        };
        self.note(Mark::Text { text: text.to_owned(), at, letters })
    }
}
