//! Products of polynomials from which an expansion chooses: a product is a list of inputs with their degrees.

/// q of the hyperbolic norm.
const NORM: f64 = 0.75;
/// Most multi-indices.
const MOST_CANDIDATES: usize = 1500;
/// A degree more is preferred this much less.
const PREFERENCE: f64 = 0.95;

/// The constant is never to be missed; of equal columns the simpler one goes first.
pub(super) fn preference(index: &[(usize, usize)]) -> f64 {
    const FIRST: f64 = 1e6;
    match index.iter().map(|(_, degree)| *degree as i32).sum() {
        0 => FIRST,
        degree => PREFERENCE.powi(degree),
    }
}

/// All multi-indices within the hyperbola, the constant first; `None` if too many.
pub(super) fn multi_indices(inputs: usize, highest: usize) -> Option<Vec<Vec<(usize, usize)>>> {
    let budget = (highest as f64).powf(NORM) * (1.0 + 1e-12);
    let mut found = vec![Vec::new()];
    let mut from = 0;
    // Each round appends one input behind those that an index has.
    while from < found.len() {
        let round = from..found.len();
        from = found.len();
        for at in round {
            let base: Vec<(usize, usize)> = found[at].clone();
            let spent: f64 = base.iter().map(|(_, k)| (*k as f64).powf(NORM)).sum();
            let next = base.last().map_or(0, |(input, _)| input + 1);
            for input in next..inputs {
                let within = |k: &usize| spent + (*k as f64).powf(NORM) <= budget;
                for k in (1..=highest).take_while(within) {
                    let mut index = base.clone();
                    index.push((input, k));
                    found.push(index);
                }
            }
            if found.len() > MOST_CANDIDATES {
                return None;
            }
        }
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hyperbolic_sets_hold_every_index_once() {
        // q-norm 3/4 <= 3: 1..3 alone; of pairs (1,1): 2^(4/3) = 2.5; (1,2) is 3.46
        let found = multi_indices(2, 3).unwrap();
        assert_eq!(found.len(), 1 + 6 + 1);
        let mut sorted = multi_indices(4, 6).unwrap();
        let count = sorted.len();
        sorted.sort();
        sorted.dedup();
        assert_eq!(sorted.len(), count);
        assert!(multi_indices(200, 3).is_none());
    }
}
