"""Makes recordings of virtual soft sensors: runs of signals and forces as CSV files, from a seed.

python virtual_recordings.py FAMILY FOLDER [--runs 3] [--seed 1]

| family | signals | forces | what is hard |
|---|---|---|---|
| press | 15 magnetometer channels, uT, irregular clock of some 10 Hz | fz_n, 0-34 N | sessions differ, hysteresis |
| shear | 30 magnetometer channels, uT, 20 Hz | fx_n, fy_n, fz_n | forces partly independent |
| fingers | 2 motor positions, deg, 2 wire lengths, mm, 30 Hz | fx_n, fy_n, fz_n | signals don't tell all |
| tire | 12 piezo films, mV, 200 Hz | fx_n, fy_n, fz_n, stances at 0.8-5 Hz | films forget (high-pass) |

A seed makes one sensor. Its runs are sessions of their own: offsets, gains, drift and movements differ. Run 2 is the
same whether or not run 3 is asked for.
"""

import argparse
import pathlib
from dataclasses import dataclass

import numpy as np


@dataclass
class Recording:
    time_s: np.ndarray
    # Rows x channels.
    signals: np.ndarray
    # By column; NaN where the force wasn't measured.
    forces: dict


# What sessions and materials do.


def wander(rng, time_s, fastest_hz, columns=1):
    """Smooth random courses of variance 1, one a column: eight sines of random frequencies and phases."""
    frequency = fastest_hz * rng.uniform(0.05, 1.0, (8, columns))
    phase = rng.uniform(0.0, 2.0 * np.pi, (8, columns))
    return np.sin(2.0 * np.pi * frequency * time_s[:, None, None] + phase).sum(axis=1) / 2.0


def overstress(time_s, strain, branches):
    """Sum of Prony branches, each a share g of the strain that relaxes with its time tau."""
    step = np.diff(time_s, prepend=time_s[0])
    rise = np.diff(strain, axis=0, prepend=strain[:1])
    total = np.zeros_like(strain)
    for share, tau in branches:
        decay = np.exp(-step / tau)
        branch = np.zeros_like(strain[0])
        for k in range(len(strain)):
            # The mean of the decay over the step, at which the rise has come evenly.
            branch = decay[k] * branch + share * rise[k] * np.exp(-0.5 * step[k] / tau)
            total[k] += branch
    return total


def measured(rng, time_s, clean, *, offset, gain, drift, noise, digit):
    """What a session's electronics make of clean signals: gains, offsets, drift, noise and digits."""
    channels = clean.shape[1]
    gains = 1.0 + gain * rng.standard_normal(channels)
    begin = time_s[0]
    share = (time_s - begin) / (time_s[-1] - begin)
    trend = share[:, None] * rng.standard_normal(channels) + 0.3 * wander(rng, time_s, 0.02, channels)
    signals = gains * clean + offset * rng.standard_normal(channels) + drift * trend
    signals += noise * rng.standard_normal(clean.shape)
    return np.round(signals / digit) * digit


def ramp(share):
    """From 0 to 1, smoothly."""
    share = np.clip(share, 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)


def presses(rng, time_s, deepest):
    """Depth over time with rests between presses, the number of each row's press and whether it rests."""
    depth, number = np.zeros_like(time_s), np.zeros(len(time_s), dtype=int)
    now, count = time_s[0] + rng.uniform(1.0, 2.0), 0
    while now < time_s[-1]:
        down, hold, up = rng.uniform(0.3, 1.5), rng.uniform(0.2, 1.5), rng.uniform(0.3, 1.2)
        peak = deepest * rng.uniform(0.15, 1.0)
        depth += peak * (ramp((time_s - now) / down) - ramp((time_s - now - down - hold) / up))
        number[time_s >= now] = count
        now += down + hold + up + rng.uniform(0.4, 1.2)
        count += 1
    return depth, number, count


# A soft skin with magnets above magnetometers.


@dataclass
class Skin:
    # Places of the chips, mm.
    chips: np.ndarray
    # Fields of the magnets at rest, uT, and their heights above the chips, mm.
    rest: np.ndarray
    height: np.ndarray
    # How each chip is turned.
    turns: np.ndarray
    # Width of a dent, mm.
    width: float

    @classmethod
    def made(cls, rng, chips):
        count = len(chips)
        turns = np.linalg.qr(np.eye(3) + 0.1 * rng.standard_normal((count, 3, 3)))[0]
        turns *= np.sign(np.diagonal(turns, axis1=1, axis2=2))[:, None, :]
        rest = 300.0 * rng.uniform(0.8, 1.2, count)
        return cls(chips + 0.3 * rng.standard_normal(chips.shape), rest, rng.uniform(9.0, 10.5, count), turns, 9.0)

    def fields(self, place, depth, sideways):
        """Change of the field in uT, rows x (3 for each chip), of a dent at a place that is dragged sideways, mm."""
        away = self.chips[None] - place[:, None]
        dent = np.exp(-0.5 * (away**2).sum(axis=2) / self.width**2)
        down = depth[:, None] * dent
        # Magnets beside the dent lean towards it.
        aside = sideways[:, None] * dent[..., None] - 0.5 * down[..., None] * away / self.width
        nearer = self.height / (self.height - down)
        level = 1.5 * self.rest[None, :, None] * (aside / self.height[None, :, None]) * nearer[..., None] ** 4
        field = np.concatenate([level, (self.rest * (nearer**3 - 1.0))[..., None]], axis=2)
        return np.einsum("tci,cji->tcj", field, self.turns).reshape(len(depth), -1)


def skin_signals(rng, time_s, clean):
    """Magnetometers' readings, uT."""
    return measured(rng, time_s, clean, offset=12.0, gain=0.03, drift=2.0, noise=2.0, digit=0.1)


SKIN_BRANCHES = ((0.25, 0.4), (0.15, 4.0))


def press(sensor, rng):
    """Presses of a square skin at seven places; the force meter reads two rows in three."""
    chips = 8.0 * np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]])
    skin = Skin.made(sensor, chips)
    places = sensor.uniform(-8.0, 8.0, (7, 2))
    stiffness = sensor.uniform(0.9, 1.1, 7)
    rows = 930
    # Most intervals are 0.072 s; one in ten is a good deal longer.
    late = rng.random(rows) < 0.1
    step = 0.072 * np.exp(0.06 * rng.standard_normal(rows)) + late * rng.uniform(0.15, 0.5, rows)
    time_s = np.round(np.cumsum(step), 4)
    depth, number, count = presses(rng, time_s, 2.6)
    of_press = rng.integers(0, len(places), count)
    spot = places[of_press] + 0.4 * rng.standard_normal((count, 2)) + 0.4 * rng.standard_normal(2)
    clean = skin.fields(spot[number], depth, np.zeros((rows, 2)))
    stiffer = stiffness[of_press][number] * (1.0 + 0.03 * rng.standard_normal())
    elastic = (5.0 * depth + 0.8 * depth**3) * stiffer
    force = np.maximum(elastic + overstress(time_s, elastic, SKIN_BRANCHES), 0.0)
    force += 0.05 * rng.standard_normal(rows)
    # Rows that the force meter missed, and the end of the run, which it didn't record.
    force[(rng.random(rows) < 0.3) | (time_s > time_s[-1] - 5.0)] = np.nan
    return Recording(time_s, skin_signals(rng, time_s, clean), {"fz_n": np.round(force, 3)})


def shear(sensor, rng):
    """Presses that are dragged sideways, partly with the press and partly on their own."""
    chips = np.array([[x, y] for x in (-10.0, -5.0, 0.0, 5.0, 10.0) for y in (-4.0, 4.0)])
    skin = Skin.made(sensor, chips)
    lean = 0.3 * sensor.standard_normal(2)
    time_s = np.round(np.cumsum(0.05 + 0.001 * rng.standard_normal(1500)), 4)
    depth, number, count = presses(rng, time_s, 2.6)
    spot = 5.0 * rng.uniform(-1.0, 1.0, (count, 2)) * [1.5, 0.5] + 0.3 * rng.standard_normal(2)
    # Friction holds sideways movement up to about the depth.
    pull = np.tanh(0.7 * wander(rng, time_s, 0.8, 2) + lean)
    sideways = 0.8 * depth[:, None] * pull
    clean = skin.fields(spot[number], depth, sideways)
    stiffness = 1.0 + 0.03 * rng.standard_normal()
    along = 4.0 * stiffness * sideways * (1.0 + 0.1 * depth[:, None])
    down = stiffness * (4.0 * depth + 0.5 * depth**3)
    forces = np.column_stack([along, down])
    forces += overstress(time_s, forces, SKIN_BRANCHES)
    # A skin that recovers more slowly than the presser rises lets it go.
    forces[forces[:, 2] < 0.0] = 0.0
    forces += 0.05 * rng.standard_normal(forces.shape)
    return Recording(time_s, skin_signals(rng, time_s, clean), force_columns(forces))


# Fingers that are pulled by wires.


def fingers(sensor, rng):
    """Two fingers grip what isn't always in the same place: forces across depend on what no signal tells."""
    radius = sensor.uniform(7.0, 9.0, 2)
    yielding = sensor.uniform(0.04, 0.08, 2)
    time_s = np.round(np.arange(2100) / 30.0, 4)
    angle = 35.0 + 18.0 * wander(rng, time_s, 0.7, 1) + 9.0 * wander(rng, time_s, 1.2, 2)
    # Where the object is and how it is turned: of the run, and changing.
    meets = 30.0 + 4.0 * rng.standard_normal(2) + 3.0 * wander(rng, time_s, 0.2, 2)
    turned = 0.4 * rng.standard_normal() + 0.8 * wander(rng, time_s, 0.5, 1)[:, 0]
    closing = np.logaddexp(0.0, (angle - meets) / 3.0) * 0.45
    grip = np.maximum(closing + overstress(time_s, closing, ((0.3, 0.5),)), 0.0)
    down = grip.sum(axis=1)
    along = 0.6 * (grip[:, 0] - grip[:, 1]) + 0.25 * down * turned
    across = 0.12 * down * np.tanh(wander(rng, time_s, 1.0, 1)[:, 0] + 0.8 * rng.standard_normal())
    forces = np.column_stack([along, across, down]) + 0.05 * rng.standard_normal((len(time_s), 3))
    # Wires stretch with what the fingers grip and with how fast they are pulled.
    speed = np.gradient(angle, time_s, axis=0)
    wires = np.deg2rad(angle) * radius - yielding * grip - 0.001 * speed
    motors = measured(rng, time_s, angle, offset=0.5, gain=0.005, drift=0.1, noise=0.1, digit=0.088)
    lengths = measured(rng, time_s, wires, offset=0.1, gain=0.01, drift=0.05, noise=0.03, digit=0.01)
    return Recording(time_s, np.column_stack([motors, lengths]), force_columns(forces))


# A foot tire with piezo films around.


def tire(sensor, rng):
    """Stances at angles and paces of their own; films forget with a time constant of a second or two."""
    films = np.deg2rad(30.0) * np.arange(12) + 0.03 * sensor.standard_normal(12)
    sizes = sensor.uniform(0.85, 1.15, 12)
    time_constant = sensor.uniform(1.0, 2.0, 12)
    # Glued left and right of the crown in turn.
    side = np.tile([0.7, -0.7], 6)
    crooked = 0.15 * sensor.standard_normal((12, 3))
    time_s = np.round(np.arange(6000) / 200.0, 4)
    angle, forces = np.zeros_like(time_s), np.zeros((len(time_s), 3))
    now = rng.uniform(0.3, 0.6)
    while now < time_s[-1]:
        pace = np.exp(rng.uniform(np.log(0.8), np.log(5.0)))
        stance = 0.6 / pace
        share = (time_s - now) / stance
        on = (share >= 0.0) & (share < 1.0)
        load = rng.uniform(4.0, 19.0) * np.sin(np.pi * share[on]) ** rng.uniform(0.7, 1.3)
        # Within friction; the tire rolls a little while it stands.
        held, turning = rng.uniform(-0.4, 0.4, 2), rng.uniform(-0.2, 0.2, 2)
        sideways = held + turning * np.cos(np.pi * share[on])[:, None]
        forces[on] = np.column_stack([load[:, None] * sideways, load])
        angle[on] = rng.uniform(0.0, 2.0 * np.pi) + rng.uniform(-0.3, 0.3) * share[on]
        now += 1.0 / pace
    away = np.angle(np.exp(1j * (angle[:, None] - films)))
    fx, fy, fz = (forces[:, [axis]] for axis in range(3))
    # The contact grows with the load, and bends the wall outwards beside it.
    patch = 0.30 + 0.04 * np.sqrt(fz + 1e-12)
    near = np.exp(-0.5 * (away / patch) ** 2)
    beside = np.exp(-0.5 * ((np.abs(away) - 0.7) / 0.3) ** 2)
    strain = fz / (1.0 + 0.015 * fz) * (near - 0.4 * beside) * (1.0 + crooked[:, 2])
    strain = strain + fx * (2.0 * away / patch * near + crooked[:, 0] * near) + fy * near * (side + crooked[:, 1])
    strain = 20.0 * sizes * (strain + overstress(time_s, strain, ((0.2, 0.1),)))
    voltage = np.zeros_like(strain)
    keep = np.exp(-1.0 / (200.0 * time_constant))
    for k in range(1, len(strain)):
        voltage[k] = keep * voltage[k - 1] + strain[k] - strain[k - 1]
    signals = measured(rng, time_s, voltage, offset=2.0, gain=0.03, drift=1.0, noise=1.5, digit=0.1)
    return Recording(time_s, signals, force_columns(forces + 0.05 * rng.standard_normal(forces.shape)))


# Files.


def force_columns(forces):
    """Columns of three forces, N, as a force meter gives them."""
    return {name: np.round(forces[:, axis], 3) for axis, name in enumerate(("fx_n", "fy_n", "fz_n"))}


FAMILIES = {family.__name__: family for family in (press, shear, fingers, tire)}


def recording(family, seed, run):
    """A run (from 1) of a seed's sensor."""
    number = list(FAMILIES).index(family)
    return FAMILIES[family](np.random.default_rng([seed, number]), np.random.default_rng([seed, number, run]))


def cell(number):
    """The fewest digits that read back bit for bit; nothing for what wasn't measured."""
    return "" if np.isnan(number) else repr(float(number))


def write(made, file):
    """Writes a recording."""
    signals = [f"s{channel + 1}" for channel in range(made.signals.shape[1])]
    # Multiples of a digit have many decimals; readings have few.
    rows = np.column_stack([made.time_s, np.round(made.signals, 4), *made.forces.values()])
    lines = [["time_s", *signals, *made.forces], *([cell(x) for x in row] for row in rows)]
    file.write_text("".join(",".join(line) + "\n" for line in lines))


def write_runs(family, seed, runs, folder):
    """Writes so many runs and names their files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{family}-{seed}-run{run}.csv" for run in range(1, runs + 1)]
    for run, file in enumerate(files, 1):
        write(recording(family, seed, run), file)
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("family", choices=FAMILIES)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    for file in write_runs(arguments.family, arguments.seed, arguments.runs, arguments.folder):
        print(file)


if __name__ == "__main__":
    main()
