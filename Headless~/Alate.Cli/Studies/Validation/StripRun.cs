using System.Numerics;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// A uniform strip of measured stiffness in the wing model, without air: 1 long and a tenth wide, of three chains that carry the strip's
/// stiffness as they carry its mass.
/// </summary>
/// <param name="bones">Bones of each chain.</param>
/// <param name="substeps">Substeps of a beat.</param>
internal sealed class StripRun(int bones, int substeps)
{
    /// <summary>Damping ratio of the strips.</summary>
    public const double Damping = 0.1;

    /// <summary>First bending frequency, hertz.</summary>
    private const double k_First = 10;

    private const float k_Width = 0.1f, k_Turn = 0.02f, k_Shake = 1e-3f;
    private const int k_Chains = 3, k_Settled = 30, k_Parts = 24;
    private static readonly double s_Stiffness = Math.Pow(2 * Math.PI * k_First / BeamTheory.First, 2);

    /// <summary>Depth of the tip under the strip's own weight, over its length.</summary>
    /// <param name="weight">Times length² over the stiffness.</param>
    public double Droop(double weight)
    {
        using var world = new WingWorld();
        WingParameters parameters = Parameters(k_First);
        parameters.bendDamping = 1;
        WingHandle wing = Add(world, parameters, new float3(0, (float)(-weight * s_Stiffness), 0));
        for (int k = 0; k < 20 * substeps; k++)
            world.Step((float)(1 / (k_First * substeps)));
        return -Tip(world.Read(wing)).y;
    }

    /// <summary>Motion of the tip against the clamp that is shaken by 1 across the strip.</summary>
    /// <param name="ratio">Frequency over the first bending frequency.</param>
    public Complex Shaken(double ratio)
    {
        using var world = new WingWorld();
        double frequency = ratio * k_First, rate = 2 * Math.PI * frequency;
        WingHandle wing = Add(world, Parameters(frequency), default);
        Complex tip = default;
        for (int k = 1; k <= k_Settled * substeps; k++)
        {
            // On the clamp the strip feels its acceleration as a weight.
            double phase = 2 * Math.PI * k / substeps;
            world.SetSurroundings(
                wing, new WingSurroundings { gravity = new float3(0, (float)(k_Shake * rate * rate * Math.Cos(phase)), 0) });
            world.Step((float)(1 / (frequency * substeps)));
            if (k > (k_Settled - 1) * substeps)
                tip += 2.0 / substeps / k_Shake * Tip(world.Read(wing)).y * Complex.Exp(new Complex(0, -phase));
        }

        return tip;
    }

    /// <summary>Motion of the tip against the strip's undeformed line, whose root flaps by 1 with the beat.</summary>
    /// <inheritdoc cref="Shaken"/>
    public Complex Flapped(double ratio)
    {
        using var world = new WingWorld();
        double frequency = ratio * k_First;
        WingParameters parameters = Parameters(frequency);
        parameters.amplitude = new float3(k_Turn, 0, 0);
        WingHandle wing = Add(world, parameters, default);
        Complex tip = default, root = default;
        for (int k = 1; k <= k_Settled * substeps; k++)
        {
            world.Step((float)(1 / (frequency * substeps)));
            if (k <= (k_Settled - 1) * substeps)
                continue;
            WingReading reading = world.Read(wing);
            var back = Complex.Exp(new Complex(0, -2 * Math.PI * k / substeps));
            float3 line = math.rotate(reading.DrivenRotation(k_Chains / 2, 0), new float3(1, 0, 0));
            root += Math.Asin(line.y) * back;
            tip += (Tip(reading).y - line.y) * back;
        }

        return tip / root;
    }

    private float3 Tip(in WingReading reading) => reading.JointPosition(k_Chains / 2, bones);

    private WingParameters Parameters(double frequency)
    {
        WingParameters parameters = WingParameters.Default;
        parameters.maxFrequency = (float)frequency;
        parameters.frequencyFloor = parameters.amplitudeFloor = parameters.rootShare = 1;
        parameters.amplitude = default;
        parameters.phase = default;
        parameters.meanFlap = parameters.chordDelay = parameters.spanDelay = parameters.airDensity = 0;
        parameters.dorsalAsymmetry = 1;
        parameters.bendDamping = (float)Damping;
        parameters.jointLimit = math.PI / 2;
        parameters.stiffnessUnit = (float)s_Stiffness;
        parameters.substepsPerBeat = substeps;
        return parameters;
    }

    private WingHandle Add(WingWorld world, in WingParameters parameters, float3 gravity)
    {
        var rig = WingRig.Bake(Skeleton(), Surface(), new WingRigSettings { patchCount = WingRigSettings.CoarsePatches });
        WingHandle wing = world.Add(rig, parameters, new WingSurroundings { gravity = gravity });
        rig.Release();
        return wing;
    }

    // Of 1 N·m²: half of it in the chain in the middle, which carries half of the mass.
    private WingSkeleton Skeleton()
    {
        var chains = new JointChain[k_Chains];
        for (int i = 0; i < k_Chains; i++)
        {
            var joints = new UnityEngine.Vector3[bones + 1];
            for (int j = 0; j < joints.Length; j++)
                joints[j] = new UnityEngine.Vector3((float)j / bones, 0, -k_Width * i / (k_Chains - 1));
            chains[i] = new JointChain(joints) { flexuralStiffness = [i == 0 || i == k_Chains - 1 ? 0.25f : 0.5f] };
        }

        WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
        skeleton.Chains = chains;
        return skeleton;
    }

    private static SurfaceMesh Surface()
    {
        var positions = new UnityEngine.Vector3[3 * (k_Parts + 1)];
        int[] triangles = new int[12 * k_Parts];
        for (int k = 0; k < positions.Length; k++)
            positions[k] = new UnityEngine.Vector3((float)(k / 3) / k_Parts, 0, -k_Width * (k % 3) / 2);
        for (int k = 0; k < 2 * k_Parts; k++)
        {
            int a = k / 2 * 3 + k % 2;
            new[] { a, a + 3, a + 1, a + 3, a + 4, a + 1 }.CopyTo(triangles, 6 * k);
        }

        var normals = new UnityEngine.Vector3[positions.Length];
        Array.Fill(normals, UnityEngine.Vector3.up);
        return new SurfaceMesh { name = "Strip", positions = positions, normals = normals, triangles = triangles };
    }
}
