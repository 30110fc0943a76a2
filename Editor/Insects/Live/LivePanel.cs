using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Graphs and numbers of one insect in play mode. The owner calls <see cref="Refresh"/> once a frame.</summary>
    internal sealed class LivePanel
    {
        private static class Content
        {
            public const string NotPlaying = "Press Play to see the beat here.";

            public static readonly GUIContent Flap = new GUIContent(
                "Flap angle of the first wing's tip, degrees",
                "Over one beat, from the top of the stroke at the left to the next at the right; the last beats lie one over the other. "
                + "The tip as it is deformed: it lags behind what drives it.");

            public static readonly GUIContent Lift = new GUIContent(
                "Lift over weight", "Air force on all wings against gravity, over the weight of the insect, in the same beats; each value "
                    + "is the mean of a step. It flies level where the mean is 1.");

            public static readonly GUIContent Frequency = new GUIContent("Frequency", "Of this beat of the first wing.");
            public static readonly GUIContent Range = new GUIContent(
                "Flap Range", "What drives the first wing, from lowest to highest in this beat.");
            public static readonly GUIContent MeanLift = new GUIContent("Mean Lift", "Over the beats that are drawn.");
            public static readonly GUIContent Detail = new GUIContent("Detail", "How much of the model is computed now; see Quality.");
            public static readonly GUIContent Substeps = new GUIContent("Substeps", "Of the first wing.");
            public static readonly GUIContent Stretch = new GUIContent(
                "Stretch", "Largest stretch of any wing's membrane between two joints in the last beat. Above 10 % a wing looks torn.");
            public static readonly GUIContent Resets = new GUIContent("Resets", "How often a wing was put back into its driven pose "
                + "because its state was not finite. Anything but 0 is worth a look at stiffness and substeps.");
        }

        private const int k_Capacity = 512;
        private const double k_Beats = 8.0;

        private RecentPeak m_Stretch;
        private readonly BeatTrace m_Trace = new BeatTrace(k_Capacity, k_Beats);
        private readonly BeatGraph m_Flap = new BeatGraph(
            Content.Flap, "0°", sample => sample.flap, new Color(1f, 0.7f, 0.2f), 10f, k_Capacity);
        private readonly BeatGraph m_Lift = new BeatGraph(
            Content.Lift, "0.0", sample => sample.lift, new Color(0.25f, 0.75f, 0.95f), 0.5f, k_Capacity);

        /// <summary>Recorded beats.</summary>
        public BeatTrace Trace => m_Trace;

        /// <summary>Samples the insect; returns true where there is something new to show.</summary>
        public bool Refresh(InsectWings insect)
        {
            if (!BeatReader.TryRead(insect, out BeatSample sample))
            {
                bool ended = m_Trace.Count > 0;
                m_Trace.Clear();
                m_Stretch = default;
                return ended;
            }

            double before = m_Trace.Last.beat;
            bool first = m_Trace.Count == 0;
            m_Trace.Add(sample);
            m_Stretch.Add(sample.beat, insect.Stretch);
            return first || m_Trace.Last.beat != before;
        }

        /// <summary>Draws the next lines of the inspector.</summary>
        public void Draw(InsectWings insect)
        {
            if (insect.Live == null)
            {
                EditorGUILayout.LabelField(Content.NotPlaying, EditorStyles.miniLabel);
                return;
            }

            m_Flap.Draw(m_Trace, 0.0);
            m_Lift.Draw(m_Trace, BeatReader.ForceLag(insect));
            Line(Content.Frequency, LiveNumbers.Frequency(insect));
            Line(Content.Range, LiveNumbers.FlapRange(insect));
            Line(Content.MeanLift, LiveNumbers.Lift(m_Trace.Fold()));
            Line(Content.Detail, LiveNumbers.Detail(insect));
            Line(Content.Substeps, LiveNumbers.Substeps(insect));
            Line(Content.Stretch, LiveNumbers.Stretch(m_Stretch.Value));
            Line(Content.Resets, LiveNumbers.Resets(insect).ToString());
            string overstretched = LiveNumbers.Overstretched(m_Stretch.Value);
            if (overstretched != null)
                EditorGUILayout.HelpBox(overstretched, MessageType.Warning);
        }

        private static void Line(GUIContent label, string value) => EditorGUILayout.LabelField(label, new GUIContent(value));
    }
}
