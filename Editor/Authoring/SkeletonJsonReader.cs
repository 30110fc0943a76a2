using System;
using System.Collections.Generic;
using System.Globalization;
using UnityEngine;

namespace Alate.Authoring
{
    /// <summary>Reads exactly the JSON of <see cref="SkeletonJson"/>, and reports where a text departs from it.</summary>
    internal sealed class SkeletonJsonReader
    {
        private static readonly string[] s_Required =
        {
            SkeletonJson.k_Version, SkeletonJson.k_Hinge, SkeletonJson.k_Span, SkeletonJson.k_Up, SkeletonJson.k_Chains,
        };

        private static readonly string[] s_Keys = { s_Required[0], s_Required[1], s_Required[2], s_Required[3], s_Required[4],
            SkeletonJson.k_Flexural, SkeletonJson.k_Torsional, SkeletonJson.k_Widths };

        private readonly string m_Text;
        private readonly (double x, double y, double z) m_Origin;
        private int m_Position;

        /// <param name="text">The JSON.</param>
        /// <param name="origin">What the positions are counted from, in the text's space.</param>
        public SkeletonJsonReader(string text, (double x, double y, double z) origin)
        {
            m_Text = text;
            m_Origin = origin;
        }

        /// <summary>Content of a text.</summary>
        public struct Content
        {
            public Vector3 hinge;
            public Vector3 span;
            public Vector3 up;
            public JointChain[] chains;
            public float[][] flexural;
            public float[][] torsional;
            public float[][] widths;
        }

        /// <summary>Reads the whole text.</summary>
        public Content Read()
        {
            Content content = default;
            var seen = new HashSet<string>();
            if (m_Text.Length > 0 && m_Text[0] == '\uFEFF')
                m_Position = 1;
            Expect('{');
            do
            {
                string key = ReadKey();
                if (!seen.Add(key))
                    throw Wrong($"\"{key}\" appears twice");
                Expect(':');
                ReadMember(key, ref content);
            }
            while (More('}', "a member"));

            foreach (string key in s_Required)
            {
                if (!seen.Contains(key))
                    throw Wrong($"\"{key}\" is missing");
            }

            SkipSpace();
            if (m_Position < m_Text.Length)
                throw Wrong($"expected the end of the text, found {Found()}");
            for (int i = 0; i < content.chains.Length; i++)
            {
                content.chains[i].flexuralStiffness = Of(content, i, SkeletonJson.k_Flexural, content.flexural);
                content.chains[i].torsionalStiffness = Of(content, i, SkeletonJson.k_Torsional, content.torsional);
                content.chains[i].veinWidths = Of(content, i, SkeletonJson.k_Widths, content.widths);
            }

            return content;
        }

        private float[] Of(in Content content, int chain, string key, float[][] values)
        {
            if (values != null && values.Length != content.chains.Length)
                throw Wrong($"\"{key}\" has {values.Length} lists for {content.chains.Length} chains");
            return values?[chain];
        }

        private void ReadMember(string key, ref Content content)
        {
            switch (key)
            {
                case SkeletonJson.k_Version:
                    ReadVersion();
                    break;
                case SkeletonJson.k_Hinge:
                    content.hinge = ReadPosition();
                    break;
                case SkeletonJson.k_Span:
                    content.span = ReadVector(default);
                    break;
                case SkeletonJson.k_Up:
                    content.up = ReadVector(default);
                    break;
                case SkeletonJson.k_Flexural:
                    content.flexural = ReadList(ReadValues, "a list");
                    break;
                case SkeletonJson.k_Torsional:
                    content.torsional = ReadList(ReadValues, "a list");
                    break;
                case SkeletonJson.k_Widths:
                    content.widths = ReadList(ReadValues, "a list");
                    break;
                default:
                    content.chains = ReadList(ReadChain, "a chain");
                    break;
            }
        }

        private void ReadVersion()
        {
            SkipSpace();
            int start = m_Position;
            string version = ReadNumber();
            if (version == WingSkeleton.CurrentVersion.ToString(CultureInfo.InvariantCulture))
                return;
            m_Position = start;
            throw Wrong($"version {version} is not supported, only version {WingSkeleton.CurrentVersion}");
        }

        private JointChain ReadChain() => new JointChain(ReadList(ReadPosition, "a joint"));

        private float[] ReadValues() => ReadList(() => ReadFloat(0.0), "a number");

        private Vector3 ReadPosition() => ReadVector(m_Origin);

        private Vector3 ReadVector((double x, double y, double z) origin)
        {
            Expect('[', "a list of three numbers");
            var v = new Vector3 { x = ReadFloat(origin.x) };
            Expect(',');
            v.y = ReadFloat(origin.y);
            Expect(',');
            v.z = ReadFloat(origin.z);
            Expect(']');
            return v;
        }

        private T[] ReadList<T>(Func<T> readItem, string item)
        {
            var items = new List<T>();
            Expect('[', "a list");
            SkipSpace();
            if (TryRead(']'))
                return items.ToArray();
            do
            {
                items.Add(readItem());
            }
            while (More(']', item));

            return items.ToArray();
        }

        // After an item: true when a comma announces another one.
        private bool More(char end, string item)
        {
            SkipSpace();
            if (TryRead(end))
                return false;
            if (!TryRead(','))
                throw Wrong($"expected ',' or '{end}' after {item}, found {Found()}");
            return true;
        }

        private string ReadKey()
        {
            Expect('"', "a key in double quotes");
            foreach (string key in s_Keys)
            {
                if (string.CompareOrdinal(m_Text, m_Position, key + "\"", 0, key.Length + 1) == 0)
                {
                    m_Position += key.Length + 1;
                    return key;
                }
            }

            m_Position--;
            throw Wrong($"expected one of the keys {string.Join(", ", s_Keys)}, found {Found()}");
        }

        // From the origin on; without one as single precision reads it.
        private float ReadFloat(double origin)
        {
            SkipSpace();
            int start = m_Position;
            string number = ReadNumber();
            bool parsed = float.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out float value);
            if (parsed && !float.IsInfinity(value))
                return origin == 0.0 ? value : (float)(double.Parse(number, CultureInfo.InvariantCulture) - origin);
            m_Position = start;
            throw Wrong("the number is too large");
        }

        // The digits of a number as JSON spells it: no leading plus, zero or point, no NaN.
        private string ReadNumber()
        {
            SkipSpace();
            int start = m_Position;
            TryRead('-');
            int leading = m_Position;
            bool complete = Digits() && (m_Text[leading] != '0' || m_Position == leading + 1);
            if (complete && TryRead('.'))
                complete = Digits();
            if (complete && (TryRead('e') || TryRead('E')))
            {
                if (!TryRead('+'))
                    TryRead('-');
                complete = Digits();
            }

            if (complete)
                return m_Text.Substring(start, m_Position - start);
            m_Position = start;
            throw Wrong($"expected a number, found {Found()}");
        }

        private bool Digits()
        {
            int start = m_Position;
            while (m_Position < m_Text.Length && m_Text[m_Position] >= '0' && m_Text[m_Position] <= '9')
                m_Position++;
            return m_Position > start;
        }

        private void Expect(char character, string what = null)
        {
            SkipSpace();
            if (!TryRead(character))
                throw Wrong($"expected {what ?? $"'{character}'"}, found {Found()}");
        }

        private bool TryRead(char character)
        {
            bool there = m_Position < m_Text.Length && m_Text[m_Position] == character;
            if (there)
                m_Position++;
            return there;
        }

        private void SkipSpace()
        {
            while (m_Position < m_Text.Length && " \t\r\n".IndexOf(m_Text[m_Position]) >= 0)
                m_Position++;
        }

        // What stands here, for a message: the end, or the next few characters up to a separator.
        private string Found()
        {
            const int k_Longest = 20;
            if (m_Position >= m_Text.Length)
                return "the end of the text";
            int end = m_Position + 1;
            while (end < m_Text.Length && end < m_Position + k_Longest && " \t\r\n,:[]{}".IndexOf(m_Text[end]) < 0)
                end++;
            string found = m_Text.Substring(m_Position, end - m_Position);
            foreach (char character in found)
            {
                if (char.IsControl(character))
                    return $"a control character (U+{(int)character:X4})";
            }

            return $"'{found}'";
        }

        private FormatException Wrong(string reason)
        {
            int line = 1, column = 1;
            for (int k = 0; k < m_Position && k < m_Text.Length; k++)
            {
                column = m_Text[k] == '\n' ? 1 : column + 1;
                line += m_Text[k] == '\n' ? 1 : 0;
            }

            return new FormatException($"Skeleton JSON, line {line}, column {column}: {reason}.");
        }
    }
}
