using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Appearance of a material, independent of the shader.</summary>
    internal readonly struct SurfaceLook
    {
        public SurfaceLook(Texture2D texture, bool isThin, PictureOpacity opacity, Color? underside = null)
        {
            Texture = texture;
            IsThin = isThin;
            Opacity = opacity;
            Underside = underside ?? WingPattern.NoUnderside;
        }

        /// <summary>The colours; null takes those of the vertices, where the shader shows them.</summary>
        public Texture2D Texture { get; }

        /// <summary>True for a wing or fin, which is seen from both sides and lets light through; false for a closed body.</summary>
        public bool IsThin { get; }

        /// <summary>Use of alpha.</summary>
        public PictureOpacity Opacity { get; }

        /// <summary>True where things behind show through, by alpha.</summary>
        public bool IsTranslucent => Opacity == PictureOpacity.Clear;

        /// <summary>True where alpha tells the outline alone.</summary>
        public bool IsCut => Opacity == PictureOpacity.Cut;

        /// <summary>Colour towards which the lower side is paler, as <see cref="WingPattern.Underside"/>.</summary>
        public Color Underside { get; }

        /// <summary>
        /// True for bodies and other solid things, which hide what is behind them and their own far side. False for translucent wings: two
        /// of them are seen through each other, and the body through both.
        /// </summary>
        public bool WritesDepth => !IsTranslucent || !IsThin;
    }
}
