//! The backend: floating-point determinants, compared with κ, ξ and the bands of [`circles`].

use std::marker::PhantomData;

use predicament_predicates::{
    Axis, Backend, Batches, Contract, Declined, Dimension, Plane, PredicateKind, Scene, Tally, ZeroMeaning,
};

use crate::band::is_sound;
use crate::contacts::EdgeVertex;
use crate::extent::largest_extent;
use crate::float::check_precision;
use crate::session::{INPUT_ONLY, Session, Tolerances};
use crate::shift::shifted;
use crate::{ContactTolerances, Float, Misscaled, Tolerances2d, Tolerances3d, circles};

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];
/// The stages: with the coordinates as they are, and with shifted ones.
const STAGES: [&str; 2] = ["float", "shifted float"];

/// The tolerance backend: `orient2d` is zero within κ, `orient3d` within ξ.
///
/// The paper has no tolerance for the other predicates. The tolerances of circles and spheres are ours, derived
/// with its calculus in [`circles`]. The order of coordinates is exact, and zero if they are equal (the caller decides
/// how to treat the tie).
///
/// L is the largest edge of the bounding box of all points in the scene. For `orient2d` in a 3D scene it is the largest
/// edge of their projection to its plane, so that the projections are three separate 2D scenes.
///
/// Contacts are the paper's Algorithms 2 to 5 and 7 to 12, with the tolerances of Algorithm 1 or 6 for the scene's
/// [primitive lengths](Scene::primitive_lengths). Without such lengths the backend declines contacts. They have a
/// separate L, [`Session::contact_tolerances`].
///
/// Everything is computed in `F`: `f64`, or `f32` for scenes whose coordinates are numbers of `f32`. If they are not,
/// but an exact shift makes them such numbers, `prepare` shifts the scene. The backend declines other scenes. It also
/// declines scenes with constructed vertices, and sessions construct none: κ and ξ bound
/// the rounding of determinants of input vertices, not that of a computed vertex as well.
///
/// The backend declines a scene if L, a product of coordinate differences or a tolerance leaves the range of normal
/// numbers of `F`, as the paper assumes "no underflow or overflow". If this happens only for circles or spheres,
/// the backend declines that predicate. If all points coincide (L = 0) the tolerances are zero and everything is
/// degenerate, which is right. If all primitives are points, only equal points are in contact.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Tolerance<F = f64> {
    form: EdgeVertex,
    misscaled: Option<Misscaled>,
    float: PhantomData<F>,
}

/// The backend in double precision.
#[allow(non_upper_case_globals)] // reads like the unit struct that it would be without its parameter
pub const Tolerance: Tolerance = Tolerance::new();

impl<F> Tolerance<F> {
    /// The correct scheme.
    #[must_use]
    pub const fn new() -> Tolerance<F> {
        Tolerance { form: EdgeVertex::Corrected, misscaled: None, float: PhantomData }
    }

    /// The scheme with Algorithms 3 and 8 as the paper prints them, which is wrong.
    ///
    /// See [`as_printed`](crate::algorithms::as_printed).
    #[must_use]
    pub const fn as_printed() -> Tolerance<F> {
        Tolerance { form: EdgeVertex::AsPrinted, misscaled: None, float: PhantomData }
    }

    /// The scheme with a tolerance that differs from the paper's: a planted fault.
    #[must_use]
    pub const fn misscaled(by: Misscaled) -> Tolerance<F> {
        Tolerance { form: EdgeVertex::Corrected, misscaled: Some(by), float: PhantomData }
    }
}

impl<F> Default for Tolerance<F> {
    fn default() -> Tolerance<F> {
        Tolerance::new()
    }
}

impl<F: Float> Backend for Tolerance<F> {
    type Session<'s, T: Tally + 's> = Session<'s, T, F>;

    /// The name `tolerance`, `tolerance:f32`, or the name of a planted fault.
    fn name(&self) -> String {
        let name = match (self.form, self.misscaled) {
            (_, Some(misscaled)) => format!("fault:{}", misscaled.fault),
            (EdgeVertex::Corrected, None) => "tolerance".to_owned(),
            (EdgeVertex::AsPrinted, None) => "fault:tolerance-as-printed".to_owned(),
        };
        if F::NAME == <f64 as Float>::NAME { name } else { format!("{name}:{}", F::NAME) }
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        match kind {
            PredicateKind::Compare => Contract { zero: ZeroMeaning::Exact, proved: true },
            _ => Contract { zero: ZeroMeaning::Band, proved: true },
        }
    }

    /// The stage `float`; in single precision also `shifted float`, which settles all queries of a shifted scene.
    fn stages(&self) -> &'static [&'static str] {
        if F::IS_NARROW { &STAGES } else { &STAGES[..1] }
    }

    /// Batches run in vector registers, in both formats.
    fn batches(&self, _: PredicateKind) -> Batches {
        Batches::Own
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T, F>, Declined> {
        check_precision::<F>()?;
        if !scene.constructions().is_empty() {
            return Err(Declined::scene(INPUT_ONLY));
        }
        let shifted = check_coordinates::<F>(scene)?;
        let planes = match scene.dimension() {
            Dimension::Two => &PLANES[..1],
            Dimension::Three => &PLANES,
        };
        let planar: Vec<_> = planes.iter().map(|&plane| planar(scene, plane)).collect();
        let spatial = match scene.dimension() {
            Dimension::Two => None,
            Dimension::Three => Some(spatial(scene)?),
        };
        if let (Dimension::Two, Err(declined)) = (scene.dimension(), &planar[0]) {
            return Err(Declined::scene(declined.reason.clone()));
        }
        let circular = circles::prepared::<F>(scene);
        let contacts = ContactTolerances::new(scene);
        let (planar, spatial, contacts) = match self.misscaled {
            None => (planar, spatial, contacts),
            Some(by) => (
                planar.into_iter().map(|plane| plane.map(|plane| by.plane(plane))).collect(),
                spatial.map(|space| by.space(space)),
                contacts.map(|contacts| by.contacts(contacts)),
            ),
        };
        Ok(Session::new((scene, shifted), tally, Tolerances { planar, spatial, circular, contacts }, self.form))
    }
}

/// Checks that all coordinates are numbers of `F`, and returns the shifted scene if only its coordinates are.
fn check_coordinates<F: Float>(scene: &Scene) -> Result<Option<Scene>, Declined> {
    let is_exact = |x: &f64| F::nearest(*x).wide() == *x;
    let Some(at) = scene.coordinates().iter().position(|x| !is_exact(x)) else { return Ok(None) };
    if let Some(shifted) = shifted::<F>(scene) {
        return Ok(Some(shifted));
    }
    let (dimension, x, name) = (scene.dimension().count(), scene.coordinates()[at], F::NAME);
    let (point, axis) = (at / dimension, at % dimension);
    Err(Declined::scene(format!(
        "point {point}: coordinate {axis} is {x}, which {name} does not hold exactly, not even after a shift; \
         round the scene to {name} first"
    )))
}

/// The tolerances of one projection, if `F` can represent them.
fn planar<F: Float>(scene: &Scene, plane: Plane) -> Result<Tolerances2d<F>, Declined> {
    let tolerances = Tolerances2d::from_length(F::above(largest_extent(scene, &plane.axes())));
    let check = tolerances.check_range();
    check.map_err(|declined| Declined::predicate(PredicateKind::Orient2d, declined.reason))?;
    Ok(tolerances)
}

/// The tolerances of space, if `F` can represent the tolerances of volumes.
fn spatial<F: Float>(scene: &Scene) -> Result<Tolerances3d<F>, Declined> {
    let tolerances = Tolerances3d::from_length(F::above(largest_extent(scene, &[Axis::X, Axis::Y, Axis::Z])));
    let Tolerances3d { length, sigma, xi, .. } = tolerances;
    let volume = F::nearest(6.0) * length * length * length;
    if length == F::ZERO || (is_sound::<F>(sigma) && is_sound::<F>(xi) && volume.wide().is_finite()) {
        return Ok(tolerances);
    }
    let (name, length) = (F::NAME, length.wide());
    let reason =
        format!("with L = {length:e} the tolerance ξ = 56 ε^¾ L³ or a volume leaves the range of normal {name}");
    Err(Declined::scene(reason))
}
