using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Wings that users bring.</summary>
    public sealed class OwnWingTests
    {
        [Test]
        public void WingFromFiles_FliesLikeAnyOther()
        {
            using var run = new CommandRun();

            JsonElement summary = Fly(run, WingSide.Right);

            Assert.That(summary.GetProperty("species").GetString(), Is.EqualTo("wing"));
            Assert.That(summary.GetProperty("twist_pp_deg").GetDouble(), Is.InRange(5, 90));
            Assert.That(summary.GetProperty("resets").GetInt32(), Is.Zero);
            AssertReadable(run);
        }

        [Test]
        public void LeftWing_FliesAsItsMirrorImageDoes()
        {
            using var right = new CommandRun();
            using var left = new CommandRun();

            Fly(right, WingSide.Right);
            Fly(left, WingSide.Left);

            double[] one = Places(right), other = Places(left);
            Assert.That(other, Is.EqualTo(one).Within(1e-6), "a left wing's mesh makes the same insect");
            AssertReadable(left);
        }

        private static void AssertReadable(CommandRun run)
        {
            var file = new GlbFile(File.ReadAllBytes(Path.Combine(run.Out, "wings.glb")));
            for (int k = 0; k < file.AccessorCount; k++)
                Assert.That(file.Read(k), Is.All.InRange(-1e6, 1e6));
        }

        private static double[] Places(CommandRun run) => File.ReadAllLines(Path.Combine(run.Out, "joints.csv")).Skip(1)
            .SelectMany(line => line.Split(',').Skip(6).Take(3))
            .Select(number => double.Parse(number, CultureInfo.InvariantCulture)).ToArray();

        private static JsonElement Fly(CommandRun run, WingSide side)
        {
            string mesh = run.Write("wing.obj", OwnWing.Obj(side: side)), skeleton = run.Write("wing.json", OwnWing.Skeleton(side));
            int code = run.Run("fly", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--no-pictures", "--seconds", "0.3",
                "--out", run.Out);
            Assert.That(code, Is.Zero, run.Errors);
            return JsonDocument.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json"))).RootElement;
        }
    }
}
