//! Tests of tilings, sound and flawed, under exact, perturbed and faulty sessions.

mod reports;

use crate::common::faulty::{Fault as Planted, Faulty};
use crate::common::problems::{Problem, bricks, island, square_cells, squares};
use predicament_controls::Naive;
use predicament_exact::Exact;
use predicament_polygon_locate::algorithm::{LocateIndex, Locations, question_all};
use predicament_polygon_locate::checks::{Fault, TilingReport, TilingViolation, tiling_report};
use predicament_polygon_locate::truth::{Edges, Flaws, Ground, Surroundings, map_flaws, surroundings};
use predicament_predicates::{Backend, Off, Predicates, Vertex, ZeroMeaning};
use predicament_sos::{Scheme, Sos};

struct Case {
    problem: Problem,
    index: LocateIndex,
    edges: Edges,
    surroundings: Surroundings,
    flaws: Flaws,
}

impl Case {
    fn new(problem: Problem) -> Case {
        let index = LocateIndex::new(&problem.map, &problem.scene);
        let exact = Exact.prepare(&problem.scene, Off).unwrap();
        let edges = Edges::new(&problem.map, &problem.scene);
        let surroundings = surroundings(&edges, &exact, &problem.probes);
        let flaws = map_flaws(&edges, &exact);
        Case { surroundings, flaws, edges, index, problem }
    }

    fn locate<P: Predicates>(&self, session: &P) -> Locations {
        question_all(&self.index, session, &self.problem.probes, &|_| true)
    }

    fn report<P: Predicates>(&self, session: &P, zero: ZeroMeaning) -> TilingReport {
        tiling_report(&self.surroundings, &self.locate(session), zero)
    }

    /// Asserts that exact and both perturbed sessions have no violations.
    fn assert_lawful(&self) {
        let exact = Exact.prepare(&self.problem.scene, Off).unwrap();
        assert_eq!(self.report(&exact, ZeroMeaning::Exact).violations(), []);
        for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
            let sos = Sos { scheme };
            let report = self.report(&sos.prepare(&self.problem.scene, Off).unwrap(), ZeroMeaning::Never);
            assert_eq!(report.violations(), [], "{scheme}");
        }
    }

    fn grounds(&self) -> Vec<Ground> {
        let mut grounds: Vec<Ground> = (0..self.surroundings.len()).map(|at| self.surroundings.ground(at)).collect();
        grounds.sort_unstable();
        grounds.dedup();
        grounds
    }

    /// The ground at the first probe with these coordinates.
    fn ground_at(&self, point: [f64; 2]) -> Ground {
        let is_there = |&probe: &Vertex| self.problem.scene.point(probe) == point;
        let probe = self.problem.probes.iter().position(is_there).expect("a probe is there");
        self.surroundings.ground(probe)
    }

    fn with_fault(&self, fault: Planted) -> TilingReport {
        let sos = Sos::default();
        let inner = sos.prepare(&self.problem.scene, Off).unwrap();
        self.report(&Faulty { inner, fault }, ZeroMeaning::Never)
    }
}

#[test]
fn sound_maps_obey_the_law_everywhere() {
    for problem in [squares(6), bricks(5), island()] {
        for problem in [problem.scattered(), problem.scattered().scattered(), problem] {
            let case = Case::new(problem);
            assert_eq!(case.flaws, Flaws::default());
            assert_eq!(case.grounds(), [Ground::Land, Ground::Coast, Ground::Sea]);
            case.assert_lawful();
        }
    }
}

#[test]
fn a_perturbation_puts_every_point_of_the_land_in_exactly_one_region() {
    let case = Case::new(squares(6));
    let sos = Sos::default();
    let session = sos.prepare(&case.problem.scene, Off).unwrap();
    let report = case.report(&session, ZeroMeaning::Never);
    let land = report.counts(Ground::Land);
    assert!(land.one > 500 && land.none == 0 && land.more == 0, "{land:?}");
    assert_eq!(land.boundary, 25, "the inner vertices of the map themselves");
    let coast = report.counts(Ground::Coast);
    assert!(coast.none > 0 && coast.one > 0 && coast.more == 0, "{coast:?}");
    assert_eq!(report.counts(Ground::Sea).none, report.counts(Ground::Sea).probes());
    let all: usize = Ground::ALL.iter().map(|&ground| report.counts(ground).probes()).sum();
    assert_eq!(all, case.problem.probes.len());
    // the closed-set answer to the same probes
    let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
    let land = case.report(&exact, ZeroMeaning::Exact).counts(Ground::Land);
    assert!(land.boundary > 100 && land.one > 100 && land.none == 0, "{land:?}");
}

#[test]
fn sectors_are_counted_around_vertices() {
    let case = Case::new(squares(3));
    let at = |point: [f64; 2]| {
        let probe = case.problem.probes.iter().position(|&v| case.problem.scene.point(v) == point).unwrap();
        let sectors: Vec<Vec<u32>> = case.surroundings.sectors(probe).map(<[u32]>::to_vec).collect();
        (case.surroundings.ground(probe), case.surroundings.boundary(probe).to_vec(), sectors)
    };
    let one = |r: u32| vec![r];
    assert_eq!(at([1., 1.]), (Ground::Land, vec![0, 1, 3, 4], [0, 1, 3, 4].map(one).to_vec()));
    assert_eq!(at([0.5, 1.]), (Ground::Land, vec![0, 3], [0, 3].map(one).to_vec()));
    assert_eq!(at([0., 1.]), (Ground::Coast, vec![0, 3], vec![vec![], one(0), one(3)]));
    assert_eq!(at([1.25, 1.125]), (Ground::Land, vec![], vec![one(4)]));
    assert_eq!(at([3., 0.0_f64.next_down()]), (Ground::Sea, vec![], vec![vec![]]));
}

#[test]
fn a_planted_gap_is_sea_and_an_overlap_is_the_maps_own() {
    let (corners, mut regions) = square_cells(3);
    let hole = regions.remove(4);
    let case = Case::new(Problem::new(&corners, &regions));
    assert!(case.flaws.is_empty());
    assert_eq!(case.ground_at([1.25, 1.125]), Ground::Sea);
    case.assert_lawful();

    regions.extend([hole.clone(), hole]);
    let case = Case::new(Problem::new(&corners, &regions));
    assert!(case.flaws.is_empty());
    assert_eq!(case.ground_at([1.25, 1.125]), Ground::Overlap);
    assert_eq!(case.ground_at([1., 1.]), Ground::Overlap);
    assert_eq!(case.ground_at([0.25, 0.125]), Ground::Land);
    case.assert_lawful();
}

#[test]
fn a_t_junction_is_a_defect_where_it_is_and_nowhere_else() {
    // two cells on one side of an edge, one on the other, which lacks their
    // common vertex (1, 1); its lower neighbours are sound
    let corners = [[0., 0.], [2., 0.], [2., 1.], [1., 1.], [0., 1.], [0., 2.], [1., 2.], [2., 2.]];
    let regions = [vec![vec![0, 1, 2, 4]], vec![vec![4, 3, 6, 5]], vec![vec![3, 2, 7, 6]]];
    let case = Case::new(Problem::new(&corners, &regions));
    let v = Vertex::input;
    assert_eq!(case.flaws.junctions, [([v(2), v(4)], v(3))]);
    assert_eq!(case.flaws.overlaps, [[[v(2), v(3)], [v(2), v(4)]], [[v(2), v(4)], [v(3), v(4)]]]);
    assert_eq!(case.flaws.len(), 3);
    assert_eq!(case.ground_at([1., 1.]), Ground::Defect);
    assert_eq!(case.ground_at([0.5, 1.]), Ground::Defect, "two edges lie there");
    assert_eq!(case.ground_at([1., 0.75]), Ground::Land, "below it");
    assert_eq!(case.ground_at([0., 0.5]), Ground::Coast, "beside it");
    case.assert_lawful();
}

#[test]
fn crossings_and_duplicates_are_found() {
    let v = Vertex::input;
    let corners = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [2., 2.], [6., 2.], [6., 6.], [2., 6.]];
    let case = Case::new(Problem::new(&corners, &[vec![vec![0, 1, 2, 3]], vec![vec![4, 5, 6, 7]]]));
    assert_eq!(case.flaws.crossings, [[[v(1), v(2)], [v(4), v(5)]], [[v(2), v(3)], [v(4), v(7)]]]);
    assert_eq!(case.flaws.len(), 2);
    assert_eq!(case.ground_at([4., 2.]), Ground::Defect);
    assert_eq!(case.ground_at([4.25, 2.125]), Ground::Land, "beside the crossing");
    assert_eq!(case.ground_at([2.25, 2.125]), Ground::Overlap);
    assert_eq!(case.grounds(), Ground::ALL);
    case.assert_lawful();

    // neighbours with a border of their own each: equal coordinates, other ids
    let corners = [[0., 0.], [2., 0.], [2., 2.], [0., 2.], [2., 0.], [4., 0.], [4., 2.], [2., 2.]];
    let case = Case::new(Problem::new(&corners, &[vec![vec![0, 1, 2, 3]], vec![vec![4, 5, 6, 7]]]));
    assert_eq!(case.flaws.duplicates, [[v(1), v(4)], [v(2), v(7)]]);
    assert_eq!(case.flaws.overlaps, [[[v(1), v(2)], [v(4), v(7)]]]);
    assert_eq!(case.flaws.len(), 3);
    assert_eq!(case.ground_at([2., 0.]), Ground::Defect);
    assert_eq!(case.ground_at([2., 1.]), Ground::Defect);
    assert_eq!(case.ground_at([1., 0.]), Ground::Coast);
    case.assert_lawful();
}

/// Tests that a defect excuses only itself: if the law also applied to defects, a perturbation would open the gap that
/// the flaw is about.
#[test]
fn defects_are_where_perturbations_open_gaps() {
    let corners = [[0., 0.], [2., 0.], [2., 2.], [0., 2.], [2., 0.], [4., 0.], [4., 2.], [2., 2.]];
    let mut torn = 0;
    for order in 0..2 {
        // either side first: the border that moves further right is another one
        let regions = [vec![vec![0, 1, 2, 3]], vec![vec![4, 5, 6, 7]]];
        let mut corners = corners;
        corners.rotate_left(4 * order);
        let case = Case::new(Problem::new(&corners, &regions));
        let sos = Sos::default();
        let report = case.report(&sos.prepare(&case.problem.scene, Off).unwrap(), ZeroMeaning::Never);
        let counts = report.counts(Ground::Defect);
        torn += counts.none + counts.more;
    }
    assert!(torn > 0);
}

#[test]
fn planted_faults_are_caught() {
    let case = Case::new(squares(4));
    assert_eq!(case.with_fault(Planted::None).violations(), []);

    // the probe at the vertex (2, 2), and the corners around it
    let probe = case.problem.probes.iter().position(|&v| case.problem.scene.point(v) == [2., 2.]).unwrap();
    let id = case.problem.probes[probe].index();
    let corner = |x: usize, y: usize| x + 5 * y;
    for (x, y) in [(2, 2), (2, 3)] {
        let report = case.with_fault(Planted::MirroredPair([corner(x, y), id]));
        assert_eq!(report.violations().iter().map(|v| v.probe).collect::<Vec<_>>(), [probe], "({x}, {y})");
    }
    // one turn: the perturbed ray goes up through one of two neighbouring edges
    let caught = [(1, 2), (2, 3)].map(|(left, right)| {
        let report = case.with_fault(Planted::FlippedTriple([corner(left, 3), corner(right, 3), id]));
        assert!(report.violations().iter().all(|v| v.probe == probe && v.fault.is_topological()));
        report.violations().len()
    });
    assert_eq!(caught.iter().sum::<usize>(), 1, "{caught:?}");

    // every tied turn separately: at a corner the answers do not fit together
    let scattered = Case::new(squares(4).scattered());
    assert_eq!(scattered.with_fault(Planted::None).violations(), []);
    let report = scattered.with_fault(Planted::TiesByParity);
    let on_land = |v: &TilingViolation| v.ground == Ground::Land && v.fault == Fault::Double;
    assert!(report.violations().iter().any(on_land), "{:?}", report.violations());

    // an epsilon without a promise puts points on boundaries that do not contain them
    let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
    let faulty = Faulty { inner: exact, fault: Planted::Epsilon(1e-10) };
    let report = case.report(&faulty, ZeroMeaning::Exact);
    assert!(report.violations().iter().any(|v| v.fault == Fault::FalseBoundary));
    assert_eq!(case.report(&faulty, ZeroMeaning::Band).violations(), [], "with a promise it is a legal answer");
    // and zeros do not break ties
    let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
    let report = case.report(&exact, ZeroMeaning::Never);
    assert!(report.violations().iter().all(|v| v.fault == Fault::UnbrokenTie));
    assert!(!report.violations().is_empty());
}

/// Tests that ties by one fixed rule are lawful: points on an edge count as above it, and a tie in x always breaks the
/// same way. This is a consistent perturbation too: only the probe moves.
#[test]
fn ties_by_one_fixed_rule_are_lawful() {
    for problem in [squares(4), bricks(4), island()] {
        let case = Case::new(problem);
        for planted in [Planted::TiesUp, Planted::TiesByPlace] {
            let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
            let report = case.report(&Faulty { inner: exact, fault: planted }, ZeroMeaning::Band);
            assert_eq!(report.violations(), [], "{planted:?}");
        }
    }
}

#[test]
fn plain_floating_point_is_caught_on_a_slanted_tiling() {
    // squares turned by a few degrees, with coordinates that round
    let (corners, regions) = square_cells(8);
    let turned: Vec<[f64; 2]> =
        corners.iter().map(|[x, y]| [0.1 + 0.97 * x - 0.23 * y, 0.3 + 0.23 * x + 0.97 * y]).collect();
    let case = Case::new(Problem::new(&turned, &regions));
    assert!(case.flaws.is_empty());
    case.assert_lawful();
    let naive = Naive::default();
    let report = case.report(&naive.prepare(&case.problem.scene, Off).unwrap(), ZeroMeaning::Exact);
    assert!(!report.violations().is_empty());
}

#[test]
fn an_incomplete_answer_is_judged_as_far_as_it_goes() {
    let case = Case::new(squares(3));
    let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
    let few = question_all(&case.index, &exact, &case.problem.probes[..10], &|_| true);
    let report = tiling_report(&case.surroundings, &few, ZeroMeaning::Exact);
    let all: usize = Ground::ALL.iter().map(|&ground| report.counts(ground).probes()).sum();
    assert_eq!((all, report.violations()), (10, &[][..]));
}
