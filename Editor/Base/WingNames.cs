using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Names the wings of an insect for the inspector.</summary>
    internal static class WingNames
    {
        /// <summary>Name of a wing: "Right" on an insect with one pair, else "Fore Right".</summary>
        public static string Of(IReadOnlyList<Wing> wings, int index)
        {
            Wing wing = wings[index];
            return HasHindWings(wings) ? $"{wing.Pair} {wing.Side}" : wing.Side.ToString();
        }

        /// <summary>Returns true where fore and hind wings must be told apart.</summary>
        public static bool HasHindWings(IReadOnlyList<Wing> wings)
        {
            foreach (Wing wing in wings)
            {
                if (wing != null && wing.Pair == WingPair.Hind)
                    return true;
            }

            return false;
        }
    }
}
