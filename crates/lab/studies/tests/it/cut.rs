//! A lattice of tetrahedra cut by surfaces: right contacts lose no volume, wrong ones do.

use predicament_contacts::algorithm::pairs::{Contact, Contacts};
use predicament_effort::some_or_all;
use predicament_mesh::Simplex;
use predicament_predicates::Predicates;
use predicament_studies::cut::{Cut, Deviation, Made, Measured, Pieces, Placement, Row, Scene, Shape, pieces, sides};
use predicament_studies::{Common, Study};
use predicament_tasks::Contestant;

use crate::{backend, quiet};

fn cuts(backends: &[&str]) -> Measured {
    survey(&cut(backends))
}

fn cut(backends: &[&str]) -> Cut {
    Cut {
        shapes: Vec::new(),
        placements: Vec::new(),
        backends: backends.iter().map(|&name| name.to_owned()).collect(),
        cubes: 6,
        checked: 100,
        planted: false,
        common: Common { seed: 3, ..Common::default() },
    }
}

fn survey(cut: &Cut) -> Measured {
    let made: Vec<Box<dyn Contestant>> = cut.backends().iter().map(|name| backend(name)).collect();
    let made: Vec<&dyn Contestant> = made.iter().map(AsRef::as_ref).collect();
    cut.survey(&made, &quiet()).unwrap()
}

fn name(row: &Row) -> String {
    format!("{}, {} by {}", row.shape.name(), row.placement.name(), row.backend)
}

#[test]
fn right_contacts_lose_no_volume() {
    let measured = cuts(&["exact", "sos", "sos:per-mesh", "tolerance"]);
    assert_eq!(measured.rows.len(), 3 * 3 * 4);
    for row in &measured.rows {
        let name = name(row);
        let made = row.made.as_ref().unwrap();
        let pieces = &made.pieces;
        assert_eq!((row.tetrahedra, row.whole), (6 * 216, 216.0));
        assert_eq!((pieces.inconsistent, pieces.undecided, made.sides.unknown), (0, 0, 0), "{name}");
        assert!((pieces.sum - row.whole).abs() < 1e-9 && pieces.lost == 0.0, "{name}");
        // One by one they equal the result of exact contacts, up to rounding.
        let Deviation { checked, off, .. } = made.deviation;
        assert!((40..=100).contains(&checked) && row.near > 100, "{name}: {checked} of {}", row.near);
        if row.backend != "tolerance" {
            assert_eq!(off, 0, "{name}: {:?}", made.deviation);
        } else if row.placement == Placement::Near {
            assert!(off > 10, "{name}: {:?}", made.deviation);
        }
        // The error is the bends of the surface within tetrahedra: a plane has none.
        let bound =
            if row.shape == Shape::Plane && row.placement != Placement::General { 0.2 } else { 0.2 * row.truth };
        assert!((pieces.inside - row.truth).abs() < bound, "{name}: {} for {}", pieces.inside, row.truth);
        if row.placement == Placement::Degenerate {
            assert_eq!(made.registered([0, 0]) == 0, row.backend.starts_with("sos"), "{name}");
        }
        if row.placement == Placement::General {
            assert!(made.registered([1, 2]) > 100 && made.asked_in_tetrahedra() > 50, "{name}");
            assert!(made.registered([3, 0]) > 10 && pieces.cut > 50, "{name}: Algorithm 12");
            assert_eq!(pieces.parts, [1, 1], "{name}");
        }
    }
    // A plane through vertices of the lattice, and one beside it, by exact contacts.
    let plane = |placement| {
        let is = |row: &&Row| row.shape == Shape::Plane && row.placement == placement && row.backend == "exact";
        measured.rows.iter().find(is).unwrap()
    };
    let degenerate = plane(Placement::Degenerate);
    let made = degenerate.made.as_ref().unwrap();
    assert_eq!(degenerate.truth, 108.0);
    assert!((made.pieces.inside - 108.0).abs() < 1e-9);
    assert_eq!(made.registered([0, 0]), 49);
}

/// The figures fail if contacts are wrong.
///
/// There are tetrahedra that cannot be cut or, if an edge has two points for each one, only a wrong volume.
#[test]
fn wrong_contacts_lose_volume() {
    let measured = cuts(&["fault:contacts-one-sided"]);
    for row in measured.rows.iter().filter(|row| row.placement == Placement::General) {
        let (name, made) = (name(row), row.made.as_ref().unwrap());
        assert!((made.pieces.sum + made.pieces.lost - row.whole).abs() < 1e-9, "{name}");
        if row.shape == Shape::Plane {
            assert!((made.pieces.inside - row.truth).abs() > 0.25 * row.truth, "{name}: {}", made.pieces.inside);
        } else {
            assert!(made.pieces.inconsistent > 10 && made.pieces.lost > 1.0, "{name}: {:?}", made.pieces);
        }
    }
}

#[test]
fn volume_that_is_in_the_wrong_tetrahedron_is_found() {
    let right = Cut { shapes: vec![Shape::Sphere], ..cut(&["exact", "sos"]) };
    let planted = Cut { planted: true, ..right.clone() };
    let [honest, wrong] = [&right, &planted].map(survey);
    assert!(right.holds(&honest) && planted.holds(&wrong));
    assert!(!right.holds(&wrong) && !planted.holds(&honest));
    for (honest, wrong) in honest.rows.iter().zip(&wrong.rows) {
        let [honest, wrong] = [honest, wrong].map(|row| row.made.as_ref().unwrap());
        let total = |made: &Made| made.pieces.shares.iter().map(|share| share.unwrap()).sum::<f64>();
        assert!((total(honest) - total(wrong)).abs() < 1e-9 && honest.pieces.inside == wrong.pieces.inside);
        assert_eq!((honest.deviation.off, wrong.deviation.off), (0, 2));
    }
}

/// The pieces from these contacts, and the number of contradicted edges.
fn pieces_of(scene: &Scene, contacts: &Contacts) -> (usize, Pieces) {
    let mut found = None;
    let both = scene.complexes.both();
    let mut cut = |session: &mut dyn Predicates| {
        let sides = sides(&*session, both, contacts);
        found = Some((sides.contradicted.len(), pieces(&scene.scene, both[0], &sides)));
    };
    backend("sos").with_session(&scene.scene, &mut cut).unwrap();
    found.unwrap()
}

#[test]
fn one_wrong_contact_loses_the_tetrahedra_around_it() {
    let scene = Scene::new(Shape::Plane, Placement::General, 6, 3);
    let measured = cuts(&["exact"]);
    let is = |row: &&Row| row.shape == Shape::Plane && row.placement == Placement::General;
    let right = measured.rows.iter().find(is).unwrap().made.as_ref().unwrap();
    assert_eq!(pieces_of(&scene, &right.contacts), (0, right.pieces.clone()));

    // Lost: all tetrahedra around the edge.
    let lattice = &scene.complexes.a;
    let at = right.contacts.registered.iter().position(|contact| contact.a.rank == 1 && contact.b.rank == 2).unwrap();
    let mut lost = right.contacts.clone();
    let edge = lattice.vertices_of(lost.registered.remove(at).a);
    let around = lattice.tetrahedra().iter().filter(|corners| edge.iter().all(|end| corners.contains(end))).count();
    let (contradicted, pieces) = pieces_of(&scene, &lost);
    assert_eq!((contradicted, pieces.inconsistent), (1, around));
    assert!(around > 0 && (pieces.lost * 6.0 - f64::from(u32::try_from(around).unwrap())).abs() < 1e-9);

    // Merged: a vertex of the lattice mistaken for one of the surface is consistent, and changes the volume.
    let mut merged = right.contacts.clone();
    let end = Simplex { rank: 0, index: u32::try_from(lattice.vertices().binary_search(&edge[0]).unwrap()).unwrap() };
    let vertex = Simplex { rank: 0, index: 0 };
    merged.registered.insert(0, Contact { a: end, b: vertex, on_a: [1.0, 0.0, 0.0, 0.0], on_b: [1.0, 0.0, 0.0, 0.0] });
    let (contradicted, pieces) = pieces_of(&scene, &merged);
    assert_eq!((contradicted, pieces.inconsistent, pieces.lost), (0, 0, 0.0));
    let moved = (pieces.inside - right.pieces.inside).abs();
    assert!(moved > 1e-3 && moved < 4.0, "{moved}");
}

#[test]
fn cuts_are_the_same_every_time() {
    let rows = |measured: &Measured| {
        let row =
            |row: &Row| (name(row), row.made.as_ref().map(|made| (made.contacts.clone(), made.pieces.clone())).ok());
        measured.rows.iter().map(row).collect::<Vec<_>>()
    };
    let cut = Cut { cubes: some_or_all(4, 6), ..cut(&["tolerance"]) };
    assert_eq!(rows(&survey(&cut)), rows(&survey(&cut)));
}
