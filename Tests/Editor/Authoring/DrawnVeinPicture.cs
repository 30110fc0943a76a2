using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>A wing with veins, as a photo or a drawing.</summary>
    internal sealed class DrawnVeinPicture
    {
        private readonly DrawnVeins m_Veins;
        private readonly float m_Rear;

        /// <param name="wing">Its shape.</param>
        /// <param name="side">Of the picture, pixels.</param>
        /// <param name="count">Radial veins.</param>
        /// <param name="look">How it is drawn.</param>
        /// <param name="rear">Width of the last vein over that of the first.</param>
        public DrawnVeinPicture(DrawnWing wing, int side, int count, VeinLook look, float rear = 1f)
        {
            m_Rear = rear;
            Place = wing.In(side);
            m_Veins = DrawnVeins.In(wing, count);
            Root = Place.At(0.5f * (wing.Outline[0] + wing.Outline[wing.Outline.Length - 1]));
            Picture = Draw(look, side / 250f);
        }

        public DrawnPicture Picture { get; }

        public WingPlace Place { get; }

        /// <summary>The middle of the base, pixels.</summary>
        public Vector2 Root { get; }

        /// <summary>Pixels.</summary>
        public List<Vector2[]> Radial
        {
            get
            {
                var lines = new List<Vector2[]>();
                foreach (Vector2[] vein in m_Veins.Radial)
                    lines.Add(Place.At(vein));
                return lines;
            }
        }

        private DrawnPicture Draw(VeinLook look, float line)
        {
            bool isDrawing = look == VeinLook.Drawing, isBright = look == VeinLook.BrightOnDark;
            Color32 vein = isDrawing ? Grey(20) : isBright ? Grey(170) : new Color32(90, 60, 30, 255);
            Color32 wing = isBright ? Grey(70) : new Color32(200, 140, 60, 255);
            var picture = new DrawnPicture(Place.Side, Place.Side, isDrawing ? Grey(255) : Grey(210));
            if (isDrawing)
                picture.Stroke(Place.Outline, line, Grey(0));
            else
                picture.Shade((x, y) => 30f * (x - 0.5f) - 30f * (y - 0.5f) * (y - 0.5f)).Fill(Place.Outline, wing);
            for (int k = 0; k < m_Veins.Radial.Count; k++)
            {
                Vector2[] path = Place.At(m_Veins.Radial[k]);
                picture.Stroke(path, Mathf.Lerp(1f, m_Rear, k / Mathf.Max(1f, m_Veins.Radial.Count - 1f)) * line, vein);
                if (look == VeinLook.Broken)
                    Break(picture, path, 7 + 2 * k, line, wing);
            }

            foreach (Vector2[] cross in m_Veins.Cross)
                picture.Stroke(Place.At(cross), 0.6f * line, vein);
            return isDrawing ? picture : picture.Noise(10f, 3).Compress(1f);
        }

        private static void Break(DrawnPicture picture, Vector2[] path, int at, float line, Color32 wing)
        {
            picture.Stroke(new[] { path[at], path[at + 1] }, 1.5f * line, wing);
            picture.Stroke(new[] { path[at + 11], path[at + 12] }, 1.5f * line, wing);
        }

        private static Color32 Grey(byte shade) => new Color32(shade, shade, shade, 255);
    }

    /// <summary>Look of veins.</summary>
    public enum VeinLook
    {
        /// <summary>Dark on a brown wing, with noise and compression.</summary>
        Photo,

        /// <summary>Black lines on white.</summary>
        Drawing,

        /// <summary>Bright on a dark wing, with noise and compression.</summary>
        BrightOnDark,

        /// <summary>A photo whose veins are interrupted.</summary>
        Broken,
    }
}
