-- Answers of results in few characters, kept beside the results, so that lists don't read whole ones. A damaged document has none.
create index results_briefs on results (study, case when json_valid(document) then json_extract(document, '$.answer.brief') end);

-- Studies as lists show them.
create view listed_studies as
select studies.*, (
    select case when json_valid(document) then json_extract(document, '$.answer.brief') end
    from results indexed by results_briefs where study = studies.id
) as brief
from studies;
