using System.Numerics;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>
/// The air on one wing: patches of four wings, moved by their joints, against every triangle of a wing that has been skinned before.
/// </summary>
internal static unsafe class AerodynamicsComparison
{
    public static void Run(Report report, Specimen specimen, PlainRig plain, FlyingPack pack)
    {
        WingPack view = pack.Pack;
        StepScratch scratch = pack.scratch;
        var air = new PlainAerodynamics(plain, specimen.Parameters);
        Vector3 wind = PlainRig.Plain(view.surroundings->wind[0]);

        // Both see the surface that the substep carried to its end.
        PackStep.Substep(view, scratch, pack.substep);
        Surface(plain, view, scratch, out Vector3[] positions, out Vector3[] velocities);
        Vector3 ours = Force(view, scratch);
        Vector3 theirs = air.Apply(positions, velocities, wind);
        report.Check("triangles give the patches' force", (ours - theirs).Length() / theirs.Length(), 2e-2);

        Vector3 sink = default;
        double[] time = Race.Run(
            new Contestant("patches", WingPack.Lanes * view.rig.patchCount, () => sink += Force(view, scratch)),
            new Contestant("triangles", plain.triangles.Length / 3, () => sink += air.Apply(positions, velocities, wind)));
        report.Ratio(Targets.Triangle, time[0], time[1], time[1] / time[0]);
    }

    private static Vector3 Force(in WingPack pack, in StepScratch scratch)
    {
        for (int joint = 0; joint < pack.rig.jointCount; joint++)
            scratch.forces[joint] = default;
        Aerodynamics.Apply(pack, scratch);
        Vector3 force = default;
        for (int joint = 0; joint < pack.rig.jointCount; joint++)
            force += PlainRig.Plain(scratch.forces[joint][0]);
        return force;
    }

    // Vertices of the first wing and their velocities, as the joints were carried to the end of the substep.
    private static void Surface(PlainRig plain, in WingPack pack, in StepScratch scratch, out Vector3[] positions, out Vector3[] velocities)
    {
        const float h = 1e-4f;
        var now = new Matrix4x4[plain.JointCount];
        var before = new Matrix4x4[plain.JointCount];
        for (int joint = 0; joint < now.Length; joint++)
        {
            SoaFloat3x3 frame = scratch.carriedFrames[joint];
            var axes = new float3x3(frame.c0[0], frame.c1[0], frame.c2[0]);
            float3 turning = scratch.carriedTurning[joint][0];
            var rates = new float3x3(math.cross(turning, axes.c0), math.cross(turning, axes.c1), math.cross(turning, axes.c2));
            float3 position = scratch.carriedPositions[joint][0];
            float3 velocity = scratch.drivenVelocities[joint][0] - pack.drivenLags[joint][0] + pack.motions[joint].velocity[0];
            now[joint] = Transform(axes, position, plain.restJoints[joint]);
            before[joint] = Transform(axes - rates * h, position - velocity * h, plain.restJoints[joint]);
        }

        positions = new Vector3[plain.vertices.Length];
        velocities = new Vector3[plain.vertices.Length];
        PlainSkinning.Positions(plain.vertices, now, positions);
        PlainSkinning.Positions(plain.vertices, before, velocities);
        for (int v = 0; v < positions.Length; v++)
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
