namespace Alate
{
    /// <summary>When an insect's wings are stepped.</summary>
    public enum WingUpdateMode
    {
        /// <summary>With the physics, in its fixed steps; drawn smoothly between them.</summary>
        FixedUpdate,

        /// <summary>Each frame, in fixed steps of a sixtieth of a second.</summary>
        Update,

        /// <summary>Each frame, in time that does not stop or slow down with the game's.</summary>
        UnscaledTime,

        /// <summary>Only when a script calls <see cref="InsectWings.Step"/>.</summary>
        Manual,
    }
}
