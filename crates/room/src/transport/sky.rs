//! The sky's patches, as directions are drawn in them.

use hemisphere::{SkyBasis, Vec3};

/// A sky basis with what is asked of its patches again and again.
pub struct Sky<'a> {
    pub basis: &'a SkyBasis,
    patches: Vec<Cap>,
}

/// A circle on the sky about a patch.
struct Cap {
    centre: Vec3,
    radius: f64,
    solid_angle: f64,
}

impl<'a> Sky<'a> {
    pub fn new(basis: &'a SkyBasis) -> Self {
        let cap = |patch| {
            let centre = basis.centre(patch);
            // a patch is widest along one of its edges: its corners and the middles of these bound it
            let edges = [0.0, 0.5, 1.0 - 1e-12];
            let rim = edges.iter().flat_map(|&u| edges.map(|v| basis.sample(patch, [u, v])));
            let radius = rim.map(|d| d.dot(centre).clamp(-1.0, 1.0).acos()).fold(0.0, f64::max);
            Cap { centre, radius: radius + 1e-9, solid_angle: basis.solid_angle(patch) }
        };
        Self { basis, patches: (0..basis.ground()).map(cap).collect() }
    }

    /// How many patches, without the ground.
    pub fn patches(&self) -> usize {
        self.patches.len()
    }

    /// Directions drawn in a patch where so many are drawn per steradian, at least one.
    #[inline]
    pub fn directions(&self, patch: usize, per_sr: f64) -> u32 {
        (per_sr * self.patches[patch].solid_angle).ceil() as u32
    }

    /// Directions per steradian that these are.
    #[inline]
    pub fn density(&self, patch: usize, per_sr: f64) -> f64 {
        f64::from(self.directions(patch, per_sr)) / self.patches[patch].solid_angle
    }

    /// The patches that a cone about `axis` of this half-angle may touch.
    pub fn touched(&self, axis: Vec3, half_angle: f64) -> impl Iterator<Item = usize> + '_ {
        let near = move |cap: &Cap| {
            let reach = half_angle + cap.radius;
            reach >= std::f64::consts::PI || cap.centre.dot(axis) >= reach.cos()
        };
        self.patches.iter().enumerate().filter(move |(_, cap)| near(cap)).map(|(patch, _)| patch)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hemisphere::Rng;

    /// Caps hold their patches, so that a cone about any direction touches the patch it lies in.
    #[test]
    fn caps_hold_their_patches() {
        let mut rng = Rng::new(3, 0);
        for name in ["tregenza145", "reinhart577", "troplux5221"] {
            let basis = SkyBasis::named(name).expect("known");
            let sky = Sky::new(&basis);
            for patch in 0..basis.ground() {
                for _ in 0..20 {
                    let direction = basis.sample(patch, [rng.uniform(), rng.uniform()]);
                    assert!(sky.touched(direction, 0.0).any(|touched| touched == patch), "{name} {patch}");
                }
            }
        }
    }
}
