"""Recordings of bags: what two writers wrote is what a CSV file of the same numbers says, to the bit."""

from __future__ import annotations

import csv
import json
import sqlite3
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import bags
import numpy as np
import pytest
from bags import FILMS, START_NS, Message, by_another, by_rosbags
from service import BINARY

import strainsite
from strainsite.recordings import from_bag

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

STEP_NS = 5_000_000
SIGNALS = ["/films.data[0:3]"]
FORCES = {"fz_n": "/ft/wrench.wrench.force.z"}
RECIPE = '[models]\nkinds = ["ridge"]\n[features]\nsets = ["raw"]\n'


def numbers(seed: int, rows: int = 200) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """Three films of which two know the force of ten presses, and the force."""
    random = np.random.default_rng(seed)
    time = np.arange(rows) * 0.1
    fz = np.maximum(np.sin(2 * np.pi * time / 2), 0) * np.repeat(random.uniform(5, 20, rows // 20), 20)
    return np.column_stack([2 * fz, -fz, 0 * fz]) + random.normal(0, 0.2, (rows, 3)), fz


def run(seed: int, later_ns: int) -> list[Message]:
    """Messages of a run: the force comes so much later than the films."""
    films, fz = numbers(seed)
    messages = []
    for row, data in enumerate(films.tolist()):
        stamp = START_NS + row * STEP_NS
        messages += [bags.films(stamp, data), bags.wrench(stamp + later_ns, float(fz[row]))]
    return messages


def independent(path: Path, seed: int, later_ns: int) -> Path:
    """The same numbers as CSV, written with seventeen digits by nothing of the client."""
    films, fz = numbers(seed)
    rows: dict[int, dict[str, str]] = {}
    for row, data in enumerate(films.tolist()):
        cells = rows.setdefault(row * STEP_NS, {})
        cells.update({f"films_{at}": f"{number:.17g}" for at, number in enumerate(data)})
        rows.setdefault(row * STEP_NS + later_ns, {})["fz_n"] = f"{fz[row]:.17g}"
    with path.open("w", newline="") as out:
        writer = csv.DictWriter(out, ["time_s", "films_0", "films_1", "films_2", "fz_n"], restval="")
        writer.writeheader()
        writer.writerows({"time_s": f"{stamp / 1e9:.17g}", **rows[stamp]} for stamp in sorted(rows))
    return path


def learnt(folder: Path, files: Sequence[Path], recipe: str) -> bytes:
    """The model that the program learns."""
    (folder / "recipe.toml").write_text(RECIPE + recipe)
    model = folder / "model.json"
    subprocess.run(
        [BINARY, "force", "fit", folder / "recipe.toml", *files, "-o", model], check=True, capture_output=True
    )
    return model.read_bytes()


def of(bag: Path, suffix: str) -> Path:
    """The one file of a folder."""
    (found,) = bag.glob(f"*{suffix}")
    return found


WRITERS: dict[str, Callable[[Path, Sequence[Message]], Path]] = {
    "folder": by_rosbags,
    "mcap": lambda path, messages: of(by_rosbags(path, messages), ".mcap"),
    "compressed": lambda path, messages: by_rosbags(path, messages, compressed=True),
    "db3": lambda path, messages: of(by_rosbags(path, messages, "SQLITE3"), ".db3"),
    "another": lambda path, messages: by_another(path.with_suffix(".mcap"), messages),
}


@pytest.mark.parametrize("later_ns", [0, 1_234_567])
def test_bags_of_every_writer_give_the_model_of_the_csv_to_the_bit(tmp_path: Path, later_ns: int) -> None:
    files = [independent(tmp_path / f"run-{seed}.csv", seed, later_ns) for seed in (1, 2)]
    recipe = "" if later_ns == 0 else "[preprocess]\nrate_hz = 200.0\npause_s = 0.05\n"
    expected = learnt(tmp_path, files, recipe)
    texts = set()
    for name, write in WRITERS.items():
        folder = tmp_path / name
        folder.mkdir()
        of_bags = []
        for seed in (1, 2):
            recording = from_bag(write(folder / f"bag-{seed}", run(seed, later_ns)), SIGNALS, FORCES)
            assert recording.recipe == recipe
            of_bags.append(recording.to_csv(folder / f"run-{seed}.csv"))
        texts.add(tuple(path.read_text() for path in of_bags))
        if name in ("another", "db3", "mcap"):
            assert learnt(folder, of_bags, recipe) == expected, name
    assert len(texts) == 1


def test_rows_are_the_times_of_all_topics(tmp_path: Path) -> None:
    messages = [
        bags.films(START_NS, [1.0, 2.0]),
        bags.wrench(START_NS + 1_000_000, 5.0),
        bags.films(START_NS + STEP_NS, [3.0, float("nan")]),
        bags.wrench(START_NS + STEP_NS + 1, 6.0),
    ]
    found = from_bag(by_another(tmp_path / "run.mcap", messages), ["films.data"], FORCES)
    assert found.text() == "time_s,films_0,films_1,fz_n\n0.0,1.0,2.0,\n0.001,,,5.0\n0.005,3.0,,6.0\n"
    assert found.start_ns == START_NS
    assert found.has_gaps
    assert found.rate_hz == 200
    assert [(each.topic, each.clock, each.rows) for each in found.topics] == [
        ("/films", "header", 2),
        ("/ft/wrench", "header", 2),
    ]
    assert found.topics[0].delay_s == pytest.approx(300e-6)
    assert not found.notes
    assert "a recipe needs:\n    [preprocess]\n    rate_hz = 200.0" in repr(found)
    frame = found.frame()
    assert list(frame.columns) == ["time_s", "films_0", "films_1", "fz_n"]
    assert frame.attrs["bag"].endswith("run.mcap")
    assert found.to_csv(tmp_path) == tmp_path / "run.csv"


def test_cells_read_back_to_the_same_doubles(tmp_path: Path) -> None:
    numbers = [0.1 + 0.2, 1 / 3, 5e-324, -0.0, 2.0**-1074 * 3, 1.7e99, 123456789.12345678, 1e22, -1e-7]
    messages = [bags.films(START_NS + at * 1_234_567, [number]) for at, number in enumerate(numbers)]
    found = from_bag(by_another(tmp_path / "run.mcap", messages), ["/films.data[0]", "/films.small[1]"])
    rows = list(csv.DictReader(found.text().splitlines()))
    assert [float(row["films_0"]).hex() for row in rows] == [number.hex() for number in numbers]
    assert {float(row["films_small_1"]) for row in rows} == {float(np.float32(0.2))}
    assert [float(row["time_s"]) for row in rows] == [at * 1_234_567 / 1e9 for at in range(len(numbers))]
    # Digits beyond those that are needed aren't written.
    assert rows[0]["films_0"] == "0.30000000000000004"


def test_infinite_numbers_are_told_before_a_file_is_written(tmp_path: Path) -> None:
    messages = [
        bags.films(START_NS + at, [number]) for at, number in ((0, 1.0), (10**7, float("inf")), (10**8, -1e101))
    ]
    found = from_bag(by_another(tmp_path / "run.mcap", messages), ["/films.data[0]"])
    with pytest.raises(strainsite.BagError, match=r"films_0 is inf at 0.01 s, and so are 1 more: .* to nan"):
        found.to_csv(tmp_path / "run.csv")
    assert not (tmp_path / "run.csv").exists()
    found.signals["films_0"][1:] = np.nan
    assert found.text() == "time_s,films_0\n0.0,1.0\n0.01,\n0.1,\n"


def test_all_faults_of_paths_are_told_at_once(tmp_path: Path) -> None:
    bag = by_rosbags(tmp_path / "bag", run(1, 0)[:4], empty="/unused")
    signals = [
        "/films",
        "/film.data",
        "/films.date[0]",
        "/films.name",
        "/films.header",
        "/films.data[0:12]",
        "/films.a b",
    ]
    signals += ["/films.small[3]", "/films.cells", "/films.data.x", "/films.data[3:3]", "/films.name[0]"]
    with pytest.raises(strainsite.BagError) as told:
        from_bag(bag, signals, {"fz_n": "/ft/wrench.wrench.force", "time": "/films.data[0]", "fx_n": "/films.data"})
    said = str(told.value)
    assert said.startswith(f"{bag} has 14 faults\n")
    for part in [
        "  /films: must be a topic, a point and a field, as ",
        "  the bag has no topic /film; it has /films (rig_msgs/msg/Films: header (std_msgs/msg/Header), name (string)",
        ", data (float64[]), small (float32[3]), cells (rig_msgs/msg/Cell[])); /ft/wrench (geometry_msgs/msg/Wrench",
        ". Did you mean /films?",
        "  /films.date[0]: has no field 'date': /films has header (std_msgs/msg/Header), name (string), data (",
        "  /films.name: is no number but string",
        "  /films.header: is no number but a message with stamp (builtin_interfaces/msg/Time), frame_id (string)",
        "  /films.a b: must be a topic, a point and a field, as ",
        ", which can't be read from ' b' on",
        "  /films.small[3]: takes element 3 of /films.small, which has 3, from 0 on",
        "  /films.cells: is no number but an array, each element a message with strain (float64), on (bool): take ",
        "  /films.data.x: takes a field of /films.data, which is an array: take an element by [0]",
        "  /films.data[3:3]: has a range without an element, [3:3]; ",
        "  /films.name[0]: goes on behind /films.name, which is string",
        "  /ft/wrench.wrench.force: is no number but a message with x (float64), y (float64), z (float64)",
        "  'time': is a name that the reader of recordings takes for the time",
        "  /films.data: leads to several numbers; a force is one of them",
    ]:
        assert part in said, part
    with pytest.raises(strainsite.BagError, match="/unused has no message"):
        from_bag(bag, ["/unused.data[0]"])
    with pytest.raises(strainsite.BagError, match=r"/films.data has 3 elements; the path takes those up to element 11"):
        from_bag(bag, ["/films.data[0:12]"])
    with pytest.raises(strainsite.BagError, match="films_0 stands twice"):
        from_bag(bag, ["/films.data[0]", "/films.data[0:2]"])
    with pytest.raises(strainsite.BagError, match="no signal is named"):
        from_bag(bag, [])
    with pytest.raises(strainsite.BagError, match="clock must be"):
        from_bag(bag, SIGNALS, clock="sensor")  # type: ignore[arg-type]


def test_arrays_that_change_their_length_are_told(tmp_path: Path) -> None:
    cells = [{"strain": 1.0, "on": True}, {"strain": 2.0, "on": False}]
    messages = [
        bags.films(START_NS, [1.0, 2.0], cells=cells),
        bags.films(START_NS + STEP_NS, [1.0, 2.0, 3.0], cells=cells),
    ]
    bag = by_another(tmp_path / "run.mcap", messages)
    with pytest.raises(strainsite.BagError) as told:
        from_bag(bag, ["/films.data[0:2]"])
    assert "/films.data has 3 elements in message 2 of the topic, and 2 before" in str(told.value)
    found = from_bag(bag, ["/films.cells[0:2].strain", "/films.cells[1].on"])
    assert {name: list(cells) for name, cells in found.signals.items()} == {
        "films_cells_0_strain": [1.0, 1.0],
        "films_cells_1_strain": [2.0, 2.0],
        "films_cells_1_on": [0.0, 0.0],
    }


def test_clocks_are_chosen_and_told(tmp_path: Path) -> None:
    zero = [bags.films(0, [float(at)], received_ns=START_NS + at * STEP_NS) for at in range(4)]
    found = from_bag(by_another(tmp_path / "zero.mcap", zero), ["/films.data"])
    assert found.topics[0].clock == "receive"
    assert found.notes == ("/films has times of receipt: all stamps of its headers are zero",)
    assert list(found.time_s) == [0.0, 0.005, 0.01, 0.015]
    with pytest.raises(strainsite.BagError, match="all stamps of its headers are zero: clock='receive'"):
        from_bag(tmp_path / "zero.mcap", ["/films.data"], clock="header")
    stamped = [bags.films(START_NS + at * STEP_NS, [float(at)], received_ns=START_NS + at * STEP_NS) for at in range(4)]
    some = from_bag(by_another(tmp_path / "some.mcap", [*zero[:1], *stamped[1:]]), ["/films.data"])
    assert some.notes == ("/films: 1 of 4 messages are left out, as their stamps are zero",)
    assert list(some.signals["films_0"]) == [1.0, 2.0, 3.0]
    loads = [bags.plain(START_NS + at * STEP_NS, 5.0, topic="/load") for at in range(4)]
    mixed = from_bag(by_another(tmp_path / "mixed.mcap", [*stamped, *loads]), ["/films.data"], {"fz_n": "/load.data"})
    assert [each.clock for each in mixed.topics] == ["header", "receive"]
    assert mixed.notes[0] == "/load has times of receipt: its messages have no header"
    assert "/films by stamps of headers, /load by times of receipt" in mixed.notes[1]
    late = [bags.wrench(START_NS + at * STEP_NS, 5.0, received_ns=START_NS + 10**9) for at in range(4)]
    apart = from_bag(by_another(tmp_path / "late.mcap", [*stamped, *late]), ["/films.data"], FORCES)
    assert "received later than their stamps say by /films 0 s, /ft/wrench 0.993 s" in apart.notes[0]
    uptime = [bags.wrench(10**9 + at, 5.0, received_ns=START_NS) for at in range(4)]
    with pytest.raises(strainsite.BagError, match="topics have no time in common: /ft/wrench from 1000000000 to "):
        from_bag(by_another(tmp_path / "uptime.mcap", [*stamped, *uptime]), ["/films.data"], FORCES)


def test_late_messages_are_put_in_order_and_repeated_stamps_left_out(tmp_path: Path) -> None:
    stamps = [0, 2, 1, 3, 3, 4]
    messages = [
        bags.films(START_NS + stamp * STEP_NS, [float(at)], received_ns=START_NS + at * STEP_NS)
        for at, stamp in enumerate(stamps)
    ]
    found = from_bag(by_another(tmp_path / "run.mcap", messages), ["/films.data"])
    assert list(found.signals["films_0"]) == [0.0, 2.0, 1.0, 3.0, 5.0]
    assert (np.diff(found.time_s) > 0).all()
    assert (found.topics[0].duplicates, found.topics[0].late) == (1, 1)
    assert found.notes == (
        "/films: 1 of 6 messages are left out, as others have their times",
        "/films: 1 of 6 messages came late and stand where their times belong",
    )
    received = from_bag(tmp_path / "run.mcap", ["/films.data"], clock="receive")
    assert list(received.signals["films_0"]) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]


def test_names_are_those_that_the_reader_takes_for_signals_and_forces(tmp_path: Path) -> None:
    topics = ["/time", "/t", "/fz", "/force", "/temp/inside"]
    random = np.random.default_rng(1)
    messages = []
    for at, numbers in enumerate(random.normal(size=(100, 6)).tolist()):
        stamp = START_NS + at * STEP_NS
        messages += [bags.plain(stamp, number, topic=topic) for topic, number in zip(topics, numbers, strict=False)]
        messages.append(bags.plain(stamp, numbers[-1], topic="/cell"))
    bag = by_rosbags(tmp_path / "bag", messages)
    found = from_bag(bag, [f"{topic}.data" for topic in topics], {"load": "/cell.data"})
    names = ["signal_time", "signal_t", "signal_fz", "signal_force", "temp_inside"]
    assert list(found.signals) == names
    assert found.recipe == '[columns]\nforces = ["load"]\n'
    columns = json.loads(learnt(tmp_path, [found.to_csv(tmp_path / "run.csv")], found.recipe))["columns"]
    assert (columns["time"], columns["signals"], columns["forces"]) == ("time_s", names, ["load"])
    named = from_bag(bag, {"inside_deg": "/temp/inside.data"}, {"fz_n": "/cell.data"})
    assert list(named.signals) == ["inside_deg"]
    assert not named.recipe
    for name in ("Fz [N]", "force", "a,b", "", "x" * 201):
        with pytest.raises(strainsite.BagError):
            from_bag(bag, {name: "/t.data"})


def test_types_that_a_bag_does_not_define_are_given(tmp_path: Path) -> None:
    bag = of(by_rosbags(tmp_path / "bag", run(1, 0)[:6], "SQLITE3"), ".db3")
    whole = from_bag(bag, SIGNALS, FORCES).text()
    # As before Iron, when bags had no definitions.
    with sqlite3.connect(bag) as database:
        database.execute("DELETE FROM message_definitions")
    database.close()
    with pytest.raises(
        strainsite.BagError, match=r"/films has the type rig_msgs/msg/Films, which the bag doesn't define"
    ):
        from_bag(bag, SIGNALS, FORCES)
    definitions = {"rig_msgs/Cell": bags.DEFINITIONS["rig_msgs/msg/Cell"], FILMS: bags.DEFINITIONS[FILMS]}
    assert from_bag(bag, SIGNALS, FORCES, definitions=definitions).text() == whole
    with pytest.raises(strainsite.BagError, match=r"message 1 of /films can't be read as rig_msgs/msg/Films"):
        from_bag(bag, SIGNALS, FORCES, definitions={FILMS: "float64[] data"})
    with pytest.raises(strainsite.BagError, match="whose definition can't be read"):
        from_bag(bag, SIGNALS, FORCES, definitions={FILMS: "float64[[ data"})


IDL = {
    "rig_msgs/msg/Films": """#include "std_msgs/msg/Header.idl"
#include "rig_msgs/msg/Cell.idl"
module rig_msgs {
  module msg {
    typedef float float__3[3];
    @verbatim (language="comment", text="Films; see https://rig.example # 1")
    struct Films {
      std_msgs::msg::Header header;
      string name;
      @unit (value="V")
      sequence<double> data;
      float__3 small;
      sequence<rig_msgs::msg::Cell> cells;
    };
  };
};
""",
    "rig_msgs/msg/Cell": "module rig_msgs { module msg { struct Cell { double strain; boolean on; }; }; };\n",
    "std_msgs/msg/Header": """#include "builtin_interfaces/msg/Time.idl"
module std_msgs { module msg { struct Header { builtin_interfaces::msg::Time stamp; string frame_id; }; }; };
""",
    "builtin_interfaces/msg/Time": """// Seconds, and what is beyond them.
module builtin_interfaces { module msg { struct Time { int32 sec; uint32 nanosec; }; }; };
""",
}


def test_two_publishers_and_definitions_in_idl_are_read(tmp_path: Path) -> None:
    messages = [bags.films(START_NS + at * STEP_NS, [float(at)]) for at in range(4)]
    rule = "=" * 80 + "\n"
    text = "".join(f"{rule}IDL: {name}\n{definition}" for name, definition in IDL.items())
    bag = bags.by_channels(tmp_path / "run.mcap", [(FILMS, "ros2idl", text)] * 2, messages)
    assert list(from_bag(bag, ["/films.data"]).signals["films_0"]) == [0.0, 1.0, 2.0, 3.0]
    channels = [(FILMS, "ros2idl", text), (bags.PLAIN, "ros2msg", bags.DEFINITIONS[bags.PLAIN])]
    with pytest.raises(strainsite.BagError, match=r"/films has messages of 2 types, rig_msgs/msg/Films, std_msgs"):
        from_bag(bags.by_channels(tmp_path / "two.mcap", channels, messages), ["/films.data"])


@pytest.mark.parametrize("writer", ["mcap", "db3", "another"])
def test_files_that_were_cut_are_told(tmp_path: Path, writer: str) -> None:
    bag = WRITERS[writer](tmp_path / "bag", run(1, 0))
    content = bag.read_bytes()
    cut = tmp_path / f"cut{bag.suffix}"
    for size in range(0, len(content), len(content) // 40):
        cut.write_bytes(content[:size])
        with pytest.raises(strainsite.BagError, match="can't be read: .* cut off|a file without a byte"):
            from_bag(cut, SIGNALS, FORCES)


def test_what_is_no_bag_is_told(tmp_path: Path) -> None:
    def told(name: str) -> str:
        with pytest.raises(strainsite.BagError) as told:
            from_bag(tmp_path / name, SIGNALS)
        return str(told.value)

    assert "isn't there; a bag is an .mcap file" in told("none.mcap")
    (tmp_path / "run.txt").write_text("x")
    assert "is no bag by its name" in told("run.txt")
    (tmp_path / "run.bag").write_text("x")
    assert "is a bag of ROS 1" in told("run.bag")
    bag = by_rosbags(tmp_path / "bag", [], empty="/films")
    assert "the bag has no message: nothing was recorded" in told("bag")
    (bag / "metadata.yaml").unlink()
    assert "is a folder without metadata.yaml" in told("bag")
    assert "or name one of its files: bag.mcap" in told("bag")
    by_rosbags(tmp_path / "open", run(1, 0)[:4], "SQLITE3")
    (tmp_path / "open" / "open.db3-wal").write_text("x")
    assert "wasn't closed: open.db3-wal has messages of it" in told("open/open.db3")


def test_a_client_learns_from_bags(client: strainsite.Client, tmp_path: Path) -> None:
    found = [from_bag(by_another(tmp_path / f"{seed}.mcap", run(seed, 0)), SIGNALS, FORCES) for seed in (1, 2)]
    estimator = client.fit_forces({"one.csv": found[0], "two.csv": found[1]}, RECIPE)
    assert [recording.file for recording in estimator.summary.recordings] == ["one.csv", "two.csv"]
    assert len(estimator.apply_rows(found[0])) == 200
    # Recordings that need no lines of a recipe have none.
    assert found[0].recipe == ""
    again = client.fit_forces([found[0].to_csv(tmp_path / "one.csv")], found[0].recipe, wait=False)
    assert again.recipe == {}
    again.cancel()


def test_without_rosbags_the_extra_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "rosbags.rosbag2", None)
    with pytest.raises(strainsite.MissingExtra, match=r"this needs rosbags: pip install 'strainsite\[bags\]'"):
        from_bag(tmp_path / "run.mcap", SIGNALS)
    code = "import strainsite, sys; print('rosbags' in sys.modules)"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert said.stdout.strip() == "False"
