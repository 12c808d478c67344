-- Zeros that estimators were given after they were learnt: what their signals are without a force. Each that is done has a row, so that one that was removed is missed.
create table estimator_zeros (
    estimator text primary key not null references estimators (id),
    document  text not null,                      -- JSON; null where it was given none
    sha256    text not null,                      -- of that document
    seal      text
) strict;

create index estimator_zeros_unsealed on estimator_zeros (estimator) where seal is null;

insert into estimator_zeros (estimator, document, sha256)
select id, 'null', '74234e98afe7498fb5daf1f36ac2d78acc339464f950703b8c019892f982b90b' from estimators where state = 'done';
