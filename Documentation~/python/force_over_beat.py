"""Draws force and power of an insect over its beat, and its lift over span and phase.

    python3 force_over_beat.py [SPECIES] [PICTURE]
"""

import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import alate

PITCH = 40


def main(species="monarch", picture="force_over_beat.png"):
    with tempfile.TemporaryDirectory() as folder:
        run = alate.command("fly", species, "--speed", 0, "--pitch", PITCH, "--no-pictures", out=folder)
        forces, span = run["forces"], run["spanwise"]
        over_weight = run.summary["lift_over_weight"]
    phase = forces["phase_deg"]
    order = np.argsort(phase % 360)

    figure, (loads, power, strips) = plt.subplots(3, 1, figsize=(7, 8), sharex=True, layout="constrained")
    # The table's forces are along axes of the body, whose nose is up by PITCH.
    pitch, y, z = np.radians(PITCH), forces["force_y_n"], forces["force_z_n"]
    lines = [(loads, np.cos(pitch) * y + np.sin(pitch) * z, "up"), (loads, np.cos(pitch) * z - np.sin(pitch) * y, "ahead"),
             (power, forces["power_w"], "to the air"), (power, forces["inertial_power_w"], "of the wings' own mass")]
    for axes, values, label in lines:
        axes.plot((phase % 360)[order], 1e3 * values[order], label=label)
    for axes in (loads, power):
        axes.axhline(0, color="grey", linewidth=0.5)
        axes.legend()
        axes.fill_between((phase % 360)[order], 0, 1, where=(forces["half_stroke"] == "down")[order],
                          transform=axes.get_xaxis_transform(), color="0.92")
    loads.set(ylabel="force, mN", title=f"{species}: lift {over_weight:.2f} of the weight; downstroke shaded")
    power.set(ylabel="power, mW")

    wing = span.where(wing=span["wing"][0], side="right")
    phases, places, lift = wing.grid("lift_n", "phase_deg", "span_m")
    order = np.argsort(phases % 360)
    mesh = strips.pcolormesh((phases % 360)[order], 1e3 * places, 1e3 * lift[order].T, cmap="RdBu_r", shading="nearest",
                             vmin=-1e3 * np.abs(lift).max(), vmax=1e3 * np.abs(lift).max())
    figure.colorbar(mesh, ax=strips, label="lift of a strip, mN")
    strips.set(xlabel="phase of the beat, °", ylabel=f"place along the {wing['wing'][0]}, mm")
    figure.savefig(picture, dpi=120)

    # The strips of both sides add up to the forces of the beat.
    mean = span["lift_n"].sum() / len(forces)
    print(f"mean lift {1e3 * forces['lift_n'].mean():.3f} mN; of the strips {1e3 * mean:.3f} mN; "
          f"of the line {1e3 * lines[0][1].mean():.3f} mN")


if __name__ == "__main__":
    main(*sys.argv[1:])
