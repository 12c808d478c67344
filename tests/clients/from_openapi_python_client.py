"""A study by the client that openapi-python-client generates: from_openapi_python_client.py URL STUDY."""

import json
import sys
import time

from strainsite_client import Client
from strainsite_client.api.answers import layouts, locations, surface, whole
from strainsite_client.api.service import metrics
from strainsite_client.api.studies import show, submit
from strainsite_client.models import StudyDocument

url, document = sys.argv[1], json.loads(sys.argv[2])
with Client(base_url=url, raise_on_unexpected_status=True) as client:
    study = submit.sync(client=client, body=StudyDocument.from_dict(document))
    while (state := show.sync(study.id, client=client).state) != "done":
        assert state in ("queued", "running"), state
        time.sleep(0.05)
    assert whole.sync(study.id, client=client).study.id == study.id
    assert locations.sync(study.id, client=client).locations[0].rank == 1
    assert layouts.sync(study.id, client=client).to_dict()
    assert surface.sync(study.id, client=client).payload.read()[:4]
    assert b"# EOF" in metrics.sync(client=client).payload.read()
