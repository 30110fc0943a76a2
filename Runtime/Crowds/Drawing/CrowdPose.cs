using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>One insect of a crowd: where it is and what its wings do. 56 bytes.</summary>
    public struct CrowdPose
    {
        /// <summary>Place of the insect's origin, world.</summary>
        public float3 position;

        /// <summary>Scale; 1 is the size that was baked. An insect of scale 0 is not drawn.</summary>
        public float scale;

        /// <summary>Rotation; Z ahead, Y up.</summary>
        public quaternion rotation;

        /// <summary>Phase of the loop, 0 to 1; the crowd advances it.</summary>
        public float phase;

        /// <summary>Factor on the loop's own frequency; 1.</summary>
        public float rate;

        /// <summary>Loop, from 0; a number that the insect has no loop for shows the last one.</summary>
        public int loop;

        /// <summary>Loop that it passes to.</summary>
        public int nextLoop;

        /// <summary>Share of the next loop, 0 to 1. Both play at one phase, so that their wings are at like points of the beat.</summary>
        public float blend;

        /// <summary>
        /// Colour by which the insect's own is multiplied: red, green, blue from the lowest byte, 8 bits each; 0xFFFFFF is white.
        /// </summary>
        public uint tint;

        /// <summary>An insect of its own colour and size in the first loop.</summary>
        public static CrowdPose At(float3 position, quaternion rotation, float phase = 0f) =>
            new CrowdPose { position = position, scale = 1f, rotation = rotation, phase = phase, rate = 1f, tint = 0xFFFFFF };
    }
}
