using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Crowds
{
    /// <summary>
    /// Draws the insects in sight, some hundreds a call: matrices straight from native memory, rows and tints by a property block.
    /// </summary>
    internal sealed class CrowdBatches
    {
        /// <summary>Insects of one call: two matrices of each fill the 64 kB that every device binds.</summary>
        public const int BatchSize = 500;

        private static readonly int s_Rows = Shader.PropertyToID("_BakeRows"), s_NextRows = Shader.PropertyToID("_BakeNextRows"),
            s_Tint = Shader.PropertyToID("_BakeTint");

        private readonly Vector4[] m_Rows = new Vector4[BatchSize], m_NextRows = new Vector4[BatchSize], m_Tints = new Vector4[BatchSize];
        private readonly MaterialPropertyBlock m_Properties = new MaterialPropertyBlock();

        /// <summary>Draw calls of the last frame.</summary>
        public int Calls { get; private set; }

        /// <summary>Triangles of the last frame.</summary>
        public long Triangles { get; private set; }

        /// <summary>Draws one frame.</summary>
        /// <param name="insect">Meshes and materials.</param>
        /// <param name="buffers">What is in sight.</param>
        /// <param name="bounds">World bounds of all of it.</param>
        /// <param name="layer">Layer of the drawn insects.</param>
        /// <param name="shadows">Whether they cast shadows.</param>
        public void Draw(BakedInsect insect, CrowdBuffers buffers, in Bounds bounds, int layer, ShadowCastingMode shadows)
        {
            Calls = 0;
            Triangles = 0;
            NativeArray<Vector4> rows = buffers.rows.Reinterpret<Vector4>(), nextRows = buffers.nextRows.Reinterpret<Vector4>(),
                tints = buffers.tints.Reinterpret<Vector4>();
            NativeArray<Matrix4x4> matrices = buffers.matrices.Reinterpret<Matrix4x4>();
            int start = 0;
            for (int size = 0; size < insect.Sizes.Count; size++)
            {
                CrowdSize drawn = insect.Sizes[size];
                int end = start + buffers.counts[size];
                Triangles += (long)drawn.triangles * (end - start);
                for (; start < end; start += BatchSize)
                {
                    int count = math.min(BatchSize, end - start);
                    NativeArray<Vector4>.Copy(rows, start, m_Rows, 0, count);
                    NativeArray<Vector4>.Copy(nextRows, start, m_NextRows, 0, count);
                    NativeArray<Vector4>.Copy(tints, start, m_Tints, 0, count);
                    m_Properties.SetVectorArray(s_Rows, m_Rows);
                    m_Properties.SetVectorArray(s_NextRows, m_NextRows);
                    m_Properties.SetVectorArray(s_Tint, m_Tints);
                    for (int part = 0; part < drawn.mesh.subMeshCount; part++)
                    {
                        var parameters = new RenderParams(insect.Materials[part])
                        {
                            worldBounds = bounds,
                            layer = layer,
                            shadowCastingMode = shadows,
                            receiveShadows = true,
                            matProps = m_Properties,
                        };
                        Graphics.RenderMeshInstanced(parameters, drawn.mesh, part, matrices, count, start);
                        Calls++;
                    }
                }

                start = end;
            }
        }
    }
}
