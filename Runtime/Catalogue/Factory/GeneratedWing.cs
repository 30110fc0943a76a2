using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Mesh, skeleton and material of one kind of wing, left and right alike: the left wing is the right one with its X axis turned round.
    /// </summary>
    internal sealed class GeneratedWing
    {
        public GeneratedWing(WingDefinition wing)
        {
            Wing = wing;
        }

        /// <summary>The kind of wing.</summary>
        public WingDefinition Wing { get; }

        /// <summary>The right wing, its origin at the base.</summary>
        public Mesh Mesh { get; set; }

        /// <summary>Skeleton in the space of the mesh.</summary>
        public WingSkeleton Skeleton { get; set; }

        /// <summary>Material with the colours of the wing.</summary>
        public Material Material { get; set; }
    }
}
