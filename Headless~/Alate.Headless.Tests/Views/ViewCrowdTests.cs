using System.Collections.Generic;
using System.Net;
using System.Net.Http;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Threading.Tasks;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Views
{
    /// <summary>More clients than the server of the live view takes.</summary>
    public sealed class ViewCrowdTests : ViewFixture
    {
        [Test]
        public void PagesBeyondTheLastOne_AreRefused_UntilOneLeaves() => Fly(async () =>
        {
            await AllHaveLeft();
            var pages = new List<ViewClient>();
            for (int k = 0; k < ViewServer.MostPages; k++)
                pages.Add(await ViewClient.Open(Server));
            Assert.That(async () => await ViewClient.Open(Server), Throws.TypeOf<WebSocketException>());

            foreach (ViewClient page in pages)
                await page.DisposeAsync();
            await AllHaveLeft();
            await using ViewClient next = await ViewClient.Open(Server);
            Assert.That((await next.ReadState()).Columns, Is.EqualTo(1));
        });

        [Test]
        public void AThousandConnections_LeaveAnOpenPageFlying() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            var crowd = new List<TcpClient>();
            for (int k = 0; k < 1000; k++)
            {
                var one = new TcpClient();
                await one.ConnectAsync(Server.Address.Host, Server.Address.Port);
                crowd.Add(one);
            }

            double before = (await page.ReadState()).Time;
            for (int k = 0; k < 5; k++)
                await page.ReadState();
            Assert.That((await page.ReadState()).Time, Is.GreaterThan(before));
            crowd.ForEach(one => one.Dispose());
            for (int wait = 0; wait < 50; wait++)
            {
                try
                {
                    Assert.That((await Client.GetAsync("/view.css")).StatusCode, Is.EqualTo(HttpStatusCode.OK));
                    return;
                }
                catch (HttpRequestException)
                {
                    await Task.Delay(20);
                }
            }

            Assert.Fail("Nobody is served afterwards.");
        });

        // The server notices a little later that a page has gone.
        private async Task AllHaveLeft()
        {
            for (int wait = 0; Server.Pages > 0 && wait < 500; wait++)
                await Task.Delay(10);
        }
    }
}
