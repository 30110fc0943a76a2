namespace Alate
{
    /// <summary>Ways in which a flying body is moved.</summary>
    internal enum BodyMode
    {
        /// <summary>Moved by the forces of wings, air and gravity.</summary>
        Free,

        /// <summary>Moved by the table: the trim's motion with its bob, for measurements.</summary>
        Held,

        /// <summary>Not moved.</summary>
        Resting,
    }
}
