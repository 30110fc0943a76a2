using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Alate.Files
{
    /// <summary>JSON as a person would write it: two spaces a level, plain values of short lists and objects on one line.</summary>
    internal static class JsonText
    {
        private const int k_Line = 100;

        /// <summary>Text of a value, with an end of line.</summary>
        public static string Write(JsonPlace value)
        {
            var text = new StringBuilder();
            Append(text, value, 0);
            return text.Append('\n').ToString();
        }

        /// <summary>Text of a value on one line.</summary>
        public static string Line(JsonPlace value) => value.Kind switch
        {
            JsonKind.Object => value.Members.Count == 0
                ? "{}"
                : $"{{ {string.Join(", ", value.Members.Select(member => Quoted(member.Key) + ": " + Line(member.Value)))} }}",
            JsonKind.List => $"[{string.Join(", ", value.Items.Select(Line))}]",
            JsonKind.Text => Quoted(value.Text),
            _ => value.Text,
        };

        private static void Append(StringBuilder text, JsonPlace value, int depth)
        {
            string line = Line(value);
            bool isShort = line.Length + 2 * depth <= k_Line;
            if (IsPlain(value) || value.Kind == JsonKind.List && isShort
                || depth > 1 && isShort && value.Members.All(member => IsPlain(member.Value) || IsPlainList(member.Value)))
            {
                text.Append(line);
                return;
            }

            text.Append(value.IsObject ? '{' : '[');
            int count = 0;
            foreach ((string key, JsonPlace inner) in Inner(value))
            {
                text.Append(count++ == 0 ? "\n" : ",\n").Append(' ', 2 * (depth + 1));
                if (key != null)
                    text.Append(Quoted(key)).Append(": ");
                Append(text, inner, depth + 1);
            }

            text.Append('\n').Append(' ', 2 * depth).Append(value.IsObject ? '}' : ']');
        }

        private static IEnumerable<(string Key, JsonPlace Value)> Inner(JsonPlace value) =>
            value.IsObject ? value.Members : value.Items.Select(item => ((string)null, item));

        private static bool IsPlain(JsonPlace value) => value.Kind != JsonKind.Object && value.Kind != JsonKind.List;

        private static bool IsPlainList(JsonPlace value) => value.Kind == JsonKind.List && value.Items.All(IsPlain);

        private static string Quoted(string text)
        {
            var quoted = new StringBuilder("\"");
            foreach (char letter in text)
            {
                int plain = "\"\\\b\f\n\r\t".IndexOf(letter);
                if (plain >= 0)
                    quoted.Append('\\').Append("\"\\bfnrt"[plain]);
                else if (letter < ' ')
                    quoted.Append("\\u").Append(((int)letter).ToString("x4", CultureInfo.InvariantCulture));
                else
                    quoted.Append(letter);
            }

            return quoted.Append('"').ToString();
        }
    }
}
