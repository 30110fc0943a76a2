using System.Collections.Generic;

namespace Alate
{
    /// <summary>Vertices of one wing of a mesh, and their rig.</summary>
    internal sealed class RiggedPart
    {
        public RiggedPart(MeshSelection selection, WingRig rig, SmallerPart smaller)
        {
            Selection = selection;
            Rig = rig;
            Smaller = smaller;
        }

        /// <summary>The wing's part of the mesh.</summary>
        public MeshSelection Selection { get; }

        /// <summary>Rig baked from that part; vertex k of the rig is vertex <c>Selection.vertices[k]</c> of the mesh.</summary>
        public WingRig Rig { get; }

        /// <summary>The part with fewer triangles; null where there is none, or none was wanted.</summary>
        public SmallerPart Smaller { get; }

        /// <summary>Returns true where two wings share a vertex.</summary>
        public bool Overlaps(RiggedPart other) => new HashSet<int>(Selection.vertices).Overlaps(other.Selection.vertices);
    }
}
