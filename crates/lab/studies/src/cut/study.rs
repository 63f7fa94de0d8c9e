//! The survey of cuts.

use std::time::Instant;

use predicament_predicates::{Declined, PredicateKind, Predicates, ZeroMeaning};
use predicament_report::text::in_order;
use predicament_tasks::{AnswerError, Contestant, Refusal};

use super::measured::{Cut, Made, Measured, Row};
use super::{Deviation, Exactly, Placement, Scene, Shape, pieces, sides, table};
use crate::contacts::contacts;
use crate::{Common, Error, File, Host, Study};

/// The backend that locates a vertex if there may be ties.
const TIES: &str = "sos";

impl Study for Cut {
    const NAME: &'static str = "cut";
    const ASKS: &'static str = "Cut a lattice of tetrahedra by a surface, and count lost volume, slivers and parts";
    const HELP: &'static str = "\
A triangulated surface cuts a lattice of tetrahedra. The cut uses only the contacts that a backend registers: \
vertices of the lattice on the surface, points where its edges pass through the surface, vertices of the surface in \
tetrahedra (Algorithm 12). Edges without a degenerate contact connect vertices; the number of points between two \
connected vertices gives their sides. One vertex of each connected set is located by a ray (with sos, or with the \
backend's own broken ties).

If the points on an edge contradict the sides of its ends, its tetrahedra are inconsistent: they have no pieces, and \
their volume is lost. A tetrahedron is cut in two pieces or in none, so no volume is counted twice. The volume inside \
is compared with the true volume, in rationals. A tetrahedron is cut by one or two planes, but the surface may bend \
inside it: the error of exact contacts comes from the method, not from the contacts. Therefore a sample of the \
tetrahedra near the surface (--checked) is compared one by one with the result of exact contacts, in rationals. A \
tetrahedron is off if its share inside differs by more than 2^-44, or if it has no pieces.

Files in the folder: cut.csv, cut-times.csv, cut.md. Everything except times is the same in every run.

Exit code 100 if a backend whose zeros are exact, or that has no zeros, has an inconsistent tetrahedron or one that \
is off; with --planted, if an exchange is not found.

Examples:
  predicament study cut
  predicament study cut --cubes 26 --out target/cut
  predicament study cut -s sphere -p near -b tolerance,fault:contacts-one-sided
  predicament study cut --cubes 6 --planted";

    type Measured = Measured;

    fn backends(&self) -> Vec<String> {
        let mut names = self.backends.clone();
        if !names.iter().any(|name| name == TIES) {
            names.push(TIES.to_owned());
        }
        names
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Measured, Error> {
        let ties = backends.iter().find(|backend| backend.name() == TIES).copied();
        let ties = ties.ok_or_else(|| Error::unfit("cut needs sos"))?;
        let shapes = if self.shapes.is_empty() { Shape::ALL.to_vec() } else { in_order(self.shapes.iter().copied()) };
        let placements = if self.placements.is_empty() {
            Placement::ALL.to_vec()
        } else {
            in_order(self.placements.iter().copied())
        };
        let asked = &backends[..self.backends.len().min(backends.len())];
        host.begin((shapes.len() * placements.len() * asked.len()) as u64, "cuts");
        let mut rows = Vec::new();
        for shape in shapes {
            for &placement in &placements {
                let scene = Scene::new(shape, placement, self.cubes, self.common.seed);
                let exactly = Exactly::new(&scene.scene, scene.complexes.both(), self.checked);
                for &backend in asked {
                    host.turn_to(&format!("{}, {} by {}", shape.name(), placement.name(), backend.name()));
                    rows.push(Row {
                        shape,
                        placement,
                        backend: backend.name(),
                        tetrahedra: scene.complexes.a.tetrahedra().len(),
                        triangles: scene.complexes.b.triangles().len(),
                        truth: scene.inside.to_f64(),
                        whole: f64::from(self.cubes).powi(3),
                        near: exactly.near,
                        made: make(&scene, backend, ties).map(|made| self.held(made, &exactly)),
                    });
                    host.watch().done(1)?;
                }
            }
        }
        Ok(Measured { rows })
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        table::csv(measured)
    }

    fn page(&self, measured: &Measured) -> String {
        table::page(self, measured)
    }

    fn holds(&self, measured: &Measured) -> bool {
        let is_sound = |made: &Made| made.pieces.inconsistent == 0 && made.deviation.off == 0;
        measured.rows.iter().all(|row| match &row.made {
            Ok(made) if self.planted => made.deviation.off > 0,
            made => !promises(&row.backend) || made.as_ref().is_ok_and(is_sound),
        })
    }
}

/// Returns true if zeros are exact or never answered, so that all contacts are consistent.
fn promises(backend: &str) -> bool {
    backend == "exact" || backend.starts_with(TIES)
}

impl Cut {
    /// The result with the deviations of its tetrahedra from the exact shares.
    fn held(&self, mut made: Made, exactly: &Exactly) -> Made {
        if self.planted {
            made.pieces.exchange(exactly.shares.iter().map(|(at, _)| *at));
        }
        made.deviation = exactly.hold(&made.pieces.shares);
        made
    }
}

fn make(scene: &Scene, backend: &dyn Contestant, ties: &dyn Contestant) -> Result<Made, AnswerError> {
    let both = scene.complexes.both();
    let start = Instant::now();
    let registered = contacts(backend, &scene.scene, both)?;
    let registering = start.elapsed();
    // Vertices on the surface are on a side only if the backend's own tie breaking says so.
    let breaks = backend.contract(PredicateKind::Orient3d).zero == ZeroMeaning::Never;
    let locator = if breaks { backend } else { ties };
    let start = Instant::now();
    let mut found = None;
    let refused = |why| AnswerError::Refused(Refusal { check: "prepare", why });
    locator
        .with_session(&scene.scene, &mut |session: &mut dyn Predicates| {
            found = Some(sides(&*session, both, &registered));
        })
        .map_err(refused)?;
    let sides = found.ok_or_else(|| refused(Declined::scene("the backend asked for no session")))?;
    let pieces = pieces(&scene.scene, both[0], &sides);
    let cutting = start.elapsed();
    Ok(Made { contacts: registered, sides, pieces, deviation: Deviation::default(), registering, cutting })
}
