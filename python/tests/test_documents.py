"""Documents before they are sent."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from conftest import STUDY
from service import ROOT

from strainsite import Client, DocumentError
from strainsite.documents import changed, from_file, steps

if TYPE_CHECKING:
    from pathlib import Path

DOCUMENT: dict[str, Any] = {"scene": {"preset": "foot-tire"}, "inputs": [{"name": "P1"}, {"name": "P2"}], "name": "a"}


def test_paths_are_read_as_the_service_reads_them() -> None:
    assert steps("scene.ground.depths_mm[0]") == ["scene", "ground", "depths_mm", 0]
    assert steps("inputs[10].distribution.truncate[1]") == ["inputs", 10, "distribution", "truncate", 1]
    for wrong in ("", ".", "a..b", "a.", "[0]", "a[x]", "a[-1]", "a b", "a[0]b", ".a", "a[1", "a.0"):
        with pytest.raises(DocumentError, match="isn't a path"):
            steps(wrong)


def test_overrides_change_a_copy_and_make_what_is_missing() -> None:
    result = changed(
        DOCUMENT,
        {
            "scene.geometry.wall_mm": np.float64(2.5),
            "inputs[1].name": "second",
            "method": {"nodes": np.int64(7)},
            "scene.ground.depths_mm": np.array([1.0, 2.0]),
            "name": None,
        },
    )
    assert result == {
        "scene": {"preset": "foot-tire", "geometry": {"wall_mm": 2.5}, "ground": {"depths_mm": [1.0, 2.0]}},
        "inputs": [{"name": "P1"}, {"name": "second"}],
        "method": {"nodes": 7},
    }
    assert json.dumps(result)
    assert DOCUMENT["inputs"][1] == {"name": "P2"}


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("inputs.name", 1, r"inputs is a list of 2; say which, as in inputs\[0\].name"),
        ("inputs[2].name", 1, r"inputs has 2 entries, counted from 0"),
        ("name.first", 1, r"name is the text 'a', which has no fields"),
        ("scene[0]", 1, r"scene is a table, not a list"),
        ("scene.ground.depths_mm[2]", 1.0, r"scene.ground.depths_mm isn't in the document; set the whole list"),
        ("scene.carcass", None, r"there is nothing to remove"),
        ("scene.pressure.internal_mpa", float("nan"), r"scene.pressure.internal_mpa is nan, which isn't a number"),
        ("inputs[0].vary", {1, 2}, r"inputs\[0\].vary is \{1, 2\} \(set\), which a document can't hold"),
    ],
)
def test_a_path_that_does_not_fit_says_why(path: str, value: object, said: str) -> None:
    with pytest.raises(DocumentError, match=said):
        changed(DOCUMENT, {path: value})


def test_all_faults_of_the_overrides_are_said_at_once() -> None:
    with pytest.raises(DocumentError) as caught:
        changed(DOCUMENT, {"name.first": 1, "inputs.name": 2})
    assert len(str(caught.value).splitlines()) == 2


def test_scene_files_are_put_in_from_beside_the_study_or_the_working_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = tmp_path / "folder" / "study.toml"
    study.parent.mkdir()
    study.write_text('name = "a"\nscene = "scenes/mine.toml"\n')
    for folder, wall in ((tmp_path, 2.0), (study.parent, 2.5)):
        (folder / "scenes").mkdir()
        (folder / "scenes/mine.toml").write_text(f"[geometry]\nwall_mm = {wall}\n")
        monkeypatch.chdir(tmp_path)
        assert from_file(study) == {"name": "a", "scene": {"geometry": {"wall_mm": wall}}}
    as_json = tmp_path / "study.JSON"
    as_json.write_text('{"name": "a", "scene": "scenes/mine.toml"}')
    assert from_file(as_json)["scene"] == {"geometry": {"wall_mm": 2.0}}


def test_files_that_can_not_be_read_are_named(tmp_path: Path) -> None:
    broken = tmp_path / "broken.toml"
    broken.write_text("name = \n")
    missing = tmp_path / "missing.toml"
    names_missing = tmp_path / "names.toml"
    names_missing.write_text('scene = "no-such-scene.toml"')
    listed = tmp_path / "list.json"
    listed.write_text("[1]")
    for path, said in (
        (broken, "broken.toml: .*line 1"),
        (missing, "missing.toml can't be read"),
        (names_missing, "no-such-scene.toml can't be read"),
        (listed, "holds a list where a table is expected"),
    ):
        with pytest.raises(DocumentError, match=said):
            from_file(path)


def test_a_study_is_the_same_as_a_file_a_name_and_a_table(client: Client) -> None:
    by_file = client.document(str(STUDY))
    assert by_file == client.document(STUDY) == client.document("foot-tire") == client.document(by_file)
    known = "foot-tire, foot-tire-paper, forces, layouts, placement"
    with pytest.raises(DocumentError, match=f"'bicycle' is neither a shipped study .*{known}"):
        client.document("bicycle")


def test_the_shipped_scene_can_be_named_as_a_file(client: Client, tmp_path: Path) -> None:
    study = tmp_path / "study.toml"
    scene = ROOT / "scenes/foot-tire.toml"
    text = STUDY.read_text().replace('scene = { preset = "foot-tire" }', f'scene = "{scene}"')
    assert str(scene) in text
    study.write_text(text)
    assert client.document(study)["scene"]["geometry"]["kind"] == "tire"
    assert client.estimate(study).solves == client.estimate("foot-tire").solves
