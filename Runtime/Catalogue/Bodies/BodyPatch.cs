namespace Alate.Catalogue
{
    /// <summary>Part in its place on a body: its colouring, whether it has a twin on the left, and its patch of the texture.</summary>
    internal sealed class BodyPatch
    {
        public BodyPatch(BodyPart part, BodyPaint paint, bool isPair, int shelf)
        {
            Part = part;
            Paint = paint;
            IsPair = isPair;
            Shelf = shelf;
        }

        /// <summary>The part in the middle, or that of the right side.</summary>
        public BodyPart Part { get; }

        public BodyPaint Paint { get; }

        public bool IsPair { get; }

        public int Shelf { get; }
    }
}
