using System;
using UnityEngine;

namespace Alate
{
    /// <summary>Pose that the editor shows of an insect while the game does not play; without effect in play and in players.</summary>
    [Serializable]
    public struct InsectPreview
    {
        /// <summary>True where the wings are drawn as they beat; false shows the authored meshes.</summary>
        [Tooltip("Draws the wings as they beat while the game does not play, also where an Animation window or Timeline previews.")]
        public bool shows;

        /// <summary>Beats since the start phase, any finite number; its fraction is the phase that is shown.</summary>
        [Tooltip("Beats since Start Phase: key it, and scrubbing shows the beat. 0.5 is half a beat; whole numbers look alike.")]
        public float beat;
    }
}
