using Unity.Mathematics;

namespace Alate
{
    /// <summary>Box around a wing that a graphics card deforms: around its joints, and as far beyond them as its vertices reach.</summary>
    internal static unsafe class PaletteBounds
    {
        /// <summary>
        /// Share of the wing length by which a blend of transforms may lie off the place between the joints; in winds from all sides no
        /// vertex of any species lay farther out than joints and reach.
        /// </summary>
        private const float k_Bulge = 0.01f;

        /// <summary>Box around the vertices of a wing, mesh space.</summary>
        /// <param name="rig">Its rig.</param>
        /// <param name="frame">Its frame.</param>
        /// <param name="palette">[jointCount] Transforms of its joints.</param>
        public static ChunkBounds Of(in RigView rig, in WingFrame frame, DualQuaternion* palette)
        {
            float3 least = float.PositiveInfinity, most = float.NegativeInfinity;
            for (int joint = 0; joint < rig.jointCount; joint++)
            {
                float3 place = palette[joint].Move(frame.ToMesh(rig.restJoints[joint]));
                least = math.min(least, place);
                most = math.max(most, place);
            }

            float margin = rig.skinReach + k_Bulge * frame.length;
            return new ChunkBounds { min = least - margin, max = most + margin };
        }
    }
}
