-- Sweeps whose designs other machines solve, or did. Their studies have no turn here until that has ended.
create table sweep_engines (
    sweep  text primary key not null references sweeps (id),
    engine text not null,                       -- its name
    begun  text not null,                       -- when it was given the sweep, the last time
    report text not null,                       -- what became of the tasks, JSON; the JSON null until that has ended
    sha256 text not null,                       -- of the report
    ended  text,                                -- when nothing of it went on any more
    seal   text
) strict;

create index sweep_engines_unsealed on sweep_engines (sweep) where seal is null;
