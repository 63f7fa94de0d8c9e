//! Scenes and results as drawings: points, lines and areas in named layers, in the plane or in space.
//!
//! Tasks provide the content; this module decides the appearance. A drawing becomes an SVG picture ([`Drawing::svg`]),
//! or data for the turning view in a browser ([`Drawing::json`], [`Drawing::page`]). Coordinates are offsets from an
//! origin that the task chooses, so that nearly coincident points there stay distinct at any distance from zero.

mod projection;
mod svg;
mod view;

pub use projection::Look;
pub use view::SCRIPTS;

/// The role of a layer, which decides its colour.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// Input.
    Given,
    /// The second of two inputs.
    Second,
    /// Output.
    Found,
    /// A highlighted part.
    Mark,
    /// A pale part for orientation.
    Faint,
}

impl Role {
    /// The role's name in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Role::Given => "given",
            Role::Second => "second",
            Role::Found => "found",
            Role::Mark => "mark",
            Role::Faint => "faint",
        }
    }

    /// The colour in red, green and blue, from the palette of Okabe and Ito as in plots.
    #[must_use]
    pub const fn colour(self) -> [u8; 3] {
        match self {
            Role::Given => [46, 134, 204],
            Role::Second => [213, 94, 0],
            Role::Found => [0, 158, 115],
            Role::Mark => [204, 121, 167],
            Role::Faint => [140, 140, 140],
        }
    }
}

/// The kind of a layer's parts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// Single points.
    Points,
    /// Paths from point to point.
    Lines,
    /// Areas that rings bound, by the even-odd rule in the plane. In space a part has one ring, which is flat and
    /// convex.
    Areas,
}

impl Shape {
    /// The kind's name in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Shape::Points => "points",
            Shape::Lines => "lines",
            Shape::Areas => "areas",
        }
    }
}

/// A point as its offset from the origin; the third component is 0 in the plane.
pub type Offset = [f64; 3];

/// The paths of one part of a layer: one point, one line, or the rings of an area.
pub type Part = Vec<Vec<Offset>>;

/// A named layer with parts of one kind.
#[derive(Clone, PartialEq, Debug)]
pub struct Layer {
    /// The name.
    pub name: String,
    /// The role, which decides the colour.
    pub role: Role,
    /// The kind of the parts.
    pub shape: Shape,
    /// The parts.
    pub parts: Vec<Part>,
    /// A name for each part, or empty.
    pub labels: Vec<String>,
    /// True if pictures show the layer, and a view initially shows it.
    pub is_shown: bool,
}

impl Layer {
    /// Hides the layer in pictures, and in a view until the user shows it.
    pub fn hide(&mut self) {
        self.is_shown = false;
    }

    /// Names the parts, in their order.
    pub fn label(&mut self, labels: impl IntoIterator<Item = String>) {
        self.labels = labels.into_iter().collect();
    }
}

/// A drawing: layers, the later ones above the earlier ones.
#[derive(Clone, PartialEq, Debug)]
pub struct Drawing {
    /// True if the drawing is in space.
    pub is_space: bool,
    /// The layers.
    pub layers: Vec<Layer>,
}

/// The visible part of a drawing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Window {
    /// The whole drawing.
    Whole,
    /// The part that is nearer to the origin than this distance.
    Around(f64),
}

impl Drawing {
    /// The number of parts in all visible layers.
    #[must_use]
    pub fn parts(&self) -> usize {
        self.shown().map(|layer| layer.parts.len()).sum()
    }

    /// The visible layers.
    fn shown(&self) -> impl Iterator<Item = &Layer> {
        self.layers.iter().filter(|layer| layer.is_shown)
    }

    /// The points of all visible layers.
    fn points(&self) -> impl Iterator<Item = &Offset> {
        self.shown().flat_map(|layer| layer.parts.iter().flatten().flatten())
    }

    /// The centre of the bounding box of all points, and half of its longest side, which is not 0; for a window, the
    /// centre and half side of the window.
    fn extent(&self, window: Window) -> (Offset, f64) {
        if let Window::Around(radius) = window {
            return ([0.0; 3], if radius > 0.0 { radius } else { 1.0 });
        }
        let bound = |axis: usize| {
            let ends = self.points().map(|point| point[axis]);
            ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let bounds = [0, 1, 2].map(bound);
        let middle = bounds.map(|[low, high]| if low <= high { f64::midpoint(low, high) } else { 0.0 });
        // Halved first: a box may be wider than the largest double.
        let half = bounds.iter().map(|[low, high]| high / 2.0 - low / 2.0).fold(0.0, f64::max);
        (middle, if half > 0.0 && half.is_finite() { half } else { 1.0 })
    }
}
