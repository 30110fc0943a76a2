using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>What a material shall look like, whatever the shader.</summary>
    internal readonly struct SurfaceLook
    {
        public SurfaceLook(Texture2D texture, bool isThin, bool isTranslucent)
        {
            Texture = texture;
            IsThin = isThin;
            IsTranslucent = isTranslucent;
        }

        /// <summary>The colours; null takes those of the vertices, where the shader shows them.</summary>
        public Texture2D Texture { get; }

        /// <summary>A wing or fin, seen from both sides, through which light shines; else a closed body.</summary>
        public bool IsThin { get; }

        /// <summary>Whether what lies behind is seen through it, by alpha.</summary>
        public bool IsTranslucent { get; }

        /// <summary>
        /// Bodies and other solid things hide what is behind them, also their own far side. Translucent wings do not: two of them are seen through each other,
        /// and the body through both.
        /// </summary>
        public bool WritesDepth => !IsTranslucent || !IsThin;
    }
}
