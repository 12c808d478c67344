//! Assumptions on a rig, as sentences. The paper states none of it but the rate and the ranges of the gait.

use fem_client::film::amplifier::Circuit;

use crate::contact_response::DrawnFor;
use crate::force_error::thinned_run::NEIGHBOURS;
use documents::layouts::contact_laws::ContactLaw;
use documents::rig::gait_settings::{GaitSettings, RunLength};
use documents::rig::rig_settings::{Electronics, Noise, RigSettings};

/// Returns all that is assumed of a rig whose contacts differ by these laws, a sentence each.
pub fn assumed(settings: &RigSettings, contacts: &[ContactLaw]) -> Vec<String> {
    let mut sentences = vec![
        circuit(&settings.electronics),
        converter(&settings.electronics),
    ];
    sentences.extend(noise(&settings.noise));
    sentences.push(relaxation(settings));
    sentences.push(clock(settings));
    sentences.extend(gait(&settings.gait));
    sentences.push(ground(contacts));
    sentences.push(runs(settings));
    sentences.push(
        "Films and tire answer to each instant as to slow pressing: nothing has inertia, and the wheel turns in the air alone.".to_owned(),
    );
    sentences
}

/// A figure without the digits that rounding adds.
fn figure(x: f64) -> f64 {
    let digits = 1e9;
    (x * digits).round() / digits
}

fn percent(share: f64) -> f64 {
    figure(100.0 * share)
}

fn circuit(electronics: &Electronics) -> String {
    let wired = match electronics.circuit {
        Circuit::OpenCircuit => "Nothing draws charge from the films".to_owned(),
        Circuit::Voltage {
            input_mohm,
            cable_pf,
        } => format!(
            "Each film is wired to a voltage amplifier of {input_mohm} Mohm by a cable of {cable_pf} pF"
        ),
        Circuit::Charge {
            feedback_nf,
            feedback_mohm,
        } => format!(
            "Each film is wired to a charge amplifier with {feedback_nf} nF and {feedback_mohm} Mohm"
        ),
    };
    let own_s = match electronics.circuit {
        Circuit::Charge { .. } => electronics.circuit.held(0.0, 1.0).1,
        _ => None,
    };
    match (electronics.time_constant_s, own_s) {
        (Some(set_s), _) => format!(
            "{wired}; of a held charge 1/e is left after {} s, whatever its resistance.",
            figure(set_s)
        ),
        (None, Some(own_s)) => format!(
            "{wired}: of a held charge 1/e is left after {} s.",
            figure(own_s)
        ),
        (None, None) => format!("{wired}."),
    }
}

fn converter(electronics: &Electronics) -> String {
    let range = match electronics.range_v {
        Some(range_v) => format!("{} V", figure(range_v)),
        None => "twice each film's full scale".to_owned(),
    };
    match electronics.bits {
        0 => format!("The converter reads up to {range} and doesn't round."),
        bits => format!("The converter reads up to {range} with {bits} bits."),
    }
}

fn noise(noise: &Noise) -> [String; 3] {
    let Noise {
        white_share,
        thermal_k,
        drift_share,
        drift_time_s,
        warming_k_per_min,
        gain_std,
    } = *noise;
    [
        format!(
            "Each reading has white noise with a standard deviation of {} % of the film's full scale, and that of a resistance at {} K.",
            percent(white_share),
            figure(thermal_k)
        ),
        format!(
            "Readings drift with a standard deviation of {} % of full scale within some {} s, and films warm by {} K a minute.",
            percent(drift_share),
            figure(drift_time_s),
            figure(warming_k_per_min)
        ),
        format!(
            "Films' gains are drawn anew for each run, with a standard deviation of {} %.",
            percent(gain_std)
        ),
    ]
}

fn relaxation(settings: &RigSettings) -> String {
    let branches: Vec<String> = settings
        .relaxation
        .iter()
        .map(|branch| {
            format!(
                "{} % within {} s",
                percent(branch.share),
                figure(branch.time_s)
            )
        })
        .collect();
    if branches.is_empty() {
        return "The rubber doesn't relax.".to_owned();
    }
    let follow = match settings.films_follow_force {
        true => "and so do the films' charges",
        false => "but the films' charges follow the depth",
    };
    format!(
        "The rubber bears more at first and relaxes by {}, {follow}.",
        branches.join(" and ")
    )
}

fn clock(settings: &RigSettings) -> String {
    format!(
        "Films are read {} times a second; forces are learnt at the same instants, with noise of {} N: the two clocks are taken as one.",
        figure(settings.film_rate_hz),
        figure(settings.force_sensor.noise_n)
    )
}

fn gait(gait: &GaitSettings) -> [String; 2] {
    let [least_n, most_n] = gait.load_n.map(figure);
    let [from_deg, to_deg] = gait.contact_deg.map(figure);
    [
        format!(
            "Loads are drawn evenly from {least_n} to {most_n} N and contacts from {from_deg} to {to_deg} degrees for each stance, which takes {} % of a turn.",
            percent(gait.duty)
        ),
        format!(
            "Shear is drawn for each stance, up to {} % of the shift at which the contact slides, so that no force follows from another.",
            percent(gait.shear_share)
        ),
    ]
}

fn ground(contacts: &[ContactLaw]) -> String {
    let words = |span: DrawnFor| -> Vec<String> {
        let is_own = |law: &&ContactLaw| DrawnFor::of(law.quantity) == Some(span);
        let own = contacts.iter().filter(is_own);
        own.map(ContactLaw::described).collect()
    };
    let parts = [
        (words(DrawnFor::Stance), "stance"),
        (words(DrawnFor::Run), "run"),
    ];
    let drawn = parts.into_iter().filter(|(words, _)| !words.is_empty());
    let drawn: Vec<String> = drawn
        .map(|(words, each)| format!("{}, drawn for each {each}", words.join(" and ")))
        .collect();
    match drawn.is_empty() {
        true => "The wheel is upright, on flat ground.".to_owned(),
        false => format!(
            "Contacts have, as layouts.contacts says: {}; tractions are the shear's.",
            drawn.join("; ")
        ),
    }
}

fn runs(settings: &RigSettings) -> String {
    let length = match settings.gait.length {
        RunLength::Stances(stances) => format!("{stances} stances"),
        RunLength::Seconds(seconds) => format!("{} s", figure(seconds)),
    };
    let count = settings.runs;
    let runs = if count == 1 { "run" } else { "runs" };
    format!(
        "An estimator learns from {count} {runs} of {length}; its random split tests a fifth of the first {NEIGHBOURS} readings of the first run, whose neighbours it learns from."
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use documents::rig::rig_settings::Branch;

    #[test]
    fn a_default_rig_says_its_figures() {
        let all = assumed(&RigSettings::default(), &[]).join("\n");
        for part in [
            "a charge amplifier with 10 nF and 1000 Mohm: of a held charge 1/e is left after 10 s.",
            "twice each film's full scale with 12 bits",
            "1 % of the film's full scale, and that of a resistance at 293 K",
            "0.5 % of full scale within some 60 s, and films warm by 0.1 K",
            "standard deviation of 5 %",
            "relaxes by 10 % within 0.3 s, and so do",
            "200 times a second",
            "noise of 0.05 N",
            "from 0 to 30 N and contacts from 0 to 30 degrees for each stance, which takes 50 % of a turn",
            "up to 60 % of the shift",
            "4 runs of 60 s; its random split tests a fifth of the first 2000 readings",
        ] {
            assert!(all.contains(part), "{part} in\n{all}");
        }
        assert!(all.lines().all(|sentence| sentence.ends_with('.')), "{all}");
    }

    #[test]
    fn what_is_set_otherwise_is_said_otherwise() {
        let mut settings = RigSettings::default();
        settings.electronics.circuit = Circuit::of_name("voltage").expect("a circuit");
        settings.electronics.time_constant_s = Some(0.07);
        settings.electronics.bits = 0;
        settings.electronics.range_v = Some(5.0);
        settings.relaxation = vec![
            Branch {
                share: 0.07,
                time_s: 2.0
            };
            2
        ];
        settings.films_follow_force = false;
        settings.runs = 1;
        settings.gait.length = RunLength::Stances(40);
        let all = assumed(&settings, &[]).join("\n");
        for part in [
            "10 Mohm by a cable of 0 pF; of a held charge 1/e is left after 0.07 s",
            "up to 5 V and doesn't round",
            "7 % within 2 s and 7 % within 2 s, but the films' charges follow the depth",
            "1 run of 40 stances",
        ] {
            assert!(all.contains(part), "{part} in\n{all}");
        }
        settings.relaxation.clear();
        settings.electronics.circuit = Circuit::OpenCircuit;
        settings.electronics.time_constant_s = None;
        let all = assumed(&settings, &[]).join("\n");
        assert!(all.contains("The rubber doesn't relax.") && all.contains("from the films.\n"));
    }
}
