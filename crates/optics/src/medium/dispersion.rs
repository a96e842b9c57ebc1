//! How the refractive index depends on the wavelength.

use super::table::Table;
use crate::OpticsError;

/// The law n(λ); λ in µm inside the formulas, as their authors wrote them.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// One index at every wavelength (theory/media.md, eq. 1).
    Constant(f64),
    /// n² = 1 + c₀ + Σ Bᵢ λ² / (λ² − Cᵢ), the Cᵢ in µm² (theory/media.md, eq. 2).
    Sellmeier {
        /// c₀, usually 0.
        offset: f64,
        /// Bᵢ and Cᵢ [µm²].
        terms: Vec<(f64, f64)>,
    },
    /// n = c₀ + Σ cᵢ λ^pᵢ (theory/media.md, eq. 3).
    Cauchy {
        /// c₀.
        constant: f64,
        /// cᵢ [µm^−pᵢ] and pᵢ.
        terms: Vec<(f64, f64)>,
    },
    /// n² = c₀ + Σ cᵢ λ^pᵢ (theory/media.md, eq. 4).
    Polynomial {
        /// c₀.
        constant: f64,
        /// cᵢ [µm^−pᵢ] and pᵢ.
        terms: Vec<(f64, f64)>,
    },
    /// Measured values, straight lines in between.
    Tabulated(Table),
}

/// A law and where it holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Dispersion {
    law: Law,
    range_nm: Option<(f64, f64)>,
}

/// Where a law is looked at when it is made: often enough to meet a pole or an index below 1.
const PROBES: u32 = 256;

impl Dispersion {
    /// One index at every wavelength.
    pub fn constant(n: f64) -> Result<Self, OpticsError> {
        checked(n, None)?;
        Ok(Self { law: Law::Constant(n), range_nm: None })
    }

    /// A law that holds in `range_nm`; a table brings its own range and may be narrowed.
    pub fn new(law: Law, range_nm: Option<(f64, f64)>) -> Result<Self, OpticsError> {
        let range_nm = match (&law, range_nm) {
            (Law::Tabulated(table), None) => Some(table.range_nm()),
            (Law::Tabulated(table), Some(range)) => {
                let (low, high) = table.range_nm();
                Some((range.0.max(low), range.1.min(high)))
            }
            (_, range) => range,
        };
        if let Some((low_nm, high_nm)) = range_nm {
            if !(low_nm.is_finite() && high_nm.is_finite() && 0.0 < low_nm && low_nm < high_nm) {
                return Err(OpticsError::EmptyRange { low_nm, high_nm });
            }
        }
        let dispersion = Self { law, range_nm };
        match (&dispersion.law, range_nm) {
            (Law::Constant(n), _) => drop(checked(*n, None)?),
            (Law::Tabulated(table), _) => {
                table.pairs().try_for_each(|(w, n)| checked(n, Some(w)).map(drop))?;
            }
            (_, Some((low, high))) => (0..=PROBES)
                .map(|i| low + (high - low) * f64::from(i) / f64::from(PROBES))
                .try_for_each(|w| dispersion.index(w).map(drop))?,
            (_, None) => {}
        }
        Ok(dispersion)
    }

    /// A law by its name and its numbers in the order of theory/media.md; a table as λ₁, n₁, λ₂, n₂ … [nm].
    pub fn from_coefficients(law: &str, c: &[f64], range_nm: Option<(f64, f64)>) -> Result<Self, OpticsError> {
        let pairs = |from: usize| -> Vec<(f64, f64)> { c[from..].chunks_exact(2).map(|p| (p[0], p[1])).collect() };
        let count = |law, rule| Err(OpticsError::CoefficientCount { law, rule, count: c.len() });
        let odd = c.len() % 2 == 1;
        let law = match law {
            "constant" if c.len() == 1 => Law::Constant(c[0]),
            "constant" => return count("constant", "one: n"),
            "sellmeier" if odd => Law::Sellmeier { offset: c[0], terms: pairs(1) },
            "sellmeier" => return count("sellmeier", "an offset and then pairs of B and C (an odd number)"),
            "cauchy" if odd => Law::Cauchy { constant: c[0], terms: pairs(1) },
            "cauchy" => return count("cauchy", "a constant and then pairs of factor and power (an odd number)"),
            "polynomial" if odd => Law::Polynomial { constant: c[0], terms: pairs(1) },
            "polynomial" => {
                return count("polynomial", "a constant and then pairs of factor and power (an odd number)");
            }
            "tabulated" if !odd => Law::Tabulated(Table::new(&pairs(0))?),
            "tabulated" => return count("tabulated", "pairs of wavelength and n (an even number)"),
            name => return Err(OpticsError::UnknownLaw { name: name.to_owned() }),
        };
        Self::new(law, range_nm)
    }

    /// The law's name and numbers, as [`Self::from_coefficients`] takes them.
    pub fn to_coefficients(&self) -> (&'static str, Vec<f64>) {
        let flat = |first: &[f64], terms: &[(f64, f64)]| {
            first.iter().copied().chain(terms.iter().flat_map(|(a, b)| [*a, *b])).collect()
        };
        match &self.law {
            Law::Constant(n) => ("constant", vec![*n]),
            Law::Sellmeier { offset, terms } => ("sellmeier", flat(&[*offset], terms)),
            Law::Cauchy { constant, terms } => ("cauchy", flat(&[*constant], terms)),
            Law::Polynomial { constant, terms } => ("polynomial", flat(&[*constant], terms)),
            Law::Tabulated(table) => ("tabulated", table.pairs().flat_map(|(a, b)| [a, b]).collect()),
        }
    }

    /// Where the law holds [nm]; `None`: everywhere.
    pub fn range_nm(&self) -> Option<(f64, f64)> {
        self.range_nm
    }

    /// Whether n depends on the wavelength.
    pub fn is_spectral(&self) -> bool {
        !matches!(self.law, Law::Constant(_))
    }

    /// n at a wavelength, which the medium has checked to be in range.
    pub fn index(&self, wavelength_nm: f64) -> Result<f64, OpticsError> {
        let um = wavelength_nm * 1e-3;
        let powers =
            |constant: &f64, terms: &[(f64, f64)]| constant + terms.iter().map(|(c, p)| c * um.powf(*p)).sum::<f64>();
        let n = match &self.law {
            Law::Constant(n) => *n,
            Law::Sellmeier { offset, terms } => {
                (1.0 + offset + terms.iter().map(|(b, c)| b * um * um / (um * um - c)).sum::<f64>()).sqrt()
            }
            Law::Cauchy { constant, terms } => powers(constant, terms),
            Law::Polynomial { constant, terms } => powers(constant, terms).sqrt(),
            Law::Tabulated(table) => table.at(wavelength_nm),
        };
        checked(n, self.is_spectral().then_some(wavelength_nm))
    }
}

/// n, if it is one.
fn checked(n: f64, wavelength_nm: Option<f64>) -> Result<f64, OpticsError> {
    if n.is_finite() && n >= 1.0 { Ok(n) } else { Err(OpticsError::IndexBelowOne { value: n, wavelength_nm }) }
}
