//! First-order indices of some strains by three ways, side by side.

use plotters::coord::Shift;
use plotters::prelude::*;

const SIZE: (u32, u32) = (900, 330);
const TRUTH: RGBColor = RGBColor(205, 214, 224);
const FOUND: RGBColor = RGBColor(0, 90, 156);
const PRODUCT: RGBColor = RGBColor(200, 110, 20);

type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Indices of one strain for the five depths.
pub struct Panel {
    pub title: String,
    /// Shares by the full grid.
    pub truth: Vec<f64>,
    /// Shares by the product of the lines.
    pub product: Vec<f64>,
    /// Shares as the shipped study says, with what it claims to be off.
    pub found: Vec<f64>,
    pub claimed: Vec<f64>,
}

/// The panels as SVG text.
pub fn svg(panels: &[Panel]) -> Result<String, DrawingAreaErrorKind<std::io::Error>> {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        for (area, panel) in area.split_evenly((1, panels.len())).iter().zip(panels) {
            draw(area, panel)?;
        }
        area.present()?;
    }
    Ok(text)
}

fn draw(area: &DrawingArea<SVGBackend<'_>, Shift>, panel: &Panel) -> Drawn {
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.title, ("sans-serif", 16))
        .margin(8)
        .x_label_area_size(36)
        .y_label_area_size(44)
        .build_cartesian_2d(0.5f64..5.5, 0.0f64..1.3)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .x_labels(5)
        .x_label_formatter(&|x| format!("{x:.0}"))
        .y_labels(7)
        .light_line_style(WHITE)
        .y_label_formatter(&|y| format!("{y:.1}"))
        .x_desc("depth")
        .y_desc("first-order index")
        .draw()?;
    let places = || (1..=panel.truth.len()).map(|k| k as f64);
    let bars = places().zip(&panel.truth);
    chart
        .draw_series(
            bars.map(|(x, s)| Rectangle::new([(x - 0.38, 0.0), (x + 0.38, *s)], TRUTH.filled())),
        )?
        .label("full grid, 3125 solves")
        .legend(|(x, y)| Rectangle::new([(x, y - 4), (x + 14, y + 4)], TRUTH.filled()));
    let errors = places().zip(panel.found.iter().zip(&panel.claimed));
    chart.draw_series(errors.map(|(x, (s, e))| {
        let ends = [(s - e).max(0.0), (s + e).min(1.0)];
        PathElement::new(ends.map(|end| (x - 0.15, end)), FOUND.stroke_width(2))
    }))?;
    let found = places().zip(&panel.found);
    chart
        .draw_series(found.map(|(x, s)| Circle::new((x - 0.15, *s), 4, FOUND.filled())))?
        .label("shipped study, 26 solves")
        .legend(|(x, y)| Circle::new((x + 7, y), 3, FOUND.filled()));
    let products = places().zip(&panel.product);
    chart
        .draw_series(products.map(|(x, s)| Cross::new((x + 0.15, *s), 4, PRODUCT.stroke_width(2))))?
        .label("M-DRM's product")
        .legend(|(x, y)| Cross::new((x + 7, y), 4, PRODUCT.stroke_width(2)));
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.8))
        .draw()
}
