using Random = Unity.Mathematics.Random;

namespace Alate.Cli;

/// <summary>
/// CMA-ES, a search by generations of points around a mean whose spread learns the shape of the valley: Hansen 2016, "The CMA evolution
/// strategy: a tutorial", arXiv:1604.00772, with its default parameters and without negative weights. Points outside the unit cube are put
/// onto its sides. The same seed and the same orders give the same points.
/// </summary>
internal sealed class EvolutionStrategy
{
    /// <summary>Standard deviation of the first generation, of the side of the cube.</summary>
    private const double k_First = 0.3;

    private readonly int m_Dimensions;
    private readonly double[] m_Weights, m_Mean, m_Path, m_StepPath, m_Scales;
    private readonly double[,] m_Covariance, m_Axes;
    private readonly double m_Effective;
    private double[][] m_Asked;
    private Random m_Random;
    private double m_Step = k_First;
    private int m_Generation;

    /// <summary>Begins in the middle of the cube.</summary>
    /// <param name="dimensions">Number of parameters, 1 or more.</param>
    /// <param name="seed">Says the random numbers.</param>
    public EvolutionStrategy(int dimensions, uint seed)
    {
        m_Dimensions = dimensions;
        m_Random = Random.CreateFromIndex(seed);
        Size = SizeOf(dimensions);
        m_Weights = Enumerable.Range(1, Size / 2).Select(k => Math.Log((Size + 1) / 2.0) - Math.Log(k)).ToArray();
        double sum = m_Weights.Sum();
        m_Weights = Array.ConvertAll(m_Weights, weight => weight / sum);
        m_Effective = 1 / m_Weights.Sum(weight => weight * weight);
        m_Mean = Enumerable.Repeat(0.5, dimensions).ToArray();
        m_Path = new double[dimensions];
        m_StepPath = new double[dimensions];
        m_Scales = Enumerable.Repeat(1.0, dimensions).ToArray();
        m_Covariance = Identity(dimensions);
        m_Axes = Identity(dimensions);
    }

    /// <summary>Points of a generation.</summary>
    public int Size { get; }

    /// <summary>Points of a generation of so many parameters: 4 + 3 ln n, rounded down.</summary>
    public static int SizeOf(int dimensions) => 4 + (int)(3 * Math.Log(dimensions));

    /// <summary>[point][dimension] The next generation, each coordinate from 0 to 1.</summary>
    public double[][] Ask()
    {
        SymmetricMatrix.Diagonalize(m_Covariance, m_Axes, m_Scales);
        for (int k = 0; k < m_Dimensions; k++)
            m_Scales[k] = Math.Sqrt(Math.Max(m_Scales[k], 0));
        m_Asked = Enumerable.Range(0, Size).Select(_ => Draw()).ToArray();
        return m_Asked;
    }

    /// <summary>Learns from the generation that was asked for.</summary>
    /// <param name="order">Indices of its points, the best first.</param>
    public void Tell(IReadOnlyList<int> order)
    {
        int n = m_Dimensions;
        double[] before = (double[])m_Mean.Clone();
        double[][] steps = order.Take(m_Weights.Length)
            .Select(k => m_Asked[k].Select((share, axis) => (share - before[axis]) / m_Step).ToArray()).ToArray();
        double[] step = new double[n];
        for (int axis = 0; axis < n; axis++)
        {
            for (int k = 0; k < steps.Length; k++)
                step[axis] += m_Weights[k] * steps[k][axis];
            m_Mean[axis] += m_Step * step[axis];
        }

        double stepRate = (m_Effective + 2) / (n + m_Effective + 5), pathRate = (4 + m_Effective / n) / (n + 4 + 2 * m_Effective / n),
            damping = 1 + 2 * Math.Max(0, Math.Sqrt((m_Effective - 1) / (n + 1)) - 1) + stepRate,
            expected = Math.Sqrt(n) * (1 - 1.0 / (4 * n) + 1.0 / (21 * n * n)), rankOne = 2 / ((n + 1.3) * (n + 1.3) + m_Effective),
            rankMu = Math.Min(1 - rankOne, 2 * (m_Effective - 2 + 1 / m_Effective) / ((n + 2) * (n + 2) + m_Effective));
        double[] white = Whitened(step);
        Decay(m_StepPath, stepRate, Math.Sqrt(stepRate * (2 - stepRate) * m_Effective), white);
        double length = Math.Sqrt(m_StepPath.Sum(part => part * part));
        m_Generation++;
        bool isSlow = length / Math.Sqrt(1 - Math.Pow(1 - stepRate, 2 * m_Generation)) < (1.4 + 2.0 / (n + 1)) * expected;
        Decay(m_Path, pathRate, isSlow ? Math.Sqrt(pathRate * (2 - pathRate) * m_Effective) : 0, step);
        double kept = 1 - rankOne - rankMu + (isSlow ? 0 : rankOne * pathRate * (2 - pathRate));
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                double learned = rankOne * m_Path[i] * m_Path[j];
                for (int k = 0; k < steps.Length; k++)
                    learned += rankMu * m_Weights[k] * steps[k][i] * steps[k][j];
                m_Covariance[i, j] = kept * m_Covariance[i, j] + learned;
            }
        }

        m_Step = Math.Min(m_Step * Math.Exp(stepRate / damping * (length / expected - 1)), 1);
    }

    private double[] Draw()
    {
        double[] point = (double[])m_Mean.Clone();
        for (int k = 0; k < m_Dimensions; k++)
        {
            double along = m_Step * m_Scales[k] * Normal();
            for (int axis = 0; axis < m_Dimensions; axis++)
                point[axis] += m_Axes[axis, k] * along;
        }

        return Array.ConvertAll(point, share => Math.Clamp(share, 0, 1));
    }

    // By the polar method.
    private double Normal()
    {
        while (true)
        {
            double x = 2 * m_Random.NextDouble() - 1, y = 2 * m_Random.NextDouble() - 1, square = x * x + y * y;
            if (square is > 0 and < 1)
                return x * Math.Sqrt(-2 * Math.Log(square) / square);
        }
    }

    // The step in coordinates in which the spread is a sphere.
    private double[] Whitened(double[] step)
    {
        double[] white = new double[m_Dimensions];
        for (int k = 0; k < m_Dimensions; k++)
        {
            double along = 0;
            for (int axis = 0; axis < m_Dimensions; axis++)
                along += m_Axes[axis, k] * step[axis];
            along /= Math.Max(m_Scales[k], 1e-150);
            for (int axis = 0; axis < m_Dimensions; axis++)
                white[axis] += m_Axes[axis, k] * along;
        }

        return white;
    }

    private static void Decay(double[] path, double rate, double gain, double[] step)
    {
        for (int k = 0; k < path.Length; k++)
            path[k] = (1 - rate) * path[k] + gain * step[k];
    }

    private static double[,] Identity(int size)
    {
        double[,] identity = new double[size, size];
        for (int k = 0; k < size; k++)
            identity[k, k] = 1;
        return identity;
    }
}
