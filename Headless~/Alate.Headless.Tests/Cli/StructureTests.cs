using System;
using System.IO;
using System.Numerics;
using System.Text.Json;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Structure of the wing beside beams, and measured stiffness on the command line.</summary>
    public sealed class StructureTests
    {
        [Test]
        public void SlowBeams_BendByTheirInertiaAlone()
        {
            // Under an even load w/8, under one that grows from the root 11/120.
            double rate = 0.01 * BeamTheory.First;
            Assert.That(BeamTheory.Droop(0.01), Is.EqualTo(0.01 / 8).Within(0.01).Percent);
            Assert.That(BeamTheory.Shaken(0.01, 0).Magnitude / (rate * rate), Is.EqualTo(1.0 / 8).Within(0.1).Percent);
            Assert.That(BeamTheory.Turned(0.01, 0).Magnitude / (rate * rate), Is.EqualTo(11.0 / 120).Within(0.1).Percent);
        }

        [Test]
        public void Beams_HaveTheirResonance_AtAQuarterTurn()
        {
            Assert.That(BeamTheory.Shaken(1, 1e-3).Phase, Is.EqualTo(-Math.PI / 2).Within(0.01));
            Assert.That(BeamTheory.Turned(1, 1e-3).Phase, Is.EqualTo(-Math.PI / 2).Within(0.01));
        }

        [TestCase(4, 0.4, 1.0)]
        [TestCase(8, 4, 1.0)]
        public void AStrip_DroopsAsTheBeam(int bones, double weight, double percent) =>
            Assert.That(new StripRun(bones, 24).Droop(weight), Is.EqualTo(BeamTheory.Droop(weight)).Within(percent).Percent);

        [Test]
        public void AStrip_SwaysAsTheBeam_OverItsLastBeat()
        {
            Complex ours = new StripRun(4, 48).Shaken(0.5), beam = BeamTheory.Shaken(0.5, StripRun.Damping);

            Assert.That(ours.Magnitude, Is.EqualTo(beam.Magnitude).Within(5).Percent);
        }

        [Test]
        public void AStrip_FlapsAsTheBeam()
        {
            Complex ours = new StripRun(4, 96).Flapped(0.5), beam = BeamTheory.Turned(0.5, StripRun.Damping);

            Assert.That(ours.Magnitude, Is.EqualTo(beam.Magnitude).Within(5).Percent);
            Assert.That(ours.Phase, Is.EqualTo(beam.Phase).Within(0.02), "1°");
        }

        [TestCase("[[-1e-6], [], [], [], []]", "flexuralStiffness",
            "Chain 0 has a flexural stiffness of -1E-06 N·m² (value 0); it must be between 1E-15 and 1000.")]
        [TestCase("[[1e-6], [], [], [], []]", "torsionalStiffness",
            "Chain 0 has a torsional stiffness but no flexural stiffness; give both, or the flexural one alone.")]
        [TestCase("[[1e-6]]", "flexuralStiffness", "\"flexuralStiffness\" has 1 lists for 5 chains.")]
        [TestCase("[[NaN], [], [], [], []]", "flexuralStiffness", "expected a number, found 'NaN'.")]
        public void ABadStiffness_IsOneLine(string values, string key, string message)
        {
            using var run = new CommandRun();

            Assert.That(Fly(run, key, values), Is.EqualTo(2));
            Assert.That(run.Errors.Trim(), Does.Contain(message).And.Not.Contain("\n"));
        }

        [Test]
        public void AMeasuredStiffness_IsFlown()
        {
            using var run = new CommandRun();

            Assert.That(Fly(run, "flexuralStiffness", "[[3e-5], [], [], [], []]"), Is.Zero, run.Errors);
            JsonElement summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json"))).RootElement;
            Assert.That(summary.GetProperty("leading_ei_n_m2").GetDouble(), Is.EqualTo(3e-5).Within(1).Percent);
            Assert.That(summary.GetProperty("usual_ei_n_m2").GetDouble(), Is.EqualTo(3.0e-4).Within(2).Percent, "a span of 61 mm");
            Assert.That(run.Output, Does.Contain("stiffness EI of the leading chain, N m²").And.Contain("3.0e-5"));
        }

        private static int Fly(CommandRun run, string key, string values)
        {
            string text = OwnWing.Skeleton(WingSide.Right).TrimEnd();
            string mesh = run.Write("wing.obj", OwnWing.Obj(side: WingSide.Right));
            string skeleton = run.Write("wing.json", $"{text.Substring(0, text.Length - 1)}, \"{key}\": {values} }}");
            return run.Run("fly", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--no-pictures", "--seconds", "0.1",
                "--out", run.Out);
        }
    }
}
