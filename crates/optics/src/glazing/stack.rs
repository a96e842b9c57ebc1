//! Layers one behind the other with air between: double glazing, a panel between panes.

use super::{Glazing, Lobe, Lobes, Scattered, Straight};
use crate::OpticsError;
use hemisphere::{Direction, Rng};
use std::sync::Arc;

/// Layers of glazing, the outermost first, with air between them. Light between layers is taken as unpolarised.
pub struct Stack {
    layers: Vec<Arc<dyn Glazing>>,
}

/// Beams weaker than this share of the incident power are no longer followed but reported as residual.
const TOLERANCE: f64 = 1e-7;

/// Meetings with a layer after which what is left is residual.
const MOST_MEETINGS: usize = 20_000;

/// Directions closer than this are one.
const SAME: f64 = 1e-9;

/// Light on its way: in gap `gap`, before layer `gap` and behind the one before.
struct Waiting {
    gap: usize,
    lobe: Lobe,
}

impl Stack {
    /// Layers, the outermost first.
    pub fn new(layers: Vec<Arc<dyn Glazing>>) -> Result<Self, OpticsError> {
        if layers.is_empty() {
            return Err(OpticsError::NoLayers);
        }
        Ok(Self { layers })
    }

    /// The gap that light begins in.
    fn outside(&self, incident: Direction) -> usize {
        if incident.z > 0.0 { 0 } else { self.layers.len() }
    }

    /// The layer that light in a gap meets next; `None` if it has left.
    fn next(&self, gap: usize, direction: Direction) -> Option<usize> {
        if direction.z > 0.0 { (gap < self.layers.len()).then_some(gap) } else { gap.checked_sub(1) }
    }
}

/// The gap that light leaving `layer` along `direction` enters.
fn entered(layer: usize, direction: Direction) -> usize {
    if direction.z > 0.0 { layer + 1 } else { layer }
}

impl Glazing for Stack {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let first = Lobe { direction: incident, power: 1.0, total_reflections: 0 };
        let mut waiting = vec![Waiting { gap: self.outside(incident), lobe: first }];
        let mut split = Lobes::default();
        for _ in 0..MOST_MEETINGS {
            // the strongest first, so that what meets again meets merged
            let strongest = (0..waiting.len()).max_by(|&a, &b| waiting[a].lobe.power.total_cmp(&waiting[b].lobe.power));
            let Some(i) = strongest.filter(|&i| waiting[i].lobe.power >= TOLERANCE) else { break };
            let Waiting { gap, lobe } = waiting.swap_remove(i);
            let Some(layer) = self.next(gap, lobe.direction) else {
                merge(&mut out.beams, lobe);
                continue;
            };
            self.layers[layer].lobes(lobe.direction, &mut split);
            out.absorbed += lobe.power * split.absorbed;
            out.residual += lobe.power * split.residual;
            for part in &split.beams {
                let part = Lobe {
                    direction: part.direction,
                    power: lobe.power * part.power,
                    total_reflections: lobe.total_reflections.saturating_add(part.total_reflections),
                };
                let gap = entered(layer, part.direction);
                match waiting.iter_mut().find(|w| w.gap == gap && same(w.lobe.direction, part.direction)) {
                    Some(there) => join(&mut there.lobe, part),
                    None => waiting.push(Waiting { gap, lobe: part }),
                }
            }
        }
        out.residual += waiting.iter().map(|w| w.lobe.power).sum::<f64>();
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        let mut rng = Rng::new(u[2].to_bits(), 0);
        let (mut gap, mut direction, mut count) = (self.outside(incident), incident, 0_u16);
        let mut u = [u[0], u[1], rng.uniform()];
        for _ in 0..MOST_MEETINGS {
            let Some(layer) = self.next(gap, direction) else {
                return Scattered::Leaves { direction, total_reflections: count };
            };
            match self.layers[layer].scatter(direction, u) {
                Scattered::Absorbed => return Scattered::Absorbed,
                Scattered::Leaves { direction: leaves, total_reflections } => {
                    gap = entered(layer, leaves);
                    direction = leaves;
                    count = count.saturating_add(total_reflections);
                }
            }
            u = std::array::from_fn(|_| rng.uniform());
        }
        Scattered::Absorbed
    }

    /// Inner reflections between clear layers summed by the rule for adding layers.
    fn straight(&self, incident: Direction) -> Option<Straight> {
        let back = super::clear::mirror_image(incident);
        let mut order: Vec<&Arc<dyn Glazing>> = self.layers.iter().collect();
        if incident.z < 0.0 {
            order.reverse();
        }
        // seen along the light: transmittance there and back, reflectance of the near and of the far side
        let (mut there, mut back_again, mut near, mut far) = (1.0, 1.0, 0.0, 0.0);
        for layer in order {
            let (ahead, behind) = (layer.straight(incident)?, layer.straight(back)?);
            let between = 1.0 / (1.0 - far * ahead.reflectance);
            near += there * back_again * ahead.reflectance * between;
            far = behind.reflectance + ahead.transmittance * behind.transmittance * far * between;
            there *= ahead.transmittance * between;
            back_again *= behind.transmittance * between;
        }
        Some(Straight { transmittance: there, reflectance: near })
    }
}

fn same(a: Direction, b: Direction) -> bool {
    (a.vector() - b.vector()).length_squared() < SAME * SAME
}

fn join(there: &mut Lobe, part: Lobe) {
    there.power += part.power;
    there.total_reflections = there.total_reflections.min(part.total_reflections);
}

fn merge(beams: &mut Vec<Lobe>, part: Lobe) {
    match beams.iter_mut().find(|b| same(b.direction, part.direction)) {
        Some(there) => join(there, part),
        None => beams.push(part),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ClearGlazing;
    use hemisphere::Vec3;

    fn along(x: f64, y: f64, z: f64) -> Direction {
        Direction::of(Vec3::new(x, y, z)).expect("some length")
    }

    fn pane(n: f64, absorption: f64) -> Arc<dyn Glazing> {
        Arc::new(ClearGlazing::slab(n, 4.0, absorption).expect("possible"))
    }

    /// Turns the share 0.6 of the light up for down, reflects 0.1 and absorbs 0.1.
    struct Turner;

    impl Glazing for Turner {
        fn lobes(&self, incident: Direction, out: &mut Lobes) {
            out.clear();
            let y = incident.mirrored(Direction::from_unit(Vec3::Y));
            let z = incident.mirrored(Direction::from_unit(Vec3::Z));
            for (direction, power, total_reflections) in [(y, 0.6, 1), (incident, 0.2, 0), (z, 0.1, 0)] {
                out.beams.push(Lobe { direction, power, total_reflections });
            }
            out.absorbed = 0.1;
        }

        fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
            let mut lobes = Lobes::default();
            self.lobes(incident, &mut lobes);
            let mut left = u[0];
            for lobe in lobes.beams {
                left -= lobe.power;
                if left < 0.0 {
                    return Scattered::Leaves { direction: lobe.direction, total_reflections: lobe.total_reflections };
                }
            }
            Scattered::Absorbed
        }
    }

    /// One layer is itself, from either side; a stack of openings is an opening.
    #[test]
    fn one_layer_is_itself() {
        let alone = ClearGlazing::slab(1.52, 4.0, 0.01).expect("possible");
        let stack = Stack::new(vec![Arc::new(alone.clone())]).expect("a layer");
        for d in [along(0.2, -0.5, 0.8), along(0.2, -0.5, -0.3)] {
            assert_eq!(stack.straight(d), alone.straight(d));
        }
        let openings =
            Stack::new(vec![Arc::new(ClearGlazing::open()), Arc::new(ClearGlazing::open())]).expect("layers");
        assert_eq!(
            openings.straight(Direction::from_unit(Vec3::Z)),
            Some(Straight { transmittance: 1.0, reflectance: 0.0 })
        );
        assert!(Stack::new(Vec::new()).is_err());
    }

    /// Adding layers is the same as following every beam, and power is shared out whole.
    #[test]
    fn adding_agrees_with_following_each_beam() {
        let stack = Stack::new(vec![pane(1.52, 0.02), pane(1.49, 0.0), pane(1.6, 0.1)]).expect("layers");
        let mut lobes = Lobes::default();
        for d in [along(0.1, -0.4, 0.9), along(0.0, -0.9, 0.2), along(0.3, 0.3, -0.6)] {
            stack.lobes(d, &mut lobes);
            let straight = stack.straight(d).expect("clear");
            let share = |through: bool| -> f64 {
                lobes.beams.iter().filter(|l| (l.direction.z * d.z > 0.0) == through).map(|l| l.power).sum()
            };
            assert!((share(true) - straight.transmittance).abs() < 1e-6);
            assert!((share(false) - straight.reflectance).abs() < 1e-6);
            assert!((share(true) + share(false) + lobes.absorbed + lobes.residual - 1.0).abs() < 1e-12);
            assert!(lobes.residual < 1e-6 && lobes.beams.len() == 2);
        }
    }

    /// A turning panel between panes: draws leave as often as the beams say, by direction and by count of total reflections.
    #[test]
    fn draws_follow_the_beams_of_a_panel_between_panes() {
        let stack = Stack::new(vec![pane(1.52, 0.0), Arc::new(Turner), pane(1.52, 0.0)]).expect("layers");
        let d = along(0.3, -0.6, 0.7);
        assert!(stack.straight(d).is_none());
        let mut lobes = Lobes::default();
        stack.lobes(d, &mut lobes);
        assert_eq!(lobes.beams.len(), 4);
        let mut rng = Rng::new(4, 0);
        let n = 200_000;
        let mut count = vec![0.0; 4];
        for _ in 0..n {
            let u = std::array::from_fn(|_| rng.uniform());
            if let Scattered::Leaves { direction, .. } = stack.scatter(d, u) {
                let i = lobes.beams.iter().position(|l| same(l.direction, direction)).expect("a known beam");
                count[i] += 1.0;
            }
        }
        for (lobe, count) in lobes.beams.iter().zip(count) {
            let (p, n) = (lobe.power, f64::from(n));
            assert!((count / n - p).abs() < 4.5 * (p * (1.0 - p) / n).sqrt() + 1e-6, "{p} {}", count / n);
        }
        let turned = lobes.beams.iter().find(|l| l.direction.y > 0.0 && l.direction.z > 0.0).expect("turned light");
        assert!(turned.power > 0.4 && turned.total_reflections == 1);
    }
}
