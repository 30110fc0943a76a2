namespace Alate.Cli;

/// <summary>Air on a strip of a wing in a substep, wing frame; wing lengths, wing masses, seconds, radians.</summary>
/// <param name="Area">At rest.</param>
/// <param name="Force">Of all air on it.</param>
/// <param name="Moment">Of that force about the middle of the thorax.</param>
/// <param name="Pitching">Of that force about the leading edge, nose up.</param>
/// <param name="Attack">Mean angle of attack over the strip's area; not a number where no patch lies in it.</param>
internal readonly record struct SpanStrip(double Area, float3 Force, float3 Moment, double Pitching, double Attack)
{
    /// <summary>Number of strips, of one width from hinge to tip at rest.</summary>
    public const int Count = 20;

    /// <summary>Measures the strips of a wing that records its patches.</summary>
    /// <param name="reading">The wing.</param>
    /// <param name="hinge">From the middle of the thorax, wing lengths.</param>
    public static SpanStrip[] Measure(in WingReading reading, float3 hinge)
    {
        var strips = new SpanStrip[Count];
        for (int patch = 0; patch < reading.PatchCount; patch++)
        {
            ref SpanStrip strip = ref strips[IndexOf(reading.PatchSpan(patch))];
            double area = reading.PatchArea(patch);
            Add(ref strip, reading, reading.PatchSpan(patch), reading.PatchPosition(patch), reading.PatchForce(patch), hinge);
            strip = strip with { Area = strip.Area + area, Attack = strip.Attack + area * reading.PatchAngleOfAttack(patch) };
        }

        for (int joint = 0; joint < reading.ChainCount * reading.JointsPerChain; joint++)
        {
            float span = reading.JointSpan(joint);
            float3 position = reading.JointPosition(joint / reading.JointsPerChain, joint % reading.JointsPerChain);
            Add(ref strips[IndexOf(span)], reading, span, position, reading.JointForce(joint), hinge);
        }

        return Array.ConvertAll(strips, strip => strip with { Attack = strip.Area > 0.0 ? strip.Attack / strip.Area : double.NaN });
    }

    private static int IndexOf(float span) => Math.Clamp((int)(Count * span), 0, Count - 1);

    private static void Add(ref SpanStrip strip, in WingReading reading, float span, float3 position, float3 force, float3 hinge)
    {
        (float3 edge, float3 along) = LeadingEdge(reading, span);
        strip = strip with
        {
            Force = strip.Force + force,
            Moment = strip.Moment + math.cross(position + hinge, force),
            Pitching = strip.Pitching - math.dot(math.cross(position - edge, force), along),
        };
    }

    // The point of the first chain as far out at rest, and the direction of the bone that it lies on, to the tip.
    private static (float3 Point, float3 Along) LeadingEdge(in WingReading reading, float span)
    {
        int bone = 0;
        while (bone < reading.JointsPerChain - 2 && reading.JointSpan(bone + 1) < span)
            bone++;
        float from = reading.JointSpan(bone), to = reading.JointSpan(bone + 1);
        float3 start = reading.JointPosition(0, bone), end = reading.JointPosition(0, bone + 1);
        float share = to > from ? math.saturate((span - from) / (to - from)) : 0f;
        return (math.lerp(start, end, share), math.normalizesafe(end - start));
    }
}
