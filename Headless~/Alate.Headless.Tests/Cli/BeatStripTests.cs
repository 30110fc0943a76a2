using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Alate.Cli.Flights;
using Alate.Cli.Pictures;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Content of the strip of a flight, read back from its paths.</summary>
    public sealed class BeatStripTests
    {
        private const int k_Phases = 12;

        private static readonly XNamespace s_Svg = "http://www.w3.org/2000/svg";

        private string m_Text;
        private XElement m_Picture;
        private List<XElement> m_Panels;

        [OneTimeSetUp]
        public void Draw()
        {
            m_Text = BeatStrip.Draw(MonarchFlight.Level);
            m_Picture = XElement.Parse(m_Text);
            m_Panels = m_Picture.Elements(s_Svg + "g").ToList();
        }

        [Test]
        public void EveryPoint_LiesInTheFrame()
        {
            double[] frame = Numbers(m_Picture.Attribute("viewBox").Value);
            foreach (XElement panel in m_Panels)
            {
                double[] place = Numbers(panel.Attribute("transform").Value);
                List<(int X, int Y)> points = Points(panel);
                Assert.That(points.Select(point => place[0] + place[2] * point.X), Is.All.InRange(0.0, frame[2]));
                Assert.That(points.Select(point => place[1] + place[2] * point.Y), Is.All.InRange(0.0, frame[3]));
            }
        }

        [Test]
        public void AllPhases_HaveOneScale()
        {
            Assert.That(m_Panels, Has.Count.EqualTo(k_Phases));
            Assert.That(m_Panels.Select(panel => Numbers(panel.Attribute("transform").Value)[2]).Distinct().Count(), Is.EqualTo(1));
        }

        [Test]
        public void TheWings_AreHighAtTheStart_AndLowHalfABeatLater()
        {
            // Heights over the body's, which lies at the same place within a row; y points down.
            (int Top, int Bottom) start = Extent(m_Panels[0]), later = Extent(m_Panels[3]);
            (int Top, int Bottom) rowStart = Extent(m_Panels[4]), half = Extent(m_Panels[6]);

            Assert.That(start.Top, Is.LessThan(later.Top - 100));
            Assert.That(half.Bottom, Is.GreaterThan(rowStart.Bottom + 100));
        }

        [Test]
        public void EveryPhase_IsAPoseOfItsOwn()
        {
            Assert.That(m_Panels.Select(panel => panel.ToString()).Distinct().Count(), Is.EqualTo(k_Phases));
            Assert.That(m_Panels.Select(Extent).Distinct().Count(), Is.EqualTo(k_Phases));
        }

        [Test]
        public void UnderEachPhase_StandsItsTime()
        {
            double period = 1000.0 / MonarchFlight.Level.Wings[0].Frequency;
            double[] told = m_Picture.Elements(s_Svg + "text").Select(text => text.Value).Where(text => Regex.IsMatch(text, "^[0-9.]+ ms$"))
                .Select(text => Numbers(text)[0]).ToArray();

            Assert.That(told, Is.EqualTo(Enumerable.Range(0, k_Phases).Select(k => k * period / k_Phases)).Within(0.051));
        }

        [Test]
        public void TheMonarch_IsOrange()
        {
            var areas = new Dictionary<string, double>();
            foreach (XElement path in m_Panels[4].Elements(s_Svg + "path").Where(path => path.Attribute("class").Value == "f"))
            {
                string colour = path.Attribute("color").Value;
                areas[colour] = areas.GetValueOrDefault(colour) + Area(path);
            }

            string most = areas.OrderByDescending(pair => pair.Value).First().Key;
            int rgb = Convert.ToInt32(most.Substring(1), 16), red = rgb >> 16, green = (rgb >> 8) & 255, blue = rgb & 255;
            Assert.That(red, Is.GreaterThan(green + 50), most);
            Assert.That(green, Is.GreaterThan(blue + 50), most);
        }

        [Test]
        public void TheTextIsTheSame_EachTimeAndWhateverTheCulture()
        {
            using (new CommaCulture())
                Assert.That(BeatStrip.Draw(MonarchFlight.Level) == m_Text);
        }

        [Test]
        public void AWingWithoutColours_IsDrawnToo()
        {
            using var run = new CommandRun();
            var plan = new FlightPlan
            {
                Species = "monarch",
                MeshFile = run.Write("R&D.obj", OwnWing.Obj()),
                SkeletonFile = run.Write("wing.json", OwnWing.Skeleton()),
                Seconds = 0.2,
            };

            var picture = XElement.Parse(BeatStrip.Draw(MonarchFlight.Fly(plan)));

            Assert.That(picture.Elements(s_Svg + "g").Select(panel => Points(panel).Count), Is.All.GreaterThan(100));
            Assert.That(picture.Element(s_Svg + "title").Value, Does.StartWith("R&D"), "a name is text, whatever its letters");
        }

        private static (int Top, int Bottom) Extent(XElement panel)
        {
            List<(int X, int Y)> points = Points(panel);
            return (points.Min(point => point.Y), points.Max(point => point.Y));
        }

        private static List<(int X, int Y)> Points(XElement panel) =>
            panel.Elements(s_Svg + "path").SelectMany(Loops).SelectMany(loop => loop).ToList();

        private static double Area(XElement path)
        {
            double doubled = 0.0;
            foreach (List<(int X, int Y)> loop in Loops(path))
            {
                for (int k = 0; k < loop.Count; k++)
                {
                    (int X, int Y) next = loop[(k + 1) % loop.Count];
                    doubled += (double)loop[k].X * next.Y - (double)next.X * loop[k].Y;
                }
            }

            return Math.Abs(0.5 * doubled);
        }

        // Relative steps: "m" moves and goes on with lines, "z" goes back to where the loop began.
        private static IEnumerable<List<(int X, int Y)>> Loops(XElement path)
        {
            (int X, int Y) at = (0, 0);
            foreach (Match part in Regex.Matches(path.Attribute("d").Value, "m([^mz]*)(z?)"))
            {
                int[] steps = Array.ConvertAll(Numbers(part.Groups[1].Value), number => (int)number);
                Assert.That(steps.Length % 2, Is.Zero, "pairs");
                var loop = new List<(int X, int Y)>();
                for (int k = 0; k < steps.Length; k += 2)
                    loop.Add(at = (at.X + steps[k], at.Y + steps[k + 1]));
                if (part.Groups[2].Length > 0)
                    at = loop[0];
                yield return loop;
            }
        }

        private static double[] Numbers(string text) =>
            Regex.Matches(text, "-?[0-9]+(\\.[0-9]+)?").Select(match => double.Parse(match.Value, CultureInfo.InvariantCulture)).ToArray();
    }
}
