using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Mixes and soft edges for the colouring of bodies.</summary>
    internal static class Tint
    {
        /// <summary>Scale that makes the fraction of a hash look random.</summary>
        private const float k_GrainScale = 9173.7f;

        private static readonly float3 s_GrainWaves = new float3(37.1f, 71.3f, 53.9f);

        /// <summary>Mixes two colours; share 0 gives the first, 1 the second.</summary>
        public static Color32 Mix(Color32 from, Color32 to, float share) =>
            new Color32(Mix(from.r, to.r, share), Mix(from.g, to.g, share), Mix(from.b, to.b, share), Mix(from.a, to.a, share));

        /// <summary>Soft step down: 1 where the value is below the limit, 0 above it, over the given width.</summary>
        public static float Below(float value, float limit, float softness) => math.saturate(0.5f + (limit - value) / softness);

        /// <summary>Soft ball: 1 inside, 0 outside, over the given width.</summary>
        public static float Spot(Vector3 place, Vector3 centre, float radius, float softness) =>
            Below((place - centre).magnitude, radius, softness);

        /// <summary>Pseudo-random value from 0 to 1 by place, repeatable: for the mottling of skins and the shades of hairs.</summary>
        public static float Grain(Vector3 place)
        {
            float wave = math.sin(math.dot((float3)place, s_GrainWaves));
            return math.abs(k_GrainScale * wave % 1f);
        }

        private static byte Mix(byte from, byte to, float share) => (byte)Math.Round(from + (to - from) * math.saturate(share));
    }
}
