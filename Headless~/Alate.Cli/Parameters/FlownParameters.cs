using System.Collections.Generic;
using System.Linq;

namespace Alate.Cli.Parameters;

/// <summary>Every number that <c>sweep</c> knows, by the names of the inspector's sliders, and those of the flight.</summary>
internal static class FlownParameters
{
    /// <summary>The sliders of a species, in the inspector's order.</summary>
    public static IReadOnlyList<FlownParameter> OfSpecies { get; } =
    [
        new("wing-length", "m", 5e-4f, 1f, s => ref s.Size.wingLength),
        new("wing-mass", "kg", 1e-9f, 1f, s => ref s.Size.wingMass),
        new("insect-mass", "kg", 1e-8f, 10f, s => ref s.Size.insectMass),
        new("fluid-density", "kg/m³", 0f, 2000f, s => ref s.Size.fluidDensity),
        new("gravity-share", "", 0f, 1f, s => ref s.Size.gravityShare),
        new("max-frequency", "Hz", 0.1f, 1000f, s => ref s.Beat.maxFrequency),
        new("max-speed", "m/s", 0.01f, 100f, s => ref s.Beat.maxSpeed),
        new("frequency-floor", "", 0f, 1f, s => ref s.Beat.frequencyFloor),
        new("amplitude-floor", "", 0f, 1f, s => ref s.Beat.amplitudeFloor),
        new("flap-range", "°", 0f, 180f, s => ref s.Beat.flapRange),
        new("feather-range", "°", 0f, 180f, s => ref s.Beat.featherRange),
        new("sweep-range", "°", 0f, 180f, s => ref s.Beat.sweepRange),
        new("flap-phase", "°", -180f, 180f, s => ref s.Beat.flapPhase),
        new("feather-phase", "°", -180f, 180f, s => ref s.Beat.featherPhase),
        new("sweep-phase", "°", -180f, 180f, s => ref s.Beat.sweepPhase),
        new("mean-flap", "°", -90f, 90f, s => ref s.Beat.meanFlap),
        new("tilt", "°", -90f, 90f, s => ref s.Beat.tilt),
        new("phase-lead", "°", -180f, 180f, s => ref s.Beat.phaseLead),
        new("chord-delay", "half beats", 0f, 2f, s => ref s.Wave.chordDelay),
        new("span-delay", "half beats", 0f, 2f, s => ref s.Wave.spanDelay),
        new("root-share", "", 0f, 1f, s => ref s.Wave.rootShare),
        new("inertia", "", 0f, 10f, s => ref s.Wave.inertia),
        new("elasticity", "", 1e-3f, 1e6f, s => ref s.Stiffness.elasticity),
        new("leading-edge", "beats", 0.01f, 100f, s => ref s.Stiffness.leadingEdge),
        new("trailing-edge", "beats", 0.01f, 100f, s => ref s.Stiffness.trailingEdge),
        new("decay", "chain lengths", 0.05f, 100f, s => ref s.Stiffness.decay),
        new("damping", "", 0f, 10f, s => ref s.Stiffness.damping),
        new("dorsal-asymmetry", "", 0.1f, 10f, s => ref s.Stiffness.dorsalAsymmetry),
        new("in-plane-factor", "", 0f, 1000f, s => ref s.Stiffness.inPlaneFactor),
        new("torsion-factor", "", 0f, 1000f, s => ref s.Stiffness.torsionFactor),
        new("joint-limit", "°", 0f, 90f, s => ref s.Stiffness.jointLimit),
        new("spring-scale", "", 0f, 1000f, s => ref s.Stiffness.springScale),
        new("anchor", "", 0f, 100f, s => ref s.Stiffness.anchor),
        new("spring-damping", "", 0f, 10f, s => ref s.Stiffness.springDamping),
        new("strongest-wind", "", 0.1f, 1000f, s => ref s.Stiffness.strongestWind),
    ];

    /// <summary>Everything: first elasticity as a factor on the species', as <c>fly</c> takes it, then the species' sliders, then the flight's numbers.</summary>
    public static IReadOnlyList<FlownParameter> All { get; } =
    [
        new("elasticity", "× the species'", 0.001, 1e6, (plan, value) => plan with { Elasticity = value }),
        .. OfSpecies.Where(parameter => parameter.Name != "elasticity"),
        new("substeps-per-beat", "", WingParameters.MinSubsteps, WingParameters.MaxSubsteps, (plan, value) => plan with { Substeps = (int)value }, isWhole: true),
        new("speed", "m/s", 0, 100, (plan, value) => plan with { Speed = value }),
        new("climb", "m/s", -100, 100, (plan, value) => plan with { Climb = value }),
        new("pitch", "°", -90, 90, (plan, value) => plan with { PitchDegrees = value }),
        new("wind", "m/s from ahead", -100, 100, (plan, value) => plan with { Wind = [0, 0, -value] }),
    ];

    /// <summary>Finds a number by its name; capitals, hyphens and underscores do not matter.</summary>
    /// <exception cref="UserException">There is none; the message lists those there are.</exception>
    public static FlownParameter Find(string name) =>
        All.FirstOrDefault(parameter => Plain(parameter.Name) == Plain(name))
        ?? throw new UserException($"There is no parameter '{name}'. Known: {string.Join(", ", All.Select(parameter => parameter.Name))}.");

    private static string Plain(string name) => string.Concat(name.Where(char.IsLetterOrDigit)).ToLowerInvariant();
}
