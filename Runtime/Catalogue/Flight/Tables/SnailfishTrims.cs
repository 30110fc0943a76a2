namespace Alate.Catalogue
{
    /// <summary>Trim table of the Snailfish.</summary>
    internal static class SnailfishTrims
    {
        public const string Text = null;
    }
}
