//! The sensors, side by side.

use crate::RoomError;
use crate::outline::check_finite;
use crate::scene::Scene;
use crate::tracer::Place;
use hemisphere::{Direction, Vec3};

/// Points with a normal, whose illuminance is asked for.
pub struct Sensors {
    places: Vec<Place>,
    normals: Vec<Vec3>,
}

impl Sensors {
    /// Checks points and normals (of any length) and prepares them for the scene.
    pub fn new(scene: &Scene, points: &[Vec3], normals: &[Vec3]) -> Result<Self, RoomError> {
        if points.is_empty() || points.len() != normals.len() {
            let value = format!("{} points and {} normals", points.len(), normals.len());
            let way_out = "give one normal for every point";
            return Err(RoomError::Setting {
                name: "sensors",
                rule: "one or more points with a normal each",
                value,
                way_out,
            });
        }
        check_finite("sensors", points)?;
        let normals = normals
            .iter()
            .enumerate()
            .map(|(i, &n)| {
                Direction::of(n).map(Direction::vector).ok_or_else(|| RoomError::NoDirection {
                    name: format!("sensor {i}"),
                    what: "the normal",
                    value: format!("{:?}", n.to_array()),
                })
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { places: points.iter().map(|&p| scene.tracer.place(p)).collect(), normals })
    }

    /// How many.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Where sensor `i` is.
    pub fn position(&self, i: usize) -> Vec3 {
        self.places[i].position
    }

    /// The same, ready for lines of sight.
    pub fn place(&self, i: usize) -> Place {
        self.places[i]
    }

    /// Which way it faces.
    pub fn normal(&self, i: usize) -> Vec3 {
        self.normals[i]
    }
}
