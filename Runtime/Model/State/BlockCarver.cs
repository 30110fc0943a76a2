using Unity.Collections.LowLevel.Unsafe;

namespace Alate
{
    /// <summary>Hands out consecutive arrays of one block, each on a cache line; without a block it only adds up their size.</summary>
    internal unsafe struct BlockCarver
    {
        private const long k_Alignment = 64;

        private readonly byte* m_Block;

        /// <summary>Bytes handed out so far.</summary>
        public long Size { get; private set; }

        /// <summary>Begins at the start of a block; null only measures.</summary>
        public BlockCarver(byte* block)
        {
            m_Block = block;
            Size = 0;
        }

        /// <summary>Takes the next <paramref name="count"/> elements of the block; null while measuring.</summary>
        public void* Carve<T>(int count) where T : unmanaged
        {
            byte* start = m_Block == null ? null : m_Block + Size;
            long bytes = (long)count * UnsafeUtility.SizeOf<T>();
            Size += (bytes + k_Alignment - 1) / k_Alignment * k_Alignment;
            return start;
        }
    }
}
