namespace Alate
{
    /// <summary>What moves a flying body.</summary>
    internal enum BodyMode
    {
        /// <summary>Forces of wings, air and gravity.</summary>
        Free,

        /// <summary>The table: the trim's motion with its bob, for measurements.</summary>
        Held,

        /// <summary>Nothing.</summary>
        Resting,
    }
}
