using System.IO;
using System.Linq;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>Answers of <c>bake</c> to input that it cannot take: one line, exit code 2, nothing written.</summary>
    public sealed class BakeCommandTests
    {
        [TestCase("monarch --clips cruise,dive",
            "There is no clip 'dive'. Known: cruise, hover, climb, turn-left, turn-right, glide, rest, folded, bask, land, take-off.")]
        [TestCase("monarch --clips cruise,Cruise", "Clip 'cruise' is asked for twice.")]
        [TestCase("monarch --clips ,",
            "No clip is asked for. Known: cruise, hover, climb, turn-left, turn-right, glide, rest, folded, bask, land, take-off.")]
        [TestCase("monarch --format fbx", "--format takes openvat, gltf-skin, gltf-morph or usd, not 'fbx'.")]
        [TestCase("dodo", "Unknown species 'dodo'.")]
        [TestCase("monarch --variant biological", "There is no biological monarch.")]
        [TestCase("monarch --frames 3", "--frames must lie between 4 and 240; it is 3.")]
        [TestCase("monarch --fps 24", "--fps goes with --beats-per-second, so that a loop ends on a whole frame.")]
        [TestCase("monarch --fps 24 --beats-per-second 2 --frames 12", "--fps says how many frames a loop has: leave --frames away.")]
        [TestCase(
            "monarch --fps 24 --beats-per-second 5",
            "24 frames a second at 5 beats make 4.8 frames a beat; a loop has whole ones, 4 to 240: 5 at --beats-per-second 4.8.")]
        [TestCase(
            "monarch --fps 24 --beats-per-second 10",
            "24 frames a second at 10 beats make 2.4 frames a beat; a loop has whole ones, 4 to 240: 4 at --beats-per-second 6.")]
        [TestCase(
            "monarch --frames 8 --max-size 128",
            "5618 vertices at 9 frames need a texture of 128 x 396 pixels; at most 128 x 128 are allowed: bake fewer frames or clips at "
            + "once, or allow a larger texture.")]
        public void BadInput_IsOneLine_AndNothingIsWritten(string arguments, string message)
        {
            using var run = new CommandRun();

            Assert.That(run.Run([.. $"bake {arguments}".Split(' '), "--out", run.Out]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain(message));
            Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void AFolderThatCannotBeWritten_IsOneLine()
        {
            using var run = new CommandRun();
            string file = run.Write("taken", "");

            Assert.That(run.Run("bake", "monarch", "--out", Path.Combine(file, "below")), Is.EqualTo(2));
            Assert.That(run.Errors, Does.StartWith("alate: Cannot write into"));
            Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
        }

        [TestCase(WingSide.Right)]
        [TestCase(WingSide.Left, Explicit = true, Category = "Long")]
        public void AWingOfTheUsersOwn_IsBakedWithItsMirrorImage(WingSide side)
        {
            using var run = new CommandRun();
            string mesh = run.Write("wing.obj", OwnWing.Obj(side: side)), skeleton = run.Write("wing.json", OwnWing.Skeleton(side));

            Assert.That(run.Run("bake", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--frames", "6", "--out", run.Out),
                Is.Zero, run.Errors);
            var vat = new VatReader(Path.Combine(run.Out, "wing_vat"), "wing");
            float3[] shown = vat.At(5).Positions;
            Assert.That(shown, Has.Length.EqualTo(vat.VertexCount));
            for (int vertex = 0; vertex < shown.Length / 2; vertex++)
            {
                Assert.That(
                    math.distance(shown[vertex] * new float3(-1f, 1f, 1f), shown[vertex + shown.Length / 2]), Is.LessThan(1e-5f), "metres");
            }
            Assert.That(shown.Max(place => math.abs(place.x)), Is.InRange(0.02f, 0.08f), "a monarch's wings, metres");
        }

        [Test]
        public void AMeshOfTooManyVertices_IsOneLine()
        {
            using var run = new CommandRun();
            string small = OwnWing.Obj();
            int first = small.Split('\n').Count(line => line.StartsWith("v "));
            string many = string.Concat(Enumerable.Range(0, 11000).Select(k =>
                $"v {k}e-5 0 -0.1\nv {k}e-5 0 -0.2\nv {k + 1}e-5 0 -0.1\nf {first + 3 * k + 1} {first + 3 * k + 2} {first + 3 * k + 3}\n"));
            string mesh = run.Write("wing.obj", small + many), skeleton = run.Write("wing.json", OwnWing.Skeleton());

            Assert.That(run.Run("bake", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("at most 65535 can be baked: use a smaller mesh."));
            Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
        }

        [TestCase("--mesh wing.obj", "A wing of your own needs both --mesh and --skeleton.")]
        [TestCase("monarch --species firefly", "--species goes with --mesh and --skeleton")]
        [TestCase("monarch --mesh a.obj --skeleton a.json", "With --mesh the species is named by --species")]
        [TestCase("--mesh a.obj --skeleton a.json", "--mesh needs --species.")]
        public void OptionsThatNeedOrExcludeEachOther_AreNamed(string arguments, string message)
        {
            using var run = new CommandRun();

            Assert.That(run.Run([.. $"bake {arguments}".Split(' '), "--out", run.Out]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain(message));
        }

        [Test]
        public void TheErrorsOfEachClip_AreShown()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("bake", "fishfly", "--clips", "cruise,rest", "--frames", "4", "--out", run.Out), Is.Zero, run.Errors);
            Assert.That(run.Output, Does.Contain("between frames").And.Contain("linear skin"));
            Assert.That(run.Output.Split('\n').Count(line => line.Contains("cruise") || line.Contains("rest")), Is.GreaterThanOrEqualTo(2));
        }
    }
}
