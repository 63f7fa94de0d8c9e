//! Franklin and Magalhães' own point-in-polygon test, on coordinates, beside
//! the generic code, on sessions: what being generic costs.
//!
//! Index, sums and output are the same for both. The one sign that the test
//! needs is had from `robust`, and from our `exact` without a scene.

use std::hint::black_box;
use std::rc::Rc;
use std::time::{Duration, Instant};

use predicament_exact::raw;
use predicament_polygon_locate::algorithm::special::Point;
use predicament_polygon_locate::algorithm::{Location, Scratch};
use predicament_predicates::{Plane, Sign};
use predicament_records::Interface;
use predicament_tasks::{AnyCase, Class, Outcome, Stopwatch, digest};
use robust::Coord;

use super::located::Case;
use super::{Peer, Timed};

/// Both sources of the sign, judged and ready to be timed, where the case is a map.
pub fn peers(case: &dyn AnyCase) -> Vec<Peer<'_>> {
    Case::of(case).map(of).unwrap_or_default()
}

fn of(case: Case<'_>) -> Vec<Peer<'_>> {
    let coord = |[x, y]: Point| Coord { x, y };
    let by_robust = move |l, r, p| Sign::of(robust::orient2d(coord(l), coord(r), coord(p)));
    let by_exact = |l, r, p| raw::orient2d([l, r, p]);
    vec![
        peer(case.clone(), "special", env!("PREDICAMENT_ROBUST"), by_robust),
        peer(case, "special:exact", env!("CARGO_PKG_VERSION"), by_exact),
    ]
}

fn peer<'a>(
    case: Case<'a>,
    name: &str,
    version: &str,
    sign_of_d: impl Fn(Point, Point, Point) -> Sign + 'a,
) -> Peer<'a> {
    let probes = case.probes.len();
    let mut watch = Watch { case, sign_of_d, scratch: Scratch::new(), out: Vec::new() };
    let wrong: Vec<usize> = (0..probes).filter(|&probe| !watch.is_right(probe)).collect();
    watch.pass();
    let (wrongs, queries, judged) = (wrong.len() as u64, probes as u64, watch.digest());
    let mut outcome = Outcome { queries, ..Outcome::default() };
    outcome.counts.add(Class::Agree, queries - wrongs);
    outcome.counts.add(Class::Topology, wrongs);
    let remark = |first: &usize| format!("{name}: {wrongs} wrong; the first is probe {first}");
    Peer {
        name: name.to_owned(),
        version: version.to_owned(),
        outcome,
        remarks: wrong.first().map(remark).into_iter().collect(),
        timed: Some(Timed { watch: Box::new(watch), interface: Interface::Whole, judged }),
    }
}

struct Watch<'a, D> {
    case: Case<'a>,
    sign_of_d: D,
    scratch: Scratch,
    /// For each probe how many regions it is inside of and on, then the regions.
    out: Vec<u32>,
}

impl<D: Fn(Point, Point, Point) -> Sign> Watch<'_, D> {
    /// Whether an answer is the exact one, as far as the test promises: it
    /// sees only points that are on a boundary there, and of those not all.
    fn is_right(&mut self, probe: usize) -> bool {
        let exact = Rc::clone(&self.case.exact);
        let truth = Location { inside: exact.inside(probe), boundary: exact.boundary(probe) };
        let point = self.case.scene.point2(Plane::Xy, self.case.probes[probe]);
        let answer = self.case.index.locate_specially(point, &self.sign_of_d, &mut self.scratch);
        let off = answer.inside.iter().filter(|region| !truth.boundary.contains(region));
        off.eq(truth.inside) && answer.boundary.iter().all(|region| truth.boundary.contains(region))
    }
}

impl<D: Fn(Point, Point, Point) -> Sign> Stopwatch for Watch<'_, D> {
    fn pass(&mut self) -> Duration {
        self.out.clear();
        let start = Instant::now();
        for &probe in &self.case.probes {
            let point = self.case.scene.point2(Plane::Xy, probe);
            let location = self.case.index.locate_specially(point, &self.sign_of_d, &mut self.scratch);
            // A map has far fewer than 2^32 regions, so both lengths fit.
            #[allow(clippy::cast_possible_truncation)]
            self.out.extend([location.inside.len() as u32, location.boundary.len() as u32]);
            self.out.extend(location.inside);
            self.out.extend(location.boundary);
        }
        black_box(&mut self.out);
        start.elapsed()
    }

    fn digest(&self) -> u64 {
        digest(self.out.iter().copied().flat_map(u32::to_le_bytes))
    }
}
