using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>A vector from outside, of which the last one within its bound counts; the first one that is refused is told.</summary>
    internal struct GuardedVector
    {
        private float3 m_Last;
        private bool m_IsTold;

        /// <summary>The vector, or the last one that was good where it is not.</summary>
        /// <param name="value">What somebody has set.</param>
        /// <param name="most">Largest component.</param>
        /// <param name="kind">What it is, for the message.</param>
        /// <param name="unit">Unit of value and bound, for the message.</param>
        /// <param name="context">Object whose it is; null for the scene's.</param>
        public float3 Guard(float3 value, float most, string kind, string unit, Object context)
        {
            if (OuterBounds.Hold(value, most))
                return m_Last = value;
            if (!m_IsTold)
                Tell(value, most, kind, unit, context);
            return m_Last;
        }

        private void Tell(float3 value, float most, string kind, string unit, Object context)
        {
            m_IsTold = true;
            string whose = context == null ? "" : $"'{context.name}': ";
            string allowed = most < float.MaxValue ? $"at most {most} {unit} along each axis" : "finite";
            string read = $"({value.x}, {value.y}, {value.z}) {unit}";
            Debug.LogWarning($"{whose}{kind} of {read} is refused, the last good one counts: it must be {allowed}.", context);
        }
    }
}
