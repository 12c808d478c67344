//! Layouts over contacts as they come, on the foot tire's own mesh.

use crate::menu::solved;

/// A camber and a traction: their contacts are solved on one side each, and read on the other by the mirror planes, as is a station before the middle with and without the
/// camber or the traction; the contacts of all at once that the surface is judged by lie on either side.
#[test]
fn contacts_as_they_come_are_solved_on_one_side_and_judged_on_both() {
    let result = solved(
        "name = \"contacts\"
scene = { preset = \"foot-tire\", contact = { friction = 0.5 }, ground = { depths_mm = [1, 1, 1] } }
inputs = [{ name = \"P3\", vary = \"ground.depths_mm[1]\", distribution = { kind = \"uniform\", min = 0.7, max = 1.3 } }]
method = { kind = \"mdrm\", nodes = 2, check_points = 0, seed = 1 }
accuracy = { preset = \"draft\" }
[layouts]
depths_mm = [1]
units = [12, 24]
section_deg = [0, 45]
directions = [[\"y\"]]
[layouts.contacts]
camber_deg = { kind = \"uniform\", min = -10, max = 10 }
traction = { kind = \"uniform\", min = -0.2, max = 0.2 }
uneven = { kind = \"uniform\", min = -0.2, max = 0.2 }
checks = 2
",
    );
    // Flat ground at five depths; at the load and at both ends two steps of a camber, a traction and the middle station and four of the first of three, the camber with each of
    // these stations, a traction with the first and the first with the middle one; two contacts of all at once.
    assert_eq!(result.cost.layout_solves, 5 + (2 * 3 + 4 + 2 + 2) * 3 + 2);
    let findings = result.layout_findings.expect("layouts");
    let contacts = findings.contacts.expect("a surface");
    assert_eq!(
        contacts.laws,
        [
            "camber -9.98 to 9.98 degrees",
            "traction -0.20 to 0.20",
            "uneven ground -0.20 to 0.20"
        ]
    );
    assert!(contacts.short.is_empty(), "{:?}", contacts.short);
    // A camber on the wrong side would be off by half of the crown's largest signal; outermost stations with the middle one on the wrong side leave 0.023 and 0.040 where it is
    // 0.010 and 0.021.
    assert!(contacts.signal_error_rms < 0.015, "{contacts:?}");
    let slopes = contacts.slope_error_rms.expect("judged");
    assert!(slopes < 0.03, "{contacts:?}");
    assert!(contacts.force_error_n < 0.05 * 13.0, "{contacts:?}");
    for layout in &result.layouts {
        let score = &layout.score;
        let of: Vec<&str> = score.contacts.iter().map(|own| own.of.as_str()).collect();
        assert_eq!(of, ["noise", "camber_deg", "traction", "uneven"]);
        let [noise, camber, _, _] = score.contacts.as_slice() else {
            panic!("{layout:?}");
        };
        // Both are estimated; the traction shifts the peaks along the wheel, which a film along y feels as an angle alone.
        let told: Vec<&str> = score.told.iter().map(|own| own.of.as_str()).collect();
        let loads = ["fx_n", "fy_n", "mx_nmm", "my_nmm", "mz_nmm"];
        assert_eq!(told, [&["camber_deg", "traction"][..], &loads].concat());
        let deviation = |of: &str| {
            let mut told = score.told.iter();
            told.find(|own| own.of == of).expect("told").deviation
        };
        // A pull along the wheel acts at its tread, 49 mm below the axle; a camber of 10 degrees moves the contact by 2 mm across, and its 13 N with it.
        let lever_mm = deviation("my_nmm") / deviation("fx_n");
        assert!((lever_mm / 49.0 - 1.0).abs() < 0.05, "{lever_mm}");
        assert!(deviation("mx_nmm") > 10.0, "{}", deviation("mx_nmm"));
        for own in &score.told {
            assert!(own.error < 1.05 * own.deviation, "{own:?}");
        }
        // A camber that isn't known adds to the force's error, whatever the layout, within two standard errors of both.
        let chance = 3.0 * score.force_error_n_se.expect("simulated");
        let least = noise.force_error_n - chance;
        let at_crown = layout.position == "crown";
        let of_camber = if at_crown { noise.force_error_n } else { least };
        assert!(camber.force_error_n > of_camber, "{layout:?}");
        assert!(score.force_error_n > Some(least), "{layout:?}");
    }
}
