using System;
using System.Globalization;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws one value of the last beats against the phase of the beat.</summary>
    internal sealed class BeatGraph
    {
        private const float k_Height = 64f, k_LineWidth = 2f, k_Padding = 4f;
        private static readonly Color s_Axis = new Color(0.5f, 0.5f, 0.5f, 0.5f);
        private static readonly Color s_DarkGround = new Color(0f, 0f, 0f, 0.25f), s_LightGround = new Color(1f, 1f, 1f, 0.35f);

        private readonly GUIContent m_Title;
        private readonly string m_Format;
        private readonly Func<BeatSample, float> m_Value;
        private readonly Color m_Colour;
        private readonly float m_LeastRange;
        private readonly GraphCurve m_Curve;
        private GraphScale m_Scale;

        /// <param name="title">Above the graph, with its tooltip.</param>
        /// <param name="format">Of the numbers at its left side, such as "0°".</param>
        /// <param name="value">What is drawn.</param>
        /// <param name="colour">Of the line.</param>
        /// <param name="leastRange">From bottom to top, however little the value varies.</param>
        /// <param name="capacity">Most samples of a trace.</param>
        public BeatGraph(GUIContent title, string format, Func<BeatSample, float> value, Color colour, float leastRange, int capacity)
        {
            m_Title = title;
            m_Format = format;
            m_Value = value;
            m_Colour = colour;
            m_LeastRange = leastRange;
            m_Curve = new GraphCurve(capacity);
        }

        /// <summary>Draws the next lines of the inspector.</summary>
        /// <param name="trace">The last beats.</param>
        /// <param name="lag">Beats by which the value lay back when it was sampled.</param>
        public void Draw(BeatTrace trace, double lag)
        {
            EditorGUILayout.LabelField(m_Title, EditorStyles.miniBoldLabel);
            Rect area = EditorGUILayout.GetControlRect(false, k_Height);
            if (Event.current.type != EventType.Repaint)
                return;
            ReadOnlySpan<BeatSample> folded = trace.Fold(lag);
            Fit(folded);
            EditorGUI.DrawRect(area, EditorGUIUtility.isProSkin ? s_DarkGround : s_LightGround);
            Rect inner = Inner(area);
            DrawAxis(inner);
            DrawCurve(inner, folded);
            DrawNow(inner, folded);
            GUI.Label(area, m_Scale.High.ToString(m_Format, CultureInfo.InvariantCulture), EditorStyles.miniLabel);
            GUI.Label(BottomLine(area), m_Scale.Low.ToString(m_Format, CultureInfo.InvariantCulture), EditorStyles.miniLabel);
        }

        private void Fit(ReadOnlySpan<BeatSample> folded)
        {
            float low = 0f, high = 0f;
            foreach (BeatSample sample in folded)
            {
                low = Mathf.Min(low, m_Value(sample));
                high = Mathf.Max(high, m_Value(sample));
            }

            m_Scale.Fit(low, high, m_LeastRange);
        }

        private void DrawAxis(Rect inner)
        {
            Handles.color = s_Axis;
            float zero = m_Scale.Place(0f);
            Handles.DrawAAPolyLine(1f, GraphCurve.At(inner, 0f, zero), GraphCurve.At(inner, 1f, zero));
            Handles.DrawAAPolyLine(1f, GraphCurve.At(inner, 0.5f, 0f), GraphCurve.At(inner, 0.5f, 1f));
        }

        private void DrawCurve(Rect inner, ReadOnlySpan<BeatSample> folded)
        {
            m_Curve.Lay(folded, m_Value, m_Scale, inner);
            if (m_Curve.Count < 2)
                return;
            Handles.color = m_Colour;
            Handles.DrawAAPolyLine(k_LineWidth, m_Curve.Count, m_Curve.Points);
        }

        private void DrawNow(Rect inner, ReadOnlySpan<BeatSample> folded)
        {
            if (folded.Length == 0)
                return;
            BeatSample now = folded[0];
            foreach (BeatSample sample in folded)
                now = sample.beat > now.beat ? sample : now;
            Vector3 at = GraphCurve.At(inner, now.Phase, m_Scale.Place(m_Value(now)));
            EditorGUI.DrawRect(new Rect(at.x - 2f, at.y - 2f, 5f, 5f), m_Colour);
        }

        private static Rect Inner(Rect area) =>
            new Rect(area.x + k_Padding, area.y + k_Padding, area.width - 2f * k_Padding, area.height - 2f * k_Padding);

        private static Rect BottomLine(Rect area)
        {
            float line = EditorGUIUtility.singleLineHeight;
            return new Rect(area.x, area.yMax - line, area.width, line);
        }
    }
}
