using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Lift and drag of a strip over the angle at which it meets the air with the wake in it. Coefficients that were measured on a whole
    /// wing belong to the angle without that wing's own downwash: the downwash is taken out of them, and the force stays what it is in
    /// the wing's axes.
    /// </summary>
    internal sealed class StripPolar
    {
        private const int k_Steps = 360;

        /// <summary>Angle below which the lift falls to nothing, radians: some sets have a little at none, whose sign would jump.</summary>
        private const float k_Even = 0.05f;

        /// <summary>Angle of the measured wing's own downwash over C_L cos α, radians.</summary>
        private const float k_Downwash = 0.15f;

        /// <summary>
        /// [10 degrees] Effects of its own wake on the revolving wing of Dickinson, Lehmann and Sane 1999: the angle of its
        /// downwash over C_L, radians, and its force over that of strips which meet as much air. Found by flying that wing here until
        /// lift and drag at 10, 20, … 80 degrees came out as measured.
        /// </summary>
        private static readonly float[] s_Angles = { 0.109f, 0.109f, 0.113f, 0.120f, 0.130f, 0.166f, 0.167f, 0.145f, 0.123f, 0.123f };
        private static readonly float[] s_Forces = { 1.028f, 1.028f, 1.055f, 1.098f, 1.161f, 1.182f, 1.301f, 1.305f, 1.167f, 1.167f };

        // [half quarter degree] Coefficients, and the angle without the downwash.
        private readonly float[] m_Lift = new float[k_Steps + 1], m_Drag = new float[k_Steps + 1], m_Outer = new float[k_Steps + 1];

        /// <summary>Polar of a set of coefficients.</summary>
        /// <param name="set">Null for a thin plate in attached flow: C_L = 2π sin α, no drag.</param>
        /// <param name="downwash">What the coefficients hold of a wake.</param>
        public StripPolar(CoefficientSet? set, MeasuredDownwash downwash)
        {
            for (int k = 0; k <= k_Steps; k++)
            {
                float inner = 0.5f * math.PI * k / k_Steps, outer = WithoutDownwash(set, downwash, inner);
                float scale = downwash == MeasuredDownwash.RevolvingWing ? At(s_Forces, outer) : 1f;
                Of(set, outer, out float lift, out float drag);
                lift *= scale * (set == null ? 1f : math.smoothstep(0f, k_Even, inner));
                drag *= scale;
                float normal = lift * math.cos(outer) + drag * math.sin(outer), along = drag * math.cos(outer) - lift * math.sin(outer);
                m_Lift[k] = normal * math.cos(inner) - along * math.sin(inner);
                m_Drag[k] = normal * math.sin(inner) + along * math.cos(inner);
                m_Outer[k] = outer;
            }
        }

        /// <summary>Coefficients at an angle.</summary>
        /// <param name="angle">Angle between chord and stream, wake included, 0 to π/2.</param>
        /// <param name="lift">C_L across that stream.</param>
        /// <param name="drag">C_D along it.</param>
        /// <param name="outer">Angle without the downwash that the coefficients have, radians.</param>
        public void Evaluate(float angle, out float lift, out float drag, out float outer)
        {
            float place = math.saturate(angle / (0.5f * math.PI)) * k_Steps;
            int k = math.min((int)place, k_Steps - 1);
            float share = place - k;
            lift = math.lerp(m_Lift[k], m_Lift[k + 1], share);
            drag = math.lerp(m_Drag[k], m_Drag[k + 1], share);
            outer = math.lerp(m_Outer[k], m_Outer[k + 1], share);
        }

        // The angle whose downwash leads to the inner one. The downwash goes with the lift.
        private static float WithoutDownwash(CoefficientSet? set, MeasuredDownwash downwash, float inner)
        {
            if (downwash == MeasuredDownwash.None)
                return inner;
            float low = inner, high = 0.5f * math.PI;
            for (int k = 0; k < 24; k++)
            {
                float middle = 0.5f * (low + high);
                Of(set, middle, out float lift, out _);
                float share = downwash == MeasuredDownwash.Angle ? k_Downwash * math.cos(middle) : At(s_Angles, middle);
                if (middle - share * lift < inner)
                    low = middle;
                else
                    high = middle;
            }

            return 0.5f * (low + high);
        }

        private static float At(float[] table, float angle)
        {
            float place = angle * (2f / math.PI) * (table.Length - 1);
            int k = math.clamp((int)place, 0, table.Length - 2);
            return math.lerp(table[k], table[k + 1], math.saturate(place - k));
        }

        private static void Of(CoefficientSet? set, float angle, out float lift, out float drag)
        {
            if (set == null)
            {
                lift = 2f * math.PI * math.sin(angle);
                drag = 0f;
                return;
            }

            Coefficients.At(set.Value, math.sin(angle), math.cos(angle), out lift, out drag);
        }
    }
}
