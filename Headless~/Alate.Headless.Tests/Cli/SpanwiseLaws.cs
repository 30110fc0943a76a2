using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Laws of <c>spanwise.csv</c>, the air on strips along the span.</summary>
public sealed class SpanwiseLaws
{
    private FlightRecord m_Flown;
    private Dictionary<string, string>[] m_Rows;

    [OneTimeSetUp]
    public void Fly()
    {
        m_Flown = TetheredFlight.Fly(OddFlight.Plan with { RecordsAir = true, Substeps = 240 });
        m_Rows = Rows(m_Flown);
    }

    [Test]
    public void ThereIsARow_OfEachStrip_EachWing_EachSubstep() =>
        Assert.That(m_Rows, Has.Length.EqualTo(SpanStrip.Count * m_Flown.Wings.Count * 240));

    [TestCase("lift_n", 1e-4)]
    [TestCase("drag_n", 1e-4)]
    [TestCase("force_x_n", 1e-4)]
    [TestCase("force_y_n", 1e-4)]
    [TestCase("force_z_n", 1e-4)]
    [TestCase("moment_x_nm", 0.01)]
    [TestCase("moment_y_nm", 0.01)]
    [TestCase("moment_z_nm", 0.01)]
    public void SumsOverTheSpan_AreTheTotalsOfForces(string column, double share)
    {
        Dictionary<string, double[]> totals = PowerLaws.Table(ForceTable.Of(m_Flown));
        double size = totals[column].Max(Math.Abs);
        var sums = m_Rows.GroupBy(row => row["time_s"])
            .ToDictionary(rows => Number(rows.Key), rows => rows.Sum(row => Number(row[column])));
        for (int k = 0; k < totals["time_s"].Length; k++)
            Assert.That(sums[totals["time_s"][k]], Is.EqualTo(totals[column][k]).Within(share * size), $"row {k}");
    }

    [Test]
    public void Areas_SumUpToTheWing_AndSpansReachFromHingeToTip()
    {
        foreach (RecordedWing wing in m_Flown.Wings)
        {
            double length = wing.Wing.Preset.Size.wingLength;
            Dictionary<string, string>[] strips = Strips(wing, 0);
            Assert.That(strips.Select(strip => Number(strip["span_m"])),
                Is.EqualTo(Enumerable.Range(0, 20).Select(k => (k + 0.5) / 20 * length)).Within(1e-6));
            double area = 0;
            for (int k = 0; k < wing.Triangles.Length; k += 3)
            {
                float3 a = wing.Rest[wing.Triangles[k]], b = wing.Rest[wing.Triangles[k + 1]], c = wing.Rest[wing.Triangles[k + 2]];
                area += 0.5 * math.length(math.cross(b - a, c - a)) * length * length;
            }

            Assert.That(strips.Sum(strip => Number(strip["area_m2"])), Is.EqualTo(area).Within(3).Percent, wing.SideAndName);
        }
    }

    [Test]
    public void TheAngleOfAttack_AtThreeQuartersOfTheSpan_IsThatOfTheBlade()
    {
        foreach (RecordedWing wing in m_Flown.Wings)
        {
            double off = 0;
            for (int k = 0; k < wing.Frames.Count; k++)
            {
                Dictionary<string, string>[] strips = Strips(wing, k);
                IEnumerable<string> angles = strips.Select(strip => strip["attack_deg"]).Where(cell => cell.Length > 0);
                Assert.That(angles.Select(Number), Is.All.InRange(0.0, 90.0));
                double middle = 0.5 * (Number(strips[14]["attack_deg"]) + Number(strips[15]["attack_deg"]));
                off += Math.Abs(middle - math.degrees(wing.Frames[k].Attack));
            }

            Assert.That(off / wing.Frames.Count, Is.LessThan(4.0), wing.SideAndName);
        }
    }

    /// <summary>A stiff flat wing, whose leading edge is one line: the moment of all joints' loads about that line.</summary>
    [Test]
    public void ThePitchingMoment_IsThatAboutTheLeadingEdge_NoseUp()
    {
        using var run = new CommandRun();
        string mesh = run.Write("wing.obj", OwnWing.Obj()), skeleton = run.Write("wing.json", OwnWing.Skeleton());
        FlightRecord flown = TetheredFlight.Fly(new FlightPlan
        {
            MeshFile = mesh,
            SkeletonFile = skeleton,
            Species = "monarch",
            Column = ComparisonColumn.RigidWing,
            RecordsAir = true,
            Substeps = 96,
            Patches = 256,
        });
        Dictionary<string, string>[] rows = Rows(flown);
        RecordedWing wing = flown.Wings[0];
        double unit = wing.Wing.Preset.Size.wingMass * Math.Pow(wing.Wing.Preset.Size.wingLength, 2);
        double[] ours = new double[96], expected = new double[96], lever = new double[96];
        for (int k = 0; k < 96; k++)
        {
            RecordedFrame frame = wing.Frames[k];
            float3 from = frame.Joints[0], along = math.normalize(frame.Joints[wing.JointsPerChain - 1] - from);
            for (int joint = 0; joint < frame.Joints.Length; joint++)
                expected[k] -= unit * math.dot(math.cross(frame.Joints[joint] - from, frame.AirLoads[joint]), along);
            ours[k] = rows.Where(row => row["side"] == "right" && Number(row["time_s"]) == Number(FormatOf(frame.Time)))
                .Sum(row => Number(row["pitching_nm"]));
            // What the air does across a wing, which lies behind its leading edge, turns the nose to the other side.
            float3 behind = frame.Joints[^1] - from;
            lever[k] = math.dot(frame.AirForce, math.cross(behind, along));
        }

        double size = expected.Max(Math.Abs);
        Assert.That(ours, Is.EqualTo(expected).Within(0.05 * size));
        for (int k = 0; k < 96; k++)
        {
            if (Math.Abs(expected[k]) > 0.2 * size)
                Assert.That(Math.Sign(ours[k]), Is.EqualTo(Math.Sign(lever[k])), "nose down where the air lifts");
        }
    }

    private Dictionary<string, string>[] Strips(RecordedWing wing, int frame)
    {
        int wings = m_Flown.Wings.TakeWhile(one => one != wing).Count();
        return m_Rows[(SpanStrip.Count * (240 * wings + frame))..(SpanStrip.Count * (240 * wings + frame + 1))];
    }

    private static string FormatOf(double time) => Alate.Formats.CsvTable.Number(time);

    private static Dictionary<string, string>[] Rows(FlightRecord flight)
    {
        IReadOnlyList<string>[] rows = SpanwiseTable.Of(flight).ToArray();
        return rows.Skip(1).Select(row => rows[0].Zip(row).ToDictionary(cell => cell.First, cell => cell.Second)).ToArray();
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
