using System.Numerics;

namespace Alate.Cli;

/// <summary>Closed forms of thin wings in attached flow, apart from the wake; forces over the density and a unit of width.</summary>
internal static class ThinWingTheory
{
    /// <summary>
    /// Lift of an elliptic wing behind and beside another one, over that of one alone, by lifting lines: the upwash of the first, weighed
    /// with the ellipse of the second (reverse flow), over the angle that both have.
    /// </summary>
    /// <param name="ratio">Aspect ratio.</param>
    /// <param name="aside">Between their middles, spans.</param>
    /// <param name="behind">Spans.</param>
    public static double Following(double ratio, double aside, double behind)
    {
        // Lengths in spans, stream and density 1: the circulation is an ellipse of that of the lift coefficient.
        const int parts = 400;
        double slope = 2 * Math.PI / (1 + 2 / ratio), middle = 2 * slope / (Math.PI * ratio), sum = 0, weights = 0;
        for (int k = 0; k < parts; k++)
        {
            double at = Math.PI * (k + 0.5) / parts, weight = Math.Sin(at) * Math.Sin(at);
            weights += weight;
            sum += weight * Upwash(middle, aside + 0.5 * Math.Cos(at), behind, parts);
        }

        return 1 + sum / weights;
    }

    // Of the vortices that an elliptic line sheds, and of the line itself.
    private static double Upwash(double middle, double aside, double behind, int parts)
    {
        double sum = 0;
        for (int k = 0; k < parts; k++)
        {
            double at = Math.PI * (k + 0.5) / parts, y = aside - 0.5 * Math.Cos(at), r = Math.Sqrt(behind * behind + y * y);
            double shed = middle * Math.Cos(at), bound = 0.5 * middle * Math.Sin(at) * Math.Sin(at);
            sum += shed * (1 + behind / r) / (4 * Math.PI * y) - bound * behind / (4 * Math.PI * r * r * r);
        }

        return sum * Math.PI / parts;
    }

    /// <summary>Places of the integrals of the Bessel functions, and the bound of their infinite part.</summary>
    private const int k_Places = 4000;
    private const double k_Far = 12, k_Semichord = 0.5;

    /// <summary>Theodorsen's function of the reduced frequency, by Hankel functions of the second kind.</summary>
    public static Complex Theodorsen(double k)
    {
        Complex one = Hankel(1, k), none = Hankel(0, k);
        return one / (one + Complex.ImaginaryOne * none);
    }

    /// <summary>Amplitude of the lift of a heaving plate of chord 1 (Theodorsen 1935).</summary>
    /// <param name="reduced">Reduced frequency; the beat is the unit of time.</param>
    /// <param name="height">Amplitude of the height, upwards.</param>
    public static Complex Heaving(double reduced, double height)
    {
        const double k_Rate = 2 * Math.PI;
        Complex i = Complex.ImaginaryOne, down = -height;
        return -Math.PI * k_Semichord * k_Semichord * k_Rate * k_Rate * down
            + 2 * Math.PI * Speed(reduced) * k_Semichord * Theodorsen(reduced) * i * k_Rate * down;
    }

    /// <summary>Amplitude of the lift of a plate of chord 1 that is pitched about a quarter of it (Theodorsen 1935).</summary>
    /// <param name="reduced">Reduced frequency.</param>
    /// <param name="pitch">Amplitude, nose up, radians.</param>
    public static Complex Pitching(double reduced, double pitch)
    {
        const double k_Rate = 2 * Math.PI, k_Axis = -0.5;
        double speed = Speed(reduced);
        Complex i = Complex.ImaginaryOne;
        Complex carried = Math.PI * k_Semichord * k_Semichord * (speed * i * k_Rate + k_Semichord * k_Axis * k_Rate * k_Rate) * pitch;
        return carried + 2 * Math.PI * speed * k_Semichord * Theodorsen(reduced)
            * (speed + k_Semichord * (0.5 - k_Axis) * i * k_Rate) * pitch;
    }

    /// <summary>Mean thrust of a heaving plate, all suction (Garrick 1936).</summary>
    /// <inheritdoc cref="Heaving"/>
    public static double Garrick(double reduced, double height)
    {
        const double k_Rate = 2 * Math.PI;
        double lag = Theodorsen(reduced).Magnitude;
        return Math.PI * k_Semichord * k_Rate * k_Rate * height * height * lag * lag;
    }

    /// <summary>Lift coefficient at 5° after a sudden start (Wagner 1925, as R. T. Jones 1940 has it).</summary>
    /// <param name="semichords">Travelled.</param>
    public static double Wagner(double semichords) => 2 * Math.PI * Math.Sin(5 * Math.PI / 180)
        * (1 - 0.165 * Math.Exp(-0.0455 * semichords) - 0.335 * Math.Exp(-0.3 * semichords));

    /// <summary>Slope of the lift of a wing by its aspect ratio (Helmbold 1942).</summary>
    public static double Helmbold(double ratio) => 2 * Math.PI * ratio / (2 + Math.Sqrt(ratio * ratio + 4));

    private static double Speed(double reduced) => Math.PI / reduced;

    // J − iY by Bessel's and Schläfli's integrals of whole orders.
    private static Complex Hankel(int order, double x)
    {
        double j = 0, y = 0;
        for (int n = 0; n < k_Places; n++)
        {
            double turn = Math.PI * (n + 0.5) / k_Places, far = k_Far * (n + 0.5) / k_Places;
            j += Math.Cos(order * turn - x * Math.Sin(turn)) / k_Places;
            y += Math.Sin(x * Math.Sin(turn) - order * turn) / k_Places
                - k_Far / k_Places / Math.PI * (Math.Exp(order * far) + Math.Exp(-order * far) * (order % 2 == 0 ? 1 : -1))
                * Math.Exp(-x * Math.Sinh(far));
        }

        return new Complex(j, -y);
    }
}
