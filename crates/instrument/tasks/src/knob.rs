//! Knobs: transformations that make scenes harder, and their limits for each task.

/// A transformation that makes scenes harder.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Knob {
    /// Degenerate scenes, with each coordinate moved at random by up to a fraction of the scene's extent.
    Noise,
    /// General scenes, translated from the origin by 2^k of their extent: coordinates are rounded, to 53 - k bits of
    /// the extent.
    Translation,
    /// General scenes, with coordinates rounded to [`SHIFTED_BITS`] bits of their extent, then translated by 2^k of it
    /// without rounding.
    Shift,
    /// General scenes, times 2^k.
    Scale,
    /// General scenes, with the last coordinate multiplied by 2^-k.
    Aspect,
    /// General scenes with k times as many primitives.
    Size,
    /// General scenes, with coordinates rounded to k bits of their extent.
    Precision,
    /// Degenerate scenes of integers, rotated k times by the angle of a Pythagorean triangle, and five times as large
    /// (in space 25 times). This is exact while coordinates have at most 53 bits.
    Pythagorean,
    /// Degenerate scenes, rotated by k sixteenths of a right angle.
    Turn,
}

impl Knob {
    /// All knobs.
    pub const ALL: [Knob; 9] = [
        Knob::Noise,
        Knob::Translation,
        Knob::Shift,
        Knob::Scale,
        Knob::Aspect,
        Knob::Size,
        Knob::Precision,
        Knob::Pythagorean,
        Knob::Turn,
    ];

    /// The name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Knob::Noise => "noise",
            Knob::Translation => "translation",
            Knob::Shift => "shift",
            Knob::Scale => "scale",
            Knob::Aspect => "aspect",
            Knob::Size => "size",
            Knob::Precision => "precision",
            Knob::Pythagorean => "pythagorean",
            Knob::Turn => "turn",
        }
    }

    /// The transformation and its scenes, in a sentence.
    #[must_use]
    pub const fn about(self) -> &'static str {
        match self {
            Knob::Noise => {
                "Degenerate scenes, with each coordinate moved randomly by up to this fraction of the \
                            extent."
            }
            Knob::Translation => "General scenes, moved away from the origin; their coordinates are rounded.",
            Knob::Shift => {
                "General scenes, with coordinates rounded to 24 bits at every position, then moved away \
                            from the origin without rounding."
            }
            Knob::Scale => "General scenes, scaled by a power of two.",
            Knob::Aspect => "General scenes, with the last coordinate multiplied by 2^-k.",
            Knob::Size => "General scenes with more primitives.",
            Knob::Precision => "General scenes, with coordinates rounded.",
            Knob::Pythagorean => "Degenerate scenes of integers, rotated by the angle of a Pythagorean triangle.",
            Knob::Turn => "Degenerate scenes, rotated by sixteenths of a right angle.",
        }
    }

    /// The unit of its positions.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Knob::Noise => "log2 of the noise over the extent (none: -1075)",
            Knob::Translation | Knob::Shift => "log2 of the distance over the extent",
            Knob::Scale | Knob::Aspect => "log2 of the factor",
            Knob::Size => "number of primitives, as a multiple",
            Knob::Precision => "bits removed of 53",
            Knob::Pythagorean => "times",
            Knob::Turn => "sixteenths of a right angle",
        }
    }

    /// Its positions, from easy to hard as far as that is known.
    #[must_use]
    pub const fn positions(self) -> &'static [i32] {
        match self {
            Knob::Noise => &[-1075, -53, -50, -46, -40, -34, -27, -20, -10],
            Knob::Translation => &[0, 8, 16, 24, 32, 40, 44, 48, 52],
            Knob::Shift => &[0, 8, 16, 20, 24, 28],
            Knob::Scale => &[0, -50, -100, -150, -250, -350, -500, 50, 100, 150, 250, 350, 500],
            Knob::Aspect => &[0, 5, 10, 15, 20, 25, 30, 40, 50],
            Knob::Size => &[1, 2, 4, 8],
            Knob::Precision => &[0, 13, 23, 29, 37, 41, 45, 47],
            Knob::Pythagorean => &[0, 1, 2, 4, 8, 12],
            Knob::Turn => &[0, 1, 2, 3, 5, 8, 11, 16],
        }
    }

    /// The positions at which turning the knob rounds the coordinates of a scene, so that the scene itself changes:
    /// nearly degenerate points may become degenerate. At other positions the knob keeps each sign of the scene at
    /// rest, as far as its map keeps signs.
    #[must_use]
    pub const fn rounds(self) -> RoundsScene {
        match self {
            Knob::Noise | Knob::Translation | Knob::Precision | Knob::Turn => RoundsScene::Always,
            Knob::Pythagorean => RoundsScene::Beyond53Bits,
            Knob::Shift | Knob::Scale | Knob::Aspect | Knob::Size => RoundsScene::Never,
        }
    }

    /// True if it starts from degenerate scenes.
    #[must_use]
    pub const fn is_of_degenerate(self) -> bool {
        matches!(self, Knob::Noise | Knob::Pythagorean | Knob::Turn)
    }
}

/// The bits of a coordinate, over the extent, that [`Knob::Shift`] keeps: with 28 for the translation and one for the
/// sum these are 53.
pub const SHIFTED_BITS: i32 = 24;

/// The positions at which a knob rounds the coordinates of a scene.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RoundsScene {
    /// Not at any position.
    Never,
    /// At each position except rest.
    Always,
    /// At positions where coordinates would need more than 53 bits.
    Beyond53Bits,
}

impl RoundsScene {
    /// The name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            RoundsScene::Never => "no",
            RoundsScene::Always => "yes",
            RoundsScene::Beyond53Bits => "beyond 53 bits",
        }
    }
}

/// The positions of a knob for which scenes of a task remain valid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Turns {
    /// All positions.
    Everywhere,
    /// Positions of at most this magnitude, and the reason for the limit.
    UpTo(i32, &'static str),
    /// No positions, and the reason.
    Nowhere(&'static str),
}

impl Turns {
    /// True if a scene at this position is a valid scene of the task.
    #[must_use]
    pub fn reaches(self, position: i32) -> bool {
        match self {
            Turns::Everywhere => true,
            Turns::UpTo(last, _) => position.abs() <= last,
            Turns::Nowhere(_) => false,
        }
    }
}
