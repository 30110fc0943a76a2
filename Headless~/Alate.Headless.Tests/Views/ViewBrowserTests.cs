using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;
using OwnWing = Alate.Tests.Cli.OwnWing;

namespace Alate.Tests.Views
{
    /// <summary>
    /// The page of the live view in Chromium, against the real server. Skipped where Chromium, Node or its packages are missing.
    /// </summary>
    [Explicit]
    [Category("Long")]
    public sealed class ViewBrowserTests
    {
        private TemporaryFolder m_Folder;

        [SetUp]
        public void Prepare()
        {
            WebTools.NeedChromium();
            WebTools.NeedNode();
            m_Folder = new TemporaryFolder();
            File.Copy(Path.Combine(PackageRoot.Find(), "Documentation~", "images", "wing-drawing.png"), m_Folder.PathOf("wing.png"));
            File.WriteAllText(m_Folder.PathOf("mine.obj"), OwnWing.Obj());
            File.WriteAllText(m_Folder.PathOf("mine.skeleton.json"), OwnWing.Skeleton());
            File.WriteAllText(m_Folder.PathOf("mine.insect.json"), "{ \"version\": 1, \"name\": \"mine\", \"displayName\": \"My moth\", "
                + "\"like\": \"monarch\", \"wings\": { \"wing\": { \"mesh\": \"mine.obj\", \"skeleton\": \"mine.skeleton.json\" } } }");
            using FileStream mesh = File.Create(m_Folder.PathOf("mesh.obj"));
            ObjWriter.Write(InsectCatalogue.Find("monarch").Wings[0].CreateSurface(WingSide.Right), mesh);
        }

        [TearDown]
        public void Remove() => m_Folder?.Dispose();

        [Test]
        public void Page_DoesWhatItSays() => Try(
            "view.mjs", "first", "beats", "rate", "slow", "speed", "wind", "amplitude", "frequency", "elasticity", "delay", "substeps",
            "pause", "comparison", "order", "overlays", "wake", "species", "files", "photographs", "insects", "landing", "badFiles",
            "phone", "reconnect");

        [Test]
        public void TwoMinutes_TakeNoMoreMemory_OfThePageAndOfTheServer()
        {
            Task<(double Managed, double Private)> before = Measure("before"), after = Measure("after");
            Try("view.mjs", "memory");
            TestContext.Out.WriteLine($"Server: {before.Result} MB before two minutes, {after.Result} MB after");
            Assert.That(after.Result.Managed, Is.LessThan(before.Result.Managed + 2.0), "managed");
            Assert.That(after.Result.Private, Is.LessThan(before.Result.Private + 32.0), "all, of which the collector keeps some free");
        }

        private async Task<(double Managed, double Private)> Measure(string name)
        {
            await Appears(name);
            double managed = 1e-6 * GC.GetTotalMemory(true);
            using var process = Process.GetCurrentProcess();
            return (managed, 1e-6 * process.PrivateMemorySize64);
        }

        [Test]
        public void Page_IsForThoseToo_WhoSeeLittle_UseKeys_OrHoldAPhone() =>
            Try("access.mjs", "offline", "withoutThree", "axe", "overflow", "contrast", "keyboard", "sliders", "share", "errors");

        [Test]
        public void ThePageOfTheManual_IsThatOfToday()
        {
            Try("view.mjs", "picture");
            ManualPage.Compare(m_Folder.PathOf("page.png"), "live-view.png");
        }

        // Serves until the script has ended; where it asks for it, stops and starts anew at the same port.
        private void Try(string script, params string[] cases)
        {
            ViewServer server = Start(0);
            Uri address = server.Address;
            Task<(int Code, string Output)> run = Task.Run(
                () => WebTools.Run(script, [address.ToString(), WebTools.Chromium, m_Folder.Root, .. cases]));
            server.Simulation.RunUntil(Task.WhenAny(run, Appears("stop")));
            if (!run.IsCompleted)
            {
                server.Simulation.RunUntil(server.Stop());
                server = RunAndStart(run, address.Port);
            }

            server.Simulation.RunUntil(run);
            server.Simulation.RunUntil(server.Stop());
            TestContext.Out.Write(run.Result.Output);
            Assert.That(run.Result.Code, Is.Zero, string.Join('\n', run.Result.Output.Split('\n').Where(line => !line.StartsWith("ok"))));
        }

        private ViewServer RunAndStart(Task run, int port)
        {
            Task.WhenAny(run, Appears("start")).Wait();
            return Start(port);
        }

        private async Task Appears(string name)
        {
            string path = m_Folder.PathOf(name);
            while (!File.Exists(path) && Directory.Exists(m_Folder.Root))
                await Task.Delay(50);
        }

        private static ViewServer Start(int port) =>
            ViewServer.Start(new InsectView(InsectCatalogue.Find("monarch"), InsectVariant.Standard), port, ThreeSource.Find())
                .GetAwaiter().GetResult();
    }
}
