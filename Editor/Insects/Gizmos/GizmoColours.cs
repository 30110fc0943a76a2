using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Colours of gizmos, which can be told apart without telling red from green.</summary>
    internal static class GizmoColours
    {
        private static readonly Color s_Early = new Color(1f, 0.76f, 0.22f), s_Middle = new Color(0.87f, 0.35f, 0.43f),
            s_Late = new Color(0.27f, 0.36f, 0.87f);

        public static readonly Color Hinge = new Color(1f, 1f, 1f), Span = new Color(0.93f, 0.42f, 0.35f),
            Up = new Color(0.55f, 0.83f, 0.4f);
        public static readonly Color Load = new Color(0.35f, 0.85f, 0.95f, 0.6f), Force = new Color(0.2f, 0.9f, 1f);
        public static readonly Color Velocity = new Color(1f, 1f, 1f, 0.9f), Wind = new Color(0.6f, 0.8f, 1f, 0.9f),
            Bounds = new Color(0.7f, 0.7f, 0.7f, 0.5f);

        /// <summary>Rings that turn as a wing sheds them that the air pushes up, and the others.</summary>
        public static readonly Color WakeUp = new Color(1f, 0.55f, 0.25f), WakeDown = new Color(0.35f, 0.6f, 1f);

        /// <summary>Colour of a delay: 0 yellow, with the root of the leading edge; 1 blue, last of all.</summary>
        public static Color Delay(float delay) =>
            delay < 0.5f ? Color.Lerp(s_Early, s_Middle, 2f * delay) : Color.Lerp(s_Middle, s_Late, 2f * delay - 1f);
    }
}
