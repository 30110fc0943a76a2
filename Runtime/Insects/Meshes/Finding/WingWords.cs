using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>Words that tell wings in the names of objects, bones, meshes and materials.</summary>
    internal static class WingWords
    {
        private const int k_LongestAbbreviation = 2;

        private static readonly Dictionary<string, WingWord> s_Meanings = Meanings(new[]
        {
            (WingWord.Wing, "wing wings fin fins"),
            (WingWord.Left, "left l"),
            (WingWord.Right, "right r"),
            (WingWord.Fore, "fore front upper top anterior"),
            (WingWord.Hind, "hind rear back lower bottom posterior"),
            (WingWord.Fore | WingWord.Left, "fl lf"),
            (WingWord.Fore | WingWord.Right, "fr rf"),
            (WingWord.Hind | WingWord.Left, "hl lh bl lb rl"),
            (WingWord.Hind | WingWord.Right, "hr rh br rb rr"),
            (WingWord.Body, "body torso thorax abdomen head leg legs eye eyes antenna antennae tail dorsal caudal anal"),
            (WingWord.Mount, "hinge joint socket muscle collider collision shadow"),
            (WingWord.Case, "elytra elytron elytrum case cases cover covers shell shells carapace haltere halteres"),
            (WingWord.Plain, "mesh msh geo geometry model obj object node group grp part skin material mat"),
            (WingWord.Plain, "bone root rig pivot holder parent lod"),
        });

        /// <summary>
        /// The meanings of a name's words, together; "forewingL" is three of them. False if a word is unknown; the others still count.
        /// </summary>
        public static bool Read(string name, out WingWord meaning)
        {
            meaning = WingWord.Plain;
            bool known = true;
            foreach (string word in NameWords.Of(name))
            {
                if (s_Meanings.TryGetValue(word, out WingWord own) || Divide(word, 0, WingWord.Plain, false, out own))
                    meaning |= own;
                else
                    known = false;
            }

            return known;
        }

        // A compound of known words. Abbreviations are trusted only before or behind a compound that names a wing.
        private static bool Divide(string word, int start, WingWord before, bool isAbbreviated, out WingWord meaning)
        {
            meaning = before;
            if (start == word.Length)
                return !isAbbreviated || (before & WingWord.Wing) != 0;
            for (int length = word.Length - start; length > 0; length--)
            {
                bool isShort = length <= k_LongestAbbreviation;
                if (isShort && start > 0 && start + length < word.Length)
                    continue;
                if (s_Meanings.TryGetValue(word.Substring(start, length), out WingWord own)
                    && Divide(word, start + length, before | own, isAbbreviated || isShort, out meaning))
                {
                    return true;
                }
            }

            return false;
        }

        private static Dictionary<string, WingWord> Meanings((WingWord Meaning, string Words)[] groups)
        {
            var meanings = new Dictionary<string, WingWord>(StringComparer.Ordinal);
            foreach ((WingWord meaning, string words) in groups)
            {
                foreach (string word in words.Split(' '))
                    meanings.Add(word, meaning);
            }

            return meanings;
        }
    }
}
