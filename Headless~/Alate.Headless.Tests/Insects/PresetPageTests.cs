using System.Linq;
using System.Reflection;
using Alate.Cli;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Units, ranges and defaults of the manual's page of the preset, against those of the fields.</summary>
    public sealed class PresetPageTests
    {
        [Test]
        public void EveryNumber_HasARow_WithItsUnitRangeAndDefault()
        {
            PageTable[] tables = new[] { "Size", "Beat", "Wave", "Stiffness" }
                .Select(heading => new PageTable("wing-preset", heading)).ToArray();
            WingPreset monarch = ScriptableObject.CreateInstance<WingPreset>();
            foreach (FlownParameter parameter in FlownParameters.OfSpecies)
            {
                PageTable table = tables.SingleOrDefault(one => one.Cell(parameter.Name, "unit") != null);
                Assert.That(table, Is.Not.Null, parameter.Name);
                string unit = table.Cell(parameter.Name, "unit");
                Assert.That(unit == "–" || unit.StartsWith('×') ? "" : unit, Is.EqualTo(parameter.Unit), parameter.Name);
                Assert.That(PageTable.Range(table.Cell(parameter.Name, "range")),
                    Is.EqualTo(new[] { parameter.Min, parameter.Max }).Within(1e-4).Percent, parameter.Name);
                Assert.That(PageTable.Number(table.Cell(parameter.Name, "default")), Is.EqualTo(parameter.Of(monarch)).Within(1e-4).Percent,
                    parameter.Name);
            }

            Object.DestroyImmediate(monarch);
        }

        [Test]
        public void OfTheInsectsMass_PageAndInspectorSayThatTrimsGoWithIt()
        {
            string tooltip = typeof(PresetSize).GetField(nameof(PresetSize.insectMass)).GetCustomAttribute<TooltipAttribute>().tooltip;

            Assert.That(tooltip, Does.Contain("Insect Flight").And.Contain("trims"));
            Assert.That(new PageTable("wing-preset", "Size").Cell("Insect Mass", "at its ends"),
                Does.Contain("Insect Flight").And.Contain("trims"));
        }
    }
}
