using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Colours of skeletons in the scene view.</summary>
    internal static class SkeletonColours
    {
        /// <summary>Bones of the principal chain.</summary>
        public static readonly Color principalChain = new Color(1f, 0.55f, 0.15f);

        /// <summary>Bones of the other chains.</summary>
        public static readonly Color chain = new Color(0.45f, 0.8f, 1f);

        /// <summary>Lines between the same joints of neighbouring chains.</summary>
        public static readonly Color row = new Color(chain.r, chain.g, chain.b, 0.3f);

        /// <summary>Joints.</summary>
        public static readonly Color joint = new Color(0.9f, 0.95f, 1f);

        /// <summary>Selected joints.</summary>
        public static readonly Color selected = new Color(1f, 0.9f, 0.1f);

        /// <summary>Joint that a click would take.</summary>
        public static readonly Color hovered = new Color(1f, 1f, 1f);

        /// <summary>Joints with a problem, and places where a rig is weak.</summary>
        public static readonly Color problem = new Color(1f, 0.25f, 0.2f);

        /// <summary>The hinge.</summary>
        public static readonly Color hinge = new Color(0.4f, 1f, 0.5f);

        /// <summary>The wing at a phase of the beat.</summary>
        public static readonly Color beat = new Color(0.55f, 0.85f, 0.55f, 0.35f);

        /// <summary>Edges of that wing.</summary>
        public static readonly Color beatEdges = new Color(0.1f, 0.3f, 0.1f, 0.25f);

        /// <summary>Edge of the box of a box selection.</summary>
        public static readonly Color boxEdge = new Color(0.4f, 0.7f, 1f, 0.8f);

        /// <summary>The box of a box selection.</summary>
        public static readonly Color box = new Color(boxEdge.r, boxEdge.g, boxEdge.b, 0.2f);
    }
}
