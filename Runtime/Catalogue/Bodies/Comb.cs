using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Teeth or bristles in rows along an antenna.</summary>
    internal static class Comb
    {
        private static readonly Vector3 s_Up = new Vector3(0f, 1f, 0f);

        /// <param name="curve">The right antenna: a Bezier curve, millimetres.</param>
        /// <param name="teeth">Teeth of a row, evenly spaced.</param>
        /// <param name="length">Of a tooth at a place along the curve, millimetres.</param>
        /// <param name="radius">Of a tooth at its root, millimetres.</param>
        /// <param name="isDouble">A row on either side; else on the outer one only.</param>
        public static BodyPart Along(Vector3[] curve, int teeth, Func<float, float> length, float radius, bool isDouble)
        {
            var comb = new Pyramids();
            for (int tooth = 0; tooth < teeth; tooth++)
            {
                float t = (tooth + 1.5f) / (teeth + 1.5f);
                Vector3 root = Stalk.Bezier(curve, t);
                Vector3 ahead = root - Stalk.Bezier(curve, t - 0.01f);
                var outward = Vector3.Cross(s_Up, ahead);
                ahead /= ahead.magnitude;
                outward /= outward.magnitude;
                comb.Add(root, length(t) * (0.8f * outward + 0.6f * ahead), s_Up, radius, new Vector2(0.5f, t));
                if (isDouble)
                    comb.Add(root, length(t) * (-0.8f * outward + 0.6f * ahead), s_Up, radius, new Vector2(0.5f, t));
            }

            return comb.ToPart(new Vector2(2f * radius, (curve[3] - curve[0]).magnitude));
        }
    }
}
