using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Editor
{
    /// <summary>
    /// Joints of a wing over its beat, gathered from the frames of several beats: frames are too far apart to show a quick one.
    /// </summary>
    internal sealed class JointTrace
    {
        private const int k_Capacity = 128;

        /// <summary>Beats back from the last frame that count.</summary>
        private const double k_Beats = 8.0;

        /// <summary>Longest part of a beat without a frame.</summary>
        private const double k_Gap = 0.26;

        private readonly List<(double beat, float3[] joints)> m_Frames = new List<(double beat, float3[] joints)>();

        /// <summary>Takes the joints of a frame; one of another beat begins a new trace.</summary>
        /// <param name="beat">Time in beats; a frame at the time of the last one changes nothing.</param>
        /// <param name="joints">Kept, not copied.</param>
        public void Add(double beat, float3[] joints)
        {
            double last = m_Frames.Count == 0 ? double.NegativeInfinity : m_Frames[m_Frames.Count - 1].beat;
            if (beat == last)
                return;
            if (beat < last || (m_Frames.Count > 0 && m_Frames[0].joints.Length != joints.Length))
                m_Frames.Clear();
            m_Frames.Add((beat, joints));
            m_Frames.RemoveAll(frame => frame.beat < beat - k_Beats);
            if (m_Frames.Count > k_Capacity)
                m_Frames.RemoveAt(0);
        }

        /// <summary>Finds the joints at even phases, from 0, on straight lines between frames of neighbouring phases.</summary>
        /// <param name="count">Phases, 1 or more.</param>
        /// <param name="even">[phase][joint]</param>
        /// <returns>False where a quarter of the beat or more has no frame.</returns>
        public bool TrySample(int count, out float3[][] even)
        {
            even = null;
            if (m_Frames.Count == 0)
                return false;
            List<(double phase, float3[] joints)> folded =
                m_Frames.ConvertAll(frame => (frame.beat - math.floor(frame.beat), frame.joints));
            folded.Sort((a, b) => a.phase.CompareTo(b.phase));
            for (int k = 0; k < folded.Count; k++)
            {
                if (Apart(folded[k].phase, folded[(k + 1) % folded.Count].phase) > k_Gap)
                    return false;
            }

            even = new float3[count][];
            for (int k = 0; k < count; k++)
            {
                double phase = (double)k / count;
                int next = folded.FindIndex(frame => frame.phase >= phase);
                next = next < 0 ? 0 : next;
                (double phase, float3[] joints) before = folded[(next + folded.Count - 1) % folded.Count], after = folded[next];
                double width = Apart(before.phase, after.phase), way = Apart(before.phase, phase);
                even[k] = Between(before.joints, after.joints, width > 0.0 ? (float)(way / width) : 0f);
            }

            return true;
        }

        // From one phase on to another one, up to a whole beat to itself.
        private static double Apart(double from, double to) => to > from ? to - from : to - from + 1.0;

        private static float3[] Between(float3[] from, float3[] to, float share)
        {
            var between = new float3[from.Length];
            for (int k = 0; k < between.Length; k++)
                between[k] = math.lerp(from[k], to[k], math.saturate(share));
            return between;
        }
    }
}
