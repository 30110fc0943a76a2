using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>A flat rectangular wing, span 1, chord 0.4, leading edge on the X axis, to be deformed by formulas.</summary>
    internal sealed class Sheet
    {
        public const float Chord = 0.4f;

        public readonly float3[] rest;
        public readonly int[] triangles;

        public Sheet(int columns = 40, int rows = 8)
        {
            SurfaceMesh surface = TestWings.Rectangle(columns, rows, 1f, Chord);
            rest = Array.ConvertAll(surface.positions, position => (float3)position);
            triangles = surface.triangles;
        }

        public BeatMeasurement Measurement => new BeatMeasurement(rest, triangles);

        /// <summary>The sheet with each place moved by a formula.</summary>
        public float3[] Deformed(Func<float3, float3> move) => Array.ConvertAll(rest, place => move(place));

        /// <summary>A beat of evenly spaced frames.</summary>
        /// <param name="root">The root's rotation at a phase.</param>
        /// <param name="move">Where the root sees a place at a phase, before it turns.</param>
        /// <param name="count">Frames.</param>
        public List<BeatFrame> Beat(Func<float, quaternion> root, Func<float3, float, float3> move, int count = 24)
        {
            var beat = new List<BeatFrame>();
            for (int k = 0; k < count; k++)
            {
                float phase = 2f * math.PI * (k + 0.3f) / count;
                quaternion turn = root(phase);
                beat.Add(new BeatFrame(phase, turn, Deformed(place => math.rotate(turn, move(place, phase)))));
            }

            return beat;
        }

        /// <summary>Flapping by ±50° and feathering by ±20° a quarter of a beat before.</summary>
        public static quaternion Stroke(float phase) => math.mul(
            quaternion.AxisAngle(new float3(0f, 0f, 1f), math.radians(50f) * math.cos(phase)),
            quaternion.AxisAngle(new float3(1f, 0f, 0f), math.radians(20f) * math.cos(phase - 0.5f * math.PI)));

        /// <summary>The place turned about the leading edge.</summary>
        public static float3 Feathered(float3 place, float angle) =>
            math.rotate(quaternion.AxisAngle(new float3(1f, 0f, 0f), angle), place);
    }
}
