//! Mirror images among points: of two mirrored grounds a solver solves one, and remembers it for a while.

use std::collections::HashMap;

use fem_client::scene::{Film, Scene};

/// All of a scene that decides its inflated state and its mesh.
pub(crate) fn tire(scene: &Scene) -> String {
    let mut plain = scene.clone();
    plain.ground.depths_mm.clear();
    plain.ground.load_n = None;
    plain.contact.friction = 0.0;
    format!("{plain:?}")
}

/// All of a scene, the same for a ground and its mirror image.
pub(crate) fn mirror_key(scene: &Scene) -> (String, Vec<u64>) {
    (tire(scene), mirror_class(scene))
}

/// The ground's depths or load, the same for a ground and its mirror image.
pub(crate) fn mirror_class(scene: &Scene) -> Vec<u64> {
    let ground = &scene.ground;
    let depths: Vec<u64> = ground
        .depths_mm
        .iter()
        .chain(&ground.load_n)
        .map(|d| d.to_bits())
        .collect();
    if !scene.film.as_ref().is_none_or(Film::is_own_mirror_image) {
        return depths;
    }
    let mirrored: Vec<u64> = depths.iter().rev().copied().collect();
    depths.min(mirrored)
}

/// Points between a ground and its mirror image: all threads have begun others by then, and the solver remembers twice as many.
const BETWEEN: usize = 32;

/// Ordinals of points in an order in which mirror images come soon after each other, and not at the same time.
pub(crate) fn images_near(ordinals: &[usize], scenes: &[Scene]) -> Vec<usize> {
    let mut places: HashMap<Vec<u64>, usize> = HashMap::new();
    let mut classes: Vec<Vec<usize>> = Vec::new();
    for &ordinal in ordinals {
        let place = *places
            .entry(mirror_class(&scenes[ordinal]))
            .or_insert(classes.len());
        match classes.get_mut(place) {
            Some(class) => class.push(ordinal),
            None => classes.push(vec![ordinal]),
        }
    }
    let turns = |classes: &[Vec<usize>]| {
        let longest = classes.iter().map(Vec::len).max().unwrap_or(0);
        let turn = |turn: usize| classes.iter().filter_map(move |class| class.get(turn));
        (0..longest).flat_map(turn).copied().collect::<Vec<_>>()
    };
    classes.chunks(BETWEEN).flat_map(turns).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_comes_after_all_threads_have_something_else_to_do() {
        // Depths k, l of all pairs: the image of each is far behind it in their order.
        let depths = |k: usize, l: usize| {
            let mut scene = Scene::default();
            scene.ground.depths_mm = vec![0.01 * k as f64, 1.0, 0.01 * l as f64];
            scene
        };
        let scenes: Vec<Scene> = (0..400).map(|i| depths(i / 20, i % 20)).collect();
        let all: Vec<usize> = (0..400).collect();
        let order = images_near(&all, &scenes);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, all);
        let place = |ordinal: usize| order.iter().position(|other| *other == ordinal).unwrap();
        for (k, l) in (0..20).flat_map(|k| (0..k).map(move |l| (k, l))) {
            let apart = place(20 * k + l).abs_diff(place(20 * l + k));
            assert!((10..=2 * BETWEEN).contains(&apart), "{k} {l}: {apart}");
        }
    }
}
