using System.Numerics;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>The air on one wing: patches of four wings, moved by their joints, against every triangle of a wing that has been skinned before.</summary>
internal static unsafe class AerodynamicsComparison
{
    public static void Run(Report report, Specimen specimen, PlainRig plain, FlyingPack pack)
    {
        var view = pack.Pack;
        var scratch = pack.scratch;
        var air = new PlainAerodynamics(plain, specimen.Parameters);
        var wind = PlainRig.Plain(view.surroundings->wind[0]);

        // The driven pose has just been kept: nothing is carried, both see the surface of the last substep.
        PackStep.Substep(view, scratch, pack.substep);
        Surface(plain, view, pack.substep, out var positions, out var velocities);
        var ours = PlainRig.Plain(Aerodynamics.Apply(view, scratch)[0]);
        var theirs = air.Apply(positions, velocities, wind);
        report.Check("triangles give the patches' force", (ours - theirs).Length() / theirs.Length(), 2e-2);

        Vector3 sink = default;
        var time = Race.Run(
            new Contestant("patches", WingPack.Lanes * view.rig.patchCount, () => sink += PlainRig.Plain(Aerodynamics.Apply(view, scratch)[0])),
            new Contestant("triangles", plain.triangles.Length / 3, () => sink += air.Apply(positions, velocities, wind)));
        report.Ratio(Targets.Triangle, time[0], time[1], time[1] / time[0]);
    }

    // Vertices of the first wing and their velocities over the last substep.
    private static void Surface(PlainRig plain, in WingPack pack, float h, out Vector3[] positions, out Vector3[] velocities)
    {
        var now = new Matrix4x4[plain.JointCount];
        var before = new Matrix4x4[plain.JointCount];
        for (var joint = 0; joint < now.Length; joint++)
        {
            ref readonly var motion = ref pack.motions[joint];
            var axes = new float3x3(pack.pose[joint].rotation[0]);
            var rates = new float3x3(motion.rate.c0[0], motion.rate.c1[0], motion.rate.c2[0]);
            var position = pack.pose[joint].position[0];
            now[joint] = Transform(axes, position, plain.restJoints[joint]);
            before[joint] = Transform(axes - rates * h, position - motion.velocity[0] * h, plain.restJoints[joint]);
        }

        positions = new Vector3[plain.vertices.Length];
        velocities = new Vector3[plain.vertices.Length];
        PlainSkinning.Positions(plain.vertices, now, positions);
        PlainSkinning.Positions(plain.vertices, before, velocities);
        for (var v = 0; v < positions.Length; v++)
            velocities[v] = (positions[v] - velocities[v]) / h;
    }

    private static Matrix4x4 Transform(float3x3 axes, float3 position, Vector3 rest)
    {
        var matrix = new Matrix4x4(
            axes.c0.x, axes.c0.y, axes.c0.z, 0f, axes.c1.x, axes.c1.y, axes.c1.z, 0f, axes.c2.x, axes.c2.y, axes.c2.z, 0f, 0f, 0f, 0f, 1f);
        matrix.Translation = PlainRig.Plain(position) - Vector3.Transform(rest, matrix);
        return matrix;
    }
}
