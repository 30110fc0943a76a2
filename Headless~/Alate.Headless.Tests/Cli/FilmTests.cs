using System.IO;
using System.Linq;
using NUnit.Framework;
using Unity.StandIns;

namespace Alate.Tests.Cli
{
    /// <summary>The command <c>film</c>.</summary>
    public sealed class FilmTests
    {
        [Test, Explicit, Category("Long")]
        public void FilmsOfEveryKind_HaveNumberedFrames([Values("--compare", "--free")] string kind) =>
            Film_HasNumberedFrames_OfOneSize_ThatAllDiffer(kind);

        [TestCase("--variant", "expressive", "--turn", "90")]
        public void Film_HasNumberedFrames_OfOneSize_ThatAllDiffer(params string[] options)
        {
            using var run = new CommandRun();
            Assert.That(run.Run(["film", "fishfly", "--frames", "4", "--beats", "1", "--width", "160", "--out", run.Out, .. options]),
                Is.Zero, run.Errors);

            string[] files = Directory.GetFiles(Path.Combine(run.Out, "frames")).Order().ToArray();
            PngFile[] frames = files.Select(file => PngFile.Read(File.ReadAllBytes(file))).ToArray();
            Assert.That(files.Select(Path.GetFileName), Is.EqualTo(new[] { "0001.png", "0002.png", "0003.png", "0004.png" }));
            Assert.That(frames.Select(frame => frame.Width), Is.All.EqualTo(160));
            Assert.That(frames.Select(frame => frame.Height).Distinct().Count(), Is.EqualTo(1));
            for (int k = 0; k < 4; k++)
                Assert.That(frames[k].Pixels.SequenceEqual(frames[(k + 1) % 4].Pixels), Is.False);
            var film = new ApngPlayer(File.ReadAllBytes(Path.Combine(run.Out, "film.png")));
            Assert.That((film.Width, film.Height, film.Frames.Count), Is.EqualTo((160, frames[0].Height, 4)));
            for (int k = 0; k < 4; k++)
            {
                // Each file has a palette of its own.
                double off = film.Frames[k].Zip(frames[k].Pixels, (a, b) =>
                    (double)System.Math.Abs(a.r - b.r) + System.Math.Abs(a.g - b.g) + System.Math.Abs(a.b - b.b)).Average();
                Assert.That(off, Is.LessThan(3.0), $"frame {k}: shades of all channels");
            }
        }

        [Test]
        public void FreeFilm_TakesNoOtherNumbers()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("film", "monarch", "--free", "--compare", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("--free flies"));
        }
    }
}
