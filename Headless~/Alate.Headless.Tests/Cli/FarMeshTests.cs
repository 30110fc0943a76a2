using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>A wing a thousand kilometres from the origin, as in a file of geographic coordinates, keeps its shape.</summary>
    public sealed class FarMeshTests
    {
        private static readonly (double X, double Y, double Z) s_Far = (1e6, -3e5, 2e6);

        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void MeshFarAway_IsCountedFromItsMiddle()
        {
            ObjMesh near = ObjReader.Read(new StringReader(OwnWing.Obj())), far = ObjReader.Read(new StringReader(OwnWing.Obj(s_Far)));

            Assert.That(near.Origin, Is.EqualTo((0.0, 0.0, 0.0)));
            for (int k = 0; k < near.Positions.Length; k++)
            {
                Assert.That(far.Positions[k].x + far.Origin.X - s_Far.X, Is.EqualTo(near.Positions[k].x).Within(1e-6));
                Assert.That(far.Positions[k].y + far.Origin.Y - s_Far.Y, Is.EqualTo(near.Positions[k].y).Within(1e-6));
                Assert.That(far.Positions[k].z + far.Origin.Z - s_Far.Z, Is.EqualTo(near.Positions[k].z).Within(1e-6));
            }
        }

        [Test]
        public void MeshNearTheOrigin_KeepsItsNumbersToTheLastBit()
        {
            ObjMesh mesh = ObjReader.Read(new StringReader("v 40.1 0 0\nv 41.1 0 0\nv 40.1 0 1\nf 1 2 3\n"));

            Assert.That(mesh.Origin, Is.EqualTo((0.0, 0.0, 0.0)));
            Assert.That(mesh.Positions[0], Is.EqualTo(new Vector3(40.1f, 0f, 0f)));
        }

        [Test]
        public void SkeletonOfAMeshFarAway_LiesInTheMeshsSpace_AsThatOfANearOneDoes()
        {
            double[] near = Fit((0, 0, 0), "0,0,0"), far = Fit(s_Far, "1000000,-300000,2000000");

            for (int k = 0; k < near.Length; k++)
                Assert.That(far[k] - Along(k), Is.EqualTo(near[k]).Within(2e-6));
        }

        [Test]
        public void HingeOfAMeshFarAway_IsNotTakenFromItsMiddle()
        {
            Fit(s_Far, null);

            Assert.That(m_Run.Output, Does.Contain("the mesh's origin does not tell"));
        }

        [Test]
        public void WingFarAway_FliesAsANearOne()
        {
            double[] near = Fly((0, 0, 0)), far = Fly(s_Far);

            Assert.That(far, Is.EqualTo(near).Within(1e-6));
        }

        private static double Along(int k) => (k % 3) switch { 0 => s_Far.X, 1 => s_Far.Y, _ => s_Far.Z };

        private double[] Fit((double, double, double) at, string hinge)
        {
            Renew();
            string mesh = m_Run.Write("wing.obj", OwnWing.Obj(at));
            string[] hint = hinge == null ? [] : ["--hinge", hinge];
            int code = m_Run.Run(["skeleton", "fit", mesh, "--out", m_Run.Out, .. hint]);
            Assert.That(code, Is.Zero, m_Run.Errors);
            using var json = JsonDocument.Parse(File.ReadAllText(Path.Combine(m_Run.Out, "skeleton.json")));
            return json.RootElement.GetProperty("hinge").EnumerateArray()
                .Concat(json.RootElement.GetProperty("chains").EnumerateArray().SelectMany(chain => chain.EnumerateArray())
                    .SelectMany(joint => joint.EnumerateArray()))
                .Select(number => number.GetDouble()).ToArray();
        }

        private double[] Fly((double X, double Y, double Z) at)
        {
            Fit(at, FormattableString.Invariant($"{at.X},{at.Y},{at.Z}"));
            string flight = Path.Combine(m_Run.Folder, "flight");
            int code = m_Run.Run(
                "fly", "--mesh", Path.Combine(m_Run.Folder, "wing.obj"), "--skeleton", Path.Combine(m_Run.Out, "skeleton.json"),
                "--species", "monarch",
                "--no-pictures", "--seconds", "0.3", "--out", flight);
            Assert.That(code, Is.Zero, m_Run.Errors);
            return File.ReadAllLines(Path.Combine(flight, "joints.csv")).Skip(1)
                .SelectMany(line => line.Split(',').Skip(6).Take(3))
                .Select(number => double.Parse(number, CultureInfo.InvariantCulture)).ToArray();
        }

        private void Renew()
        {
            m_Run.Dispose();
            m_Run = new CommandRun();
        }
    }
}
