//! Slopes over the depth, mesh by mesh.

use plotters::coord::Shift;
use plotters::prelude::*;

const SIZE: (u32, u32) = (900, 620);
/// Colours of the meshes, in the order of a panel's curves.
const COLOURS: [RGBColor; 4] = [
    RGBColor(200, 160, 60),
    RGBColor(0, 90, 156),
    RGBColor(60, 150, 90),
    RGBColor(40, 40, 40),
];
/// Slopes that are drawn, with their place in [`Curve::slopes`].
const DRAWN: [(usize, &str); 2] = [
    (1, "meridional strain at P3, per mm"),
    (2, "reaction, N per mm"),
];

type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Slopes on one mesh: by depth (mm) those of the circumferential and the meridional strain at P3 (per mm) and of the reaction (N per mm).
#[derive(Clone)]
pub struct Curve {
    pub name: String,
    pub slopes: Vec<(f64, [f64; 3])>,
}

/// Curves of all meshes where the same depths move.
pub struct Panel {
    pub title: &'static str,
    pub curves: Vec<Curve>,
}

/// The panels as SVG text, a column each.
pub fn svg(panels: &[Panel]) -> Result<String, DrawingAreaErrorKind<std::io::Error>> {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let areas = area.split_evenly((DRAWN.len(), panels.len()));
        let places = DRAWN
            .iter()
            .flat_map(|drawn| panels.iter().map(move |panel| (drawn, panel)));
        for (area, (drawn, panel)) in areas.iter().zip(places) {
            draw(area, panel, *drawn)?;
        }
        area.present()?;
    }
    Ok(text)
}

fn draw(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    panel: &Panel,
    (read, what): (usize, &str),
) -> Drawn {
    let all = || panel.curves.iter().flat_map(|curve| &curve.slopes);
    let depths = all().map(|(depth, _)| *depth);
    let (first, last) = depths.fold((f64::MAX, f64::MIN), |(low, high), d| {
        (low.min(d), high.max(d))
    });
    let top = all().fold(0.0, |top: f64, (_, slopes)| top.max(slopes[read]));
    let mut chart = ChartBuilder::on(area)
        .caption(format!("{}, {what}", panel.title), ("sans-serif", 15))
        .margin(8)
        .x_label_area_size(34)
        .y_label_area_size(46)
        .build_cartesian_2d(first..last, 0.0..1.15 * top)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .x_labels(6)
        .y_labels(6)
        .light_line_style(WHITE)
        .x_desc("depth, mm")
        .draw()?;
    for (curve, colour) in panel.curves.iter().zip(COLOURS) {
        let points = curve
            .slopes
            .iter()
            .map(|(depth, slopes)| (*depth, slopes[read]));
        chart
            .draw_series(LineSeries::new(points, colour.stroke_width(1)))?
            .label(&curve.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 14, y)], colour.stroke_width(2)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerLeft)
        .background_style(WHITE.mix(0.8))
        .draw()
}
