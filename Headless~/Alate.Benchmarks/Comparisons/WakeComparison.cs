using System;
using System.Diagnostics;
using Alate.Wake;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Benchmarks;

/// <summary>
/// Free wakes: velocities induced by vortex segments against plain double precision, and the three beats of two pairs of wings on one core
/// and on two.
/// </summary>
internal static class WakeComparison
{
    private const int k_Vertices = 400, k_Points = 256, k_Beats = 3, k_Rounds = 5;
    private const float k_Circulation = 0.7f, k_CoreSquare = 0.02f;

    public static void Run(Report report)
    {
        Kernel(report);
        foreach (WakeMethod method in new[] { WakeMethod.Strips, WakeMethod.Panels })
            Insect(report, method);
    }

    private static void Kernel(Report report)
    {
        var random = Random.CreateFromIndex(7);
        using var field = new VortexField(k_Vertices, k_Points, new MirrorImages(false, false, new float3(0f, 1f, 0f), 0f));
        double[] chain = new double[3 * k_Vertices], points = new double[3 * k_Points], velocities = new double[3 * k_Points];
        for (int k = 0; k < k_Vertices; k++)
        {
            float3 vertex = random.NextFloat3(-1f, 1f);
            Write(chain, k, vertex);
            if (k == 0)
                field.Begin(vertex);
            else
                field.Add(vertex, k_Circulation, k_CoreSquare);
        }

        field.SetPointCount(k_Points);
        for (int k = 0; k < k_Points; k++)
        {
            float3 point = random.NextFloat3(-1f, 1f);
            Write(points, k, point);
            field.SetPoint(k, point);
        }

        double influences = (double)(k_Vertices - 1) * k_Points;
        double[] time = OnOneCore(() => Race.Run(
            new Contestant("eight points", influences, field.Induce),
            new Contestant("one point", influences, () => PlainVortices.Induce(chain, k_Circulation, k_CoreSquare, points, velocities))));
        double largest = 0.0, error = 0.0;
        for (int k = 0; k < k_Points; k++)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                largest = Math.Max(largest, Math.Abs(velocities[3 * k + axis]));
                error = Math.Max(error, Math.Abs(velocities[3 * k + axis] - field.Velocity(k)[axis]));
            }
        }

        report.Check("segments induce what they do in double precision", error / largest, 1e-4);
        report.Ratio(Targets.Vortices, time[0], time[1], time[1] / time[0]);
    }

    // A dragonfly's size: the right wings of two pairs and their mirror images.
    private static void Insect(Report report, WakeMethod method)
    {
        string name = method.ToString().ToLowerInvariant();
        double one = OnOneCore(() => Best(method)), all = Best(method);
        report.Figure("wake_seconds", name, $"wake of two pairs, three beats, by {name}, one core", "s", one);
        if (JobsUtility.JobWorkerCount == 1)
            report.Ratio(Targets.WakeCores, name, all, one, one / all);
    }

    private static double Best(WakeMethod method)
    {
        double best = double.PositiveInfinity;
        for (int round = 0; round < k_Rounds; round++)
        {
            var settings = new WakeSettings(method) { Symmetric = true, Stream = new float3(0f, 0f, -1.5f) };
            if (method == WakeMethod.Panels)
                settings.ChordPanels = 6;
            using var wake = new FreeWake(settings, new[] { new WakeWing(new Flapping(0.1f, 0f)), new WakeWing(new Flapping(-0.25f, 1f)) });
            long start = Stopwatch.GetTimestamp();
            for (int step = 0; step < k_Beats * settings.StepsPerBeat; step++)
                wake.Step();
            best = Math.Min(best, Stopwatch.GetElapsedTime(start).TotalSeconds);
        }

        return best;
    }

    private static T OnOneCore<T>(Func<T> measure)
    {
        int workers = JobsUtility.JobWorkerCount;
        JobsUtility.JobWorkerCount = 0;
        try
        {
            return measure();
        }
        finally
        {
            JobsUtility.JobWorkerCount = workers;
        }
    }

    private static void Write(double[] array, int index, float3 value)
    {
        for (int axis = 0; axis < 3; axis++)
            array[3 * index + axis] = value[axis];
    }

    /// <summary>Stiff rectangular wing that flaps about an axis along the body.</summary>
    private sealed class Flapping(float ahead, float phase) : IWingMotion
    {
        private const float k_Chord = 0.2f, k_Root = 0.1f, k_Amplitude = 0.7f;

        public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
        {
            double turn = 2.0 * Math.PI * beats + phase;
            double angle = k_Amplitude * Math.Cos(turn), rate = -2.0 * Math.PI * k_Amplitude * Math.Sin(turn);
            float cos = (float)Math.Cos(angle), sin = (float)Math.Sin(angle);
            for (int k = 0; k < places.Length; k++)
            {
                float span = math.lerp(k_Root, 1f, places[k].y);
                points[k] = new float3(span * cos, span * sin, ahead - k_Chord * places[k].x);
                velocities[k] = (float)rate * new float3(-span * sin, span * cos, 0f);
            }
        }
    }
}
