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
        private readonly Lazy<SurfaceMesh> m_Millimetres;

        internal InsectBody(Action<BodyParts> build)
        {
            m_Millimetres = new Lazy<SurfaceMesh>(() =>
            {
                var parts = new BodyParts();
                build(parts);
                return parts.Join();
            });
        }

        /// <summary>A body of a mesh in millimetres, with normals, texture coordinates and colours.</summary>
        internal InsectBody(Func<SurfaceMesh> millimetres)
        {
            m_Millimetres = new Lazy<SurfaceMesh>(millimetres);
        }

        /// <summary>The picture of its colours that was painted last.</summary>
        internal KeptPicture Picture { get; } = new KeptPicture();

        /// <summary>The body in another size.</summary>
        internal InsectBody Scaled(float factor) => factor == 1f
            ? this
            : new InsectBody(() => CreateSurface(1000f * factor));

        /// <summary>
        /// The body as one mesh of closed parts that reach into one another, the same on both sides, with smooth normals, vertex colours,
        /// and texture coordinates in which every part has a patch of its own and the left side shares that of the right. Alpha below 255
        /// lets light through, as in a fish's fins.
        /// </summary>
        /// <param name="unitsPerMetre">Mesh units of one metre of the real insect.</param>
        public SurfaceMesh CreateSurface(float unitsPerMetre)
        {
            SurfaceMesh made = m_Millimetres.Value;
            return new SurfaceMesh
            {
                positions = Array.ConvertAll(made.positions, position => position * (unitsPerMetre * 1e-3f)),
                normals = (Vector3[])made.normals.Clone(),
                uvs = (Vector2[])made.uvs.Clone(),
                colours = (Color32[])made.colours.Clone(),
                triangles = (int[])made.triangles.Clone(),
            };
        }
    }
}
