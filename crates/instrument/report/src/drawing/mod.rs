//! Scenes and results as drawings: points, lines and areas in named layers, in the plane or in space.
//!
//! Tasks say what there is to be seen; what a picture looks like is said here once. A drawing is a picture as SVG
//! ([`Drawing::svg`]), or data for the view in a browser that turns ([`Drawing::json`], [`Drawing::page`]). Coordinates are offsets
//! from an origin of the drawer's choice, so that what nearly coincides there is told apart however far it is from zero.

mod projection;
mod svg;
mod view;

pub use projection::Look;
pub use view::SCRIPTS;

/// What a layer stands for, which decides its colour.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// What was given.
    Given,
    /// The second of two that were given.
    Second,
    /// What was found.
    Found,
    /// What is to stand out.
    Mark,
    /// What is there for orientation.
    Faint,
}

impl Role {
    /// The name, as in JSON.
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

    /// Red, green and blue: colours of Okabe and Ito, as in plots.
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

/// What the parts of a layer are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// Single points.
    Points,
    /// Paths from point to point.
    Lines,
    /// What rings bound, by even and odd in the plane. In space a part has one ring, which is flat and convex.
    Areas,
}

impl Shape {
    /// The name, as in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Shape::Points => "points",
            Shape::Lines => "lines",
            Shape::Areas => "areas",
        }
    }
}

/// The place of a point as its offset from the origin; the third is 0 in the plane.
pub type Offset = [f64; 3];

/// Paths of one part of a layer: one point, one line, or the rings of an area.
pub type Part = Vec<Vec<Offset>>;

/// Parts of one kind with a name.
#[derive(Clone, PartialEq, Debug)]
pub struct Layer {
    /// The name.
    pub name: String,
    /// The colour.
    pub role: Role,
    /// What the parts are.
    pub shape: Shape,
    /// The parts.
    pub parts: Vec<Part>,
    /// A name for each part, or none.
    pub labels: Vec<String>,
    /// Whether a picture has it, and a view at first.
    pub is_shown: bool,
}

impl Layer {
    /// Leaves the layer out of pictures, and a view until it is asked for.
    pub fn hide(&mut self) {
        self.is_shown = false;
    }

    /// Names the parts, in their order.
    pub fn label(&mut self, labels: impl IntoIterator<Item = String>) {
        self.labels = labels.into_iter().collect();
    }
}

/// Layers, the later ones above the earlier ones.
#[derive(Clone, PartialEq, Debug)]
pub struct Drawing {
    /// Whether it is in space.
    pub is_space: bool,
    /// The layers.
    pub layers: Vec<Layer>,
}

/// How much of a drawing is seen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Window {
    /// All of it.
    Whole,
    /// What is nearer to the origin than this.
    Around(f64),
}

impl Drawing {
    /// The number of parts in all layers that are shown.
    #[must_use]
    pub fn parts(&self) -> usize {
        self.shown().map(|layer| layer.parts.len()).sum()
    }

    /// The layers that are shown.
    fn shown(&self) -> impl Iterator<Item = &Layer> {
        self.layers.iter().filter(|layer| layer.is_shown)
    }

    /// The points of all layers that are shown.
    fn points(&self) -> impl Iterator<Item = &Offset> {
        self.shown().flat_map(|layer| layer.parts.iter().flatten().flatten())
    }

    /// The middle of the box around all points and half of its longest side, which is not 0; in a window those of the window.
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
        // Halves first: a box may be wider than the largest double.
        let half = bounds.iter().map(|[low, high]| high / 2.0 - low / 2.0).fold(0.0, f64::max);
        (middle, if half > 0.0 && half.is_finite() { half } else { 1.0 })
    }
}
