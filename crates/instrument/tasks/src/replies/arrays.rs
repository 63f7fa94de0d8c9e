//! Named arrays: the form in which scenes go to other programs, and in which answers come back.
//!
//! A program in any language can read flat arrays of numbers. A list of loops is two of them: the vertices of all
//! loops, and under the name `NAME.starts` the place of each loop's first vertex, with the total at the end.

use predicament_predicates::Vertex;

/// An array, or a word.
#[derive(Clone, PartialEq, Debug)]
pub enum Array {
    /// A word: the value of a key with a fixed set of values.
    Word(String),
    /// Whole numbers: indices of points, places in other arrays, labels.
    Ids(Vec<u32>),
    /// Coordinates and other measures.
    Numbers(Vec<f64>),
}

/// Arrays by name, in the order in which they were added.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Arrays {
    entries: Vec<(String, Array)>,
}

/// An error in the form of an answer, in words.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Malformed(pub String);

impl std::fmt::Display for Malformed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Malformed {}

impl Arrays {
    /// Adds an array under a name. Of two arrays of one name, the first counts.
    pub fn add(&mut self, name: impl Into<String>, array: Array) {
        self.entries.push((name.into(), array));
    }

    /// All arrays with their names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Array)> {
        self.entries.iter().map(|(name, array)| (name.as_str(), array))
    }

    /// The array with this name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Array> {
        self.entries.iter().find(|(of, _)| of == name).map(|(_, array)| array)
    }

    /// The array with this name, to be changed.
    pub fn get_mut(&mut self, name: &str) -> Option<&mut Array> {
        self.entries.iter_mut().find(|(of, _)| of == name).map(|(_, array)| array)
    }

    /// Removes a part: the array of this name, and those whose names go on with a point.
    pub fn remove(&mut self, part: &str) {
        let is_of_part = |name: &str| name == part || name.strip_prefix(part).is_some_and(|rest| rest.starts_with('.'));
        self.entries.retain(|(name, _)| !is_of_part(name));
    }

    /// The names of the arrays, separated by commas.
    #[must_use]
    pub fn names(&self) -> String {
        let names: Vec<&str> = self.entries.iter().map(|(name, _)| name.as_str()).collect();
        if names.is_empty() { "nothing".to_owned() } else { names.join(", ") }
    }

    /// The whole numbers with this name.
    ///
    /// # Errors
    /// [`Malformed`] if the array is missing or has other values.
    pub fn ids(&self, name: &str) -> Result<&[u32], Malformed> {
        match self.get(name) {
            Some(Array::Ids(ids)) => Ok(ids),
            // An empty list has no type in most languages.
            Some(Array::Numbers(numbers)) if numbers.is_empty() => Ok(&[]),
            Some(_) => Err(Malformed(format!("`{name}` is not an array of whole numbers"))),
            None => Err(Malformed(format!("the answer lacks `{name}`; it has {}", self.names()))),
        }
    }

    /// The finite numbers with this name.
    ///
    /// # Errors
    /// [`Malformed`] if the array is missing, has other values, or has a number that is not finite.
    pub fn numbers(&self, name: &str) -> Result<&[f64], Malformed> {
        match self.get(name) {
            Some(Array::Numbers(numbers)) => match numbers.iter().position(|x| !x.is_finite()) {
                None => Ok(numbers),
                Some(at) => Err(Malformed(format!("number {at} of `{name}` is {}", numbers[at]))),
            },
            Some(Array::Ids(ids)) if ids.is_empty() => Ok(&[]),
            Some(_) => Err(Malformed(format!("`{name}` is not an array of coordinates"))),
            None => Err(Malformed(format!("the answer lacks `{name}`; it has {}", self.names()))),
        }
    }

    /// The only number with this name.
    ///
    /// # Errors
    /// As [`Arrays::numbers`]; also if there is another number of them.
    pub fn number(&self, name: &str) -> Result<f64, Malformed> {
        match *self.numbers(name)? {
            [number] => Ok(number),
            ref numbers => Err(Malformed(format!("`{name}` has {} numbers instead of one", numbers.len()))),
        }
    }

    /// Lists of whole numbers below `below`.
    ///
    /// # Errors
    /// As [`Arrays::ids`] and [`Arrays::ranges`]; also if a number is too large.
    pub fn lists(&self, name: &str, below: usize) -> Result<Vec<&[u32]>, Malformed> {
        let ids = self.ids(name)?;
        if let Some(id) = ids.iter().find(|&&id| id as usize >= below) {
            return Err(Malformed(format!("`{name}` has the index {id}, but there are {below}")));
        }
        Ok(self.ranges(&format!("{name}.starts"), ids.len())?.into_iter().map(|range| &ids[range]).collect())
    }

    /// Tuples of `N` vertices of a scene with `points` points.
    ///
    /// # Errors
    /// As [`Arrays::ids`]; also if the array does not have whole tuples, or an index is out of range.
    pub fn tuples<const N: usize>(&self, name: &str, points: usize) -> Result<Vec<[Vertex; N]>, Malformed> {
        let (tuples, rest) = self.ids(name)?.as_chunks::<N>();
        if !rest.is_empty() {
            let count = tuples.len() * N + rest.len();
            return Err(Malformed(format!("`{name}` has {count} indices, which is not a multiple of {N}")));
        }
        tuples.iter().map(|tuple| vertices(name, tuple, points)).collect()
    }

    /// Points with `D` coordinates.
    ///
    /// # Errors
    /// As [`Arrays::numbers`]; also if the array does not have whole points.
    pub fn points<const D: usize>(&self, name: &str) -> Result<&[[f64; D]], Malformed> {
        let numbers = self.numbers(name)?;
        let (points, rest) = numbers.as_chunks::<D>();
        if rest.is_empty() {
            return Ok(points);
        }
        Err(Malformed(format!("`{name}` has {} numbers, which is not a multiple of {D}", numbers.len())))
    }

    /// The ranges of `NAME.starts` in an array of `total` items.
    ///
    /// # Errors
    /// As [`Arrays::ids`]; also if the places do not ascend from 0 to the total.
    pub fn ranges(&self, name: &str, total: usize) -> Result<Vec<std::ops::Range<usize>>, Malformed> {
        let starts: Vec<usize> = self.ids(name)?.iter().map(|&start| start as usize).collect();
        let is_right = match (starts.first(), starts.last()) {
            (Some(&first), Some(&last)) => first == 0 && last == total && starts.is_sorted(),
            _ => total == 0,
        };
        if !is_right {
            return Err(Malformed(format!("`{name}` does not ascend from 0 to {total}")));
        }
        Ok(starts.windows(2).map(|pair| pair[0]..pair[1]).collect())
    }
}

/// Indices as vertices of a scene with `points` points.
fn vertices<const N: usize>(name: &str, ids: &[u32; N], points: usize) -> Result<[Vertex; N], Malformed> {
    match ids.iter().find(|&&id| id as usize >= points) {
        None => Ok(ids.map(|id| Vertex::input(id as usize))),
        Some(id) => Err(Malformed(format!("`{name}` has the index {id}, but the scene has {points} points"))),
    }
}
