using System.Linq;
using System.Text.RegularExpressions;

namespace Alate.Files
{
    /// <summary>A text.</summary>
    internal sealed class TextShape : FileShape
    {
        /// <param name="words">What it says.</param>
        /// <param name="most">Most characters.</param>
        /// <param name="pattern">Regular expression of the whole text; null for any.</param>
        public TextShape(string words, int most = 500, string pattern = null)
        {
            Words = words;
            Most = most;
            Pattern = pattern;
        }

        /// <summary>Most characters.</summary>
        public int Most { get; }

        /// <summary>Regular expression of the whole text; null for any.</summary>
        public string Pattern { get; }

        public override string Words { get; }

        public override void Check(JsonPlace value)
        {
            if (value.Kind != JsonKind.Text || string.IsNullOrWhiteSpace(value.Text) || value.Text.Length > Most
                || value.Text.Any(char.IsControl) || Pattern != null && !Regex.IsMatch(value.Text, Pattern))
            {
                throw Not(value);
            }
        }
    }
}
