using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Order in which the vertices are skinned: cell by cell, four at a time.</summary>
    internal sealed class SkinLayout
    {
        /// <summary>[cell] Run of quads.</summary>
        public readonly SkinCell[] cells;

        /// <summary>[quad] Every vertex once, those of no triangle too; a cell's last vertex may be repeated.</summary>
        public readonly SkinQuad[] quads;

        /// <summary>[quad] Tangents beside <see cref="quads"/>; null when the mesh has none.</summary>
        public readonly SkinTangentQuad[] tangents;

        /// <summary>Largest distance of a vertex from the place between its joints that its weights name, mesh units.</summary>
        public readonly float reach;

        /// <param name="rest">The skeleton at rest.</param>
        /// <param name="frame">Of the wing, in the mesh.</param>
        /// <param name="points">[vertex] In its cell.</param>
        /// <param name="surface">The mesh.</param>
        /// <param name="normals">[vertex] Mesh space.</param>
        /// <param name="smaller">Number of the first vertices that a smaller mesh consists of; 0 where there is none.</param>
        public SkinLayout(
            RestSkeleton rest, in WingFrame frame, CellPoint[] points, SurfaceMesh surface, float3[] normals, int smaller)
        {
            int cellCount = rest.CellCount;
            int[] order = new int[points.Length];
            int[] ranks = CellPoint.Ranks(points, cellCount, out int[] starts);
            for (int vertex = 0; vertex < order.Length; vertex++)
                order[ranks[vertex]] = vertex;
            cells = new SkinCell[cellCount];
            int quadCount = 0;
            for (int cell = 0; cell < cellCount; cell++)
            {
                cells[cell] = new SkinCell { firstQuad = quadCount, quadCount = (starts[cell + 1] - starts[cell] + 3) / 4 };
                quadCount += cells[cell].quadCount;
            }

            // Within a cell the vertices keep their order, so that those of the smaller mesh are its first.
            for (int cell = 0; cell < cellCount; cell++)
            {
                int count = 0;
                while (count < starts[cell + 1] - starts[cell] && (smaller == 0 || order[starts[cell] + count] < smaller))
                    count++;
                cells[cell].smallerQuads = (count + 3) / 4;
            }

            bool hasTangents = surface.tangents != null && surface.tangents.Length > 0;
            quads = new SkinQuad[quadCount];
            tangents = hasTangents ? new SkinTangentQuad[quadCount] : null;
            for (int cell = 0; cell < cellCount; cell++)
            {
                for (int lane = 0; lane < 4 * cells[cell].quadCount; lane++)
                {
                    int vertex = order[math.min(starts[cell] + lane, starts[cell + 1] - 1)];
                    int quad = cells[cell].firstQuad + lane / 4;
                    Set(ref quads[quad], lane % 4, vertex, points[vertex], surface.positions[vertex], normals[vertex]);
                    if (hasTangents)
                        Set(ref tangents[quad], lane % 4, surface.tangents[vertex]);
                }
            }

            for (int vertex = 0; vertex < points.Length; vertex++)
                reach = math.max(reach, math.distance(surface.positions[vertex], frame.ToMesh(Named(rest, points[vertex]))));
        }

        // Place between the joints, wing frame.
        private static float3 Named(RestSkeleton rest, CellPoint point)
        {
            int inner = rest.FirstJoint(point.cell), behind = inner + rest.jointsPerChain;
            return math.lerp(
                math.lerp(rest.joints[inner], rest.joints[inner + 1], point.v),
                math.lerp(rest.joints[behind], rest.joints[behind + 1], point.v), point.u);
        }

        private static void Set(ref SkinQuad quad, int lane, int vertex, CellPoint at, float3 position, float3 normal)
        {
            quad.u[lane] = at.u;
            quad.v[lane] = at.v;
            quad.px[lane] = position.x;
            quad.py[lane] = position.y;
            quad.pz[lane] = position.z;
            quad.nx[lane] = normal.x;
            quad.ny[lane] = normal.y;
            quad.nz[lane] = normal.z;
            quad.target[lane] = vertex;
        }

        private static void Set(ref SkinTangentQuad quad, int lane, Vector4 tangent)
        {
            quad.tx[lane] = tangent.x;
            quad.ty[lane] = tangent.y;
            quad.tz[lane] = tangent.z;
            quad.tw[lane] = tangent.w;
        }
    }
}
