//! The predicates against the exact signs of known hard queries.

use predicament_conformance::check;

#[test]
fn orient2d_is_exact() {
    check::orient2d(own_predicate::orient2d).assert();
}

#[test]
fn the_filter_is_right_where_it_decides() {
    check::orient2d(own_predicate::filtered_orient2d).may_be_undecided().assert();
}
