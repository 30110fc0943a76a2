using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Texture with the joints' transforms of all wings that the graphics card deforms: dual quaternions, two texels a joint, one block a
    /// mesh. Its upper half holds those of the last picture, where motion vectors are wanted. 32 bytes a joint, 64 with motion.
    /// </summary>
    internal sealed class SkinTable : IDisposable, IJointMemory
    {
        /// <summary>Texels in a row; the shader counts with the same number.</summary>
        public const int Width = 1024;

        /// <summary>Most texels: those that a float counts one by one.</summary>
        private const int k_MostTexels = 1 << 24;

        private const int k_TexelsOfAJoint = 2, k_JointsInARow = Width / k_TexelsOfAJoint, k_LeastRows = 8;

        private readonly Dictionary<int, Stack<int>> m_Free = new Dictionary<int, Stack<int>>();
        private readonly int m_MostRows;
        private int m_Rows = k_LeastRows, m_End, m_Movers;
        private bool m_IsWritten, m_WasWritten;

        /// <param name="largestTexture">Largest side of a texture on the device, pixels.</param>
        public SkinTable(int largestTexture) => m_MostRows = math.min(largestTexture, k_MostTexels / Width);

        /// <summary>The texture; null before the first block is taken.</summary>
        public Texture2D Texture { get; private set; }

        /// <inheritdoc/>
        public NativeArray<float4> Texels => Texture == null ? default : Texture.GetPixelData<float4>(0);

        /// <summary>Texels from a transform to that of the last picture; 0 where motion vectors are not wanted.</summary>
        public int Last => m_Movers > 0 ? m_Rows * Width : 0;

        /// <summary>Number that changes whenever <see cref="Texture"/> or <see cref="Last"/> do.</summary>
        public int Version { get; private set; }

        /// <summary>Joints in use.</summary>
        public int Joints { get; private set; }

        /// <summary>Takes a block of joints, at rest.</summary>
        /// <param name="joints">How many.</param>
        /// <param name="moves">Whether those of the last picture are wanted too.</param>
        /// <param name="start">The first joint.</param>
        /// <returns>False where the texture cannot hold them.</returns>
        public bool TryTake(int joints, bool moves, out int start)
        {
            bool isFreed = m_Free.TryGetValue(joints, out Stack<int> freed) && freed.Count > 0;
            start = isFreed ? freed.Peek() : m_End;
            int rows = m_Rows, movers = m_Movers + (moves ? 1 : 0), parts = movers > 0 ? 2 : 1;
            while (start + joints > rows * k_JointsInARow && rows * parts < m_MostRows)
                rows *= 2;
            if (start + joints > rows * k_JointsInARow || rows * parts > m_MostRows)
                return false;
            if (isFreed)
                freed.Pop();
            else
                m_End += joints;
            m_Movers = movers;
            Joints += joints;
            Reserve(rows, parts);
            Rest(start, joints);
            return true;
        }

        /// <summary>
        /// Makes room for joints that will be taken soon, so that the texture is made once for all of them; does nothing where it cannot
        /// hold them.
        /// </summary>
        public void Expect(int joints)
        {
            int rows = m_Rows, parts = m_Movers > 0 ? 2 : 1;
            while (m_End + joints > rows * k_JointsInARow && rows * parts < m_MostRows)
                rows *= 2;
            if (Texture != null && rows * parts <= m_MostRows)
                Reserve(rows, parts);
        }

        /// <summary>Gives a block back.</summary>
        public void Return(int start, int joints, bool moves)
        {
            if (!m_Free.TryGetValue(joints, out Stack<int> freed))
                m_Free.Add(joints, freed = new Stack<int>());
            freed.Push(start);
            Joints -= joints;
            m_Movers -= moves ? 1 : 0;
        }

        /// <summary>Begins a picture: what the last one showed is the past.</summary>
        public void Begin()
        {
            m_WasWritten = m_IsWritten;
            m_IsWritten = false;
            if (Texture == null)
                return;

            // Not before: materials show the texture until they are refreshed at the end of a picture.
            if (m_Movers == 0)
                Reserve(m_Rows, 1);
            NativeArray<float4> texels = Texture.GetPixelData<float4>(0);
            if (m_WasWritten && Last > 0)
                NativeArray<float4>.Copy(texels, 0, texels, Last, m_End * k_TexelsOfAJoint);
        }

        /// <summary>Notes that transforms were written for this picture.</summary>
        public void MarkWritten() => m_IsWritten = true;

        /// <summary>Takes the past from a block that was written: the last picture has not shown what it moves on from.</summary>
        public void ForgetPast(int start, int joints)
        {
            NativeArray<float4> texels = Texels;
            int first = start * k_TexelsOfAJoint;
            NativeArray<float4>.Copy(texels, first, texels, first + Last, joints * k_TexelsOfAJoint);
        }

        /// <summary>Ends a picture: sends what changed to the graphics card.</summary>
        public void End()
        {
            if (m_IsWritten || (m_WasWritten && Last > 0))
                Texture.Apply(false);
        }

        /// <summary>Frees the texture.</summary>
        public void Dispose()
        {
            ObjectEnd.Destroy(Texture);
            Texture = null;
        }

        // Until a wing is drawn for the first time.
        private void Rest(int start, int joints)
        {
            NativeArray<float4> texels = Texture.GetPixelData<float4>(0);
            for (int texel = start * k_TexelsOfAJoint; texel < (start + joints) * k_TexelsOfAJoint; texel += k_TexelsOfAJoint)
            {
                texels[texel] = texels[texel + Last] = quaternion.identity.value;
                texels[texel + 1] = texels[texel + Last + 1] = float4.zero;
            }

            m_IsWritten = true;
        }

        private void Reserve(int rows, int parts)
        {
            if (Texture != null && Texture.height == rows * parts)
                return;
            Texture2D before = Texture;
            int joints = m_Rows * k_JointsInARow;
            m_Rows = rows;
            Texture = new Texture2D(Width, rows * parts, TextureFormat.RGBAFloat, false, true)
            {
                name = "Joints of wings",
                hideFlags = HideFlags.HideAndDontSave,
                filterMode = FilterMode.Point,
                wrapMode = TextureWrapMode.Clamp,
            };
            if (before != null)
            {
                int texels = math.min(joints, rows * k_JointsInARow) * k_TexelsOfAJoint;
                NativeArray<float4> from = before.GetPixelData<float4>(0), to = Texture.GetPixelData<float4>(0);
                NativeArray<float4>.Copy(from, 0, to, 0, texels);
                if (Last > 0)
                    NativeArray<float4>.Copy(from, 0, to, Last, texels);
                ObjectEnd.Destroy(before);
            }

            m_IsWritten = true;
            Version++;
        }
    }
}
