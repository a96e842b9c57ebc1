//! Layers that turn no light: all reflections between them in closed form.

use super::super::{Glazing, Straight, clear::mirror_image};
use hemisphere::Direction;
use std::sync::Arc;

/// Where the power goes: what leaves on the far side, what comes back, what each layer keeps.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LayerShares {
    /// Share that leaves on the far side.
    pub transmittance: f64,
    /// Share that leaves on the side it came from.
    pub reflectance: f64,
    /// Share that leaves on the far side with its vertical sense reversed.
    pub transmittance_deflected: f64,
    /// Share each layer absorbs, the outermost first.
    pub absorptance: Vec<f64>,
    /// Share not followed to its end.
    pub residual: f64,
}

/// One layer along the way of the light: what it does to light ahead of it and to light that comes back.
pub struct Layer {
    ahead: Straight,
    behind: Straight,
}

/// The layers for light along `incident`, in the order it meets them, for s and for p; `None` if one of them turns light.
pub fn straight_layers(layers: &[Arc<dyn Glazing>], incident: Direction) -> Option<[Vec<Layer>; 2]> {
    let back = mirror_image(incident);
    let mut found = [Vec::with_capacity(layers.len()), Vec::with_capacity(layers.len())];
    for i in 0..layers.len() {
        let layer = &layers[if incident.z > 0.0 { i } else { layers.len() - 1 - i }];
        let (ahead, behind) = (layer.straight_s_p(incident)?, layer.straight_s_p(back)?);
        for (which, list) in found.iter_mut().enumerate() {
            list.push(Layer { ahead: ahead[which], behind: behind[which] });
        }
    }
    Some(found)
}

/// The same for light that is unpolarised before every layer.
pub fn averaged(by_polarisation: &[Vec<Layer>; 2]) -> Vec<Layer> {
    let [s, p] = by_polarisation;
    let mean = super::super::polarised::mean;
    let layer =
        |(s, p): (&Layer, &Layer)| Layer { ahead: mean([s.ahead, p.ahead]), behind: mean([s.behind, p.behind]) };
    s.iter().zip(p).map(layer).collect()
}

/// Transmittance and reflectance of all layers together (theory/layers.md, eqs. 1 and 2).
pub fn added(layers: &[Layer]) -> Straight {
    let mut rest = 0.0;
    let mut through = 1.0;
    // from the far side: what lies behind layer i reflects `rest`
    for Layer { ahead, behind } in layers.iter().rev() {
        let passes = passed(ahead.transmittance, behind.reflectance, rest);
        rest = ahead.reflectance + passes * rest * behind.transmittance;
        through *= passes;
    }
    Straight { transmittance: through, reflectance: rest }
}

/// The same with what each layer keeps, in the order of `layers` (theory/layers.md, eq. 3).
pub fn added_with_absorptance(layers: &[Layer], absorptance: &mut [f64], weight: f64) -> Straight {
    // reflectance of the layers from each gap on
    let mut rest = vec![0.0; layers.len() + 1];
    for (i, Layer { ahead, behind }) in layers.iter().enumerate().rev() {
        let passes = passed(ahead.transmittance, behind.reflectance, rest[i + 1]);
        rest[i] = ahead.reflectance + passes * rest[i + 1] * behind.transmittance;
    }
    let mut onward = 1.0;
    for (i, Layer { ahead, behind }) in layers.iter().enumerate() {
        let beyond = onward * passed(ahead.transmittance, behind.reflectance, rest[i + 1]);
        let returning = beyond * rest[i + 1];
        let kept = |shares: &Straight| 1.0 - shares.transmittance - shares.reflectance;
        absorptance[i] += weight * (onward * kept(ahead) + returning * kept(behind));
        onward = beyond;
    }
    Straight { transmittance: onward, reflectance: rest[0] }
}

/// Light beyond a layer for each unit before it, all reflections between the layer and the rest summed.
fn passed(transmittance: f64, reflectance_behind: f64, rest: f64) -> f64 {
    // a layer that lets nothing through at grazing incidence may reflect all on both sides
    if transmittance == 0.0 { 0.0 } else { transmittance / (1.0 - reflectance_behind * rest) }
}
