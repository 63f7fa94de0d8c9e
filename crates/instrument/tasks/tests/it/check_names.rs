//! The names in findings, reports and expectations: users write them down, so a test pins each name.

use predicament_contacts::checks::audit::{PairKind, Symbol, Verdict};
use predicament_interval::checks::PartitionFault;
use predicament_laws::axioms::Law;
use predicament_overlay::checks::{overlay, snap};
use predicament_polygon_locate::checks::Fault;
use predicament_polygon_locate::truth::Ground;
use predicament_slice::checks as slice;

#[test]
fn checks_of_overlays() {
    use overlay::Check;
    let names = [
        (Check::Nodes, "nodes"),
        (Check::Chain, "chain"),
        (Check::OnSegment, "node off its segment"),
        (Check::Edges, "edges"),
        (Check::Crossing, "undiscovered crossing"),
        (Check::Euler, "euler"),
        (Check::Boundary, "boundary"),
        (Check::Nesting, "nesting"),
        (Check::Winding, "winding"),
        (Check::Orientation, "loop orientation"),
        (Check::ResultCrossing, "crossing loops"),
        (Check::Area, "area"),
        (Check::Membership, "membership"),
    ];
    for (check, name) in names {
        assert_eq!(check.name(), name);
        assert!(check.law().len() > 10, "{name} says what should hold: {}", check.law());
    }
    assert_eq!(Check::Nodes.law(), "two nodes are not at the same place");
}

#[test]
fn checks_of_slices() {
    use slice::Check;
    let names = [
        (Check::Closed, "part not closed"),
        (Check::Side, "wrong side"),
        (Check::CapInPlane, "cap not in its plane"),
        (Check::CapOrientation, "cap orientation"),
        (Check::PieceInFace, "piece not in its face"),
        (Check::PieceOrientation, "piece orientation"),
        (Check::FaceArea, "face area"),
        (Check::Volume, "volume"),
        (Check::Degenerate, "triangle without area"),
        (Check::SelfIntersection, "self-intersection"),
    ];
    for (check, name) in names {
        assert_eq!(check.name(), name);
        assert!(check.law().len() > 10, "{name} says what should hold: {}", check.law());
    }
    assert_eq!(Check::CapInPlane.law(), "caps are in their planes");
}

#[test]
fn flaws_of_rounded_drawings() {
    use snap::Flaw;
    let names = [
        (Flaw::Ends(0), "ends"),
        (Flaw::NotHot(0), "hot pixels only"),
        (Flaw::Missing(0), "all hot pixels"),
        (Flaw::Strange(0), "own hot pixels only"),
        (Flaw::Backwards(0), "one way"),
        (Flaw::Crossing(0, 1), "no new crossing"),
        (Flaw::Near(0), "no vertex near an edge"),
    ];
    for (flaw, name) in names {
        assert_eq!(flaw.name(), name);
    }
}

#[test]
fn faults_of_tilings_and_partitions_and_their_ground() {
    let faults = [
        (Fault::Gap, "gap", true),
        (Fault::Double, "double", true),
        (Fault::Misplaced, "misplaced", true),
        (Fault::FalseBoundary, "false-boundary", false),
        (Fault::MissedBoundary, "missed-boundary", false),
        (Fault::UnbrokenTie, "unbroken-tie", false),
    ];
    for (fault, name, is_topological) in faults {
        assert_eq!((fault.name(), fault.is_topological()), (name, is_topological));
    }
    let grounds = [
        (Ground::Land, "land"),
        (Ground::Coast, "coast"),
        (Ground::Sea, "sea"),
        (Ground::Overlap, "overlap"),
        (Ground::Defect, "defect"),
    ];
    for (ground, name) in grounds {
        assert_eq!(ground.name(), name);
    }
    let faults = [(PartitionFault::Gap, "gap"), (PartitionFault::Double, "double"), (PartitionFault::Stray, "stray")];
    for (fault, name) in faults {
        assert_eq!(fault.name(), name);
    }
}

#[test]
fn laws_of_predicates() {
    let names = [
        (Law::NeverZero, "never-zero"),
        (Law::Antisymmetry, "antisymmetry"),
        (Law::Transitivity, "transitivity"),
        (Law::GrassmannPlucker, "grassmann-plucker"),
        (Law::MixedGrassmannPlucker, "mixed-grassmann-plucker"),
        (Law::Place, "independence-of-place"),
        (Law::LaterVertices, "independence-of-later-vertices"),
        (Law::Reference, "equals-exact"),
    ];
    for (law, name) in names {
        assert_eq!(law.name(), name);
    }
}

#[test]
fn pairs_verdicts_and_symbols_of_the_audit() {
    let pairs = [
        (PairKind::VertexVertex, "vertex-vertex"),
        (PairKind::EdgeVertex, "edge-vertex"),
        (PairKind::EdgeEdge, "edge-edge"),
        (PairKind::TriangleVertex, "triangle-vertex"),
        (PairKind::TriangleEdge, "triangle-edge"),
        (PairKind::TetrahedronVertex, "tetrahedron-vertex"),
    ];
    for (kind, name) in pairs {
        assert_eq!(kind.name(), name);
    }
    let verdicts = [
        (Verdict::Agree, "agree"),
        (Verdict::InBand, "in_band"),
        (Verdict::Overreach, "overreach"),
        (Verdict::Missed, "missed"),
        (Verdict::Unguarded, "unguarded"),
        (Verdict::BadWeight, "bad_weight"),
        (Verdict::Unasked, "unasked"),
        (Verdict::Misread, "misread"),
    ];
    for (verdict, name) in verdicts {
        assert_eq!(verdict.name(), name);
    }
    // As in the paper, with the hat of σ as a combining character.
    let symbols = [
        (Symbol::Sigma, "σ"),
        (Symbol::Tau, "τ"),
        (Symbol::Delta, "δ"),
        (Symbol::Gamma, "γ"),
        (Symbol::SigmaHat, "σ\u{302}"),
        (Symbol::Kappa, "κ"),
        (Symbol::Lambda, "λ"),
        (Symbol::Phi, "φ"),
        (Symbol::Nu, "ν"),
        (Symbol::Zeta, "ζ"),
        (Symbol::Mu, "μ"),
        (Symbol::Xi, "ξ"),
        (Symbol::Rho, "ρ"),
    ];
    for (symbol, name) in symbols {
        assert_eq!(symbol.name(), name);
    }
}
