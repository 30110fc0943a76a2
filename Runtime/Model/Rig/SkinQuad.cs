using Unity.Mathematics;

namespace Alate
{
    /// <summary>Four vertices of one cell; lane = vertex. The last quad of a cell repeats its last vertex to fill up.</summary>
    internal struct SkinQuad
    {
        /// <summary>Bilinear coordinate across the chains, 0 on the cell's forward chain.</summary>
        public float4 u;

        /// <summary>Bilinear coordinate along the chains, 0 at the cell's inner joints.</summary>
        public float4 v;

        /// <summary>Rest positions, mesh space.</summary>
        public float4 px;
        public float4 py;
        public float4 pz;

        /// <summary>Rest normals, mesh space.</summary>
        public float4 nx;
        public float4 ny;
        public float4 nz;

        /// <summary>Mesh vertex indices.</summary>
        public int4 target;
    }
}
