//! Layers one behind the other with air between: double glazing, a panel between panes.

mod adding;
mod finishing;
mod following;
mod gathering;
mod states;

use super::{
    Glazing, LitLobe, LitLobes, Lobe, Lobes, PolarisedLobe, PolarisedLobes, Scattered, Straight, clear::mirror_image,
    polarised,
};
use crate::OpticsError;
use crate::stokes::{Mueller, Stokes};
use adding::{added, added_with_absorptance, averaged, straight_layers};
use finishing::{End, Ray, walk};
use following::follow;
use gathering::{gathered, joined};
use hemisphere::{Direction, Rng};
use states::same;
use std::sync::Arc;

pub use adding::LayerShares;
pub use following::StackLobes;

/// Layers of glazing, the outermost first, with air between them, at one or several wavelengths.
pub struct Stack {
    spectrum: Vec<(Vec<Arc<dyn Glazing>>, f64)>,
    is_resolved: bool,
}

impl Stack {
    /// Layers, the outermost first; polarisation is carried from one to the next.
    pub fn new(layers: Vec<Arc<dyn Glazing>>) -> Result<Self, OpticsError> {
        Self::spectral(vec![(layers, 1.0)], true)
    }

    /// The same layers at several wavelengths, each with its weight. Unless polarisation is resolved, light is unpolarised again
    /// before every layer.
    pub fn spectral(spectrum: Vec<(Vec<Arc<dyn Glazing>>, f64)>, is_resolved: bool) -> Result<Self, OpticsError> {
        let Some((first, _)) = spectrum.first() else { return Err(OpticsError::NoLayers) };
        if first.is_empty() {
            return Err(OpticsError::NoLayers);
        }
        let whole: f64 = spectrum.iter().map(|(_, weight)| weight).sum();
        let is_whole = (whole - 1.0).abs() < 1e-9 && spectrum.iter().all(|&(_, weight)| weight >= 0.0);
        if !is_whole {
            return Err(OpticsError::StackSpectrum { detail: format!("weights that add to {whole}") });
        }
        for (layers, _) in &spectrum {
            if layers.len() != first.len() {
                let detail = format!("{} and {} layers", first.len(), layers.len());
                return Err(OpticsError::StackSpectrum { detail });
            }
            if let Some(layer) = layers.iter().position(|layer| layer.spreads()) {
                return Err(OpticsError::LayerSpreads { layer });
            }
        }
        Ok(Self { spectrum, is_resolved })
    }

    /// Number of layers.
    pub fn layers(&self) -> usize {
        self.spectrum[0].0.len()
    }

    /// Every beam that leaves when unpolarised light comes in, and what each layer absorbs.
    pub fn outcome(&self, incident: Direction) -> StackLobes {
        self.outcome_of(incident, [1.0, 0.0, 0.0, 0.0])
    }

    fn outcome_of(&self, incident: Direction, stokes: Stokes) -> StackLobes {
        let mut out = StackLobes { absorptance: vec![0.0; self.layers()], ..StackLobes::default() };
        for (layers, weight) in &self.spectrum {
            follow(layers, self.is_resolved, (incident, stokes), *weight, &mut out);
        }
        out.beams = joined(&out.beams);
        out
    }

    /// How unpolarised light divides, by layer: in closed form if no layer turns light, by following beams otherwise.
    pub fn shares(&self, incident: Direction) -> LayerShares {
        let mut shares = LayerShares { absorptance: vec![0.0; self.layers()], ..LayerShares::default() };
        for (layers, weight) in &self.spectrum {
            let Some(by_polarisation) = straight_layers(layers, incident) else {
                return self.shares_of_beams(incident);
            };
            let mut add = |layers: &[adding::Layer], weight: f64| {
                let Straight { transmittance, reflectance } =
                    added_with_absorptance(layers, &mut shares.absorptance, weight);
                shares.transmittance += weight * transmittance;
                shares.reflectance += weight * reflectance;
            };
            if self.is_resolved {
                by_polarisation.iter().for_each(|layers| add(layers, 0.5 * weight));
            } else {
                add(&averaged(&by_polarisation), *weight);
            }
        }
        if incident.z < 0.0 {
            // light from the room met the innermost layer first
            shares.absorptance.reverse();
        }
        shares
    }

    fn shares_of_beams(&self, incident: Direction) -> LayerShares {
        let StackLobes { beams, absorptance, residual, .. } = self.outcome(incident);
        let mut shares = LayerShares { absorptance, residual, ..LayerShares::default() };
        for LitLobe { direction, stokes, .. } in beams {
            if direction.z * incident.z < 0.0 {
                shares.reflectance += stokes[0];
                continue;
            }
            shares.transmittance += stokes[0];
            if direction.y * incident.y < -1e-15 {
                shares.transmittance_deflected += stokes[0];
            }
        }
        shares
    }

    /// The layers of one wavelength, drawn by its weight with a number that is as good as new afterwards.
    fn drawn(&self, u: f64) -> (&[Arc<dyn Glazing>], f64) {
        let (mut left, mut chosen) = (u, 0);
        while chosen + 1 < self.spectrum.len() && left >= self.spectrum[chosen].1 {
            left -= self.spectrum[chosen].1;
            chosen += 1;
        }
        let (layers, weight) = &self.spectrum[chosen];
        (layers, (left / weight).clamp(0.0, 1.0 - f64::EPSILON))
    }
}

impl Glazing for Stack {
    fn lobes(&self, incident: Direction, out: &mut Lobes) {
        out.clear();
        let found = self.outcome(incident);
        out.absorbed = found.absorptance.iter().sum();
        (out.residual, out.walked) = (found.residual, found.walked);
        out.beams.extend(gathered(found.beams).iter().map(|b| Lobe {
            direction: b.direction,
            power: b.stokes[0],
            total_reflections: b.total_reflections,
        }));
    }

    fn scatter(&self, incident: Direction, u: [f64; 3]) -> Scattered {
        if let Some(Straight { transmittance, reflectance }) = self.straight(incident) {
            return match u[0] {
                u if u < transmittance => Scattered::Leaves { direction: incident, total_reflections: 0 },
                u if u < transmittance + reflectance => {
                    Scattered::Leaves { direction: mirror_image(incident), total_reflections: 0 }
                }
                _ => Scattered::Absorbed,
            };
        }
        self.polarised_scatter(incident, [0.0; 3], u).0
    }

    /// Inner reflections between clear layers summed by the rule for adding layers.
    fn straight(&self, incident: Direction) -> Option<Straight> {
        if self.is_resolved {
            return self.straight_s_p(incident).map(polarised::mean);
        }
        let mut sum = Straight { transmittance: 0.0, reflectance: 0.0 };
        for (layers, weight) in &self.spectrum {
            sum.add(*weight, added(&averaged(&straight_layers(layers, incident)?)));
        }
        Some(sum)
    }

    fn straight_s_p(&self, incident: Direction) -> Option<[Straight; 2]> {
        if !self.is_resolved {
            return self.straight(incident).map(|shares| [shares; 2]);
        }
        let mut sums = [Straight { transmittance: 0.0, reflectance: 0.0 }; 2];
        for (layers, weight) in &self.spectrum {
            let by_polarisation = straight_layers(layers, incident)?;
            sums.iter_mut().zip(&by_polarisation).for_each(|(sum, layers)| sum.add(*weight, added(layers)));
        }
        Some(sums)
    }

    fn polarised_lobes(&self, incident: Direction, out: &mut PolarisedLobes) {
        if !self.is_resolved {
            let mut lobes = Lobes::default();
            self.lobes(incident, &mut lobes);
            return out.depolarised(&lobes);
        }
        out.beams.clear();
        // a matrix column by column: of light polarised fully, less that of unpolarised light
        let unpolarised = self.outcome(incident);
        out.residual = unpolarised.residual;
        let columns = [1, 2, 3].map(|k| {
            let mut stokes = [1.0, 0.0, 0.0, 0.0];
            stokes[k] = 1.0;
            self.outcome_of(incident, stokes).beams
        });
        for beam in &unpolarised.beams {
            let mut rows = [[0.0; 4]; 4];
            for (row, &power) in rows.iter_mut().zip(&beam.stokes) {
                row[0] = power;
            }
            for (k, column) in columns.iter().enumerate() {
                let light = column.iter().find(|b| same(b.direction, beam.direction)).map_or([0.0; 4], |b| b.stokes);
                for i in 0..4 {
                    rows[i][k + 1] = light[i] - beam.stokes[i];
                }
            }
            let (direction, total_reflections) = (beam.direction, beam.total_reflections);
            out.beams.push(PolarisedLobe { direction, mueller: Mueller(rows), total_reflections });
        }
    }

    fn lit_lobes(&self, incident: Direction, [q, u, v]: [f64; 3], out: &mut LitLobes) {
        let light = if self.is_resolved { [1.0, q, u, v] } else { [1.0, 0.0, 0.0, 0.0] };
        let found = self.outcome_of(incident, light);
        *out = LitLobes {
            beams: gathered(found.beams),
            absorbed: found.absorptance.iter().sum(),
            residual: found.residual,
        };
        if !self.is_resolved {
            out.beams.iter_mut().for_each(|beam| beam.stokes = [beam.stokes[0], 0.0, 0.0, 0.0]);
        }
    }

    fn polarised_scatter(&self, incident: Direction, polarisation: [f64; 3], u: [f64; 3]) -> (Scattered, [f64; 3]) {
        let mut rng = Rng::new(u[2].to_bits(), u[1].to_bits());
        let (layers, first) = self.drawn(u[0]);
        let gap = if incident.z > 0.0 { 0 } else { layers.len() };
        let given = [first, u[1], rng.uniform()];
        let numbers = |meeting| if meeting == 0 { given } else { std::array::from_fn(|_| rng.uniform()) };
        let ray = Ray { gap, direction: incident, polarisation, total_reflections: 0 };
        match walk(layers, self.is_resolved, ray, numbers) {
            End::Leaves(Ray { direction, polarisation, total_reflections, .. }) => {
                (Scattered::Leaves { direction, total_reflections }, polarisation)
            }
            End::Absorbed(_) | End::Lost => (Scattered::Absorbed, [0.0; 3]),
        }
    }
}

impl Straight {
    fn add(&mut self, weight: f64, other: Self) {
        self.transmittance += weight * other.transmittance;
        self.reflectance += weight * other.reflectance;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClearGlazing, Interface, Split};
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

    /// One layer is itself, from either side, but for its table of 1e-7; a stack of openings is an opening.
    #[test]
    fn one_layer_is_itself() {
        let alone = ClearGlazing::slab(1.52, 4.0, 0.01).expect("possible");
        let stack = Stack::new(vec![Arc::new(alone.clone())]).expect("a layer");
        for d in [along(0.2, -0.5, 0.8), along(0.2, -0.5, -0.3)] {
            let (stacked, alone) = (stack.straight(d).expect("clear"), alone.straight(d).expect("clear"));
            assert!((stacked.transmittance - alone.transmittance).abs() < 1e-7);
            assert!((stacked.reflectance - alone.reflectance).abs() < 1e-7);
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
            assert!((share(true) - straight.transmittance).abs() < 1e-9);
            assert!((share(false) - straight.reflectance).abs() < 1e-9);
            assert!((share(true) + share(false) + lobes.absorbed + lobes.residual - 1.0).abs() < 1e-12);
            assert!(lobes.residual < 1e-9 && lobes.beams.len() == 2);
            // and what each layer keeps is the same, followed and added
            let (followed, shares) = (stack.outcome(d).absorptance, stack.shares(d));
            for (a, b) in followed.iter().zip(&shares.absorptance) {
                assert!((a - b).abs() < 1e-9, "{a} {b}");
            }
            let kept: f64 = shares.absorptance.iter().sum();
            assert!((kept + shares.transmittance + shares.reflectance - 1.0).abs() < 1e-14);
        }
    }

    /// s light stays s light: two equal panes transmit the mean of what s and p do, which averaging between them misses.
    #[test]
    fn polarisation_is_carried_from_pane_to_pane() {
        let layers = || vec![pane(1.52, 0.0), pane(1.52, 0.0)];
        let d = along(0.0, -(75.0_f64).to_radians().tan(), 1.0);
        let resolved = Stack::new(layers()).expect("layers");
        let averaged = Stack::spectral(vec![(layers(), 1.0)], false).expect("layers");
        // lossless: n like panes of one polarisation have T = (1 − R) / (1 + (2n − 1) R), R of one face
        let Split::Partial { amplitude_s, amplitude_p, .. } = (Interface { n_i: 1.0, n_t: 1.52 }).split(d.z) else {
            panic!("from air all goes in part")
        };
        let expected =
            [amplitude_s, amplitude_p].map(|r| (1.0 - r * r) / (1.0 + 3.0 * r * r)).iter().sum::<f64>() / 2.0;
        let found = resolved.straight(d).expect("clear").transmittance;
        assert!((found - expected).abs() < 1e-12);
        assert!(found - averaged.straight(d).expect("clear").transmittance > 0.02);
    }

    /// Stokes vectors followed beam by beam are s and p added apart, in any plane of incidence.
    #[test]
    fn a_nested_stack_is_its_layers() {
        let nested: Arc<dyn Glazing> = Arc::new(Stack::new(vec![pane(1.52, 0.02), pane(1.49, 0.0)]).expect("layers"));
        let whole = Stack::new(vec![nested, pane(1.6, 0.1)]).expect("layers");
        let flat = Stack::new(vec![pane(1.52, 0.02), pane(1.49, 0.0), pane(1.6, 0.1)]).expect("layers");
        for d in [along(0.4, -0.7, 0.3), along(-0.8, 0.1, -0.3)] {
            let (a, b) = (whole.outcome(d), flat.shares(d));
            let through: f64 = a.beams.iter().filter(|l| l.direction.z * d.z > 0.0).map(|l| l.stokes[0]).sum();
            assert!((through - b.transmittance).abs() < 1e-8, "{through} {}", b.transmittance);
            assert!((a.absorptance[0] - b.absorptance[0] - b.absorptance[1]).abs() < 1e-8);
        }
    }

    /// What spreads its light and what does not fit is refused.
    #[test]
    fn wavelengths_must_fit() {
        assert!(Stack::spectral(Vec::new(), true).is_err());
        assert!(Stack::spectral(vec![(vec![pane(1.5, 0.0)], 0.4)], true).is_err());
        let uneven = vec![(vec![pane(1.5, 0.0)], 0.5), (vec![pane(1.5, 0.0), pane(1.5, 0.0)], 0.5)];
        assert!(Stack::spectral(uneven, true).is_err());
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
