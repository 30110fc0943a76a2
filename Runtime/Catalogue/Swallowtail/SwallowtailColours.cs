using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>The colours that a swallowtail's fore and hind wings share.</summary>
    internal static class SwallowtailColours
    {
        public static readonly Color Yellow = new Color(0.96f, 0.80f, 0.33f);
        public static readonly Color Pale = new Color(0.97f, 0.87f, 0.52f);
        public static readonly Color Black = new Color(0.09f, 0.075f, 0.07f);
        public static readonly Color Dusk = new Color(0.30f, 0.25f, 0.16f);
        public static readonly Color Blue = new Color(0.30f, 0.44f, 0.78f);
        public static readonly Color Red = new Color(0.82f, 0.25f, 0.13f);
    }
}
