using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Pictures of the manual's page of the model.</summary>
public sealed class ManualFigureTests
{
    private static readonly XNamespace s_Svg = "http://www.w3.org/2000/svg";

    private static readonly Regex s_Number = new(@"-?\d+(\.\d+)?");

    private static IEnumerable<string> Names => ManualFigures.Pictures.Select(picture => picture.Name);

    // To a unit of the last digit: other processors round otherwise.
    [TestCaseSource(nameof(Names))]
    public void APictureOfTheManual_IsThatOfToday(string name)
    {
        string path = Path.Combine(PackageRoot.Find(), "Documentation~", name), now = Draw(name);
        if (Environment.GetEnvironmentVariable("ALATE_WRITE_FIGURES") == "1")
            File.WriteAllText(path, now);
        string told = File.ReadAllText(path).ReplaceLineEndings("\n");

        Assert.That(s_Number.Replace(now, "#"), Is.EqualTo(s_Number.Replace(told, "#")), "run figures --pictures");
        Assert.That(Numbers(now).Zip(Numbers(told), (here, there) => Math.Abs(here - there)).Max(), Is.LessThan(0.11));
        Assert.That(told, Has.Length.LessThan(150_000));
    }

    // Of each of 640 flights one dot, and the compromises.
    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void ThePictureOfTheStudies_IsThatOfToday()
    {
        string folder = Path.Combine(PackageRoot.Find(), "Documentation~"), now = FiguresCommand.Study(folder),
            told = File.ReadAllText(Path.Combine(folder, "images", "study.svg")).ReplaceLineEndings("\n");

        Assert.That(s_Number.Replace(now, "#"), Is.EqualTo(s_Number.Replace(told, "#")), "run figures --pictures");
        Assert.That(Numbers(now).Zip(Numbers(told), (here, there) => Math.Abs(here - there)).Max(), Is.LessThan(0.11));
        Assert.That(XElement.Parse(told).Elements(s_Svg + "circle").Count(), Is.GreaterThan(640));
    }

    // Five chains, their rows, 25 joints, the ring and the axis of the hinge, the patches of the rig.
    [Test]
    public void ThePictureOfTheTool_IsWhatTheToolDraws()
    {
        XElement[] shapes = [.. XElement.Parse(Draw("images/skeleton-tool.svg")).Elements()];
        string[] Strokes(string colour) =>
            [.. shapes.Where(shape => (string)shape.Attribute("stroke") == colour).Select(shape => shape.Name.LocalName)];
        int Filled(string colour) => shapes.Count(shape => (string)shape.Attribute("fill") == colour);

        Assert.That((Strokes("#ff8c26").Length, Strokes("#73ccff").Length), Is.EqualTo((1, 4 + 4 * 5)), "chains, and rows between them");
        Assert.That((Filled("#e6f2ff"), Filled("#ffe61a")), Is.EqualTo((23, 2)), "joints");
        Assert.That(Strokes("#66ff80"), Is.EqualTo(new[] { "circle" }), "hinge");
        Assert.That(shapes.Count(shape => shape.Attribute("fill-opacity") != null), Is.InRange(32, 200), "colours of patches");
        Assert.That(shapes.Where(shape => shape.Name.LocalName == "text").Select(text => text.Value),
            Is.SupersetOf(new[] { "chain 0", "chain 4", "3", "hinge" }));
    }

    // What is drawn lies on the page.
    [TestCaseSource(nameof(Names))]
    public void APicture_StaysOnItsPage_AndSaysWhatItShows(string name)
    {
        var page = XElement.Parse(Draw(name));
        double[] size = [.. Numbers((string)page.Attribute("viewBox"))];
        foreach (XElement shape in page.Descendants(s_Svg + "circle"))
        {
            Assert.That((double)shape.Attribute("cx"), Is.InRange(0.0, size[2]), shape.ToString());
            Assert.That((double)shape.Attribute("cy"), Is.InRange(0.0, size[3]), shape.ToString());
        }

        foreach (XElement path in page.Descendants(s_Svg + "path").Where(path => !((string)path.Attribute("d")).Contains('h')))
        {
            double[] points = [.. Numbers((string)path.Attribute("d"))];
            Assert.That(points.Where((_, k) => k % 2 == 0), Is.All.InRange(0.0, size[2]), path.ToString());
            Assert.That(points.Where((_, k) => k % 2 == 1), Is.All.InRange(0.0, size[3]), path.ToString());
        }

        foreach (XElement text in page.Descendants(s_Svg + "text").Where(text => text.Attribute("text-anchor") == null))
        {
            double end = (double)text.Attribute("x") + 0.49 * (double)text.Attribute("font-size") * text.Value.Length;
            Assert.That(end, Is.LessThan(size[2]), text.Value);
        }

        Assert.That(page.Element(s_Svg + "title").Value, Is.Not.Empty);
    }

    [Test]
    public void TheSkeletons_HaveADotForEachJointOfEachWing_AndLinesAroundTheirMeshes()
    {
        var page = XElement.Parse(SkeletonFigure.Draw());
        int joints = InsectCatalogue.All.SelectMany(insect => insect.Wings).Sum(wing => wing.Chains * wing.JointsPerChain),
            chains = InsectCatalogue.All.SelectMany(insect => insect.Wings).Sum(wing => wing.Chains);

        Assert.That(page.Elements(s_Svg + "circle").Count(), Is.EqualTo(joints));
        Assert.That(page.Elements(s_Svg + "path").Count(path => (string)path.Attribute("fill") == "none"), Is.EqualTo(chains));
        Assert.That(page.Elements(s_Svg + "text").Select(text => text.Value),
            Is.SupersetOf(InsectCatalogue.All.Select(insect => insect.DisplayName)));
    }

    // The margin of a mesh is as long as the edges that one triangle has, and goes around its area.
    [Test]
    public void TheMarginOfAWing_GoesAroundItsArea()
    {
        foreach (InsectDefinition insect in InsectCatalogue.All)
        {
            foreach (InsectWing wing in Insect.Of(FlightPlan.Cruise(insect, InsectVariant.Standard)).Wings)
            {
                double area = 0.0;
                for (int k = 0; k < wing.Surface.triangles.Length; k += 3)
                {
                    float3 At(int corner) => wing.Surface.positions[wing.Surface.triangles[k + corner]];
                    area += 0.5 * Math.Abs(math.cross(At(1) - At(0), At(2) - At(0)).y) / Math.Pow(InsectDefinition.UnitsPerMetre, 2);
                }

                double around = PlanWing.Of(wing).Margins.Sum(Area);
                Assert.That(Math.Abs(around), Is.EqualTo(area).Within(1).Percent, $"{insect.Name}, {wing.Name}");
            }
        }
    }

    // A beat of the flap alone moves no joint along the chord; the last bone of the leading chain reaches the whole flap.
    [Test]
    public void FlapAlone_IsTheCosineOfTheClock_AtTheEndOfTheLeadingChain()
    {
        (InsectWing wing, WingParameters flap) = Flapping();
        flap.chordDelay = flap.spanDelay = 0f;
        var driven = DrivenWing.Of(wing, flap);
        int last = driven.Joints - 2;
        for (int moment = 0; moment < DrivenWing.Moments; moment++)
        {
            double angle = flap.meanFlap + flap.amplitude.x * Math.Cos(2 * Math.PI * moment / DrivenWing.Moments + flap.phase.x);
            Assert.That(driven.Flaps[moment][last], Is.EqualTo(angle).Within(0.02), $"moment {moment}");
        }

        for (int chain = 0; chain < driven.Chains; chain++)
            Assert.That(DelayFigure.Delay(driven, chain, last), Is.EqualTo(0.0).Within(0.01));
    }

    // λ and μ of Eq. 2: along the span the delay of the preset, over the chord as much as its chains have room for.
    [Test]
    public void Delays_GrowAlongEachChain_AndFromChainToChain()
    {
        (InsectWing wing, WingParameters flap) = Flapping();
        var driven = DrivenWing.Of(wing, flap);
        for (int chain = 0; chain < driven.Chains; chain++)
        {
            for (int bone = 0; bone < driven.Joints - 1; bone++)
            {
                double here = DelayFigure.Delay(driven, chain, bone);
                if (bone > 0)
                    Assert.That(here, Is.GreaterThan(DelayFigure.Delay(driven, chain, bone - 1)), $"{chain}, {bone}");
                if (chain > 0)
                    Assert.That(here, Is.GreaterThan(DelayFigure.Delay(driven, chain - 1, bone)), $"{chain}, {bone}");
            }
        }

        double across = DelayFigure.Delay(driven, driven.Chains - 1, 0);
        Assert.That(across, Is.EqualTo(180 * flap.chordDelay).Within(1).Percent, "half a beat at 1");
    }

    // Of two tones the one of half the amplitude lies six decibels below the other; what is silent is drawn at the quietest.
    [Test]
    public void OvertonesOfASound_AreAsFarBelowTheStrongestAsTheirAmplitudesSay()
    {
        double[] beats = new double[4000];
        for (int k = 0; k < beats.Length; k++)
        {
            double turn = 2 * Math.PI * 2 * k / beats.Length;
            beats[k] = 0.3 * Math.Sin(3 * turn + 0.4) + 0.15 * Math.Cos(5 * turn);
        }

        double[] levels = [.. HumFigure.Levels(beats).Select(point => point.Y)];
        Assert.That(levels, Has.Length.EqualTo(12));
        Assert.That((levels[2], levels[4]), Is.EqualTo((0.0, -20 * Math.Log10(2))).Within(1e-6));
        Assert.That(levels.Where((_, k) => k != 2 && k != 4), Is.All.EqualTo(-60.0));
    }

    // The curves of a wing are the angles of its file, drawn over the beat.
    [Test]
    public void TheMeasuredAngles_AreThoseOfTheFile()
    {
        XElement[] curves = [.. XElement.Parse(KinematicsFigure.Draw()).Elements(s_Svg + "path")
            .Where(path => path.Attribute("clip-path") != null)];
        double[] flap = [.. Numbers((string)curves[0].Attribute("d"))], hind = [.. Numbers((string)curves[3].Attribute("d"))];
        Assert.That(curves, Has.Length.EqualTo(6));
        for (int k = 0; k <= 96; k++)
        {
            double turn = 2 * Math.PI * k / 96;
            Assert.That(flap[2 * k + 1], Is.EqualTo(Height(36 * Math.Cos(turn))).Within(0.15), "the fore wing's flap");
            Assert.That(hind[2 * k + 1], Is.EqualTo(Height(26 * Math.Cos(turn + 51 * Math.PI / 180))).Within(0.15), "the hind wing's");
        }

        static double Height(double degrees) => 108 + 34 + (284 - 34 - 26) * (60 - degrees) / 150;
    }

    private static (InsectWing Wing, WingParameters Flap) Flapping()
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        InsectWing wing = Insect.Of(plan).Wings[0];
        WingParameters flap = plan.ParametersOf(wing.Preset);
        flap.amplitude *= new float3(1f, 0f, 0f);
        return (wing, flap);
    }

    private static string Draw(string name) => ManualFigures.Pictures.Single(picture => picture.Name == name).Draw();

    private static double Area(List<float2> loop)
    {
        double area = 0.0;
        for (int k = 0; k < loop.Count; k++)
        {
            (float2 a, float2 b) = (loop[k], loop[(k + 1) % loop.Count]);
            area += 0.5 * ((double)a.x * b.y - (double)b.x * a.y);
        }

        return area;
    }

    private static IEnumerable<double> Numbers(string text) =>
        s_Number.Matches(text).Select(match => double.Parse(match.Value, CultureInfo.InvariantCulture));
}
