using System;
using System.Collections.Generic;
using System.Text;

namespace Alate.Files
{
    /// <summary>
    /// Reads JSON as RFC 8259 has it, without comments and trailing commas, into values that know their lines. Unity's own
    /// <c>JsonUtility</c> knows neither keys that it was not told of nor where a value stands.
    /// </summary>
    internal sealed class JsonReader
    {
        private const int k_Depth = 32;

        private readonly string m_Text;
        private int m_At, m_Line = 1, m_LineStart, m_Depth;

        private JsonReader(string text)
        {
            m_Text = text;
        }

        /// <summary>Reads a whole text.</summary>
        /// <exception cref="FormatException">It is no JSON, nests deeper than 32 levels, or a key stands in an object twice.</exception>
        public static JsonPlace Read(string text)
        {
            var reader = new JsonReader(text);
            JsonPlace root = reader.Value("");
            reader.SkipSpace();
            return reader.m_At == text.Length ? root : throw reader.Wrong();
        }

        // NUL, which no text has, at the end.
        private char Next => m_At < m_Text.Length ? m_Text[m_At] : '\0';

        private JsonPlace Value(string path)
        {
            SkipSpace();
            int line = m_Line;
            switch (Next)
            {
                case '{':
                    return new JsonPlace(JsonKind.Object, path, line, null, Nested(() => Members(path, line)));
                case '[':
                    return new JsonPlace(JsonKind.List, path, line, null, items: Nested(() => Items(path)));
                case '"':
                    return new JsonPlace(JsonKind.Text, path, line, Text(line, path));
                case 't':
                    return new JsonPlace(JsonKind.True, path, line, Word("true"));
                case 'f':
                    return new JsonPlace(JsonKind.False, path, line, Word("false"));
                case 'n':
                    return new JsonPlace(JsonKind.Null, path, line, Word("null"));
                default:
                    return new JsonPlace(JsonKind.Number, path, line, Number());
            }
        }

        private List<T> Nested<T>(Func<List<T>> read)
        {
            if (++m_Depth > k_Depth)
                throw Wrong();
            m_At++;
            List<T> all = read();
            m_Depth--;
            return all;
        }

        private List<(string Key, JsonPlace Value)> Members(string path, int line)
        {
            var members = new List<(string, JsonPlace)>();
            var seen = new HashSet<string>();
            for (bool isFirst = true; !Ends('}', isFirst); isFirst = false)
            {
                if (Next != '"')
                    throw Wrong();
                int at = m_Line;
                string key = Text(line, path), place = path.Length == 0 ? Short(key) : $"{path}.{Short(key)}";
                if (!seen.Add(key))
                    throw new FormatException($"line {at}, {place}: the key stands there twice.");
                SkipSpace();
                Take(':');
                members.Add((key, Value(place)));
            }

            return members;
        }

        private List<JsonPlace> Items(string path)
        {
            var items = new List<JsonPlace>();
            for (bool isFirst = true; !Ends(']', isFirst); isFirst = false)
                items.Add(Value($"{path}[{items.Count}]"));
            return items;
        }

        // At the end of an object or list, or before its next value, behind the comma.
        private bool Ends(char end, bool isFirst)
        {
            SkipSpace();
            if (Next == end)
            {
                m_At++;
                return true;
            }

            if (!isFirst)
                Take(',');
            SkipSpace();
            return false;
        }

        private string Text(int line, string path)
        {
            Take('"');
            var text = new StringBuilder();
            while (Next != '"')
            {
                if (Next < ' ')
                    throw Wrong();
                text.Append(Next == '\\' ? Escaped() : m_Text[m_At++]);
            }

            m_At++;
            for (int k = 0; k < text.Length; k++)
            {
                bool isPair = char.IsHighSurrogate(text[k]) && k + 1 < text.Length && char.IsLowSurrogate(text[k + 1]);
                if (char.IsSurrogate(text[k]) && !isPair)
                {
                    throw new FormatException(
                        path.Length == 0 ? $"line {line}: a text is no Unicode." : $"line {line}, {path}: it is no Unicode.");
                }
                k += isPair ? 1 : 0;
            }

            return text.ToString();
        }

        private char Escaped()
        {
            m_At++;
            int plain = "\"\\/bfnrt".IndexOf(Next);
            if (plain >= 0)
            {
                m_At++;
                return "\"\\/\b\f\n\r\t"[plain];
            }

            Take('u');
            int code = 0;
            for (int k = 0; k < 4; k++, m_At++)
            {
                if (!Uri.IsHexDigit(Next))
                    throw Wrong();
                code = 16 * code + Uri.FromHex(Next);
            }

            return (char)code;
        }

        // No leading plus, zero or point, no NaN.
        private string Number()
        {
            int start = m_At;
            Skip('-');
            int leading = m_At;
            Digits();
            if (m_Text[leading] == '0' && m_At > leading + 1)
            {
                m_At = leading + 1;
                throw Wrong();
            }

            if (Skip('.'))
                Digits();
            if (Skip('e') || Skip('E'))
            {
                if (!Skip('+'))
                    Skip('-');
                Digits();
            }

            return m_Text.Substring(start, m_At - start);
        }

        private void Digits()
        {
            int start = m_At;
            while (Next >= '0' && Next <= '9')
                m_At++;
            if (m_At == start)
                throw Wrong();
        }

        private string Word(string word)
        {
            foreach (char letter in word)
                Take(letter);
            return word;
        }

        private bool Skip(char one)
        {
            bool isThere = Next == one;
            m_At += isThere ? 1 : 0;
            return isThere;
        }

        private void Take(char one)
        {
            if (!Skip(one))
                throw Wrong();
        }

        private void SkipSpace()
        {
            for (; m_At < m_Text.Length && " \t\r\n".IndexOf(Next) >= 0; m_At++)
            {
                if (Next == '\n')
                    (m_Line, m_LineStart) = (m_Line + 1, m_At + 1);
            }
        }

        private static string Short(string key)
        {
            var shown = new StringBuilder();
            foreach (char letter in key)
                shown.Append(char.IsControl(letter) ? ' ' : letter);
            string quoted = Quote.Of(shown.ToString());
            return quoted.Substring(1, quoted.Length - 2);
        }

        private FormatException Wrong() => new FormatException(
            $"line {m_Line}: not JSON at column {m_At - m_LineStart + 1}.");
    }
}
