//! Widths over which the contact is felt: a Gaussian in the stress around the wheel at the crown, for each load.

use fem_client::solver::Response;

use crate::signals::gaussian_fit::GaussianFit;
use crate::signals::signal_rows::TireAnswers;
use documents::signals::signal_settings::SignalSettings;
use results::StressWidth;

/// Widths that are looked for, degrees.
const WIDTHS_DEG: [f64; 2] = [0.5, 60.0];

impl TireAnswers<'_> {
    /// The width at each load, on the bare tire.
    pub fn widths(&self, settings: &SignalSettings) -> Vec<StressWidth> {
        let pressings = settings.over_loads(self.scene).into_iter();
        pressings
            .map(|pressing| {
                let response = self.fine.response(None, &pressing);
                let fit = response.clone().and_then(fitted);
                let found = fit.as_ref().ok();
                StressWidth {
                    tire: self.name.to_owned(),
                    load_n: pressing.load_n,
                    depth_mm: response.ok().map(|response| response.depth_mm),
                    amplitude_mpa: found.map(|fit| fit.amplitude),
                    width_deg: found.map(|fit| fit.width),
                    offset_mpa: found.map(|fit| fit.offset),
                    r2: found.map(|fit| fit.r2),
                    reason: fit.err(),
                }
            })
            .collect()
    }
}

fn fitted(response: &Response) -> Result<GaussianFit, String> {
    let gauges = response.gauges.iter();
    let points: Vec<(f64, f64)> = gauges
        .map(|reading| (reading.gauge.theta_deg, reading.von_mises_mpa))
        .collect();
    GaussianFit::of(&points, WIDTHS_DEG).ok_or_else(|| {
        let [narrowest, widest] = WIDTHS_DEG;
        format!(
            "no Gaussian between {narrowest} and {widest} degrees fits the stress around the wheel"
        )
    })
}
