using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text.Json;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Views
{
    /// <summary>The command <c>site</c>.</summary>
    public sealed class SiteTests
    {
        [Test]
        public void Site_HasThePage_AndASettledBeatOfEveryVariant_ThatCloses()
        {
            using var run = new CommandRun();
            string three = Path.Combine(run.Folder, "three");
            Directory.CreateDirectory(three);
            foreach (string name in ThreeSource.Hashes.Keys)
                File.WriteAllText(Path.Combine(three, Path.GetFileName(name)), name);
            Assert.That(run.Run("site", run.Out, "fishfly", "--three", three), Is.Zero, run.Errors);

            string page = File.ReadAllText(Path.Combine(run.Out, "index.html"));
            Assert.That(page, Does.Contain("data-mode=\"baked\"").And.Not.Contain("http"));
            Assert.That(File.Exists(Path.Combine(run.Out, "three", "build", "three.core.js")), Is.True);
            JsonElement index = JsonDocument.Parse(File.ReadAllText(Path.Combine(run.Out, "insects", "index.json"))).RootElement;
            string[] variants = index.GetProperty("species")[0].GetProperty("variants").EnumerateArray()
                .Select(variant => variant.GetString()).ToArray();
            Assert.That(index.GetProperty("sliders").GetArrayLength(), Is.EqualTo(1));
            Assert.That(
                Directory.GetFiles(Path.Combine(run.Out, "insects"), "*-look.json"), Has.Length.EqualTo(1), "all variants look alike");
            foreach (string name in variants.Append("standard-parts"))
            {
                using var file = new MemoryStream(Unpacked(Path.Combine(run.Out, "insects", $"fishfly-{name}.bin")));
                using var reader = new BinaryReader(file);
                ViewState first = null, last = null;
                int count = 0;
                for (; file.Position < file.Length; count++)
                {
                    last = new ViewState(reader.ReadBytes(reader.ReadInt32()));
                    first ??= last;
                }

                Assert.That(count, Is.EqualTo(24));
                Assert.That(first.Columns, Is.EqualTo(name == "standard-parts" ? 4 : 1));
                Assert.That(last.Beats[0] - first.Beats[0], Is.EqualTo(23.0 / 24.0).Within(0.01),
                    "a whole beat with the way back to the first state");
                float step = math.distance(last.Wings[0][0].Places[^1], first.Wings[0][0].Places[^1]);
                Assert.That(step, Is.LessThan(0.5f * first.Wings[0][0].Reach), "the last state leads into the first");
            }
        }

        private static byte[] Unpacked(string path)
        {
            using FileStream file = File.OpenRead(path);
            using var packed = new GZipStream(file, CompressionMode.Decompress);
            using var content = new MemoryStream();
            packed.CopyTo(content);
            return content.ToArray();
        }

        [Test, Explicit, Category("Long")]
        public void Site_FliesInTheBrowser_FromFilesAnywhere()
        {
            WebTools.NeedChromium();
            WebTools.NeedNode();
            using var run = new CommandRun();
            Assert.That(run.Run("site", run.Out, "fishfly", "--three", WebTools.Three), Is.Zero, run.Errors);

            (int code, string output) = WebTools.Run("site.mjs", WebTools.Chromium, run.Out).Result;
            TestContext.Out.Write(output);
            Assert.That(code, Is.Zero, output);
        }
    }
}
