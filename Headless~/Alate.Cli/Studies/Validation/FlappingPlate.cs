using Alate.Wake;

namespace Alate.Cli;

/// <summary>
/// Stiff wing of an ornithopter that flaps in a stream of 2.9 m/s, 3.3 times a second, at no angle of attack: case C of Yeo, Atkins and
/// Shyy 2011, who measured the pressure at nine ports. Their plots were digitised by Urban 2020; the lift here is the sum of his nine
/// pressures, each over the area that he gives to its port, along the vertical, for both wings.
/// </summary>
internal sealed class FlappingPlate : IWingMotion
{
    /// <summary>Metres, metres a second, hertz, kilograms a cubic metre.</summary>
    private const double k_Span = 0.213, k_Speed = 2.9, k_Frequency = 3.3, k_Density = 1.225;

    private const int k_Beats = 4;

    /// <summary>Millinewtons, at twentieths of the beat from the middle of the upstroke on; both wings.</summary>
    private static readonly double[] s_Measured =
    [
        -75.7, -78.2, -64.9, -45.4, -11.9, 20.4, 58.0, 85.3, 109.4, 120.7, 112.8, 103.5, 88.6, 72.8, 56.1, 35.1, 3.3, -17.3, -39.6, -62.1,
    ];

    /// <summary>Flap, radians: mean; cosine and sine of each harmonic.</summary>
    private static readonly double[] s_Flap = [0.0354, 4.1e-5, 0.3793, -0.0322, -2e-6, -9e-7, -0.0035, 0.00046, -3.6e-6];

    /// <summary>Distance from the root, leading and trailing edge, millimetres.</summary>
    private static readonly double[][] s_Outline =
    [
        [0, 72, 0], [40, 71.6, 0.1], [60, 71.4, 1.2], [80, 70.7, 2.8], [100, 70.2, 5], [120, 69.2, 8.4], [140, 68, 11.9], [160, 66.4, 16.9],
        [180, 64.2, 23.9], [190, 62.8, 28.7], [200, 60.2, 35], [206, 58.8, 40.3], [210, 57, 44.9], [212, 55.2, 50.6], [213, 53.3, 53.2],
    ];

    /// <summary>Root mean square of the measured lift, millinewtons.</summary>
    public static double MeasuredRms => Math.Sqrt(s_Measured.Average(lift => lift * lift));

    public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
    {
        double flap = s_Flap[0], rate = 0;
        for (int harmonic = 1; 2 * harmonic < s_Flap.Length; harmonic++)
        {
            double turn = 2 * Math.PI * harmonic, cos = Math.Cos(turn * beats), sin = Math.Sin(turn * beats);
            double a = s_Flap[2 * harmonic - 1], b = s_Flap[2 * harmonic];
            flap += a * cos + b * sin;
            rate += turn * (b * cos - a * sin);
        }

        for (int k = 0; k < places.Length; k++)
        {
            double far = places[k].y, z = Edge(far, 1) + (Edge(far, 2) - Edge(far, 1)) * places[k].x;
            points[k] = new float3((float)(far * Math.Cos(flap)), (float)(far * Math.Sin(flap)), (float)z);
            velocities[k] = (float)rate * new float3(-points[k].y, points[k].x, 0f);
        }
    }

    /// <summary>Root mean square of the lift, and its mean distance from the measured one, millinewtons, over the last beat.</summary>
    /// <param name="method">Panels or strips.</param>
    /// <param name="attached">Panels alone: the suction of the leading edge stays along the chord.</param>
    /// <param name="steps">Of a beat.</param>
    public static (double Rms, double Error) Fly(WakeMethod method, bool attached, int steps)
    {
        var settings = new WakeSettings(method)
        {
            Symmetric = true,
            StepsPerBeat = steps,
            Keep = 3f,
            SuctionAlongChord = attached,
            Stream = new float3(0f, 0f, (float)(-k_Speed / (k_Span * k_Frequency))),
        };
        using var wake = new FreeWake(settings, [new WakeWing(new FlappingPlate()) { FreeRoot = false }]);
        double unit = 2000 * k_Density * Math.Pow(k_Span, 4) * k_Frequency * k_Frequency, square = 0, error = 0;
        for (int k = 0; k < k_Beats * steps; k++)
        {
            double time = wake.Time;
            wake.Step();
            if (k < (k_Beats - 1) * steps)
                continue;
            double lift = unit * wake.Loads(0).Force.y;
            square += lift * lift / steps;
            error += Math.Abs(lift - Measured(time)) / steps;
        }

        return (Math.Sqrt(square), error);
    }

    private static double Measured(double beats)
    {
        double at = (beats - Math.Floor(beats)) * s_Measured.Length;
        int before = (int)at;
        double share = at - before;
        return (1 - share) * s_Measured[before % s_Measured.Length] + share * s_Measured[(before + 1) % s_Measured.Length];
    }

    // In half spans, from the trailing edge of the root on.
    private static double Edge(double far, int side)
    {
        double place = far * 1000 * k_Span;
        int after = Math.Clamp(Array.FindIndex(s_Outline, row => row[0] >= place - 1e-6), 1, s_Outline.Length - 1);
        double[] a = s_Outline[after - 1], b = s_Outline[after];
        double share = Math.Clamp((place - a[0]) / (b[0] - a[0]), 0, 1);
        return (a[side] + share * (b[side] - a[side])) / (1000 * k_Span);
    }
}
