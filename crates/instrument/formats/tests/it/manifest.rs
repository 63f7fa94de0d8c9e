//! Tests of invalid manifests.

use predicament_formats::Manifest;

#[test]
fn bad_manifests_are_refused_by_line() {
    let good = include_str!("../../../../../corpora/fetch.toml");
    Manifest::parse("fetch.toml", good).unwrap();
    for (from, to, message) in [
        (
            "manager = \"cargo\"",
            "manager = \"conda\"",
            "no package manager is called `conda`; use npm, cargo, pip or apt",
        ),
        ("fixtures/orient2d.txt", "../orient2d.txt", "`../orient2d.txt` is not a path in a package"),
        ("package = \"robust\"", "package = \"-robust\"", "`-robust` is not a package name"),
        ("sha256 = \"4609", "sha256 = \"46\\u0020", "is not a SHA-256"),
        ("key = \"robust-orient3d\"", "key = \"robust-orient2d\"", "the key `robust-orient2d` is taken"),
        ("version = \"1.2.0\"", "version = \"^1.2\"", "`^1.2` is not a plain name"),
    ] {
        assert!(good.contains(from), "{from}");
        let error = Manifest::parse("fetch.toml", &good.replacen(from, to, 1)).unwrap_err();
        assert!(error.line().is_some() && error.to_string().contains(message), "{error}");
    }
}
