-- Each estimator is learnt in a process of its own, which takes so much memory and may crash.
alter table estimators add column memory_bytes integer not null default 0; -- that learning may take
alter table estimators add column crashes integer not null default 0;      -- of its process
