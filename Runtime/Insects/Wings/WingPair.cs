namespace Alate
{
    /// <summary>Pair of an insect's wings: fore or hind.</summary>
    public enum WingPair
    {
        /// <summary>The front pair, or the only one.</summary>
        Fore,

        /// <summary>The pair behind it.</summary>
        Hind,
    }
}
