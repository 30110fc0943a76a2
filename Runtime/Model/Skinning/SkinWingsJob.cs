using System.Diagnostics;
using Unity.Burst;
using Unity.Burst.Intrinsics;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Second of the two jobs of a frame: deforms the meshes at a time within the last step; index = chunk of one wing.</summary>
    [BurstCompile]
    internal unsafe struct SkinWingsJob : IJobFor
    {
        // Input
        public ClockTimes clocks;
        [ReadOnly] public NativeArray<SkinChunk> chunks;
        [ReadOnly] public NativeArray<SkinTarget> targets;
        [ReadOnly] public NativeArray<WingPack> packs;

        // Output, besides the vertices behind the targets; each wing writes its own joints.
        public NativeArray<ChunkBounds> bounds;
        [NativeDisableParallelForRestriction] public NativeArray<float4> joints;

        /// <summary>Checks the fields before the job is scheduled over a number of chunks.</summary>
        /// <exception cref="System.ArgumentException">One is out of its range; names it, its value and the range.</exception>
        [Conditional(JobFields.Checks)]
        public void Validate(int count)
        {
            JobFields.Steps(clocks);
            JobFields.AtLeast(chunks.Length, count, "SkinWingsJob.chunks");
            JobFields.AtLeast(bounds.Length, count, "SkinWingsJob.bounds");
            for (int k = 0; k < count; k++)
            {
                SkinChunk chunk = chunks[k];
                JobFields.InRange(chunk.target, 0, targets.Length - 1, "SkinWingsJob.chunks.target");
                SkinTarget target = targets[chunk.target];
                JobFields.InRange(target.pack, 0, packs.Length - 1, "SkinWingsJob.targets.pack");
                JobFields.InRange(target.lane, 0, WingPack.Lanes - 1, "SkinWingsJob.targets.lane");
                JobFields.InRange(chunk.endQuad, 0, target.rig.quadCount, "SkinWingsJob.chunks.endQuad");
                JobFields.InRange(chunk.firstQuad, 0, chunk.endQuad, "SkinWingsJob.chunks.firstQuad");
                if (target.placed > 0)
                {
                    JobFields.AtLeast(joints.Length, 2 * (target.placed - 1 + target.rig.jointCount), "SkinWingsJob.joints");
                    continue;
                }

                if (target.palette != null)
                    continue;
                JobFields.AtLeast(target.vertices == null && target.packedVertices == null ? 0 : target.rig.vertexCount,
                    target.rig.vertexCount, "SkinWingsJob.targets.vertices");
            }
        }

        public void Execute(int index)
        {
            SkinChunk chunk = chunks[index];

            // By reference: both are hundreds of bytes.
            ref readonly SkinTarget target = ref ((SkinTarget*)targets.GetUnsafeReadOnlyPtr())[chunk.target];
            if (!target.skinned)
                return;
            ref readonly WingPack pack = ref ((WingPack*)packs.GetUnsafeReadOnlyPtr())[target.pack];
            ClockTime clock = clocks[pack.clock];
            if (!clock.IsDrawn)
                return;
            if (target.placed > 0 || target.palette != null)
            {
                DualQuaternion* own = target.placed > 0 ? (DualQuaternion*)joints.GetUnsafePtr() + target.placed - 1 : target.palette;
                SkinPalette.Evaluate(pack, target, clock.alpha, own);
                return;
            }

            DualQuaternion* palette = stackalloc DualQuaternion[target.rig.jointCount];
            SkinPalette.Evaluate(pack, target, clock.alpha, palette);
            bounds[index] = SkinQuads(target, palette, chunk.firstQuad, chunk.endQuad, true);
        }

        /// <summary>Skins a range of quads, cell by cell; with eight lanes where they are wanted and the processor has them.</summary>
        public static ChunkBounds SkinQuads(in SkinTarget target, DualQuaternion* palette, int firstQuad, int endQuad, bool eightLanes)
        {
            SoaBounds bounds = SoaBounds.Empty;
            byte* memory = stackalloc byte[EightVertices.Room];
            EightVertices* eight = X86.Avx2.IsAvx2Supported && eightLanes ? EightVertices.Place(memory, &bounds) : null;
            CellBlend blend = default;
            int joints = target.rig.jointsPerChain;
            for (int cell = 0; cell < target.rig.cellCount; cell++)
            {
                SkinCell range = target.rig.skinCells[cell];
                int first = math.max(range.firstQuad, firstQuad);
                int end = math.min(range.firstQuad + (target.smaller ? range.smallerQuads : range.quadCount), endQuad);
                if (first >= end)
                    continue;
                int joint = cell + cell / (joints - 1);
                blend.Set(palette[joint], palette[joint + 1], palette[joint + joints], palette[joint + joints + 1]);
                DualQuaternionSkinning.Cell(&blend, eight, target, first, end, &bounds);
            }

            if (X86.Avx2.IsAvx2Supported && eight != null)
                EightVertices.Bound(eight, &bounds);

            return new ChunkBounds
            {
                min = new float3(math.cmin(bounds.min.x), math.cmin(bounds.min.y), math.cmin(bounds.min.z)),
                max = new float3(math.cmax(bounds.max.x), math.cmax(bounds.max.y), math.cmax(bounds.max.z)),
            };
        }
    }
}
