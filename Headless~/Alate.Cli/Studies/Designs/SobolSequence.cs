using System.Numerics;

namespace Alate.Cli;

/// <summary>
/// Points of the Sobol sequence in Gray code order, with the direction numbers of Joe and Kuo 2008, SIAM J. Sci. Comput. 30, 2635-2654
/// (their table new-joe-kuo-6, the first 20 dimensions). The first 2^k points, the origin among them, have one coordinate of each dimension
/// in each of 2^k equal parts.
/// </summary>
internal sealed class SobolSequence
{
    /// <summary>Most dimensions.</summary>
    public const int MostDimensions = 20;

    private const int k_Bits = 32;

    // Degree and coefficients of a primitive polynomial, and odd numbers m_i below 2^i.
    private static readonly (int Degree, uint Coefficients, uint[] Numbers)[] s_Table =
    [
        (1, 0, [1]), (2, 1, [1, 3]), (3, 1, [1, 3, 1]), (3, 2, [1, 1, 1]), (4, 1, [1, 1, 3, 3]), (4, 4, [1, 3, 5, 13]),
        (5, 2, [1, 1, 5, 5, 17]), (5, 4, [1, 1, 5, 5, 5]), (5, 7, [1, 1, 7, 11, 19]), (5, 11, [1, 1, 5, 1, 1]),
        (5, 13, [1, 1, 1, 3, 11]), (5, 14, [1, 3, 5, 5, 31]), (6, 1, [1, 3, 3, 9, 7, 49]), (6, 13, [1, 1, 1, 15, 21, 21]),
        (6, 16, [1, 3, 1, 13, 27, 49]), (6, 19, [1, 1, 1, 15, 7, 5]), (6, 22, [1, 3, 1, 15, 13, 25]), (6, 25, [1, 1, 5, 5, 19, 61]),
        (7, 1, [1, 3, 7, 11, 23, 15, 103]),
    ];

    private readonly uint[][] m_Directions;
    private readonly uint[] m_Point;
    private uint m_Index;

    /// <summary>Begins at the origin.</summary>
    public SobolSequence(int dimensions)
    {
        m_Directions = Enumerable.Range(0, dimensions).Select(Directions).ToArray();
        m_Point = new uint[dimensions];
    }

    /// <summary>The next point, each coordinate from 0 to below 1.</summary>
    public double[] Next()
    {
        double[] point = Array.ConvertAll(m_Point, bits => bits / 4294967296.0);
        int changed = BitOperations.TrailingZeroCount(~m_Index++);
        for (int k = 0; k < m_Point.Length; k++)
            m_Point[k] ^= m_Directions[k][changed];
        return point;
    }

    private static uint[] Directions(int dimension)
    {
        uint[] directions = new uint[k_Bits];
        if (dimension == 0)
        {
            for (int k = 0; k < k_Bits; k++)
                directions[k] = 1u << (31 - k);
            return directions;
        }

        (int degree, uint coefficients, uint[] numbers) = s_Table[dimension - 1];
        for (int k = 0; k < k_Bits; k++)
        {
            if (k < degree)
            {
                directions[k] = numbers[k] << (31 - k);
                continue;
            }

            directions[k] = directions[k - degree] ^ (directions[k - degree] >> degree);
            for (int j = 1; j < degree; j++)
            {
                if ((coefficients >> (degree - 1 - j) & 1) != 0)
                    directions[k] ^= directions[k - j];
            }
        }

        return directions;
    }
}
