using System;
using System.IO;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using System.Threading;
using System.Threading.Tasks;
using Alate.Cli;

namespace Alate.Tests.Views
{
    /// <summary>A page of the live view without a browser.</summary>
    internal sealed class ViewClient : IAsyncDisposable
    {
        private readonly ClientWebSocket m_Socket = new ClientWebSocket();
        private readonly CancellationTokenSource m_Patience = new CancellationTokenSource(TimeSpan.FromSeconds(30));
        private readonly byte[] m_Buffer = new byte[1 << 20];

        /// <summary>Opens the socket as the server's own page does.</summary>
        public static async Task<ViewClient> Open(ViewServer server)
        {
            var client = new ViewClient();
            client.m_Socket.Options.SetRequestHeader("Origin", server.Address.GetLeftPart(UriPartial.Authority));
            await client.m_Socket.ConnectAsync(new Uri($"ws://{server.Address.Authority}/live"), client.m_Patience.Token);
            return client;
        }

        public Task Say(string message) =>
            m_Socket.SendAsync(Encoding.UTF8.GetBytes(message), WebSocketMessageType.Text, true, m_Patience.Token);

        public Task Give(byte[] file) => m_Socket.SendAsync(file, WebSocketMessageType.Binary, true, m_Patience.Token);

        /// <summary>The next message of a type; others are passed over.</summary>
        public async Task<JsonElement> Read(string type)
        {
            while (true)
            {
                (WebSocketMessageType kind, byte[] content) = await Next();
                if (kind != WebSocketMessageType.Text)
                    continue;
                JsonElement message = JsonDocument.Parse(content).RootElement;
                if (message.GetProperty("type").GetString() == type)
                    return message;
            }
        }

        /// <summary>The next state; others are passed over.</summary>
        public async Task<ViewState> ReadState() => new ViewState(await ReadBinary());

        /// <summary>The next binary message.</summary>
        public async Task<byte[]> ReadBinary()
        {
            while (true)
            {
                (WebSocketMessageType kind, byte[] content) = await Next();
                if (kind == WebSocketMessageType.Binary)
                    return content;
            }
        }

        /// <summary>Why the server closes the socket.</summary>
        public async Task<WebSocketCloseStatus?> ReadClose()
        {
            while ((await Next()).Kind != WebSocketMessageType.Close)
            {
            }

            return m_Socket.CloseStatus;
        }

        /// <summary>Reason that the server gave as it closed the socket.</summary>
        public string Reason => m_Socket.CloseStatusDescription;

        public async ValueTask DisposeAsync()
        {
            try
            {
                if (m_Socket.State is WebSocketState.Open or WebSocketState.CloseReceived)
                    await m_Socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, null, m_Patience.Token);
            }
            catch (Exception problem) when (problem is WebSocketException or OperationCanceledException)
            {
                // The server was faster.
            }

            m_Socket.Dispose();
            m_Patience.Dispose();
        }

        private async Task<(WebSocketMessageType Kind, byte[] Content)> Next()
        {
            using var content = new MemoryStream();
            while (true)
            {
                WebSocketReceiveResult part = await m_Socket.ReceiveAsync(new ArraySegment<byte>(m_Buffer), m_Patience.Token);
                content.Write(m_Buffer, 0, part.Count);
                if (part.EndOfMessage)
                    return (part.MessageType, content.ToArray());
            }
        }
    }
}
