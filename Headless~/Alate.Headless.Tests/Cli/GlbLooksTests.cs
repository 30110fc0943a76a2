using System;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Views;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>
    /// Looks of GLB files: pictures on wings, judged by the file itself and by the format's own validator where it is installed.
    /// </summary>
    public sealed class GlbLooksTests
    {
        private static readonly string s_Photo = Path.Combine(PackageRoot.Find(), "Documentation~", "images", "wing-drawing.png");

        [Test]
        [Explicit]
        [Category("Long")]
        public void PhotographOfAWing_ComesBackOnIt_AndTheFileIsValid()
        {
            using var run = new CommandRun();
            string traced = Path.Combine(run.Folder, "traced");
            Assert.That(run.Run("skeleton", "from-image", s_Photo, "--out", traced, "--triangles", "200"), Is.Zero, run.Errors);
            byte[] glb = Fly(new FlightPlan
            {
                Species = "monarch",
                MeshFile = Path.Combine(traced, "wing.obj"),
                SkeletonFile = Path.Combine(
                traced, "skeleton.json")
            });

            // The photograph itself runs out over its ground in the texture.
            byte[] texture = File.ReadAllBytes(Path.Combine(traced, "wing.png"));
            Assert.That(new GlbFile(glb).Image(0).SequenceEqual(texture), Is.True);
            File.WriteAllBytes(Path.Combine(run.Folder, "wings.glb"), glb);
            Validate(Path.Combine(run.Folder, "wings.glb"));
        }

        [Test]
        public void Texture_NeedsCoordinates_AndAMesh()
        {
            using var run = new CommandRun();
            string mesh = run.Write("wing.obj", OwnWing.Obj()), skeleton = run.Write("wing.json", OwnWing.Skeleton());

            Assert.That(
                run.Run("fly", "--mesh", mesh, "--skeleton", skeleton, "--species", "monarch", "--texture", s_Photo, "--out", run.Out),
                Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("has no texture coordinates"));
            Assert.That(run.Run("fly", "monarch", "--texture", s_Photo, "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("--texture goes with --mesh"));
        }

        [Test]
        public void ForeAndHindWing_FlyTogether()
        {
            using var run = new CommandRun();
            string mesh = run.Write("wing.obj", OwnWing.Obj()), skeleton = run.Write("wing.json", OwnWing.Skeleton());
            string[] both = { "--mesh", mesh, mesh, "--skeleton", skeleton, skeleton, "--out", run.Out };

            var plan = new FlightPlan
            {
                Species = "fishfly",
                MeshFile = mesh,
                SkeletonFile = skeleton,
                HindMeshFile = mesh,
                HindSkeletonFile = skeleton,
                Seconds = 0.1,
            };
            var file = new GlbFile(Fly(plan));
            Assert.That(file.Root.GetProperty("meshes").GetArrayLength(), Is.EqualTo(5), "body and four wings");
            Assert.That(run.Run(["fly", "--species", "monarch", .. both]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("one kind of wing"));
            Assert.That(run.Run("fly", "--species", "fishfly", "--mesh", mesh, mesh, "--skeleton", skeleton), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("Each --mesh needs a --skeleton"));
        }

        [Test, Explicit, Category("Long")]
        public void EverySpecies_IsValid_AndShown()
        {
            using var folder = new TemporaryFolder();
            string[] files = InsectCatalogue.All.Select(species =>
            {
                string path = folder.PathOf(Path.Combine(species.Name, "wings.glb"));
                Directory.CreateDirectory(Path.GetDirectoryName(path));
                using FileStream stream = File.Create(path);
                WingsGlb.Write(TetheredFlight.Fly(FlightPlan.Cruise(species, InsectVariant.Standard)), stream);
                return path;
            }).ToArray();
            Validate(files);
            WebTools.NeedChromium();
            (int code, string output) = WebTools.Run(
                "glb.mjs", [WebTools.Chromium, folder.Root, .. files.SelectMany(file => new[] { file, "0.25", "40", "30" })]).Result;
            Assert.That(code, Is.Zero, output);
        }

        private static byte[] Fly(FlightPlan plan)
        {
            using var stream = new MemoryStream();
            WingsGlb.Write(TetheredFlight.Fly(plan), stream);
            return stream.ToArray();
        }

        // Errors and warnings count; hints do not.
        internal static void Validate(params string[] files)
        {
            WebTools.NeedNode();
            (int code, string output) = WebTools.Run("validate.mjs", files).Result;
            Assert.That(code, Is.Zero, output);
        }
    }
}
