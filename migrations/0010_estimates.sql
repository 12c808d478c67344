-- What a study was expected to take when it last started, JSON: shown while it runs, and beside what it took.
alter table studies add column estimate text;
