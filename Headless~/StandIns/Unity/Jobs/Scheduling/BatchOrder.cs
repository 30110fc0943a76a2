namespace Unity.Jobs;

/// <summary>The order in which the batches of a job are handed out.</summary>
internal readonly struct BatchOrder
{
    // Larger than any batch count can be divided by: a step of a prime visits every batch once.
    private const int k_Prime = 2147483629;

    private readonly uint m_Start;

    private BatchOrder(uint start)
    {
        m_Start = start;
    }

    public static BatchOrder Ascending => default;

    public bool IsAscending => m_Start == 0;

    /// <summary>Another order for each odd or even seed but 0.</summary>
    public static BatchOrder Shuffled(uint seed) => new(seed | 1u);

    public int Of(int position, int count)
    {
        if (m_Start == 0 || position >= count || count < 2)
            return position;
        return (int)(((ulong)(uint)position * k_Prime + m_Start) % (uint)count);
    }
}
