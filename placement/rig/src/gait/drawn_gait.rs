//! The stances of a run, and the contact at the instants of a clock.

use crate::contact_response::{Contact, ContactResponse, DrawnFor};
use crate::even_clock::EvenClock;
use crate::gait::stance::Stance;
use crate::seeded_draws::{SeededDraws, Stream};
use documents::rig::gait_settings::{Frequency, GaitSettings, RunLength};

/// The stances of one run, each turn after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct Gait {
    /// Stances in the order of time; the first begins at 0 s.
    pub stances: Vec<Stance>,
    /// Time at which the run ends, s.
    pub end_s: f64,
}

impl Gait {
    /// Draws a run on this tire, by its seed and number. The wheel turns to the next contact angle between two stances, in the air.
    pub fn drawn<R: ContactResponse + ?Sized>(
        settings: &GaitSettings,
        response: &R,
        (seed, run): (u64, u64),
    ) -> Self {
        let mut draws = SeededDraws::new(seed, run, Stream::Gait);
        let mut of_contact = SeededDraws::new(seed, run, Stream::Contact);
        let differing = response.differing().iter();
        let of_run: Vec<f64> = differing.map(|_| of_contact.uniform()).collect();
        let mut stances: Vec<Stance> = Vec::new();
        let mut begin_s = 0.0;
        let wanted = |number, begin_s| match settings.length {
            RunLength::Stances(stances) => number < stances,
            RunLength::Seconds(seconds) => begin_s < seconds,
        };
        while wanted(stances.len(), begin_s) {
            let stance = drawn_stance(settings, response, stances.len(), begin_s, &mut draws);
            begin_s = stance.end_s();
            let shares = response.differing().iter().zip(&of_run);
            let shares = shares.map(|(drawn_for, of_run)| match drawn_for {
                DrawnFor::Stance => of_contact.uniform(),
                DrawnFor::Run => *of_run,
            });
            stances.push(Stance {
                shares: shares.collect(),
                ..stance
            });
        }
        let end_s = match settings.length {
            RunLength::Stances(_) => begin_s,
            RunLength::Seconds(seconds) => seconds,
        };
        Self { stances, end_s }
    }

    /// The contact at each instant of a clock until the run ends, with the stance that it belongs to.
    pub fn contacts<'g, R: ContactResponse + ?Sized>(
        &'g self,
        clock: EvenClock,
        response: &'g R,
    ) -> impl Iterator<Item = (f64, &'g Stance, Contact)> {
        let mut at = 0;
        let times = clock.times_s().take_while(|time_s| *time_s < self.end_s);
        times.filter_map(move |time_s| {
            let ended = |stance: &Stance| stance.end_s() <= time_s;
            while at + 1 < self.stances.len() && ended(&self.stances[at]) {
                at += 1;
            }
            let stance = self.stances.get(at)?;
            Some((time_s, stance, stance.contact(time_s, response)))
        })
    }
}

fn drawn_stance<R: ContactResponse + ?Sized>(
    settings: &GaitSettings,
    response: &R,
    number: usize,
    begin_s: f64,
    draws: &mut SeededDraws,
) -> Stance {
    let hz = match settings.frequency {
        Frequency::Fixed { hz } => hz,
        Frequency::Randomised { min_hz, max_hz } => draws.between([min_hz, max_hz]),
        Frequency::Transition { from_hz, to_hz } => {
            from_hz + (to_hz - from_hz) * progress(settings.length, number, begin_s)
        }
    };
    let contact_deg = draws.between(settings.contact_deg);
    let load_n = draws.between(settings.load_n);
    // Both ends of the line of shares lie in the disc of friction, so the line does.
    let mut shares = || draws.in_disc().map(|share| settings.shear_share * share);
    Stance {
        number,
        begin_s,
        hz,
        duty: settings.duty,
        contact_deg,
        load_n,
        peak_mm: response.depth_of_load_mm(load_n),
        shear: [shares(), shares()],
        shares: Vec::new(),
    }
}

/// Returns how much of a run is over when a stance begins, from 0 to 1.
fn progress(length: RunLength, number: usize, begin_s: f64) -> f64 {
    match length {
        RunLength::Stances(stances) => number as f64 / stances.saturating_sub(1).max(1) as f64,
        RunLength::Seconds(seconds) => begin_s / seconds,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bump_response::BumpResponse;
    use crate::contact_response::StanceResponse;

    fn gait(settings: &GaitSettings, seed: u64, run: u64) -> Gait {
        Gait::drawn(settings, &BumpResponse::new(6), (seed, run))
    }

    fn of_stances(frequency: Frequency, stances: usize) -> GaitSettings {
        GaitSettings {
            frequency,
            length: RunLength::Stances(stances),
            ..GaitSettings::default()
        }
    }

    #[test]
    fn frequencies_are_as_asked() {
        let hz = |frequency| {
            let gait = gait(&of_stances(frequency, 5), 1, 0);
            gait.stances
                .iter()
                .map(|stance| stance.hz)
                .collect::<Vec<_>>()
        };
        assert_eq!(hz(Frequency::Fixed { hz: 2.0 }), [2.0; 5]);
        assert_eq!(
            hz(Frequency::Transition {
                from_hz: 1.0,
                to_hz: 5.0
            }),
            [1.0, 2.0, 3.0, 4.0, 5.0]
        );
        let drawn = hz(Frequency::Randomised {
            min_hz: 1.0,
            max_hz: 5.0,
        });
        assert!(drawn.iter().all(|hz| (1.0..=5.0).contains(hz)), "{drawn:?}");
        assert!(drawn.windows(2).all(|pair| pair[0] != pair[1]));
    }

    #[test]
    fn a_run_of_seconds_cuts_its_last_stance() {
        let settings = GaitSettings {
            frequency: Frequency::Fixed { hz: 0.8 },
            length: RunLength::Seconds(3.0),
            ..GaitSettings::default()
        };
        let gait = gait(&settings, 1, 0);
        assert_eq!((gait.stances.len(), gait.end_s), (3, 3.0));
        let clock = EvenClock::new(0.0, 200.0);
        let tire = BumpResponse::new(6);
        let numbers: Vec<usize> = gait
            .contacts(clock, &tire)
            .map(|(_, stance, _)| stance.number)
            .collect();
        // 1.25 s a turn, of 250 instants.
        let of = |number| numbers.iter().filter(|n| **n == number).count();
        assert_eq!([0, 1, 2].map(of), [250, 250, 100]);
        assert!(numbers.is_sorted());
    }

    #[test]
    fn a_seed_and_a_run_say_all_stances() {
        let settings = of_stances(
            Frequency::Randomised {
                min_hz: 1.0,
                max_hz: 5.0,
            },
            20,
        );
        assert_eq!(gait(&settings, 1, 0), gait(&settings, 1, 0));
        let first = gait(&settings, 1, 0);
        for other in [gait(&settings, 2, 0), gait(&settings, 1, 1)] {
            for (a, b) in first.stances.iter().zip(&other.stances) {
                assert!(a.load_n != b.load_n && a.contact_deg != b.contact_deg);
            }
        }
    }

    /// Shares that a stance has to itself change from one to the next, those of a run don't; the stances are those of contacts that are alike.
    #[test]
    fn contacts_differ_by_stance_or_by_run() {
        let settings = of_stances(Frequency::Fixed { hz: 2.0 }, 50);
        let tire = BumpResponse::new(6).of_many(&[DrawnFor::Stance, DrawnFor::Run]);
        let [first, second] = [0, 1].map(|run| Gait::drawn(&settings, &tire, (1, run)));
        let shares = |gait: &Gait, number: usize| -> Vec<f64> {
            gait.stances
                .iter()
                .map(|stance| stance.shares[number])
                .collect()
        };
        let of_stance = shares(&first, 0);
        assert!(of_stance.windows(2).all(|pair| pair[0] != pair[1]));
        let [least, most] = [f64::min, f64::max].map(|of| of_stance.iter().copied().reduce(of));
        // Of 50 even draws none lies below a tenth with a chance of 0.005.
        assert!(least < Some(0.1) && most > Some(0.9));
        let of_run = shares(&first, 1);
        assert!(of_run.iter().all(|share| *share == of_run[0]));
        assert_ne!(of_run[0], shares(&second, 1)[0]);
        let alike = gait(&settings, 1, 0);
        for (own, other) in alike.stances.iter().zip(first.stances) {
            assert!(own.shares.is_empty());
            assert_eq!(
                *own,
                Stance {
                    shares: Vec::new(),
                    ..other
                }
            );
        }
    }

    #[test]
    fn stances_fill_their_ranges_and_stay_in_the_disc_of_friction() {
        const STANCES: usize = 4000;
        let settings = of_stances(Frequency::Fixed { hz: 2.0 }, STANCES);
        let gait = gait(&settings, 5, 0);
        let mean = |of: fn(&Stance) -> f64| {
            gait.stances.iter().map(of).sum::<f64>() / gait.stances.len() as f64
        };
        // Even on [0, 30]: standard deviation 30 / sqrt(12) = 8.66, of a mean of 4000 0.137; within 3 of it.
        for found in [
            mean(|stance| stance.load_n),
            mean(|stance| stance.contact_deg),
        ] {
            assert!((found - 15.0).abs() < 0.41, "{found}");
        }
        for stance in &gait.stances {
            assert!((0.0..=30.0).contains(&stance.load_n));
            for [along, across] in stance.shear {
                assert!(along.hypot(across) <= 0.6 * (1.0 + 1e-12));
            }
        }
    }

    /// Forces along and across at the deepest point, against the vertical one: without a correlation, r sqrt(n) is standard normal for many stances.
    #[test]
    fn forces_along_and_across_do_not_follow_from_the_vertical_one() {
        const STANCES: usize = 4000;
        let tire = BumpResponse::new(6);
        let gait = gait(&of_stances(Frequency::Fixed { hz: 2.0 }, STANCES), 3, 0);
        for turn in [0.3, 0.5, 0.7] {
            let forces: Vec<[f64; 3]> = gait
                .stances
                .iter()
                .map(|stance| {
                    let contact = stance.contact(stance.begin_s + turn / stance.hz, &tire);
                    tire.stance(stance.contact_deg).answer(&contact, &mut [])
                })
                .collect();
            for (a, b) in [(0, 2), (1, 2), (0, 1)] {
                let r = correlation(&forces, a, b);
                // Three standard errors of a product of factors that aren't normal: the variance is <x^2 y^2> / (<x^2> <y^2>) / n, which for a load F even on
                // its range and shares s independent of it is 1.2 for s F against F - <F>, and below (1/5) / (1/3)^2 = 1.8 for s F against s' F.
                let bound = 3.0 * (1.8 / STANCES as f64).sqrt();
                assert!(r.abs() < bound, "{turn} {a} {b}: {r}");
            }
        }
    }

    fn correlation(rows: &[[f64; 3]], a: usize, b: usize) -> f64 {
        let n = rows.len() as f64;
        let mean = |k: usize| rows.iter().map(|row| row[k]).sum::<f64>() / n;
        let (ma, mb) = (mean(a), mean(b));
        let of = |j: usize, mj: f64, k: usize, mk: f64| {
            rows.iter()
                .map(|row| (row[j] - mj) * (row[k] - mk))
                .sum::<f64>()
        };
        of(a, ma, b, mb) / (of(a, ma, a, ma) * of(b, mb, b, mb)).sqrt()
    }
}
