namespace Alate
{
    /// <summary>Side of the insect on which a wing grows, seen from the insect itself.</summary>
    public enum WingSide
    {
        /// <summary>Right side; span along +X.</summary>
        Right,

        /// <summary>Left side; span along −X; the mirror image of a right wing.</summary>
        Left,
    }
}
