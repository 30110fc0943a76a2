using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>
    /// A baked insect: its surface, its wings, and loops that say where each vertex is at each frame. <see cref="InsectBaker"/> makes one;
    /// writers, crowds and textures are made from it.
    /// </summary>
    public sealed class InsectBake
    {
        /// <summary>Name of the insect.</summary>
        public string Name { get; internal set; }

        /// <summary>The surface at rest.</summary>
        public BakedSurface Surface { get; internal set; }

        /// <summary>The wings, in the order of the insect's list.</summary>
        public IReadOnlyList<BakedWing> Wings { get; internal set; }

        /// <summary>Abdomens that swing.</summary>
        public IReadOnlyList<BakedAbdomen> Abdomens { get; internal set; }

        /// <summary>The clips.</summary>
        public IReadOnlyList<BakedClip> Clips { get; internal set; }

        /// <summary>Metres of a unit of the insect's space.</summary>
        public float MetresPerUnit { get; internal set; }

        /// <summary>Length of the longest wing, units of the insect's space; errors are shares of it.</summary>
        public float WingLength { get; internal set; }

        /// <summary>Joints of all wings and, behind them, of the abdomens.</summary>
        public int JointCount { get; internal set; }

        /// <summary>Frames of all clips.</summary>
        public int FrameCount
        {
            get
            {
                int count = 0;
                foreach (BakedClip clip in Clips)
                    count += clip.Frames.Count;
                return count;
            }
        }

        /// <summary>Bounds of the insect over all frames of all clips.</summary>
        public Bounds Bounds
        {
            get
            {
                float3 min = float.PositiveInfinity, max = float.NegativeInfinity;
                foreach (BakedClip clip in Clips)
                {
                    foreach (BakedFrame frame in clip.Frames)
                    {
                        foreach (float3 position in frame.Positions)
                        {
                            min = math.min(min, position);
                            max = math.max(max, position);
                        }
                    }
                }

                var bounds = new Bounds();
                bounds.SetMinMax(min, max);
                return bounds;
            }
        }
    }
}
