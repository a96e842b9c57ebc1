//! A scene: named surfaces, checked once, then frozen and indexed.

use crate::facet::Facet;
use crate::outline::{Outline, check_finite};
use crate::sunlit::plane::Pieces;
use crate::surface::{Kind, Material, Medium};
use crate::tracer::{Hit, NO_FACET, Ray, Tracer};
use crate::{RoomError, nesting};
use hemisphere::{Direction, Frame, Vec3};
use optics::Glazing;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// A named surface of a frozen scene.
pub struct Surface {
    /// Its name.
    pub name: String,
    /// What it does to light.
    pub kind: Kind,
    /// Area of all its facets \[m²\].
    pub area: f64,
    /// Its facets.
    pub facets: Range<u32>,
}

/// A frozen, indexed scene.
pub struct Scene {
    /// Its surfaces, in the order they were added.
    pub surfaces: Vec<Surface>,
    /// Where rays end.
    pub(crate) tracer: Tracer,
    /// Area of all facets of the same surface up to and with each, for drawing points by area.
    area_to_here: Vec<f64>,
    /// Convex pieces of the facets, once asked for.
    pub(crate) pieces: OnceLock<Pieces>,
}

impl Scene {
    /// All flat pieces of all surfaces.
    pub fn facets(&self) -> &[Facet] {
        self.tracer.facets()
    }

    /// The facet numbered `facet`.
    #[inline]
    pub(crate) fn facet(&self, facet: u32) -> &Facet {
        &self.tracer.facets()[facet as usize]
    }

    /// The surface that facet belongs to.
    #[inline]
    pub(crate) fn surface_of(&self, facet: u32) -> &Surface {
        &self.surfaces[self.facet(facet).surface as usize]
    }

    /// The first surface met from a point along a direction: how far \[m\], which.
    pub fn closest(&self, origin: Vec3, direction: Vec3) -> Option<(f64, u32)> {
        let Hit { distance, facet } = self.tracer.closest(&Ray { origin, direction, leaving: NO_FACET })?;
        Some((distance, self.facet(facet).surface))
    }

    /// A point on a surface, uniform over its area for `u` uniform in the unit square: the facet and the point.
    pub(crate) fn point_on(&self, surface: u32, u: [f64; 2]) -> (u32, Vec3) {
        let Range { start, end } = self.surfaces[surface as usize].facets;
        if end - start == 1 {
            return (start, self.facet(start).point(u));
        }
        let areas = &self.area_to_here[start as usize..end as usize];
        let target = u[0] * areas[areas.len() - 1];
        let i = areas.partition_point(|&a| a <= target).min(areas.len() - 1);
        let before = if i == 0 { 0.0 } else { areas[i - 1] };
        let facet = start + i as u32;
        (facet, self.facet(facet).point([(target - before) / (areas[i] - before), u[1]]))
    }
}

impl Scene {
    /// What [`Self::point_on`] makes a point of a facet from, within its surface.
    pub(crate) fn coordinates(&self, facet: u32, p: Vec3) -> [f64; 2] {
        let shape = self.facet(facet);
        let Range { start, end } = self.surfaces[shape.surface as usize].facets;
        let [u, v] = shape.coordinates(p);
        if end - start == 1 {
            return [u, v];
        }
        let areas = &self.area_to_here[start as usize..end as usize];
        let i = (facet - start) as usize;
        let before = if i == 0 { 0.0 } else { areas[i - 1] };
        [(before + u.clamp(0.0, 1.0) * (areas[i] - before)) / areas[areas.len() - 1], v]
    }
}

/// A scene being put together.
#[derive(Default)]
pub struct SceneBuilder {
    objects: Vec<Object>,
}

struct Object {
    name: String,
    kind: Kind,
    shape: Shape,
}

enum Shape {
    Polygon(Outline),
    Mesh(Vec<[Vec3; 3]>),
}

impl SceneBuilder {
    /// Adds an opaque polygon with holes.
    pub fn polygon(
        &mut self,
        name: &str,
        outline: &[Vec3],
        holes: &[Vec<Vec3>],
        material: Material,
    ) -> Result<(), RoomError> {
        let outline = Outline::new(name, outline, holes)?;
        self.add(name, Kind::Opaque(material.check(name)?), Shape::Polygon(outline))
    }

    /// Adds an opaque triangle mesh; triangles without area are left out.
    pub fn mesh(
        &mut self,
        name: &str,
        vertices: &[Vec3],
        triangles: &[[i64; 3]],
        material: Material,
    ) -> Result<(), RoomError> {
        let triangles = checked_triangles(name, vertices, triangles)?;
        self.add(name, Kind::Opaque(material.check(name)?), Shape::Mesh(triangles))
    }

    /// Adds a window whose outline runs anticlockwise as seen from the room. `up` is the element's y axis, as far as it lies in the
    /// window; by default the vertical, or north in a horizontal window. With `wall`, its hole is cut into that polygon.
    pub fn window(
        &mut self,
        name: &str,
        outline: &[Vec3],
        glazing: Arc<dyn Glazing>,
        up: Option<Vec3>,
        wall: Option<&str>,
    ) -> Result<(), RoomError> {
        let outline = Outline::new(name, outline, &[])?;
        let normal = Direction::from_unit(outline.frame.z);
        // within a thousandth of a degree of horizontal there is no way up the slope
        let default_up = if normal.z.abs() > 1.0 - 1e-10 { Vec3::Y } else { Vec3::Z };
        let frame = Frame::with_up(normal, up.unwrap_or(default_up)).filter(|f| f.x.is_finite()).ok_or_else(|| {
            let value = format!("{:?}", up.unwrap_or(default_up).to_array());
            RoomError::NoDirection { name: name.to_owned(), what: "up, not along the window's normal,", value }
        })?;
        if let Some(wall) = wall {
            let none = || RoomError::NoSuchWall { name: name.to_owned(), wall: wall.to_owned() };
            let object = self.objects.iter_mut().find(|o| o.name == wall).ok_or_else(none)?;
            match (&object.kind, &mut object.shape) {
                (Kind::Opaque(_), Shape::Polygon(wall_outline)) => wall_outline.cut_out(wall, name, &outline)?,
                _ => return Err(none()),
            }
        }
        self.add(name, Kind::Window { glazing, frame }, Shape::Polygon(outline))
    }

    /// Adds a boundary between media; `front` is the medium on the side the right-hand normal points to.
    pub fn interface(
        &mut self,
        name: &str,
        vertices: &[Vec3],
        triangles: &[[i64; 3]],
        front: Medium,
        back: Medium,
    ) -> Result<(), RoomError> {
        let kind = Kind::Interface { front: front.check(name)?, back: back.check(name)? };
        let triangles = checked_triangles(name, vertices, triangles)?;
        self.add(name, kind, Shape::Mesh(triangles))
    }

    fn add(&mut self, name: &str, kind: Kind, shape: Shape) -> Result<(), RoomError> {
        if self.objects.iter().any(|o| o.name == name) {
            return Err(RoomError::NameTwice { name: name.to_owned() });
        }
        self.objects.push(Object { name: name.to_owned(), kind, shape });
        Ok(())
    }

    /// Checks the scene as a whole, indexes it and freezes it.
    pub fn build(self) -> Result<Scene, RoomError> {
        if self.objects.is_empty() {
            return Err(RoomError::EmptyScene);
        }
        let (mut surfaces, mut facets): (Vec<Surface>, Vec<Facet>) = (Vec::new(), Vec::new());
        for Object { name, kind, shape } in self.objects {
            let start = facets.len() as u32;
            let surface = surfaces.len() as u32;
            match shape {
                Shape::Polygon(outline) => facets.push(Facet::polygon(&outline, surface)),
                Shape::Mesh(triangles) => {
                    facets.extend(triangles.into_iter().filter_map(|t| Facet::triangle(t, surface)))
                }
            }
            let own = start..facets.len() as u32;
            let area = facets[start as usize..].iter().map(|f| f.area).sum();
            if own.is_empty() {
                return Err(RoomError::NoArea { name, detail: "only triangles without area".to_owned() });
            }
            surfaces.push(Surface { name, kind, area, facets: own });
        }
        let mut area_to_here: Vec<f64> = facets.iter().map(|f| f.area).collect();
        for surface in &surfaces {
            let own = &mut area_to_here[surface.facets.start as usize..surface.facets.end as usize];
            (1..own.len()).for_each(|i| own[i] += own[i - 1]);
        }
        let scene = Scene { surfaces, tracer: Tracer::new(facets), area_to_here, pieces: OnceLock::new() };
        nesting::check(&scene)?;
        Ok(scene)
    }
}

fn checked_triangles(name: &str, vertices: &[Vec3], triangles: &[[i64; 3]]) -> Result<Vec<[Vec3; 3]>, RoomError> {
    check_finite(name, vertices)?;
    triangles
        .iter()
        .enumerate()
        .map(|(triangle, corners)| {
            let mut found = [Vec3::ZERO; 3];
            for (place, &index) in found.iter_mut().zip(corners) {
                *place = *usize::try_from(index).ok().and_then(|i| vertices.get(i)).ok_or_else(|| {
                    RoomError::NoSuchVertex { name: name.to_owned(), triangle, index, count: vertices.len() }
                })?;
            }
            Ok(found)
        })
        .collect()
}
