using System;
using System.IO;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>The documentation's page of flight, whose tables the command <c>figures</c> writes.</summary>
    public sealed class FlightPageTests
    {
        // ALATE_WRITE_FIGURES=1 writes the page's tables again, as figures does with all pages.
        [Test]
        [Explicit]
        [Category("Long")]
        public void ItsTables_AreThoseOfToday()
        {
            string path = Path.Combine(PackageRoot.Find(), "Documentation~", FlightFigures.Page);
            string page = File.ReadAllText(path).ReplaceLineEndings("\n"), made = FlightFigures.Make(page);
            if (Environment.GetEnvironmentVariable("ALATE_WRITE_FIGURES") == "1")
                File.WriteAllText(path, made);

            Assert.That(page, Is.EqualTo(made), "run the command figures");
        }
    }
}
