using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A part in its place on a body: in the middle, or on the right with a twin on the left; how it is painted, and its patch of the
    /// texture.
    /// </summary>
    internal sealed class BodyPatch
    {
        public BodyPart part;
        public BodyPaint paint;
        public bool isPair, isAbdomen;
        public int shelf;
    }

    /// <summary>Gathers the parts of a body and joins them to one mesh that is symmetric left and right.</summary>
    internal sealed class BodyParts
    {
        private readonly List<BodyPatch> m_Patches = new List<BodyPatch>();
        private readonly List<Vector2> m_Extents = new List<Vector2>();

        /// <summary>Adds a part of the middle, itself symmetric.</summary>
        public BodyPatch Add(BodyPart part, BodyPaint paint) => Add(part, paint, false);

        /// <summary>Adds the abdomen, which may swing.</summary>
        public BodyPatch AddAbdomen(BodyPart part, BodyPaint paint)
        {
            BodyPatch patch = Add(part, paint, false);
            patch.isAbdomen = true;
            return patch;
        }

        /// <summary>Adds a part of the right side and its twin on the left; both share one patch of the texture.</summary>
        public BodyPatch AddPair(BodyPart right, BodyPaint paint) => Add(right, paint, true);

        /// <summary>Adds a part of the right side that swings with the abdomen, and its twin on the left.</summary>
        public BodyPatch AddAbdomenPair(BodyPart right, BodyPaint paint)
        {
            BodyPatch patch = AddPair(right, paint);
            patch.isAbdomen = true;
            return patch;
        }

        /// <summary>Adds hair that grew on the right side of a patch; it takes the texture of the skin it grows on.</summary>
        public void AddFur(BodyPatch skin, BodyPart hair, BodyPaint paint) =>
            m_Patches.Add(new BodyPatch { part = hair, paint = paint, isPair = true, isAbdomen = skin.isAbdomen, shelf = skin.shelf });

        /// <summary>Joins all parts to one mesh, millimetres.</summary>
        /// <param name="abdomen">First vertex of the abdomen, which comes last; the number of all where there is none.</param>
        public SurfaceMesh Join(out int abdomen)
        {
            Rect[] shelves = UvShelves.Lay(m_Extents);
            var positions = new List<Vector3>();
            var normals = new List<Vector3>();
            var uvs = new List<Vector2>();
            var colours = new List<Color32>();
            var triangles = new List<int>();
            abdomen = int.MaxValue;
            foreach (BodyPatch patch in m_Patches.OrderBy(patch => patch.isAbdomen))
            {
                if (patch.isAbdomen)
                    abdomen = Mathf.Min(abdomen, positions.Count);
                Rect shelf = shelves[patch.shelf];
                Color32[] painted = Colours(patch);
                foreach (BodyPart part in patch.isPair ? new[] { patch.part, patch.part.Mirrored() } : new[] { patch.part })
                {
                    int first = positions.Count;
                    positions.AddRange(part.Positions);
                    normals.AddRange(part.Normals);
                    uvs.AddRange(
                        Array.ConvertAll(part.Uvs, uv => new Vector2(shelf.x + uv.x * shelf.width, shelf.y + uv.y * shelf.height)));
                    colours.AddRange(painted);
                    triangles.AddRange(Array.ConvertAll(part.Triangles, vertex => first + vertex));
                }
            }

            abdomen = Mathf.Min(abdomen, positions.Count);
            return new SurfaceMesh
            {
                positions = positions.ToArray(),
                normals = normals.ToArray(),
                uvs = uvs.ToArray(),
                colours = colours.ToArray(),
                triangles = triangles.ToArray(),
            };
        }

        private BodyPatch Add(BodyPart part, BodyPaint paint, bool isPair)
        {
            m_Patches.Add(new BodyPatch { part = part, paint = paint, isPair = isPair, shelf = m_Extents.Count });
            m_Extents.Add(part.Extent);
            return m_Patches[m_Patches.Count - 1];
        }

        // A part of the middle is painted as its right half everywhere.
        private static Color32[] Colours(BodyPatch patch)
        {
            BodyPart part = patch.part;
            var colours = new Color32[part.Positions.Length];
            for (int vertex = 0; vertex < colours.Length; vertex++)
            {
                Vector3 place = part.Positions[vertex];
                Vector3 normal = part.Normals[vertex];
                if (place.x < 0f && !patch.isPair)
                {
                    place.x = -place.x;
                    normal.x = -normal.x;
                }

                colours[vertex] = patch.paint(new BodyPoint(place, normal, part.Uvs[vertex]));
            }

            return colours;
        }
    }
}
