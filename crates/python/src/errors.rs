//! Rust errors become one Python exception, whose message says name, rule, value and way out.

use optics::OpticsError;
use panel::PanelError;
use pyo3::PyErr;
use room::RoomError;

mod python {
    pyo3::import_exception!(clerestory.errors, ClerestoryError);
}

/// A user's mistake, as the exception that the package raises for every one.
pub fn mistake(message: impl std::fmt::Display) -> PyErr {
    python::ClerestoryError::new_err(message.to_string())
}

/// What was wrong with a medium or a measured glass.
pub fn optics(error: OpticsError) -> PyErr {
    mistake(error)
}

/// What was wrong with a panel.
pub fn panel(error: PanelError) -> PyErr {
    mistake(error)
}

/// What was wrong with a room.
pub fn room(error: RoomError) -> PyErr {
    mistake(error)
}
