using System.Globalization;
using System.IO;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Lifts of a monarch that is held at its cruise, as pages tell them in words, which no command writes again.</summary>
    public sealed class ManualLiftLaws
    {
        [TestCase("README.md", @"standard strokes carry ([\d.]+) of a monarch's weight", 0)]
        [TestCase("README.md", @"`--pitch 30` gives ([\d.]+) ", 30)]
        [TestCase("Documentation~/species.md", @"\(([\d.]+) of the monarch's weight at 18.6°", 18.6)]
        [TestCase("Documentation~/species.md", @"monarch's weight at 18.6°, ([\d.]+) at 30°", 30)]
        public void APage_TellsTheLiftThatIsFlown(string page, string sentence, double pitch)
        {
            Match told = Regex.Match(File.ReadAllText(Path.Combine(PackageRoot.Find(), page)), sentence);
            Assert.That(told.Success, page);
            FlightRecord flight = TetheredFlight.Fly(new FlightPlan { Species = "monarch", PitchDegrees = pitch });

            Assert.That(double.Parse(told.Groups[1].Value, CultureInfo.InvariantCulture),
                Is.EqualTo(FlightSummary.Of(flight).LiftOverWeight).Within(0.006));
        }
    }
}
