using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Tests.Architecture;

namespace Alate.Tests
{
    /// <summary>Rows of the tables under one heading of a page of the manual.</summary>
    internal sealed class PageTable
    {
        private readonly List<(string[] Columns, string[] Cells)> m_Rows = new();

        /// <param name="page">Name of the page, without its ending.</param>
        /// <param name="heading">The heading, without marks.</param>
        public PageTable(string page, string heading)
        {
            string[] columns = null;
            foreach (string line in ManualPages.Text($"Documentation~/{page}.md").Split('\n')
                .SkipWhile(line => !IsHeading(line) || line.TrimStart('#', ' ') != heading).Skip(1).TakeWhile(line => !IsHeading(line)))
            {
                string[] cells = line.StartsWith('|') ? line.Trim('|').Split('|').Select(cell => cell.Trim()).ToArray() : null;
                if (cells != null && columns != null && !cells[0].StartsWith("--", StringComparison.Ordinal))
                    m_Rows.Add((columns, cells));
                columns = cells == null ? null : columns ?? cells;
            }
        }

        /// <summary>
        /// Finds the cell of a field, by its name in the inspector, under the heading of a column; null where there is no such row, and
        /// empty where there is no such column.
        /// </summary>
        public string Cell(string field, string column)
        {
            (string[] columns, string[] cells) = m_Rows.SingleOrDefault(
                row => !row.Cells[0].StartsWith('`') && row.Cells[0].Split('(')[0].Split(',').Any(name => Plain(name) == Plain(field)));
            if (cells == null)
                return null;
            int index = Array.IndexOf(columns, column);
            return index < 0 ? "" : cells[index];
        }

        /// <summary>Number as pages write it: "2.51·10⁻⁵", "10⁶", "−90"; null for what is no number.</summary>
        public static double? Number(string text)
        {
            const string raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
            string plain = text.Replace("−", "-");
            int ten = plain.IndexOf("10", StringComparison.Ordinal), exponent = plain.IndexOfAny((raised + "⁻").ToCharArray());
            if (exponent < 0)
                return double.TryParse(plain, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : null;
            string power = string.Concat(plain[exponent..].Select(letter => letter == '⁻' ? '-' : (char)('0' + raised.IndexOf(letter))));
            double mantissa = ten == 0 ? 1 : double.Parse(plain[..(ten - 1)], CultureInfo.InvariantCulture);
            return mantissa * Math.Pow(10, int.Parse(power, CultureInfo.InvariantCulture));
        }

        /// <summary>Both ends of a range: "−60–60".</summary>
        public static IEnumerable<double?> Range(string text) => text.Split('–').Select(Number);

        /// <summary>All numbers of a text without powers of ten: "−60–60", "0 to 1,000,000", "0.1 snaps, 5 slow".</summary>
        public static IEnumerable<double> Numbers(string text) =>
            Regex.Matches(text, @"(?<![\d.])−?\d+(?:,\d{3})*(?:\.\d+)?")
                .Select(match => double.Parse(match.Value.Replace("−", "-").Replace(",", ""), CultureInfo.InvariantCulture));

        private static bool IsHeading(string line) => line.StartsWith('#');

        // "Chord Delay", "chord-delay", "chordDelay" and "m_ChordDelay" are one name.
        private static string Plain(string name) =>
            string.Concat((name.StartsWith("m_", StringComparison.Ordinal) ? name[2..] : name).Where(char.IsLetterOrDigit))
            .ToLowerInvariant();
    }
}
