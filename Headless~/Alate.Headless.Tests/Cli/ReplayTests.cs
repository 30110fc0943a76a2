using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Recordings of the command line: the same bytes come out again, and what is no recording is refused.</summary>
    public sealed class ReplayTests
    {
        private static readonly string[] s_Flight =
        [
            "--free", "--pilot", "wander", "--seed", "5", "--gust", "0.5,-2,0", "--aid", "0.3", "--seconds", "0.7", "--step", "0.013",
            "--no-pictures",
        ];

        private CommandRun m_Run;
        private string m_File, m_Trajectory;

        [OneTimeSetUp]
        public void Record()
        {
            m_Run = new CommandRun();
            m_File = Path.Combine(m_Run.Folder, "flight.txt");
            Assert.That(Fly(["monarch", .. s_Flight, "--record", m_File], "recorded"), Is.Zero, m_Run.Errors);
            m_Trajectory = Trajectory("recorded");
        }

        [OneTimeTearDown]
        public void Remove() => m_Run.Dispose();

        [Test]
        public void AReplay_WritesTheSameBytes()
        {
            Assert.That(Fly(["--free", "--replay", m_File, "--no-pictures"], "again"), Is.Zero, m_Run.Errors);
            foreach (string file in new[] { "trajectory.csv", "forces.csv" })
            {
                byte[] again = File.ReadAllBytes(Path.Combine(m_Run.Folder, "again", file));
                byte[] recorded = File.ReadAllBytes(Path.Combine(m_Run.Folder, "recorded", file));
                Assert.That(again.SequenceEqual(recorded), Is.True, file);
            }

            Assert.That(Path.Combine(m_Run.Folder, "again", "path.png"), Does.Not.Exist, "--no-pictures");
            Assert.That(m_Run.Output, Does.Contain("flight.glb").And.Not.Contain("path.png"));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void AReplayInAnotherProcess_WritesTheSameBytes()
        {
            var start = new ProcessStartInfo(Environment.ProcessPath.Contains("dotnet") ? Environment.ProcessPath : "dotnet")
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
            };
            string[] words = [Cli, "fly", "--free", "--replay", m_File, "--no-pictures", "--out", Path.Combine(m_Run.Folder, "process")];
            foreach (string word in words)
                start.ArgumentList.Add(word);
            using var process = Process.Start(start);
            string errors = process.StandardError.ReadToEndAsync().Result + process.StandardOutput.ReadToEnd();
            process.WaitForExit();

            Assert.That(process.ExitCode, Is.Zero, errors);
            Assert.That(Trajectory("process"), Is.EqualTo(m_Trajectory));
        }

        [Test]
        public void TheRecording_SaysWhoFlewAndHow()
        {
            string[] lines = File.ReadAllLines(m_File);
            Assert.That(lines[0], Is.EqualTo("alate flight 1"));
            Assert.That(lines, Has.Member("insect monarch"));
            Assert.That(lines, Has.Member("options --pilot wander --seed 5 --gust 0.5,-2,0 --aid 0.3 --step 0.013"));
            Assert.That(lines.Last(), Is.EqualTo($"end {m_Trajectory.Split('\n', StringSplitOptions.RemoveEmptyEntries).Length - 1}"));
        }

        [TestCase("alate flight 1", "alate flight 7", "another version")]
        [TestCase("insect monarch", "insect wasp", "The insect 'wasp' is not known here.")]
        [TestCase("insect monarch", "insect firefly", "with numbers of another version")]
        [TestCase("\nend ", "\nfly 1\nend ", "there are")]
        [TestCase("\ngo ", "\ngo to ", "are not")]
        public void AWrongRecording_IsRefusedInOneLine_AndNothingIsWritten(string right, string wrong, string said)
        {
            using var run = new CommandRun();
            string file = run.Write("wrong.txt", File.ReadAllText(m_File).Replace(right, wrong));
            AssertRefused(run, said, "--free", "--replay", file);
        }

        [Test]
        public void ACutRecording_IsRefused()
        {
            using var run = new CommandRun();
            string text = File.ReadAllText(m_File);
            AssertRefused(run, "cut off", "--free", "--replay", run.Write("cut.txt", text[..(text.Length / 2)]));
        }

        [TestCase("--replay needs --free", "monarch", "--replay", "x")]
        [TestCase("--record needs --free", "monarch", "--record", "x")]
        [TestCase("--replay takes no --gust", "--free", "--replay", "x", "--gust", "0,0,1")]
        [TestCase("--replay takes no --record", "--free", "--replay", "x", "--record", "y")]
        [TestCase("--replay takes no --seconds", "--free", "--replay", "x", "--seconds", "3")]
        [TestCase("there is no such file", "--free", "--replay", "x")]
        public void OptionsThatDoNotGoTogether_AreNamed(string said, params string[] words)
        {
            using var run = new CommandRun();
            AssertRefused(run, said, words);
        }

        [Test]
        public void AnotherSpecies_IsRefused()
        {
            using var run = new CommandRun();
            AssertRefused(run, "was flown by the monarch", "moth", "--free", "--replay", m_File);
        }

        // A scene may place wings otherwise: each stands for the nearest of its side.
        [Test]
        public void ARecordingOfAScene_IsFlownWithItsWings()
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch");
            using FlightModel own = CatalogueFlight.CreateModel(monarch);
            var recording = new FlightRecording();
            foreach (FlightWing wing in own.Wings)
            {
                recording.Wings.Add(
                    new RecordedPlace { hinge = wing.Hinge + new float3(0.0001f, 0.0002f, 0.0003f), axes = wing.Axes });
            }

            using (FlightModel model = new Replay(monarch, recording).CreateModel())
            {
                Assert.That(model.Wings.Count, Is.EqualTo(own.Wings.Count));
                for (int k = 0; k < own.Wings.Count; k++)
                {
                    Assert.That(math.distance(model.Wings[k].Hinge, recording.Wings[k].hinge), Is.Zero);
                    Assert.That(model.Wings[k].IsLeft, Is.EqualTo(own.Wings[k].IsLeft));
                }

                Assert.That((model.Mass, model.FluidDensity, model.GravityShare),
                    Is.EqualTo((own.Mass, own.FluidDensity, own.GravityShare)));
            }

            using (FlightModel plain = new Replay(monarch, new FlightRecording()).CreateModel())
                Assert.That(math.distance(plain.Wings[0].Hinge, own.Wings[0].Hinge), Is.Zero, "those of the catalogue");
            recording.Wings.RemoveAt(0);
            Assert.That(() => new Replay(monarch, recording).CreateModel(), Throws.TypeOf<UserException>().With.Message
                .EqualTo("The recording has 1 wings, which are not those of the Monarch."));
        }

        private static string Cli => Path.Combine(AppContext.BaseDirectory, "Alate.Cli.dll");

        private static void AssertRefused(CommandRun run, string said, params string[] words)
        {
            int code = run.Run(["fly", .. words, "--out", run.Out]);
            Assert.That((code, run.Errors.TrimEnd().Split('\n').Length), Is.EqualTo((2, 1)), run.Errors);
            Assert.That(run.Errors, Does.Contain(said));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        private int Fly(IEnumerable<string> words, string folder) =>
            m_Run.Run(["fly", .. words, "--out", Path.Combine(m_Run.Folder, folder)]);

        private string Trajectory(string folder) => File.ReadAllText(Path.Combine(m_Run.Folder, folder, "trajectory.csv"));
    }
}
