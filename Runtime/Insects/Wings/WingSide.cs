namespace Alate
{
    /// <summary>The side of the insect a wing grows on, seen from the insect itself.</summary>
    public enum WingSide
    {
        /// <summary>Span along +X.</summary>
        Right,

        /// <summary>Span along −X; the mirror image of the right wing.</summary>
        Left,
    }
}
