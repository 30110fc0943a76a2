namespace Alate
{
    /// <summary>Vertices of one wing of a mesh, and their rig.</summary>
    internal sealed class RiggedPart
    {
        public RiggedPart(MeshSelection selection, WingRig rig)
        {
            Selection = selection;
            Rig = rig;
        }

        /// <summary>The wing's part of the mesh.</summary>
        public MeshSelection Selection { get; }

        /// <summary>Rig baked from that part; vertex k of the rig is vertex <c>Selection.vertices[k]</c> of the mesh.</summary>
        public WingRig Rig { get; }

        /// <summary>Returns true where two wings share a vertex.</summary>
        public bool Overlaps(RiggedPart other)
        {
            int[] a = Selection.vertices, b = other.Selection.vertices;
            int i = 0, j = 0;
            while (i < a.Length && j < b.Length)
            {
                if (a[i] == b[j])
                    return true;
                if (a[i] < b[j])
                    i++;
                else
                    j++;
            }

            return false;
        }
    }
}
