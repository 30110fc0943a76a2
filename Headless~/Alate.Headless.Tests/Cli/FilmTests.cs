using System;
using System.IO;
using System.Linq;
using System.Text;
using Alate.Catalogue;
using Alate.Cli;
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
                    (double)Math.Abs(a.r - b.r) + System.Math.Abs(a.g - b.g) + System.Math.Abs(a.b - b.b)).Average();
                Assert.That(off, Is.LessThan(3.0), $"frame {k}: shades of all channels");
            }
        }

        // Its frames are those on paper, once the paper is laid behind them.
        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void ATransparentFilm_OnPaper_IsTheFilmOnPaper()
        {
            PngFile[] Frames(params string[] options)
            {
                using var run = new CommandRun();
                Assert.That(run.Run(["film", "monarch", "--frames", "4", "--beats", "1", "--width", "161", "--out", run.Out, .. options]),
                    Is.Zero, run.Errors);
                Assert.That(PngFile.Read(File.ReadAllBytes(Path.Combine(run.Out, "film.png"))).Pixels.Any(pixel => pixel.a < 255),
                    Is.EqualTo(options.Length > 0));
                return [.. Directory.GetFiles(Path.Combine(run.Out, "frames")).Order()
                    .Select(file => PngFile.Read(File.ReadAllBytes(file)))];
            }

            PngFile[] paper = Frames(), cut = Frames("--transparent");
            double[] ground = [0xf7, 0xf4, 0xec];
            for (int k = 0; k < 4; k++)
            {
                Assert.That((cut[k].Width, cut[k].Height), Is.EqualTo((paper[k].Width, paper[k].Height)));
                double most = 0;
                for (int pixel = 0; pixel < paper[k].Pixels.Length; pixel++)
                {
                    UnityEngine.Color32 over = cut[k].Pixels[pixel], seen = paper[k].Pixels[pixel];
                    double share = over.a / 255.0;
                    most = Math.Max(most, Math.Abs(share * over.r + (1 - share) * ground[0] - seen.r));
                    most = Math.Max(most, Math.Abs(share * over.b + (1 - share) * ground[2] - seen.b));
                }

                Assert.That(most, Is.LessThan(12), $"frame {k}, of 255");
                Assert.That(cut[k].Pixels[0].a, Is.Zero);
            }
        }

        // What is solid is as it is with nothing behind it; the wall is dimmest in the corners, and darker where the shadow falls.
        [Test]
        public void AFilmBeforeAWall_IsTheInsect_TheWallAndAShadow()
        {
            PngFile Frame(params string[] options)
            {
                using var run = new CommandRun();
                Assert.That(run.Run(["film", "firefly", "--frames", "4", "--beats", "1", "--width", "160", "--out", run.Out, .. options]),
                    Is.Zero, run.Errors);
                return PngFile.Read(File.ReadAllBytes(Path.Combine(run.Out, "frames", "0002.png")));
            }

            PngFile cut = Frame("--transparent"), studio = Frame("--backdrop", "studio");
            Assert.That((studio.Width, studio.Height), Is.EqualTo((cut.Width, cut.Height)));
            Assert.That(studio.Pixels.All(pixel => pixel.a == 255), Is.True);
            int solid = 0, shaded = 0;
            for (int k = 0; k < cut.Pixels.Length; k++)
            {
                (UnityEngine.Color32 alone, UnityEngine.Color32 seen) = (cut.Pixels[k], studio.Pixels[k]);
                if (alone.a == 255)
                {
                    solid++;
                    Assert.That(Math.Max(Math.Abs(alone.r - seen.r), Math.Abs(alone.b - seen.b)), Is.LessThanOrEqualTo(1));
                }

                shaded += alone.a == 0 && seen.r < 0xb0 ? 1 : 0;
            }

            Assert.That(solid, Is.GreaterThan(200));
            Assert.That(shaded, Is.GreaterThan(100), "darker than any corner");
            Assert.That(studio.Pixels[0].b, Is.InRange(0xb9, 0xe0));
        }

        [TestCase(false, Explicit = true, Category = "Long")]
        [TestCase(true)]
        public void TheSound_IsAsLongAsTheFilm_AndBeatsAsTheInsect_OrAsSlowAsTheFilm(bool isSlow)
        {
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "hum.wav");
            string[] words = ["film", "dragonfly", "--frames", "4", "--beats", "6", "--rate", "12", "--width", "120", "--out", run.Out,
                "--sound", file, .. isSlow ? ["--slow-sound"] : Array.Empty<string>()];
            Assert.That(run.Run(words), Is.Zero, run.Errors);
            Assert.That(run.Output, Does.Contain(file));

            byte[] bytes = File.ReadAllBytes(file);
            Assert.That(Encoding.ASCII.GetString(bytes, 0, 4) + Encoding.ASCII.GetString(bytes, 8, 8), Is.EqualTo("RIFFWAVEfmt "));
            Assert.That((BitConverter.ToInt32(bytes, 4), BitConverter.ToInt16(bytes, 20), BitConverter.ToInt16(bytes, 22)),
                Is.EqualTo((bytes.Length - 8, 1, 1)), "the rest of the file; as it is, of one channel");
            Assert.That((BitConverter.ToInt32(bytes, 24), BitConverter.ToInt32(bytes, 28), BitConverter.ToInt16(bytes, 32),
                BitConverter.ToInt16(bytes, 34)), Is.EqualTo((48000, 96000, 2, 16)));
            Assert.That((Encoding.ASCII.GetString(bytes, 36, 4), BitConverter.ToInt32(bytes, 40)), Is.EqualTo(("data", bytes.Length - 44)));
            double[] samples = Enumerable.Range(0, (bytes.Length - 44) / 2)
                .Select(k => BitConverter.ToInt16(bytes, 44 + 2 * k) / 32767.0).ToArray();
            Assert.That(samples, Has.Length.EqualTo(2 * 48000), "24 frames, 12 a second");
            Assert.That(Math.Sqrt(samples.Average(sample => sample * sample)), Is.EqualTo(0.2).Within(10).Percent);

            // What comes again after a beat is like itself then, and unlike half a beat before.
            var plan = FlightPlan.Cruise(InsectCatalogue.Find("dragonfly"), InsectVariant.Standard);
            double beat = isSlow ? 3.0 : TetheredFlight.Fly(plan).Wings[0].Frequency;
            Assert.That(Alike((int)Math.Round(48000 / beat)), Is.GreaterThan(0.98));
            Assert.That(Alike((int)Math.Round(24000 / beat)), Is.LessThan(0.9));

            double Alike(int lag)
            {
                double product = 0.0, square = 0.0;
                for (int k = 9600; k < samples.Length - lag; k++)
                {
                    product += samples[k] * samples[k + lag];
                    square += samples[k] * samples[k];
                }

                return product / square;
            }
        }

        [Test]
        public void ASlowSound_NeedsAFile()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("film", "monarch", "--slow-sound", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors.Trim(), Does.EndWith("--slow-sound needs --sound FILE.wav."));
            Assert.That(run.Run("film", "monarch", "--sound", run.Folder, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("it is a folder, not a file"));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void FreeFilm_TakesNoOtherNumbers()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("film", "monarch", "--free", "--compare", "--out", run.Out), Is.EqualTo(2));
            foreach (string other in new[] { "--free", "--compare" })
            {
                Assert.That(run.Run("film", "monarch", other, "--wake", "--out", run.Out), Is.EqualTo(2));
                Assert.That(run.Errors, Does.Contain("neither with --free nor with --compare"));
            }

            Assert.That(run.Errors, Does.Contain("--free flies"));
        }
    }
}
