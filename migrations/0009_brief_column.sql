-- Short answers in a column: an index over JSON read each document again whenever a result was written, copied or checked.
drop view listed_studies;
drop index results_briefs;
alter table results add column brief text;     -- of the document's answer; null where it has none
update results set brief = case when json_valid(document) then json_extract(document, '$.answer.brief') end;
create index results_briefs on results (study, brief);

-- Studies as lists show them, for which no document is read.
create view listed_studies as
select studies.*, (select brief from results indexed by results_briefs where study = studies.id) as brief
from studies;
