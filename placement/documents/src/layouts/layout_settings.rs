//! Settings of a study's layouts.

use fem_client::scene::{Film, Geometry, Level};
use fem_client::solver::Position;
use fem_client::solver::direction::Direction;
use serde_json::{Map, Value, json};

use crate::layouts::assumptions::Assumptions;
use crate::layouts::contact_laws::Contacts;
use crate::layouts::film_room::FilmRoom;
use crate::layouts::gluing_limits::GluingLimits;
use crate::parts::directions::Directions;
use crate::parts::film_model::FilmModel;
use crate::parts::film_place::FilmPlace;

/// Unit of films that follow the wall and resist nothing.
pub const STRAIN_UNIT: &str = "strain";
/// Unit of glued films' signals.
pub const VOLT_UNIT: &str = "V";
/// Reach of the solved depths beyond the least and the largest load, over these.
pub const BEYOND: [f64; 2] = [0.5, 1.25];
/// Number of loads below which contacts as they come are solved at both of these ends, too.
pub const FEW_LOADS: usize = 3;
/// Numbers of films of the common menu, 3 to 48: those that divide a turn into angles that can be marked by hand.
const COMMON_FILMS: [usize; 14] = [3, 4, 6, 8, 9, 10, 12, 15, 18, 20, 24, 30, 36, 48];
/// Share of the crown's largest strain that a film's noise has unless the study says otherwise.
pub(crate) const NOISE_SHARE: f64 = 0.02;

/// The `[layouts]` of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Layouts {
    /// Numbers of films of the menu: each is laid along every direction, and as all directions in one place or in turn.
    pub films: Vec<usize>,
    /// Angles between neighbouring units, degrees; each divides 360.
    pub spacings_deg: Vec<f64>,
    /// Numbers of units, beside those of the spacings.
    pub units: Vec<usize>,
    /// Meridional positions of the units.
    pub positions: Vec<Position>,
    /// Section angles of the units beside the positions', degrees.
    pub section_deg: Vec<f64>,
    /// Directions of the films of a unit, degrees to the circumference; none: those that the study asks for.
    pub directions: Vec<Vec<f64>>,
    /// Whether units of several films are scored with their films spread between the units, too.
    pub staggered: bool,
    /// Layouts film by film.
    pub free: Vec<FreeLayout>,
    /// Limits to where films can be glued.
    pub limits: GluingLimits,
    /// Length and width of all films, mm; none: they are points.
    pub size_mm: Option<[f64; 2]>,
    /// Further lengths and widths of the candidates, mm.
    pub candidate_sizes_mm: Vec<[f64; 2]>,
    /// The film that is glued on, wherever it is placed; none: films follow the wall and resist nothing.
    pub glued: Option<GluedFilm>,
    /// Loads; none: the study's mean depth, or its load.
    pub loads: LayoutLoads,
    /// Errors of a film's reading.
    pub noise: NoiseSettings,
    /// Whether every single film is taken out.
    pub dead: bool,
    /// Whether forces along and across the wheel are unknown, too.
    pub shear: bool,
    /// Contacts as they come; without a law all are as in the scene.
    pub contacts: Contacts,
    /// Values to which what the figures rest on is changed.
    pub assumptions: Assumptions,
    /// Mesh level; none: the study's own, the standard at most.
    pub level: Option<Level>,
    /// Search for the best layouts.
    pub search: Option<SearchSettings>,
}

/// A film that is glued on.
#[derive(Debug, Clone, PartialEq)]
pub struct GluedFilm {
    /// The film.
    pub film: Film,
    /// Whether it is solved with the tire around the wheel; else its transfer is all that is known of it.
    pub is_coupled: bool,
}

impl GluedFilm {
    fn model(&self) -> FilmModel {
        match self.is_coupled {
            true => FilmModel::Coupled,
            false => FilmModel::Transfer,
        }
    }
}

/// A layout film by film.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeLayout {
    /// Name of the layout.
    pub name: String,
    /// Films of the layout.
    pub films: Vec<FilmPlace>,
}

/// Loads at which layouts are scored.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum LayoutLoads {
    /// The study's own.
    #[default]
    Mean,
    /// Depths of a flat ground, mm.
    Depths(Vec<f64>),
    /// Forces of a flat ground, N.
    Forces(Vec<f64>),
}

/// Errors of a film's reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoiseSettings {
    /// Standard deviation, strain, or a share of the crown's largest strain at the mean load.
    pub floor: NoiseFloor,
    /// Standard deviation of the gain, relative.
    pub gain_std: f64,
    /// Standard deviation of the film's place around the wheel, degrees.
    pub place_std_deg: f64,
}

/// Standard deviation of a reading whatever its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoiseFloor {
    /// Share of the crown's largest signal at the load in the middle.
    Share(f64),
    /// Noise in strain.
    Strain(f64),
    /// Noise in volts, of glued films.
    Volts(f64),
}

impl Default for NoiseSettings {
    fn default() -> Self {
        Self {
            floor: NoiseFloor::Share(NOISE_SHARE),
            gain_std: 0.0,
            place_std_deg: 0.0,
        }
    }
}

/// Layouts to search for.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchSettings {
    /// Numbers of films.
    pub films: Vec<usize>,
    /// Places around the wheel.
    pub slots: usize,
    /// Section angles, degrees.
    pub section_deg: Vec<f64>,
    /// Directions, degrees to the circumference.
    pub directions: Vec<f64>,
    /// Limits to where films can be glued, besides those of all layouts.
    pub limits: GluingLimits,
}

impl SearchSettings {
    /// The table as in a document, every default filled in that this search uses.
    fn to_value(&self) -> Value {
        let mut table = Map::new();
        let mut put = |name: &str, value: Value| {
            table.insert(name.to_owned(), value);
        };
        put("films", json!(self.films));
        put("slots", self.slots.into());
        put("section_deg", json!(self.section_deg));
        let directions = self.directions.iter().map(|angle| direction_value(*angle));
        put("directions", directions.collect());
        self.limits.write("fixed", &mut put);
        Value::Object(table)
    }
}

impl Default for Layouts {
    fn default() -> Self {
        Self {
            films: COMMON_FILMS.to_vec(),
            spacings_deg: Vec::new(),
            units: Vec::new(),
            positions: vec![Position::Crown, Position::Shoulder, Position::Sidewall],
            section_deg: Vec::new(),
            directions: Vec::new(),
            staggered: false,
            free: Vec::new(),
            limits: GluingLimits::default(),
            size_mm: None,
            candidate_sizes_mm: Vec::new(),
            glued: None,
            loads: LayoutLoads::Mean,
            noise: NoiseSettings::default(),
            dead: false,
            shear: false,
            contacts: Contacts::default(),
            assumptions: Assumptions::default(),
            level: None,
            search: None,
        }
    }
}

impl Layouts {
    /// Asks for no layouts.
    pub fn none() -> Self {
        Self {
            films: Vec::new(),
            positions: Vec::new(),
            ..Self::default()
        }
    }

    /// Whether there is a layout to score or to search for.
    pub fn is_asked(&self) -> bool {
        let is_counted = !self.films.is_empty() || !self.unit_counts().is_empty();
        let regular = is_counted && !self.sections_deg().is_empty();
        regular || !self.free.is_empty() || self.search.is_some()
    }

    /// Limits of the search: its own, and those of all layouts.
    pub fn search_limits(&self) -> GluingLimits {
        match &self.search {
            Some(search) => self.limits.with(&search.limits),
            None => self.limits.clone(),
        }
    }

    /// Model of its films.
    pub fn model(&self) -> FilmModel {
        match &self.glued {
            Some(glued) => glued.model(),
            None => FilmModel::Bare,
        }
    }

    /// Makes the same with films of another model: glued ones are this film.
    pub fn with_films(&self, model: FilmModel, film: Film) -> Self {
        let own = self.clone();
        if model == FilmModel::Bare {
            return Self { glued: None, ..own };
        }
        Self {
            size_mm: Some([film.length_mm, film.width_mm]),
            candidate_sizes_mm: Vec::new(),
            glued: Some(GluedFilm {
                film,
                is_coupled: model == FilmModel::Coupled,
            }),
            ..own
        }
    }

    /// Room that its films need on a tire.
    pub fn room(&self, geometry: &Geometry) -> FilmRoom {
        FilmRoom::on(geometry, self.size_mm, self.limits.least_distance_mm)
    }

    /// Numbers of units, in the order of the document, each once.
    pub(crate) fn unit_counts(&self) -> Vec<usize> {
        let of_spacings = self.spacings_deg.iter().map(|spacing| units_of(*spacing));
        once_each(of_spacings.chain(self.units.iter().copied()))
    }

    /// Section angles, degrees, those of the positions first, each once.
    pub fn sections_deg(&self) -> Vec<f64> {
        let of_positions = self.positions.iter().map(|position| position.angle_deg());
        once_each(of_positions.chain(self.section_deg.iter().copied()))
    }

    /// Directions of the films of a unit, degrees.
    pub fn sets(&self, asked: Directions) -> Vec<Vec<f64>> {
        match self.directions.as_slice() {
            [] => vec![
                asked
                    .asked()
                    .iter()
                    .map(|direction| direction_deg(*direction))
                    .collect(),
            ],
            sets => sets.to_vec(),
        }
    }

    /// Numbers of films of the layouts that it names or offers, those of a search apart.
    pub(crate) fn film_counts(&self, asked: Directions) -> Vec<usize> {
        let of_rings = self.rings(asked).into_iter().map(|ring| ring.films());
        let of_free = self.free.iter().map(|layout| layout.films.len());
        of_rings.chain(of_free).collect()
    }

    /// Unit of its films' signals.
    pub fn unit(&self) -> &'static str {
        match self.glued {
            Some(_) => VOLT_UNIT,
            None => STRAIN_UNIT,
        }
    }

    /// Mesh level for a study on this one.
    pub fn level_on(&self, study: Level) -> Level {
        self.level.unwrap_or(study.min(Level::Standard))
    }

    /// The table as in a document, every default filled in that this study uses.
    pub fn to_value(&self) -> Value {
        let mut table = Map::new();
        let mut put = |name: &str, value: Value| {
            table.insert(name.to_owned(), value);
        };
        if !self.films.is_empty() {
            put("films", json!(self.films));
        }
        put("spacings_deg", json!(self.spacings_deg));
        put("positions", json!(self.positions));
        if !self.units.is_empty() {
            put("units", json!(self.units));
        }
        if !self.section_deg.is_empty() {
            put("section_deg", json!(self.section_deg));
        }
        if !self.directions.is_empty() {
            let sets = self.directions.iter().map(|set| {
                set.iter()
                    .map(|angle| direction_value(*angle))
                    .collect::<Value>()
            });
            put("directions", sets.collect());
        }
        if self.staggered {
            put("staggered", true.into());
        }
        if !self.free.is_empty() {
            let free = self
                .free
                .iter()
                .map(|layout| json!({"name": layout.name, "films": layout.films}));
            put("free", free.collect());
        }
        self.limits.write("taken", &mut put);
        if let Some(glued) = &self.glued {
            put("film", glued.model().as_str().into());
        }
        if let Some(size) = self.size_mm {
            put("size_mm", json!(size));
        }
        if !self.candidate_sizes_mm.is_empty() {
            put("candidate_sizes_mm", json!(self.candidate_sizes_mm));
        }
        match &self.loads {
            LayoutLoads::Mean => {}
            LayoutLoads::Depths(depths) => put("depths_mm", json!(depths)),
            LayoutLoads::Forces(loads) => put("loads_n", json!(loads)),
        };
        match self.noise.floor {
            NoiseFloor::Share(NOISE_SHARE) => {}
            NoiseFloor::Share(share) => put("noise_share", share.into()),
            NoiseFloor::Strain(strain) => put("noise_strain", strain.into()),
            NoiseFloor::Volts(volts) => put("noise_v", volts.into()),
        };
        if self.noise.gain_std > 0.0 {
            put("gain_std", self.noise.gain_std.into());
        }
        if self.noise.place_std_deg > 0.0 {
            put("place_std_deg", self.noise.place_std_deg.into());
        }
        if self.dead {
            put("dead", true.into());
        }
        if self.shear {
            put("shear", true.into());
        }
        if !self.contacts.laws.is_empty() {
            put("contacts", self.contacts.to_value());
        }
        if self.assumptions != Assumptions::default() {
            put("assumptions", self.assumptions.to_value());
        }
        if let Some(level) = self.level {
            put("level", level.as_str().into());
        }
        if let Some(search) = &self.search {
            put("search", search.to_value());
        }
        Value::Object(table)
    }
}

/// Units around the wheel at this spacing, degrees.
pub(crate) fn units_of(spacing_deg: f64) -> usize {
    (360.0 / spacing_deg).round() as usize
}

/// The section angle up to which films are laid, degrees: a wall's thickness off the bead, where the clamp makes strains of its own.
pub fn farthest_section_deg(geometry: &Geometry) -> f64 {
    let inner = geometry.section_radius_mm - geometry.wall_mm;
    (geometry.bead_angle_deg - (geometry.wall_mm / inner).to_degrees()).max(0.0)
}

/// Angle to the circumference, degrees.
pub(crate) fn direction_deg(direction: Direction) -> f64 {
    match direction {
        Direction::X => 0.0,
        Direction::Y => 90.0,
    }
}

/// `x`, `y`, or an angle in degrees.
pub fn direction_name(angle_deg: f64) -> String {
    match angle_deg {
        0.0 => "x".to_owned(),
        90.0 => "y".to_owned(),
        angle => format!("{angle}"),
    }
}

/// Writes a direction as in a document: `"x"`, `"y"`, or a number.
fn direction_value(angle_deg: f64) -> Value {
    match angle_deg {
        0.0 => "x".into(),
        90.0 => "y".into(),
        angle => angle.into(),
    }
}

/// The position's name, or the angle.
pub fn section_name(section_deg: f64) -> String {
    let of_angle = Position::ALL
        .into_iter()
        .find(|position| position.angle_deg() == section_deg);
    of_angle.map_or_else(
        || format!("{section_deg} deg"),
        |position| position.as_str().to_owned(),
    )
}

/// The angle of a direction's name, degrees.
pub fn direction_of(name: &str) -> Option<f64> {
    match name {
        "x" => Some(0.0),
        "y" => Some(90.0),
        angle => angle.parse().ok(),
    }
}

/// The section angle of its name, degrees; `None` of several.
pub fn section_of(name: &str) -> Option<f64> {
    let mut positions = Position::ALL.into_iter();
    match positions.find(|position| position.as_str() == name) {
        Some(position) => Some(position.angle_deg()),
        None => name.strip_suffix(" deg")?.parse().ok(),
    }
}

fn once_each<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    let mut kept = Vec::new();
    for item in items {
        if !kept.contains(&item) {
            kept.push(item);
        }
    }
    kept
}
