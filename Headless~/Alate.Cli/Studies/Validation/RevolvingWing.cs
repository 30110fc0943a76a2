using Alate.Wake;

namespace Alate.Cli;

/// <summary>
/// Model of a fly's wing that revolves about its root from rest, as that of Dickinson, Lehmann and Sane 1999: R 0.25 m, area 0.0167
/// m². Half a turn is one beat.
/// </summary>
internal sealed class RevolvingWing : IWingMotion
{
    private const double k_Chord = 0.0167 / (0.25 * 0.25), k_Rate = Math.PI;

    private readonly double m_Attack;

    private RevolvingWing(double attack) => m_Attack = attack;

    public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
    {
        double turned = k_Rate * beats, cos = Math.Cos(turned), sin = Math.Sin(turned);
        for (int k = 0; k < places.Length; k++)
        {
            double far = places[k].y, before = (0.25 - places[k].x) * FlyPlanform.Chord(far, k_Chord);
            double ahead = before * Math.Cos(m_Attack);
            points[k] = new float3(
                (float)(far * cos - ahead * sin), (float)(before * Math.Sin(m_Attack)), (float)(far * sin + ahead * cos));
            velocities[k] = (float)k_Rate * new float3(-points[k].z, 0f, points[k].x);
        }
    }

    /// <summary>Mean coefficients over the middle half of half a turn.</summary>
    public static (double Lift, double Drag) Fly(double degrees, WakeSettings settings, MeasuredDownwash downwash = default)
    {
        var wing = new RevolvingWing(degrees * Math.PI / 180.0);
        using var wake = new FreeWake(settings, new[] { new WakeWing(wing) { Downwash = downwash } });
        double lift = 0.0, drag = 0.0;
        int count = 0;
        for (int k = 0; k < settings.StepsPerBeat * 3 / 4; k++)
        {
            double time = wake.Time, turned = k_Rate * time;
            wake.Step();
            if (time <= 0.25)
                continue;
            float3 force = wake.Loads(0).Force;
            lift += force.y;
            drag += Math.Sin(turned) * force.x - Math.Cos(turned) * force.z;
            count++;
        }

        double pressure = 0.5 * k_Rate * k_Rate * FlyPlanform.Moment * k_Chord * count;
        return (lift / pressure, drag / pressure);
    }

    public static double MeasuredLift(double degrees) => 0.225 + 1.58 * Math.Sin((2.13 * degrees - 7.20) * Math.PI / 180.0);

    public static double MeasuredDrag(double degrees) => 1.92 - 1.55 * Math.Cos((2.04 * degrees - 9.82) * Math.PI / 180.0);
}
