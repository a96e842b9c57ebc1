//! What can be wrong with a room: a variant a rule, naming the object.

/// A mistake in the description of a scene or of what to compute in it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RoomError {
    /// Nothing to trace.
    #[error("a scene must hold at least one surface, got none; add walls, a window or a mesh")]
    EmptyScene,
    /// Two objects of one name.
    #[error("the names of surfaces must differ, got {name:?} twice; rename one")]
    NameTwice {
        /// The name.
        name: String,
    },
    /// A coordinate that is none.
    #[error("{name}: coordinates must be finite, got {value} at vertex {vertex}; correct the drawing")]
    NotFinite {
        /// The object.
        name: String,
        /// Which vertex, from 0.
        vertex: usize,
        /// What was found.
        value: f64,
    },
    /// An outline that bounds no area.
    #[error("{name}: an outline must be three or more points that bound an area, got {detail}; correct the outline")]
    NoArea {
        /// The object.
        name: String,
        /// What was found.
        detail: String,
    },
    /// An outline that is not flat.
    #[error(
        "{name}: an outline must lie in one plane, got vertex {vertex} {distance_m:.2e} m off it; \
         correct the vertex or give a mesh"
    )]
    NotPlanar {
        /// The object.
        name: String,
        /// Which vertex, from 0.
        vertex: usize,
        /// How far off \[m\].
        distance_m: f64,
    },
    /// An outline that crosses or touches itself.
    #[error("{name}: an outline must not cross itself, got edges {first} and {second} crossing; reorder its vertices")]
    SelfCrossing {
        /// The object.
        name: String,
        /// One edge, from 0.
        first: usize,
        /// The other edge.
        second: usize,
    },
    /// An opening that is not inside.
    #[error(
        "{name}: {inner} must lie wholly inside {outer} and apart from its other openings, got {detail}; \
         move or shrink it"
    )]
    Outside {
        /// The object.
        name: String,
        /// What should lie inside.
        inner: String,
        /// What it should lie inside.
        outer: String,
        /// What was found.
        detail: String,
    },
    /// A wall that is not there.
    #[error("{name}: its wall must be a polygon of the scene, got {wall:?}; add the wall first or correct the name")]
    NoSuchWall {
        /// The window.
        name: String,
        /// The wall asked for.
        wall: String,
    },
    /// Shares that create light.
    #[error("{name}: {what} must lie in 0..1{rule}, got {value}; correct the material")]
    ShareOutside {
        /// The object.
        name: String,
        /// Which share.
        what: &'static str,
        /// What else holds.
        rule: &'static str,
        /// What was given.
        value: f64,
    },
    /// A mesh that refers to what is not there.
    #[error("{name}: triangle {triangle} must name vertices 0..{count}, got {index}; correct the mesh")]
    NoSuchVertex {
        /// The object.
        name: String,
        /// Which triangle.
        triangle: usize,
        /// The index found.
        index: i64,
        /// How many vertices there are.
        count: usize,
    },
    /// A medium that is none.
    #[error("{name}: {what} of the medium must be {rule}, got {value}; correct the medium")]
    NotAMedium {
        /// The object.
        name: String,
        /// Which quantity.
        what: &'static str,
        /// The rule.
        rule: &'static str,
        /// What was given.
        value: f64,
    },
    /// Neighbouring boundaries that disagree on what lies between them.
    #[error(
        "{name}: media must nest, but between {name} and {other} one says {one} and the other {two}; \
         close the body or swap its front and back"
    )]
    MediaDoNotNest {
        /// One boundary.
        name: String,
        /// The boundary met next, or "the open sky".
        other: String,
        /// What the first says lies between.
        one: String,
        /// What the second says.
        two: String,
    },
    /// A window that scatters the sun's light in no definite directions.
    #[error(
        "{name}: the sun's beams behind a window must have definite directions, got {residual:.3} of the light without; \
         use smooth cuts, or fill the window with the panel's own BSDF, `panel.bsdf().blurred()`, which spreads the sun's light"
    )]
    NoLobes {
        /// The window.
        name: String,
        /// The share of light without a direction.
        residual: f64,
    },
    /// A direction that is none.
    #[error("{name}: {what} must be a finite vector of some length, got {value}; correct it")]
    NoDirection {
        /// The object.
        name: String,
        /// Which vector.
        what: &'static str,
        /// What was given.
        value: String,
    },
    /// A number of samples that is none, and the like.
    #[error("{name} must be {rule}, got {value}; {way_out}")]
    Setting {
        /// Which setting.
        name: &'static str,
        /// The rule.
        rule: &'static str,
        /// What was given.
        value: String,
        /// What to do.
        way_out: &'static str,
    },
}
