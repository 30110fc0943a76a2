using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>A painted picture, kept for the next material that asks for it as long as nobody else needs its memory.</summary>
    internal sealed class KeptPicture
    {
        private readonly WeakReference<Color32[]> m_Pixels = new WeakReference<Color32[]>(null);
        private (object Drawing, int Width, int Height) m_Kept;

        /// <summary>Pixels of a drawing in a size, which nobody may change; painted where they are not those that are kept.</summary>
        /// <param name="drawing">What is drawn.</param>
        /// <param name="width">Columns.</param>
        /// <param name="height">Rows.</param>
        /// <param name="paint">Paints them.</param>
        public Color32[] Get(object drawing, int width, int height, Func<Color32[]> paint)
        {
            if (m_Kept == (drawing, width, height) && m_Pixels.TryGetTarget(out Color32[] kept))
                return kept;
            Color32[] painted = paint();
            m_Pixels.SetTarget(painted);
            m_Kept = (drawing, width, height);
            return painted;
        }
    }
}
