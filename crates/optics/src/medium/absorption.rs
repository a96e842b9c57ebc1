//! How much a medium absorbs along the way.

use super::table::Table;
use crate::OpticsError;
use std::f64::consts::PI;

/// The absorption coefficient α, of the power, per mm of path.
#[derive(Clone, Debug, PartialEq)]
pub enum Absorption {
    /// The same α at every wavelength [1/mm].
    Constant(f64),
    /// α measured at some wavelengths [1/mm].
    PerMm(Table),
    /// The extinction coefficient k, the imaginary part of the index: α = 4πk / λ (theory/media.md, eq. 6).
    Extinction(Table),
}

impl Absorption {
    /// By the quantity's name and numbers: `constant` α, or `per_mm` and `extinction` as λ₁, value₁, λ₂, value₂ … [nm].
    pub fn from_values(quantity: &str, values: &[f64]) -> Result<Self, OpticsError> {
        let table = |quantity| {
            if values.len() % 2 == 1 {
                let rule = "pairs of wavelength and value (an even number)";
                return Err(OpticsError::CoefficientCount { law: "tabulated", rule, count: values.len() });
            }
            let table = Table::new(&values.chunks_exact(2).map(|p| (p[0], p[1])).collect::<Vec<_>>())?;
            table.pairs().try_for_each(|(w, value)| checked(quantity, value, Some(w)).map(drop))?;
            Ok(table)
        };
        match quantity {
            "constant" => match values {
                [alpha] => Ok(Self::Constant(checked("absorption_per_mm", *alpha, None)?)),
                _ => Err(OpticsError::CoefficientCount { law: "constant", rule: "one", count: values.len() }),
            },
            "per_mm" => Ok(Self::PerMm(table("absorption_per_mm")?)),
            "extinction" => Ok(Self::Extinction(table("extinction")?)),
            name => Err(OpticsError::UnknownQuantity { name: name.to_owned() }),
        }
    }

    /// The quantity's name and numbers, as [`Self::from_values`] takes them.
    pub fn to_values(&self) -> (&'static str, Vec<f64>) {
        let flat = |table: &Table| table.pairs().flat_map(|(w, value)| [w, value]).collect();
        match self {
            Self::Constant(alpha) => ("constant", vec![*alpha]),
            Self::PerMm(table) => ("per_mm", flat(table)),
            Self::Extinction(table) => ("extinction", flat(table)),
        }
    }

    /// Where it is known [nm]; `None`: everywhere.
    pub fn range_nm(&self) -> Option<(f64, f64)> {
        match self {
            Self::Constant(_) => None,
            Self::PerMm(table) | Self::Extinction(table) => Some(table.range_nm()),
        }
    }

    /// α at a wavelength [1/mm], which the medium has checked to be in range.
    pub fn per_mm(&self, wavelength_nm: f64) -> f64 {
        /// Nanometres in a millimetre.
        const NM_PER_MM: f64 = 1e6;
        match self {
            Self::Constant(alpha) => *alpha,
            Self::PerMm(table) => table.at(wavelength_nm),
            Self::Extinction(table) => 4.0 * PI * table.at(wavelength_nm) / (wavelength_nm / NM_PER_MM),
        }
    }
}

/// The coefficient, if a passive medium can have it.
fn checked(quantity: &'static str, value: f64, wavelength_nm: Option<f64>) -> Result<f64, OpticsError> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(OpticsError::NegativeAbsorption { quantity, value, wavelength_nm })
    }
}
