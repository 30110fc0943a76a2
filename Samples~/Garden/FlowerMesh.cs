using System.Collections.Generic;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>Shapes of the garden with vertex colours: flowers, the ground, the pond.</summary>
    internal sealed class FlowerMesh
    {
        private const int k_Sides = 8;
        private const float k_StemWidth = 0.08f;

        private readonly List<Vector3> m_Positions = new List<Vector3>();
        private readonly List<Vector3> m_Normals = new List<Vector3>();
        private readonly List<Color32> m_Colours = new List<Color32>();
        private readonly List<int> m_Triangles = new List<int>();

        /// <summary>A flower whose head is at the origin and whose stem goes down from there.</summary>
        /// <param name="radius">Of the head, world units.</param>
        /// <param name="stem">Length, world units.</param>
        /// <param name="petals">Colour.</param>
        public static Mesh Flower(float radius, float stem, Color petals)
        {
            var flower = new FlowerMesh();
            flower.Stem(stem);
            for (int k = 0; k < k_Sides; k++)
                flower.Petal(360f / k_Sides * k, radius, petals);
            flower.Disc(Vector3.zero, 0.45f * radius, new Color(0.55f, 0.36f, 0.1f));
            return flower.ToMesh("Flower");
        }

        /// <summary>A round plate that looks up.</summary>
        /// <param name="radius">World units.</param>
        /// <param name="colour">Of its middle; the rim is darker.</param>
        public static Mesh Plate(float radius, Color colour)
        {
            var plate = new FlowerMesh();
            plate.Disc(Vector3.zero, radius, colour);
            return plate.ToMesh("Plate");
        }

        private void Stem(float length)
        {
            var green = new Color(0.3f, 0.5f, 0.2f);
            for (int k = 0; k < 3; k++)
            {
                Vector3 side = Quaternion.Euler(0f, 120f * k, 0f) * Vector3.forward,
                    next = Quaternion.Euler(0f, 120f * (k + 1), 0f) * Vector3.forward;
                Vector3 a = k_StemWidth * side, b = k_StemWidth * next, down = length * Vector3.down;
                Quad(a, b, b + down, a + down, (side + next).normalized, green);
            }
        }

        private void Petal(float angle, float radius, Color colour)
        {
            var turn = Quaternion.Euler(0f, angle, 0f);
            Vector3 tip = turn * new Vector3(0f, -0.12f * radius, radius), inner = turn * new Vector3(0f, -0.02f, 0.3f * radius);
            Vector3 side = turn * new Vector3(0.3f * radius, -0.05f * radius, 0.7f * radius),
                other = turn * new Vector3(-0.3f * radius, -0.05f * radius, 0.7f * radius);
            Quad(inner, other, tip, side, Vector3.up, colour);
        }

        private void Disc(Vector3 centre, float radius, Color colour)
        {
            const int corners = 24;
            int first = Add(centre, Vector3.up, colour);
            for (int k = 0; k < corners; k++)
                Add(centre + Quaternion.Euler(0f, 360f / corners * k, 0f) * new Vector3(0f, 0f, radius), Vector3.up, colour * 0.7f);
            for (int k = 0; k < corners; k++)
                m_Triangles.AddRange(new[] { first, first + 1 + k, first + 1 + (k + 1) % corners });
        }

        private void Quad(Vector3 a, Vector3 b, Vector3 c, Vector3 d, Vector3 normal, Color colour)
        {
            int first = Add(a, normal, colour * 0.8f);
            Add(b, normal, colour);
            Add(c, normal, colour);
            Add(d, normal, colour);
            m_Triangles.AddRange(new[] { first, first + 2, first + 1, first, first + 3, first + 2 });
        }

        private int Add(Vector3 position, Vector3 normal, Color colour)
        {
            m_Positions.Add(position);
            m_Normals.Add(normal);
            colour.a = 1f;
            m_Colours.Add(colour);
            return m_Positions.Count - 1;
        }

        private Mesh ToMesh(string name) => new SurfaceMesh
        {
            positions = m_Positions.ToArray(),
            normals = m_Normals.ToArray(),
            colours = m_Colours.ToArray(),
            triangles = m_Triangles.ToArray(),
        }.ToMesh(name);
    }
}
