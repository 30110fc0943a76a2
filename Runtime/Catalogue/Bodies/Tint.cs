using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Mixes and soft edges for the colouring of bodies.</summary>
    internal static class Tint
    {
        /// <summary>Mixes two colours; share 0 gives the first, 1 the second.</summary>
        public static Color32 Mix(Color32 from, Color32 to, float share) =>
            new Color32(Mix(from.r, to.r, share), Mix(from.g, to.g, share), Mix(from.b, to.b, share), Mix(from.a, to.a, share));

        /// <summary>Soft step down: 1 where the value is below the limit, 0 above it, over the given width.</summary>
        public static float Below(float value, float limit, float softness) => math.saturate(0.5f + (limit - value) / softness);

        /// <summary>Soft ball: 1 inside, 0 outside, over the given width.</summary>
        public static float Spot(Vector3 place, Vector3 centre, float radius, float softness) =>
            Below((place - centre).magnitude, radius, softness);

        private static byte Mix(byte from, byte to, float share) => (byte)Math.Round(from + (to - from) * math.saturate(share));
    }
}
