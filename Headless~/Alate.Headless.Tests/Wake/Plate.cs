using System;
using Alate.Wake;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>
    /// Stiff plate that heaves and pitches: span along x, its leading edge ahead, which is +z; chord 1 unless it has a shape.
    /// </summary>
    internal sealed class Plate : IWingMotion
    {
        /// <summary>Span, chords.</summary>
        public float Span { get; init; } = 1f;

        /// <summary>Place of the root.</summary>
        public float Root { get; init; }

        /// <summary>Share of the chord, from the leading edge, about which it pitches.</summary>
        public double Pivot { get; init; }

        /// <summary>Chord over the share of the span, about the middle of the largest one; null for 1.</summary>
        public Func<float, double> Chord { get; init; }

        /// <summary>Height and its rate; pitch nose up, radians, and its rate; over beats.</summary>
        public Func<double, (double Height, double Rise, double Pitch, double Turn)> Move { get; init; }

        public static Plate Steady(float span, double pitch) =>
            new() { Span = span, Root = -0.5f * span, Move = _ => (0.0, 0.0, pitch, 0.0) };

        public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
        {
            (double height, double rise, double pitch, double turn) = Move(beats);
            double cos = Math.Cos(pitch), sin = Math.Sin(pitch);
            for (int k = 0; k < places.Length; k++)
            {
                double chord = Chord == null ? 1.0 : Chord(places[k].y);
                double ahead = Pivot - (0.5 - 0.5 * chord + places[k].x * chord);
                points[k] = new float3(Root + places[k].y * Span, (float)(height + ahead * sin), (float)(ahead * cos));
                velocities[k] = new float3(0f, (float)(rise + ahead * cos * turn), (float)(-ahead * sin * turn));
            }
        }
    }
}
