//! The methods: a backend, and the form of a result in the next step.

use std::fmt;
use std::str::FromStr;

/// The treatment of a result's vertices before the next step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Keep {
    /// Vertices stay unchanged: constructed ones by definitions from edges of the operands, whatever the step.
    Whole,
    /// Each vertex is rounded to the nearest double.
    Rounded,
    /// Edges and crossings are rounded to pixels by snap rounding.
    ///
    /// The number is the binary logarithm of the pixels per largest coordinate.
    Snapped(u32),
    /// Edges are merged where the tolerance scheme registers contacts.
    Contacts,
    /// Vertices and edges are thick; the operands have this radius.
    Thick(f64),
}

/// A method of a cascade's steps: a backend, and the treatment of each result.
#[derive(Clone, PartialEq, Debug)]
pub struct Method {
    /// The backend's name.
    pub backend: String,
    /// The treatment of a result.
    pub keep: Keep,
}

/// The default of the binary logarithm of pixels per largest coordinate.
const PIXELS: u32 = 40;
/// The default radius of the operands.
const RADIUS: f64 = 1e-9;
/// The backend of thick primitives.
pub(super) const FLOAT: &str = "naive";

impl Method {
    /// The reference method.
    pub(super) fn exact() -> Method {
        Method { backend: "exact".to_owned(), keep: Keep::Whole }
    }

    /// Returns true if the method promises that every point is on the correct side of the result, and that nothing
    /// crosses.
    pub(super) fn is_exact(&self) -> bool {
        self.keep == Keep::Whole && (self.backend == "exact" || self.backend.starts_with("sos"))
    }

    /// Returns true if the method promises that nothing crosses.
    pub(super) fn is_planar(&self) -> bool {
        self.is_exact() || self.backend == "exact" && matches!(self.keep, Keep::Snapped(_))
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let backend = &self.backend;
        match self.keep {
            Keep::Whole => f.write_str(backend),
            Keep::Rounded => write!(f, "{backend}+round"),
            Keep::Snapped(PIXELS) => write!(f, "{backend}+snap"),
            Keep::Snapped(pixels) => write!(f, "{backend}+snap:{pixels}"),
            Keep::Contacts => write!(f, "{backend}+contacts"),
            Keep::Thick(radius) => write!(f, "thick:{radius:e}"),
        }
    }
}

/// The reason why a text is not a method.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ParseMethodError {
    /// The text is empty.
    NoName,
    /// The radius of `thick:RADIUS` is out of range in this text.
    Radius(String),
    /// The bits of `+snap:BITS` are out of range in this text.
    Bits(String),
    /// The treatment of results has an unknown name.
    Keep(String),
}

impl std::fmt::Display for ParseMethodError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ParseMethodError::NoName => f.write_str("a method needs a name"),
            ParseMethodError::Radius(text) => {
                write!(f, "`{text}`: the radius of `thick:RADIUS` must be between 0 and 0.5")
            }
            ParseMethodError::Bits(text) => write!(f, "`{text}`: the bits of `+snap:BITS` must be from 1 to 50"),
            ParseMethodError::Keep(rest) => {
                write!(f, "`+{rest}` is unknown; use +round, +snap, +snap:BITS or +contacts")
            }
        }
    }
}

impl std::error::Error for ParseMethodError {}

impl FromStr for Method {
    type Err = ParseMethodError;

    fn from_str(text: &str) -> Result<Method, ParseMethodError> {
        if let Some(radius) = text.strip_prefix("thick").filter(|rest| rest.is_empty() || rest.starts_with(':')) {
            let radius = radius.strip_prefix(':').map_or(Ok(RADIUS), str::parse);
            let radius = radius.ok().filter(|radius: &f64| radius.is_finite() && (0.0..=0.5).contains(radius));
            let radius = radius.ok_or_else(|| ParseMethodError::Radius(text.to_owned()))?;
            return Ok(Method { backend: FLOAT.to_owned(), keep: Keep::Thick(radius) });
        }
        let of = |backend: &str, keep: Keep| Ok(Method { backend: backend.to_owned(), keep });
        match text.rsplit_once('+') {
            None if text.is_empty() => Err(ParseMethodError::NoName),
            None => of(text, Keep::Whole),
            Some((backend, "round")) => of(backend, Keep::Rounded),
            Some((backend, "contacts")) => of(backend, Keep::Contacts),
            Some((backend, "snap")) => of(backend, Keep::Snapped(PIXELS)),
            Some((backend, rest)) => {
                let Some(pixels) = rest.strip_prefix("snap:") else {
                    return Err(ParseMethodError::Keep(rest.to_owned()));
                };
                let pixels = pixels.parse().ok().filter(|pixels| (1..=50).contains(pixels));
                let pixels = pixels.ok_or_else(|| ParseMethodError::Bits(text.to_owned()))?;
                of(backend, Keep::Snapped(pixels))
            }
        }
    }
}
