namespace Alate.Cli;

/// <summary>
/// Moments of a flight that wait for their step of the wake: a ring of two beats. Where the wake falls behind by as much, a whole beat of
/// them is left out, so that the next one has the phase that was awaited: the beat repeats. One thread adds and one takes; the owner
/// guards all but <see cref="Next"/>.
/// </summary>
internal sealed class WakeMoments
{
    private readonly int m_Beat;
    private readonly long[] m_Indices;
    private readonly float3[][] m_Places;
    private int m_First;

    /// <param name="beat">Moments of a beat.</param>
    /// <param name="places">Places of a moment.</param>
    public WakeMoments(int beat, int places)
    {
        m_Beat = beat;
        // One more than two beats: the moment that is being written.
        m_Indices = new long[2 * beat + 1];
        m_Places = [.. m_Indices.Select(_ => new float3[places])];
    }

    /// <summary>Moments that wait.</summary>
    public int Count { get; private set; }

    /// <summary>Places of the moment that <see cref="Add"/> adds; nobody reads them before.</summary>
    public float3[] Next => m_Places[(m_First + Count) % m_Places.Length];

    /// <summary>Drops all.</summary>
    public void Clear() => Count = 0;

    /// <summary>Adds a moment, whose places <see cref="Next"/> holds.</summary>
    public void Add(long index)
    {
        m_Indices[(m_First + Count) % m_Indices.Length] = index;
        Count++;
        if (Count < m_Indices.Length)
            return;
        m_First = (m_First + m_Beat) % m_Indices.Length;
        Count -= m_Beat;
    }

    /// <summary>Takes the oldest moment.</summary>
    /// <returns>False where none waits.</returns>
    public bool TryTake(float3[] places, out long index)
    {
        index = m_Indices[m_First];
        if (Count == 0)
            return false;
        Array.Copy(m_Places[m_First], places, places.Length);
        m_First = (m_First + 1) % m_Indices.Length;
        Count--;
        return true;
    }
}
