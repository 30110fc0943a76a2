using UnityEngine;

namespace Alate.Samples
{
    /// <summary>A flower: two rows of petals around a head, on a stem with leaves.</summary>
    internal static class FlowerMesh
    {
        private const int k_Petals = 13, k_Sides = 6, k_HeadCorners = 18;
        private const float k_StemWidth = 0.07f, k_HeadShare = 0.3f, k_Below = 0.05f;

        private static readonly Color s_Stem = new Color(0.26f, 0.42f, 0.16f), s_Leaf = new Color(0.3f, 0.5f, 0.2f),
            s_Head = new Color(0.42f, 0.26f, 0.07f), s_Pollen = new Color(0.92f, 0.7f, 0.16f);

        /// <summary>A flower whose head is at the origin, where an insect may sit, and whose stem goes down from there.</summary>
        /// <param name="radius">Of its petals, world units.</param>
        /// <param name="stem">Length, world units.</param>
        /// <param name="petals">Colour.</param>
        public static Mesh Create(float radius, float stem, Color petals)
        {
            var flower = new GardenShape();
            Stem(flower, stem);
            for (int k = 0; k < 3; k++)
                Leaf(flower, (0.2f + 0.2f * k) * stem - stem, 130f * k, 0.9f * radius);
            for (int k = 0; k < k_Petals; k++)
            {
                float angle = 360f / k_Petals * k;
                Blade(flower, angle, new Vector3(0f, -k_Below, 0.22f * radius), radius, 0.15f * radius, -0.16f * radius, petals);
                Blade(flower, angle + 180f / k_Petals, new Vector3(0f, -0.6f * k_Below, 0.2f * radius), 0.74f * radius, 0.12f * radius,
                    -0.02f * radius, Color.Lerp(petals, Color.white, 0.18f));
            }

            Head(flower, k_HeadShare * radius);
            return flower.ToMesh("Flower");
        }

        // Narrow at both ends, hollow along the middle, darker where it begins.
        private static void Blade(GardenShape shape, float angle, Vector3 from, float reach, float halfWidth, float rise, Color colour)
        {
            const int rows = 6;
            var turn = Quaternion.Euler(0f, angle, 0f);
            int before = 0;
            for (int k = 0; k < rows; k++)
            {
                float along = k / (rows - 1f), width = halfWidth * Mathf.Pow(Mathf.Sin(Mathf.PI * (0.12f + 0.83f * along)), 0.7f);
                float height = from.y + 0.25f * halfWidth * Mathf.Sin(Mathf.PI * along) + rise * along * along;
                float ahead = Mathf.Lerp(from.z, reach, along);
                var shade = Color.Lerp(colour * 0.6f, colour, Mathf.Min(1f, 1.6f * along));
                int row = shape.Add(turn * new Vector3(-width, height + 0.3f * width, ahead), shade);
                shape.Add(turn * new Vector3(0f, height, ahead), shade * 0.86f);
                shape.Add(turn * new Vector3(width, height + 0.3f * width, ahead), shade);
                if (k > 0)
                    shape.Join(before, row, 3);
                before = row;
            }
        }

        private static void Leaf(GardenShape shape, float height, float angle, float reach) =>
            Blade(shape, angle, new Vector3(0f, height, 0.4f * k_StemWidth), reach, 0.2f * reach, 0.35f * reach, s_Leaf);

        private static void Stem(GardenShape shape, float length)
        {
            const int rows = 4;
            int above = 0;
            for (int k = 0; k < rows; k++)
            {
                float down = k / (rows - 1f);
                int ring = shape.Ring((k_Below + down * (length - k_Below)) * Vector3.down, k_StemWidth * (0.8f + 0.4f * down), k_Sides,
                    Color.Lerp(s_Leaf, s_Stem, down));
                if (k > 0)
                    shape.Join(above, ring, k_Sides + 1);
                above = ring;
            }
        }

        // A dome whose highest point is the origin, with rings of pollen.
        private static void Head(GardenShape shape, float radius)
        {
            const int rings = 5;
            int middle = shape.Add(Vector3.zero, s_Head), inner = middle;
            for (int k = 1; k <= rings; k++)
            {
                float share = k / (float)rings;
                int ring = shape.Ring(0.5f * radius * share * share * Vector3.down, radius * share, k_HeadCorners,
                    k == rings ? s_Head * 0.7f : k % 2 == 0 ? s_Pollen : s_Head);
                if (k == 1)
                {
                    for (int corner = 0; corner < k_HeadCorners; corner++)
                        shape.Triangle(middle, ring + corner, ring + corner + 1);
                }
                else
                {
                    shape.Join(inner, ring, k_HeadCorners + 1);
                }

                inner = ring;
            }
        }
    }
}
