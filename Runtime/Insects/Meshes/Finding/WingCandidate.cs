using UnityEngine;

namespace Alate
{
    /// <summary>Part of a renderer that may be a wing.</summary>
    internal sealed class WingCandidate
    {
        public Renderer renderer;
        public WingPart part;
        public int submesh;
        public Vector3 point;
        public WingShape shape;

        /// <summary>True where a name says that the part is a wing.</summary>
        public bool isNamed;

        /// <summary>Side given by a name, for parts whose place does not tell.</summary>
        public WingSide? namedSide;

        /// <summary>Pair, given by a name or found later.</summary>
        public WingPair? pair;

        /// <summary>Side of the body on which most of the part is, else the side given by its name.</summary>
        public WingSide Side => shape.Side ?? namedSide ?? (shape.centroid.x < 0f ? WingSide.Left : WingSide.Right);

        /// <summary>Makes the wing for the inspector's list.</summary>
        public Wing ToWing()
        {
            return new Wing
            {
                Renderer = renderer as MeshRenderer,
                Part = part,
                Submesh = submesh,
                Point = point,
                Side = Side,
                Pair = pair ?? WingPair.Fore,
            };
        }
    }
}
