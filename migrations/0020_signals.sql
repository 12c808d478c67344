-- What films read of loads, pressures and contact angles, one row each, as it is served.
create table signals (
    study                  text not null references results (study),
    ordinal                integer not null,
    tire                   text not null,
    film                   text not null,   -- bare, transfer, coupled
    position               text not null,   -- crown, shoulder, sidewall
    direction              text not null check (direction in ('x', 'y')),
    axis                   text not null,   -- what its curve is over: load, pressure, contact
    load_n                 real not null,
    pressure_mpa           real not null,
    contact_deg            real not null,
    depth_mm               real,
    strain                 real,
    tension_1_n_per_mm     real,
    charge_nc              real,
    open_circuit_v         real,
    output_v               real,
    output_std_v           real,
    state                  text,            -- ok, beyond-yield, wrinkled
    error_strain           real,
    error_charge_nc        real,
    error_open_circuit_v   real,
    error_output_v         real,
    reason                 text,            -- why numbers are null
    primary key (study, ordinal)
) strict, without rowid;

-- What a study's rows show. Only results that have signals have one.
create table signal_findings (
    study       text primary key not null references results (study),
    findings    text not null,              -- curves, pairs, widths and claims, JSON
    rows_sha256 text not null               -- of the findings and the rows above
) strict;
