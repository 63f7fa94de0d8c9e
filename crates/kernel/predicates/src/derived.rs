//! Predicates from formulas, as values of the vocabulary.

use alloc::{borrow::ToOwned, boxed::Box, format, string::String, vec::Vec};
use core::cmp::Ordering;
use core::fmt;
use core::hash::{Hash, Hasher};
use std::sync::{OnceLock, PoisonError, RwLock};

use predicament_formula::{Formula, MOST_COORDINATES, MOST_POINTS};

use crate::{Dimension, PredicateKind, Scene, Vertex};

/// A predicate that is derived from a formula; two are equal if name and formula are.
///
/// The value is a pointer: the formula lives as long as the program.
#[derive(Clone, Copy)]
pub struct Derived(&'static Formula);

/// The name alone: a formula and its error bounds take pages.
impl fmt::Debug for Derived {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Derived").field(&self.name()).finish()
    }
}

impl Derived {
    /// The predicate of a formula, which lives as long as the program from now on.
    ///
    /// # Errors
    /// The reason, if the formula is about points of one coordinate: scenes have two or three.
    pub fn new(formula: Formula) -> Result<Derived, String> {
        if Dimension::of(formula.dimension()).is_none() {
            return Err("the formula is about points of one coordinate; scenes have points of two or three".to_owned());
        }
        Ok(Derived(Box::leak(Box::new(formula))))
    }

    /// The formula.
    #[inline]
    #[must_use]
    pub fn formula(self) -> &'static Formula {
        self.0
    }

    /// The dimension of the scenes that the predicate is about.
    #[must_use]
    pub fn dimension(self) -> Dimension {
        Dimension::of(self.0.dimension()).unwrap_or(Dimension::Two)
    }

    /// The name.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.0.name()
    }

    /// The number of points of a query.
    #[must_use]
    pub fn arity(self) -> usize {
        self.0.arity()
    }

    /// The degree of the polynomial in coordinates.
    #[must_use]
    pub fn degree(self) -> u32 {
        self.0.polynomial().degree()
    }

    /// The text of the formula.
    #[must_use]
    pub fn text(self) -> &'static str {
        self.0.text()
    }

    /// The meaning of the sign, in one line.
    #[must_use]
    pub fn about(self) -> &'static str {
        self.0.about()
    }

    /// Returns true if the formula reads weights of points.
    #[must_use]
    pub fn is_weighted(self) -> bool {
        self.0.is_weighted()
    }

    /// Calls a function with the coordinates of input vertices, and with their weights if the formula reads them.
    ///
    /// # Panics
    /// If a vertex is constructed or out of range.
    #[inline]
    pub fn with_points<R>(self, scene: &Scene, vertices: &[Vertex], then: impl FnOnce(&[&[f64]]) -> R) -> R {
        let mut points: [&[f64]; MOST_POINTS] = [&[]; MOST_POINTS];
        if !self.0.is_weighted() {
            for (point, &vertex) in points.iter_mut().zip(vertices) {
                *point = scene.point(vertex);
            }
            return then(&points[..vertices.len()]);
        }
        let count = scene.dimension().count();
        let mut weighted = [[0.0; MOST_COORDINATES]; MOST_POINTS];
        for (point, &vertex) in weighted.iter_mut().zip(vertices) {
            point[..count].copy_from_slice(scene.point(vertex));
            point[count] = scene.weights()[vertex.index()];
        }
        for (point, weighted) in points.iter_mut().zip(&weighted) {
            *point = &weighted[..=count];
        }
        then(&points[..vertices.len()])
    }

    /// The ranks of vertices by index: equal vertices have equal ranks.
    #[must_use]
    pub fn ranks(vertices: &[Vertex]) -> Vec<usize> {
        let mut sorted: Vec<usize> = vertices.iter().map(|v| v.index()).collect();
        sorted.sort_unstable();
        sorted.dedup();
        vertices.iter().map(|v| sorted.iter().position(|&other| other == v.index()).unwrap_or(0)).collect()
    }
}

/// The predicates from formulas that were registered.
static KNOWN: RwLock<Vec<Derived>> = RwLock::new(Vec::new());

impl Derived {
    /// The predicates that the project ships, in the order of [`predicament_formula::CATALOGUE`].
    ///
    /// # Panics
    /// If a shipped definition is not a formula; a test reads them all.
    pub fn shipped() -> &'static [Derived] {
        static SHIPPED: OnceLock<Vec<Derived>> = OnceLock::new();
        SHIPPED.get_or_init(|| {
            let shipped = predicament_formula::CATALOGUE.iter().map(|entry| {
                let formula =
                    Formula::new(entry.definition()).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
                Derived::new(formula).unwrap_or_else(|reason| panic!("{}: {reason}", entry.name))
            });
            shipped.collect()
        })
    }

    /// Makes a predicate known by its name, for the rest of the program's life.
    ///
    /// # Errors
    /// The reason, if the name is taken by another predicate, or is not a name.
    pub fn register(formula: Formula) -> Result<Derived, String> {
        let name = formula.name().to_owned();
        let is_name = name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-')) && !name.is_empty();
        if !is_name {
            return Err(format!("`{name}` is not a name: use letters, digits, `_` and `-`"));
        }
        let derived = Derived::new(formula)?;
        match name.parse::<PredicateKind>() {
            Ok(PredicateKind::Derived(same)) if same == derived => Ok(same),
            Ok(_) => Err(format!("`{name}` is a predicate of the tool already; choose another name")),
            Err(_) => {
                KNOWN.write().unwrap_or_else(PoisonError::into_inner).push(derived);
                Ok(derived)
            }
        }
    }

    /// The predicate with this name, shipped or registered.
    #[must_use]
    pub fn named(name: &str) -> Option<Derived> {
        Derived::all().into_iter().find(|derived| derived.formula().name() == name)
    }

    /// All predicates from formulas that are known by name: the shipped ones, then the registered ones.
    #[must_use]
    pub fn all() -> Vec<Derived> {
        let registered = KNOWN.read().unwrap_or_else(PoisonError::into_inner);
        Derived::shipped().iter().chain(registered.iter()).copied().collect()
    }
}

impl PartialEq for Derived {
    fn eq(&self, other: &Derived) -> bool {
        core::ptr::eq(self.0, other.0) || self.0 == other.0
    }
}

impl Eq for Derived {}

impl PartialOrd for Derived {
    fn partial_cmp(&self, other: &Derived) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Derived {
    fn cmp(&self, other: &Derived) -> Ordering {
        let key = |formula: &'static Formula| (formula.name(), formula.text());
        key(self.0).cmp(&key(other.0))
    }
}

impl Hash for Derived {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.name().hash(state);
    }
}
