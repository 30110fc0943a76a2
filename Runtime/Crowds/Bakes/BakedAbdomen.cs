using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>An abdomen of a baked insect that swings: vertices behind one another, and the joint that they follow.</summary>
    public sealed class BakedAbdomen
    {
        /// <summary>Name of what is drawn.</summary>
        public string Name { get; internal set; }

        /// <summary>First of its vertices in the surface, and how many.</summary>
        public int FirstVertex { get; internal set; }

        /// <summary>Number of its vertices.</summary>
        public int VertexCount { get; internal set; }

        /// <summary>Its joint among those of a frame.</summary>
        public int Joint { get; internal set; }

        /// <summary>Place of the joint, in the insect's space.</summary>
        public float3 Hinge { get; internal set; }
    }
}
