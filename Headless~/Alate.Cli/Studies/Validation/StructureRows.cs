using System.Numerics;

namespace Alate.Cli;

/// <summary>
/// Comparisons of the structure alone: strips without air beside beam theory, and the stiffness of the catalogue's wings beside measured
/// ones.
/// </summary>
internal static class StructureRows
{
    private const int k_Bones = 4, k_MoreBones = 8;
    private const double k_Beam = 0.03, k_Motion = 0.05, k_Phase = 5;
    private const string k_Ours = "ours: theory has no spread";
    private const string k_Elastica = "beam theory, Euler's elastica under its own weight";
    private const string k_Moving = "closed form of the Euler–Bernoulli beam on a base that moves across it and turns, damped by its "
        + "strain rate: the problem of Erturk and Inman 2008, J. Vib. Acoust. 130:041002, without piezoelectric layers";
    private static readonly double[] s_Droops = [0.002, 0.01, 0.05, 0.2, 0.5];

    /// <summary>Strips that droop, at five loads and with more bones.</summary>
    public static IEnumerable<ValidationRow> Droops(Fineness fineness, Action done)
    {
        foreach (double load in s_Droops)
            yield return Droop(k_Bones, load, fineness);
        yield return Droop(k_MoreBones, s_Droops[^1], fineness);
        done();
    }

    /// <summary>Strips on a clamp that is shaken, and strips that flap, below and above their first resonance.</summary>
    public static IEnumerable<ValidationRow> Motions(Fineness fineness, Action done)
    {
        foreach (double ratio in new[] { 0.5, 1, 1.5, 2 })
        {
            Complex beam = BeamTheory.Shaken(ratio, StripRun.Damping);
            Complex ours = new StripRun(k_Bones, fineness.Substeps).Shaken(ratio),
                fine = new StripRun(k_Bones, fineness.Fine).Shaken(ratio);
            foreach (ValidationRow row in Motion(
                FormattableString.Invariant($"strip of {k_Bones} bones, root shaken at {ratio} of its first frequency"), "shake",
                beam, ours, fine))
            {
                yield return row;
            }
        }

        foreach (double ratio in new[] { 0.2, 0.5, 1, 1.5 })
        {
            Complex beam = BeamTheory.Turned(ratio, StripRun.Damping);
            Complex ours = new StripRun(k_Bones, fineness.Substeps).Flapped(ratio),
                fine = new StripRun(k_Bones, fineness.Fine).Flapped(ratio);
            foreach (ValidationRow row in Motion(
                FormattableString.Invariant($"strip of {k_Bones} bones, flapping at {ratio} of its first frequency"), "stroke",
                beam, ours, fine))
            {
                yield return row;
            }
        }

        done();
    }

    /// <summary>Stiffness of the catalogue's insects, which the factors of their presets make.</summary>
    public static IEnumerable<ValidationRow> Insects(Fineness fineness, Action done)
    {
        foreach (InsectDefinition insect in InsectCatalogue.All.Where(insect => insect.Name != "snailfish"))
        {
            (string wing, WingStiffness stiffness) = Stiffness(insect, fineness.Substeps);
            (_, WingStiffness fine) = Stiffness(insect, fineness.Fine);
            yield return new ValidationRow(
                $"{insect.Name}, {wing}", "flexural stiffness EI of all chains over that of measured wings of its span",
                double.NegativeInfinity, double.PositiveInfinity,
                FormattableString.Invariant($"measured: 1, that is {stiffness.Usual:0.0e-0} N·m²"),
                "", "Combes and Daniel 2003, J. exp. Biol. 206:2979, a line through 16 species",
                stiffness.Whole / stiffness.Usual, fine.Whole / fine.Usual)
            {
                Reason = "the scatter of the 16 species is not at hand; the preset's stiffness is chosen so that the wing bends as filmed "
                    + "ones do, and follows the beat, not the span",
            };
        }

        done();
    }

    // Of the main wing; joints do not know the substep, and both finenesses have the same.
    private static (string Wing, WingStiffness Stiffness) Stiffness(InsectDefinition insect, int substeps)
    {
        var plan = new FlightPlan { Species = insect.Name, Substeps = substeps };
        using var wings = new TetheredWings(plan, Insect.Of(plan));
        return (wings.All[0].Wing.Name, wings.All[0].Stiffness);
    }

    private static ValidationRow Droop(int bones, double load, Fineness fineness)
    {
        double weight = 8 * load, beam = 100 * BeamTheory.Droop(weight);
        return new ValidationRow(
            FormattableString.Invariant($"strip of {bones} bones under a weight of {weight:0.###} EI/L²"),
            "droop of the tip, % of the length",
            (1 - k_Beam) * beam, (1 + k_Beam) * beam, FormattableString.Invariant($"theory: {beam:0.000}"), k_Ours, k_Elastica,
            100 * new StripRun(bones, fineness.Substeps).Droop(weight),
            100 * new StripRun(bones, fineness.Fine).Droop(weight))
        {
            Table = ValidationTable.Strips,
        };
    }

    internal static IEnumerable<ValidationRow> Motion(string title, string moved, Complex beam, Complex ours, Complex fine)
    {
        double size = 100 * beam.Magnitude, phase = Degrees(beam);
        yield return new ValidationRow(
            title, $"motion of the tip, % of the {moved}", (1 - k_Motion) * size, (1 + k_Motion) * size,
            FormattableString.Invariant($"theory: {size:0.00}"), k_Ours, k_Moving, 100 * ours.Magnitude, 100 * fine.Magnitude)
        {
            Table = ValidationTable.Strips,
        };
        yield return new ValidationRow(
            title, $"phase of the tip behind the {moved}, °", phase - k_Phase, phase + k_Phase,
            FormattableString.Invariant($"theory: {phase:0.0}"), k_Ours, k_Moving, Degrees(ours), Degrees(fine))
        {
            Table = ValidationTable.Strips,
        };
    }

    // Behind, 0 to 360.
    private static double Degrees(Complex value) => (360 - 180 / Math.PI * value.Phase) % 360;
}
