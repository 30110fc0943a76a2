using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>The triangles of an insect that one material draws.</summary>
    public sealed class BakedPart
    {
        internal BakedPart(string name, Material material, bool hasColours, int[] triangles)
        {
            Name = name;
            Material = material;
            HasColours = hasColours;
            Triangles = triangles;
        }

        /// <summary>Name of the renderer that the first of them came from.</summary>
        public string Name { get; }

        /// <summary>The material; null where there is none.</summary>
        public Material Material { get; }

        /// <summary>True where the vertices have colours of their own.</summary>
        public bool HasColours { get; }

        /// <summary>Three vertices a triangle, wound as Unity winds the side that is seen.</summary>
        public int[] Triangles { get; }
    }
}
