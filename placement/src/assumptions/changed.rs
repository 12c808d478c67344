//! Assumptions with their changed values.

use fem_client::scene::Scene;

use documents::layouts::layout_settings::Layouts;
use documents::parts::film_model::FilmModel;
use layouts::field::film_field::Noise;

/// An assumption with its changed value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Changed {
    /// Noise, so many times as large.
    Noise(f64),
    /// Drift beside the noise, over the crown's largest signal.
    Drift(f64),
    /// Standard deviation of the gains.
    Gain(f64),
    /// Standard deviation of the places around the wheel, degrees.
    Place(f64),
    /// Pressure, so many times as large.
    Pressure(f64),
    /// Inclination of the wheel, degrees.
    Camber(f64),
    /// Friction of the ground, with that of the scene.
    Friction(f64, f64),
    /// Model of the films.
    Film(FilmModel),
}

impl Changed {
    /// Changes of what a study's readings are off by, that change something.
    pub fn of_readings(settings: &Layouts) -> Vec<Self> {
        let (changed, own) = (&settings.assumptions, &settings.noise);
        let more = |changed: f64, own: f64| if changed > own { changed } else { 2.0 * own };
        let gain = more(changed.gain_std, own.gain_std);
        let place = more(changed.place_std_deg, own.place_std_deg);
        let all = [
            (changed.noise_factor != 1.0).then_some(Self::Noise(changed.noise_factor)),
            (changed.drift_share > 0.0).then_some(Self::Drift(changed.drift_share)),
            (gain > 0.0).then_some(Self::Gain(gain)),
            (place > 0.0).then_some(Self::Place(place)),
        ];
        all.into_iter().flatten().collect()
    }

    /// Changes of a scene that a study asks for, that change something.
    pub fn of_scene(settings: &Layouts, scene: &Scene) -> Vec<Self> {
        let changed = &settings.assumptions;
        let (camber, friction) = (scene.ground.camber_deg, scene.contact.friction);
        let pressure = changed.pressure_factor.filter(|factor| *factor != 1.0);
        let other = |changed: Option<f64>, own: f64| changed.filter(|value| *value != own);
        let all = [
            pressure.map(Self::Pressure),
            other(changed.camber_deg, camber).map(Self::Camber),
            other(changed.friction, friction).map(|value| Self::Friction(value, friction)),
        ];
        all.into_iter().flatten().collect()
    }

    /// Change of the films that a study asks for, where these aren't such ones.
    pub fn of_films(settings: &Layouts) -> Option<Self> {
        let asked = settings.assumptions.film;
        let other = asked.filter(|model| *model != settings.model());
        other.map(Self::Film)
    }

    /// Name of the assumption.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Noise(_) => "noise",
            Self::Drift(_) => "drift",
            Self::Gain(_) => "gain",
            Self::Place(_) => "place",
            Self::Pressure(_) => "pressure",
            Self::Camber(_) => "camber",
            Self::Friction(..) => "friction",
            Self::Film(_) => "film",
        }
    }

    /// Change in words, as they follow `with`.
    pub fn words(&self) -> String {
        let percent = |share: f64| {
            let text = format!("{:.3}", 100.0 * share);
            format!("{} %", text.trim_end_matches('0').trim_end_matches('.'))
        };
        match self {
            Self::Noise(2.0) => "twice the noise".to_owned(),
            Self::Noise(factor) => format!("{factor} times the noise"),
            Self::Drift(share) => format!("a drift of {} beside the noise", percent(*share)),
            Self::Gain(std) => format!("gains that differ by {}", percent(*std)),
            Self::Place(std) => format!("films glued {std} degrees off"),
            Self::Pressure(factor) if *factor < 1.0 => {
                format!("a pressure {} lower", percent(1.0 - factor))
            }
            Self::Pressure(factor) => format!("a pressure {} higher", percent(factor - 1.0)),
            Self::Camber(camber) => format!("a wheel that leans by {camber} degrees"),
            Self::Friction(value, own) => format!("a friction of {value} in place of {own}"),
            Self::Film(FilmModel::Bare) => "films that resist nothing".to_owned(),
            Self::Film(FilmModel::Transfer) => "glued films, by their transfer alone".to_owned(),
            Self::Film(FilmModel::Coupled) => "films glued on, with their stiffness".to_owned(),
        }
    }

    /// Errors of readings as changed; the crown's largest signal is this.
    pub fn noise(&self, own: Noise, crown: f64) -> Noise {
        match self {
            Self::Noise(factor) => Noise {
                floor: factor * own.floor,
                ..own
            },
            Self::Drift(share) => Noise {
                floor: own.floor.hypot(share * crown),
                ..own
            },
            Self::Gain(gain_std) => Noise {
                gain_std: *gain_std,
                ..own
            },
            Self::Place(place_std_deg) => Noise {
                place_std_deg: *place_std_deg,
                ..own
            },
            Self::Pressure(_) | Self::Camber(_) | Self::Friction(..) | Self::Film(_) => own,
        }
    }

    /// Changes a scene.
    pub fn change(&self, scene: &mut Scene) {
        match self {
            Self::Pressure(factor) => scene.pressure.internal_mpa *= factor,
            Self::Camber(camber) => scene.ground.camber_deg = *camber,
            Self::Friction(value, _) => scene.contact.friction = *value,
            Self::Noise(_) | Self::Drift(_) | Self::Gain(_) | Self::Place(_) | Self::Film(_) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use documents::layouts::assumptions::Assumptions;

    use super::*;

    #[test]
    fn what_changes_nothing_is_left_out_and_what_is_assumed_already_is_doubled() {
        let mut settings = Layouts::default();
        let usual = Changed::of_readings(&settings);
        let expected = [
            Changed::Noise(2.0),
            Changed::Drift(0.02),
            Changed::Gain(0.1),
            Changed::Place(2.0),
        ];
        assert_eq!(usual, expected);
        settings.assumptions = Assumptions {
            noise_factor: 1.0,
            drift_share: 0.0,
            pressure_factor: Some(0.9),
            camber_deg: Some(0.0),
            friction: Some(0.5),
            film: Some(FilmModel::Bare),
            ..Assumptions::default()
        };
        settings.noise.gain_std = 0.2;
        let changed = Changed::of_readings(&settings);
        assert_eq!(changed, [Changed::Gain(0.4), Changed::Place(2.0)]);
        assert_eq!(Changed::of_films(&settings), None);
        let of_scene = Changed::of_scene(&settings, &Scene::default());
        assert_eq!(
            of_scene,
            [Changed::Pressure(0.9), Changed::Friction(0.5, 0.0)]
        );
    }

    #[test]
    fn changes_are_told_in_words() {
        let told = [
            (Changed::Noise(2.0), "twice the noise"),
            (Changed::Noise(0.5), "0.5 times the noise"),
            (Changed::Drift(0.02), "a drift of 2 % beside the noise"),
            (Changed::Gain(0.125), "gains that differ by 12.5 %"),
            (Changed::Place(2.0), "films glued 2 degrees off"),
            (Changed::Pressure(0.9), "a pressure 10 % lower"),
            (Changed::Pressure(1.05), "a pressure 5 % higher"),
            (Changed::Camber(5.0), "a wheel that leans by 5 degrees"),
            (
                Changed::Friction(0.5, 0.0),
                "a friction of 0.5 in place of 0",
            ),
            (
                Changed::Film(FilmModel::Coupled),
                "films glued on, with their stiffness",
            ),
        ];
        for (changed, words) in told {
            assert_eq!(changed.words(), words);
        }
    }
}
