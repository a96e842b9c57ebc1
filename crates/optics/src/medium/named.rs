//! Media with a name: whose measurement, which formula, which table. Every number has its source beside it.
//!
//! Coefficients and tables are those of the refractiveindex.info database (public domain, CC0 1.0).

use super::{Absorption, Dispersion, Medium};
use crate::OpticsError;

/// What is known of one medium.
struct Entry {
    name: &'static str,
    law: &'static str,
    /// In the order of [`Dispersion::from_coefficients`], λ in µm.
    coefficients: &'static [f64],
    range_nm: (f64, f64),
    /// Table of the extinction coefficient; without one the source gives none and the medium is lossless.
    extinction: Option<&'static str>,
    source: &'static str,
}

/// Fit of M. Rubin, Solar Energy Materials 12, 275–288 (1985) to all soda-lime glasses: n = 1.5130 − 0.003169 λ² + 0.003962 λ⁻².
const SODA_LIME: &[f64] = &[1.5130, -0.003169, 2.0, 0.003962, -2.0];
const RUBIN: &str = "n, k: M. Rubin, Solar Energy Materials 12, 275-288 (1985)";

const ENTRIES: &[Entry] = &[
    Entry {
        name: "pmma",
        law: "polynomial",
        coefficients: &[
            2.1778, 6.1209e-3, 2.0, -1.5004e-3, 4.0, 2.3678e-2, -2.0, -4.2137e-3, -4.0, 7.3417e-4, -6.0, -4.5042e-5,
            -8.0,
        ],
        range_nm: (420.0, 1620.0),
        extinction: Some(include_str!("../tables/pmma_k.csv")),
        source: "n: G. Beadie et al., Applied Optics 54, F139-F143 (2015); \
                 k: X. Zhang et al., Applied Optics 59, 2337-2344 (2020), sheet by Mitsubishi",
    },
    Entry {
        name: "pmma_sultanova",
        law: "sellmeier",
        coefficients: &[0.0, 1.1819, 0.011313],
        range_nm: (436.8, 1052.0),
        extinction: None,
        source: "n: N. Sultanova, S. Kasarova, I. Nikolov, Acta Physica Polonica A 116, 585-587 (2009); no absorption given",
    },
    Entry {
        name: "polycarbonate",
        law: "sellmeier",
        coefficients: &[0.0, 1.4182, 0.021304],
        range_nm: (436.8, 1052.0),
        extinction: None,
        source: "n: N. Sultanova, S. Kasarova, I. Nikolov, Acta Physica Polonica A 116, 585-587 (2009); no absorption given",
    },
    Entry {
        name: "soda_lime_clear",
        law: "cauchy",
        coefficients: SODA_LIME,
        range_nm: (310.0, 4600.0),
        extinction: Some(include_str!("../tables/soda_lime_clear_k.csv")),
        source: RUBIN,
    },
    Entry {
        name: "soda_lime_low_iron",
        law: "cauchy",
        coefficients: SODA_LIME,
        range_nm: (310.0, 4600.0),
        extinction: Some(include_str!("../tables/soda_lime_low_iron_k.csv")),
        source: RUBIN,
    },
    Entry {
        name: "soda_lime_grey",
        law: "cauchy",
        coefficients: SODA_LIME,
        range_nm: (320.0, 4600.0),
        extinction: Some(include_str!("../tables/soda_lime_grey_k.csv")),
        source: RUBIN,
    },
    Entry {
        name: "soda_lime_bronze",
        law: "cauchy",
        coefficients: SODA_LIME,
        range_nm: (320.0, 4600.0),
        extinction: Some(include_str!("../tables/soda_lime_bronze_k.csv")),
        source: RUBIN,
    },
    Entry {
        name: "bk7",
        law: "sellmeier",
        coefficients: &[0.0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653],
        range_nm: (300.0, 2500.0),
        extinction: Some(include_str!("../tables/bk7_k.csv")),
        source: "n, k: Schott N-BK7, optical glass catalogue of 2017-01-20",
    },
];

/// The names of all media with one.
pub fn names() -> impl Iterator<Item = &'static str> {
    ENTRIES.iter().map(|entry| entry.name)
}

impl Medium {
    /// A medium by its name.
    pub fn named(name: &str) -> Result<Self, OpticsError> {
        let entry = find(name)?;
        let absorption = match entry.extinction {
            Some(text) => Absorption::from_values("extinction", &numbers(text))?,
            None => Absorption::Constant(0.0),
        };
        Self::new(Dispersion::from_coefficients(entry.law, entry.coefficients, Some(entry.range_nm))?, absorption)
    }

    /// Who measured it.
    pub fn source_of(name: &str) -> Result<&'static str, OpticsError> {
        find(name).map(|entry| entry.source)
    }
}

fn find(name: &str) -> Result<&'static Entry, OpticsError> {
    ENTRIES.iter().find(|entry| entry.name == name).ok_or_else(|| OpticsError::UnknownMedium {
        name: name.to_owned(),
        known: names().collect::<Vec<_>>().join(", "),
    })
}

/// The numbers of a packaged table, row by row; what is not a row of numbers is its heading.
fn numbers(text: &str) -> Vec<f64> {
    text.lines()
        .filter_map(|line| {
            let (wavelength_nm, value) = line.split_once(',')?;
            Some([wavelength_nm.parse().ok()?, value.trim().parse().ok()?])
        })
        .flatten()
        .collect()
}
