using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Alate.Cli.Parameters;
using Alate.Cli.Projects;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Units, ranges and defaults of the manual's page of the preset, against those of the fields.</summary>
    public sealed class PresetPageTests
    {
        private static readonly string[][] s_Rows = File.ReadAllLines(Path.Combine(PackageRoot.Find(), "Documentation~", "wing-preset.md"))
            .Where(line => line.StartsWith('|')).Select(line => line.Split('|').Select(cell => cell.Trim()).ToArray()).ToArray();

        [Test]
        public void EveryNumber_HasARow_WithItsUnitRangeAndDefault()
        {
            WingPreset monarch = ScriptableObject.CreateInstance<WingPreset>();
            foreach (FlownParameter parameter in FlownParameters.OfSpecies)
            {
                string[] row = s_Rows.SingleOrDefault(cells => Name(cells[1]) == parameter.Name);
                Assert.That(row, Is.Not.Null, parameter.Name);
                string[] range = row[3].Split('–');
                Assert.That(row[2] == "–" || row[2].StartsWith('×') ? "" : row[2], Is.EqualTo(parameter.Unit), parameter.Name);
                Assert.That(range.Select(Number), Is.EqualTo(new[] { parameter.Min, parameter.Max }).Within(1e-4).Percent, parameter.Name);
                Assert.That(Number(row[4]), Is.EqualTo(parameter.Of(monarch)).Within(1e-4).Percent, parameter.Name);
            }

            UnityEngine.Object.DestroyImmediate(monarch);
        }

        // "Chord Delay (λ)" is chord-delay.
        private static string Name(string cell) => cell.Split('(')[0].Trim().Replace(' ', '-').ToLowerInvariant();

        // "2.51·10⁻⁵", "10⁶", "−90".
        private static double Number(string text)
        {
            const string raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
            string plain = text.Replace("−", "-");
            int ten = plain.IndexOf("10", StringComparison.Ordinal), exponent = plain.IndexOfAny((raised + "⁻").ToCharArray());
            if (exponent < 0)
                return double.Parse(plain, CultureInfo.InvariantCulture);
            string power = string.Concat(plain[exponent..].Select(letter => letter == '⁻' ? '-' : (char)('0' + raised.IndexOf(letter))));
            double mantissa = ten == 0 ? 1 : double.Parse(plain[..(ten - 1)], CultureInfo.InvariantCulture);
            return mantissa * Math.Pow(10, int.Parse(power, CultureInfo.InvariantCulture));
        }
    }
}
