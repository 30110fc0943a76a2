using Unity.Mathematics;

namespace Alate
{
    /// <summary>The counts of a rig that working memory depends on.</summary>
    internal struct RigSize
    {
        public int joints;
        public int bones;
        public int patches;
        public int strips;
        public int bandBlocks;

        /// <summary>Reads the counts of one rig.</summary>
        public static RigSize Of(in RigView rig) => new RigSize
        {
            joints = rig.jointCount,
            bones = rig.boneCount,
            patches = rig.patchCount,
            strips = rig.stripCount,
            bandBlocks = rig.BandBlocks,
        };

        /// <summary>Larger of the counts of two rigs, one by one.</summary>
        public static RigSize Max(in RigSize a, in RigSize b) => new RigSize
        {
            joints = math.max(a.joints, b.joints),
            bones = math.max(a.bones, b.bones),
            patches = math.max(a.patches, b.patches),
            strips = math.max(a.strips, b.strips),
            bandBlocks = math.max(a.bandBlocks, b.bandBlocks),
        };
    }
}
