//! A drawing in the formats of pages and files.

use super::pdf;
use super::recording::Recording;
use crate::{Error, Picture};

impl Recording {
    /// The drawing in the formats of pages and files.
    pub fn picture(&self) -> Result<Picture, Error> {
        Ok(Picture { svg: self.svg()?, pdf: Some(pdf::pdf(self)?) })
    }
}
