-- What a comparison reads of a result: a twentieth of it. Results of earlier versions have none or one of another format, and are read whole.
create table result_extracts (
    study    text primary key not null references results (study),
    format   integer not null,                  -- of the document; raised when it gets other fields
    document text not null,                     -- JSON
    sha256   text not null                      -- of study, format and document
) strict;
