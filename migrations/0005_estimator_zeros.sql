-- Zeros that estimators were given after they were learnt: what their signals are without a force.
create table estimator_zeros (
    estimator text primary key not null references estimators (id),
    document  text not null,                      -- JSON
    sha256    text not null,                      -- of that document
    seal      text
) strict;

create index estimator_zeros_unsealed on estimator_zeros (estimator) where seal is null;
