namespace Alate.Drawing;

/// <summary>
/// Places of pictures of any proportions in rows that fill the width: those of a row are equally high, and rows are about as high as each
/// other.
/// </summary>
internal sealed class JustifiedRows
{
    private readonly (float2 Corner, float2 Size)[] m_Places;

    /// <param name="aspects">[picture] Width over height.</param>
    /// <param name="width">Of the page.</param>
    /// <param name="gap">Around each picture.</param>
    /// <param name="heightOverWidth">About the proportions of the page.</param>
    public JustifiedRows(IReadOnlyList<float> aspects, float width, float gap, float heightOverWidth)
    {
        m_Places = new (float2, float2)[aspects.Count];
        float wanted = width * math.sqrt(heightOverWidth / aspects.Sum());
        float top = gap;
        foreach ((int first, int end) in Rows(aspects, width, gap, wanted))
        {
            float height = RowHeight(aspects, first, end, width, gap), left = gap;
            for (int k = first; k < end; k++)
            {
                m_Places[k] = (new float2(left, top), new float2(aspects[k] * height, height));
                left += aspects[k] * height + gap;
            }

            top += height + gap;
        }

        Height = top;
    }

    /// <summary>Of the page.</summary>
    public float Height { get; }

    /// <summary>Upper left corner and size of a picture.</summary>
    public (float2 Corner, float2 Size) this[int picture] => m_Places[picture];

    // The rows whose heights are off by the least in the mean of their squares, found from the last picture on.
    private static IEnumerable<(int First, int End)> Rows(IReadOnlyList<float> aspects, float width, float gap, float wanted)
    {
        float[] least = new float[aspects.Count + 1];
        int[] ends = new int[aspects.Count];
        for (int first = aspects.Count - 1; first >= 0; first--)
        {
            least[first] = float.PositiveInfinity;
            for (int end = first + 1; end <= aspects.Count; end++)
            {
                float height = RowHeight(aspects, first, end, width, gap);
                if (height <= 0f)
                    break;
                float off = math.log(height / wanted), sum = off * off + least[end];
                if (sum < least[first])
                    (least[first], ends[first]) = (sum, end);
            }
        }

        for (int first = 0; first < aspects.Count; first = ends[first])
            yield return (first, ends[first]);
    }

    private static float RowHeight(IReadOnlyList<float> aspects, int first, int end, float width, float gap)
    {
        float sum = 0f;
        for (int k = first; k < end; k++)
            sum += aspects[k];
        return (width - (end - first + 1) * gap) / sum;
    }
}
