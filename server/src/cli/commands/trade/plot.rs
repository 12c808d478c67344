//! The trade as a picture: time against true and claimed error, both logarithmic.

use plotters::prelude::*;

use placement::ladder::trade::Trade;

const SIZE: (u32, u32) = (900, 560);
const TRUE: RGBColor = RGBColor(0, 90, 156);
const CLAIMED: RGBColor = RGBColor(200, 110, 20);
/// Width of a letter of a label, at most, pixels.
const LETTER: i32 = 6;
/// Errors below this are drawn there: a logarithm has no zero.
const LEAST: f64 = 1e-5;

/// The picture as SVG text.
///
/// # Errors
/// A sentence, when it can't be drawn.
pub fn svg(trade: &Trade) -> Result<String, String> {
    let mut text = String::new();
    draw(trade, &mut text).map_err(|error| format!("the plot can't be drawn: {error}"))?;
    Ok(text)
}

/// Place of the mark of a time and an error.
fn drawn((wall_s, error): (f64, f64)) -> (f64, f64) {
    (wall_s, error.max(LEAST))
}

/// A range that holds all values and some room, in whole powers of ten.
fn decades(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), value| {
        (low.min(value), high.max(value))
    });
    if high <= 0.0 {
        return 0.1..1.0;
    }
    let decade = |value: f64| 10f64.powf(value);
    decade(low.log10().floor())..decade((high.log10() + 1e-9).ceil())
}

fn draw(trade: &Trade, text: &mut String) -> Result<(), DrawingAreaErrorKind<std::io::Error>> {
    let rungs = &trade.rungs;
    let truth: Vec<_> = rungs
        .iter()
        .filter_map(|rung| rung.true_mark().map(drawn))
        .collect();
    let claims: Vec<_> = rungs
        .iter()
        .filter_map(|rung| rung.claimed_mark().map(drawn))
        .collect();
    let both = || truth.iter().chain(&claims);
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(&trade.study, ("sans-serif", 18))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d(
            decades(both().map(|p| p.0)).log_scale(),
            decades(both().map(|p| p.1)).log_scale(),
        )?;
    chart
        .configure_mesh()
        .x_desc("wall-clock time, s")
        .y_desc("largest error of a first-order index")
        .x_label_formatter(&|x| plain(*x))
        .y_label_formatter(&|y| plain(*y))
        .draw()?;
    let mut front: Vec<_> = rungs
        .iter()
        .filter(|rung| rung.pareto)
        .filter_map(|rung| rung.true_mark().map(drawn))
        .collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0));
    chart
        .draw_series(LineSeries::new(front, TRUE.stroke_width(2)))?
        .label("Pareto front")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 16, y)], TRUE.stroke_width(2)));
    chart
        .draw_series(claims.iter().map(|p| TriangleMarker::new(*p, 5, CLAIMED)))?
        .label("claimed")
        .legend(|(x, y)| TriangleMarker::new((x + 8, y), 5, CLAIMED));
    chart
        .draw_series(truth.iter().map(|p| Circle::new(*p, 5, TRUE.filled())))?
        .label("true")
        .legend(|(x, y)| Circle::new((x + 8, y), 5, TRUE.filled()));
    let mut labels: Vec<_> = rungs
        .iter()
        .filter_map(|rung| Some((drawn(rung.true_mark()?), &rung.label)))
        .collect();
    labels.sort_by(|a, b| a.0.0.total_cmp(&b.0.0));
    // Neighbours in time have their labels above and below, the slowest theirs to the left.
    let slow = labels.last().map_or(0.0, |(at, _)| 0.3 * at.0);
    chart.draw_series(labels.iter().enumerate().map(|(k, (at, label))| {
        let left = if at.0 > slow {
            -LETTER * label.len() as i32
        } else {
            0
        };
        let offset = (left + 4, if k % 2 == 0 { -18 } else { 8 });
        EmptyElement::at(*at) + Text::new((*label).clone(), offset, ("sans-serif", 11))
    }))?;
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerLeft)
        .background_style(WHITE)
        .border_style(BLACK.mix(0.3))
        .draw()?;
    area.present()
}

/// A power of ten as people write it.
fn plain(value: f64) -> String {
    if (1e-4..1e5).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}
