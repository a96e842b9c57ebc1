//! The sun's way through the windows of a scene of the crate `room`, for Python: tables of windows, beams, patches and paths.

use crate::arrays::{self, vectors};
use crate::errors::mistake;
use crate::scene::PyScene;
use hemisphere::Vec3;
use numpy::{Element, IntoPyArray, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use room::{Event, PathVertex, Scene, SunWay, WaySettings};

/// The number that stands for no surface.
const NONE: i64 = -1;

fn put<T: Element>(into: &Bound<'_, PyDict>, name: &str, values: impl Iterator<Item = T>) -> PyResult<()> {
    into.set_item(name, values.collect::<Vec<_>>().into_pyarray(into.py()))
}

/// Rows of three numbers, one after another, however many belong to each thing.
fn put_points<'a>(into: &Bound<'_, PyDict>, name: &str, rows: impl Iterator<Item = &'a Vec3>) -> PyResult<()> {
    into.set_item(name, vectors(into.py(), &rows.copied().collect::<Vec<_>>()))
}

fn event(vertex: &PathVertex) -> u8 {
    match vertex.event {
        Event::Sun => 0,
        Event::Glazing => 1,
        Event::Mirror => 2,
        Event::Diffuse => 3,
        Event::Interface => 4,
        Event::Sky => 5,
    }
}

fn windows<'py>(py: Python<'py>, scene: &Scene, way: &SunWay) -> PyResult<Bound<'py, PyDict>> {
    let made = PyDict::new(py);
    put(&made, "surface", way.windows.iter().map(|(one, _)| surface(scene, one.facet)))?;
    put(&made, "cos_incidence", way.windows.iter().map(|(one, _)| one.cos))?;
    put(&made, "sunlit_share", way.windows.iter().map(|(one, _)| one.share))?;
    put(&made, "hidden_by", way.windows.iter().map(|(one, _)| one.hidden_by.map_or(NONE, i64::from)))?;
    put(&made, "entering", way.windows.iter().map(|(_, entering)| *entering))?;
    Ok(made)
}

fn beams<'py>(py: Python<'py>, scene: &Scene, way: &SunWay) -> PyResult<Bound<'py, PyDict>> {
    let made = PyDict::new(py);
    put(&made, "source", way.beams.iter().map(|beam| surface(scene, beam.source)))?;
    put(&made, "window", way.beams.iter().map(|beam| beam.window.map_or(NONE, |facet| surface(scene, facet))))?;
    put_points(&made, "direction", way.beams.iter().map(|beam| &beam.direction))?;
    put(&made, "power", way.beams.iter().map(|beam| beam.power))?;
    put(&made, "strength", way.beams.iter().map(|beam| beam.strength))?;
    put(&made, "total_reflections", way.beams.iter().map(|beam| i64::from(beam.total_reflections)))?;
    put(&made, "is_mirrored", way.beams.iter().map(|beam| beam.is_mirrored))?;
    Ok(made)
}

fn patches<'py>(py: Python<'py>, scene: &Scene, way: &SunWay) -> PyResult<Bound<'py, PyDict>> {
    let made = PyDict::new(py);
    put(&made, "beam", way.patches.iter().map(|patch| patch.beam as i64))?;
    put(&made, "surface", way.patches.iter().map(|patch| surface(scene, patch.facet)))?;
    put(&made, "corners", way.patches.iter().map(|patch| patch.corners.len() as i64))?;
    put_points(&made, "corner", way.patches.iter().flat_map(|patch| &patch.corners))?;
    put_points(&made, "source", way.patches.iter().flat_map(|patch| &patch.source))?;
    put(&made, "area", way.patches.iter().map(|patch| patch.area))?;
    put(&made, "strength", way.patches.iter().map(|patch| patch.strength))?;
    Ok(made)
}

fn paths<'py>(py: Python<'py>, way: &SunWay) -> PyResult<Bound<'py, PyDict>> {
    let made = PyDict::new(py);
    let place = |vertex: &usize| &way.vertices[*vertex];
    let places = || way.paths.iter().flatten().map(place);
    put(&made, "vertices", way.paths.iter().map(|path| path.len() as i64))?;
    put_points(&made, "position", places().map(|vertex| &vertex.position))?;
    put(&made, "event", places().map(event))?;
    put(&made, "surface", places().map(|vertex| vertex.surface.map_or(NONE, i64::from)))?;
    put(&made, "power", places().map(|vertex| vertex.power))?;
    // a path comes in by the first window that it meets
    let window = |path: &Vec<usize>| path.iter().map(place).find(|vertex| vertex.event == Event::Glazing)?.surface;
    put(&made, "window", way.paths.iter().map(|path| window(path).map_or(NONE, i64::from)))?;
    let ends = || way.paths.iter().filter_map(|path| path.last()).map(place);
    put(&made, "total_reflections", ends().map(|vertex| i64::from(vertex.total_reflections)))?;
    put(&made, "is_mirrored", ends().map(|vertex| vertex.is_mirrored))?;
    Ok(made)
}

fn surface(scene: &Scene, facet: u32) -> i64 {
    i64::from(scene.facets()[facet as usize].surface)
}

/// The sun's way through the windows of a scene: tables of windows, beams, patches and paths. Surfaces are numbers, -1 none; places
/// of all patches and of all paths stand one after another. Events are sun, glazing, mirror, diffuse, interface and sky.
#[pyfunction]
#[pyo3(signature = (scene, sun_direction, *, points, bounces, least_power, beyond_m, most_shades))]
#[allow(clippy::too_many_arguments)]
fn sun_way<'py>(
    py: Python<'py>,
    scene: &PyScene,
    sun_direction: PyReadonlyArray2<'_, f64>,
    points: usize,
    bounces: u32,
    least_power: f64,
    beyond_m: f64,
    most_shades: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let directions = arrays::directions("sun_direction", &sun_direction)?;
    let [towards] = directions[..] else { return Err(mistake("sun_direction must be one direction")) };
    let settings = WaySettings { points, bounces, least_power, beyond_m, most_shades };
    let (scene, way) = (&scene.0, py.detach(|| room::sun_way(&scene.0, towards, &settings)));
    let made = PyDict::new(py);
    made.set_item("windows", windows(py, scene, &way)?)?;
    made.set_item("beams", beams(py, scene, &way)?)?;
    made.set_item("patches", patches(py, scene, &way)?)?;
    made.set_item("paths", paths(py, &way)?)?;
    Ok(made)
}

/// Adds all of this file to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(sun_way, module)?)
}
