//! The payload of a PLY file in ASCII: a line for each element, a word for each number.
//!
//! A coordinate declared as a single must be a decimal that is exactly a single; otherwise it is refused, or, if the
//! suite requests it, rounded to the nearest single. Doubles work in the same way.

use ply_rs_bw::ply::{ElementDef, PropertyAccess, PropertyType, ScalarType};

use super::ply_element::{Element, axis, ended, is_corners};
use crate::decimals::{Place, explain, shown};
use crate::lines::{Line, lines};
use crate::{CorpusError, Decimals};

/// The part of the file after the header.
pub(super) struct Payload<'p> {
    file: &'p str,
    lines: Box<dyn Iterator<Item = Line<'p>> + 'p>,
    /// The number of lines in the header.
    before: usize,
    /// The number of the last line read.
    last: usize,
    decimals: &'p Decimals,
}

impl<'p> Payload<'p> {
    /// The payload behind a header.
    pub(super) fn new(
        file: &'p str,
        header: &[u8],
        payload: &'p [u8],
        decimals: &'p Decimals,
    ) -> Result<Payload<'p>, CorpusError> {
        let ends = |text: &[u8]| text.iter().filter(|&&byte| byte == b'\n').count();
        let before = ends(header);
        let text = str::from_utf8(payload).map_err(|why| {
            let line = before + ends(&payload[..why.valid_up_to()]) + 1;
            CorpusError::file(file, "the file is not text in UTF-8", "write it as such").at_line(line)
        })?;
        Ok(Payload { file, lines: Box::new(lines(text)), before, last: 0, decimals })
    }

    fn error(&self, line: usize, message: String, cure: &str) -> CorpusError {
        CorpusError::file(self.file, message, cure).at_line(self.before + line)
    }

    /// Reads the next element, with index `index` of its kind; returns it with its line.
    pub(super) fn element(&mut self, kind: &ElementDef, index: usize) -> Result<(usize, Element), CorpusError> {
        let Some(Line { number, body, .. }) = self.lines.next() else {
            return Err(ended(self.file, kind, index).at_line(self.before + self.last));
        };
        self.last = number;
        Ok((self.before + number, self.line(kind, number, body)?))
    }

    /// Refuses content after the elements that the header counts.
    pub(super) fn end(&mut self) -> Result<(), CorpusError> {
        match self.lines.find(|line| !line.body.trim().is_empty()) {
            Some(Line { number, .. }) => Err(self.error(
                number,
                "there is extra text after the elements that the header counts".to_owned(),
                "correct the counts",
            )),
            None => Ok(()),
        }
    }

    fn line(&self, kind: &ElementDef, number: usize, body: &str) -> Result<Element, CorpusError> {
        let mut element = Element::new();
        let mut words = body.split_ascii_whitespace();
        for property in kind.properties.values() {
            let mut word = || {
                words.next().ok_or_else(|| {
                    let message = format!("the line ends before `{}`", shown(&property.name));
                    self.error(number, message, "write a number for each property")
                })
            };
            let first = word()?;
            match &property.data_type {
                PropertyType::Scalar(scalar) => {
                    if let Some(axis) = axis(&property.name) {
                        element.at[axis] = self.coordinate(scalar, number, first)?;
                    }
                }
                PropertyType::List(..) => {
                    let length: usize = first.parse().map_err(|_| {
                        let message = format!("`{}` is not the length of a list", shown(first));
                        self.error(number, message, "write how many numbers follow")
                    })?;
                    let is_face = kind.name == "face" && is_corners(&property.name);
                    let mut corners = Vec::new();
                    for _ in 0..length {
                        let word = word()?;
                        if is_face {
                            corners.push(word.parse().map_err(|_| {
                                let message = format!("`{}` is not an index", shown(word));
                                self.error(number, message, "indices are integers from 0")
                            })?);
                        }
                    }
                    if is_face {
                        element.corners = Some(corners);
                    }
                }
            }
        }
        match words.next() {
            None => Ok(element),
            Some(word) => {
                let message = format!("`{}` follows the last property", shown(word));
                Err(self.error(number, message, "write one number for each property"))
            }
        }
    }

    fn coordinate(&self, scalar: &ScalarType, number: usize, word: &str) -> Result<f64, CorpusError> {
        let read = match scalar {
            ScalarType::Float => self.decimals.read_single(word),
            _ => self.decimals.read(word),
        };
        read.map_err(|why| {
            let (message, cure) = explain(Place::Data, word, &why);
            self.error(number, message, &cure)
        })
    }
}
