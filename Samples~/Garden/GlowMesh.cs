using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// Glow around the lantern of a firefly: balls in one another, each clearer than the one within, that a lamp lights from inside.
    /// </summary>
    internal static class GlowMesh
    {
        private const int k_Rings = 6, k_Corners = 10;
        private static readonly Color s_Glow = new Color(0.9f, 1f, 0.45f);
        private static readonly Vector2[] s_RadiusAndOpacity =
        {
            new Vector2(0.06f, 0.85f), new Vector2(0.1f, 0.03f), new Vector2(0.16f, 0.02f), new Vector2(0.23f, 0.02f),
            new Vector2(0.32f, 0.02f),
        };

        /// <summary>A glow around the origin.</summary>
        public static Mesh Create()
        {
            var glow = new GardenShape();
            foreach (Vector2 ball in s_RadiusAndOpacity)
            {
                Color colour = s_Glow;
                colour.a = ball.y;
                int last = 0;
                for (int k = 0; k <= k_Rings; k++)
                {
                    float angle = Mathf.PI * k / k_Rings;
                    int ring = glow.Ring(ball.x * Mathf.Cos(angle) * Vector3.up, ball.x * Mathf.Sin(angle), k_Corners, colour);
                    if (k > 0)
                        glow.Join(last, ring, k_Corners + 1);
                    last = ring;
                }
            }

            return glow.ToMesh("Glow");
        }
    }
}
