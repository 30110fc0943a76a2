using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Xml.Linq;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Air in the plane behind an insect, in its units and axes.</summary>
public sealed class WakePlaneLaws
{
    private const double k_Length = 0.05, k_Period = 0.1;
    private const float k_Pitch = 25f;

    private FreeWake m_Wake;
    private WakePlane m_Plane;
    private FlightPlan m_Flight;

    // A plate that is pitched in the body's axes as the body is against the world, in a stream along the world's axis.
    [OneTimeSetUp]
    public void Shed()
    {
        m_Flight = new FlightPlan { Species = "monarch", PitchDegrees = k_Pitch, Speed = 3.0 };
        var motion = new ThinWing
        {
            Span = 0.9f,
            Root = 0.05f,
            Chord = _ => 0.4,
            Move = _ => (0.0, 0.0, 0.05 - Math.PI / 180.0 * k_Pitch, 0.0),
        };
        var settings = new WakeSettings(WakeMethod.Panels)
        {
            Symmetric = true,
            SpanPanels = 8,
            Stream = m_Flight.AirInBodyAxes * (float)(k_Period / k_Length),
        };
        m_Wake = new FreeWake(settings, [new WakeWing(motion)]);
        m_Plane = new WakePlane(m_Flight, 0.04, k_Length, k_Period);
        for (int k = 0; k < 30; k++)
            m_Wake.Step();
        m_Plane.Add(m_Wake);
    }

    [OneTimeTearDown]
    public void Free() => m_Wake.Dispose();

    [Test]
    public void Places_AreMetres_UprightAcrossTheWay_BehindTheInsect()
    {
        float3 first = m_Plane.Place(0, 0), last = m_Plane.Place(m_Plane.Columns - 1, m_Plane.Rows - 1);

        Assert.That(first.x, Is.EqualTo(-1.6 * k_Length).Within(1e-6));
        Assert.That(first.y, Is.EqualTo(1.4 * k_Length).Within(1e-6));
        Assert.That(math.distance(last, first * new float3(-1f, -1f, 1f)), Is.LessThan(1e-6f));
        Assert.That(new[] { first.z, last.z }, Is.All.EqualTo(-0.04).Within(1e-6));
    }

    [Test]
    public void Velocities_AreThoseOfTheWake_InMetresASecond_AlongTheWorldsAxes()
    {
        var found = new float3[1];
        foreach ((int column, int row) in new[] { (5, 7), (32, 28), (50, 40) })
        {
            float3 place = m_Plane.Place(column, row);
            m_Wake.Velocities([m_Flight.ToBody(place) / (float)k_Length], found);
            float3 expected = m_Flight.ToWorld(found[0]) * (float)(k_Length / k_Period);
            Assert.That(math.distance(m_Plane.Velocity(column, row), expected), Is.LessThan(1e-5f * math.length(expected) + 1e-8f));
        }

        // A stream that is level in the world: the wake lies behind the wings, and the air there goes down.
        int middle = m_Plane.Rows / 2;
        Assert.That(m_Plane.Velocity(m_Plane.Columns / 2 + 10, middle).y, Is.LessThan(0f), "behind the middle of a wing");
        int strongest = Enumerable.Range(0, m_Plane.Rows).MaxBy(row => Math.Abs(m_Plane.Vorticity(m_Plane.Columns - 15, row)));
        Assert.That(strongest, Is.EqualTo(middle).Within(6), "as high as the wings");
    }

    [Test]
    public void Vorticity_IsTheCirculationAroundASquare_OverItsArea_ClockwiseFromBehind()
    {
        double step = m_Plane.Place(1, 0).x - m_Plane.Place(0, 0).x, worst = 0.0, most = 0.0;
        for (int row = 1; row < m_Plane.Rows - 1; row++)
        {
            for (int column = 1; column < m_Plane.Columns - 1; column++)
            {
                // Right along the upper side, down the right one, left along the lower one, up the left one.
                double around = 2.0 * step * (m_Plane.Velocity(column, row - 1).x - m_Plane.Velocity(column + 1, row).y
                    - m_Plane.Velocity(column, row + 1).x + m_Plane.Velocity(column - 1, row).y);
                worst = Math.Max(worst, Math.Abs(m_Plane.Vorticity(column, row) - around / (4.0 * step * step)));
                most = Math.Max(most, Math.Abs(m_Plane.Vorticity(column, row)));
            }
        }

        Assert.That(worst, Is.LessThan(1e-4 * most));
        // Air comes up outside of the left tip and goes down inside of it.
        int tip = m_Plane.Columns / 2 - 19;
        Assert.That(
            Enumerable.Range(0, m_Plane.Rows).Select(row => m_Plane.Vorticity(tip, row)).MaxBy(Math.Abs), Is.GreaterThan(0.3 * most));
    }

    [Test]
    public void TheTable_HasARowAPlace_InMetresAndSeconds()
    {
        string[][] rows = [.. m_Plane.Table().Select(row => row.ToArray())];
        string[] one = rows[1 + 20 * m_Plane.Columns + 40];

        Assert.That(rows, Has.Length.EqualTo(1 + m_Plane.Columns * m_Plane.Rows));
        Assert.That(rows[0], Is.EqualTo(
            new[] { "x_m", "y_m", "z_m", "velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s", "vorticity_1_s" }));
        float3 place = m_Plane.Place(40, 20), velocity = m_Plane.Velocity(40, 20);
        double[] expected = [place.x, place.y, place.z, velocity.x, velocity.y, velocity.z, m_Plane.Vorticity(40, 20)];
        for (int k = 0; k < one.Length; k++)
        {
            Assert.That(
                double.Parse(one[k], CultureInfo.InvariantCulture), Is.EqualTo(expected[k]).Within(1e-5 * Math.Abs(expected[k]) + 1e-12));
        }
    }

    [Test]
    public void ThePicture_HasItsColoursWhereTheAirTurns_AndItsNumbers()
    {
        var svg = XElement.Parse(WakePlanePicture.Draw(m_Plane, "Plate"));
        XNamespace ns = svg.Name.Namespace;
        List<XElement> cells = [.. svg.Elements(ns + "rect").Where(cell => cell.Attribute("fill-opacity") != null)];
        XElement densest = cells.MaxBy(cell => Number(cell, "fill-opacity"));
        int column = (int)Math.Round((Number(densest, "x") - 26) / 10), row = (int)Math.Round((Number(densest, "y") - 70) / 10);
        double most = Enumerable.Range(0, m_Plane.Columns * m_Plane.Rows)
            .Max(k => Math.Abs(m_Plane.Vorticity(k % m_Plane.Columns, k / m_Plane.Columns)));

        Assert.That(Math.Abs(m_Plane.Vorticity(column, row)), Is.EqualTo(most).Within(1).Percent);
        Assert.That((string)densest.Attribute("fill"), Is.EqualTo(m_Plane.Vorticity(column, row) > 0.0 ? "#b3261e" : "#1f5fa8"));
        string[] texts = [.. svg.Elements(ns + "text").Select(text => text.Value)];
        Assert.That(texts[0], Is.EqualTo("Plate: the air 40 mm behind, mean of a beat"));
        Assert.That(texts[1], Does.EndWith(FormattableString.Invariant($"vorticity up to {most:0} 1/s")));
        Assert.That(texts[2], Does.StartWith("160 mm wide"));
        // The longest line is as long as told, and leads where the air goes.
        XElement longest = svg.Elements(ns + "line").MaxBy(Length);
        Assert.That(Length(longest), Is.InRange(15.0, 30.1));
        Assert.That(
            svg.Elements(ns + "line").Count(line => Number(line, "y2") > Number(line, "y1") && Length(line) > 5), Is.GreaterThan(3));
    }

    private static double Number(XElement element, string name) =>
        double.Parse((string)element.Attribute(name), CultureInfo.InvariantCulture);

    private static double Length(XElement line) => Math.Sqrt(Math.Pow(Number(line, "x2") - Number(line, "x1"), 2)
        + Math.Pow(Number(line, "y2") - Number(line, "y1"), 2));
}
