namespace Alate
{
    /// <summary>Which pair of an insect's wings one belongs to.</summary>
    public enum WingPair
    {
        /// <summary>The front pair, or the only one.</summary>
        Fore,

        /// <summary>The pair behind it.</summary>
        Hind,
    }
}
