using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Keeps what is drawn.</summary>
    internal sealed class RecordingPen : IGizmoPen
    {
        public List<(Vector3 from, Vector3 to, Color colour)> Lines { get; } = new List<(Vector3, Vector3, Color)>();

        public List<(Vector3 at, Color colour)> Dots { get; } = new List<(Vector3, Color)>();

        public List<(Matrix4x4 space, Bounds bounds)> Boxes { get; } = new List<(Matrix4x4, Bounds)>();

        public void Line(Vector3 from, Vector3 to, Color colour, bool wide) => Lines.Add((from, to, colour));

        public void Dot(Vector3 at, Color colour) => Dots.Add((at, colour));

        public void Box(Matrix4x4 space, Bounds bounds, Color colour) => Boxes.Add((space, bounds));
    }
}
