"""Makes an insect file of a paper's numbers, flies it, and draws how its lift depends on the flap.

    python3 own_wing.py [PICTURE]

The numbers are those of the hawkmoth of the manual, Manduca sexta: Willmott and Ellington 1997, J. exp. Biol. 200,
2705-2722, male M1, with the wing length of Liu et al. 1998, J. exp. Biol. 201, 461-477. Write those of your paper
in their place; what a file may say stands on the manual's page Insect files.
"""

import json
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import alate

INSECT = {
    "version": 1,
    "name": "paper",
    "like": "monarch",
    "massMilligrams": 1579,
    "beat": {
        "frequencyHertz": 26.1,
        "flapRangeDegrees": 114.6,
        "featherRangeDegrees": 100,
        "sweepRangeDegrees": 0,
        "tiltDegrees": 35,
    },
    "wings": {"wing": {"lengthMillimetres": 48.3, "massMilligrams": 47}},
    "sources": [{"quantity": "all", "value": "as written", "source": "Willmott and Ellington 1997; Liu et al. 1998"}],
}

FLAPS = np.array([80.0, 90.0, 100.0, 114.6, 125.0])


def main(picture="own_wing.png"):
    lifts, powers = [], []
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "paper.insect.json"
        for flap in FLAPS:
            INSECT["beat"]["flapRangeDegrees"] = flap
            file.write_text(json.dumps(INSECT), encoding="utf-8")
            run = alate.command("fly", file, "--speed", 0, "--pitch", 40, "--no-pictures", out=Path(folder) / str(flap))
            lifts.append(run.summary["lift_over_weight"])
            powers.append(1e3 * run.summary["positive_power_w"])
            for doubt in run.summary.get("doubts", []):
                print(f"at {flap}°: {doubt}")

    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    axes.plot(FLAPS, lifts, marker="o")
    axes.axhline(1, color="grey", linewidth=0.8)
    axes.axvline(114.6, color="grey", linewidth=0.8)
    axes.set(xlabel="flap from end to end, °", ylabel="lift over weight", title="hovering; the paper's flap and the weight in grey")
    figure.savefig(picture, dpi=120)
    for flap, lift, power in zip(FLAPS, lifts, powers):
        print(f"flap {flap:5.1f}°  lift {lift:.2f} of the weight  positive power {power:.0f} mW")


if __name__ == "__main__":
    main(*sys.argv[1:])
