using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Lift and drag coefficients against the angle of attack (Fig. 6 and the sets measured for insects).</summary>
    internal static class Coefficients
    {
        private const float k_Degrees = 180f / math.PI;

        /// <summary>Lift l(α) and drag d(α) of Eq. 9 for a run of elements; one set for all of them.</summary>
        public static unsafe void Evaluate(in ModelOptions options, PatchStream* streams, int count)
        {
            PatchStream* end = streams + count;
            switch (options.coefficients)
            {
                case CoefficientSet.FlatPlate:
                    for (PatchStream* s = streams; s < end; s++)
                        FlatPlate(math.abs(s->across), s->tangential, out s->lift, out s->drag);
                    return;
                case CoefficientSet.Paper:
                    Angles(streams, count);
                    for (PatchStream* s = streams; s < end; s++)
                        Paper(s->angle, options.clampLift, out s->lift, out s->drag);
                    return;
                case CoefficientSet.Dickinson1999:
                case CoefficientSet.Dragonfly:
                    Angles(streams, count);
                    for (PatchStream* s = streams; s < end; s++)
                        Dickinson(s->angle, out s->lift, out s->drag);
                    if (options.coefficients == CoefficientSet.Dickinson1999)
                        return;
                    for (PatchStream* s = streams; s < end; s++)
                        s->drag = DragonflyDrag(s->across, s->tangential);
                    return;
                default:
                    // A job throws nothing: the world refuses such options, and a set that was forgotten here is seen at once.
                    for (PatchStream* s = streams; s < end; s++)
                        s->lift = s->drag = float.NaN;
                    return;
            }
        }

        /// <summary>Lift and drag of a set at one angle; NaN for a set that does not exist.</summary>
        /// <param name="set">The set; the paper's with its lift clamped at 0.</param>
        /// <param name="sine">Sine of the angle of attack, which is between 0 and a right angle.</param>
        /// <param name="cosine">Its cosine.</param>
        /// <param name="lift">C_L.</param>
        /// <param name="drag">C_D.</param>
        public static unsafe void At(CoefficientSet set, float sine, float cosine, out float lift, out float drag)
        {
            ModelOptions options = ModelOptions.Physical;
            options.coefficients = set;
            options.clampLift = true;
            PatchStream stream = default;
            stream.across = sine;
            stream.tangential = cosine;
            Evaluate(options, &stream, 1);
            lift = stream.lift.x;
            drag = stream.drag.x;
        }

        private static unsafe void Angles(PatchStream* streams, int count)
        {
            for (PatchStream* s = streams; s < streams + count; s++)
                s->angle = SoaMath.QuadrantAngle(math.abs(s->across), s->tangential);
        }

        /// <summary>Evaluates the polynomials of Fig. 6; the angle is in degrees there, in radians here.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Paper(float4 angle, bool clampLift, out float4 lift, out float4 drag)
        {
            float4 a = angle * k_Degrees;
            lift = -0.34182f + a * (0.090635f + a * -0.00095953f);
            drag = 0.51127f + a * (0.0063148f + a * (0.0011527f + a * -0.0000079518f));
            if (clampLift)
                lift = math.max(lift, 0f);
        }

        /// <summary>
        /// Dickinson, Lehmann, Sane 1999: C_L = 0.225 + 1.58 sin(2.13α − 7.20°), C_D = 1.92 − 1.55 cos(2.04α − 9.82°), α in
        /// degrees there. Sine and cosine by their series about the middle of their ranges, error below 1e-6.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Dickinson(float4 angle, out float4 lift, out float4 drag)
        {
            float4 a = angle * 2.13f - (0.12566371f + 1.57079633f);
            float4 a2 = a * a;
            float4 a4 = a2 * a2;
            float4 sin = 1f + a2 * -0.5f + a4 * (4.16666667e-2f + a2 * -1.38888889e-3f + a4 * (2.48015873e-5f + a2 * -2.75573192e-7f));
            lift = 0.225f + 1.58f * sin;

            float4 b = angle * 2.04f - (0.17139133f + 1.57079633f);
            float4 b2 = b * b;
            float4 b4 = b2 * b2;
            float4 minusCos = b * (1f + b2 * -1.66666667e-1f
                + b4 * (8.33333333e-3f + b2 * -1.98412698e-4f + b4 * (2.75573192e-6f + b2 * -2.50521084e-8f)));
            drag = 1.92f + 1.55f * minusCos;
        }

        /// <summary>
        /// Drag of a dragonfly's wing by Azuma and Watanabe 1988: C_D = 0.094 + 1.906 s + s (1 − s)(−0.388 + 0.168 s + 2.14 s²), s = sin²α.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 DragonflyDrag(float4 normal, float4 tangential)
        {
            float4 s = normal * normal / math.max(normal * normal + tangential * tangential, 1e-24f);
            return 0.094f + s * (1.906f + (1f - s) * (-0.388f + s * (0.168f + s * 2.14f)));
        }

        /// <summary>Flat plate: C_L = 1.8 sin 2α, C_D = 0.05 + 1.9 sin²α, without an angle.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void FlatPlate(float4 normal, float4 tangential, out float4 lift, out float4 drag)
        {
            float4 inverse = 1f / math.max(normal * normal + tangential * tangential, 1e-24f);
            lift = 3.6f * normal * tangential * inverse;
            drag = 0.05f + 1.9f * normal * normal * inverse;
        }
    }
}
