using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>A word that is no command is named, with the commands there are.</summary>
    public sealed class UnknownCommandTests
    {
        [TestCase("glide")]
        [TestCase("glide", "--help")]
        [TestCase("glide", "monarch", "--speed", "1")]
        public void UnknownCommand_IsNamed_WithThoseThereAre(params string[] arguments) =>
            AssertRefused("Unknown command 'glide'. Commands: fly, ", arguments);

        [TestCase("flu", "fly")]
        [TestCase("specie", "species")]
        [TestCase("Galery", "gallery")]
        [TestCase("fit", "skeleton fit")]
        [TestCase("from-imag", "skeleton from-image")]
        public void MistypedCommand_IsNamed_WithTheNearest(string word, string nearest) =>
            AssertRefused($"Unknown command '{word}'. Did you mean '{nearest}'? Commands: fly, ", word, "monarch");

        [Test]
        public void UnknownCommandOfACommand_IsNamed_WithThoseThereAre() =>
            AssertRefused("Unknown command 'glide'. Commands: fit, from-image.", "skeleton", "glide", "wing.obj");

        [Test]
        public void CommandWithoutItsCommand_ListsThoseThereAre() =>
            AssertRefused("'skeleton' needs a command. Commands: fit, from-image.", "skeleton");

        [Test]
        public void UnknownOptionWithoutACommand_IsNamed() => AssertRefused("Unknown option '--speed'. Commands: fly, ", "--speed", "3");

        private static void AssertRefused(string said, params string[] arguments)
        {
            using var run = new CommandRun();

            int code = run.Run(arguments);

            Assert.That(code, Is.EqualTo(2));
            Assert.That(run.Errors, Does.StartWith("alate: " + said));
            Assert.That(run.Errors.Split('\n'), Has.Length.EqualTo(2), "one line: " + run.Errors);
            Assert.That(run.Output, Is.Empty);
        }
    }
}
