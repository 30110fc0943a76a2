using System;
using System.Net.Http;
using System.Threading.Tasks;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Views
{
    /// <summary>A server of the live view for the tests of a class.</summary>
    public abstract class ViewFixture
    {
        private protected ViewServer Server { get; private set; }

        private protected HttpClient Client { get; private set; }

        [OneTimeSetUp]
        public void Start()
        {
            Server = StartServer().GetAwaiter().GetResult();
            Client = new HttpClient { BaseAddress = Server.Address };
        }

        [OneTimeTearDown]
        public void Stop()
        {
            Client.Dispose();
            Server.Simulation.RunUntil(Server.Stop());
        }

        private static Task<ViewServer> StartServer() =>
            ViewServer.Start(new InsectView(InsectCatalogue.Find("fishfly"), InsectVariant.Standard), 0, ThreeSource.Public);

        // Runs clients beside this thread, which flies for them.
        private protected void Fly(Func<Task> clients)
        {
            var run = Task.Run(clients);
            Server.Simulation.RunUntil(run);
            run.GetAwaiter().GetResult();
        }
    }
}
