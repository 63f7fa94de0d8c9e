//! The module `predicament._native`: the Rust side of the Python package `predicament`.
//!
//! It answers predicates on arrays (`arrays`, `scene`), gives exact values (`value`), makes cases with the truth
//! (`cases`), runs a Python function on the embedded corpora (`check`, `callable`), and calls the tool
//! (`tool`). The Python sources beside it, in `python/predicament`, are the interface that users see: they turn any
//! arguments into contiguous arrays, and results into tables. This crate computes no sign itself, and holds no lock of
//! the interpreter while Rust code works. Read `arrays` next.

mod arrays;
mod callable;
mod cases;
mod check;
mod kinds;
mod scene;
mod timing;
mod tool;
mod value;
mod waiting;

use pyo3::prelude::*;

/// Makes the module.
#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("KINDS", kinds::table(module.py())?)?;
    module.add_function(wrap_pyfunction!(arrays::signs, module)?)?;
    module.add_function(wrap_pyfunction!(value::exact_value, module)?)?;
    module.add_function(wrap_pyfunction!(cases::cases, module)?)?;
    module.add_function(wrap_pyfunction!(cases::families, module)?)?;
    module.add_function(wrap_pyfunction!(check::check, module)?)?;
    module.add_function(wrap_pyfunction!(tool::call, module)?)?;
    module.add_function(wrap_pyfunction!(tool::main, module)?)?;
    module.add_function(wrap_pyfunction!(timing::seconds_of_loop, module)?)?;
    module.add_function(wrap_pyfunction!(timing::seconds_of_batch, module)?)?;
    module.add_class::<scene::Scene>()
}
