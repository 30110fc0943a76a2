using UnityEngine;

namespace Alate
{
    /// <summary>A part of a renderer that may be a wing.</summary>
    internal sealed class WingCandidate
    {
        public Renderer renderer;
        public WingPart part;
        public int submesh;
        public Vector3 point;
        public WingShape shape;

        /// <summary>A name says that it is a wing.</summary>
        public bool isNamed;

        /// <summary>The side by name, where the place does not tell.</summary>
        public WingSide? namedSide;

        /// <summary>The pair: by name, or as found later.</summary>
        public WingPair? pair;

        /// <summary>The side of the body: where most of it is, else what its name says.</summary>
        public WingSide Side => shape.Side ?? namedSide ?? (shape.centroid.x < 0f ? WingSide.Left : WingSide.Right);

        /// <summary>The wing for the inspector's list.</summary>
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
