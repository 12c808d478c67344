-- When a study or a sweep was archived, so that lists leave it out unless asked; null in those that they show. Its `name` may be another than its document's.
alter table studies add column archived text;
alter table sweeps add column archived text;
