//! What windows make of the directions of one sun: each is solved once.

use crate::scene::Scene;
use crate::surface::Kind;
use hemisphere::{Direction, Frame, Vec3};
use optics::{Glazing, Lobes};
use std::cell::RefCell;
use std::rc::Rc;

/// Directions closer than this are one.
const SAME: f64 = 1e-12;

/// One beam that leaves a window.
#[derive(Clone, Copy)]
pub struct Leaving {
    /// In the world's axes.
    pub direction: Vec3,
    pub power: f64,
    pub total_reflections: u16,
}

/// All that leaves a window of light of one direction.
pub struct Solved {
    /// The strongest first.
    pub beams: Vec<Leaving>,
    /// Share that leaves spread.
    pub spread: f64,
}

/// The windows of a scene, and what they made of light so far.
pub struct Lobed<'a> {
    scene: &'a Scene,
    found: RefCell<Vec<(u32, Vec3, Rc<Solved>)>>,
}

impl<'a> Lobed<'a> {
    pub fn of(scene: &'a Scene) -> Self {
        Self { scene, found: RefCell::default() }
    }

    /// What fills a window, and its axes; `None` of what is none.
    pub fn window(&self, facet: u32) -> Option<(&'a dyn Glazing, Frame)> {
        match &self.scene.surface_of(facet).kind {
            Kind::Window { glazing, frame } => Some((&**glazing, *frame)),
            _ => None,
        }
    }

    /// What a window, if it is one, makes of light of a direction of travel.
    pub fn solved(&self, facet: u32, direction: Vec3) -> Option<Rc<Solved>> {
        let (glazing, frame) = self.window(facet)?;
        let near = |known: &&(u32, Vec3, Rc<Solved>)| known.0 == facet && known.1.abs_diff_eq(direction, SAME);
        if let Some((_, _, solved)) = self.found.borrow().iter().find(near) {
            return Some(solved.clone());
        }
        let mut lobes = Lobes::default();
        glazing.lobes(Direction::of(frame.inward(direction))?, &mut lobes);
        let mut beams: Vec<Leaving> = lobes
            .beams
            .iter()
            .map(|lobe| Leaving {
                direction: frame.outward(*lobe.direction),
                power: lobe.power,
                total_reflections: lobe.total_reflections,
            })
            .collect();
        beams.sort_by(|a, b| b.power.total_cmp(&a.power));
        let solved = Rc::new(Solved { beams, spread: lobes.spread });
        self.found.borrow_mut().push((facet, direction, solved.clone()));
        Some(solved)
    }
}
