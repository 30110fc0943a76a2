using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Way of each vertex since the last picture, for motion vectors: written before the vertices, which still hold the last picture.
    /// Computes positions a second time, so that the loop over vertices is the same with and without.
    /// </summary>
    internal static unsafe class Displacements
    {
        /// <summary>Writes the displacements of the quads of one cell from <paramref name="first"/> up to <paramref name="end"/>.</summary>
        public static void Cell(CellBlend* blend, in SkinTarget target, int first, int end)
        {
            for (SkinQuad* quad = target.rig.skinQuads + first; quad < target.rig.skinQuads + end; quad++)
            {
                var displacement = new SoaFloat3(float3.zero);
                if (target.displaces)
                    displacement = DualQuaternionSkinning.Position(blend, quad) - Last(target, quad->target);
                uint4 xy = VertexDisplacement.PackXY(displacement), z = VertexDisplacement.PackZ(displacement);
                target.displacements[quad->target.x] = new VertexDisplacement { xy = xy.x, z = z.x };
                target.displacements[quad->target.y] = new VertexDisplacement { xy = xy.y, z = z.y };
                target.displacements[quad->target.z] = new VertexDisplacement { xy = xy.z, z = z.z };
                target.displacements[quad->target.w] = new VertexDisplacement { xy = xy.w, z = z.w };
            }
        }

        // A position and what follows it are read at once.
        private static SoaFloat3 Last(in SkinTarget target, int4 vertex)
        {
            float4x4 rows = target.packedVertices != null
                ? new float4x4(
                    *(float4*)(target.packedVertices + vertex.x), *(float4*)(target.packedVertices + vertex.y),
                    *(float4*)(target.packedVertices + vertex.z), *(float4*)(target.packedVertices + vertex.w))
                : new float4x4(
                    *(float4*)(target.vertices + vertex.x), *(float4*)(target.vertices + vertex.y),
                    *(float4*)(target.vertices + vertex.z), *(float4*)(target.vertices + vertex.w));
            float4x4 columns = math.transpose(rows);
            return new SoaFloat3(columns.c0, columns.c1, columns.c2);
        }
    }
}
