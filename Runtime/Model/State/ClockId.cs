namespace Alate
{
    /// <summary>Clocks of wings; the index of a step's length and of a picture's time in <see cref="StepPlan"/>.</summary>
    internal enum ClockId
    {
        /// <summary>Fixed steps of the physics.</summary>
        Fixed,

        /// <summary>Frames, scaled time.</summary>
        Frame,

        /// <summary>Frames, time that does not stop when the game is paused.</summary>
        Unscaled,

        /// <summary>Steps by hand, one insect at a time.</summary>
        Own,
    }
}
