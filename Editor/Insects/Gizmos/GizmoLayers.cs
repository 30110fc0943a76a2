using System;

namespace Alate.Editor
{
    /// <summary>Layers of gizmos over a selected insect in the scene view.</summary>
    [Flags]
    internal enum GizmoLayers
    {
        /// <summary>No layer.</summary>
        None = 0,

        /// <summary>The chains, coloured by delay.</summary>
        Chains = 1,

        /// <summary>Hinge, span and up axis.</summary>
        Axes = 2,

        /// <summary>The air's force on each surface patch; only in play.</summary>
        Loads = 4,

        /// <summary>The air's force on each wing; only in play.</summary>
        Force = 8,

        /// <summary>Velocity and wind; only in play.</summary>
        Velocity = 16,

        /// <summary>Bounds of the meshes.</summary>
        Bounds = 32,

        /// <summary>Vortex rings that the wings leave in the air; only in play.</summary>
        Wake = 64,
    }
}
