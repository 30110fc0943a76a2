using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Hands out the lines of a property drawer from top to bottom.</summary>
    internal struct Rows
    {
        private Rect m_Rest;

        /// <summary>Starts with the first line of a rect.</summary>
        public Rows(Rect position)
        {
            m_Rest = position;
        }

        /// <summary>Height of a number of lines of one field each.</summary>
        public static float HeightOf(int lines) =>
            lines * EditorGUIUtility.singleLineHeight + Mathf.Max(lines - 1, 0) * EditorGUIUtility.standardVerticalSpacing;

        /// <summary>The next line.</summary>
        public Rect Next() => Next(EditorGUIUtility.singleLineHeight);

        /// <summary>The next line, of some height.</summary>
        public Rect Next(float height)
        {
            var line = new Rect(m_Rest.x, m_Rest.y, m_Rest.width, height);
            m_Rest.yMin += height + EditorGUIUtility.standardVerticalSpacing;
            return line;
        }
    }
}
