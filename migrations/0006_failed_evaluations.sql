-- That a load has no equilibrium is an answer too, kept as others are: its response is the JSON null.
alter table evaluations add column failure text;    -- kind, where it ended, loads reached, JSON; null beside a response
