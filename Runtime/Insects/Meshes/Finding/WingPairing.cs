using System.Collections.Generic;

namespace Alate
{
    /// <summary>Tells fore wings from hind wings, by names or else by their order along the body.</summary>
    internal static class WingPairing
    {
        /// <summary>Assigns each wing its pair. The wings of an insect with one pair are fore wings, whatever their name.</summary>
        public static void Assign(List<WingCandidate> wings)
        {
            Assign(wings, WingSide.Right);
            Assign(wings, WingSide.Left);
            if (wings.TrueForAll(wing => wing.pair == WingPair.Hind))
                wings.ForEach(wing => wing.pair = WingPair.Fore);
        }

        /// <summary>Orders wings with pairs: fore right, fore left, hind right, hind left; larger ones first.</summary>
        public static int Compare(WingCandidate a, WingCandidate b)
        {
            if (a.pair != b.pair)
                return a.pair == WingPair.Fore ? -1 : 1;
            if (a.Side != b.Side)
                return a.Side == WingSide.Right ? -1 : 1;
            return b.shape.area.CompareTo(a.shape.area);
        }

        private static void Assign(List<WingCandidate> wings, WingSide side)
        {
            List<WingCandidate> own = wings.FindAll(wing => wing.Side == side);
            int count = WingGroup.Divide(own.ConvertAll(wing => wing.shape), out int[] groups);
            var pairs = new WingPair?[count];
            for (int place = 0; place < own.Count; place++)
                pairs[groups[place]] = pairs[groups[place]] ?? own[place].pair;

            bool hasFore = System.Array.IndexOf(pairs, WingPair.Fore) >= 0;
            for (int group = 0; group < count; group++)
            {
                pairs[group] = pairs[group] ?? (hasFore ? WingPair.Hind : WingPair.Fore);
                hasFore |= pairs[group] == WingPair.Fore;
            }

            for (int place = 0; place < own.Count; place++)
                own[place].pair = own[place].pair ?? pairs[groups[place]];
        }
    }
}
