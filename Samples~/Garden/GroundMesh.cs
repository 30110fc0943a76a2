using UnityEngine;

namespace Alate.Samples
{
    /// <summary>The ground of the garden: a meadow with a bank down to the bottom of the pond around it, and the pond's water.</summary>
    internal static class GroundMesh
    {
        private const int k_Corners = 48, k_FarCorners = 90, k_Tufts = 1800, k_Blades = 4;

        private static readonly Color s_Grass = new Color(0.34f, 0.48f, 0.19f), s_Dry = new Color(0.58f, 0.6f, 0.3f),
            s_Earth = new Color(0.34f, 0.27f, 0.18f), s_Bottom = new Color(0.3f, 0.3f, 0.22f),
            s_Far = new Color(0.36f, 0.5f, 0.34f), s_Haze = new Color(0.62f, 0.72f, 0.74f);

        /// <summary>Ground that is flat up to its bank, and the bottom of the pond.</summary>
        /// <param name="radius">Of what is flat, world units.</param>
        /// <param name="pondRadius">World units.</param>
        /// <param name="depth">Of the pond, world units.</param>
        public static Mesh Ground(float radius, float pondRadius, float depth)
        {
            var ground = new GardenShape();
            int before = ground.Ring(Vector3.zero, 0.01f, k_Corners, s_Grass);
            (float radius, float depth, Color colour)[] rings =
            {
                (0.35f * radius, 0f, Color.Lerp(s_Grass, s_Dry, 0.2f)), (0.7f * radius, 0f, s_Grass), (radius, 0f, s_Grass),
                (radius + 0.4f, 0.25f, s_Earth), (radius + 2f, 0.5f * depth, s_Earth * 0.8f), (radius + 6f, depth, s_Bottom),
                (pondRadius, depth, s_Bottom),
            };
            foreach ((float radius, float depth, Color colour) ring in rings)
            {
                int next = ground.Ring(ring.depth * Vector3.down, ring.radius, k_Corners, ring.colour);
                ground.Join(before, next, k_Corners + 1);
                before = next;
            }

            return ground.ToMesh("Ground");
        }

        /// <summary>The surface of the water, which is seen through.</summary>
        /// <param name="radius">Of the ground that it surrounds, world units.</param>
        /// <param name="pondRadius">World units.</param>
        public static Mesh Water(float radius, float pondRadius)
        {
            var water = new GardenShape();
            int shore = water.Ring(Vector3.zero, radius, k_Corners, new Color(0.5f, 0.68f, 0.72f, 0.3f)),
                deep = water.Ring(Vector3.zero, 1.8f * radius, k_Corners, new Color(0.46f, 0.62f, 0.7f, 0.65f)),
                end = water.Ring(Vector3.zero, pondRadius, k_Corners, new Color(0.68f, 0.78f, 0.86f, 1f));
            water.Join(shore, deep, k_Corners + 1);
            water.Join(deep, end, k_Corners + 1);
            return water.ToMesh("Water");
        }

        /// <summary>The far shore of the pond, with hills behind it.</summary>
        /// <param name="radius">Of the shore, world units.</param>
        /// <param name="seed">Each number makes other hills, always the same.</param>
        public static Mesh Shore(float radius, int seed)
        {
            var random = new System.Random(seed);
            var shore = new GardenShape();
            (float away, float height, Color colour)[] rings =
            {
                (-2f, -1f, s_Earth), (1f, 0.5f, s_Dry), (14f, 1.5f, s_Grass), (16f, 4.5f, s_Far * 0.7f), (30f, 6f, s_Far),
                (60f, 12f, Color.Lerp(s_Far, s_Haze, 0.6f)),
            };
            int before = 0;
            for (int ring = 0; ring < rings.Length; ring++)
            {
                int first = 0;
                for (int k = 0; k <= k_FarCorners; k++)
                {
                    // The last corner lies on the first one.
                    float height = rings[ring].height * (ring < 2 ? 1f : Mathf.Lerp(0.6f, 1.3f, (float)random.NextDouble()));
                    Vector3 way = Quaternion.Euler(0f, 360f / k_FarCorners * k, 0f) * Vector3.forward;
                    Vector3 place = k == k_FarCorners ? shore[first] : (radius + rings[ring].away) * way + height * Vector3.up;
                    int next = shore.Add(place, rings[ring].colour);
                    first = k == 0 ? next : first;
                }

                if (ring > 0)
                    shore.Join(before, first, k_FarCorners + 1);
                before = first;
            }

            return shore.ToMesh("Shore");
        }

        /// <summary>Grass in tufts.</summary>
        /// <param name="radius">Of the ground it grows on, world units.</param>
        /// <param name="seed">Each number grows other tufts, always the same.</param>
        public static Mesh Grass(float radius, int seed)
        {
            var random = new System.Random(seed);
            float Between(float least, float most) => Mathf.Lerp(least, most, (float)random.NextDouble());

            var grass = new GardenShape();
            for (int k = 0; k < k_Tufts; k++)
            {
                Vector3 place = Quaternion.Euler(0f, Between(0f, 360f), 0f) * new Vector3(0f, 0f, radius * Mathf.Sqrt(Between(0f, 1f)));
                for (int blade = 0; blade < k_Blades; blade++)
                {
                    var turn = Quaternion.Euler(0f, Between(0f, 360f), 0f);
                    Blade(grass, place, turn, Between(0.35f, 1.1f), Between(0.1f, 0.6f), Color.Lerp(s_Grass, s_Dry, Between(0f, 0.8f)));
                }
            }

            return grass.ToMesh("Grass");
        }

        private static void Blade(GardenShape grass, Vector3 place, Quaternion turn, float height, float lean, Color colour)
        {
            const float halfWidth = 0.035f;
            int foot = grass.Add(place + turn * new Vector3(-halfWidth, 0f, 0f), colour * 0.55f);
            grass.Add(place + turn * new Vector3(halfWidth, 0f, 0f), colour * 0.55f);
            int middle = grass.Add(place + turn * new Vector3(-0.7f * halfWidth, 0.6f * height, 0.3f * lean), colour);
            grass.Add(place + turn * new Vector3(0.7f * halfWidth, 0.6f * height, 0.3f * lean), colour);
            int tip = grass.Add(place + turn * new Vector3(0f, height, lean), colour * 1.1f);
            grass.Join(foot, middle, 2);
            grass.Triangle(middle, tip, middle + 1);
        }
    }
}
