//! What can be wrong with a medium or a measured glass: a variant a rule, in the user's units.

/// A mistake in what the user gave; the message says name, rule, value and way out.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum OpticsError {
    /// A refractive index that no clear medium has.
    #[error("n must be finite and at least 1, got {value}{}; give the index relative to air", at(.wavelength_nm))]
    IndexBelowOne {
        /// The index found.
        value: f64,
        /// The wavelength it was found at, if it depends on one [nm].
        wavelength_nm: Option<f64>,
    },
    /// A medium that would amplify.
    #[error(
        "{quantity} must be finite and not negative, got {value}{}; use 0 for a lossless medium",
        at(.wavelength_nm)
    )]
    NegativeAbsorption {
        /// The name of what was given.
        quantity: &'static str,
        /// The absorption or extinction coefficient found.
        value: f64,
        /// The wavelength it was found at, if it depends on one [nm].
        wavelength_nm: Option<f64>,
    },
    /// A wavelength outside the range the data was measured in.
    #[error(
        "wavelength_nm must lie in the validity range {low_nm} to {high_nm} nm of this medium, got {value}; \
         choose a wavelength inside it or a medium that reaches further"
    )]
    WavelengthOutside {
        /// The wavelength asked for [nm].
        value: f64,
        /// Where the data begins [nm].
        low_nm: f64,
        /// Where it ends [nm].
        high_nm: f64,
    },
    /// A wavelength that is none.
    #[error("wavelength_nm must be finite and greater than 0, got {value}; visible light is 380 to 780 nm")]
    NotAWavelength {
        /// What was given.
        value: f64,
    },
    /// A range without extent.
    #[error(
        "wavelength_range_nm must be two finite wavelengths, the shorter (above 0) first, got {low_nm} to {high_nm}; \
         swap or correct them"
    )]
    EmptyRange {
        /// The end given first [nm].
        low_nm: f64,
        /// The end given second [nm].
        high_nm: f64,
    },
    /// A dispersion and an absorption that share no wavelength.
    #[error(
        "the ranges of n ({n_low_nm} to {n_high_nm} nm) and of absorption ({a_low_nm} to {a_high_nm} nm) must overlap; \
         give data for the same wavelengths"
    )]
    DisjointRanges {
        /// Where n begins [nm].
        n_low_nm: f64,
        /// Where n ends [nm].
        n_high_nm: f64,
        /// Where the absorption begins [nm].
        a_low_nm: f64,
        /// Where the absorption ends [nm].
        a_high_nm: f64,
    },
    /// A law with the wrong number of coefficients.
    #[error("coefficients of a {law} law must be {rule}, got {count}; see theory/media.md for the order")]
    CoefficientCount {
        /// The law's name.
        law: &'static str,
        /// How many it takes.
        rule: &'static str,
        /// How many came.
        count: usize,
    },
    /// A law that does not exist.
    #[error(
        "the law must be one of constant, sellmeier, cauchy, polynomial, tabulated; got {name:?}; correct its name"
    )]
    UnknownLaw {
        /// The name given.
        name: String,
    },
    /// A quantity of absorption that does not exist.
    #[error("the quantity of absorption must be constant, per_mm or extinction; got {name:?}; correct its name")]
    UnknownQuantity {
        /// The name given.
        name: String,
    },
    /// A named medium that does not exist.
    #[error("the name of a medium must be one of {known}; got {name:?}; or build one from its own n and absorption")]
    UnknownMedium {
        /// The name given.
        name: String,
        /// The names there are.
        known: String,
    },
    /// A table that cannot be interpolated.
    #[error("the wavelengths of a table must be at least two, finite, above 0 and increasing; got {detail}; sort them")]
    TableOrder {
        /// The offending entry.
        detail: String,
    },
    /// A transmittance that no such pane has.
    #[error("transmittance must lie above 0 and at most {greatest:.4}, got {value}; check the pane's data")]
    TransmittanceOutside {
        /// What was given.
        value: f64,
        /// The most that is possible.
        greatest: f64,
    },
    /// A stack of nothing.
    #[error("layers must be one or more, got none; give the outermost first")]
    NoLayers,
    /// A layer whose light is no longer in beams.
    #[error(
        "layers[{layer}] spreads light, so that no beams are left to follow; combine the layers as matrices, by Stack.bsdf"
    )]
    LayerSpreads {
        /// Its place, the outermost first, from 0.
        layer: usize,
    },
    /// Wavelengths whose weights or layers do not fit.
    #[error("each wavelength of a stack must have the same layers and a weight, all weights together 1; got {detail}")]
    StackSpectrum {
        /// What was found.
        detail: String,
    },
    /// A pane without body.
    #[error("thickness_mm must be finite and greater than 0, got {value}; give the pane's thickness in mm")]
    NotAThickness {
        /// What was given [mm].
        value: f64,
    },
    /// A measured pane that is not one.
    #[error(
        "normal transmittance and reflectance must be 0 or more, reflectance below 1, and their sum at most 1; \
         got {transmittance} and {reflectance}; correct the measured values"
    )]
    ImpossibleGlass {
        /// Transmittance at normal incidence.
        transmittance: f64,
        /// Reflectance at normal incidence.
        reflectance: f64,
    },
    /// A value no BSDF has.
    #[error(
        "values of a BSDF must be finite and 0 or more, got {value} ({place}); correct it, or set noise below 0 to 0"
    )]
    BsdfValue {
        /// Where it stands.
        place: String,
        /// What was found [1/sr].
        value: f64,
    },
    /// A table of the wrong size.
    #[error(
        "values of a BSDF must be {rows} outgoing by {columns} incident patches, got {got} in all; name the bases they belong to"
    )]
    BsdfShape {
        /// Outgoing patches.
        rows: usize,
        /// Incident patches.
        columns: usize,
        /// Values found.
        got: usize,
    },
    /// A block that gives more light than it gets.
    #[error(
        "{block} must send out no more than 1.01 of the light of any direction, got {sum:.4}; values are 1/sr, \
         not multiplied by cosine or solid angle"
    )]
    BsdfGains {
        /// Its name.
        block: String,
        /// The greatest share.
        sum: f64,
    },
    /// A tree of another kind.
    #[error("rank must be 3 (the same turned about its normal) or 4, got {rank}")]
    TreeRank {
        /// What was given.
        rank: usize,
    },
    /// A tree of rank 3 of an element that has an up and a right.
    #[error(
        "rank 3 is for elements with exact beams that are the same turned about their normal, as clear panes are; \
         use rank=4 for this one"
    )]
    NotIsotropic,
    /// A walk of a tree that is no tree.
    #[error("the preorder walk of a tensor tree must {rule}, which fails at place {at}; check the file it comes from")]
    TreeLength {
        /// What it must do.
        rule: &'static str,
        /// How far the walk makes sense.
        at: usize,
    },
}

/// " at 550 nm", or nothing.
fn at(wavelength_nm: &Option<f64>) -> String {
    wavelength_nm.map(|w| format!(" at {w} nm")).unwrap_or_default()
}
