using System.Collections.Generic;

namespace Alate
{
    /// <summary>Splits an object's name into words at signs, digits and capitals: "ForeWing_L.001" gives fore, wing, l.</summary>
    internal static class NameWords
    {
        /// <summary>Words of a name in lower case; digits are no words.</summary>
        public static List<string> Of(string name)
        {
            var words = new List<string>();
            int start = 0;
            for (int end = 1; end <= name.Length; end++)
            {
                if (end < name.Length && !IsBreak(name, end))
                    continue;
                if (char.IsLetter(name[start]))
                    words.Add(name.Substring(start, end - start).ToLowerInvariant());
                start = end;
            }

            return words;
        }

        private static bool IsBreak(string name, int at)
        {
            char before = name[at - 1], here = name[at];
            if (char.IsLetter(before) != char.IsLetter(here))
                return true;
            if (!char.IsUpper(here))
                return false;
            bool isLastOfCapitals = at + 1 < name.Length && char.IsLower(name[at + 1]);
            return char.IsLower(before) || isLastOfCapitals;
        }
    }
}
