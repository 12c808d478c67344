//! Peak memory of a study.
//!
//! An upper bound rather than a mean, because a study is refused by it: measured peaks are two fifths to all of it. Fitted to the peaks of whole
//! studies by all methods on the draft, coarse and standard meshes, with and without maps of up to 40 602 numbers.

use super::solve_time::{How, Machine};
use super::workload::{Point, Stage, Workload};

/// The program without a study, bytes.
pub(super) const PROGRAM: f64 = 30e6;
/// A point's response, and its row on the way to the database, without its numbers, bytes.
const RESPONSE: f64 = 60e3;
/// A number read of one point: the response's, the row's, and those of the analysis, bytes.
const READING: f64 = 32.0;
/// A number's indices and errors, in the analysis, the result and its text, on one mesh, bytes: by a method with a plan, and by one that adapts,
/// which keeps the surrogates that it chooses from.
const OUTPUT: [f64; 2] = [3e3, 30e3];
/// Memory that solves leave in the allocator's pools, in meshes in work: that of few points, how many these are, points for another one, at most.
const POOLS: (f64, f64, f64, f64) = (1.7, 26.0, 40.0, 3.5);
/// Memory that the estimate of contacts keeps for each film of a layout on each thread, bytes: a dozen functions at 4860 angles, twice, and what the allocator
/// keeps of them.
const FILM: f64 = 2e6;
/// Memory of the tangents that are kept for further loads of layouts, in meshes in work. The shipped study took 903 to 1069 MB in seventeen runs.
const CHAINED: f64 = 0.2;
/// Meshes that layouts are solved on, at most.
const MESHES: usize = 2;
/// Memory of a search for each place that films may have, bytes: the shares of both criteria.
const PLACE: f64 = 100e3;
/// Memory of a solve of deep contact beside its mesh, bytes on the draft mesh: borders that are widened again and again, of as many nodes as a surface has.
const DEEP: f64 = 70e6;

/// Largest memory of the process while these stages of a workload run, bytes: the program, the meshes in work, the responses of all
/// points, and their analysis.
pub(super) fn memory_bytes(work: &Workload, stages: &[Stage], machine: &Machine) -> u64 {
    let largest = |part: &dyn Fn(&Stage) -> f64| stages.iter().map(part).fold(0.0, f64::max);
    let points: usize = stages.iter().map(Stage::points).sum();
    let responses = points as f64 * (RESPONSE + READING * work.readings as f64);
    let analysed = |stage: &Stage| {
        let output = OUTPUT[usize::from(stage.extra.most > 0)];
        output * (stage.meshes() * work.readings) as f64
    };
    let solving = |stage: &Stage| solving(stage, machine);
    let scored = |stage: &Stage| {
        FILM * (stage.films * machine.threads) as f64 + PLACE * stage.searched.1 as f64
    };
    (PROGRAM + largest(&solving) + responses + largest(&analysed) + largest(&scored)) as u64
}

fn solving(stage: &Stage, machine: &Machine) -> f64 {
    let (few, few_points, another, most) = POOLS;
    let pools = |solves: usize| (few + (solves as f64 - few_points).max(0.0) / another).min(most);
    let of_series = |series: &Vec<Point>, kept: f64, pools: f64| {
        let own = |point: &&Point| {
            point.task.how == How::Afresh || point.task.friction || point.task.deep
        };
        // Those near a cut point share its factor, which is kept when they leave it.
        let at_once = (1 + series.iter().filter(own).count()).min(machine.threads);
        let is_deep = series.iter().any(|point| point.task.deep);
        let meshes = (at_once + usize::from(is_deep)) as f64 + kept;
        let largest = series.iter().map(|point| point.task.memory_bytes());
        let borders = series.iter().map(|point| point.task.surface());
        let contact = match is_deep {
            true => DEEP * borders.fold(0.0, f64::max) * at_once as f64,
            false => 0.0,
        };
        pools * largest.fold(0.0, f64::max) * meshes + contact
    };
    let own = pools(stage.own.len() + stage.extra.expected);
    let all = stage.series().map(|series| of_series(series, 0.0, own));
    // Flat ground is a series on each mesh; glued films and contacts are many.
    let many = match stage.layouts.len() {
        ..=MESHES => own,
        _ => own.max(pools(stage.layouts.iter().map(Vec::len).sum())),
    };
    let layouts = stage
        .layouts
        .iter()
        .map(|series| of_series(series, CHAINED, many));
    all.chain(layouts).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use document::Format;
    use tire::embedded::EmbeddedSolver;

    use super::*;
    use documents::study::plan::PlannedStudy;
    use documents::study::{Study, presets};

    /// The shipped study with another map, method and mesh.
    fn megabytes(grid: Option<[usize; 2]>, method: &str, level: &str) -> f64 {
        estimated_mb(&changed(grid, method, level))
    }

    fn changed(grid: Option<[usize; 2]>, method: &str, level: &str) -> String {
        let map = "grid = { circumferential = 61, meridional = 21 }";
        let other = grid.map_or(String::new(), |[x, y]| {
            format!("grid = {{ circumferential = {x}, meridional = {y} }}")
        });
        let mdrm = "kind = \"mdrm\"\nnodes = 5\ncheck_points = 5";
        let text = presets()[0].1.replace(map, &other);
        let text = text.replace("[layouts]", "[layouts]\nspacings_deg = []");
        let text = text.replace(mdrm, method);
        text.replace("preset = \"standard\"", &format!("preset = \"{level}\""))
    }

    fn estimated_mb(text: &str) -> f64 {
        let study = Study::from_document(text, Format::Toml, &|path| Err(path.to_owned()));
        let planned = PlannedStudy::new(study.expect("a study")).expect("a plan");
        let work = Workload::of(&planned, &EmbeddedSolver::default());
        memory_bytes(&work, &work.stages, &Machine::new(2)) as f64 / 1e6
    }

    #[test]
    fn deep_contact_takes_no_more_than_was_said() {
        let map = Some([61, 21]);
        let depths = "min = 0.7, max = 1.3";
        // The reference study, before its mesh was changed, and the coarse one up to 9 mm had made their tangents, but not all of their solves.
        for (level, others, peak) in [
            ("draft", "min = 3.0, max = 9.0", 141.0),
            ("coarse", "min = 3.0, max = 9.0", 931.5),
            ("coarse", "min = 4.0, max = 6.0", 765.7),
            ("reference", "min = 3.0, max = 9.0", 3074.0),
        ] {
            let mdrm = "kind = \"mdrm\"\nnodes = 5\ncheck_points = 5";
            let text = changed(map, mdrm, level).replace(depths, others);
            let ratio = estimated_mb(&text) / peak;
            assert!(
                (1.0..3.0).contains(&ratio),
                "{level} {others}: {ratio:.2} times {peak} MB"
            );
        }
    }

    #[test]
    fn measured_peaks_are_met_and_no_study_is_refused_for_thrice_what_it_takes() {
        let mdrm = "kind = \"mdrm\"\nnodes = 5\ncheck_points = 5";
        let (pce, auto) = ("kind = \"pce\"\nsamples = 60", "kind = \"auto\"");
        // Largest resident memory of `strainsite run` on two threads, MB, the larger of two runs.
        let measured = [
            (None, mdrm, "draft", 44.9),
            (Some([61, 21]), mdrm, "draft", 52.3),
            (Some([101, 101]), mdrm, "draft", 106.4),
            (Some([201, 101]), mdrm, "draft", 183.1),
            (Some([61, 21]), pce, "draft", 59.5),
            (Some([101, 101]), pce, "draft", 120.5),
            (None, auto, "draft", 69.7),
            (Some([61, 21]), auto, "draft", 124.9),
            (Some([101, 101]), auto, "draft", 540.5),
            (None, mdrm, "coarse", 272.7),
            (Some([61, 21]), mdrm, "coarse", 306.3),
            (Some([101, 101]), mdrm, "coarse", 384.0),
            (Some([61, 21]), auto, "coarse", 400.9),
            (None, mdrm, "standard", 577.4),
            (Some([61, 21]), mdrm, "standard", 543.2),
        ];
        for (grid, method, level, peak) in measured {
            let ratio = megabytes(grid, method, level) / peak;
            assert!(
                (1.0..3.0).contains(&ratio),
                "{grid:?} {method} {level}: {ratio:.2} times {peak} MB"
            );
        }
    }
}
