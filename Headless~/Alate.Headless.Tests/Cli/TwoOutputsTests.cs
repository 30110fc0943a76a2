using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>
/// Files of one flight against each other, by Newton's law and by sight: what one says in its units the others say in theirs.
/// </summary>
public sealed class TwoOutputsTests
{
    private CommandRun m_Free, m_Held;

    [OneTimeSetUp]
    public void Fly()
    {
        (m_Free, m_Held) = (new CommandRun(), new CommandRun());
        string[] flight = ["fly", "monarch", "--free", "--to", "0.6,0.2,2", "--seconds", "3", "--step", "0.01", "--no-pictures"];
        Assert.That(m_Free.Run([.. flight, "--out", m_Free.Out]), Is.Zero, m_Free.Errors);
        Assert.That(m_Held.Run("fly", "monarch", "--speed", "1.2", "--climb", "0.3", "--pitch", "20", "--no-pictures", "--out", m_Held.Out),
            Is.Zero, m_Held.Errors);
    }

    [OneTimeTearDown]
    public void RemoveFolders()
    {
        m_Free.Dispose();
        m_Held.Dispose();
    }

    [Test]
    public void Forces_AreWhatTheMomentumGains_BesidesTheWeight()
    {
        Dictionary<string, double[]> path = Table(m_Free, "trajectory.csv"), forces = Table(m_Free, "forces.csv");
        using FlightModel monarch = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
        int last = path["time_s"].Length - 1;
        foreach (string axis in new[] { "x", "y", "z" })
        {
            double impulse = 0.0, gained = monarch.Mass * (path[$"v{axis}_m_s"][last] - path[$"v{axis}_m_s"][0]);
            for (int k = 1; k <= last; k++)
            {
                impulse +=
                    (path["time_s"][k] - path["time_s"][k - 1]) * (forces[$"force_{axis}_n"][k] - (axis == "y" ? monarch.Weight : 0.0));
            }
            Assert.That(impulse, Is.EqualTo(gained).Within(0.03 * monarch.Weight * path["time_s"][last]), axis);
        }

        Assert.That(forces["time_s"], Is.EqualTo(path["time_s"]).Within(1e-4));
        Assert.That(forces["phase_deg"], Is.EqualTo(path["phase_deg"]).Within(1e-3));
        Assert.That(forces["lift_n"], Is.EqualTo(forces["force_y_n"]));
    }

    [Test]
    public void ThePath_IsWhatTheVelocityCovers_AndTheHeadingIsItsWay()
    {
        Dictionary<string, double[]> path = Table(m_Free, "trajectory.csv");
        int last = path["time_s"].Length - 1;
        foreach (string axis in new[] { "x", "y", "z" })
        {
            double covered = 0.0;
            for (int k = 1; k <= last; k++)
                covered += 0.5 * (path["time_s"][k] - path["time_s"][k - 1]) * (path[$"v{axis}_m_s"][k] + path[$"v{axis}_m_s"][k - 1]);
            Assert.That(covered, Is.EqualTo(path[$"{axis}_m"][last] - path[$"{axis}_m"][0]).Within(0.02), axis);
        }

        int half = last / 2;
        double way = Math.Atan2(path["vx_m_s"].Skip(half).Average(), path["vz_m_s"].Skip(half).Average()) * 180.0 / Math.PI;
        Assert.That(path["heading_deg"].Skip(half).Average(), Is.EqualTo(way).Within(8.0), "degrees to the right");
        Assert.That(way, Is.GreaterThan(3.0), "the goal lies to the right");
    }

    [Test]
    public void Angles_TurnAtTheAngularVelocity()
    {
        // Over half a beat the pitch goes up where the body turns about its right wing backwards.
        Dictionary<string, double[]> path = Table(m_Free, "trajectory.csv");
        double sum = 0.0, size = 0.0;
        for (int k = 1; k < path["time_s"].Length; k++)
        {
            double rate = (path["pitch_deg"][k] - path["pitch_deg"][k - 1]) / (path["time_s"][k] - path["time_s"][k - 1]),
                told = -0.5 * (path["wx_rad_s"][k] + path["wx_rad_s"][k - 1]) * 180.0 / Math.PI;
            sum += rate * told;
            size += told * told;
        }

        Assert.That(sum / size, Is.EqualTo(1.0).Within(0.15));
    }

    [Test]
    public void TheScene_MovesTheThoraxAlongThePath_MirroredInX_AsItsAxesAre()
    {
        Dictionary<string, double[]> path = Table(m_Free, "trajectory.csv");
        var file = new GlbFile(File.ReadAllBytes(Path.Combine(m_Free.Out, "flight.glb")));
        JsonElement animation = file.Root.GetProperty("animations")[0];
        double[] Of(string what, string side) =>
            file.Read(animation.GetProperty("samplers")[animation.GetProperty("channels").EnumerateArray()
            .First(channel => channel.GetProperty("target").GetProperty("path").GetString() == what).GetProperty("sampler").GetInt32()]
                .GetProperty(side).GetInt32());
        double[] places = Of("translation", "output"), turns = Of("rotation", "output"), times = Of("translation", "input");

        Assert.That(times, Is.EqualTo(path["time_s"]).Within(1e-4), "seconds");
        for (int k = 0; k < times.Length; k += 7)
        {
            double away = Math.Sqrt(Math.Pow(places[3 * k] + path["x_m"][k], 2.0) + Math.Pow(places[3 * k + 1] - path["y_m"][k], 2.0)
                + Math.Pow(places[3 * k + 2] - path["z_m"][k], 2.0));
            Assert.That(away, Is.LessThan(0.02), "the thorax is within centimetres of the centre of mass");
            (double x, double y, double z, double w) = (turns[4 * k], turns[4 * k + 1], turns[4 * k + 2], turns[4 * k + 3]);

            // Where glTF's rotation takes +Z, the nose.
            double aheadX = 2.0 * (x * z + w * y), aheadY = 2.0 * (y * z - w * x), aheadZ = 1.0 - 2.0 * (x * x + y * y);
            Assert.That(Math.Asin(aheadY) * 180.0 / Math.PI, Is.EqualTo(path["pitch_deg"][k]).Within(0.05));
            Assert.That(Math.Atan2(-aheadX, aheadZ) * 180.0 / Math.PI, Is.EqualTo(path["heading_deg"][k]).Within(0.05));
        }
    }

    [Test]
    public void OnTheSpot_TheMeanForces_AreThoseOfTheSummary()
    {
        Dictionary<string, double[]> forces = Table(m_Held, "forces.csv");
        JsonElement summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(m_Held.Out, "summary.json"))).RootElement;
        double[] Mean(string name) => summary.GetProperty(name).EnumerateArray().Select(number => number.GetDouble()).ToArray();
        double weight = 9.81 * InsectCatalogue.Find("monarch").Wings[0].CreatePreset().Size.insectMass;

        Assert.That(new[] { "x", "y", "z" }.Select(axis => forces[$"force_{axis}_n"].Average()),
            Is.EqualTo(Mean("mean_force_n")).Within(1e-4 * weight));
        Assert.That(new[] { "x", "y", "z" }.Select(axis => forces[$"moment_{axis}_nm"].Average()),
            Is.EqualTo(Mean("mean_moment_n_m")).Within(1e-6 * weight));
        Assert.That(forces["lift_n"].Average() / weight, Is.EqualTo(summary.GetProperty("lift_over_weight").GetDouble()).Within(1e-4));
        Assert.That(forces["lift_n"].Average(), Is.InRange(0.2 * weight, 3.0 * weight), "a body that is pitched up is lifted: newtons");
    }

    [Test]
    public void OnTheSpot_LiftIsAlongTheWorldsUp_AndDragAgainstTheWay()
    {
        Dictionary<string, double[]> forces = Table(m_Held, "forces.csv");

        // The body's nose is pitched up by 20 degrees; it flies 1.2 m/s ahead and 0.3 m/s up.
        double sine = Math.Sin(Math.PI / 9.0), cosine = Math.Cos(Math.PI / 9.0), speed = Math.Sqrt(1.2 * 1.2 + 0.3 * 0.3);
        for (int k = 0; k < forces["time_s"].Length; k++)
        {
            double up = cosine * forces["force_y_n"][k] + sine * forces["force_z_n"][k],
                ahead = cosine * forces["force_z_n"][k] - sine * forces["force_y_n"][k];
            double size = Math.Abs(up) + Math.Abs(ahead);
            Assert.That(forces["lift_n"][k], Is.EqualTo(up).Within(1e-4 * size));
            Assert.That(forces["drag_n"][k], Is.EqualTo(-(1.2 * ahead + 0.3 * up) / speed).Within(1e-4 * size));
        }
    }

    [Test]
    public void Joints_LieOnTheMeshesOfTheScene_InMetres()
    {
        // At phase 0 the meshes are in the shape of their file; both wings are in one place of the table at one time.
        string[][] rows = File.ReadAllLines(Path.Combine(m_Held.Out, "joints.csv")).Select(line => line.Split(',')).ToArray();
        var file = new GlbFile(File.ReadAllBytes(Path.Combine(m_Held.Out, "wings.glb")));
        double Cell(string[] row, string column) => double.Parse(row[Array.IndexOf(rows[0], column)], CultureInfo.InvariantCulture);
        double Phase(string[] row) => Math.Min(Cell(row, "phase_deg"), 360.0 - Cell(row, "phase_deg"));
        double nearest = rows.Skip(1).Min(Phase);
        foreach (string side in new[] { "right", "left" })
        {
            double[] mesh = file.Read(file.Primitive($"wing {side}").GetProperty("attributes").GetProperty("POSITION").GetInt32());
            foreach (string[] row in rows.Skip(1).Where(row => row[3] == side && Phase(row) <= nearest + 1e-6))
            {
                double least = double.MaxValue;
                for (int k = 0; k < mesh.Length; k += 3)
                {
                    least = Math.Min(least, Math.Pow(mesh[k] + Cell(row, "x_m"), 2.0) + Math.Pow(mesh[k + 1] - Cell(row, "y_m"), 2.0)
                        + Math.Pow(mesh[k + 2] - Cell(row, "z_m"), 2.0));
                }
                Assert.That(Math.Sqrt(least), Is.LessThan(0.005), $"{side}, chain {row[4]}, joint {row[5]}");
            }
        }
    }

    [Test]
    public void Bends_AreDegreesBetweenBones()
    {
        // The bend up and the one in the plane of a bone at the hinge of a joint make its angle to the bone before, for small bends by
        // Pythagoras; the rest shape has bends of its own.
        string[][] rows = File.ReadAllLines(Path.Combine(m_Held.Out, "joints.csv")).Skip(1).Select(line => line.Split(',')).ToArray();
        string[][] tip = rows.Where(row => row[3] == "right" && row[4] == "4").ToArray();
        double[][] places = tip
            .Select(row => row.Skip(6).Take(3).Select(text => double.Parse(text, CultureInfo.InvariantCulture)).ToArray()).ToArray();
        var angles = new List<double>();
        var bends = new List<double>();
        for (int k = 0; k < tip.Length; k++)
        {
            if (tip[k][5] != "2")
                continue;
            double[] before = places[k].Zip(places[k - 1], (a, b) => a - b).ToArray(),
                after = places[k + 1].Zip(places[k], (a, b) => a - b).ToArray();
            double dot = before.Zip(after, (a, b) => a * b).Sum() / Math.Sqrt(before.Sum(a => a * a) * after.Sum(a => a * a));
            angles.Add(Math.Acos(Math.Min(1.0, dot)) * 180.0 / Math.PI);
            bends.Add(double.Parse(tip[k][9], CultureInfo.InvariantCulture));
        }

        Assert.That(bends.Max() - bends.Min(), Is.InRange(0.5, 30.0), "degrees");
        Assert.That(angles.Max(), Is.EqualTo(bends.Max(Math.Abs)).Within(0.5 * angles.Max() + 0.5));
    }

    private static Dictionary<string, double[]> Table(CommandRun run, string name)
    {
        string[][] rows = File.ReadAllLines(Path.Combine(run.Out, name)).Select(line => line.Split(',')).ToArray();
        var table = new Dictionary<string, double[]>();
        for (int column = 0; column < rows[0].Length; column++)
        {
            table.Add(rows[0][column], rows
                .Skip(1)
                .Select(row =>
                    double.TryParse(row[column], NumberStyles.Float, CultureInfo.InvariantCulture, out double value) ? value : double.NaN)
                .ToArray());
        }
        return table;
    }
}
