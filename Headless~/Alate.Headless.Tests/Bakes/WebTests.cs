using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.Json;
using Alate.Cli;
using Alate.Tests.Views;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>
    /// Baked insects in a vertex shader of WebGL 2, in Chromium without a screen. Skipped where it is not installed (Debian: chromium).
    /// </summary>
    public sealed class WebTests
    {
        [Test, Explicit, Category("Long")]
        public void TenThousandInsects_ArePlayedByAVertexShader()
        {
            const int side = 100;
            int[] probes = { 0, 1, 77, 1234, side * side - 1 };
            WebTools.NeedChromium();
            using var files = new BakedFiles();
            string folder = Path.Combine(files.Folder("monarch --triangles 160"), "monarch_vat");
            var vat = new VatReader(folder, "monarch");
            string page = Path.Combine(folder, "vat.html");
            string source = File.ReadAllText(
                Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Bakes", "Web", "vat.html"));
            File.WriteAllText(page, source.Replace("/*DATA*/", Data(folder, vat, side, probes)));
            JsonElement result = WebTools.Show(page, folder);

            Assert.That(result.GetProperty("error").ToString(), Is.EqualTo("0"));
            Assert.That(result.GetProperty("count").GetInt32(), Is.EqualTo(side * side));
            Assert.That(result.GetProperty("painted").GetDouble(), Is.InRange(0.05, 0.9), "share of the picture");
            for (int probe = 0; probe < probes.Length; probe++)
            {
                float phase = probes[probe] * 0.618034f;
                float3[] wanted = vat.At((phase - math.floor(phase)) * LiveWings.Frames).Positions;
                float[] read = result.GetProperty("read")[probe].EnumerateArray().Select(number => number.GetSingle()).ToArray();
                for (int vertex = 0; vertex < wanted.Length; vertex++)
                {
                    var played = new float3(read[3 * vertex], read[3 * vertex + 1], read[3 * vertex + 2]);
                    Assert.That(math.distance(played, wanted[vertex]), Is.LessThan(5e-5f), $"metres, insect {probes[probe]}");
                }
            }
        }

        private static string Data(string folder, VatReader vat, int side, int[] probes)
        {
            var picture = new WidePng(File.ReadAllBytes(Path.Combine(folder, "monarch.png")));
            var pixels = new List<float>();
            for (int row = 0; row < picture.Height; row++)
            {
                for (int column = 0; column < picture.Width; column++)
                {
                    pixels.AddRange(
                        new[] { (float)picture[column, row, 0], (float)picture[column, row, 1], (float)picture[column, row, 2], 1f });
                }
            }

            JsonElement[] parts = vat.Mesh.Root.GetProperty("meshes")[0].GetProperty("primitives").EnumerateArray().ToArray();
            JsonElement attributes = parts[0].GetProperty("attributes");
            ushort[] triangles = parts.SelectMany(part => vat.Mesh.Read(part.GetProperty("indices").GetInt32()))
                .Select(corner => (ushort)corner).ToArray();
            double[] colours = vat.Mesh.Read(attributes.GetProperty("COLOR_0").GetInt32());
            return JsonSerializer.Serialize(new
            {
                side,
                probes,
                vertexCount = vat.VertexCount,
                corners = triangles.Length,
                width = picture.Width,
                height = picture.Height,
                first = vat.Clip("cruise").Start,
                frames = LiveWings.Frames,
                least = new[] { vat.Least.x, vat.Least.y, vat.Least.z },
                most = new[] { vat.Most.x, vat.Most.y, vat.Most.z },
                rest = Text(Floats(vat, attributes, "POSITION")),
                places = Text(Floats(vat, attributes, "TEXCOORD_1")),
                colours = Text(colours.Where((_, k) => k % 4 < 3).Select(value => (float)value).ToArray()),
                triangles = Text(triangles),
                pixels = Text(pixels.ToArray()),
            });
        }

        private static float[] Floats(VatReader vat, JsonElement attributes, string name) =>
            vat.Mesh.Read(attributes.GetProperty(name).GetInt32()).Select(value => (float)value).ToArray();

        private static string Text<T>(T[] values) where T : struct => Convert.ToBase64String(MemoryMarshal.AsBytes<T>(values));
    }
}
