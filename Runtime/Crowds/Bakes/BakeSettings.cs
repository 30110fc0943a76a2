namespace Alate.Crowds
{
    /// <summary>Settings of how finely an insect is baked.</summary>
    public readonly struct BakeSettings
    {
        /// <summary>Bounds of the number of frames.</summary>
        public const int MinFrames = 4, MaxFrames = 240;

        /// <summary>
        /// Frames of a beat that keep the error between frames below 0.5 % of the wing length for all insects of the catalogue.
        /// </summary>
        public const int DefaultFrames = 48;

        /// <param name="frames">Frames of each loop, 4 to 240.</param>
        /// <exception cref="System.ArgumentOutOfRangeException">Too few or too many frames.</exception>
        public BakeSettings(int frames)
        {
            if (frames < MinFrames || frames > MaxFrames)
                throw new System.ArgumentOutOfRangeException(nameof(frames), frames, $"A loop has {MinFrames} to {MaxFrames} frames.");
            Frames = frames;
        }

        /// <summary><see cref="DefaultFrames"/>.</summary>
        public static BakeSettings Default => new BakeSettings(DefaultFrames);

        /// <summary>Frames of a loop; a motion in which nothing moves takes one.</summary>
        public int Frames { get; }
    }
}
