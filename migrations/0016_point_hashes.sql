-- A row that says which evaluation answers for a point has a hash of its own. Earlier rows get theirs when the database is opened.
alter table study_points add column sha256 text;   -- of study, ordinal and evaluation
