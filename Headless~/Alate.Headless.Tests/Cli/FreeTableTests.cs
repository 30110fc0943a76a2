using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Columns of the tables of a free flight, of moments made by hand: what each number is, in which unit.</summary>
public sealed class FreeTableTests
{
    private static readonly FreeMoment s_Moment = new FreeMoment(
        1.25, new float3(1f, 2f, 3f), quaternion.identity, new float3(0.5f, -0.25f, 2f), new float3(4f, 5f, 6f),
        new float3(0.1f, 0.2f, 1.5f), new float3(0.5f, -0.25f, -1f),
        Math.PI / 3.0, 10.5, 0.7, new float3(1e-3f, 5e-3f, -2e-3f), new float3(1e-5f, 2e-5f, 3e-5f), 0.03, 0.004, FlightState.Flying);

    [Test]
    public void TheTrajectory_IsInMetresDegreesAndHertz()
    {
        Dictionary<string, string> row = Trajectory(s_Moment);

        AssertAll(row, ("time_s", 1.25), ("x_m", 1), ("y_m", 2), ("z_m", 3), ("vx_m_s", 0.5), ("vy_m_s", -0.25), ("vz_m_s", 2));
        AssertAll(
            row, ("wanted_vx_m_s", 0.1), ("wanted_vy_m_s", 0.2), ("wanted_vz_m_s", 1.5), ("wx_rad_s", 4), ("wy_rad_s", 5), ("wz_rad_s", 6));
        AssertAll(row, ("phase_deg", 60), ("frequency_hz", 10.5), ("half_flap_deg", 40.107), ("aid_w", 0.004), ("heading_deg", 0),
            ("pitch_deg", 0), ("roll_deg", 0));
        Assert.That(row["state"], Is.EqualTo("Flying"));
    }

    [Test]
    public void TheTrajectory_HasTheCommandOfThePilot_BesideTheReference()
    {
        Dictionary<string, string> row = Trajectory(
            s_Moment with { Commanded = new float3(7f, -8f, 9f), CommandedHeading = 0.5 * Math.PI }), along = Trajectory(s_Moment);

        AssertAll(row, ("commanded_vx_m_s", 7), ("commanded_vy_m_s", -8), ("commanded_vz_m_s", 9), ("commanded_heading_deg", 90));
        Assert.That(along["commanded_heading_deg"], Is.Empty, "along the way");
    }

    // 100 m/s are asked for; the reference stays within what a monarch flies.
    [Test]
    public void AFlight_RecordsWhatItsPilotAskedFor()
    {
        FreeRecord flight = FreeRun.Fly(
            new FreePlan
            {
                Insect = Alate.Catalogue.InsectCatalogue.Find("monarch"),
                Seconds = 0.2,
                Pilot = new FreePilot("rush", [], false, (_, _) => new Rush()),
            },
            _ => { });

        Assert.That(flight.Moments.Select(at => at.Commanded), Is.All.EqualTo(new float3(0f, 0f, 100f)));
        Assert.That(flight.Moments.Select(at => at.CommandedHeading), Is.All.EqualTo(0.25).Within(1e-6));
        Assert.That(flight.Moments.Max(at => math.length(at.Wanted)), Is.LessThan(3f));
    }

    [TestCase(30f, 0f, 0f)]
    [TestCase(0f, 20f, 0f)]
    [TestCase(0f, 0f, 25f)]
    [TestCase(-110f, -40f, 0f)]
    [TestCase(170f, 10f, -35f)]
    public void HeadingPitchAndRoll_AreToTheRight_NoseUp_AndRightWingDown(float heading, float pitch, float roll)
    {
        // Where the nose and the right wing point, by sine and cosine alone.
        double h = heading * Math.PI / 180.0, p = pitch * Math.PI / 180.0, r = roll * Math.PI / 180.0;
        var ahead = new float3((float)(Math.Cos(p) * Math.Sin(h)), (float)Math.Sin(p), (float)(Math.Cos(p) * Math.Cos(h)));
        float3 level = new float3((float)Math.Cos(h), 0f, (float)-Math.Sin(h)), top = math.cross(ahead, level);
        float3 right = (float)Math.Cos(r) * level - (float)Math.Sin(r) * top;
        Dictionary<string, string> row = Trajectory(s_Moment with { Rotation = quaternion.LookRotation(ahead, math.cross(ahead, right)) });

        AssertAll(row, ("heading_deg", heading), ("pitch_deg", pitch));
        Assert.That(Math.Sin(Number(row["roll_deg"]) * Math.PI / 180.0), Is.EqualTo(Math.Sin(r) * Math.Cos(p)).Within(1e-4),
            "the right wing points as far down");
    }

    [Test]
    public void Forces_AreInNewtons_LiftAgainstGravity_DragAgainstTheWayThroughTheAir()
    {
        Dictionary<string, string> row = Forces(s_Moment);

        AssertAll(row, ("time_s", 1.25), ("phase_deg", 60), ("force_x_n", 1e-3), ("force_y_n", 5e-3), ("force_z_n", -2e-3));
        AssertAll(row, ("moment_x_nm", 1e-5), ("moment_y_nm", 2e-5), ("moment_z_nm", 3e-5), ("lift_n", 5e-3), ("power_w", 0.03));
        AssertAll(row, ("inertial_power_w", 0), ("positive_power_w", 0.065), ("negative_power_w", -0.035));
        AssertAll(row, ("right_fore_wing_power_w", 0.01), ("right_fore_wing_inertial_power_w", -0.03));
        AssertAll(row, ("left_fore_wing_positive_power_w", 0.06), ("left_fore_wing_negative_power_w", -0.01));
        AssertAll(row, ("drag_n", 2e-3));
        Assert.That(Forces(s_Moment with { Wind = new float3(0.5f, -0.25f, 4f) })["drag_n"], Is.EqualTo("-2E-3"),
            "a wind from behind, faster than the insect");
    }

    [TestCase(0.0, "down")]
    [TestCase(3.14, "down")]
    [TestCase(3.15, "up")]
    [TestCase(6.28, "up")]
    public void TheHalfStroke_IsThatOfTheFlap(double phase, string half) =>
        Assert.That(Forces(s_Moment with { Phase = phase })["half_stroke"], Is.EqualTo(half));

    [Test]
    public void Numbers_HaveAPoint_WhateverTheCulture()
    {
        using (new CommaCulture())
            Assert.That((Forces(s_Moment)["lift_n"], Trajectory(s_Moment)["frequency_hz"]), Is.EqualTo(("5E-3", "10.5")));
    }

    [Test]
    public void TheThorax_LiesBehindTheCentre_AsTheBodyIsTurned_AndTheUpstrokeHasItsShare()
    {
        FreeMoment up = s_Moment with { Phase = 4.0, Force = new float3(9f, 1e-3f, 0f), Rotation = quaternion.RotateY(0.5f * math.PI) };
        FreeRecord record = Record(s_Moment, up);

        Assert.That(math.distance(record.Thorax(s_Moment), new float3(1f, 2f, 3f) - new float3(0.1f, 0.2f, 0.4f)), Is.LessThan(1e-6f));
        Assert.That(math.distance(record.Thorax(up), new float3(1f, 2f, 3f) - new float3(0.4f, 0.2f, -0.1f)), Is.LessThan(1e-6f),
            "ahead turns to the right");
        Assert.That(record.UpstrokeShare, Is.EqualTo(1.0 / 6.0).Within(1e-6));
    }

    [Test]
    public void WordsOfAFlight_AreInMetresSharesAndMilliwatts()
    {
        FreeMoment up = s_Moment with
        {
            Time = 2.5,
            Phase = 4.0,
            Force = new float3(9f, 1e-3f, 0f),
            Power = 0.01,
            AidPower = 0.002,
            Velocity = s_Moment.Wanted,
            Position = new float3(1.234f, -2.5f, 3.456f),
        };
        FreeRecord record = Record(s_Moment, up) with { Insect = Alate.Catalogue.InsectCatalogue.Find("monarch"), Weight = 0.004 };
        // The first is off by 0.4, 0.45 and 0.5 m/s, the second by nothing.
        double off = Math.Sqrt(0.5 * (0.4 * 0.4 + 0.45 * 0.45 + 0.5 * 0.5));

        Assert.That(FreeReport.Way(record), Is.EqualTo("Monarch: 2.5 s by its own wings, from the origin to 1.23, -2.50, 3.46 m; "
            + FormattableString.Invariant($"velocity off by {off:0.000} m/s (bob and all)")));
        Assert.That(FreeReport.Air(record), Is.EqualTo("mean lift 0.750 of the weight, 17 % of it on the upstroke; power 20 mW; aid 3 mW"));
    }

    private static FreeRecord Record(params FreeMoment[] moments) => new FreeRecord(null, moments, new float3(0.1f, 0.2f, 0.4f), 1.0, null)
    {
        WingNames = ["right fore wing", "left fore wing"],
        Powers = [.. moments.Select(_ => new[] { new WingPower(0.01, -0.03, 0.005), new WingPower(0.02, 0.03, 0.06) })],
    };

    private static Dictionary<string, string> Trajectory(FreeMoment moment) => Row(TrajectoryTable.Of(Record(moment)));

    private static Dictionary<string, string> Forces(FreeMoment moment) => Row(ForceTable.Of(Record(moment)));

    private static Dictionary<string, string> Row(IEnumerable<IReadOnlyList<string>> table)
    {
        IReadOnlyList<string>[] rows = table.ToArray();
        Assert.That(rows[1], Has.Count.EqualTo(rows[0].Count));
        return rows[0].Zip(rows[1]).ToDictionary(cell => cell.First, cell => cell.Second);
    }

    private static void AssertAll(Dictionary<string, string> row, params (string Column, double Value)[] wanted)
    {
        foreach ((string column, double value) in wanted)
        {
            Assert.That(Number(row[column]), Is.EqualTo(value).Within(Math.Max(1e-4 * Math.Abs(value), 1e-9)).Or.EqualTo(value)
                .Within(Math.Abs(value) > 1.0 ? 1e-3 : 1e-9), column);
        }
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private sealed class Rush : IFlightPilot
    {
        public FlightCommand Command(in FlightSituation situation) => FlightCommand.Fly(new float3(0f, 0f, 100f), 0.25f);
    }
}
