using System.Collections.Generic;
using UnityEngine;

namespace Alate.Showcase
{
    /// <summary>
    /// A column of labels, sliders and buttons on the screen of a running scene, for samples and trials. It needs nothing in the project,
    /// and works with the Input Manager, the Input System package and both: IMGUI draws it, which it does with any of them, and the panel
    /// reads the pointer itself.
    /// </summary>
    /// <example>
    /// <code>
    /// private readonly ScreenPanel m_Panel = new ScreenPanel(280f);
    ///
    /// private void OnGUI()
    /// {
    ///     if (!m_Panel.Begin())
    ///         return;
    ///     m_Speed = m_Panel.Slider($"Speed {m_Speed:0.0} m/s", m_Speed, 0f, 2f);
    ///     m_Panel.End();
    /// }
    /// </code>
    /// </example>
    public sealed class ScreenPanel
    {
        private const float k_Margin = 10f, k_Padding = 8f, k_Gap = 4f, k_Line = 22f, k_SliderHeight = 14f;

        /// <summary>Dots an inch at which a unit of the panel is a pixel.</summary>
        private const float k_Dpi = 96f;

        private static readonly List<ScreenPanel> s_Drawn = new List<ScreenPanel>();
        private static ScreenPanel s_HeldPanel;
        private static int s_HeldControl;

        private readonly float m_Width;
        private PointerFrame m_Pointer;
        private Vector2 m_Place;
        private Rect m_Area;
        private float m_Scale = 1f, m_Next, m_Row;
        private int m_Control, m_Columns, m_Column, m_Frame = -1;
        private bool m_Pressed, m_Released, m_WasDown;

        /// <summary>Makes a panel for the upper left corner of the screen.</summary>
        /// <param name="width">Width, units: a pixel at 96 dots an inch, more on finer screens.</param>
        public ScreenPanel(float width)
        {
            m_Width = width;
        }

        /// <summary>Number key that went down in this frame, 0 to 9; −1 for none.</summary>
        public int Digit { get; private set; } = -1;

        /// <summary>Returns true where a panel of the last frame lies.</summary>
        /// <param name="place">Pixels from the upper left corner of the screen.</param>
        public static bool Covers(Vector2 place)
        {
            foreach (ScreenPanel panel in s_Drawn)
            {
                // A panel that is drawn no more covers nothing.
                if (panel.m_Frame >= Time.frameCount - 1 && panel.m_Area.Contains(place / panel.m_Scale))
                    return true;
            }

            return false;
        }

        /// <summary>Begins the panel in <c>OnGUI</c>.</summary>
        /// <returns>False for events other than the repaint: return from <c>OnGUI</c> then.</returns>
        public bool Begin()
        {
            if (Event.current.type != EventType.Repaint)
                return false;

            // A window that is painted twice in a frame reacts once.
            bool isNew = m_Frame != Time.frameCount;
            m_Frame = Time.frameCount;
            m_Pointer = PointerReader.Now;
            m_Scale = Mathf.Max(1f, Mathf.Round(2f * Screen.dpi / k_Dpi) / 2f);
            m_Place = m_Pointer.position / m_Scale;
            m_Pressed = isNew && m_Pointer.isDown && !m_WasDown;
            m_Released = isNew && !m_Pointer.isDown && m_WasDown;
            m_WasDown = m_Pointer.isDown;
            Digit = isNew ? m_Pointer.digit : -1;
            if (m_Pressed)
                s_HeldPanel = null;
            if (!s_Drawn.Contains(this))
                s_Drawn.Add(this);
            s_Drawn.RemoveAll(panel => panel.m_Frame < m_Frame - 1);
            m_Control = m_Columns = m_Column = 0;
            m_Next = k_Margin + k_Padding;
            m_Row = 0f;
            GUI.matrix = Matrix4x4.Scale(new Vector3(m_Scale, m_Scale, 1f));
            GUI.Box(m_Area, "");
            return true;
        }

        /// <summary>Ends the panel.</summary>
        public void End()
        {
            EndRow();
            m_Area = new Rect(k_Margin, k_Margin, m_Width, m_Next - k_Margin - k_Gap + k_Padding);
            if (m_Released && s_HeldPanel == this)
                s_HeldPanel = null;
            GUI.matrix = Matrix4x4.identity;
        }

        /// <summary>Puts the next controls side by side.</summary>
        /// <param name="columns">Number of controls.</param>
        public void Row(int columns)
        {
            EndRow();
            m_Columns = columns;
        }

        /// <summary>Writes a text, on as many lines as it needs.</summary>
        public void Label(string text)
        {
            float width = NextWidth;
            GUI.Label(Next(Mathf.Max(k_Line, GUI.skin.label.CalcHeight(new GUIContent(text), width))), text);
        }

        /// <summary>Draws a slider below its label.</summary>
        /// <param name="label">Name and value.</param>
        /// <param name="value">Value now.</param>
        /// <param name="least">Value at the left end.</param>
        /// <param name="most">Value at the right end.</param>
        /// <returns>The value, moved where the user drags the slider.</returns>
        public float Slider(string label, float value, float least, float most)
        {
            Label(label);
            Rect place = Next(k_SliderHeight);
            var reach = new Rect(place.x - k_Gap, place.y - k_Gap, place.width + 2f * k_Gap, place.height + 2f * k_Gap);
            if (Holds(reach))
                value = Mathf.Lerp(least, most, Mathf.InverseLerp(place.xMin, place.xMax, m_Place.x));
            GUI.HorizontalSlider(place, value, least, most);
            return value;
        }

        /// <summary>Draws a box that is ticked or not.</summary>
        /// <returns>The value, changed where the user presses the box.</returns>
        public bool Toggle(string text, bool value)
        {
            Rect place = Next(k_Line);
            value ^= IsPressed(place);
            GUI.Toggle(place, value, text);
            return value;
        }

        /// <summary>Draws a button.</summary>
        /// <returns>True where the user lets it go.</returns>
        public bool Button(string text)
        {
            Rect place = Next(k_Line);
            bool isPressed = IsPressed(place);
            GUI.Button(place, text);
            return isPressed;
        }

        /// <summary>Draws buttons side by side, one of them chosen.</summary>
        /// <returns>Index of the chosen one.</returns>
        public int Choose(int chosen, IReadOnlyList<string> texts)
        {
            Row(texts.Count);
            for (int k = 0; k < texts.Count; k++)
            {
                Rect place = Next(k_Line);
                chosen = IsPressed(place) ? k : chosen;
                GUI.Toggle(place, chosen == k, texts[k]);
            }

            return chosen;
        }

        // Frames are counted from the beginning of each play, and statics may outlive it.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget()
        {
            s_Drawn.Clear();
            s_HeldPanel = null;
        }

        private float NextWidth => (m_Width - 2f * k_Padding - Mathf.Max(0, m_Columns - 1) * k_Gap) / Mathf.Max(1, m_Columns);

        private Rect Next(float height)
        {
            float width = NextWidth;
            var place = new Rect(k_Margin + k_Padding + m_Column * (width + k_Gap), m_Next, width, height);
            m_Control++;
            m_Row = Mathf.Max(m_Row, height + k_Gap);
            if (++m_Column >= m_Columns)
                EndRow();
            return place;
        }

        // A row is as high as its highest control.
        private void EndRow()
        {
            m_Columns = m_Column = 0;
            m_Next += m_Row;
            m_Row = 0f;
        }

        // A control that was pressed is held until it is let go, wherever the pointer is.
        private bool Holds(Rect place)
        {
            if (m_Pressed && place.Contains(m_Place))
                (s_HeldPanel, s_HeldControl) = (this, m_Control);
            return s_HeldPanel == this && s_HeldControl == m_Control && (m_Pointer.isDown || m_Released);
        }

        private bool IsPressed(Rect place) => Holds(place) && m_Released && place.Contains(m_Place);
    }
}
