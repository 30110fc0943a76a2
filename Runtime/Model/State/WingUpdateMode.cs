using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Time at which an insect's wings are stepped.</summary>
    [MovedFrom(true, null, "Alate")]
    public enum WingUpdateMode
    {
        /// <summary>Steps with the physics, in its fixed steps; drawn smoothly between them.</summary>
        FixedUpdate,

        /// <summary>Steps each frame, in fixed steps of a sixtieth of a second.</summary>
        Update,

        /// <summary>Steps each frame, in time that does not stop or slow down with the game's.</summary>
        UnscaledTime,

        /// <summary>Only when a script calls <c>InsectWings.Step</c>.</summary>
        Manual,
    }
}
