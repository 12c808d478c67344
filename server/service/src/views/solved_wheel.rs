//! The wheel of a study at its cut point, from the equilibrium that is stored there.

use document::Format;
use fem_client::scene::Scene;
use fem_client::solver::StartState;
use serde::de::IgnoredAny;
use sqlx::SqliteConnection;
use vtu::solved_body::Body;
use vtu::wheel_skins::WheelSkins;

use store::StoreError;
use store::points::evaluations;

/// Both skins of the whole wheel at the study's cut point on the mesh of this level; `None` where no state of such a mesh is stored. The mesh is made anew for it.
///
/// # Errors
/// [`StoreError::Damaged`] when a row doesn't match its hash; when the database can't be read.
pub async fn skins(
    connection: &mut SqliteConnection,
    study: &str,
    level: &str,
) -> Result<Option<WheelSkins>, StoreError> {
    let Some((scene, state)) = cut_point(connection, study, level).await? else {
        return Ok(None);
    };
    let drawn =
        tokio::task::spawn_blocking(move || Body::of(&scene, &state).map(|body| body.skins()));
    // What panics is in the log, and drew nothing.
    Ok(drawn.await.ok().flatten())
}

/// The scene and the equilibrium from which the study's points on this level start. What else starts from an equilibrium of its own, effects and
/// layouts, comes after them.
async fn cut_point(
    connection: &mut SqliteConnection,
    study: &str,
    level: &str,
) -> Result<Option<(Scene, StartState)>, StoreError> {
    let points = evaluations::cut_points_of::<IgnoredAny>(connection, study).await?;
    let mut scenes = points.into_iter().filter_map(|(_, key, evaluation)| {
        let scene = Scene::from_text(&evaluation.scene, Format::Json).ok()?;
        Some((key, scene))
    });
    let on_level = |(_, scene): &(String, Scene)| scene.model.level.as_str() == level;
    let Some((key, scene)) = scenes.find(on_level) else {
        return Ok(None);
    };
    let state = evaluations::find_start(connection, &key).await?;
    Ok(state.map(|state| (scene, state)))
}
