//! All three forces of a layout.

use std::sync::atomic::{AtomicBool, Ordering};

use estimation::recipe::{FeatureSet, Kind};

use crate::result::film::force_error::{AskewError, ForceError, TrialError};
use crate::rig::contact_response::TurnableFilms;
use crate::rig::force_error::fresh_trials::FreshTrials;
use crate::rig::force_error::learnt_force::{LearntForce, Unlearnt, labelled, learnt, recipe};
use crate::rig::force_error::thinned_run::{ThinnedRun, thinning};
use crate::rig::rig_settings::RigSettings;

/// Names of the forces, in the order of a contact's.
const AXES: [&str; 3] = ["fx", "fy", "fz"];

/// How well a layout's films tell the forces along, across and vertical; None where the caller stops meanwhile. The same films and settings give the same bits.
pub fn force_errors<R: TurnableFilms>(
    response: &R,
    settings: &RigSettings,
    stop: &AtomicBool,
) -> Option<Vec<ForceError>> {
    let one_of = thinning(settings);
    let mut runs = Vec::new();
    for run in 0..settings.runs {
        if stop.load(Ordering::Relaxed) {
            return None;
        }
        runs.push(ThinnedRun::recorded(response, settings, run as u64, one_of));
    }
    let trials = FreshTrials::recorded(response, settings, one_of);
    let recipe = recipe(response, settings);
    let mut found = Vec::new();
    for (axis, name) in AXES.into_iter().enumerate() {
        let rows = labelled(&runs, axis);
        match learnt(&rows, &recipe, settings.film_rate_hz.recip(), stop) {
            Ok(learnt) => found.push(tried(name, axis, learnt, &trials)),
            Err(Unlearnt::Reason(reason)) => found.push(unknown(name, reason)),
            Err(Unlearnt::Stopped) => return None,
        }
    }
    Some(found)
}

fn tried(name: &str, axis: usize, learnt: LearntForce, trials: &FreshTrials) -> ForceError {
    let (fresh, worst_contact) = trials.fresh(&learnt.model, axis);
    ForceError {
        axis: name.to_owned(),
        chosen: learnt.chosen.kind,
        features: learnt.chosen.features,
        useful: learnt.chosen.kind != Kind::Mean,
        splits: learnt.splits,
        leak: learnt.leak,
        fresh,
        dead: trials.dead(&learnt.model, axis),
        askew: trials.askew(&learnt.model, axis),
        worst_contact,
        reason: None,
    }
}

fn unknown(name: &str, reason: String) -> ForceError {
    ForceError {
        axis: name.to_owned(),
        chosen: Kind::Mean,
        features: FeatureSet::Raw,
        useful: false,
        splits: Vec::new(),
        leak: None,
        fresh: TrialError::default(),
        dead: None,
        askew: AskewError {
            std_deg: 0.0,
            error: TrialError::default(),
        },
        worst_contact: None,
        reason: Some(reason),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rig::bump_response::BumpResponse;

    #[test]
    #[ignore = "measures"]
    fn measured() {
        for films in [6, 12, 24] {
            let begun = std::time::Instant::now();
            let found = force_errors(
                &BumpResponse::new(films),
                &RigSettings::default(),
                &AtomicBool::new(false),
            );
            println!("{films}: {:.2} s", begun.elapsed().as_secs_f64());
            for f in found.unwrap() {
                println!(
                    "{} {:?} {:?} useful {} leak {:?}",
                    f.axis, f.chosen, f.features, f.useful, f.leak
                );
                for s in &f.splits {
                    println!(
                        "   {:?} rmse {:?} nrmse {:?} mean {:?} r2 {:?} cov {:?} w {:?} {:?}",
                        s.by,
                        s.rmse_n,
                        s.nrmse_percent,
                        s.mean_nrmse_percent,
                        s.r2,
                        s.coverage,
                        s.width_n,
                        s.reason
                    );
                }
                println!(
                    "   fresh {:?}\n   dead {:?}\n   askew {:?}\n   worst {:?}",
                    f.fresh, f.dead, f.askew, f.worst_contact
                );
            }
        }
    }
}
