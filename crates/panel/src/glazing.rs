//! A panel as a room sees it: exact lobes, and directions drawn in proportion to power.

use crate::{
    panel::{Panel, Workspace},
    walk::{Draw, End},
};
use hemisphere::Direction;
use optics::{Glazing, Lobe, Lobes, Scattered};
use std::cell::RefCell;

thread_local! {
    static WORKSPACE: RefCell<Workspace> = RefCell::default();
}

impl Glazing for Panel {
    /// A rough panel has no lobes: all its light is residual here, and [`Glazing::scatter`] follows it.
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let outcome = WORKSPACE.with_borrow_mut(|workspace| self.outcome(incident, workspace));
        let Ok(outcome) = outcome else {
            out.residual = 1.0;
            return;
        };
        let lobe = |b: &crate::Beam| Lobe {
            direction: b.direction,
            power: b.stokes[0],
            total_reflections: b.total_reflections,
        };
        out.beams.extend(outcome.beams.iter().map(lobe));
        (out.absorbed, out.residual) = (outcome.absorbed, outcome.residual);
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        // one number chooses the wavelength; what is left of it is as good as new
        let (mut left, mut chosen) = (u[0], 0);
        while chosen + 1 < self.walks().len() && left >= self.walks()[chosen].1 {
            left -= self.walks()[chosen].1;
            chosen += 1;
        }
        let (walk, weight) = &self.walks()[chosen];
        let mut draw = Draw::given([(left / weight).clamp(0.0, 1.0 - f64::EPSILON), u[1], u[2]]);
        match walk.run(incident, &mut draw) {
            End::Leaves { direction, total_reflections, weight } if draw.uniform() < weight => {
                Scattered::Leaves { direction: Direction::from_unit(direction.normalize()), total_reflections }
            }
            _ => Scattered::Absorbed,
        }
    }
}
