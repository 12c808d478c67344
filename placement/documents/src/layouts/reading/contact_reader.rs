//! Reads the laws of contacts: the table `layouts.contacts`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Choice;
use document::fault::{Fault, member};
use document::fields::{Fields, plain};
use fem_client::scene::Scene;

use crate::layouts::contact_laws::{
    CHECKS, CHECKS_WITHIN, ContactLaw, ContactQuantity, Contacts, SCATTER, Scatter,
};
use crate::layouts::layout_settings::{BEYOND, FEW_LOADS, LayoutLoads, Layouts};
use crate::layouts::reading::usual_contact::check_usual;
use crate::parts::distribution_reader::read_distribution;

/// Share of the friction up to which a contact may be dragged: beyond it most of it slides.
const OF_FRICTION: f64 = 0.8;
/// Share of a depth up to which a station may be lower.
const OF_DEPTH: f64 = 0.9;

/// Reads `[layouts.contacts]`; no law without the table.
pub(super) fn contacts(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Contacts {
    let usual = Contacts::default();
    let Some((value, pointer)) = fields.get("contacts") else {
        return usual;
    };
    let quantities = ContactQuantity::ALL.map(ContactQuantity::as_str);
    let known = [&quantities[..], &[SCATTER, CHECKS]].concat();
    let Some(table) = Fields::open(value, &pointer, &known, faults) else {
        return usual;
    };
    let mut law = |quantity: ContactQuantity| {
        let (value, at) = table.get(quantity.as_str())?;
        let law = read_distribution(value, &at, faults)?;
        let law = ContactLaw { quantity, law };
        check_range(&law, &at, faults).then_some(law)
    };
    let laws: Vec<ContactLaw> = ContactQuantity::ALL
        .into_iter()
        .filter_map(&mut law)
        .collect();
    if !quantities.into_iter().any(|name| table.get(name).is_some()) {
        let detail = format!("must have a law of {}; it has none", quantities.join(", "));
        Fault::add(faults, &pointer, detail);
    }
    let scatter = match table.get(SCATTER) {
        Some(_) => table.choice(SCATTER, Scatter::CHOICES, usual.scatter, faults),
        None => None,
    };
    let checks = table.integer(CHECKS, CHECKS_WITHIN, usual.checks.into(), faults);
    Contacts {
        laws,
        scatter: scatter.unwrap_or_default(),
        checks: checks
            .and_then(|checks| u32::try_from(checks).ok())
            .unwrap_or(usual.checks),
    }
}

fn check_range(law: &ContactLaw, at: &str, faults: &mut Vec<Fault>) -> bool {
    let range = law.quantity.range();
    let [low, high] = law.ends();
    if range.low <= low && low < high && high <= range.high {
        return true;
    }
    let detail = format!(
        "must stay {range}, but for a thousandth at either end; it reaches from {} to {}",
        plain(low),
        plain(high)
    );
    Fault::add(faults, at, detail);
    false
}

/// Checks that contacts of this scene can be as the laws say.
pub(super) fn check_contacts(
    layouts: &Layouts,
    fields: &Fields<'_>,
    scene: Option<&Scene>,
    faults: &mut Vec<Fault>,
) {
    if layouts.contacts.laws.is_empty() {
        return;
    }
    let pointer = fields.at("contacts");
    let mean_is_force = scene.is_some_and(|scene| scene.ground.load_n.is_some());
    let by_force = match &layouts.loads {
        LayoutLoads::Forces(_) => true,
        LayoutLoads::Depths(_) => false,
        LayoutLoads::Mean => mean_is_force,
    };
    if by_force {
        let detail = "are judged at depths: give layouts.depths_mm";
        Fault::add(faults, &pointer, detail);
    }
    if layouts.shear {
        let detail =
            "and layouts.shear are two models of forces along the ground: give one of them";
        Fault::add(faults, &pointer, detail);
    }
    let Some(scene) = scene else {
        return;
    };
    check_usual(scene, &pointer, "are", faults);
    let has = |quantity| {
        layouts
            .contacts
            .laws
            .iter()
            .any(|law| law.quantity == quantity)
    };
    if has(ContactQuantity::Uneven) && has(ContactQuantity::Rough) {
        let detail = "and uneven are two laws of the same stations: give one of them";
        let at = member(&pointer, ContactQuantity::Rough.as_str());
        Fault::add(faults, &at, detail);
    }
    let lowest = OF_DEPTH * least_depth_mm(layouts, scene);
    let pulls = OF_FRICTION * least_friction(&layouts.contacts.laws, scene);
    for law in &layouts.contacts.laws {
        let detail = match law.quantity {
            ContactQuantity::Traction | ContactQuantity::SideTraction if law.reach() > pulls => {
                format!(
                    "must stay within {OF_FRICTION} of the least contact.friction, {}; it reaches {}",
                    plain(pulls),
                    plain(law.reach())
                )
            }
            ContactQuantity::Rough if law.reach() > lowest => format!(
                "must stay within {OF_DEPTH} of the least depth that is solved, {} mm, as the ground touches everywhere; it reaches {}",
                plain(lowest),
                plain(law.reach())
            ),
            ContactQuantity::Friction if scene.contact.friction == 0.0 => {
                "is a share of the scene's contact.friction, which is 0: give it one".to_owned()
            }
            _ => continue,
        };
        Fault::add(faults, &member(&pointer, law.quantity.as_str()), detail);
    }
}

/// Least depth at which contacts are solved, mm.
fn least_depth_mm(layouts: &Layouts, scene: &Scene) -> f64 {
    let own = &scene.ground.depths_mm;
    let asked = match &layouts.loads {
        LayoutLoads::Depths(depths) => depths.clone(),
        _ => vec![own.iter().sum::<f64>() / own.len().max(1) as f64],
    };
    let least = asked.iter().copied().fold(f64::INFINITY, f64::min);
    match asked.len() {
        ..FEW_LOADS => BEYOND[0] * least,
        _ => least,
    }
}

/// Least friction of contacts on a scene's ground.
fn least_friction(laws: &[ContactLaw], scene: &Scene) -> f64 {
    let law = laws
        .iter()
        .find(|law| law.quantity == ContactQuantity::Friction);
    let [least, _] = law.map_or([1.0; 2], ContactLaw::ends);
    least * scene.contact.friction
}

#[cfg(test)]
mod tests {
    use document::Format;

    use super::*;
    use crate::study::Study;

    fn read(contacts: &str, rest: &str) -> Result<Study, Vec<Fault>> {
        let text = format!(
            "name = \"contacts\"\nscene = {{ preset = \"foot-tire\", contact = {{ friction = 0.5 }} }}\n[[inputs]]\nname = \"p\"\nvary = \"pressure.internal_mpa\"\ndistribution = {{ kind = \"uniform\", min = 0.01, max = 0.02 }}\n[layouts]\nunits = [6]\n{rest}\n[layouts.contacts]\n{contacts}"
        );
        Study::from_document(&text, Format::Toml, &|path| Err(path.to_owned()))
    }

    fn faults(contacts: &str, rest: &str) -> String {
        match read(contacts, rest) {
            Ok(_) => String::new(),
            Err(faults) => faults
                .iter()
                .map(|fault| format!("{}: {}\n", fault.pointer, fault.detail))
                .collect(),
        }
    }

    #[test]
    fn scatter_is_read_and_written_where_it_is_averaged_over() {
        let camber = "camber_deg = { kind = \"uniform\", min = -5, max = 5 }";
        let together = read(camber, "depths_mm = [1]").expect("reads");
        assert_eq!(together.layouts.contacts.scatter, Scatter::Together);
        assert!(!together.canonical().contains("scatter"));
        let each =
            read(&format!("{camber}\nscatter = \"each\""), "depths_mm = [1]").expect("reads");
        assert_eq!(each.layouts.contacts.scatter, Scatter::Each);
        let again = Study::from_canonical(&each.canonical()).expect("reads what it wrote");
        assert_eq!(again.canonical(), each.canonical());
        assert_eq!(again.layouts.contacts.scatter, Scatter::Each);
        assert_eq!(
            (
                together.layouts.contacts.checks,
                again.layouts.contacts.checks
            ),
            (3, 3)
        );
        let many = read(&format!("{camber}\nchecks = 30"), "depths_mm = [1]").expect("reads");
        let again = Study::from_canonical(&many.canonical()).expect("reads what it wrote");
        assert_eq!(again.layouts.contacts.checks, 30);
    }

    #[test]
    fn laws_are_read_and_what_cannot_be_is_named() {
        let even = |name: &str, low: f64, high: f64| {
            format!("{name} = {{ kind = \"uniform\", min = {low}, max = {high} }}\n")
        };
        let all = even("camber_deg", -10.0, 10.0)
            + &even("traction", -0.3, 0.3)
            + &even("uneven", -0.3, 0.3);
        assert_eq!(faults(&all, "depths_mm = [1]"), "");
        for (contacts, rest, expected) in [
            (
                even("camber_deg", -31.0, 10.0),
                "",
                "/layouts/contacts/camber_deg: must stay from -30 to 30 degrees",
            ),
            (
                even("traction", -0.3, 0.41),
                "",
                "/layouts/contacts/traction: must stay within 0.8 of the least contact.friction, 0.4",
            ),
            (
                even("uneven", -0.3, 0.3),
                "loads_n = [13]",
                "/layouts/contacts: are judged at depths",
            ),
            (
                even("uneven", -0.3, 0.3),
                "shear = true",
                "/layouts/contacts: and layouts.shear are two models",
            ),
            (
                even("traction", -0.3, 0.3) + &even("friction_factor", 0.6, 1.4),
                "",
                "/layouts/contacts/traction: must stay within 0.8 of the least contact.friction, 0.24",
            ),
            (
                even("rough_mm", -0.5, 0.5),
                "depths_mm = [1]",
                "/layouts/contacts/rough_mm: must stay within 0.9 of the least depth that is solved, 0.45 mm",
            ),
            (
                even("rough_mm", -0.2, 0.2) + &even("uneven", -0.2, 0.2),
                "",
                "/layouts/contacts/rough_mm: and uneven are two laws",
            ),
            (
                even("friction_factor", 0.1, 1.4),
                "",
                "/layouts/contacts/friction_factor: must stay from 0.2 to 4",
            ),
            (even("wind", -0.3, 0.3), "", "/layouts/contacts/wind"),
            (
                format!("{}\nscatter = \"apart\"", even("camber_deg", -5.0, 5.0)),
                "",
                "/layouts/contacts/scatter: must be \"together\" or \"each\"",
            ),
            (
                format!("{}\nchecks = 0", even("camber_deg", -5.0, 5.0)),
                "",
                "/layouts/contacts/checks: must be a whole number from 1 to 1000",
            ),
            (
                "scatter = \"each\"".to_owned(),
                "",
                "/layouts/contacts: must have a law of camber_deg, traction",
            ),
            (
                String::new(),
                "",
                "/layouts/contacts: must have a law of camber_deg, traction",
            ),
        ] {
            let found = faults(&contacts, rest);
            assert!(found.contains(expected), "{found}");
        }
    }
}
