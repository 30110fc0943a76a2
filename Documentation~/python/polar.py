"""Draws the polar of a beating insect: mean lift over mean thrust at some pitches of the body, and what they cost.

    python3 polar.py [SPECIES] [SPEED, m/s] [PICTURE]
"""

import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import alate

# Up to 30 degrees: above, an insect beats harder.
PITCHES = np.arange(-10, 31, 8)


def main(species="monarch", speed="1", picture="polar.png"):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for pitch in PITCHES:
            run = alate.command("fly", species, "--speed", speed, "--pitch", pitch, "--no-pictures",
                                out=Path(folder) / str(pitch))
            # Against gravity, and along the flight: forces along x, y and z are in axes of the body.
            lift, thrust = run["forces"]["lift_n"].mean(), -run["forces"]["drag_n"].mean()
            summary = run.summary
            rows.append((pitch, 1e3 * lift, 1e3 * thrust, 1e3 * summary["positive_power_w"], summary["lift_over_weight"]))
    pitches, lift, thrust, power, over_weight = np.array(rows).T

    figure, (polar, cost) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    polar.plot(thrust, lift, marker="o")
    for at, x, y in zip(pitches, thrust, lift):
        polar.annotate(f"{at:.0f}°", (x, y), textcoords="offset points", xytext=(5, 4))
    polar.set(xlabel="mean thrust, mN", ylabel="mean lift, mN", title=f"{species} at {speed} m/s, by the body's pitch")
    cost.plot(over_weight, power, marker="o")
    cost.set(xlabel="lift over weight", ylabel="positive power, mW", title="what the lift costs")
    figure.savefig(picture, dpi=120)
    print("pitch °  lift mN  thrust mN  power mW  lift/weight")
    for row in rows:
        print("{:7.0f} {:8.3f} {:10.3f} {:9.2f} {:12.2f}".format(*row))


if __name__ == "__main__":
    main(*sys.argv[1:])
