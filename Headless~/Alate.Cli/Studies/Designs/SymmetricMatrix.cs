namespace Alate.Cli;

/// <summary>Axes of small symmetric matrices.</summary>
internal static class SymmetricMatrix
{
    private const int k_MostSweeps = 60;

    /// <summary>Finds eigenvectors and eigenvalues by Jacobi's rotations.</summary>
    /// <param name="matrix">[row, column] Symmetric; it stays.</param>
    /// <param name="axes">[row, axis] Gets the eigenvectors, each of length 1.</param>
    /// <param name="values">[axis] Gets the eigenvalues.</param>
    public static void Diagonalize(double[,] matrix, double[,] axes, double[] values)
    {
        int n = values.Length;
        double[,] rest = (double[,])matrix.Clone();
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
                axes[i, j] = i == j ? 1 : 0;
        }

        for (int sweep = 0; sweep < k_MostSweeps; sweep++)
        {
            double off = 0, all = 0;
            for (int i = 0; i < n; i++)
            {
                all += rest[i, i] * rest[i, i];
                for (int j = 0; j < i; j++)
                    off += rest[i, j] * rest[i, j];
            }

            if (off <= 1e-32 * all)
                break;
            for (int p = 0; p < n; p++)
            {
                for (int q = p + 1; q < n; q++)
                    Rotate(rest, axes, p, q);
            }
        }

        for (int k = 0; k < n; k++)
            values[k] = rest[k, k];
    }

    // Takes the element (p, q) away.
    private static void Rotate(double[,] rest, double[,] axes, int p, int q)
    {
        if (rest[p, q] == 0)
            return;
        double slope = (rest[q, q] - rest[p, p]) / (2 * rest[p, q]);
        double tangent = (slope >= 0 ? 1 : -1) / (Math.Abs(slope) + Math.Sqrt(slope * slope + 1)),
            cosine = 1 / Math.Sqrt(tangent * tangent + 1), sine = tangent * cosine;
        for (int k = 0; k < axes.GetLength(0); k++)
            (rest[k, p], rest[k, q]) = (cosine * rest[k, p] - sine * rest[k, q], sine * rest[k, p] + cosine * rest[k, q]);
        for (int k = 0; k < axes.GetLength(0); k++)
        {
            (rest[p, k], rest[q, k]) = (cosine * rest[p, k] - sine * rest[q, k], sine * rest[p, k] + cosine * rest[q, k]);
            (axes[k, p], axes[k, q]) = (cosine * axes[k, p] - sine * axes[k, q], sine * axes[k, p] + cosine * axes[k, q]);
        }
    }
}
