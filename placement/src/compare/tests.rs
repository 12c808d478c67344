use gsa::method::analysis::{Form, Status};

use super::*;
use results::{CoarserIndices, IndexError};

/// A strain of two inputs; the coarser mesh is off by so much more.
fn output(first: f64, coarser: Option<[f64; 2]>) -> Output {
    let factor = 4.0;
    let first_order = vec![first, 1.0 - first];
    let coarser = coarser.map(|off| CoarserIndices {
        first_order: vec![first + off[0], 1.0 - first + off[1]],
        factor,
    });
    Output {
        location: "P1".to_owned(),
        direction: Direction::X,
        mean: Some(0.01),
        std: Some(1e-3),
        first_order: Some(first_order),
        total: None,
        method: Form::Mdrm,
        status: Status::Ok,
        reason: None,
        mdrm_first_order: None,
        error: IndexError {
            mesh: coarser.as_ref().map(|_| 0.04),
            quadrature: Some(0.0),
            decomposition: Some(0.003),
            total: Some(0.043),
            reason: None,
        },
        coarser,
        misses: None,
    }
}

fn index(percent: f64, error: Option<f64>, output: &Output) -> Index<'_> {
    Index {
        percent: Some(percent),
        error,
        input: Some(0),
        output: Some(output),
    }
}

fn close(a: Option<f64>, b: f64) -> bool {
    a.is_some_and(|a| (a - b).abs() < 1e-12)
}

#[test]
fn what_both_meshes_get_wrong_alike_is_no_error_of_the_difference() {
    let ours = output(0.72, Some([0.010, -0.004]));
    let theirs = output(0.70, Some([0.009, -0.004]));
    let (a, b) = (
        index(72.0, Some(4.3), &ours),
        index(70.0, Some(4.4), &theirs),
    );
    let beside = a.beside(Some(b));
    assert!(close(beside.difference_percent, 2.0));
    // 4 (0.010 - 0.009) of the meshes; 0.3 and 0.4 of the methods.
    assert!(
        close(beside.difference_error_percent, 0.4 + 0.5),
        "{beside:?}"
    );
    assert_eq!(beside.verdict, Some(Verdict::Real));
}

#[test]
fn what_both_forms_miss_alike_is_no_error_of_the_difference() {
    let missing = |factor: f64| Output {
        misses: Some(FormMisses {
            nodes: vec![0, 1, 1, 0],
            residuals: vec![0.0; 2],
            contributions: [1e-3, 2e-3, 0.0, 0.0].map(|c| c * factor).to_vec(),
            weight: 1.0,
            fitted: 0,
            images: Vec::new(),
        }),
        ..output(0.72, Some([0.0, 0.0]))
    };
    let errors = |output: &Output| {
        let misses = output.misses.as_ref().expect("misses");
        100.0 * misses.misses().errors()[0]
    };
    let (ours, theirs) = (missing(1.0), missing(0.9));
    // Beside the mesh's 4 points, and 0.3 and 0.4 of the rules.
    let a = index(72.0, Some(4.0 + 0.3 + errors(&ours)), &ours);
    let b = index(70.0, Some(4.0 + 0.4 + errors(&theirs)), &theirs);
    let error = a.beside(Some(b)).difference_error_percent;
    assert!(close(error, 0.1 * errors(&ours) + 0.5), "{error:?}");
    // Another input's depth has nothing in common with this one's.
    let other = Index {
        input: Some(1),
        ..b
    };
    let apart = a.beside(Some(other)).difference_error_percent;
    let expected = (0.3 + errors(&ours)).hypot(0.4 + errors(&theirs));
    assert!(close(apart, expected), "{apart:?}");
}

#[test]
fn without_coarser_meshes_errors_are_independent() {
    let (ours, theirs) = (output(0.72, None), output(0.70, Some([0.01, 0.0])));
    let (a, b) = (
        index(72.0, Some(3.0), &ours),
        index(70.0, Some(4.0), &theirs),
    );
    let beside = a.beside(Some(b));
    assert!(close(beside.difference_error_percent, 5.0));
    assert_eq!(beside.verdict, Some(Verdict::Noise));
    let unknown = index(72.0, None, &ours).beside(Some(b));
    assert_eq!(
        (unknown.difference_error_percent, unknown.verdict),
        (None, Some(Verdict::Unknown))
    );
}

#[test]
fn a_study_is_its_own_equal() {
    let ours = output(0.72, Some([0.010, -0.004]));
    let a = index(72.0, Some(4.0), &ours);
    let beside = a.beside(Some(a));
    assert_eq!(
        (beside.difference_percent, beside.verdict),
        (Some(0.0), Some(Verdict::Noise))
    );
    assert_eq!(a.beside(None).verdict, None);
}

#[test]
fn without_any_result_the_reasons_are_left() {
    let entry = Entry {
        id: "a".to_owned(),
        name: "thin".to_owned(),
        set: None,
        state: "failed".to_owned(),
        result: Err("it has no equilibrium".to_owned()),
    };
    let table = compare(&[entry], None);
    assert_eq!((table.baseline, table.rows.len()), (None, 0));
    assert_eq!(
        table.studies[0].reason.as_deref(),
        Some("it has no equilibrium")
    );
    assert!(table.notes[0].contains("no study has a result"));
}
