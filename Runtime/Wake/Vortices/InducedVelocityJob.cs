using System.Diagnostics;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace Alate.Wake
{
    /// <summary>Velocities that all vortex segments induce at points; index = eight points, two quartets.</summary>
    [BurstCompile]
    internal struct InducedVelocityJob : IJobFor
    {
        // Input
        [ReadOnly] public NativeArray<VortexVertex> vertices;
        public int vertexCount;
        [ReadOnly] public NativeArray<SoaFloat3> points;

        // Output; [quartet], as the points.
        [NativeDisableParallelForRestriction] public NativeArray<SoaFloat3> velocities;

        /// <summary>Checks the fields before the job is scheduled over a number of groups of eight points.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate(int count)
        {
            JobFields.InRange(vertexCount, 0, vertices.Length, "InducedVelocityJob.vertexCount");
            JobFields.AtLeast(points.Length, 2 * count, "InducedVelocityJob.points");
            JobFields.AtLeast(velocities.Length, 2 * count, "InducedVelocityJob.velocities");
        }

        public void Execute(int index)
        {
            BiotSavart.Induce(vertices, 0, vertexCount, points[2 * index], points[2 * index + 1], out SoaFloat3 low, out SoaFloat3 high);
            velocities[2 * index] = low;
            velocities[2 * index + 1] = high;
        }
    }
}
