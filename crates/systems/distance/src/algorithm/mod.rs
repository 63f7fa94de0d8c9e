//! The nearest features of two objects.
//!
//! First, two trees of boxes are searched together for the parts that may be nearest (`near.rs`, `bounds.rs`): doubles
//! with proved bounds select them. Then predicates decide (`pairs.rs`, `formulas.rs`): signs of formulas say whether
//! the nearest points of two features are inside the features, and compare the squared distances of pairs. Nothing is
//! rounded unless the session rounds.
//!
//! # Ties
//! Pairs at one distance are all reported. A perturbation by infinitesimals would break these ties, and would say
//! nothing about distances: a distance is a number, not a side. So a perturbed session is asked for its
//! [unperturbed](Predicates::unperturbed) one, and `sos` answers what `exact` answers.

mod bounds;
mod formulas;
mod inside;
mod near;
mod pairs;
pub mod questions;

use std::sync::OnceLock;

use predicament_grid::Bounds;
use predicament_mesh_rays::algorithm::MeshTree;
use predicament_predicates::{Declined, Predicates, Scene, Sign, Vertex};

use crate::answer::{Feature, Kind, Nearest, Object, Pair};
use inside::{has_inside, one_of_each};
use near::{Parts, near, point};
use pairs::Asking;
use questions::{asks, is_measured};

/// An object with a tree over its parts. It depends on raw coordinates only, not on a backend.
#[derive(Debug)]
pub struct Indexed {
    object: Object,
    is_closed: bool,
    parts: Parts,
    /// The features of each part that no earlier part has, with their boxes.
    owned: Vec<Vec<(Feature, Bounds<3>)>>,
    /// One vertex of each connected part.
    one_of_each: Vec<Vertex>,
    /// The mesh for rays, if one is asked for.
    mesh: OnceLock<MeshTree>,
}

impl Indexed {
    /// The object with its tree.
    ///
    /// # Panics
    /// If the object has 2^32 parts, or the scene lacks one of its vertices.
    #[must_use]
    pub fn new(scene: &Scene, object: Object) -> Indexed {
        let closure = |(part, corners): (usize, &[Vertex])| {
            Feature::closure(corners).into_iter().enumerate().map(move |(at, feature)| (feature, [part, at]))
        };
        let mut all: Vec<(Feature, [usize; 2])> = object.parts().enumerate().flat_map(closure).collect();
        all.sort_unstable();
        all.dedup_by_key(|(feature, _)| *feature);
        all.sort_unstable_by_key(|(_, place)| *place);
        let mut owned = vec![Vec::new(); object.parts().count()];
        for (feature, [part, _]) in all {
            let bounds = Bounds::of(feature.corners().iter().map(|&v| point(scene, v)));
            owned[part].push((feature, bounds));
        }
        Indexed {
            owned,
            is_closed: object.is_closed(),
            parts: Parts::new(scene, &object),
            one_of_each: one_of_each(&object),
            mesh: OnceLock::new(),
            object,
        }
    }

    /// The mesh for rays: it has a tree of its own.
    fn mesh(&self, scene: &Scene) -> &MeshTree {
        self.mesh.get_or_init(|| MeshTree::new(scene, &self.object.triangles()))
    }

    /// The object.
    #[must_use]
    pub fn object(&self) -> &Object {
        &self.object
    }
}

/// The nearest features of two objects.
///
/// # Errors
/// [`Declined`] if the session does not answer one of the predicates.
///
/// # Panics
/// If the session's scene lacks one of the vertices.
pub fn nearest<P: Predicates>(session: &P, objects: [&Indexed; 2]) -> Result<Nearest, Declined> {
    let Some(unperturbed) = session.unperturbed() else { return solved(session, objects) };
    let mut found = Err(Declined::scene("the backend asked for no session"));
    unperturbed.with_session(session.scene(), &mut |session| found = solved(session, objects))?;
    found
}

/// [`nearest`] by a session whose zeros are zeros.
fn solved(session: &dyn Predicates, objects: [&Indexed; 2]) -> Result<Nearest, Declined> {
    let scene = session.scene();
    for kind in asks(scene.dimension()) {
        session.supports(kind)?;
    }
    let asking = Asking { session };
    let [first, second] = objects.map(Indexed::object);
    let (near, least) = near(scene, [first, second], objects.map(|object| &object.parts));
    let parts = |[i, j]: [u32; 2]| [first.part(i), second.part(j)];
    let do_cross = |[one, other]: [&[_]; 2]| asking.cross(one, other);
    if near.iter().filter(|near| near.meet).any(|near| do_cross(parts(near.parts))) {
        return Ok(Nearest { kind: Kind::Crossing, pairs: Vec::new() });
    }
    let mut best: Vec<Pair> = Vec::new();
    // A pair of features is asked about where the first parts that have them are near: the boxes of these parts are not
    // farther apart than those of the features.
    for near in near {
        let [of_first, of_second] = [0, 1].map(|at: usize| &objects[at].owned[near.parts[at] as usize]);
        for ((one, box_of_one), (other, box_of_other)) in
            of_first.iter().flat_map(|one| of_second.iter().map(move |other| (one, other)))
        {
            let pair = [*one, *other];
            let is_asked = is_measured(scene.dimension(), &pair) && bounds::below(box_of_one, box_of_other) <= least;
            if !is_asked || !asking.is_inside(&pair) {
                continue;
            }
            match best.first().map_or(Sign::Negative, |nearest| asking.compare(&pair, nearest)) {
                Sign::Negative => best = vec![pair],
                Sign::Zero => best.push(pair),
                Sign::Positive => {}
            }
        }
    }
    let meets = best.first().is_some_and(|nearest| asking.meets(nearest));
    let is_inside = [[0, 1], [1, 0]].into_iter().any(|[one, other]| {
        // Where boundaries do not meet, one vertex speaks for its whole part.
        let all = if meets { objects[one].object.vertices() } else { Vec::new() };
        has_inside(session, objects[other], if meets { &all } else { &objects[one].one_of_each })
    });
    let kind = match (meets, is_inside) {
        (false, false) => Kind::Apart,
        (true, false) => Kind::Touching,
        (true, true) => Kind::Crossing,
        (false, true) => Kind::Contained,
    };
    best.sort_unstable();
    Ok(Nearest { kind, pairs: if is_inside { Vec::new() } else { best } })
}
