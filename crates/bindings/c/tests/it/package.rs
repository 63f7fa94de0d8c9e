//! The files beside the library: versions and names.

use super::file;

#[test]
fn the_cmake_package_has_the_version_of_the_crate() {
    let version = env!("CARGO_PKG_VERSION");
    let package = file("cmake/predicamentConfigVersion.cmake");
    assert!(package.contains(&format!("set(PACKAGE_VERSION \"{version}\")")), "another version than {version}");
    let template = file("predicament.pc.in");
    for field in ["prefix=@prefix@", "Version: @version@", "Libs.private: @libs@", "Cflags: -I${includedir}"] {
        assert!(template.lines().any(|line| line == field), "{field}");
    }
}
