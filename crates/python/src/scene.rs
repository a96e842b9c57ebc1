//! Scenes of the crate `room`, for Python: what is in them, and where rays end.

use crate::arrays::{directions, points};
use crate::errors::{self, mistake};
use crate::glazing::PyGlazing;
use hemisphere::Vec3;
use numpy::{IntoPyArray, PyArray1, PyArray3, PyReadonlyArray2, ndarray::Array3};
use pyo3::prelude::*;
use room::{Material, Medium, Scene, SceneBuilder};

/// Shares of light that an opaque surface reflects, on both sides.
#[pyclass(name = "Material", module = "clerestory._native", frozen)]
pub struct PyMaterial(Material);

#[pymethods]
impl PyMaterial {
    #[new]
    #[pyo3(signature = (diffuse, specular=0.0))]
    fn new(diffuse: f64, specular: f64) -> PyResult<Self> {
        Material { diffuse, specular }.check("material").map(Self).map_err(errors::room)
    }

    #[getter]
    fn diffuse(&self) -> f64 {
        self.0.diffuse
    }

    #[getter]
    fn specular(&self) -> f64 {
        self.0.specular
    }
}

/// A scene being put together.
#[pyclass(name = "SceneBuilder", module = "clerestory._native")]
#[derive(Default)]
pub struct PySceneBuilder(SceneBuilder);

fn triangles(array: &PyReadonlyArray2<'_, i64>) -> PyResult<Vec<[i64; 3]>> {
    let rows = array.as_array();
    if rows.ncols() != 3 {
        return Err(mistake(format!("triangles must have shape (any, 3), got {:?}", rows.shape())));
    }
    Ok(rows.outer_iter().map(|row| [row[0], row[1], row[2]]).collect())
}

#[pymethods]
impl PySceneBuilder {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// An opaque polygon with holes.
    #[pyo3(signature = (name, outline, material, holes=Vec::new()))]
    fn polygon(
        &mut self,
        name: &str,
        outline: PyReadonlyArray2<'_, f64>,
        material: &PyMaterial,
        holes: Vec<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<()> {
        let holes = holes.iter().map(|hole| points(name, hole)).collect::<PyResult<Vec<_>>>()?;
        self.0.polygon(name, &points(name, &outline)?, &holes, material.0).map_err(errors::room)
    }

    /// An opaque triangle mesh.
    fn mesh(
        &mut self,
        name: &str,
        vertices: PyReadonlyArray2<'_, f64>,
        triangles: PyReadonlyArray2<'_, i64>,
        material: &PyMaterial,
    ) -> PyResult<()> {
        let triangles = self::triangles(&triangles)?;
        self.0.mesh(name, &points(name, &vertices)?, &triangles, material.0).map_err(errors::room)
    }

    /// A window whose outline runs anticlockwise as seen from the room.
    #[pyo3(signature = (name, outline, glazing, up=None, wall=None))]
    fn window(
        &mut self,
        name: &str,
        outline: PyReadonlyArray2<'_, f64>,
        glazing: &PyGlazing,
        up: Option<[f64; 3]>,
        wall: Option<&str>,
    ) -> PyResult<()> {
        let outline = points(name, &outline)?;
        self.0.window(name, &outline, glazing.0.clone(), up.map(Vec3::from_array), wall).map_err(errors::room)
    }

    /// A boundary between media, each an index and an absorption per metre; `front` is where the right-hand normal points.
    fn interface(
        &mut self,
        name: &str,
        vertices: PyReadonlyArray2<'_, f64>,
        triangles: PyReadonlyArray2<'_, i64>,
        front: (f64, f64),
        back: (f64, f64),
    ) -> PyResult<()> {
        let triangles = self::triangles(&triangles)?;
        let medium = |(n, absorption_per_m)| Medium { n, absorption_per_m };
        self.0.interface(name, &points(name, &vertices)?, &triangles, medium(front), medium(back)).map_err(errors::room)
    }

    /// Checks the whole, indexes it and freezes it; the builder is empty afterwards.
    fn build(&mut self, py: Python<'_>) -> PyResult<PyScene> {
        let builder = std::mem::take(&mut self.0);
        py.detach(|| builder.build()).map(PyScene).map_err(errors::room)
    }
}

/// A checked, indexed scene.
#[pyclass(name = "Scene", module = "clerestory._native", frozen)]
pub struct PyScene(pub Scene);

#[pymethods]
impl PyScene {
    /// Names, in the order they were added.
    #[getter]
    fn surfaces(&self) -> Vec<&str> {
        self.0.surfaces.iter().map(|s| s.name.as_str()).collect()
    }

    /// "opaque", "window" or "interface" for each.
    #[getter]
    fn kinds(&self) -> Vec<&'static str> {
        self.0.surfaces.iter().map(|s| s.kind.name()).collect()
    }

    /// Area of each [m²].
    #[getter]
    fn areas<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.0.surfaces.iter().map(|s| s.area).collect::<Vec<_>>().into_pyarray(py)
    }

    /// Triangles for drawing, (triangle, corner, 3), and the surface of each.
    fn triangles<'py>(&self, py: Python<'py>) -> (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray1<i64>>) {
        let (mut corners, mut surface) = (Vec::new(), Vec::new());
        for facet in self.0.facets() {
            for triangle in facet.triangles() {
                corners.push(triangle);
                surface.push(i64::from(facet.surface));
            }
        }
        let corners = Array3::from_shape_fn((corners.len(), 3, 3), |(t, c, k)| corners[t][c][k]);
        (corners.into_pyarray(py), surface.into_pyarray(py))
    }

    /// Mirrors too curved for the sun by way of them to be looked for: name, directions of their normals (257 stand for all more),
    /// facets.
    fn unfollowed_mirrors(&self) -> Vec<(String, usize, usize)> {
        room::unfollowed_mirrors(&self.0).into_iter().map(|one| (one.name, one.normals, one.facets)).collect()
    }

    /// How far each ray goes [m] and which surface it meets; infinity and -1 in the open.
    #[allow(clippy::type_complexity)]
    fn closest<'py>(
        &self,
        py: Python<'py>,
        origins: PyReadonlyArray2<'_, f64>,
        directions: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>)> {
        let (origins, directions) = (points("origins", &origins)?, self::directions("directions", &directions)?);
        if origins.len() != directions.len() {
            let (n, m) = (origins.len(), directions.len());
            return Err(mistake(format!("directions must have one row for each of {n} origins, got {m}")));
        }
        let (distance, surface): (Vec<f64>, Vec<i64>) = py.detach(|| {
            origins
                .iter()
                .zip(&directions)
                .map(|(o, d)| self.0.closest(*o, **d).map_or((f64::INFINITY, -1), |(t, s)| (t, i64::from(s))))
                .unzip()
        });
        Ok((distance.into_pyarray(py), surface.into_pyarray(py)))
    }
}

/// Adds all of this file to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyMaterial>()?;
    module.add_class::<PySceneBuilder>()?;
    module.add_class::<PyScene>()
}
