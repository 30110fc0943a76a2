using System.Diagnostics;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>Gathers what the shader reads of the insects of one call, and a box around them.</summary>
    [BurstCompile]
    internal struct CrowdGatherJob : IJob
    {
        // Input
        public int start;
        public int count;

        /// <summary>True where the last frame is gathered too: then each matrix is followed by that of the last frame.</summary>
        public bool moves;

        [ReadOnly] public NativeArray<int> seen;
        [ReadOnly] public NativeArray<float4> spheres;
        [ReadOnly] public NativeArray<float4x4> allMatrices;
        [ReadOnly] public NativeArray<float4> allRows;
        [ReadOnly] public NativeArray<float4> allNextRows;
        [ReadOnly] public NativeArray<float4> allTints;
        [ReadOnly] public NativeArray<float4x4> allLastMatrices;
        [ReadOnly] public NativeArray<float4> allLastRows;
        [ReadOnly] public NativeArray<float4> allLastNextRows;

        // Output
        public NativeArray<float4x4> matrices;
        public NativeArray<float4> rows;
        public NativeArray<float4> nextRows;
        public NativeArray<float4> tints;
        public NativeArray<float4> lastRows;
        public NativeArray<float4> lastNextRows;

        /// <summary>Lower and upper corner of the box, world.</summary>
        public NativeArray<float3> corners;

        /// <summary>Sets what is gathered from.</summary>
        public void From(in CrowdInstances instances)
        {
            allMatrices = instances.matrices;
            allRows = instances.rows;
            allNextRows = instances.nextRows;
            allTints = instances.tints;
            allLastMatrices = instances.lastMatrices;
            allLastRows = instances.lastRows;
            allLastNextRows = instances.lastNextRows;
        }

        /// <summary>Checks the fields before the job is run.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate()
        {
            JobFields.InRange(count, 1, moves ? matrices.Length / 2 : matrices.Length, "CrowdGatherJob.count");
            JobFields.InRange(start, 0, seen.Length - count, "CrowdGatherJob.start");
            JobFields.AtLeast(rows.Length, count, "CrowdGatherJob.rows");
            JobFields.AtLeast(nextRows.Length, count, "CrowdGatherJob.nextRows");
            JobFields.AtLeast(tints.Length, count, "CrowdGatherJob.tints");
            JobFields.AtLeast(corners.Length, 2, "CrowdGatherJob.corners");
            int last = moves ? count : 0;
            JobFields.AtLeast(lastRows.Length, last, "CrowdGatherJob.lastRows");
            JobFields.AtLeast(lastNextRows.Length, last, "CrowdGatherJob.lastNextRows");
            JobFields.AtLeast(allLastMatrices.Length, moves ? allMatrices.Length : 0, "CrowdGatherJob.allLastMatrices");
        }

        public void Execute()
        {
            float4 lower = float.PositiveInfinity, upper = float.NegativeInfinity;
            for (int k = 0; k < count; k++)
            {
                int insect = seen[start + k];
                rows[k] = allRows[insect];
                nextRows[k] = allNextRows[insect];
                tints[k] = allTints[insect];
                if (moves)
                {
                    matrices[2 * k] = allMatrices[insect];
                    matrices[2 * k + 1] = allLastMatrices[insect];
                    lastRows[k] = allLastRows[insect];
                    lastNextRows[k] = allLastNextRows[insect];
                }
                else
                {
                    matrices[k] = allMatrices[insect];
                }

                float4 sphere = spheres[insect];
                lower = math.min(lower, sphere - sphere.w);
                upper = math.max(upper, sphere + sphere.w);
            }

            corners[0] = lower.xyz;
            corners[1] = upper.xyz;
        }
    }
}
