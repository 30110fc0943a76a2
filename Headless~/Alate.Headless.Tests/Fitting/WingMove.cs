using System;
using Unity.Mathematics;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    /// <summary>A random rotation, mirroring, unit and position.</summary>
    internal sealed class WingMove
    {
        private readonly quaternion m_Turn;
        private readonly float m_Side;
        private readonly float3 m_Offset;

        public WingMove(int seed)
        {
            var random = new Random(seed);
            float3 axis = new float3(Next(random), Next(random), Next(random)) - 0.5f;
            m_Turn = math.normalize(new quaternion(axis.x, axis.y, axis.z, 0.1f + Next(random)));
            m_Side = random.Next(2) == 0 ? 1f : -1f;
            Scale = math.exp(12f * Next(random) - 6f);
            m_Offset = Scale * new float3(Next(random), Next(random), Next(random));
            TurnsTriangles = random.Next(2) == 0;
        }

        public float Scale { get; }

        /// <summary>True where front and back of the triangles are swapped too.</summary>
        public bool TurnsTriangles { get; }

        public Vector3 Direction(Vector3 d) => math.rotate(m_Turn, new float3(m_Side * d.x, d.y, d.z));

        public Vector3 Point(Vector3 p) => Scale * (float3)Direction(p) + m_Offset;

        public SurfaceMesh Surface(SurfaceMesh surface)
        {
            int[] triangles = (int[])surface.triangles.Clone();
            for (int k = 0; TurnsTriangles && k < triangles.Length; k += 3)
                (triangles[k], triangles[k + 1]) = (triangles[k + 1], triangles[k]);
            return new SurfaceMesh
            {
                name = surface.name,
                positions = Array.ConvertAll(surface.positions, Point),
                normals = surface.normals,
                triangles = triangles,
            };
        }

        private static float Next(Random random) => (float)random.NextDouble();
    }
}
