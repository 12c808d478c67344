"""A study by the client that openapi-generator generates for Python: from_openapi_generator.py URL STUDY."""

import json
import sys
import time

from openapi_client import AnswersApi, ApiClient, ChangedSceneDocument, Configuration, ServiceApi, StudiesApi, StudyDocument, StudyDocumentScene

url, document = sys.argv[1], json.loads(sys.argv[2])
body = StudyDocument.from_dict(document)
# from_dict sends null for what isn't named and may be null, as a preset's carcass, which takes it away; what is made by name isn't sent.
body.scene = StudyDocumentScene(ChangedSceneDocument(**document["scene"]))
with ApiClient(Configuration(host=url)) as client:
    studies, answers = StudiesApi(client), AnswersApi(client)
    study = studies.submit(body)
    while (state := studies.show(study.id).state) != "done":
        assert state in ("queued", "running"), state
        time.sleep(0.05)
    assert answers.whole(study.id).study.id == study.id
    assert answers.locations(study.id).locations[0].rank == 1
    assert answers.layouts(study.id)
    assert answers.surface(study.id)[:4]
    assert answers.export(study.id, format="csv").startswith(b"location,")
    assert b"# EOF" in ServiceApi(client).metrics()
