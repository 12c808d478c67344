-- Which studies a point belongs to, and which keys a study has: asked when a study is removed.
create index study_points_by_evaluation on study_points (evaluation);
create index idempotency_keys_by_study on idempotency_keys (study);
create index sweep_keys_by_sweep on sweep_keys (sweep);
