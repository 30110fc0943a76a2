using System;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Http;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Security.Cryptography;
using System.Text;
using System.Threading.Tasks;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Views
{
    /// <summary>The server of the live view, as well-meaning and as hostile clients meet it.</summary>
    public sealed class ViewServerTests : ViewFixture
    {
        [Test]
        public void Server_ListensOnTheLoopbackAlone() => Assert.That(IPAddress.IsLoopback(IPAddress.Parse(Server.Address.Host)), Is.True);

        [Test]
        public async Task Page_ComesWithItsFiles_AndWithAPolicyThatNamesTheImportMap()
        {
            HttpResponseMessage answer = await Client.GetAsync("/");
            string page = await answer.Content.ReadAsStringAsync();
            string map = page.Split("<script type=\"importmap\">")[1].Split("</script>")[0];
            string hash = Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(map)));

            Assert.That(answer.StatusCode, Is.EqualTo(HttpStatusCode.OK));
            Assert.That(page, Does.Contain("data-mode=\"live\""));
            Assert.That(answer.Headers.GetValues("Content-Security-Policy").Single(),
                Does.Contain($"'sha256-{hash}'").And.Contain("default-src 'none'"));
            foreach (string file in new[] { "main.js", "view.css", "icon.svg" })
                Assert.That((await Client.GetAsync(file)).StatusCode, Is.EqualTo(HttpStatusCode.OK), file);
        }

        [Test]
        public void HashesOfThePage_AreThoseOfThePackage()
        {
            WebTools.NeedThree();
            foreach ((string name, string hash) in ThreeSource.Hashes)
            {
                Assert.That("sha384-" + Convert.ToBase64String(SHA384.HashData(File.ReadAllBytes(Path.Combine(WebTools.Three, name)))),
                    Is.EqualTo(hash), name);
            }
        }

        [TestCase("/../../../../etc/passwd")]
        [TestCase("/%2e%2e/%2e%2e/etc/passwd")]
        [TestCase("/..%5c..%5cwindows%5cwin.ini")]
        [TestCase("//etc/passwd")]
        [TestCase("/three/../../main.js%00.css")]
        [TestCase("/Page/main.js")]
        public async Task OtherPaths_AreNotFound(string path) =>
            Assert.That(await Status($"GET {path} HTTP/1.1\r\nHost: {Host}\r\nConnection: close\r\n\r\n"), Is.EqualTo(404).Or.EqualTo(400));

        [TestCase("evil.example")]
        [TestCase("127.0.0.1.evil.example")]
        [TestCase("127.0.0.1:1")]
        [TestCase("")]
        public async Task ForeignHosts_AreRefused(string host) =>
            Assert.That(await Status($"GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"), Is.EqualTo(403).Or.EqualTo(400));

        [TestCase("POST / HTTP/1.1\r\nContent-Length: 0", 405)]
        [TestCase("DELETE /main.js HTTP/1.1", 405)]
        [TestCase("GET /live HTTP/1.1", 400)]
        public async Task OtherMethods_AreRefused(string request, int status) =>
            Assert.That(await Status($"{request}\r\nHost: {Host}\r\nConnection: close\r\n\r\n"), Is.EqualTo(status));

        [Test]
        public async Task RequestsThatAreTooLong_AreRefused()
        {
            string longLine = new string('a', 20000);

            Assert.That(await Status($"GET /{longLine} HTTP/1.1\r\nHost: {Host}\r\n\r\n"), Is.EqualTo(414));
            Assert.That(await Status($"GET / HTTP/1.1\r\nHost: {Host}\r\nCookie: {longLine}\r\n\r\n"), Is.EqualTo(431));
            Assert.That(await Status("\0\u0001 no HTTP at all\r\n\r\n"), Is.EqualTo(400));
            Assert.That(
                await Status($"POST / HTTP/1.1\r\nHost: {Host}\r\nContent-Length: 99999999\r\n\r\n"), Is.EqualTo(405).Or.EqualTo(413));
        }

        [TestCase("http://evil.example")]
        [TestCase("https://127.0.0.1")]
        [TestCase("null")]
        [TestCase("")]
        public void SocketsOfForeignPages_AreRefused(string origin)
        {
            using var socket = new ClientWebSocket();
            if (origin.Length > 0)
                socket.Options.SetRequestHeader("Origin", origin);
            socket.Options.CollectHttpResponseDetails = true;

            Assert.That(async () => await socket.ConnectAsync(SocketAddress, default), Throws.TypeOf<WebSocketException>());
            Assert.That(socket.HttpStatusCode, Is.EqualTo(HttpStatusCode.Forbidden));
        }

        [TestCase("no JSON")]
        [TestCase("{\"speces\":\"monarch\"}")]
        [TestCase("[1,2,3]")]
        [TestCase("{\"values\":{\"speed\":\"fast\"}}")]
        [TestCase("{\"compare\":1}")]
        [TestCase("{\"wake\":\"on\"}")]
        [TestCase("{\"wake\":1}")]
        [TestCase("{\"species\":null}")]
        [TestCase("{\"values\":{\"a\":{\"b\":{\"c\":{\"d\":1}}}}}")]
        public void MessagesThatAreNone_CloseTheSocket(string message) => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say(message);

            Assert.That(await page.ReadClose(), Is.EqualTo(WebSocketCloseStatus.InvalidPayloadData));
        });

        [TestCase('x')]
        [TestCase('é')]
        [TestCase('蝶')]
        public void ALongName_ClosesTheSocket_WithAReasonThatHasRoom(char letter) => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say($"{{\"{new string(letter, 900)}\":1}}");

            Assert.That(await page.ReadClose(), Is.EqualTo(WebSocketCloseStatus.InvalidPayloadData));
            Assert.That(page.Reason, Does.StartWith($"A message of this page has no '{letter}{letter}").And.Not.Contain("\uFFFD"));
            Assert.That(Encoding.UTF8.GetByteCount(page.Reason), Is.InRange(80, 123));
        });

        [Test]
        public void MessagesThatAreTooLong_CloseTheSocket() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say(new string(' ', PageSocket.LongestText + 1));

            Assert.That(await page.ReadClose(), Is.EqualTo(WebSocketCloseStatus.MessageTooBig));
        });

        [Test]
        public void FilesThatNobodyNamed_CloseTheSocket() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Give([1, 2, 3]);

            Assert.That(await page.ReadClose(), Is.EqualTo(WebSocketCloseStatus.InvalidPayloadData));
        });

        [TestCase("{\"species\":\"unicorn\"}", "Unknown species 'unicorn'")]
        [TestCase("{\"variant\":\"soft\"}", "There is no variant 'soft'")]
        [TestCase("{\"values\":{\"speed\":1e300}}", "'speed' must lie between 0 and 5")]
        [TestCase("{\"values\":{\"colour\":1}}", "There is no slider 'colour'")]
        public void WrongValues_AreOneLine_AndTheInsectFliesOn(string message, string problem) => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say(message);

            Assert.That((await page.Read("error")).GetProperty("message").GetString(), Does.StartWith(problem).And.Not.Contain("\n"));
            Assert.That((await page.ReadState()).Columns, Is.EqualTo(1));
        });

        [TestCase("wing.obj", "v 0 0 0\nf 1 2", "wing.obj: line 2")]
        [TestCase("wing.png", "\u0089PNG cut off", "wing.png: the mesh is empty")]
        [TestCase("wing.obj", "", "wing.obj: the mesh is empty")]
        public void FilesThatAreNoWings_AreOneLine_AndTheInsectFliesOn(string name, string content, string problem) => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say($"{{\"file\":\"{name}\"}}");
            await page.Give(Encoding.UTF8.GetBytes(content));

            Assert.That((await page.Read("error")).GetProperty("message").GetString(), Does.StartWith(problem).And.Not.Contain("\n"));
            Assert.That((await page.ReadState()).Columns, Is.EqualTo(1));
        });

        [Test]
        public void PortThatIsTaken_IsOneLine()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("view", "--port", Server.Address.Port.ToString(), "--no-browser"), Is.EqualTo(2));
            Assert.That(run.Errors.TrimEnd(), Does.StartWith($"alate: Cannot listen on port {Server.Address.Port}").And.Not.Contain("\n"));
        }

        [Test]
        public void FolderWithoutThree_IsOneLine()
        {
            using var run = new CommandRun();

            Assert.That(run.Run("view", "--three", run.Folder, "--no-browser"), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain("there is no 'build/three.module.js'"));
        }

        [Test]
        public void FolderWithThree_IsServedFromThere()
        {
            using var folder = new TemporaryFolder();
            foreach (string name in ThreeSource.Hashes.Keys)
                folder.File(Path.GetFileName(name), name);
            var files = new PageFiles(ThreeSource.Of(folder.Root), PageKind.Live);

            Assert.That(Encoding.UTF8.GetString(files.Find("three/build/three.core.js")), Is.EqualTo("build/three.core.js"));
            Assert.That(Encoding.UTF8.GetString(files.Find(PageFiles.Index)), Does.Not.Contain("http"));
            Assert.That(files.SecurityPolicy, Does.Not.Contain("https"));
        }

        [TestCaseSource(typeof(InsectCatalogue), nameof(InsectCatalogue.All))]
        public void PageOfAnInsect_HasItsPictureForTheBeginning(InsectDefinition insect)
        {
            var files = new PageFiles(ThreeSource.Public, PageKind.Live, insect);
            string name = PageFiles.FirstPicture(insect.Name);
            var picture = PngFile.Read(files.Find(name));
            Color32[] pixels = [.. picture.Pixels];
            int size = FirstPicture.Size, half = size / 2;

            Assert.That(files.Names.Where(file => file.EndsWith(".png")), Is.EqualTo(new[] { name }), "no other insect's");
            Assert.That(Encoding.UTF8.GetString(files.Find(PageFiles.Index)), Does.Contain($"src=\"{name}\""));
            Assert.That((picture.Width, picture.Height), Is.EqualTo((size, size)));
            Assert.That(pixels.Count(pixel => pixel.a > 0), Is.InRange(0.04 * size * size, 0.5 * size * size));
            Assert.That(pixels[half * size + half].a, Is.EqualTo(255), "the thorax is in the middle");
            Assert.That(Enumerable.Range(0, size).Count(k => pixels[k].a > 0 || pixels[(size - 1) * size + k].a > 0), Is.Zero,
                "nothing is cut off");
        }

        [Test]
        public void InsectOfAFile_AndAScene_HaveNone()
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch"),
                other = new("monarch", "Another", monarch.Wings.ToArray(), monarch.Body, []);
            foreach (PageFiles files in new[] { new PageFiles(ThreeSource.Public, PageKind.Live, other),
                new PageFiles(ThreeSource.Public, PageKind.Scene) })
            {
                Assert.That(files.Names, Has.None.EndsWith(".png"));
                Assert.That(Encoding.UTF8.GetString(files.Find(PageFiles.Index)),
                    Does.Not.Contain("id=\"first\"").And.Not.Contain("FIRST"));
            }
        }

        [Test]
        public void Three_IsFoundInAFolderAbove_WhereItsFilesAreTheKnownOnes()
        {
            WebTools.NeedThree();
            using var folder = new TemporaryFolder();
            string inner = folder.PathOf("one/two"), three = folder.PathOf("node_modules/three");
            Directory.CreateDirectory(inner);
            Assert.That(ThreeSource.Find(inner).IsPublic, Is.True, "there is none yet");
            foreach (string name in ThreeSource.Hashes.Keys)
            {
                Directory.CreateDirectory(Path.GetDirectoryName(Path.Combine(three, name)));
                File.Copy(Path.Combine(WebTools.Three, name), Path.Combine(three, name));
            }

            Assert.That(ThreeSource.Find(folder.PathOf("nowhere"), inner).Names, Is.EquivalentTo(ThreeSource.Hashes.Keys));
            File.AppendAllText(Path.Combine(three, ThreeSource.Hashes.Keys.Last()), "// changed");
            Assert.That(ThreeSource.Find(inner).IsPublic, Is.True, "files of another version, which nobody named");
        }

        [Test]
        public void Three_OfTheCheckout_IsFoundFromTheProgram()
        {
            WebTools.NeedThree();
            Assert.That(ThreeSource.Find(AppContext.BaseDirectory).IsPublic, Is.False);
        }

        private string Host => $"127.0.0.1:{Server.Address.Port}";

        private Uri SocketAddress => new Uri($"ws://{Host}/live");

        // What a client says that no library would let say.
        private async Task<int> Status(string request)
        {
            using var client = new TcpClient();
            await client.ConnectAsync(Server.Address.Host, Server.Address.Port);
            await using NetworkStream stream = client.GetStream();
            await stream.WriteAsync(Encoding.UTF8.GetBytes(request));
            using var reader = new StreamReader(stream);
            string line = await reader.ReadLineAsync() ?? "";
            return int.Parse(line.Split(' ')[1]);
        }
    }
}
