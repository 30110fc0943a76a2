using Alate.Flight;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Speed, power, straightness and turning of insects that wander by their wings without aid.</summary>
/// <param name="Species">Name for people.</param>
/// <param name="Erratic">Liveliness of the tracks, 0 to 1.</param>
internal sealed record WanderStatistics(string Species, double Erratic)
{
    /// <summary>Times over which straightness is told, seconds.</summary>
    public static readonly double[] Lags = [0.2, 0.5, 1, 2, 4, 8];

    /// <summary>Frequencies at which the spectrum of turning is told, Hz.</summary>
    public static readonly double[] Frequencies =
        [.. Enumerable.Range(1, (int)(k_Fastest * k_Window / k_Rate)).Select(k => k * k_Rate / k_Window)];

    private const int k_Seeds = 8, k_Window = 400, k_Coarse = 5;
    private const float k_Step = 0.01f;
    private const double k_Settled = 2, k_Seconds = 42, k_Rate = 1 / (k_Coarse * k_Step), k_Slow = 0.1, k_Fastest = 3;
    private static readonly FlightVolume s_Volume = new(VolumeShape.Box, Vector3.zero, new Vector3(8f, 4f, 8f));

    private double m_Seconds, m_Work, m_Path, m_Turning;
    private int m_Turns;
    private readonly double[] m_Straight = new double[Lags.Length], m_Spectrum = new double[Frequencies.Length];
    private readonly int[] m_Counts = new int[Lags.Length];
    private int m_Windows;

    /// <summary>Mean speed, m/s.</summary>
    public double Speed => m_Path / m_Seconds;

    /// <summary>Mean power to the air over that of steady level flight at the mean speed.</summary>
    public double PowerOverSteady { get; private set; }

    /// <summary>Flights in which the insect tumbled.</summary>
    public int Tumbled { get; private set; }

    /// <summary>Root mean square of the rate at which the course turns, degrees a second.</summary>
    public double Turning => Math.Sqrt(m_Turning / m_Turns);

    /// <summary>[lag] Distance flown straight over the way flown.</summary>
    public IReadOnlyList<double> Straightness => [.. m_Straight.Select((sum, lag) => sum / m_Counts[lag])];

    /// <summary>[frequency] Power spectral density of the rate at which the course turns, (°/s)²/Hz.</summary>
    public IReadOnlyList<double> Spectrum => [.. m_Spectrum.Select(sum => sum / m_Windows)];

    /// <summary>Flies an insect of the catalogue.</summary>
    public static WanderStatistics Of(InsectDefinition insect, double erratic)
    {
        using FlightModel model = CatalogueFlight.CreateModel(insect);
        using TrimTable table = CatalogueFlight.CreateTable(insect, model);
        var statistics = new WanderStatistics(insect.DisplayName, erratic);
        WanderSettings settings = WanderSettings.Default;
        settings.erratic = (float)erratic;
        for (int seed = 1; seed <= k_Seeds; seed++)
            statistics.Fly(model, table, seed, settings);
        double steady = FlightMeans.Fly(model, table, new FlightCondition((float)statistics.Speed, 0f)).PowerPerMass;
        statistics.PowerOverSteady = statistics.m_Work / statistics.m_Seconds / model.Mass / steady;
        return statistics;
    }

    private void Fly(FlightModel model, TrimTable table, int seed, WanderSettings settings)
    {
        using var flight = new FreeFlight(model, table);
        var course = new ErraticCourse(seed);
        List<float3> places = [];
        bool tumbles = false;
        for (int step = 0; flight.Time < k_Seconds; step++)
        {
            flight.Step(FlightCommand.Fly(course.Next(flight.Situation(k_Step), s_Volume, settings)), k_Step);
            tumbles |= flight.State == FlightState.Tumbling;
            if (flight.Time < k_Settled)
                continue;
            m_Seconds += k_Step;
            m_Work += flight.Power * k_Step;
            m_Path += math.length(flight.Velocity) * k_Step;
            if (step % k_Coarse == 0)
                places.Add(flight.Position);
        }

        Tumbled += tumbles ? 1 : 0;
        Add(places);
    }

    /// <summary>Adds a track.</summary>
    /// <param name="places">Metres, 20 a second.</param>
    internal void Add(IReadOnlyList<float3> places)
    {
        for (int lag = 0; lag < Lags.Length; lag++)
        {
            int steps = (int)Math.Round(Lags[lag] * k_Rate);
            for (int k = steps; k < places.Count; k += steps)
            {
                double way = 0;
                for (int j = k - steps; j < k; j++)
                    way += math.distance(places[j + 1].xz, places[j].xz);
                if (way < k_Slow * Lags[lag])
                    continue;
                m_Straight[lag] += math.distance(places[k].xz, places[k - steps].xz) / way;
                m_Counts[lag]++;
            }
        }

        // Of the course over two tenths of a second, in which the body's bob has gone; an insect that hardly moves has none.
        const int k_Over = 4;
        double last = double.NaN;
        List<double> rates = [];
        for (int k = k_Over; k < places.Count; k++)
        {
            float2 way = places[k].xz - places[k - k_Over].xz;
            double heading = Math.Atan2(way.x, way.y);
            bool moves = math.length(way) * k_Rate / k_Over > k_Slow;
            double turn = moves && !double.IsNaN(last) ? Math.IEEERemainder(heading - last, 2 * Math.PI) : 0;
            last = moves ? heading : double.NaN;
            rates.Add(180 / Math.PI * turn * k_Rate);
        }

        m_Turning += rates.Sum(rate => rate * rate);
        m_Turns += rates.Count;
        for (int from = 0; from + k_Window <= rates.Count; from += k_Window / 2)
            AddWindow(rates, from);
    }

    // A periodogram under Hann's window.
    private void AddWindow(List<double> rates, int from)
    {
        double squares = Enumerable.Range(0, k_Window).Sum(k => Hann(k) * Hann(k));
        for (int n = 0; n < Frequencies.Length; n++)
        {
            double cosine = 0, sine = 0;
            for (int k = 0; k < k_Window; k++)
            {
                double angle = 2 * Math.PI * (n + 1) * k / k_Window;
                cosine += Hann(k) * rates[from + k] * Math.Cos(angle);
                sine += Hann(k) * rates[from + k] * Math.Sin(angle);
            }

            m_Spectrum[n] += 2 * (cosine * cosine + sine * sine) / (k_Rate * squares);
        }

        m_Windows++;
    }

    private static double Hann(int k) => 0.5 - 0.5 * Math.Cos(2 * Math.PI * k / k_Window);
}
