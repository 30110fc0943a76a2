using System;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>The joints of a skeleton with complete chains, seen from above the wing; mesh units, relative to the hinge.</summary>
    internal sealed class SkeletonPlan
    {
        private readonly PlanPoint[] m_Points;
        private readonly double[] m_Heights;

        /// <param name="skeleton">All its chains have the same number of finite joints.</param>
        /// <param name="axes">Columns: span, up, cross(span, up).</param>
        public SkeletonPlan(WingSkeleton skeleton, float3x3 axes)
        {
            ChainCount = skeleton.ChainCount;
            JointsPerChain = skeleton.JointsPerChain;
            m_Points = new PlanPoint[ChainCount * JointsPerChain];
            m_Heights = new double[m_Points.Length];
            Vector3 hinge = skeleton.Hinge;
            for (int i = 0; i < ChainCount; i++)
            {
                for (int j = 0; j < JointsPerChain; j++)
                {
                    Vector3 p = skeleton.GetJoint(i, j);
                    double x = (double)p.x - hinge.x, y = (double)p.y - hinge.y, z = (double)p.z - hinge.z;
                    m_Points[i * JointsPerChain + j] = new PlanPoint(Along(axes.c0, x, y, z), Along(axes.c2, x, y, z));
                    m_Heights[i * JointsPerChain + j] = Along(axes.c1, x, y, z);
                }
            }

            Measure();
        }

        public int ChainCount { get; }

        public int JointsPerChain { get; }

        /// <summary>Largest extent of the joints along any of the three axes.</summary>
        public double Size { get; private set; }

        /// <summary>Extent of the joints along the up axis.</summary>
        public double HeightExtent { get; private set; }

        public PlanPoint this[int chain, int joint] => m_Points[chain * JointsPerChain + joint];

        /// <summary>Squared distance of two joints in space, by joint index.</summary>
        public double DistanceSquared(int a, int b)
        {
            double height = m_Heights[a] - m_Heights[b];
            return (m_Points[a] - m_Points[b]).LengthSquared + height * height;
        }

        /// <summary>Sum of the signed areas of the strips between the chains; negative if chain 0 lies towards cross(span, up).</summary>
        public double SignedArea()
        {
            double area = 0.0;
            for (int i = 0; i + 1 < ChainCount; i++)
                area += StripArea(i);
            return area;
        }

        /// <summary>Signed area of the polygon out along chain i and back along chain i + 1.</summary>
        public double StripArea(int chain)
        {
            var corners = new PlanPoint[2 * JointsPerChain];
            for (int j = 0; j < JointsPerChain; j++)
            {
                corners[j] = this[chain, j];
                corners[corners.Length - 1 - j] = this[chain + 1, j];
            }

            return Polygon.Area(corners);
        }

        private static double Along(float3 axis, double x, double y, double z) => axis.x * x + axis.y * y + axis.z * z;

        private void Measure()
        {
            double lowX = double.MaxValue, lowY = double.MaxValue, lowZ = double.MaxValue;
            double highX = double.MinValue, highY = double.MinValue, highZ = double.MinValue;
            for (int k = 0; k < m_Points.Length; k++)
            {
                lowX = Math.Min(lowX, m_Points[k].x);
                highX = Math.Max(highX, m_Points[k].x);
                lowY = Math.Min(lowY, m_Heights[k]);
                highY = Math.Max(highY, m_Heights[k]);
                lowZ = Math.Min(lowZ, m_Points[k].z);
                highZ = Math.Max(highZ, m_Points[k].z);
            }

            HeightExtent = highY - lowY;
            Size = Math.Max(highX - lowX, Math.Max(HeightExtent, highZ - lowZ));
        }
    }
}
