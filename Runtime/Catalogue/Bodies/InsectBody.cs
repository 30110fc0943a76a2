using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// A simple body made by code: X to the right, Y up, Z ahead, the origin in the middle of the thorax. It carries the wings in a picture
    /// and does not take part in the model.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class InsectBody
    {
        private readonly Lazy<(SurfaceMesh surface, int abdomen)> m_Millimetres;

        internal InsectBody(Action<BodyParts> build)
            : this(() =>
            {
                var parts = new BodyParts();
                build(parts);
                return (parts.Join(out int abdomen), abdomen);
            })
        {
        }

        /// <summary>A body of a mesh in millimetres, with normals, texture coordinates and colours.</summary>
        internal InsectBody(Func<SurfaceMesh> millimetres)
            : this(() =>
            {
                SurfaceMesh made = millimetres();
                return (made, made.VertexCount);
            })
        {
        }

        private InsectBody(Func<(SurfaceMesh, int)> millimetres)
        {
            m_Millimetres = new Lazy<(SurfaceMesh, int)>(millimetres);
        }

        /// <summary>First vertex of the abdomen in the body's mesh, after all others; the number of vertices where it has none.</summary>
        internal int AbdomenStart => m_Millimetres.Value.abdomen;

        /// <summary>The picture of its colours that was painted last.</summary>
        internal KeptPicture Picture { get; } = new KeptPicture();

        /// <summary>The body in another size.</summary>
        internal InsectBody Scaled(float factor) => factor == 1f
            ? this
            : new InsectBody(() => (CreateSurface(1000f * factor), AbdomenStart));

        /// <summary>
        /// The body as one mesh of closed parts that reach into one another, the same on both sides, with smooth normals, vertex colours,
        /// and texture coordinates in which every part has a patch of its own and the left side shares that of the right. Alpha below 255
        /// lets light through, as in a fish's fins.
        /// </summary>
        /// <param name="unitsPerMetre">Mesh units of one metre of the real insect.</param>
        public SurfaceMesh CreateSurface(float unitsPerMetre)
        {
            SurfaceMesh made = m_Millimetres.Value.surface;
            return new SurfaceMesh
            {
                positions = Array.ConvertAll(made.positions, position => position * (unitsPerMetre * 1e-3f)),
                normals = (Vector3[])made.normals.Clone(),
                uvs = (Vector2[])made.uvs.Clone(),
                colours = (Color32[])made.colours.Clone(),
                triangles = (int[])made.triangles.Clone(),
            };
        }

        /// <summary>The body without its abdomen, and the abdomen alone, with its hinge in the origin.</summary>
        /// <param name="unitsPerMetre">Mesh units of one metre of the real insect.</param>
        /// <param name="hinge">From the middle of the thorax, metres.</param>
        /// <param name="abdomen">The abdomen; null where the body has none of its own.</param>
        internal SurfaceMesh CreateParts(float unitsPerMetre, Vector3 hinge, out SurfaceMesh abdomen)
        {
            SurfaceMesh whole = CreateSurface(unitsPerMetre);
            int start = AbdomenStart;
            abdomen = null;
            if (start == whole.VertexCount)
                return whole;
            abdomen = Part(whole, start, whole.VertexCount - start);
            abdomen.positions = Array.ConvertAll(abdomen.positions, position => position - unitsPerMetre * hinge);
            return Part(whole, 0, start);
        }

        private static SurfaceMesh Part(SurfaceMesh whole, int start, int count) => new SurfaceMesh
        {
            positions = whole.positions.AsSpan(start, count).ToArray(),
            normals = whole.normals.AsSpan(start, count).ToArray(),
            uvs = whole.uvs.AsSpan(start, count).ToArray(),
            colours = whole.colours.AsSpan(start, count).ToArray(),
            triangles = Array.ConvertAll(
                Array.FindAll(whole.triangles, vertex => vertex >= start && vertex < start + count), vertex => vertex - start),
        };
    }
}
