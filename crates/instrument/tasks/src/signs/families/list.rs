//! The families by name, and the predicates for which they make queries.

use std::sync::OnceLock;

use predicament_corpus::{Family, Recipe};
use predicament_families::{self as families, Kind};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::PredicateKind;

use super::{by_query, read};

/// The predicates for which a family makes queries.
#[derive(Clone, Copy)]
enum For {
    /// The five predicates and all formulas.
    All,
    /// The five predicates.
    Five,
    /// These of the five predicates.
    These(&'static [PredicateKind]),
    /// Formulas that are the determinant of directions in space.
    Directions,
}

const FLAT: For = For::These(&[PredicateKind::Compare, PredicateKind::Orient2d]);
const SOLID: For = For::These(&[PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d]);

/// The families that make queries for a predicate.
pub(in crate::signs) fn of(kind: PredicateKind) -> &'static [Family] {
    // All formulas have the same families, except for determinants of directions.
    static FAMILIES: [OnceLock<Vec<Family>>; PredicateKind::COUNT + 1] =
        [const { OnceLock::new() }; PredicateKind::COUNT + 1];
    let is_of_directions = matches!(kind, PredicateKind::Derived(derived)
        if derived.formula().is_determinant() && derived.formula().dimension() == 3);
    FAMILIES[if is_of_directions { PredicateKind::COUNT } else { kind.index() }].get_or_init(|| {
        let is_formula = matches!(kind, PredicateKind::Derived(_));
        let fits = |kinds: For| match kinds {
            For::All => true,
            For::Five => !is_formula,
            For::These(these) => these.contains(&kind),
            For::Directions => is_of_directions,
        };
        list().into_iter().filter(|(kinds, _)| fits(*kinds)).map(|(_, family)| family).collect()
    })
}

type Read = fn(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError>;

fn family(
    name: &'static str,
    reported_as: &'static str,
    kinds: For,
    parameters: &'static [&'static str],
    about: &'static str,
    read: Read,
) -> (For, Family) {
    (kinds, Family { name, reported_as: Some(reported_as), parameters, about, read })
}

fn list() -> Vec<(For, Family)> {
    vec![
        family("uniform", "uniform", For::All, &[], "multiples of 2^-53, uniform in [0, 1)", |task, fields| {
            by_query(task, fields, families::uniform)
        }),
        family(
            "scattered",
            "scattered",
            For::These(&[
                PredicateKind::Orient2d,
                PredicateKind::Orient3d,
                PredicateKind::Incircle,
                PredicateKind::Insphere,
            ]),
            &[],
            "random vertices among five times as many uniform points as queries",
            read::scattered,
        ),
        family("grid", "grid", For::All, &[], "integers from 0 to 15: many ties, few bits", |task, fields| {
            by_query(task, fields, families::grid)
        }),
        family(
            "near",
            "near",
            For::All,
            &["ulps"],
            "at most `ulps` ulps off a line, plane, circle or sphere",
            read::near,
        ),
        family(
            "kettner",
            "kettner",
            For::Five,
            &[],
            "0.5 + k·2^-53, k < 256, against a line, plane, circle or sphere through 0.5",
            |task, fields| by_query(task, fields, families::kettner),
        ),
        family(
            "degen",
            "degen",
            For::All,
            &[],
            "exactly degenerate in general position: every answer is 0",
            |task, fields| by_query(task, fields, read::degenerate),
        ),
        family(
            "decimal-collinear",
            "decimal-collinear",
            For::These(&[PredicateKind::Orient2d]),
            &["digits"],
            "collinear decimals, rounded to doubles",
            read::decimal,
        ),
        family(
            "decimal-coplanar",
            "decimal-coplanar",
            For::These(&[PredicateKind::Orient3d]),
            &["digits"],
            "coplanar decimals, rounded to doubles",
            read::decimal,
        ),
        family(
            "decimal-cocircular",
            "decimal-cocircular",
            For::These(&[PredicateKind::Incircle]),
            &["digits"],
            "cocircular decimals, rounded to doubles",
            read::decimal,
        ),
        family(
            "decimal-cospherical",
            "decimal-cospherical",
            For::These(&[PredicateKind::Insphere]),
            &["digits"],
            "cospherical decimals, rounded to doubles",
            read::decimal,
        ),
        family(
            "decimals",
            "decimals",
            For::These(families::Typed::KINDS),
            &["digits", "figure", "place"],
            "numbers as people write them, on a figure or one step beside it",
            read::typed,
        ),
        family(
            "midpoint-collinear",
            "midpoint-collinear",
            For::These(&[PredicateKind::Orient2d, PredicateKind::Orient3d]),
            &[],
            "two points and their rounded midpoint; in 3D with any fourth",
            |task, fields| by_query(task, fields, families::midpoint),
        ),
        family(
            "wide-scaled",
            "wide",
            For::All,
            &[],
            "uniform, near and degen queries scaled by 2^k, subnormal to 2^1023",
            |task, fields| by_query(task, fields, read::wide_scaled),
        ),
        family(
            "wide-mixed",
            "wide",
            For::All,
            &[],
            "every coordinate with its own exponent, subnormal to 2^1023",
            |task, fields| by_query(task, fields, families::wide_mixed),
        ),
        family("far", "far", For::All, &[], "unit clusters 2^20 to 2^45 away from the origin", |task, fields| {
            by_query(task, fields, families::far)
        }),
        family(
            "band",
            "band",
            For::These(&[PredicateKind::Orient2d, PredicateKind::Orient3d]),
            &[],
            "determinants around the tolerance scheme's thresholds",
            read::band,
        ),
        family(
            "pixel-map",
            "pixel-map",
            For::These(&[PredicateKind::Orient2d]),
            &["p", "q", "r", "side", "step"],
            "a square of neighbours of p against fixed q and r (Kettner et al.)",
            read::pixels,
        ),
        family(
            "sphere",
            "sphere",
            For::Directions,
            &["figure"],
            "directions of length 1 up to roundings, general or on a great circle, opposite, halfway, or close",
            read::sphere,
        ),
        family(
            "ssi-uniform",
            "ssi-uniform",
            FLAT,
            &["halvings"],
            "two lines' meeting points and input points, all uniform in [0, 1)",
            |task, fields| read::constructed_uniform(task, fields, &[Kind::Ssi]),
        ),
        family(
            "ssi-near",
            "ssi-near",
            FLAT,
            &["ulps", "halvings"],
            "two lines' meeting points at most `ulps` ulps off a tie",
            |task, fields| read::constructed_near(task, fields, &[Kind::Ssi]),
        ),
        family(
            "ssi-degen",
            "ssi-degen",
            FLAT,
            &["halvings"],
            "two lines' meeting points in exact ties: every answer is 0",
            |task, fields| read::constructed_degenerate(task, fields, &[Kind::Ssi]),
        ),
        family(
            "lpi-uniform",
            "lpi-uniform",
            SOLID,
            &["halvings"],
            "meeting points of lines and planes and input points, all uniform in [0, 1)",
            |task, fields| read::constructed_uniform(task, fields, &[Kind::Lpi]),
        ),
        family(
            "lpi-near",
            "lpi-near",
            SOLID,
            &["ulps", "halvings"],
            "meeting points of lines and planes at most `ulps` ulps off a tie",
            |task, fields| read::constructed_near(task, fields, &[Kind::Lpi]),
        ),
        family(
            "lpi-degen",
            "lpi-degen",
            SOLID,
            &["halvings"],
            "meeting points of lines and planes in exact ties: every answer is 0",
            |task, fields| read::constructed_degenerate(task, fields, &[Kind::Lpi]),
        ),
        family(
            "tpi-uniform",
            "tpi-uniform",
            SOLID,
            &["halvings"],
            "three planes' meeting points and input points, all uniform in [0, 1)",
            |task, fields| read::constructed_uniform(task, fields, &[Kind::Tpi]),
        ),
        family(
            "tpi-near",
            "tpi-near",
            SOLID,
            &["ulps", "halvings"],
            "three planes' meeting points at most `ulps` ulps off a tie",
            |task, fields| read::constructed_near(task, fields, &[Kind::Tpi]),
        ),
        family(
            "tpi-degen",
            "tpi-degen",
            SOLID,
            &["halvings"],
            "three planes' meeting points in exact ties: every answer is 0",
            |task, fields| read::constructed_degenerate(task, fields, &[Kind::Tpi]),
        ),
        family(
            "lpi-tpi-uniform",
            "lpi-tpi-uniform",
            SOLID,
            &["halvings"],
            "both kinds of meeting points in space and input points, all uniform in [0, 1)",
            |task, fields| read::constructed_uniform(task, fields, &[Kind::Lpi, Kind::Tpi]),
        ),
        family(
            "lpi-tpi-near",
            "lpi-tpi-near",
            SOLID,
            &["ulps", "halvings"],
            "both kinds of meeting points in space at most `ulps` ulps off a tie",
            |task, fields| read::constructed_near(task, fields, &[Kind::Lpi, Kind::Tpi]),
        ),
        family(
            "lpi-tpi-degen",
            "lpi-tpi-degen",
            SOLID,
            &["halvings"],
            "both kinds of meeting points in space in exact ties: every answer is 0",
            |task, fields| read::constructed_degenerate(task, fields, &[Kind::Lpi, Kind::Tpi]),
        ),
    ]
}
