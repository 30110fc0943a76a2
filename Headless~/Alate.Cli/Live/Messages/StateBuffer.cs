using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Alate.Cli;

/// <summary>Bytes of a binary message, little-endian, in an array that is kept.</summary>
internal sealed class StateBuffer
{
    private byte[] m_Bytes = new byte[1 << 16];

    /// <summary>Bytes that were added since <see cref="Clear"/>.</summary>
    public ReadOnlyMemory<byte> Content => m_Bytes.AsMemory(0, Length);

    public int Length { get; private set; }

    public void Clear() => Length = 0;

    public void Add(uint value) => Add(MemoryMarshal.AsBytes([value]));

    public void Add(float value) => Add(MemoryMarshal.AsBytes([value]));

    public void Add(double value) => Add(MemoryMarshal.AsBytes([value]));

    public void Add(float3 value) => Add(MemoryMarshal.AsBytes([value.x, value.y, value.z]));

    public void Add(ReadOnlySpan<byte> bytes) => bytes.CopyTo(Reserve(bytes.Length));

    /// <summary>Room for values that the caller writes.</summary>
    public Span<T> Add<T>(int count) where T : unmanaged => MemoryMarshal.Cast<byte, T>(Reserve(count * Unsafe.SizeOf<T>()));

    private Span<byte> Reserve(int count)
    {
        while (Length + count > m_Bytes.Length)
            Array.Resize(ref m_Bytes, 2 * m_Bytes.Length);
        Length += count;
        return m_Bytes.AsSpan(Length - count, count);
    }
}
