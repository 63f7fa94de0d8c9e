//! Tests the backend on embedded scenes.

use mine::Mine;
use predicament::Level;

#[test]
fn holds() {
    predicament::conformance(Mine)
        .level(Level::Quick)
        .filter("^families/(uniform|grid)-(compare|orient2d)") // all scenes if left out
        .assert();
}
