//! `engines doctor`: settings of a compiler that break an engine.

use std::fs;
use std::path::Path;

use tempfile::{TempDir, tempdir};

use crate::common::{Told, told, tool, write};

/// Signs of turns by exact expansions: products in two parts without fused operations, then a sum without error.
/// `compare` never rounds. The engine refuses to be compiled for x87.
const EXACT: &str = "#include <float.h>\n#if FLT_EVAL_METHOD == 2\n#include <no-x87>\n#endif\n#include <predicament_engine.hpp>\n\
struct Exact {\n\
  static constexpr const char* name = \"exact-cpp\";\n\
  static constexpr predicament::Zero zero = predicament::Zero::exact;\n\
  static std::string version() { return \"1\"; }\n\
  static double compare(int axis, const double* a, const double* b) { return a[axis] < b[axis] ? -1 : a[axis] > b[axis]; }\n\
  static void split(double a, double& hi, double& lo) { double c = 134217729.0 * a, big = c - a; hi = c - big; lo = a - hi; }\n\
  static void product(double a, double b, double sign, double* sum) {\n\
    double p = a * b, ah, al, bh, bl; split(a, ah, al); split(b, bh, bl);\n\
    add(sign * (al * bl - (((p - ah * bh) - al * bh) - ah * bl)), sum); add(sign * p, sum);\n\
  }\n\
  static void add(double x, double* sum) {\n\
    for (int i = 0; i < 12; ++i) { double s = x + sum[i], b = s - x; sum[i] = (x - (s - b)) + (sum[i] - b); x = s; }\n\
    for (int i = 0; i < 11; ++i) sum[i] = sum[i + 1];\n\
    sum[11] = x;\n\
  }\n\
  static double orient2d(const double* a, const double* b, const double* c) {\n\
    double sum[12] = {0};\n\
    product(a[0], b[1], 1, sum); product(a[1], b[0], -1, sum); product(b[0], c[1], 1, sum);\n\
    product(b[1], c[0], -1, sum); product(c[0], a[1], 1, sum); product(c[1], a[0], -1, sum);\n\
    for (int i = 11; i >= 0; --i) if (sum[i] != 0) return sum[i];\n\
    return 0;\n\
  }\n\
};\n\
int main(int argc, char** argv) { return predicament::serve<Exact>(argc, argv); }\n";

/// A folder of engines with the helper for C++ and this engine.
fn engines(build: &str) -> TempDir {
    let folder = tempdir().unwrap();
    for name in ["include", "mine"] {
        fs::create_dir(folder.path().join(name)).unwrap();
    }
    let helper = Path::new(env!("CARGO_MANIFEST_DIR")).join("../engines/include/predicament_engine.hpp");
    fs::copy(helper, folder.path().join("include/predicament_engine.hpp")).unwrap();
    write(&folder, "mine/engine.cpp", EXACT);
    write(&folder, "mine/engine.toml", &format!("name = \"mine\"\nbuild = [{build}]\nrun = [\"./engine\"]\n"));
    folder
}

fn doctor(engines: &TempDir, options: &[&str]) -> Told {
    let mut command = tool(&[&["engines", "doctor", "mine"], options].concat());
    told(command.env("PREDICAMENT_ENGINES", engines.path()).output().unwrap())
}

const BUILD: &str = "[\"c++\", \"-std=c++17\", \"-O0\", \"-I\", \"../include\", \"engine.cpp\", \"-o\", \"engine\"]";

/// Red if the flags do not reach the compiler, or if a setting is blamed for errors of the engine's own build (the
/// families of wide exponents, in which the products underflow).
#[test]
#[ignore = "needs a C++ compiler"]
fn fast_math_breaks_expansions_in_cpp_and_plain_optimisation_does_not() {
    let engines = engines(BUILD);
    let told = doctor(&engines, &["--format", "csv", "--settings", "^-O2( -ffast-math| -mfpmath=387)?$"]);
    assert_eq!(told.code, 100, "{}{}", told.stdout, told.stderr);
    let row = |start: &str| told.stdout.lines().find(|line| line.starts_with(start)).unwrap_or_default().to_owned();
    assert!(row("\"own\",compare,\"right\",0,").contains(",false,"), "{}", told.stdout);
    assert!(row("\"-O2\",orient2d,").contains(",false,"), "{}", told.stdout);
    assert_eq!(row("\"-O2\",orient2d,").replace("-O2", "own"), row("\"own\",orient2d,"));
    let broken = row("\"-O2 -ffast-math\",orient2d,");
    assert!(broken.contains("BREAKS: ") && broken.contains(",true,"), "{broken}");
    assert!(broken.contains("orient2d(xy; 0 1 2)") && broken.matches("vertex").count() == 3, "{broken}");
    assert!(broken.contains("0x") && broken.contains("truth "), "{broken}");
    assert!(!row("\"-O2 -ffast-math\",compare,").contains("BREAKS"), "{}", told.stdout);
    assert!(!engines.path().join("mine/engine").exists(), "the engine's own folder is not built in");
    assert!(row("\"-O2 -mfpmath=387\",orient2d,").contains("\"not built: "), "{}", told.stdout);
    assert!(told.stderr.contains("1 of 3 settings break a predicate; 1 were not built"), "{}", told.stderr);
}

#[test]
fn what_cannot_be_examined_is_refused_with_a_cure() {
    let engines = engines("[\"make\"]");
    let refused = doctor(&engines, &[]);
    assert!(refused.code == 2 && refused.stderr.contains("calls no compiler of C, C++ or Rust"), "{}", refused.stderr);
    fs::write(
        engines.path().join("mine/engine.toml"),
        format!("name = \"mine\"\nbuild = [{BUILD}]\nrun = [\"./e\"]\n"),
    )
    .unwrap();
    let refused = doctor(&engines, &["--settings", "no-such"]);
    assert!(refused.code == 4 && refused.stderr.contains("choose from -O0; -O2;"), "{}", refused.stderr);
    let refused = doctor(&engines, &["--settings", "("]);
    assert!(refused.code == 2 && refused.stderr.contains("--settings: "), "{}", refused.stderr);
}
