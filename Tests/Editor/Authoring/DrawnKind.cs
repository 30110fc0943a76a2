using System;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Ways in which tests draw a wing.</summary>
    public enum DrawnKind
    {
        /// <summary>Black on white.</summary>
        Silhouette,

        /// <summary>White on black, with grey noise of strength 25.</summary>
        Noisy,

        /// <summary>On ground that darkens to one corner.</summary>
        Gradient,

        /// <summary>Picture with the blocks and ripples of strong JPEG compression.</summary>
        Compressed,

        /// <summary>Picture with all of those faults at once.</summary>
        Hard,

        /// <summary>On transparent ground.</summary>
        Transparent,

        /// <summary>Outline drawn in thin black on white.</summary>
        Drawing,
    }

    /// <summary>Draws wings in those ways.</summary>
    internal static class DrawnKinds
    {
        private static readonly Color32 s_White = new Color32(255, 255, 255, 255), s_Black = new Color32(0, 0, 0, 255);
        private static readonly Color32 s_Paper = new Color32(205, 200, 190, 255), s_Dark = new Color32(70, 60, 80, 255);

        public static DrawnPicture Draw(this WingPlace wing, DrawnKind kind, int seed = 1)
        {
            int side = wing.Side;
            switch (kind)
            {
                case DrawnKind.Silhouette:
                    return new DrawnPicture(side, side, s_White).Fill(wing.Outline, s_Black);
                case DrawnKind.Noisy:
                    return new DrawnPicture(side, side, s_Black).Fill(wing.Outline, s_White).Noise(25f, seed);
                case DrawnKind.Gradient:
                    return new DrawnPicture(side, side, s_Paper).Shade(Gradient).Fill(wing.Outline, s_Dark);
                case DrawnKind.Compressed:
                    return new DrawnPicture(side, side, s_Paper).Fill(wing.Outline, s_Dark).Compress(2f);
                case DrawnKind.Hard:
                    return new DrawnPicture(side, side, s_Paper).Shade(Gradient).Fill(wing.Outline, s_Dark).Noise(14f, seed).Compress(1.5f);
                case DrawnKind.Transparent:
                    return new DrawnPicture(side, side, new Color32(0, 0, 0, 0)).Fill(wing.Outline, new Color32(200, 120, 30, 255));
                case DrawnKind.Drawing:
                    return new DrawnPicture(side, side, s_White).Stroke(Closed(wing.Outline), Math.Max(1.2f, side / 400f), s_Black);
                default:
                    throw new ArgumentOutOfRangeException(nameof(kind), kind, "There is no such way.");
            }
        }

        private static float Gradient(float x, float y) => 45f * (x - 0.5f) - 30f * (y - 0.5f) - 40f * (x - 0.3f) * (x - 0.3f);

        private static Vector2[] Closed(Vector2[] outline)
        {
            var closed = new Vector2[outline.Length + 1];
            outline.CopyTo(closed, 0);
            closed[outline.Length] = outline[0];
            return closed;
        }
    }
}
