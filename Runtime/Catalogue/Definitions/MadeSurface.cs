using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>The meshed outline of a wing, kept for the next insect: to fill it evenly takes the longest of making one.</summary>
    internal sealed class MadeSurface
    {
        private readonly double m_Length;
        private readonly float m_Scale;
        private readonly int m_TriangleCount;
        private readonly bool m_IsFilled;
        private readonly RimScallops m_Scallops;
        private readonly WingPattern m_Pattern;
        private MarginCut m_Margin;

        /// <summary>Meshes the outline of a wing.</summary>
        /// <param name="wing">A wing with an outline.</param>
        /// <param name="scale">Mesh units of one wing length.</param>
        public MadeSurface(WingDefinition wing, float scale)
        {
            (m_Length, m_Scale, m_TriangleCount, m_IsFilled) = (wing.Length, scale, wing.TriangleCount, wing.IsFilled);
            (m_Scallops, m_Pattern) = (wing.Scallops, wing.Pattern);
            Surface = m_IsFilled
                ? WingMesher.Fill(wing.Contour, m_Scallops, m_TriangleCount, scale)
                : WingMesher.Strips(wing.Contour, m_TriangleCount, scale);
            Surface.name = wing.Name;
            Surface.colours = m_Pattern?.ColourVertices(Surface, scale, Math.Sqrt(2 * wing.Contour.Area / m_TriangleCount));
        }

        /// <summary>The right wing; nobody may change it.</summary>
        public SurfaceMesh Surface { get; }

        /// <summary>Its margin.</summary>
        public MarginCut Margin => m_Margin ??= new MarginCut(Surface, m_Scale);

        /// <summary>Returns true where it is what the wing's numbers ask for now.</summary>
        public bool Is(WingDefinition wing, float scale) => m_Length == wing.Length && m_Scale == scale
            && m_TriangleCount == wing.TriangleCount && m_IsFilled == wing.IsFilled && m_Scallops == wing.Scallops
            && m_Pattern == wing.Pattern;

        /// <summary>The right wing in arrays of its own.</summary>
        public SurfaceMesh Copy() => new SurfaceMesh
        {
            name = Surface.name,
            positions = (Vector3[])Surface.positions.Clone(),
            normals = (Vector3[])Surface.normals.Clone(),
            uvs = (Vector2[])Surface.uvs.Clone(),
            colours = (Color32[])Surface.colours?.Clone(),
            triangles = (int[])Surface.triangles.Clone(),
        };
    }
}
