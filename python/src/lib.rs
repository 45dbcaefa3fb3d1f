//! The extension module of the Python package `stribeck`: plain data in, plain data out. What users see is written in
//! Python, in `stribeck/`.

mod batch;
mod catalogue;
mod entries;
mod identification;
mod model;
mod numbers;
mod places;
mod series;
mod steady;
mod study;
mod systems;
mod tyre;
mod work;

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

create_exception!(stribeck, Refused, PyValueError, "A name or a value that is refused; the message names the limit.");

/// A refusal with its reason.
fn refused(reason: impl std::fmt::Display) -> PyErr {
    Refused::new_err(reason.to_string())
}

#[pymodule]
fn _stribeck(module: &Bound<PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("Refused", module.py().get_type::<Refused>())?;
    module.add_class::<model::Instance>()?;
    module.add_class::<batch::Batch>()?;
    module.add_class::<tyre::Tyre>()?;
    module.add_function(wrap_pyfunction!(catalogue::names, module)?)?;
    module.add_function(wrap_pyfunction!(catalogue::describe, module)?)?;
    module.add_function(wrap_pyfunction!(series::follow, module)?)?;
    module.add_function(wrap_pyfunction!(steady::settle, module)?)?;
    module.add_function(wrap_pyfunction!(identification::identify, module)?)?;
    module.add_function(wrap_pyfunction!(identification::identify_options, module)?)?;
    module.add_function(wrap_pyfunction!(study::make_study, module)?)?;
    module.add_function(wrap_pyfunction!(study::missing_chunks, module)?)?;
    module.add_function(wrap_pyfunction!(study::merge_study, module)?)?;
    module.add_function(wrap_pyfunction!(systems::systems, module)?)?;
    module.add_function(wrap_pyfunction!(systems::solvers, module)?)?;
    module.add_function(wrap_pyfunction!(systems::find_step, module)?)?;
    module.add_function(wrap_pyfunction!(systems::solve, module)?)
}
