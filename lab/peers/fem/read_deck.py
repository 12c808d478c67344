"""Reads what the other programs need from the deck: mesh, supports, surfaces, rubber, loads."""

from dataclasses import dataclass

import numpy as np

# Corners of the two faces along the third direction, by the label of the face in the deck.
FACES = {1: [0, 1, 2, 3], 2: [4, 5, 6, 7]}


@dataclass
class Deck:
    nodes: np.ndarray
    bricks: np.ndarray
    # Nodes held along each axis.
    held: list
    # Corners of the faces under pressure, and of those that may touch the ground.
    pressure_faces: np.ndarray
    tread_faces: np.ndarray
    c10: float
    c01: float
    d1: float
    pressure: float
    penalty: float
    # Height at which the ground is parked, and its way up from there.
    parked: float
    rise: float


def blocks(text):
    """Keyword lines with the numbers and words of the lines below each."""
    found = []
    for line in text.splitlines():
        if line.startswith("*"):
            found.append((line.replace(" ", ""), []))
        else:
            found[-1][1].append([word.strip() for word in line.split(",")])
    return found


def read_deck(file):
    """The deck in a file, with nodes and elements counted from 0."""
    with open(file) as source:
        # Supports and supported ground have the same keyword: the first is the tire's.
        by_keyword = dict(reversed(blocks(source.read())))

    def numbers(keyword):
        return np.array(by_keyword[keyword], dtype=float)

    bricks = numbers("*ELEMENT,TYPE=C3D8R,ELSET=WALL")[:, 1:].astype(int) - 1
    held = numbers("*BOUNDARY")
    inner = numbers("*ELSET,ELSET=PRESSURE1")[:, 0].astype(int) - 1
    tread = [int(element) - 1 for element, _ in by_keyword["*SURFACE,NAME=TREAD,TYPE=ELEMENT"]]
    c10, c01, d1 = numbers("*HYPERELASTIC,MOONEY-RIVLIN")[0]
    ground = numbers("*NODE,NSET=GROUND")
    return Deck(
        nodes=numbers("*NODE,NSET=TIRE")[:, 1:],
        bricks=bricks,
        held=[held[held[:, 1] == axis + 1, 0].astype(int) - 1 for axis in range(3)],
        pressure_faces=bricks[inner][:, FACES[1]],
        tread_faces=bricks[tread][:, FACES[2]],
        c10=c10,
        c01=c01,
        d1=d1,
        pressure=float(by_keyword["*DLOAD,AMPLITUDE=INFLATE"][0][2]),
        penalty=numbers("*SURFACEBEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR")[0, 0],
        parked=ground[:, 3].max(),
        rise=float(by_keyword["*BOUNDARY,AMPLITUDE=RISE"][0][3]),
    )
