using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Alate.Cli;
using Alate.Formats;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    public sealed class JointTableTests
    {
        private const int k_Wings = 2, k_Joints = 25, k_Substeps = 16;

        private string m_Text;
        private string[] m_Columns;
        private List<string[]> m_Rows;

        [OneTimeSetUp]
        public void Write()
        {
            m_Text = Written();
            string[] lines = m_Text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
            m_Columns = lines[0].Split(',');
            m_Rows = lines.Skip(1).Select(line => line.Split(',')).ToList();
        }

        [Test]
        public void TheHeader_NamesEveryColumnWithItsUnit()
        {
            Assert.That(m_Columns, Is.SupersetOf(new[] { "time_s", "phase_deg", "wing", "side", "chain", "joint", "x_m", "y_m", "z_m" }));
            Assert.That(m_Columns, Is.Unique);
            Assert.That(m_Rows.Select(row => row.Length), Is.All.EqualTo(m_Columns.Length));
        }

        [Test]
        public void EveryJointOfBothWings_HasOneRowASubstep()
        {
            Assert.That(m_Rows, Has.Count.EqualTo(k_Wings * k_Joints * k_Substeps));
            Assert.That(m_Rows.Select(row => (Key(row), Field(row, "side"))), Is.Unique);
        }

        [Test]
        public void TheRows_RunOverOneBeat()
        {
            double[] times = m_Rows.Select(row => Number(row, "time_s")).Distinct().OrderBy(time => time).ToArray();
            double[] phases = m_Rows.Select(row => Number(row, "phase_deg")).Distinct().ToArray();
            double step = 1.0 / (k_Substeps * (double)MonarchFlight.Level.Wings[0].Frequency);

            Assert.That(times.Zip(times.Skip(1), (one, next) => next - one), Is.All.EqualTo(step).Within(2e-6));
            Assert.That(phases, Is.All.InRange(0.0, 360.0));
            Assert.That(phases.Select(phase => (int)Math.Round(phase / 22.5) % k_Substeps).Distinct().Count(), Is.EqualTo(k_Substeps));
        }

        [Test]
        public void Joints_AreInMetresFromTheMiddleOfTheBody()
        {
            double[] reach = m_Rows.Select(row => math.length(Place(row))).Select(length => (double)length).ToArray();

            Assert.That(reach.Max(), Is.InRange(0.055, 0.075), "a monarch's wing is 61 mm long");
            IEnumerable<string[]> roots = m_Rows.Where(row => Field(row, "joint") == "0");
            Assert.That(roots.Select(row => math.length(Place(row))), Is.All.LessThan(0.006f), "roots stay at the thorax");
        }

        [Test]
        public void InLevelFlight_TheLeftWingMirrorsTheRight()
        {
            var right = m_Rows.Where(row => Field(row, "side") == "right").ToDictionary(Key, Place);
            foreach (string[] row in m_Rows.Where(row => Field(row, "side") == "left"))
                Assert.That(math.distance(Place(row), right[Key(row)] * new float3(-1f, 1f, 1f)), Is.LessThan(2e-7f));
        }

        [Test]
        public void TheNumbers_AreThoseOfTheFlight()
        {
            RecordedWing wing = MonarchFlight.Level.Wings[1];
            RecordedFrame frame = wing.Frames[7];
            string[] row = m_Rows.Single(candidate =>
                (Field(candidate, "side"), Field(candidate, "chain"), Field(candidate, "joint")) == ("left", "3", "2")
                && Math.Abs(Number(candidate, "time_s") - frame.Time) < 1e-6);

            Assert.That(math.distance(Place(row), wing.Placement.ToBody(frame.Joints[3 * 5 + 2])), Is.LessThan(1e-7f));
        }

        [Test]
        public void TheTextIsTheSame_WhateverTheCulture()
        {
            using (new CommaCulture())
                Assert.That(Written(), Is.EqualTo(m_Text));
        }

        private float3 Place(string[] row) => new float3((float)Number(row, "x_m"), (float)Number(row, "y_m"), (float)Number(row, "z_m"));

        private string Key(string[] row) => $"{Field(row, "time_s")} {Field(row, "chain")} {Field(row, "joint")}";

        private double Number(string[] row, string column) =>
            double.Parse(Field(row, column), NumberStyles.Float, CultureInfo.InvariantCulture);

        private string Field(string[] row, string column) => row[Array.IndexOf(m_Columns, column)];

        private static string Written()
        {
            using var stream = new MemoryStream();
            CsvTable.Write(stream, JointTable.Of(MonarchFlight.Level));
            return Encoding.UTF8.GetString(stream.ToArray());
        }
    }
}
