using System.IO;
using System.Linq;
using Alate.Tests.Cli;
using NUnit.Framework;

namespace Alate.Tests.Bakes
{
    /// <summary>What <c>bake</c> says of input that it cannot take: one line, exit code 2, nothing written.</summary>
    public sealed class BakeCommandTests
    {
        [TestCase("monarch --clips cruise,dive", "There is no clip 'dive'. Known: cruise, hover, climb, turn-left, turn-right, glide, rest.")]
        [TestCase("monarch --clips cruise,Cruise", "Clip 'cruise' is asked for twice.")]
        [TestCase("monarch --clips ,", "No clip is asked for. Known: cruise, hover, climb, turn-left, turn-right, glide, rest.")]
        [TestCase("monarch --format fbx", "--format takes openvat, gltf-skin or gltf-morph, not 'fbx'.")]
        [TestCase("dodo", "Unknown species 'dodo'.")]
        [TestCase("monarch --variant biological", "There is no biological monarch.")]
        [TestCase("monarch --frames 3", "--frames must lie between 4 and 240; it is 3.")]
        [TestCase(
            "monarch --frames 8 --max-size 128",
            "5624 vertices at 9 frames need a texture of 128 x 396 pixels; at most 128 x 128 are allowed: bake fewer frames or clips at once, or allow a larger texture.")]
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

        [Test]
        public void TheErrorsOfEachClip_AreShown()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("bake", "monarch", "--clips", "cruise,rest", "--frames", "12", "--out", run.Out), Is.Zero, run.Errors);
            Assert.That(run.Output, Does.Contain("between frames").And.Contain("linear skin"));
            Assert.That(run.Output.Split('\n').Count(line => line.Contains("cruise") || line.Contains("rest")), Is.GreaterThanOrEqualTo(2));
        }
    }
}
