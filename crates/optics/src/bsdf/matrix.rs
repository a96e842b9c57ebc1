//! A block between pairs of Klems patches.

use crate::OpticsError;
use hemisphere::KlemsBasis;

/// Values constant between pairs of Klems patches; the bases of incident and outgoing directions may differ.
#[derive(Clone, Debug)]
pub struct Matrix {
    incident: KlemsBasis,
    outgoing: KlemsBasis,
    /// [1/sr], one outgoing patch after the other for each incident one.
    values: Vec<f64>,
    /// Share sent to the outgoing patches up to each, in the same order.
    cumulative: Vec<f64>,
}

impl Matrix {
    /// A block from its values [1/sr] in rows of one outgoing patch: `values[o * incident.patches() + i]`.
    pub fn new(incident: KlemsBasis, outgoing: KlemsBasis, values: &[f64]) -> Result<Self, OpticsError> {
        let (columns, rows) = (incident.patches(), outgoing.patches());
        if values.len() != rows * columns {
            return Err(OpticsError::BsdfShape { rows, columns, got: values.len() });
        }
        if let Some(at) = values.iter().position(|v| !(v.is_finite() && *v >= 0.0)) {
            let place = format!("outgoing patch {}, incident patch {}", at / columns, at % columns);
            return Err(OpticsError::BsdfValue { place, value: values[at] });
        }
        let by_column = |i: usize| (0..rows).map(move |o| values[o * columns + i]);
        let values: Vec<f64> = (0..columns).flat_map(by_column).collect();
        let mut cumulative = values.clone();
        for column in cumulative.chunks_mut(rows) {
            let mut sum = 0.0;
            for (o, value) in column.iter_mut().enumerate() {
                sum += *value * outgoing.projected_solid_angle(o);
                *value = sum;
            }
        }
        Ok(Self { incident, outgoing, values, cumulative })
    }

    /// The value [1/sr].
    pub fn value(&self, incident: [f64; 2], outgoing: [f64; 2]) -> f64 {
        let column = self.incident.find(incident[0], incident[1]) * self.outgoing.patches();
        self.values[column + self.outgoing.find(outgoing[0], outgoing[1])]
    }

    /// Shares sent to the outgoing patches up to each by light along `incident`.
    fn column(&self, incident: [f64; 2]) -> &[f64] {
        let rows = self.outgoing.patches();
        let column = self.incident.find(incident[0], incident[1]) * rows;
        &self.cumulative[column..column + rows]
    }

    /// Share of the light along `incident` that is sent out.
    pub fn hemispherical(&self, incident: [f64; 2]) -> f64 {
        self.column(incident).last().copied().unwrap_or(0.0)
    }

    /// The greatest such share of all incident patches.
    pub fn greatest_hemispherical(&self) -> f64 {
        self.cumulative.chunks(self.outgoing.patches()).filter_map(|c| c.last().copied()).fold(0.0, f64::max)
    }

    /// A direction drawn in proportion to power.
    pub(super) fn sample(&self, incident: [f64; 2], u: [f64; 3]) -> [f64; 2] {
        let column = self.column(incident);
        let place = u[0] * column.last().copied().unwrap_or(0.0);
        let patch = column.partition_point(|&sum| sum <= place).min(column.len() - 1);
        self.outgoing.sample(patch, [u[1], u[2]])
    }
}
